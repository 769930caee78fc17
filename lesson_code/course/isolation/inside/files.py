"""What stands in a file that was handed in: the code of a program, or of the cells of a notebook.

A file may be in any encoding and of any form, and some take minutes to decode: like all reading it
is done in a process of its own.
"""

from __future__ import annotations

import codecs
import io
import json
import tokenize
from pathlib import Path
from typing import Any

MOST_CELLS = 2_000
"""A chapter's exercise has about 20 cells."""

MOST_CODE = 1_000_000
"""Characters. A chapter's answers have 5,000; the outputs of a notebook are not counted."""

NO_TEXT = "is not text in UTF-8; save it as UTF-8"
OLD_FORMAT = "is in the format of an old notebook; open it in Jupyter and save it"
TOO_MUCH_CODE = f"has more than {MOST_CODE:,} characters of code; leave out what is no answer"


def handed_in(path: str) -> dict[str, Any]:
    """Return the ``sources`` in a file, and the ``exercise`` that a notebook says it is.

    A source has a ``name``, a ``source``, and says whether it ``is_cell``. Of what is no notebook
    or program, why (``problem``).
    """
    is_cell = is_notebook(path)
    found = _notebook(path) if is_cell else _program(path)
    if "problem" not in found:
        found["sources"] = [
            {"name": f"your {place}", "source": code, "is_cell": is_cell}
            for place, code in found["sources"]
        ]
    return found


def is_notebook(path: str) -> bool:
    """Return whether a file is a notebook by its name."""
    return path.lower().endswith(".ipynb")


def _program(path: str) -> dict[str, Any]:
    """Return the code of a program."""
    text, problem = _text_in(path, may_name_its_encoding=True)
    if not problem and len(text) > MOST_CODE:
        problem = TOO_MUCH_CODE
    return {"problem": problem} if problem else {"sources": [(Path(path).name, text)]}


def _notebook(path: str) -> dict[str, Any]:
    """Return the code cells of a notebook, and the exercise it says it is."""
    text, problem = _text_in(path, may_name_its_encoding=False)
    if problem:
        return {"problem": problem}
    try:
        whole = json.loads(text)
    except (ValueError, RecursionError):
        return {"problem": "is not a notebook (its text is not JSON)"}
    if isinstance(whole, dict) and "cells" not in whole and "worksheets" in whole:
        return {"problem": OLD_FORMAT}
    cells = whole.get("cells") if isinstance(whole, dict) else None
    if not isinstance(cells, list) or not all(isinstance(cell, dict) for cell in cells):
        return {"problem": "is not a notebook (it has no list of cells)"}
    if len(cells) > MOST_CELLS:
        return {"problem": f"has more than {MOST_CELLS} cells"}
    sources = [
        (f"cell {number}", _cell_source(cell))
        for number, cell in enumerate(cells, start=1)
        if cell.get("cell_type") == "code"
    ]
    if sum(len(source) for _, source in sources) > MOST_CODE:
        return {"problem": TOO_MUCH_CODE}
    exercise = _deep(whole, "metadata", "workbook", "exercise")
    return {"sources": sources, "exercise": exercise if isinstance(exercise, str) else None}


def _text_in(path: str, *, may_name_its_encoding: bool) -> tuple[str, str]:
    """Return the text in a file, and what is wrong with it."""
    try:
        text = _decoded(Path(path).read_bytes(), may_name_its_encoding=may_name_its_encoding)
    except OSError as error:
        return "", f"cannot be read ({error.strerror})"
    except (UnicodeError, SyntaxError, LookupError):
        return "", NO_TEXT
    return text, "" if text.strip() else "is empty"


def _decoded(raw: bytes, *, may_name_its_encoding: bool) -> str:
    """Return a file's text: in UTF-16 by its mark, in what its first lines name, or in UTF-8."""
    is_utf_16 = raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    encoding = "utf-16" if is_utf_16 else "utf-8-sig"
    if may_name_its_encoding and not is_utf_16:
        encoding, _ = tokenize.detect_encoding(io.BytesIO(raw).readline)
    return raw.decode(encoding).replace("\r\n", "\n").replace("\r", "\n")


def _deep(value: Any, *keys: str) -> Any:
    """Return what stands under nested keys, or None where anything else is in the way."""
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _cell_source(cell: dict[str, Any]) -> str:
    """Return a cell's source, which may be a text or a list of lines."""
    source = cell.get("source", "")
    return "".join(map(str, source)) if isinstance(source, list) else str(source)

"""A submission: a notebook or a .py file, taken apart into the statements that define answers.

Answers are found by the names of functions, wherever in the file they stand. Which statements are
kept is said in ``isolation.inside.reading``, which reads them in a process of its own.
"""

from __future__ import annotations

import ast
import codecs
import io
import json
import tokenize
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from lesson_code.course.isolation.call_outcome import one_line
from lesson_code.course.isolation.inside.reading import parsed
from lesson_code.course.isolation.reader import read_units, reader

LARGEST_FILE = 20_000_000
"""Bytes. A notebook with every figure in it stays under 2 MB."""

MOST_CELLS = 2_000
"""A chapter's exercise has about 20 cells."""


class SubmissionError(ValueError):
    """A file that cannot be graded at all; the message says why and names the file."""


@dataclass(frozen=True)
class Unit:
    """A cell, or a whole .py file: its code, and which of its statements are kept.

    Statements are kept in groups, which run one after another. A statement that fails ends its
    group: a cell is one group, as in a notebook; in a .py file each statement is its own. `lines`
    says where each statement begins; `missing` names what an import gives that is left out; `uses`
    says which names stand in a definition.
    """

    name: str
    source: str
    groups: tuple[tuple[int, ...], ...]
    lines: tuple[int, ...] = ()
    functions: tuple[str, ...] = ()
    left_out: dict[str, str] = field(default_factory=dict)
    missing: tuple[str, ...] = ()
    uses: dict[str, list[str]] = field(default_factory=dict)

    def as_request(self) -> dict[str, Any]:
        """Return the unit as the child process is sent it."""
        names = ("name", "source", "groups", "missing")
        return {name: getattr(self, name) for name in names}

    @property
    def parts(self) -> list[Unit]:
        """The unit in parts, each of which holds one statement that is kept."""
        return [replace(self, groups=((index,),)) for group in self.groups for index in group]

    @cached_property
    def statements(self) -> list[ast.stmt]:
        """All statements, kept or not, of a unit that the course has written itself."""
        return parsed(self.source)

    @property
    def kept_sources(self) -> list[str]:
        """The kept statements of each group, as they were written."""
        return list(reader().ask("kept", self.as_request()) or [])

    def place_of(self, index: int) -> str:
        """Return where a statement stands."""
        return f"{self.name}, line {self.lines[index]}"


@dataclass(frozen=True)
class Submission:
    """What was handed in: its name, its units, and what could not be read of it.

    `lost` says why a function could not be read, by its name.
    """

    path: Path
    units: tuple[Unit, ...]
    unreadable: tuple[str, ...]
    exercise: str | None
    lost: dict[str, str] = field(default_factory=dict)

    @property
    def left_out(self) -> dict[str, str]:
        """What gives a name and is left out, by that name: imports that are not on the list."""
        return {name: why for unit in self.units for name, why in unit.left_out.items()}

    @property
    def functions(self) -> tuple[str, ...]:
        """The names of the functions it defines, in the order of the file."""
        return tuple(name for unit in self.units for name in unit.functions)

    def used_by(self, function: str) -> set[str]:
        """Return the names that a function looks up, and the functions that it calls, and so on."""
        found: set[str] = set()
        left = {function}
        while left:
            name = left.pop()
            used = {other for unit in self.units for other in unit.uses.get(name, ())}
            left |= used - found
            found |= used
        return found


def read_submission(path: Path) -> Submission:
    """Return the submission in a file.

    Raises
    ------
    SubmissionError
        The file is missing, empty, a link, too large, neither .ipynb nor .py, not text, not
        a notebook, or holds no code at all.
    """
    text = _text_of(path)
    is_notebook = _is_notebook(path)
    sources, exercise = [(f"your {path.name}", text)], None
    if is_notebook:
        sources, exercise = _notebook_cells(path, text)
    given = [{"name": name, "source": code, "is_cell": is_notebook} for name, code in sources]
    read = read_units(given)
    units = tuple(_unit(part) for part in read if _may_answer(part))
    unread = [(one_line(part["unreadable"]), part["lost"]) for part in read if "lost" in part]
    if not units and not unread:
        raise SubmissionError(f"{path}: holds no code to grade")
    lost = {function: why for why, functions in unread for function in functions}
    return Submission(path, units, tuple(why for why, _ in unread), exercise, lost)


def _may_answer(read: dict[str, Any]) -> bool:
    """Return whether anything of a unit is kept, or was left out for what it imports."""
    return any(read.get("groups", ())) or bool(read.get("left_out"))


def _unit(read: dict[str, Any]) -> Unit:
    """Return a unit as it was read."""
    sequences = ("lines", "functions", "missing")
    groups = tuple(map(tuple, read["groups"]))
    return Unit(**{**read, "groups": groups, **{name: tuple(read[name]) for name in sequences}})


def _text_of(path: Path) -> str:
    """Return the text of a file, or say why it cannot be one."""
    if path.is_symlink():
        raise SubmissionError(f"{path}: a submission is a file, and this is a link")
    if not path.exists():
        raise SubmissionError(f"{path}: no such file")
    if not path.is_file():
        raise SubmissionError(f"{path}: a submission is a file, and this is none")
    if path.suffix.lower() not in (".ipynb", ".py"):
        raise SubmissionError(f"{path}: a submission ends in .ipynb or .py")
    if path.stat().st_size > LARGEST_FILE:
        cause = "; clear the outputs of its cells and save it" if _is_notebook(path) else ""
        raise SubmissionError(f"{path}: larger than {LARGEST_FILE // 1_000_000} MB{cause}")
    text = _decoded(path)
    if not text.strip():
        raise SubmissionError(f"{path}: is empty")
    return text


def _is_notebook(path: Path) -> bool:
    """Return whether a file is a notebook by its name."""
    return path.suffix.lower() == ".ipynb"


def _decoded(path: Path) -> str:
    """Return a file's text: in UTF-16 by its mark, in what its first lines name, or in UTF-8."""
    raw = path.read_bytes()
    encoding = (
        "utf-16" if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)) else "utf-8-sig"
    )
    try:
        if not _is_notebook(path) and encoding != "utf-16":
            encoding, _ = tokenize.detect_encoding(io.BytesIO(raw).readline)
        text = raw.decode(encoding)
    except (UnicodeDecodeError, SyntaxError, LookupError):
        raise SubmissionError(f"{path}: is not text in UTF-8; save it as UTF-8") from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _notebook_cells(path: Path, text: str) -> tuple[list[tuple[str, str]], str | None]:
    """Return name and code of a notebook's code cells, and the exercise it says it is."""
    try:
        notebook = json.loads(text)
    except (ValueError, RecursionError):
        raise SubmissionError(f"{path}: is not a notebook (its text is not JSON)") from None
    cells = notebook.get("cells") if isinstance(notebook, dict) else None
    if not isinstance(cells, list) or not all(isinstance(cell, dict) for cell in cells):
        raise SubmissionError(f"{path}: is not a notebook (it has no list of cells)")
    if len(cells) > MOST_CELLS:
        raise SubmissionError(f"{path}: has more than {MOST_CELLS} cells")
    sources = [
        (f"your cell {number}", _cell_source(cell))
        for number, cell in enumerate(cells, start=1)
        if cell.get("cell_type") == "code"
    ]
    exercise = _deep(notebook, "metadata", "workbook", "exercise")
    return sources, exercise if isinstance(exercise, str) else None


def _deep(value: Any, *keys: str) -> Any:
    """Return what stands under nested keys, or None where anything else is in the way."""
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _cell_source(cell: dict[str, Any]) -> str:
    """Return a cell's source, which may be a text or a list of lines."""
    source = cell.get("source", "")
    return "".join(map(str, source)) if isinstance(source, list) else str(source)

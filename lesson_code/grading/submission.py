"""A submission: a notebook or a .py file, taken apart into the statements that define answers.

Answers are found by the names of functions, wherever in the file they stand. Kept are
definitions, imports and assignments; bare calls (prints, plots, checks) are left out, and so are
imports of lesson_code, since an answer has to stand on its own.
"""

from __future__ import annotations

import ast
import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

LARGEST_FILE = 20_000_000
"""Bytes. A notebook with every figure in it stays under 2 MB."""

MOST_CELLS = 2_000
"""A chapter's exercise has about 20 cells."""

MAGIC = re.compile(r"^(\s*)[%!].*$", re.MULTILINE)


class SubmissionError(ValueError):
    """A file that cannot be graded at all; the message says why and names the file."""


@dataclass(frozen=True)
class Unit:
    """Statements that run one after another until one fails: a cell, or a statement of a .py."""

    name: str
    source: str
    keep: tuple[int, ...]

    def as_request(self) -> dict[str, Any]:
        """Return the unit as the child process is sent it."""
        return {"name": self.name, "source": self.source, "keep": self.keep}

    @property
    def kept_source(self) -> str:
        """The kept statements alone, as they were written."""
        lines = self.source.splitlines()
        body = ast.parse(self.source).body
        return "\n\n".join(_written(body[index], lines) for index in self.keep)


@dataclass(frozen=True)
class Submission:
    """What was handed in: its name, its units, and what could not be read of it."""

    path: Path
    units: tuple[Unit, ...]
    unreadable: tuple[str, ...]
    exercise: str | None

    @property
    def functions(self) -> tuple[str, ...]:
        """The names of the functions it defines, in the order of the file."""
        return tuple(
            statement.name
            for unit in self.units
            for statement in ast.parse(unit.source).body
            if isinstance(statement, ast.FunctionDef)
        )


def read_submission(path: Path) -> Submission:
    """Return the submission in a file.

    Raises
    ------
    SubmissionError
        The file is missing, empty, too large, neither .ipynb nor .py, not text, not a
        notebook, or holds no code at all.
    """
    text = _text_of(path)
    if path.suffix == ".ipynb":
        cells, exercise = _notebook_cells(path, text)
        parts = [_unit(f"your cell {number}", source) for number, source in cells]
    else:
        exercise = None
        parts = _statements(f"your {path.name}", text)
    units = tuple(part for part in parts if isinstance(part, Unit) and part.keep)
    unreadable = tuple(part for part in parts if isinstance(part, str))
    if not units and not unreadable:
        raise SubmissionError(f"{path}: holds no code to grade")
    return Submission(path, units, unreadable, exercise)


def _text_of(path: Path) -> str:
    """Return the text of a file, or say why it cannot be one."""
    if not path.exists():
        raise SubmissionError(f"{path}: no such file")
    if not path.is_file():
        raise SubmissionError(f"{path}: a submission is a file, and this is none")
    if path.suffix not in (".ipynb", ".py"):
        raise SubmissionError(f"{path}: a submission ends in .ipynb or .py")
    if path.stat().st_size > LARGEST_FILE:
        raise SubmissionError(f"{path}: larger than {LARGEST_FILE // 1_000_000} MB")
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise SubmissionError(f"{path}: is not text in UTF-8") from None
    if not text.strip():
        raise SubmissionError(f"{path}: is empty")
    return text


def _notebook_cells(path: Path, text: str) -> tuple[list[tuple[int, str]], str | None]:
    """Return the numbered code cells of a notebook, and the exercise it says it is."""
    try:
        notebook = json.loads(text)
    except (ValueError, RecursionError):
        raise SubmissionError(f"{path}: is not a notebook (its text is not JSON)") from None
    cells = notebook.get("cells") if isinstance(notebook, dict) else None
    if not isinstance(cells, list) or not all(isinstance(cell, dict) for cell in cells):
        raise SubmissionError(f"{path}: is not a notebook (it has no list of cells)")
    if len(cells) > MOST_CELLS:
        raise SubmissionError(f"{path}: has more than {MOST_CELLS} cells")
    numbered = [
        (number, _cell_source(cell))
        for number, cell in enumerate(cells, start=1)
        if cell.get("cell_type") == "code"
    ]
    exercise = _deep(notebook, "metadata", "workbook", "exercise")
    return numbered, exercise if isinstance(exercise, str) else None


def _deep(value: Any, *keys: str) -> Any:
    """Return what stands under nested keys, or None where anything else is in the way."""
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _cell_source(cell: dict[str, Any]) -> str:
    """Return a cell's source, with magics turned into comments."""
    source = cell.get("source", "")
    joined = "".join(map(str, source)) if isinstance(source, list) else str(source)
    return MAGIC.sub(r"\1pass  # a magic, left out", joined)


def _unit(name: str, source: str) -> Unit | str:
    """Return a cell as a unit, or in a line why it cannot be read."""
    try:
        body = ast.parse(source).body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        return _unreadable(name, error)
    return Unit(name, source, tuple(i for i, item in enumerate(body) if _is_kept(item)))


def _statements(name: str, source: str) -> list[Unit | str]:
    """Return each kept statement of a .py file as a unit of its own."""
    whole = _unit(name, source)
    if isinstance(whole, str):
        return [whole]
    return [Unit(name, source, (index,)) for index in whole.keep]


def _unreadable(name: str, error: Exception) -> str:
    """Return in a line where the syntax is wrong."""
    if isinstance(error, SyntaxError):
        return f"{name}, line {error.lineno}: {error.msg}"
    return f"{name}: cannot be read ({error or type(error).__name__})"


def _is_kept(statement: ast.stmt) -> bool:
    """Return whether a statement may define an answer."""
    if isinstance(statement, ast.Expr | ast.Pass):
        return False
    if isinstance(statement, ast.Import):
        return not any(_is_lesson_code(alias.name) for alias in statement.names)
    if isinstance(statement, ast.ImportFrom):
        return not _is_lesson_code(statement.module or "")
    return not (isinstance(statement, ast.If) and "__name__" in ast.unparse(statement.test))


def _is_lesson_code(module: str) -> bool:
    """Return whether a module belongs to this package."""
    return module.partition(".")[0] == "lesson_code"


def _written(statement: ast.stmt, lines: list[str]) -> str:
    """Return a statement's own lines, decorators included."""
    decorators = getattr(statement, "decorator_list", [])
    first = min([statement.lineno, *(decorator.lineno for decorator in decorators)])
    return "\n".join(lines[first - 1 : statement.end_lineno])

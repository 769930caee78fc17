"""A submission: a notebook or a .py file, taken apart into the statements that define answers.

Answers are found by the names of functions, wherever in the file they stand. Kept are
definitions, imports and assignments, and calls that fill a container (``SETTINGS.update(...)``).
Left out are other bare calls (prints, plots, checks), loops without an end, what awaits something,
and imports of lesson_code, since an answer has to stand on its own.
"""

from __future__ import annotations

import ast
import codecs
import io
import json
import re
import tokenize
import warnings
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from lesson_code.course.isolation.call_outcome import one_line

LARGEST_FILE = 20_000_000
"""Bytes. A notebook with every figure in it stays under 2 MB."""

MOST_CELLS = 2_000
"""A chapter's exercise has about 20 cells."""

MOST_CODE = 100_000
"""Characters. A chapter's answers take 5,000; reading code takes a thousand times its memory."""

MOST_BRACES = 2_000
"""Braces that open. A chapter's answers have 20. Python reads an f-string in a time that grows with
the square of its expressions, each of which has one, and cannot be interrupted."""

MAGIC = re.compile(
    r"^([ \t]*)(?:(?:\w[\w, ]*=[ \t]*)?[%!].*|\?.*|[\w.]+\?{1,2}[ \t]*)$", re.MULTILINE
)
"""Lines that a notebook understands and Python does not: %magic, !command, x = !command, name?."""

FOREIGN = re.compile(
    r"\s*%%(bash|sh|html|javascript|js|latex|markdown|svg|script|writefile|perl)\b"
)
"""How a cell in another language begins."""

DEFINITION = re.compile(r"^[ \t]*def[ \t]+([A-Za-z_]\w*)", re.MULTILINE)
"""Where a function begins in code that cannot be read."""

FILLS = ("update", "append", "extend", "add", "insert", "setdefault", "sort", "reverse")
"""Methods that a bare call may fill a container with."""

LONGEST_LINE = 80
"""Characters of a line with an error in it that are shown."""

UNPARSABLE = (SyntaxError, ValueError, RecursionError, MemoryError)
"""What reading code may end in."""


class SubmissionError(ValueError):
    """A file that cannot be graded at all; the message says why and names the file."""


@dataclass(frozen=True)
class Unit:
    """A cell, or a whole .py file: its code, and which of its statements are kept.

    Statements are kept in groups, which run one after another. A statement that fails ends its
    group: a cell is one group, as in a notebook; in a .py file each statement is its own.
    """

    name: str
    source: str
    groups: tuple[tuple[int, ...], ...]

    def as_request(self) -> dict[str, Any]:
        """Return the unit as the child process is sent it."""
        return {"name": self.name, "source": self.source, "groups": self.groups}

    @property
    def parts(self) -> list[Unit]:
        """The unit in parts, each of which holds one statement that is kept."""
        return [replace(self, groups=((index,),)) for group in self.groups for index in group]

    @cached_property
    def statements(self) -> list[ast.stmt]:
        """All statements, kept or not."""
        return parsed(self.source)

    @property
    def kept_sources(self) -> list[str]:
        """The kept statements of each group, as they were written."""
        body = self.statements
        return [
            "\n\n".join(_written(body[index], self.source) for index in group)
            for group in self.groups
        ]


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
        """What gives a name and is left out, by that name: imports of lesson_code."""
        return {
            (alias.asname or alias.name).partition(".")[0]: "import of lesson_code"
            for unit in self.units
            for statement in ast.walk(ast.Module(unit.statements, []))
            if isinstance(statement, ast.Import | ast.ImportFrom) and not _is_kept(statement)
            for alias in statement.names
        }

    @property
    def functions(self) -> tuple[str, ...]:
        """The names of the functions it defines, in the order of the file."""
        return tuple(
            statement.name
            for unit in self.units
            for statement in unit.statements
            if isinstance(statement, ast.FunctionDef)
        )


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
    if sum(len(source) for _, source in sources) > MOST_CODE:
        raise SubmissionError(f"{path}: holds more than {MOST_CODE:,} characters of code")
    if sum(source.count("{") for _, source in sources) > MOST_BRACES:
        raise SubmissionError(f"{path}: holds more than {MOST_BRACES:,} curly brackets in its code")
    parts = [_unit(name, source, is_cell=is_notebook) for name, source in sources]
    units = tuple(part for part in parts if isinstance(part, Unit) and any(part.groups))
    unreadable = tuple(part for part in parts if isinstance(part, str))
    if not units and not unreadable:
        raise SubmissionError(f"{path}: holds no code to grade")
    lost = {
        function: part
        for part, (_, source) in zip(parts, sources, strict=True)
        if isinstance(part, str)
        for function in DEFINITION.findall(source)
    }
    return Submission(path, units, unreadable, exercise, lost)


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


def parsed(source: str) -> list[ast.stmt]:
    """Return the statements of some code, without a word about its style."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ast.parse(source).body


def _unit(name: str, source: str, *, is_cell: bool) -> Unit | str:
    """Return a cell or a file as a unit, or in a line why it cannot be read."""
    try:
        code, body = _cell(source) if is_cell else (source, parsed(source))
    except UNPARSABLE as error:
        return _unreadable(name, error)
    kept = tuple(i for i, statement in enumerate(body) if _is_kept(statement))
    return Unit(name, code, (kept,) if is_cell else tuple((index,) for index in kept))


def _cell(source: str) -> tuple[str, list[ast.stmt]]:
    """Return a cell's code and statements, with magics commented out if it cannot be read as it is.

    A cell in another language is no code at all.
    """
    if FOREIGN.match(source):
        return "", []
    try:
        return source, parsed(source)
    except UNPARSABLE:
        code = MAGIC.sub(r"\1pass  # a magic, left out", source)
        return code, parsed(code)


def _unreadable(name: str, error: Exception) -> str:
    """Return in a line where the syntax is wrong."""
    if isinstance(error, SyntaxError):
        line = (error.text or "").strip()
        shown = f", in: {one_line(line[:LONGEST_LINE])}" if line else ""
        return f"{name}, line {error.lineno}: {one_line(error.msg)}{shown}"
    return f"{name}: cannot be read ({error or type(error).__name__})"


def _is_kept(statement: ast.stmt) -> bool:
    """Return whether a statement may define an answer."""
    if isinstance(statement, ast.Expr):
        return _sets_up(statement.value)
    if isinstance(statement, ast.Pass) or _never_ends(statement) or _waits(statement):
        return False
    if isinstance(statement, ast.Import):
        return not any(_is_lesson_code(alias.name) for alias in statement.names)
    if isinstance(statement, ast.ImportFrom):
        return not _is_lesson_code(statement.module or "")
    return not (isinstance(statement, ast.If) and _asks_for_name(statement.test))


def _sets_up(expression: ast.expr) -> bool:
    """Return whether an expression fills a container of the answer's own: ``SETTINGS.update(a=1)``.

    Any other bare call, such as a print, a plot or a check, is left out.
    """
    match expression:
        case ast.Call(func=ast.Attribute(value=ast.Name(), attr=method)):
            return method in FILLS
    return False


def _never_ends(statement: ast.stmt) -> bool:
    """Return whether a statement is a loop without an end: a demo below the answers."""
    return (
        isinstance(statement, ast.While)
        and isinstance(statement.test, ast.Constant)
        and bool(statement.test.value)
        and not any(isinstance(part, ast.Break) for part in ast.walk(statement))
    )


def _waits(statement: ast.stmt) -> bool:
    """Return whether a statement awaits something, which only a notebook can do."""
    if isinstance(statement, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
        return False
    waits = ast.Await | ast.AsyncFor | ast.AsyncWith
    return any(isinstance(part, waits) for part in ast.walk(statement))


def _asks_for_name(test: ast.expr) -> bool:
    """Return whether a condition looks at ``__name__``."""
    return any(isinstance(node, ast.Name) and node.id == "__name__" for node in ast.walk(test))


def _is_lesson_code(module: str) -> bool:
    """Return whether a module belongs to this package."""
    return module.partition(".")[0] == "lesson_code"


def _written(statement: ast.stmt, source: str) -> str:
    """Return a statement's own text, decorators included."""
    decorators = getattr(statement, "decorator_list", [])
    if decorators:
        statement.lineno, statement.col_offset = decorators[0].lineno, 0
    return ast.get_source_segment(source, statement) or ""

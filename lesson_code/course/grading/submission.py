"""A submission: a notebook or a .py file, taken apart into the statements that define answers.

Answers are found by the names of functions, wherever in the file they stand. Which statements are
kept is said in ``isolation.inside.reading``, which reads them in a process of its own.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from lesson_code.course.isolation.call_outcome import one_line
from lesson_code.course.isolation.inside.files import is_notebook
from lesson_code.course.isolation.inside.reading import parsed
from lesson_code.course.isolation.reader import TOO_SLOW, read_file, reader

LARGEST_FILE = 50_000_000
"""Bytes. A notebook with every figure in it stays under 2 MB; films and printed loops take more."""

ARCHIVES = (".zip", ".7z", ".rar", ".tar", ".gz", ".tgz", ".bz2", ".xz")
"""How files end in which others are packed."""

CLEAR = "clear the outputs of its cells and save it"
"""What makes a notebook small."""


class SubmissionError(ValueError):
    """A file that cannot be graded at all; the message says why and names the file."""


@dataclass(frozen=True)
class Unit:
    """A cell, or a whole .py file: its code, and which of its statements are kept.

    Statements are kept in groups, which run one after another. A statement that fails ends its
    group: a cell is one group, as in a notebook; in a .py file each statement is its own. `lines`
    says where each statement begins; `missing` names what an import gives that is left out; `uses`
    says which names stand in a definition, `prints` has the fingerprints of its functions, and
    `codes` the kept statements compiled, by their places.
    """

    name: str
    source: str
    groups: tuple[tuple[int, ...], ...]
    lines: tuple[int, ...] = ()
    functions: tuple[str, ...] = ()
    left_out: dict[str, str] = field(default_factory=dict)
    missing: tuple[str, ...] = ()
    uses: dict[str, list[str]] = field(default_factory=dict)
    prints: tuple[dict[str, Any], ...] = ()
    codes: tuple[str | None, ...] = ()

    def as_request(self) -> dict[str, Any]:
        """Return the unit as the child process is sent it."""
        names = ("name", "source", "groups", "missing", "codes")
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
        """What gives a name and is left out, by that name: imports off the list, and awaits."""
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
    _must_be_readable(path)
    found = read_file(str(path.absolute()))
    if "problem" in found:
        cure = _cure(path) if found["problem"] == TOO_SLOW else ""
        raise SubmissionError(f"{path}: {found['problem']}{cure}")
    read = found["units"]
    units = tuple(_unit(part) for part in read if _may_answer(part))
    unread = [(one_line(part["unreadable"]), part["lost"]) for part in read if "lost" in part]
    if not units and not unread:
        raise SubmissionError(f"{path}: holds no code to grade")
    lost = {function: why for why, functions in unread for function in functions}
    return Submission(path, units, tuple(why for why, _ in unread), found.get("exercise"), lost)


def _may_answer(read: dict[str, Any]) -> bool:
    """Return whether anything of a unit is kept, or was left out for what it imports."""
    return any(read.get("groups", ())) or bool(read.get("left_out"))


def _unit(read: dict[str, Any]) -> Unit:
    """Return a unit as it was read."""
    sequences = ("lines", "functions", "missing", "prints", "codes")
    groups = tuple(map(tuple, read["groups"]))
    return Unit(**{**read, "groups": groups, **{name: tuple(read[name]) for name in sequences}})


def _must_be_readable(path: Path) -> None:
    """Raise for what is no file of a submission's kind and size."""
    if path.is_symlink():
        raise SubmissionError(f"{path}: a submission is a file, and this is a link")
    if not path.exists():
        raise SubmissionError(f"{path}: no such file")
    if not path.is_file():
        raise SubmissionError(f"{path}: a submission is a file, and this is none")
    if path.suffix.lower() not in (".ipynb", ".py"):
        cure = "; unpack it first" if is_archive(path.name) else ""
        raise SubmissionError(f"{path}: a submission ends in .ipynb or .py{cure}")
    if path.stat().st_size > LARGEST_FILE:
        raise SubmissionError(f"{path}: larger than {LARGEST_FILE // 1_000_000} MB{_cure(path)}")


def is_archive(name: str) -> bool:
    """Return whether other files are packed in a file, by its name."""
    return name.lower().endswith(ARCHIVES)


def _cure(path: Path) -> str:
    """Return what helps against a file that is too large, where it is a notebook."""
    return f"; {CLEAR}" if is_notebook(str(path)) else ""

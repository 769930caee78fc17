"""The journal of a class run: each file's marks, written down as soon as they are known.

The first line says what run it is, each further one holds the marks of one file. So a run that
was interrupted goes on where it stopped: a line that was cut off is graded again, and so is a file
that has changed since.
"""

from __future__ import annotations

import json
import os
from contextlib import suppress
from io import BufferedRandom
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    from lesson_code.course.class_run.collect import Paper

JOURNAL = "journal.jsonl"
BEGINS = b'{"version": '
"""How a journal begins, unless it was cut off there."""

Marks: TypeAlias = dict[str, Any]
"""What a file has earned, as JSON: a report, or "problem" alone; with "is_other", where it may be a
file that answers nothing, such as a module of helpers. "is_assumed" says of a report that nothing
in the file tells its exercise: it is the only one that counts. "was_cut_off" says that it wanted
more time than it may use; such marks are not in the journal."""


class Journal:
    """A journal that is open for writing.

    Parameters
    ----------
    path : Path
        Its place; created if it is not there.
    head : dict
        What the run is. None under a name of `drawn` agrees with whatever was drawn before.
    drawn : dict
        Takes the place of None in a new journal.

    Attributes
    ----------
    head : dict
        What the journal says the run is.
    done : dict
        The marks that stand in it, by :func:`key_of` their file.

    Raises
    ------
    ValueError
        The journal is that of another run, and what differs is named; or another run is writing it.
    """

    def __init__(self, path: Path, head: dict[str, Any], drawn: dict[str, Any]) -> None:
        self.path = path
        self.done: dict[str, Marks] = {}
        self.head = head | {name: drawn[name] for name in drawn if head[name] is None}
        self._file: BufferedRandom = path.open("a+b")
        try:
            _lock(self._file, path)
            self._read(
                {name: head[name] for name in head if name not in drawn or head[name] is not None}
            )
        except BaseException:
            self._file.close()
            raise

    def __enter__(self) -> Journal:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._file.close()

    def write(self, paper: Paper, marks: Marks) -> None:
        """Write down what a file has earned; when this returns, the line has left the process."""
        self.done[key_of(paper)] = marks
        self._line({"paper": key_of(paper), "marks": marks})

    def _read(self, required: dict[str, Any]) -> None:
        """Read what stands in it, cut off a line that was not finished, and check the first."""
        self._file.seek(0)
        whole = 0
        lines: list[Any] = []
        for line in self._file:
            value = _value(line)
            if value is None:
                break
            lines.append(value)
            whole += len(line)
        self._file.truncate(whole)
        if not lines:
            self._line(self.head)
            return
        self.head = lines[0]
        for name, wanted in required.items():
            if self.head.get(name) != wanted:
                raise ValueError(
                    f"{self.path}: is the journal of another run ({name} was "
                    f"{self.head.get(name)!r} and is {wanted!r} now); --fresh begins again"
                )
        self.done = {line["paper"]: line["marks"] for line in lines[1:]}

    def _line(self, value: dict[str, Any]) -> None:
        """Add a line."""
        self._file.seek(0, os.SEEK_END)
        self._file.write(json.dumps(value).encode() + b"\n")
        self._file.flush()


def is_journal(path: Path) -> bool:
    """Return whether a file is a journal of ours."""
    with suppress(OSError):
        if path.is_file():
            with path.open("rb") as file:
                return BEGINS.startswith(file.read(len(BEGINS)))
    return False


def _lock(file: BufferedRandom, path: Path) -> None:
    """Keep other runs from writing the same journal, for as long as the file is open."""
    try:
        import fcntl
    except ImportError:  # Windows has no fcntl: there a second run is not kept out
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise ValueError(f"{path}: another run is writing it") from None


def key_of(paper: Paper) -> str:
    """Return what tells a file's marks from those of any other file, and of an earlier version."""
    return f"{paper.digest} {paper.name}"


def _value(line: bytes) -> dict[str, Any] | None:
    """Return what stands in a whole line; None where it was cut off."""
    try:
        value = json.loads(line) if line.endswith(b"\n") else None
    except ValueError:
        return None
    return value if isinstance(value, dict) else None

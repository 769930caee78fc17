"""A class's submissions: one folder or file per student, found and named, not yet read."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

from lesson_code.course.class_run.names import same_name, shown
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.submission import LARGEST_FILE

GRADABLE = (".ipynb", ".py")
MOST_FILES = 200
"""Gradable files a student; the course has about 20 exercises."""

LEFT_ALONE = (
    *("__pycache__", "__MACOSX", "venv", "site-packages"),
    *("lesson_code", "notebooks", "solutions", "backups"),
)
"""Folders of tools and of the workbook, which students hand in along with their own; so are those
whose names begin with a dot."""

SEPARATORS = "_-. "
"""What stands between a student's id and the rest of a file's name."""


@dataclass(frozen=True)
class Paper:
    """A file that a student handed in.

    `name` is its path within the class's folder, with slashes; `digest` says what stands in it.
    """

    name: str
    path: Path
    digest: str
    handed_in: datetime


@dataclass(frozen=True)
class HandIn:
    """A student, the student's files, and remarks about them."""

    student: Enrolled
    papers: tuple[Paper, ...] = ()
    problems: tuple[str, ...] = ()
    on_roster: bool = True
    entries: tuple[str, ...] = field(default=(), compare=False)

    @property
    def is_missing(self) -> bool:
        """Whether the student handed in nothing at all."""
        return not self.entries


def collect(
    folder: Path, roster: Sequence[Enrolled] | None = None, without: Container[Path] = ()
) -> list[HandIn]:
    """Return what each student handed in, in the order of their ids.

    Parameters
    ----------
    folder : Path
        Holds one folder or file a student.
    roster : sequence of Enrolled, optional
        The class. An entry belongs to the student whose id is its name, or the beginning of it up
        to a separator. Without a roster each name is a student.
    without : container of Path
        Resolved paths in the folder that are not handed in, such as the roster itself.

    Raises
    ------
    ValueError
        The folder is not one, or holds nothing.
    """
    if not folder.is_dir():
        raise ValueError(f"{folder}: there is no such folder")
    entries = sorted(
        entry
        for entry in folder.iterdir()
        if not _is_tools(entry.name) and entry.resolve() not in without
    )
    if not entries:
        raise ValueError(f"{folder}: nothing has been handed in")
    ids = None if roster is None else {same_name(student.id): student.id for student in roster}
    whose: dict[str, list[Path]] = {}
    for entry in entries:
        whose.setdefault(_student_of(entry, ids or {}), []).append(entry)
    listed = {student.id: student for student in roster or ()}
    return [
        _hand_in(
            folder,
            listed.get(name, Enrolled(name)),
            whose.get(name, []),
            on_roster=roster is None or name in listed,
        )
        for name in sorted({*whose, *listed})
    ]


def _is_tools(name: str) -> bool:
    """Return whether a name is that of a tool's or the workbook's folder."""
    return name.startswith(".") or name in LEFT_ALONE


def _student_of(entry: Path, ids: Mapping[str, str]) -> str:
    """Return whose a folder or file is: an id of the roster, the longest that fits, or its name."""
    name = entry.name if entry.is_dir() else entry.stem
    written = same_name(name)
    ends = [place for place, letter in enumerate(written) if letter in SEPARATORS]
    for end in (len(written), *reversed(ends)):
        if written[:end] in ids:
            return ids[written[:end]]
    return _without_exercise(name)


def _without_exercise(name: str) -> str:
    """Return a name without the exercise's own name at its end: ada_01_one_dimension is ada's."""
    for exercise in exercises():
        rest = name.removesuffix(exercise.name).rstrip(SEPARATORS)
        if rest and len(rest) < len(name) - len(exercise.name):
            return rest
    return name


def _hand_in(folder: Path, student: Enrolled, entries: list[Path], *, on_roster: bool) -> HandIn:
    """Return what one student handed in."""
    problems: list[str] = []
    papers: list[Paper] = []
    for entry in entries:
        files = list(_files_in(folder, entry, problems))
        if not files and not problems:
            problems.append(f"{_name(folder, entry)}: holds no .ipynb or .py file")
        papers += [_paper(folder, path) for path in files[:MOST_FILES]]
        if len(files) > MOST_FILES:
            problems.append(
                f"{_name(folder, entry)}: holds more than {MOST_FILES} files; "
                f"only the first {MOST_FILES} are graded"
            )
    names = tuple(entry.name for entry in entries)
    return HandIn(student, tuple(papers), tuple(problems), on_roster, names)


def _files_in(folder: Path, entry: Path, problems: list[str]) -> Iterator[Path]:
    """Yield the files of an entry that may be graded; note what cannot be."""
    if entry.is_symlink() or not entry.is_dir():
        yield entry  # the reader says what is wrong with it
        return

    def unreadable(error: OSError) -> None:
        problems.append(f"{_name(folder, entry)}: cannot be read ({error.strerror})")

    for top, folders, files in os.walk(entry, onerror=unreadable):
        folders[:] = sorted(name for name in folders if not _is_tools(name))
        for name in sorted(files):
            if Path(name).suffix.lower() in GRADABLE and not _is_tools(name):
                yield Path(top) / name


def _paper(folder: Path, path: Path) -> Paper:
    """Return a file as what was handed in."""
    try:
        modified = path.lstat().st_mtime
    except OSError:
        modified = 0.0
    when = datetime.fromtimestamp(int(modified)).astimezone()
    return Paper(path.relative_to(folder).as_posix(), path, _digest(path), when)


def _digest(path: Path) -> str:
    """Return what tells a file's content from any other; of what is not graded, its kind alone."""
    try:
        if path.is_symlink() or not path.is_file():
            return "no file"
        if (size := path.stat().st_size) > LARGEST_FILE:
            return f"{size} bytes"
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        return f"unreadable: {error.strerror}"


def _name(folder: Path, path: Path) -> str:
    """Return a file's name within the class's folder, as it is shown."""
    return shown(path.relative_to(folder).as_posix())

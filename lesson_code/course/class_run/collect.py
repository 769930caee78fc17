"""A class's submissions: one folder or file per student, found and named, not yet read."""

from __future__ import annotations

import hashlib
import os
from collections import Counter
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from lesson_code.course.class_run.downloads import (
    GRADESCOPE_LIST,
    Submitters,
    named,
    read_gradescope_list,
)
from lesson_code.course.class_run.journal import JOURNAL, is_journal
from lesson_code.course.class_run.matching import owners
from lesson_code.course.class_run.names import encodable, same_name, visible
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.grading.submission import LARGEST_FILE, is_archive

GRADABLE = (".ipynb", ".py")
MOST_FILES = 200
"""Gradable files a student; the course has about 20 exercises."""

MOST_NAMED = 200
"""Files that are named one by one in a remark; of more, their number is said."""

LEFT_ALONE = (
    *("__pycache__", "__MACOSX", "venv", "site-packages"),
    *("lesson_code", "notebooks", "solutions", "backups"),
)
"""Folders of tools and of the workbook, which students hand in along with their own.

They are left out, and so is what begins with a dot: systems hide such names, and tools keep copies
of notebooks there, which would be taken for a student's answer. An entry that the roster lists is
graded whatever it is called, and all that is left out is named.
"""

OF_THE_SYSTEM = ("thumbs.db", "desktop.ini")
"""Files that Windows makes in a folder. They are left out, too."""

DOT, TOOLS = "the name begins with a dot", "a folder of tools or of the workbook"
SYSTEM = "a file of the system"
OTHER_KIND, LINK = "no .ipynb or .py file", "a link to a folder"
OWN = "the roster or the marks of this run"
EARLIER = "the marks of an earlier run"
LIST = "Gradescope's list of submissions"


@dataclass(frozen=True)
class Paper:
    """A file that a student handed in.

    `name` is its path within the class's folder, with slashes; `digest` says what stands in it.
    `handed_in` is None where a download says no more than whether it is late: `is_late`. `number`
    is that of the file in a download, which grows with time.
    """

    name: str
    path: Path
    digest: str
    handed_in: datetime | None
    is_late: bool = False
    number: int = 0

    @property
    def age(self) -> tuple[int, float]:
        """What grows with the time at which it was handed in."""
        return self.number, self.handed_in.timestamp() if self.handed_in else 0.0


@dataclass(frozen=True)
class HandIn:
    """A student, the student's files, and remarks about them.

    `problems` are of what should have been graded and is not, `notes` of all else. `entries` are
    the names of the folders and files in the class's folder; `unmatched` says why they are credited
    to no line of the roster.
    """

    student: Enrolled
    papers: tuple[Paper, ...] = ()
    problems: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    unmatched: str = ""
    entries: tuple[str, ...] = field(default=(), compare=False)

    @property
    def is_missing(self) -> bool:
        """Whether the student handed in nothing at all."""
        return not self.entries

    @property
    def is_renamed(self) -> bool:
        """Whether anything but one entry of just the student's id is credited to the student."""
        own = {self.student.id + suffix for suffix in ("", *map(_suffix, self.entries))}
        return len(self.entries) > 1 or not own.issuperset(self.entries)


class Collected(NamedTuple):
    """What a class handed in, and in a line each what of its folder is left out."""

    hand_ins: list[HandIn]
    left_out: tuple[str, ...]


def collect(
    folder: Path, roster: Sequence[Enrolled] | None = None, without: Container[str] = ()
) -> Collected:
    """Return what each student handed in, in the order of their ids.

    Each entry of the folder is credited to one student, as :func:`.matching.owners` says, or named
    as left out.

    Parameters
    ----------
    folder : Path
        Holds one folder or file a student.
    roster : sequence of Enrolled, optional
        The class. Without it each name is a student.
    without : container of str
        Real paths (`os.path.realpath`) in the folder that are not handed in, such as the roster's.

    Raises
    ------
    ValueError
        The folder is not one, or holds nothing.
    """
    if not folder.is_dir():
        raise ValueError(f"{folder}: there is no such folder")
    inside = [entry for entry in folder.iterdir() if not entry.name.startswith(".")]
    if len(inside) == 1 and (inside[0] / GRADESCOPE_LIST).is_file():
        raise ValueError(f"{folder}: holds a download of Gradescope's; grade {inside[0]}")
    enrolled = {student.id: student for student in roster or ()}
    submitters = read_gradescope_list(folder)
    entries, left_out = _entries(folder, set(map(same_name, enrolled)), without)
    if not entries:
        raise ValueError("; ".join((f"{folder}: nothing has been handed in", *left_out)))
    whose: dict[tuple[str, str], list[Path]] = {(name, ""): [] for name in enrolled}
    found = owners([_called(entry) for entry in entries], roster, submitters)
    for entry, its_owners in zip(entries, found, strict=True):
        for owner in its_owners:
            whose.setdefault((owner.id, owner.unmatched), []).append(entry)
            if owner.listed:
                enrolled.setdefault(owner.id, owner.listed)
    shared = _shared(roster or (), whose)
    systems = {made.system if (made := named(_called(entry))) else "" for entry in entries}
    is_download = len(systems) == 1
    alike = Counter(same_name(name) for name, _ in whose)
    hand_ins = []
    for (name, unmatched), own in sorted(whose.items()):
        remarks = [f"unmatched: {unmatched}"] if unmatched else []
        if alike[same_name(name)] > 1:
            remarks.append(f"{visible(name)}: another's name differs only in how it is written")
        student = enrolled.get(name, Enrolled(name))
        if is_download and not unmatched:
            student = _numbered(student, own)
        of_others = shared.get(name, []) if not unmatched else []
        remarks += [f"{visible(entry.name)}: handed in by {who}" for entry, who in of_others]
        all_ = sorted({*own, *(entry for entry, _ in of_others)})
        hand_ins.append(_hand_in(folder, student, all_, unmatched, remarks, submitters))
    return Collected(hand_ins, left_out)


def _numbered(student: Enrolled, entries: Sequence[Path]) -> Enrolled:
    """Return a student with the number that the course system's download gives, if any."""
    for made in filter(None, map(named, map(_called, entries))):
        if made.system == "canvas":
            student = replace(student, canvas=student.canvas or made.number)
        else:
            student = replace(student, moodle=student.moodle or made.number)
    return student


def _shared(
    roster: Sequence[Enrolled], whose: Mapping[tuple[str, str], list[Path]]
) -> dict[str, list[tuple[Path, str]]]:
    """Return what each student of a team has from the others of it, and from whom."""
    teams: dict[str, list[str]] = {}
    for student in roster:
        if student.team:
            teams.setdefault(same_name(student.team), []).append(student.id)
    return {
        name: [
            (entry, visible(other))
            for other in members
            for entry in whose[other, ""]
            if entry not in whose[name, ""]
        ]
        for members in teams.values()
        for name in members
    }


def _entries(
    folder: Path, listed: Container[str], without: Container[str]
) -> tuple[list[Path], tuple[str, ...]]:
    """Return the entries that stand for a student, and lines about those that do not."""
    entries: list[Path] = []
    left_out: list[tuple[str, str]] = []
    for entry in sorted(folder.iterdir()):
        reason = OWN if os.path.realpath(entry) in without else _reason(entry.name)
        reason = LIST if entry.name == GRADESCOPE_LIST else reason
        reason = reason or (EARLIER if is_journal(entry / JOURNAL) else "")
        if reason and (reason in (OWN, LIST) or same_name(_called(entry)) not in listed):
            left_out.append((reason, entry.name))
        else:
            entries.append(entry)
    return entries, _named(left_out)


def _called(entry: Path) -> str:
    """Return what an entry says whose it is: a folder's name, a file's without its suffix."""
    return entry.name if _is_folder(entry) else entry.stem


def _suffix(name: str) -> str:
    """Return the suffix of a file's name."""
    return Path(name).suffix


def _reason(name: str) -> str:
    """Return why nothing of this name is graded; an empty text if it may be."""
    if name.startswith("."):
        return DOT
    if name.casefold() in OF_THE_SYSTEM:
        return SYSTEM
    return TOOLS if name in LEFT_ALONE else ""


def _named(left_out: Iterable[tuple[str, str]]) -> tuple[str, ...]:
    """Return a line for each reason, with the names of what is left out for it."""
    names: dict[str, list[str]] = {}
    for reason, name in left_out:
        names.setdefault(reason, []).append(visible(name))
    return tuple(f"left out, {reason}: {listed(all_)}" for reason, all_ in names.items())


def listed(names: Sequence[str]) -> str:
    """Return names in a line; of very many, the first, and how many more there are."""
    more = len(names) - MOST_NAMED
    line = ", ".join(names[:MOST_NAMED])
    return line if more <= 0 else f"{line} and {more} more"


def _hand_in(
    folder: Path,
    student: Enrolled,
    entries: list[Path],
    unmatched: str,
    remarks: list[str],
    submitters: Mapping[str, Submitters],
) -> HandIn:
    """Return what one student handed in."""
    problems: list[str] = []
    left_out: list[tuple[str, str]] = []
    papers: list[Paper] = []
    for entry in entries:
        before, packed = len(problems), len(left_out)
        files = _files_in(folder, entry, problems, left_out)
        if not files and len(problems) == before:
            archives = [visible(name) for _, name in left_out[packed:] if is_archive(name)]
            cure = f"; unpack {listed(archives)} first" if archives else ""
            problems.append(f"{visible(entry.name)}: holds no .ipynb or .py file{cure}")
        times = submitters.get(_called(entry))
        papers += [_paper(folder, path, entry, times) for path in files[:MOST_FILES]]
        if rest := [_name(folder, path) for path in files[MOST_FILES:]]:
            problems.append(
                f"{visible(entry.name)}: holds more than {MOST_FILES} files; only the first "
                f"{MOST_FILES} are graded, and not {listed(rest)}"
            )
    names = tuple(entry.name for entry in entries)
    paths = [*names, *(paper.name for paper in papers)]
    replaced = [note for name in dict.fromkeys(paths) if (note := _replaced(name))]
    notes = (*remarks, *replaced, *_named(left_out))
    return HandIn(student, tuple(papers), tuple(problems), notes, unmatched, names)


def _replaced(name: str) -> str:
    """Return what is written otherwise in a name; an empty text if it is as the student has it."""
    if encodable(name) != name:
        return f"{visible(name)}: the name is not UTF-8; its other bytes are written as <U+DC..>"
    if visible(name) != name:
        return f"{visible(name)}: what cannot be seen in the name is written as <U+....>"
    return ""


def _files_in(
    folder: Path, entry: Path, problems: list[str], left_out: list[tuple[str, str]]
) -> list[Path]:
    """Return the files of an entry that may be graded; note what cannot be, and what is not."""
    if entry.is_symlink() or not _is_folder(entry):
        return [entry]  # the reader says what is wrong with it
    found: list[Path] = []

    def unreadable(error: OSError) -> None:
        where = _name(folder, Path(os.fsdecode(error.filename or entry)))
        problems.append(f"{where}: cannot be read ({error.strerror})")

    def is_kept(path: Path, reason: str) -> bool:
        if reason:
            left_out.append((reason, path.relative_to(folder).as_posix()))
        return not reason

    waiting = [str(entry)]  # folders may be nested by the thousand, which os.walk does not bear
    while waiting:
        try:
            with os.scandir(waiting.pop()) as inside:
                parts = sorted((Path(part.path), _is_folder(part)) for part in inside)
        except OSError as error:
            unreadable(error)
            continue
        folders = [path for path, is_folder in parts if is_folder]
        waiting += reversed([str(path) for path in folders if is_kept(path, _of_folder(path))])
        found += [path for path, is_folder in parts if not is_folder and is_kept(path, _of(path))]
    return found


def _of_folder(path: Path) -> str:
    """Return why a folder is not looked into; an empty text if it is."""
    return _reason(path.name) or (LINK if os.path.islink(path) else "")  # noqa: PTH114


def _of(file: Path) -> str:
    """Return why a file is not graded; an empty text if it may be."""
    return _reason(file.name) or ("" if _is_gradable(file.name) else OTHER_KIND)


def _is_folder(entry: Path | os.DirEntry[str]) -> bool:
    """Return whether an entry is a folder; False where nobody may look."""
    if isinstance(entry, os.DirEntry) and not entry.is_symlink():
        return entry.is_dir()
    return os.path.isdir(entry)  # noqa: PTH112


def _is_gradable(name: str) -> bool:
    """Return whether a file is a notebook or a program by its name."""
    return _suffix(name).lower() in GRADABLE


def _paper(folder: Path, path: Path, entry: Path, listed: Submitters | None) -> Paper:
    """Return a file as what was handed in, when the download or else the file itself says."""
    name, digest = path.relative_to(folder).as_posix(), _digest(path)
    if listed:
        return Paper(name, path, digest, listed.handed_in)
    if (made := named(_called(entry))) and made.system == "canvas":
        return Paper(name, path, digest, None, made.is_late, made.file)
    try:
        modified = path.lstat().st_mtime
    except OSError:
        modified = 0.0
    return Paper(name, path, digest, datetime.fromtimestamp(int(modified)).astimezone())


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
    return visible(path.relative_to(folder).as_posix())

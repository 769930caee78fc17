"""What course systems make of a class's files when an instructor downloads them.

- Canvas: ``byronada_LATE_123_4567_answers.ipynb``: the name in small letters, whether it is late,
  the student's number, the file's number, the file; ``byronada_123_text.html`` is what was typed
  in. All files carry the time of the download.
- Moodle: ``Ada Byron_123_assignsubmission_file``, a folder or, with the file's name, a file; in a
  group assignment the group's name and a hyphen come first.
- Gradescope: ``submission_4567``, a folder; ``submission_metadata.yml`` says whose each is, and
  when it was handed in.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.sheets import SheetError

CANVAS = re.compile(
    r"(?P<person>.*?)_((?P<late>late)_)?(?P<number>\d+)_((?P<file>\d+)_.+|text|link)",
    re.DOTALL | re.IGNORECASE,
)
MOODLE_MARK = "_assignsubmission_"
MOODLE = re.compile(
    rf"(?P<person>.+)_(?P<number>\d+){MOODLE_MARK}[a-z]+(_.*)?", re.DOTALL | re.IGNORECASE
)

BETWEEN_LOW_LINES = re.compile(r"_(\d+)_")
NOT_IN_MOODLE = re.compile(r"[\0-\x1f\x7f&<>\"`|':\\/]")
"""What Moodle takes out of the names of files."""

GRADESCOPE_LIST = "submission_metadata.yml"
LARGEST_LIST = 200_000_000
"""Bytes; it holds the results of every attempt."""


@dataclass(frozen=True)
class Named:
    """What a name says that a course system made; `file` orders the files of a student."""

    system: str
    person: str
    number: str
    is_late: bool = False
    file: int = 0


@dataclass(frozen=True)
class Submitters:
    """Whom Gradescope lists for a folder, as (name, number, email), and when it was handed in."""

    students: tuple[tuple[str, str, str], ...]
    handed_in: datetime


def named(name: str) -> Named | None:
    """Return what a name says that Canvas or Moodle made; None for any other.

    Where a mark stands twice, a student wrote one of them. Moodle writes the person before the
    last, so a made-up name leads to no other student; Canvas writes its numbers before the first
    letter that a student chooses.

    Examples
    --------
    >>> named("byronada_LATE_123_4567_answers")
    Named(system='canvas', person='byronada', number='123', is_late=True, file=4567)
    >>> named("Ada Byron_123_assignsubmission_file").person
    'Ada Byron'
    """
    if MOODLE_MARK in name.casefold():
        moodle = MOODLE.fullmatch(name)
        return Named("moodle", moodle["person"], moodle["number"]) if moodle else None
    canvas = CANVAS.fullmatch(name)
    if canvas is None or not canvas["person"]:
        return None
    file = int(canvas["file"] or 0)
    return Named("canvas", canvas["person"], canvas["number"], bool(canvas["late"]), file)


def canvas_forms(name: str) -> set[str]:
    """Return what Canvas may make of a name: the last names first, in small letters, joined.

    A number between low lines loses them: they stand round Canvas's own numbers.

    >>> sorted(canvas_forms("Ada_7_ Byron"))
    ['ada7byron', 'byronada7']
    """
    told = BETWEEN_LOW_LINES.sub(r"\1", name.lower())
    words = ["".join(filter(_is_of_a_word, word)) for word in told.split()]
    return {"".join(words[n:] + words[:n]) for n in range(len(words))} - {""}


def moodle_form(name: str) -> str:
    """Return what Moodle makes of a name: spaces for low lines, and without what it takes out.

    >>> moodle_form("Conan O'Brien_2")
    'Conan OBrien 2'
    """
    return NOT_IN_MOODLE.sub("", name.replace("_", " "))


def _is_of_a_word(letter: str) -> bool:
    """Return whether Canvas keeps a letter of a name: letters and their marks, digits, low lines.

    >>> [letter for letter in "o'b-1_" if _is_of_a_word(letter)]
    ['o', 'b', '1', '_']
    """
    kind = unicodedata.category(letter)
    return kind[0] in "LM" or kind in ("Nd", "Pc")


def read_gradescope_list(folder: Path) -> dict[str, Submitters]:
    """Return whose each folder of a Gradescope download is; nothing if it is no such download.

    Raises
    ------
    SheetError
        The list is there and cannot be read.
    """
    import yaml

    path = folder / GRADESCOPE_LIST
    if not path.is_file():
        return {}
    if path.stat().st_size > LARGEST_LIST:
        raise SheetError(f"{path}: larger than {LARGEST_LIST // 1_000_000} MB")
    try:
        plain = getattr(yaml, "CBaseLoader", yaml.BaseLoader)  # all that it reads are texts
        listed = yaml.load(path.read_bytes(), plain)  # noqa: S506
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        said = " ".join(str(error).split())[:200]
        raise SheetError(f"{path}: is not Gradescope's list of submissions ({said})") from None
    if not isinstance(listed, dict):
        raise SheetError(f"{path}: is not Gradescope's list of submissions")
    return {str(name): _submitters(path, str(name), entry) for name, entry in listed.items()}


def _submitters(path: Path, folder: str, entry: Any) -> Submitters:
    """Return the students of a folder."""
    found = entry.get(":submitters") if isinstance(entry, Mapping) else None
    if not isinstance(found, list) or not all(isinstance(one, Mapping) for one in found):
        raise SheetError(f"{path}: {folder} has no :submitters:")
    try:
        when = datetime.fromisoformat(_iso(str(entry.get(":created_at")))).astimezone()
    except (ValueError, OverflowError):
        raise SheetError(f"{path}: {folder} has no time :created_at:") from None
    said = [tuple(str(one.get(key) or "") for key in (":name", ":sid", ":email")) for one in found]
    return Submitters(tuple((name, sid, email) for name, sid, email in said), when)


def _iso(time: str) -> str:
    """Return a time as Ruby writes it in the form that Python reads.

    >>> _iso("2026-11-20 22:59:00.123456000 Z")
    '2026-11-20 22:59:00.123456000+00:00'
    """
    return time.replace(" Z", "+00:00").replace(" UTC", "+00:00")

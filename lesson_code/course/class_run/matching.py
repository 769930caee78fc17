"""Whose a folder or a file is: one line of the roster fits the whole name, or nobody is guessed.

A name is an id or a name of the roster, or an id followed by an exercise, a number or "late", or
what Moodle makes of a name: ``Ada Byron_123_assignsubmission_file``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from lesson_code.course.class_run.names import same_name, visible
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.grading.exercises import exercises

SEPARATORS = "_-. "
"""What stands between a student's id and the rest of a file's name."""

MOODLE_MARK = "_assignsubmission_"

MOODLE = re.compile(
    rf"(?P<person>.+)_(?P<number>\d+){MOODLE_MARK}[a-z]+(_.*)?", re.DOTALL | re.IGNORECASE
)
"""A folder or a file as Moodle names it: full name, participant's number, kind, file."""


@dataclass(frozen=True)
class Owner:
    """Whose an entry is; `unmatched` says why it is nobody's of the roster."""

    id: str
    unmatched: str = ""


def owners(names: Sequence[str], roster: Sequence[Enrolled] | None) -> list[Owner]:
    """Return the owner of each name.

    Without a roster a student is what the name says: all of it but an exercise at its end, and
    with Moodle's number, which tells two students of one name apart. With a roster, a name that
    no line fits, or more than one, keeps all of it as its id. So do the folders of students whom
    Moodle numbers differently, where the same line fits them.
    """
    if roster is None:
        return [Owner(_by_itself(name)) for name in names]
    lines = _Lines(roster)
    fitting = [lines.fitting(name) for name in names]
    numbers: dict[str, set[str]] = {}
    for name, ids in zip(names, fitting, strict=True):
        if len(ids) == 1 and (number := lines.moodle_number(name)):
            numbers.setdefault(ids[0], set()).add(number)
    return [
        _owner(
            name, ids, numbers.get(ids[0], set()) if ids and lines.moodle_number(name) else set()
        )
        for name, ids in zip(names, fitting, strict=True)
    ]


def _owner(name: str, ids: Sequence[str], numbers: set[str]) -> Owner:
    """Return the owner of a name, from the lines that fit and Moodle's numbers at its line."""
    if not ids:
        return Owner(name, "fits no line of the roster")
    listed = ", ".join(map(visible, ids))
    if len(ids) > 1:
        return Owner(name, f"fits {len(ids)} lines of the roster ({listed})")
    if len(numbers) > 1:
        told = ", ".join(sorted(numbers))
        return Owner(name, f"fits the line {listed}, as another student's does (numbers {told})")
    return Owner(ids[0])


class _Lines:
    """The lines of a roster, found by id and by name."""

    def __init__(self, roster: Sequence[Enrolled]) -> None:
        self._by_id = {same_name(student.id): student.id for student in roster}
        self._by_name: dict[str, list[str]] = {}
        for student in roster:
            if student.name.strip():
                self._by_name.setdefault(same_name(student.name), []).append(student.id)

    def fitting(self, name: str) -> list[str]:
        """Return the ids of the lines that fit a name."""
        written = same_name(name)
        if written in self._by_id:
            return [self._by_id[written]]
        if MOODLE_MARK in written:
            person = same_name(moodle["person"]) if (moodle := _moodle(name)) else ""
            by_id = [self._by_id[person]] if person in self._by_id else []
            return sorted({*by_id, *self._by_name.get(person, ())})
        if written in self._by_name:
            return self._by_name[written]
        ends = (place for place, letter in enumerate(written) if letter in SEPARATORS)
        return [
            self._by_id[written[:end]]
            for end in ends
            if written[:end] in self._by_id and _names_no_person(written[end:])
        ]

    def moodle_number(self, name: str) -> str:
        """Return the number that Moodle gives a student, where the name is not an id itself."""
        moodle = None if same_name(name) in self._by_id else _moodle(name)
        return moodle["number"] if moodle else ""


def _moodle(name: str) -> re.Match[str] | None:
    """Return the parts of a name that Moodle made.

    Where its mark stands twice, a student wrote one of them, and all before the last is the person:
    that is nobody's name, so a made-up name or file leads to no other student.
    """
    return MOODLE.fullmatch(name)


def _names_no_person(rest: str) -> bool:
    """Return whether what follows an id says an exercise, a number or "late", and no other name."""
    known = "|".join(re.escape(exercise.name.casefold()) for exercise in exercises())
    gap = f"[{re.escape(SEPARATORS)}]"
    return bool(re.fullmatch(rf"{gap}*((\(?\d+\)?|late|{known})({gap}.*)?)?", rest, re.DOTALL))


def _by_itself(name: str) -> str:
    """Return the student that a name says where there is no roster."""
    if moodle := _moodle(name):
        return f"{moodle['person']}_{moodle['number']}"
    for exercise in exercises():
        rest = name.removesuffix(exercise.name).rstrip(SEPARATORS)
        if rest and len(rest) < len(name) - len(exercise.name):
            return rest
    return name

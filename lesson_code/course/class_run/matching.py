"""Whose a folder or a file is: one line of the roster fits the whole name, or nobody is guessed.

A name is an id or a name of the roster, with either name first, or an id followed by an exercise, a
number or "late", or what Canvas or Moodle makes of a name; of a folder of Gradescope's, its list
says whose it is.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from lesson_code.course.class_run.downloads import (
    MOODLE_MARK,
    Named,
    Submitters,
    canvas_forms,
    moodle_form,
    named,
)
from lesson_code.course.class_run.names import same_name, visible
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.grading.exercises import exercises

SEPARATORS = "_-. "
"""What stands between a student's id and the rest of a file's name."""


@dataclass(frozen=True)
class Owner:
    """Whose an entry is; `unmatched` says why it is nobody's of the roster.

    `listed` is what a download says of a student whom no roster names.
    """

    id: str
    unmatched: str = ""
    listed: Enrolled | None = None


def owners(
    names: Sequence[str],
    roster: Sequence[Enrolled] | None,
    submitters: Mapping[str, Submitters] | None = None,
) -> list[list[Owner]]:
    """Return the owners of each name: more than one only of what Gradescope lists for a group.

    Without a roster a student is what the name says: all of it but an exercise at its end, and
    with the number of the course system, which tells two students of one name apart. With a
    roster, a name that no line fits, or more than one, keeps all of it as its id. So do the files
    of students to whom the course system gives different numbers, where the same line fits them.
    """
    listed = {name: its for name, its in (submitters or {}).items() if its.students}
    if roster is None:
        return [
            _listed_by_itself(name, listed[name]) if name in listed else [_by_itself(name)]
            for name in names
        ]
    lines = _Lines(roster)
    fitting = [[] if name in listed else lines.fitting(name) for name in names]
    numbers: dict[str, set[str]] = {}
    for name, ids in zip(names, fitting, strict=True):
        if len(ids) == 1 and (number := lines.number(name)):
            numbers.setdefault(ids[0], set()).add(number)
    found: list[list[Owner]] = []
    for name, ids in zip(names, fitting, strict=True):
        if name in listed:
            found.append(_submitting(name, listed[name], lines))
        else:
            same_line = numbers.get(ids[0], set()) if ids and lines.number(name) else set()
            found.append([_owner(name, ids, same_line)])
    return found


def _submitting(name: str, submitters: Submitters, lines: _Lines) -> list[Owner]:
    """Return the owners of a folder of Gradescope's; who fits no line is called by both names."""
    is_group = len(submitters.students) > 1
    return [
        _owner(f"{name}, {one[0]}" if is_group else name, lines.submitting(*one), set())
        for one in submitters.students
    ]


def _owner(name: str, ids: Sequence[str], numbers: set[str]) -> Owner:
    """Return the owner of a name, from the lines that fit and the numbers at its line."""
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
    """The lines of a roster, found by id, by name, by the numbers of course systems."""

    def __init__(self, roster: Sequence[Enrolled]) -> None:
        self._by_id = {same_name(student.id): student.id for student in roster}
        self._also: dict[str, list[str]] = {}
        self._by_name: dict[str, list[str]] = {}
        self._by_form: dict[str, list[str]] = {}
        self._by_moodle: dict[str, list[str]] = {}
        for student in roster:
            for other in student.also:
                self._also.setdefault(same_name(other), []).append(student.id)
            for name in _both_orders(student.name):
                self._by_name.setdefault(same_name(name), []).append(student.id)
                teamed = f"{student.team}-{name}" if student.team else name
                for form in {moodle_form(name), moodle_form(teamed)}:
                    self._by_moodle.setdefault(same_name(form), []).append(student.id)
            for form in canvas_forms(student.name):
                self._by_form.setdefault(same_name(form), []).append(student.id)
        self._by_number = {
            (system, number): student.id
            for student in roster
            for system, number in (("canvas", student.canvas), ("moodle", student.moodle))
            if number
        }
        self._numbering = {system for system, _ in self._by_number}

    def fitting(self, name: str) -> list[str]:
        """Return the ids of the lines that fit a name."""
        written = same_name(name)
        if written in self._by_id:
            return [self._by_id[written]]
        made = named(name)
        if made and made.system in self._numbering:
            found = self._by_number.get((made.system, made.number))
            return [found] if found else []
        if MOODLE_MARK in written:
            return self._of_moodle(made) if made else []
        if found_by := self._also.get(written) or self._by_name.get(written) or self._turned(name):
            return found_by
        ends = (place for place, letter in enumerate(written) if letter in SEPARATORS)
        begins = [
            self._by_id[written[:end]]
            for end in ends
            if written[:end] in self._by_id and _names_no_person(written[end:])
        ]
        return begins or (self._by_form.get(same_name(made.person), []) if made else [])

    def _turned(self, name: str) -> list[str]:
        """Return the ids of the lines that fit a name whose last name comes first, with a comma."""
        forms = map(same_name, _both_orders(name))
        return sorted({found for form in forms for found in self._by_name.get(form, ())})

    def submitting(self, name: str, number: str, email: str) -> list[str]:
        """Return the ids of the lines that fit a student of Gradescope's list."""
        for said in (number, email):
            written = same_name(said)
            if written in self._by_id:
                return [self._by_id[written]]
            if written in self._also:
                return self._also[written]
        return self._by_name.get(same_name(name), [])

    def number(self, name: str) -> str:
        """Return the number that a course system gives, where the name is not an id itself."""
        made = None if same_name(name) in self._by_id else named(name)
        return made.number if made else ""

    def _of_moodle(self, made: Named) -> list[str]:
        """Return the ids of the lines that fit a name that Moodle made."""
        person = same_name(made.person)
        by_id = [self._by_id[person]] if person in self._by_id else []
        return sorted({*by_id, *self._by_moodle.get(person, ())})


def _both_orders(name: str) -> set[str]:
    """Return a name as it is written, and with the first name first.

    >>> sorted(_both_orders("Byron, Ada"))
    ['Ada Byron', 'Byron, Ada']

    Either of two commas may stand before the first name.

    >>> sorted(_both_orders("Comma, Jr., Sam"))
    ['Comma, Jr., Sam', 'Jr., Sam Comma', 'Sam Comma, Jr.']
    """
    parted = (name.partition(", "), name.rpartition(", "))
    turned = {f"{first} {last}" for last, _, first in parted if first and last}
    return set(filter(str.strip, {name, *turned}))


def _names_no_person(rest: str) -> bool:
    """Return whether what follows an id says an exercise, a number or "late", and no other name."""
    known = "|".join(re.escape(exercise.name.casefold()) for exercise in exercises())
    gap = f"[{re.escape(SEPARATORS)}]"
    return bool(re.fullmatch(rf"{gap}*((\(?\d+\)?|late|{known})({gap}.*)?)?", rest, re.DOTALL))


def _listed_by_itself(folder: str, submitters: Submitters) -> list[Owner]:
    """Return the students that Gradescope lists for a folder, where there is no roster."""
    return [
        Owner(id_, listed=Enrolled(id_, name, email, also=(email,) if email else ()))
        for name, number, email in submitters.students
        for id_ in [number or email or name or folder]
    ]


def _by_itself(name: str) -> Owner:
    """Return the student that a name says where there is no roster."""
    if made := named(name):
        id_ = f"{made.person}_{made.number}"
        canvas, moodle = ("", made.number) if made.system == "moodle" else (made.number, "")
        return Owner(id_, listed=Enrolled(id_, made.person, canvas=canvas, moodle=moodle))
    for exercise in exercises():
        rest = name.removesuffix(exercise.name).rstrip(SEPARATORS)
        if rest and len(rest) < len(name) - len(exercise.name):
            return Owner(rest)
    return Owner(name)

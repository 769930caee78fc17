"""What counts of what one student handed in: the newest file for each exercise, and how late."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from lesson_code.course.class_run.changes import Changes, exact, hundredths, number
from lesson_code.course.class_run.collect import HandIn, Paper, listed
from lesson_code.course.class_run.journal import Marks, key_of
from lesson_code.course.class_run.names import visible
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.task import Task

MINUTES_A_DAY = 1440

MOST_COMPARED = 100
"""Functions of a file that are compared with others'; a chapter's answers have 5 to 20."""


@dataclass(frozen=True)
class Student:
    """A student's marks: one report for each exercise that was handed in and counts.

    `label` is the id as it can be shown, `stem` the beginning of the names of the student's files;
    no two students of a gradebook share either. `papers` are the files that the reports are of, and
    `comments` what the instructor says of all that was handed in.
    """

    hand_in: HandIn
    reports: Mapping[str, Marks]
    papers: Mapping[str, Paper]
    problems: tuple[str, ...]
    notes: tuple[str, ...]
    late: tuple[str, ...] = ()
    comments: tuple[str, ...] = ()
    label: str = ""
    stem: str = ""

    @property
    def id(self) -> str:
        """What the student is called in the roster or by the folder."""
        return self.hand_in.student.id

    @property
    def points(self) -> int | float:
        """The points earned in all exercises."""
        return number(sum((exact(report["points"]) for report in self.reports.values()), exact(0)))

    @property
    def status(self) -> str:
        """In a word or two whether there are marks, and whether all is well."""
        if not self.reports:
            return "missing" if self.hand_in.is_missing else "not gradable"
        return "late" if self.late else "graded"

    def of_task(self, exercise: Exercise, task: Task) -> dict[str, Any] | None:
        """Return what the report says of a task; None if the exercise was not handed in."""
        if exercise.name not in self.reports:
            return None
        tasks: list[dict[str, Any]] = self.reports[exercise.name]["tasks"]
        return next((entry for entry in tasks if entry["task"] == task.id), None)


def counted(hand_in: HandIn, marks: Mapping[str, Marks]) -> Student:
    """Return what of a student's files counts, before anything is weighed or taken off."""
    found = [(p, marks.get(key_of(p), {"problem": "has not been graded"})) for p in hand_in.papers]
    answers: dict[str, list[tuple[Paper, Marks]]] = {}
    for paper, report in found:
        if "problem" not in report:
            answers.setdefault(report["exercise"], []).append((paper, report))
    problems, notes = list(hand_in.problems), list(hand_in.notes)
    counting = {
        name: newest
        for name in sorted(answers)
        if (newest := _newest(name, answers[name], problems, notes))
    }
    for paper, report in found:
        if "problem" in report and report.get("is_other") and counting:
            notes.append(f"{visible(paper.name)}: left out, it answers no exercise")
        elif "problem" in report:
            problems.append(f"{visible(paper.name)}: {report['problem']}")
    notes += [
        f"{visible(paper.name)}: only its {MOST_COMPARED} longest functions are compared"
        for paper, report in counting.values()
        if len(report.get("passages", ())) == MOST_COMPARED
    ]
    return Student(
        hand_in,
        {name: report for name, (_, report) in counting.items()},
        {name: paper for name, (paper, _) in counting.items()},
        tuple(problems),
        tuple(notes),
    )


def _newest(
    exercise: str, answers: list[tuple[Paper, Marks]], problems: list[str], notes: list[str]
) -> tuple[Paper, Marks] | None:
    """Return the file that counts for an exercise, with its marks, and name the others.

    That is the one that was changed last, to the second: more files are no more attempts. Files
    that only may be answers, since nothing in them tells, give way to one that is. Two different
    files that were changed last in the same second leave open which is meant: neither counts.
    """
    sure = [answer for answer in answers if not answer[1].get("is_assumed")]
    for paper, report in answers:
        if sure and report.get("is_assumed"):
            why = "; ".join(report["notes"])
            said = problems if why else notes
            said.append(f"{visible(paper.name)}: {why or 'left out, it answers no exercise'}")
    ranked = sorted(sure or answers, key=lambda answer: answer[0].age, reverse=True)
    last = [answer for answer in ranked if answer[0].age == ranked[0][0].age]
    names = [visible(paper.name) for paper, _ in ranked]
    if len({paper.digest for paper, _ in last}) > 1:
        tied = listed(names[: len(last)])
        older = f"; older: {listed(names[len(last) :])}" if names[len(last) :] else ""
        problems.append(
            f"{exercise}: no file counts, since {len(last)} were changed last in the same second: "
            f"{tied}{older}; keep the one that is meant"
        )
        return None
    if len(ranked) > 1:
        notes.append(f"{exercise}: {names[0]} counts, the newest; left out: {listed(names[1:])}")
    return ranked[0]


def lateness(
    student: Student, exercise: Exercise, full: int | float, changes: Changes, due: datetime | None
) -> tuple[str, int | float]:
    """Return in a line how late a student's file is, and what that takes off; ("", 0) if it is not.

    Parameters
    ----------
    student : Student
        Has a file that counts for the exercise.
    exercise : Exercise
        What was handed in.
    full : int or float
        The full mark of the exercise.
    changes : Changes
        Times of its own, and the percent that a day takes off.
    due : datetime, optional
        Until when all may hand in, unless the changes say otherwise.
    """
    paper, enrolled = student.papers[exercise.name], student.hand_in.student
    limit, percent = changes.due(enrolled, exercise, due), changes.late(enrolled, exercise)
    name = visible(paper.name)
    if paper.handed_in is None:
        unknown = "; nothing is taken off, since the name does not say how late" if percent else ""
        return (f"{name}: late, as its name says{unknown}", 0) if paper.is_late else ("", 0)
    if limit is None or paper.handed_in <= limit:
        return "", 0
    seconds = (paper.handed_in - limit).total_seconds()
    begun = -int(-seconds // (MINUTES_A_DAY * 60))
    off = number(hundredths(min(exact(full), exact(full) * percent * begun / 100)))
    taken = f"; {off} points are taken off" if off else ""
    return f"{name}: {_time(int(seconds // 60))} late{taken}", off


def _time(minutes: int) -> str:
    """Return a time in days, hours and minutes, without those that are none.

    >>> _time(31), _time(1440 + 5), _time(0)
    ('31 min', '1 d 5 min', '0 min')
    """
    parts = ((minutes // MINUTES_A_DAY, "d"), (minutes % MINUTES_A_DAY // 60, "h"))
    said = [f"{number} {unit}" for number, unit in (*parts, (minutes % 60, "min")) if number]
    return " ".join(said) or "0 min"

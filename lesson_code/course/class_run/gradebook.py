"""The marks of a class: each student's, and what the class as a whole has not understood."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from typing import Any

from lesson_code.course.class_run.collect import HandIn, Paper
from lesson_code.course.class_run.journal import Marks, key_of
from lesson_code.course.class_run.names import shown
from lesson_code.course.grading import exercises as course
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.feedback import NOT_WRITTEN
from lesson_code.course.grading.task import Task


@dataclass(frozen=True)
class Student:
    """A student's marks: one report for each exercise that was handed in."""

    hand_in: HandIn
    reports: Mapping[str, Marks]
    problems: tuple[str, ...]
    notes: tuple[str, ...]
    late: tuple[str, ...]

    @property
    def id(self) -> str:
        """What the student is called in the roster or by the folder."""
        return self.hand_in.student.id

    @property
    def points(self) -> int:
        """The points earned in all exercises."""
        return sum(report["points"] for report in self.reports.values())

    @property
    def status(self) -> str:
        """In a word or two whether there are marks, and whether all is well."""
        if self.hand_in.is_missing:
            return "missing"
        if not self.reports:
            return "not gradable"
        return "late" if self.late else "graded"

    def of_task(self, exercise: Exercise, task: Task) -> dict[str, Any] | None:
        """Return what the report says of a task; None if the exercise was not handed in."""
        if exercise.name not in self.reports:
            return None
        tasks: list[dict[str, Any]] = self.reports[exercise.name]["tasks"]
        return next((entry for entry in tasks if entry["task"] == task.id), None)


@dataclass(frozen=True)
class Misconception:
    """A wrong model that was recognised, and with how many students."""

    name: str
    says: str
    hint: str
    students: int


@dataclass(frozen=True)
class TaskSummary:
    """How a class did in a task. `handed_in` counts the students who handed in its exercise."""

    exercise: Exercise
    task: Task
    handed_in: int
    full: int
    not_written: int
    points: int
    failed: tuple[tuple[str, int], ...]
    misconceptions: tuple[Misconception, ...]

    @property
    def mean(self) -> float:
        """Points a student who handed in the exercise."""
        return self.points / self.handed_in if self.handed_in else 0.0


@dataclass(frozen=True)
class Gradebook:
    """A class: its students in the order of their ids, and what they were graded on."""

    students: tuple[Student, ...]
    exercises: tuple[Exercise, ...]
    seed: int
    due: datetime | None = None

    @property
    def full_points(self) -> int:
        """The full mark: of every exercise that is graded."""
        return sum(exercise.points for exercise in self.exercises)

    def with_status(self, status: str) -> list[Student]:
        """Return the students with a status."""
        return [student for student in self.students if student.status == status]

    @property
    def is_complete(self) -> bool:
        """Whether every file that was handed in has marks."""
        return not any(student.problems for student in self.students)

    @cached_property
    def isolation(self) -> list[Any]:
        """The kinds of isolation the files were graded in, each described once."""
        said: list[Any] = []
        for student in self.students:
            for report in student.reports.values():
                if report["isolation"] not in said:
                    said.append(report["isolation"])
        return said

    @cached_property
    def summary(self) -> tuple[TaskSummary, ...]:
        """How the class did, task by task."""
        return tuple(
            _summary(self.students, exercise, task)
            for exercise in self.exercises
            for task in exercise.tasks
        )


def gradebook(
    hand_ins: Sequence[HandIn],
    marks: Mapping[str, Marks],
    *,
    exercises: Sequence[str],
    seed: int,
    due: datetime | None = None,
) -> Gradebook:
    """Return the marks of a class, from those of its files.

    Parameters
    ----------
    hand_ins : sequence of HandIn
        What came from whom.
    marks : mapping of str to dict
        The marks of each file, by its key in the journal.
    exercises : sequence of str
        The names of those that count; if there are none, all that anybody handed in.
    seed : int
        What the inputs were drawn with.
    due : datetime, optional
        Files that are newer are late, unless the student has a time of his or her own.
    """
    students = tuple(_student(hand_in, marks, due) for hand_in in hand_ins)
    wanted = set(exercises) or {name for student in students for name in student.reports}
    chosen = tuple(exercise for exercise in course.exercises() if exercise.name in wanted)
    return Gradebook(students, chosen, seed, due)


def _student(hand_in: HandIn, marks: Mapping[str, Marks], due: datetime | None) -> Student:
    """Return one student's marks; of two files for one exercise the better counts."""
    found = [(p, marks.get(key_of(p), {"problem": "has not been graded"})) for p in hand_in.papers]
    reports: dict[str, Marks] = {}
    notes: list[str] = []
    for report in (report for _, report in found if "problem" not in report):
        before = reports.setdefault(report["exercise"], report)
        if before is not report:
            better = max(before, report, key=lambda one: int(one["points"]))
            reports[report["exercise"]] = better
            notes.append(f"{report['exercise']} came more than once; the better file counts")
    problems = list(hand_in.problems)
    for paper, report in found:
        if "problem" in report and report.get("is_other") and reports:
            notes.append(f"{shown(paper.name)}: left out, it answers no exercise")
        elif "problem" in report:
            problems.append(f"{shown(paper.name)}: {report['problem']}")
    if not hand_in.on_roster:
        notes.append("not on the roster")
    limit = hand_in.student.due or due
    late = tuple(
        _late(paper, limit) for paper in hand_in.papers if limit and _is_late(paper, limit)
    )
    ordered = {name: reports[name] for name in sorted(reports)}
    return Student(hand_in, ordered, tuple(problems), tuple(dict.fromkeys(notes)), late)


def _is_late(paper: Paper, limit: datetime) -> bool:
    """Return whether a file was changed after the time by which it was due."""
    return paper.handed_in > limit


def _late(paper: Paper, limit: datetime) -> str:
    """Return in a line how late a file is."""
    minutes = int((paper.handed_in - limit).total_seconds() // 60)
    days, hours = minutes // 1440, minutes % 1440 // 60
    return f"{shown(paper.name)}: {days} d {hours} h {minutes % 60} min late"


def _summary(students: Sequence[Student], exercise: Exercise, task: Task) -> TaskSummary:
    """Return how a class did in one task."""
    entries = [entry for student in students if (entry := student.of_task(exercise, task))]
    failed = Counter(
        criterion["name"]
        for entry in entries
        for criterion in entry["criteria"]
        if criterion["points"] < criterion["full_points"] and not _is_not_written(entry)
    )
    models = Counter(entry["wrong_model"]["name"] for entry in entries if entry["wrong_model"])
    return TaskSummary(
        exercise,
        task,
        handed_in=len(entries),
        full=sum(entry["points"] == entry["full_points"] for entry in entries),
        not_written=sum(map(_is_not_written, entries)),
        points=sum(entry["points"] for entry in entries),
        failed=tuple(sorted(failed.items(), key=lambda item: (-item[1], item[0]))),
        misconceptions=tuple(
            Misconception(model.name, model.misconception, model.hint, models[model.name])
            for model in sorted(task.wrong_models, key=lambda m: (-models[m.name], m.name))
            if models[model.name]
        ),
    )


def _is_not_written(entry: Mapping[str, Any]) -> bool:
    """Return whether an answer is still the stub."""
    return all(criterion["message"] == NOT_WRITTEN for criterion in entry["criteria"])

"""The marks of a class: each student's, as the instructor weighs and changes them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from functools import cached_property
from typing import Any

from lesson_code.course.class_run.alike import Alike, alike_in
from lesson_code.course.class_run.changes import (
    Changes,
    exact,
    full_points,
    full_points_of_task,
    hundredths,
    number,
    weighed,
)
from lesson_code.course.class_run.collect import HandIn
from lesson_code.course.class_run.journal import Marks
from lesson_code.course.class_run.names import file_stem, told_apart, visible
from lesson_code.course.class_run.roster import Roster
from lesson_code.course.class_run.student import Student, counted, lateness
from lesson_code.course.class_run.summary import TaskSummary, summary_of
from lesson_code.course.grading import exercises as course
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.task import Task

FEWEST = 2
SHARE = 0.1
"""Where nobody says which exercises count, those do to which there are so many files, and such a
share of as many as have marks: a stray file adds nothing to the full mark, nor do a few in a
hundred.
"""


@dataclass(frozen=True)
class Gradebook:
    """A class: its students in the order of their ids, and what they were graded on."""

    students: tuple[Student, ...]
    exercises: tuple[Exercise, ...]
    seed: int
    due: datetime | None = None
    left_out: tuple[str, ...] = ()
    changes: Changes = field(default_factory=Changes)
    roster: Roster | None = None
    is_variant: bool = False

    @cached_property
    def full_points(self) -> int | float:
        """The full mark: of every exercise that is graded."""
        return number(sum((exact(self.full_of(e)) for e in self.exercises), exact(0)))

    def full_of(self, exercise: Exercise) -> int | float:
        """Return the full mark of an exercise, as it is weighed."""
        return number(full_points(exercise, self.changes))

    def full_of_task(self, exercise: Exercise, task: Task) -> int | float:
        """Return the full mark of a task, as it is weighed."""
        return number(full_points_of_task(task, exercise, self.changes))

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
                if report["isolation"] not in (None, *said):
                    said.append(report["isolation"])
        return said

    @cached_property
    def summary(self) -> tuple[TaskSummary, ...]:
        """How the class did, task by task."""
        return tuple(
            summary_of(self.students, exercise, task, self.full_of_task(exercise, task))
            for exercise in self.exercises
            for task in exercise.tasks
        )

    @cached_property
    def alike(self) -> tuple[Alike, ...]:
        """What of the answers is alike, or like the lesson; no mark depends on it."""
        return alike_in(self.students, self.exercises)


def gradebook(
    hand_ins: Sequence[HandIn],
    marks: Mapping[str, Marks],
    *,
    exercises: Sequence[str],
    seed: int,
    due: datetime | None = None,
    left_out: tuple[str, ...] = (),
    changes: Changes | None = None,
    roster: Roster | None = None,
    is_variant: bool = False,
) -> Gradebook:
    """Return the marks of a class, from those of its files.

    Of a student's files for one exercise the newest counts (:func:`.student.counted`).

    Parameters
    ----------
    hand_ins : sequence of HandIn
        What came from whom.
    marks : mapping of str to dict
        The marks of each file, by its key in the journal.
    exercises : sequence of str
        The names of those that count; if there are none, those of :func:`common_exercises`.
    seed : int
        What the inputs were drawn with.
    due : datetime, optional
        Files that are newer are late, unless the student has a time of his or her own.
    left_out : tuple of str
        What of the class's folder is nobody's.
    changes : Changes, optional
        What the instructor changed.
    roster : Roster, optional
        The class, for files that a course system imports.
    is_variant : bool
        Whether each student's inputs were drawn with a seed of their own.
    """
    changed = changes or Changes()
    students = [counted(hand_in, marks) for hand_in in hand_ins]
    wanted = set(exercises) or common_exercises(map(_files_of, students))
    chosen = tuple(
        exercise
        for exercise in course.exercises()
        if exercise.name in wanted and changed.weight(exercise)
    )
    ids = [student.id for student in students]
    labels, stems = told_apart(ids, visible), told_apart(ids, file_stem)
    files = _file_counts(map(_files_of, students))
    return Gradebook(
        tuple(
            replace(
                _settled(_without_strays(student, wanted, files), chosen, changed, due),
                label=labels[student.id],
                stem=stems[student.id],
            )
            for student in students
        ),
        chosen,
        seed,
        due,
        left_out,
        changed,
        roster,
        is_variant,
    )


def _files_of(student: Student) -> dict[str, str]:
    """Return the file that counts for each exercise of a student."""
    return {name: paper.name for name, paper in student.papers.items()}


def common_exercises(handed_in: Iterable[Mapping[str, str]]) -> set[str]:
    """Return the exercises that count where nobody says which: those that a class has in common.

    An exercise counts if there are at least 2 files to it, and a tenth as many as students with
    marks. A file that a group shares is one, and so are students who share all. In a class where no
    two files are to the same exercise, all count.

    Parameters
    ----------
    handed_in : iterable of mappings of str to str
        The files of each student, by exercise.

    Examples
    --------
    >>> ada, group = {"01": "ada.py"}, {"02": "group.py"}
    >>> common_exercises([ada, {"01": "bob.py"}, group, group])
    {'01'}
    >>> sorted(common_exercises([ada, group, group]))
    ['01', '02']
    """
    each = [files for files in handed_in if files]
    sharing = {frozenset(files.items()) for files in each}
    counts = _file_counts(each)
    common = {n for n, count in counts.items() if count >= max(FEWEST, SHARE * len(sharing))}
    return common or set(counts)


def _file_counts(handed_in: Iterable[Mapping[str, str]]) -> Counter[str]:
    """Return how many files there are to each exercise; one that a group shares is one."""
    return Counter(name for name, _ in {pair for files in handed_in for pair in files.items()})


def _without_strays(student: Student, wanted: set[str], files: Counter[str]) -> Student:
    """Return a student's marks without the exercises that do not count; a problem names each."""
    strays = [report for name, report in student.reports.items() if name not in wanted]
    problems = [
        f"{visible(report['submission'])}: answers {report['exercise']}, which does not count: "
        f"files of the class that answer it: {files[report['exercise']]}; "
        "--exercise says which exercises count"
        for report in strays
    ]
    kept = {name: report for name, report in student.reports.items() if name in wanted}
    return replace(student, reports=kept, problems=(*student.problems, *problems))


def _settled(
    student: Student, exercises: Sequence[Exercise], changes: Changes, due: datetime | None
) -> Student:
    """Return a student's marks as they count: weighed, changed, with lateness taken off."""
    reports: dict[str, Marks] = {}
    late: list[str] = []
    for exercise in exercises:
        report = student.reports.get(exercise.name)
        own = changes.points(student.id, exercise)
        given = {task.id: changes.points(student.id, task) for task in exercise.tasks}
        if report is None and own is None and not any(p is not None for p in given.values()):
            continue
        tasks = [
            _task(_entry(report, task), task, exercise, student.id, changes)
            for task in exercise.tasks
        ]
        full = full_points(exercise, changes)
        earned = sum((exact(entry["points"]) for entry in tasks), exact(0))
        off: int | float = 0
        if own is not None:
            earned = hundredths(own / exercise.points * full)
        elif report is not None:
            line, off = lateness(student, exercise, number(full), changes, due)
            late += [line] if line else []
            earned = max(exact(0), earned - exact(off))
        reports[exercise.name] = (report or _by_hand_alone(exercise)) | {
            "points": number(earned),
            "full_points": number(full),
            "taken_off": off,
            "is_by_hand": own is not None,
            "comments": changes.comments(student.id, exercise),
            "tasks": tasks,
        }
    return replace(
        student,
        reports=reports,
        late=tuple(late),
        comments=tuple(changes.comments(student.id, None)),
    )


def _entry(report: Marks | None, task: Task) -> dict[str, Any] | None:
    """Return what the grader says of a task; None if it was not handed in."""
    entries = report["tasks"] if report else []
    return next((entry for entry in entries if entry["task"] == task.id), None)


def _task(
    entry: dict[str, Any] | None, task: Task, exercise: Exercise, student: str, changes: Changes
) -> dict[str, Any]:
    """Return what a task counts: the grader's points or those given by hand, weighed."""
    given = changes.points(student, task)
    graded = entry or {
        "task": task.id,
        "function": task.function,
        "points": 0,
        "criteria": [],
        "wrong_model": None,
        "diagnoses": [],
    }
    points = exact(graded["points"]) if given is None else given
    return (
        {"lent": ""}
        | graded
        | {
            "points": number(weighed(points, task, exercise, changes)),
            "full_points": number(full_points_of_task(task, exercise, changes)),
            "is_full": points == task.points,
            "is_by_hand": given is not None,
            "comments": changes.comments(student, task),
        }
    )


def _by_hand_alone(exercise: Exercise) -> Marks:
    """Return the report of an exercise for which nothing was handed in that counts."""
    return {"exercise": exercise.name, "submission": None, "isolation": None, "notes": []}

"""The marks of a class: each student's, and what the class as a whole has not understood."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cached_property
from typing import Any

from lesson_code.course.class_run.collect import HandIn, Paper, listed
from lesson_code.course.class_run.journal import Marks, key_of
from lesson_code.course.class_run.names import file_stem, told_apart, visible
from lesson_code.course.grading import exercises as course
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.feedback import NOT_WRITTEN
from lesson_code.course.grading.task import Task

FEWEST = 2
SHARE = 0.1
"""Where nobody says which exercises count, those count that so many students, and such a share of
those with marks, handed in: a stray file adds nothing to the full mark, nor do some in a hundred.
"""


@dataclass(frozen=True)
class Student:
    """A student's marks: one report for each exercise that was handed in and counts.

    `label` is the id as it can be shown, `stem` the beginning of the names of the student's files;
    no two students of a gradebook share either.
    """

    hand_in: HandIn
    reports: Mapping[str, Marks]
    problems: tuple[str, ...]
    notes: tuple[str, ...]
    late: tuple[str, ...]
    label: str = ""
    stem: str = ""

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
    left_out: tuple[str, ...] = ()

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
    left_out: tuple[str, ...] = (),
) -> Gradebook:
    """Return the marks of a class, from those of its files.

    Of a student's files for one exercise the newest counts (:func:`_counting`).

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
    """
    students = [_student(hand_in, marks, due) for hand_in in hand_ins]
    wanted = set(exercises) or common_exercises([student.reports for student in students])
    chosen = tuple(exercise for exercise in course.exercises() if exercise.name in wanted)
    ids = [student.id for student in students]
    labels, stems = told_apart(ids, visible), told_apart(ids, file_stem)
    handed_in = Counter(name for student in students for name in student.reports)
    return Gradebook(
        tuple(
            replace(
                _without_strays(student, wanted, handed_in),
                label=labels[student.id],
                stem=stems[student.id],
            )
            for student in students
        ),
        chosen,
        seed,
        due,
        left_out,
    )


def common_exercises(handed_in: Iterable[Iterable[str]]) -> set[str]:
    """Return the exercises that count where nobody says which: those that a class has in common.

    An exercise counts if at least 2 students, and a tenth of those with marks, handed it in. In a
    class where no two students did the same exercise, all count.

    Parameters
    ----------
    handed_in : iterable of iterables of str
        The exercises of each student.

    Examples
    --------
    >>> sorted(common_exercises([["01"], ["01", "02"]])), sorted(common_exercises([["01", "02"]]))
    (['01'], ['01', '02'])
    """
    each = [names for exercises in handed_in if (names := set(exercises))]
    counts = Counter(name for names in each for name in names)
    common = {n for n, count in counts.items() if count >= max(FEWEST, SHARE * len(each))}
    return common or set(counts)


def _without_strays(student: Student, wanted: set[str], handed_in: Counter[str]) -> Student:
    """Return a student's marks without the exercises that do not count; a problem names each."""
    strays = [report for name, report in student.reports.items() if name not in wanted]
    problems = [
        f"{visible(report['submission'])}: answers {report['exercise']}, which does not count: "
        f"handed in by {handed_in[report['exercise']]} of the class; "
        "--exercise says which exercises count"
        for report in strays
    ]
    kept = {name: report for name, report in student.reports.items() if name in wanted}
    return replace(student, reports=kept, problems=(*student.problems, *problems))


def _student(hand_in: HandIn, marks: Mapping[str, Marks], due: datetime | None) -> Student:
    """Return one student's marks."""
    found = [(p, marks.get(key_of(p), {"problem": "has not been graded"})) for p in hand_in.papers]
    answers: dict[str, list[tuple[Paper, Marks]]] = {}
    for paper, report in found:
        if "problem" not in report:
            answers.setdefault(report["exercise"], []).append((paper, report))
    problems, notes = list(hand_in.problems), list(hand_in.notes)
    reports = {
        name: counted
        for name in sorted(answers)
        if (counted := _counting(name, answers[name], problems, notes))
    }
    for paper, report in found:
        if "problem" in report and report.get("is_other") and reports:
            notes.append(f"{visible(paper.name)}: left out, it answers no exercise")
        elif "problem" in report:
            problems.append(f"{visible(paper.name)}: {report['problem']}")
    limit = hand_in.student.due or due
    late = tuple(
        _late(paper, limit) for paper in hand_in.papers if limit and _is_late(paper, limit)
    )
    return Student(hand_in, reports, tuple(problems), tuple(notes), late)


def _counting(
    exercise: str, answers: list[tuple[Paper, Marks]], problems: list[str], notes: list[str]
) -> Marks | None:
    """Return the marks of the file that counts for an exercise, and name the others.

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
    ranked = sorted(sure or answers, key=lambda answer: answer[0].handed_in, reverse=True)
    last = [answer for answer in ranked if answer[0].handed_in == ranked[0][0].handed_in]
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
    return ranked[0][1]


def _is_late(paper: Paper, limit: datetime) -> bool:
    """Return whether a file was changed after the time by which it was due."""
    return paper.handed_in > limit


def _late(paper: Paper, limit: datetime) -> str:
    """Return in a line how late a file is."""
    minutes = int((paper.handed_in - limit).total_seconds() // 60)
    days, hours = minutes // 1440, minutes % 1440 // 60
    return f"{visible(paper.name)}: {days} d {hours} h {minutes % 60} min late"


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

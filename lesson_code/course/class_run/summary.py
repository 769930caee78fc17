"""What a class has not understood: task by task, who, and answers that show it."""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from lesson_code.course.class_run.changes import exact
from lesson_code.course.class_run.student import Student
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.feedback import NOT_WRITTEN, not_there
from lesson_code.course.grading.task import Task

MOST_ANSWERS = 3
"""Answers that are shown of those that make the same mistake."""

BINS = 10
"""Bars of a spread, of ten percent each."""


@dataclass(frozen=True)
class Misconception:
    """What explains wrong answers, with whom it was recognised, and answers that show it."""

    name: str
    says: str
    hint: str
    who: tuple[Student, ...]
    answers: tuple[str, ...]

    @property
    def students(self) -> int:
        """With how many students it was recognised."""
        return len(self.who)


@dataclass(frozen=True)
class Unexplained:
    """Wrong answers that no model explains: whose, what is not right in them, and some of them."""

    who: tuple[Student, ...]
    failed: tuple[tuple[str, int], ...]
    answers: tuple[str, ...]


@dataclass(frozen=True)
class TaskSummary:
    """How a class did in a task. `handed_in` counts the students who handed in its exercise."""

    exercise: Exercise
    task: Task
    full_points: int | float
    handed_in: int
    full: int
    not_written: int
    points: int | float
    failed: tuple[tuple[str, int], ...]
    misconceptions: tuple[Misconception, ...]
    unexplained: Unexplained

    @property
    def mean(self) -> float:
        """Points a student who handed in the exercise."""
        return float(self.points) / self.handed_in if self.handed_in else 0.0

    @property
    def percent(self) -> float:
        """The mean in percent of the full mark."""
        return percent(self.mean, self.full_points)


@dataclass(frozen=True)
class Spread:
    """How marks are spread, in percent: lowest, quarters, highest, and a count every ten percent.

    The last count includes 100 percent.
    """

    lowest: float
    first_quarter: float
    median: float
    third_quarter: float
    highest: float
    mean: float
    counts: tuple[int, ...]


def percent(points: float, full: float) -> float:
    """Return points in percent of the full mark; 0 where nothing can be earned.

    >>> percent(3, 4), percent(0, 0)
    (75.0, 0.0)
    """
    return 100 * points / full if full else 0.0


def spread_of(percents: Sequence[float]) -> Spread | None:
    """Return how marks are spread; None if there are none.

    >>> spread_of([0, 50, 100]).counts
    (1, 0, 0, 0, 0, 1, 0, 0, 0, 1)
    """
    if not percents:
        return None
    ordered = sorted(percents)
    quarters = statistics.quantiles([*ordered, *ordered[-1:]] if len(ordered) < 2 else ordered,
                                    n=4, method="inclusive")  # fmt: skip
    bins = Counter(min(int(value * BINS / 100), BINS - 1) for value in ordered)
    counts = tuple(bins[n] for n in range(BINS))
    mean = statistics.fmean(ordered)
    return Spread(ordered[0], quarters[0], quarters[1], quarters[2], ordered[-1], mean, counts)


def summary_of(
    students: Sequence[Student], exercise: Exercise, task: Task, full_points: int | float
) -> TaskSummary:
    """Return how a class did in one task; marks given by hand for nothing are left out."""
    found = [
        (student, entry)
        for student in students
        if (entry := student.of_task(exercise, task)) and entry["criteria"]
    ]
    wrong = [(student, entry) for student, entry in found if _is_wrong(entry, task)]
    failed = _failed(entry for _, entry in wrong)
    by_model: dict[str, list[tuple[Student, dict[str, Any]]]] = {}
    said: dict[str, dict[str, str]] = {}
    for student, entry in wrong:
        for found_in in entry["diagnoses"]:
            by_model.setdefault(found_in["name"], []).append((student, entry))
            said.setdefault(found_in["name"], found_in)
    unexplained = [(student, entry) for student, entry in wrong if not entry["diagnoses"]]
    order = sorted(by_model, key=lambda name: (-len(by_model[name]), name))
    return TaskSummary(
        exercise,
        task,
        full_points,
        handed_in=len(found),
        full=sum(entry["is_full"] for _, entry in found),
        not_written=sum(_is_not_written(entry, task) for _, entry in found),
        points=float(sum((exact(entry["points"]) for _, entry in found), exact(0))),
        failed=failed,
        misconceptions=tuple(
            Misconception(
                name,
                said[name]["says"],
                said[name]["hint"],
                who=tuple(student for student, _ in by_model[name]),
                answers=_shown(by_model[name], exercise, task),
            )
            for name in order
        ),
        unexplained=Unexplained(
            tuple(student for student, _ in unexplained),
            _failed(entry for _, entry in unexplained),
            _shown(unexplained, exercise, task),
        ),
    )


def _failed(entries: Iterable[Mapping[str, Any]]) -> tuple[tuple[str, int], ...]:
    """Return the criteria that do not hold and how often, the commonest first."""
    failed = Counter(
        criterion["name"]
        for entry in entries
        for criterion in entry["criteria"]
        if criterion["points"] < criterion["full_points"]
    )
    return tuple(sorted(failed.items(), key=lambda item: (-item[1], item[0])))


def _shown(
    wrong: Sequence[tuple[Student, dict[str, Any]]], exercise: Exercise, task: Task
) -> tuple[str, ...]:
    """Return some answers that differ in more than spaces: the commonest, then the shortest."""
    answers: dict[str, list[str]] = {}
    for student, _ in wrong:
        answer = student.reports[exercise.name].get("answers", {}).get(task.id, "")
        if answer:
            answers.setdefault("".join(answer.split()), []).append(answer)
    ranked = sorted(answers, key=lambda text: (-len(answers[text]), len(text), text))
    return tuple(min(answers[text]) for text in ranked[:MOST_ANSWERS])


def _is_wrong(entry: Mapping[str, Any], task: Task) -> bool:
    """Return whether an answer was written and the grader took points from it."""
    took = any(c["points"] < c["full_points"] for c in entry["criteria"])
    return took and not _is_not_written(entry, task)


def _is_not_written(entry: Mapping[str, Any], task: Task) -> bool:
    """Return whether an answer is still the stub, or its function is not there at all."""
    nothing = NOT_WRITTEN, not_there(task.function)
    return all(criterion["message"] in nothing for criterion in entry["criteria"])

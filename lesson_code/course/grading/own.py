"""A reader's own functions, as they stand in the exercises: for an engine or a program to call.

They run in this very process, with no wall: this is for the reader's own machine.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.grading.in_process import call_here, kept_apart
from lesson_code.course.grading.submission import SubmissionError, read_submission
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.verdict import judge
from lesson_code.course.isolation.inside.answers import load
from lesson_code.course.notebooks.root import find_root

SEED = 0
"""Draws the inputs, so that the same answer always has the same marks here."""


@dataclass
class OwnFunction:
    """The answer to a task, as its reader has written it.

    Attributes
    ----------
    task : Task
        What it answers.
    function : callable or None
        The answer; None while there is none that can be called.
    said : str
        Its marks, with the first thing that is wrong; or why there is none.
    """

    task: Task
    function: Callable[..., Any] | None = field(repr=False)
    said: str

    @property
    def is_own(self) -> bool:
        """Whether the reader's function is called, and not the workbook's in its place."""
        return self.function is not None

    @property
    def line(self) -> str:
        """Whose function it is, and what there is to say of it."""
        return f"{self.task.title:32} {'yours' if self.is_own else 'lent'}: {self.said}"

    def give_up(self, reason: str) -> None:
        """Call it no more, and say why."""
        self.function, self.said = None, reason


def own_functions(task_ids: Iterable[str], root: Path | None = None) -> dict[str, OwnFunction]:
    """Return what a reader has written for some tasks, by the names of the functions.

    Parameters
    ----------
    task_ids : iterable of str
        Numbers of tasks, such as "4.3".
    root : Path, optional
        The workbook; by default the one around the current folder.

    Raises
    ------
    ValueError
        There is no such task.
    """
    wanted = list(task_ids)
    folder = root or find_root()
    found: dict[str, OwnFunction] = {}
    for exercise in exercises():
        tasks = [task for task in exercise.tasks if task.id in wanted]
        if tasks:
            found |= _written_in(exercise, tasks, folder)
    known = {own.task.id: own for own in found.values()}
    if missing := [task for task in wanted if task not in known]:
        raise ValueError(f"task_ids must be numbers of tasks, got {missing[0]!r}")
    return {known[task].task.function: known[task] for task in wanted}


def _written_in(exercise: Exercise, tasks: Iterable[Task], root: Path) -> dict[str, OwnFunction]:
    """Return the answers that a reader's copy of an exercise holds."""
    try:
        names = _names_in(exercise.student_copy(root))
    except SubmissionError as error:
        return {task.function: OwnFunction(task, None, str(error)) for task in tasks}
    return {task.function: _judged(task, names) for task in tasks}


def _names_in(path: Path) -> dict[str, Any]:
    """Return what the names in a reader's file mean; a cell that fails gives none."""
    names: dict[str, Any] = {"__name__": path.stem}
    with kept_apart():
        for _ in load([unit.as_request() for unit in read_submission(path).units], names):
            pass
    return names


def _judged(task: Task, names: dict[str, Any]) -> OwnFunction:
    """Return an answer with its marks."""
    verdict = judge(task, partial(call_here, names), SEED)
    marks, *reasons = verdict.lines
    said = marks.removeprefix(f"{task.title}: ")
    if marks.endswith(")"):  # not written yet
        return OwnFunction(task, None, said.partition("(")[2].rstrip(")"))
    wrong = next((line.strip() for line in reasons if not line.startswith("  right:")), "")
    return OwnFunction(task, names.get(task.function), f"{said}. {wrong}" if wrong else said)

"""The exercises of the course: which tasks each holds, and where its solution stands."""

from __future__ import annotations

import inspect
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path

from lesson_code.course.chapters import Chapter, chapters_with, is_part
from lesson_code.course.grading.submission import Submission
from lesson_code.course.grading.task import Alternative, KnownAnswer, Task, WrongModel

KNOWN_ANSWERS: dict[str, type[KnownAnswer]] = {
    "wrong_answers": WrongModel,
    "right_answers": Alternative,
}
"""The modules of a chapter that mark answers, with their parts, and what each marks."""


def marks_answers(name: str) -> bool:
    """Return whether a module of a chapter marks answers: by its name."""
    return any(is_part(name, start) for start in KNOWN_ANSWERS)


@dataclass(frozen=True)
class Exercise:
    """A file a student works through: its name, title and tasks."""

    chapter: Chapter

    @property
    def name(self) -> str:
        """Name of the file, without its suffix."""
        return self.chapter.name

    @property
    def title(self) -> str:
        """What it is about, in a few words."""
        return self.chapter.title

    @property
    def suffix(self) -> str:
        """A chapter's exercise is a notebook, a program's a program."""
        return ".ipynb" if self.chapter.number else ".py"

    @property
    def file_name(self) -> str:
        """Name of the file, with its suffix."""
        return f"{self.name}{self.suffix}"

    @cached_property
    def tasks(self) -> tuple[Task, ...]:
        """The functions to write, each with the answers that the chapter marks for it."""
        return tuple(map(self._with_known_answers, self.chapter.module("tasks").TASKS))

    @cached_property
    def known_answers(self) -> tuple[KnownAnswer, ...]:
        """The answers that the chapter marks, wrong and right, in the order of their modules."""
        return tuple(
            mark
            for start, kind in KNOWN_ANSWERS.items()
            for module in self.chapter.modules(start)
            for mark in vars(module).values()
            if isinstance(mark, kind)
        )

    def _with_known_answers(self, task: Task) -> Task:
        """Return a task with its answers; practice checks, which bring their own, as they are."""
        if task.wrong_models:
            return task
        known = [mark for mark in self.known_answers if mark.task == task.id]
        return replace(
            task,
            wrong_models=tuple(mark for mark in known if isinstance(mark, WrongModel)),
            alternatives=tuple(mark for mark in known if isinstance(mark, Alternative)),
            parameters=tuple(inspect.signature(known[0].function).parameters) if known else (),
        )

    @property
    def points(self) -> int:
        """The full mark."""
        return sum(task.points for task in self.tasks)

    @property
    def task_ids(self) -> dict[str, str]:
        """The task of each function to write."""
        return {task.function: task.id for task in self.tasks}

    def solution(self, root: Path) -> Path:
        """Return where the solution stands in a workbook."""
        return root / "solutions" / self.file_name

    def student_copy(self, root: Path) -> Path:
        """Return where the student's copy stands in a workbook."""
        return root / "exercises" / self.file_name


@cache
def exercises() -> tuple[Exercise, ...]:
    """Return the exercises of the course: one for each chapter that has tasks."""
    return tuple(map(Exercise, chapters_with("tasks.py")))


def task_by_id(task_id: str) -> Task:
    """Return a task of the course by its number.

    Raises
    ------
    ValueError
        There is no such task.
    """
    for exercise in exercises():
        for task in exercise.tasks:
            if task.id == task_id:
                return task
    known = ", ".join(task.id for exercise in exercises() for task in exercise.tasks)
    raise ValueError(f"task must be one of {known}, got {task_id!r}")


def exercise_by_name(name: str) -> Exercise:
    """Return an exercise by its name, or by the beginning of its name, such as its number.

    Raises
    ------
    ValueError
        No exercise has such a name, or more than one has.
    """
    found = [exercise for exercise in exercises() if exercise.name.startswith(name)]
    if len(found) != 1 or not name:
        known = ", ".join(exercise.name for exercise in exercises())
        raise ValueError(f"exercise must be one of {known}, got {name!r}")
    return found[0]


def exercise_of(submission: Submission) -> Exercise:
    """Return which exercise a submission answers.

    The notebook says so itself; failing that, its file name or its functions tell.

    Raises
    ------
    ValueError
        Nothing in the submission tells.
    """
    names = {exercise.name: exercise for exercise in exercises()}
    if submission.exercise in names:
        return names[submission.exercise]
    if submission.path.stem in names:
        return names[submission.path.stem]
    defined = set(submission.functions)
    ranked = sorted(exercises(), key=lambda exercise: -len(defined & set(exercise.task_ids)))
    if not defined & set(ranked[0].task_ids):
        raise ValueError(
            f"{submission.path}: neither its name nor its functions tell which exercise it is; "
            f"say it with --exercise"
        )
    return ranked[0]

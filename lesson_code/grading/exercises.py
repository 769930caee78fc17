"""The exercises of the course: which tasks each holds, and where its solution stands."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from lesson_code.grading.submission import Submission
from lesson_code.grading.task import Task
from lesson_code.grading.tasks import (
    asteroids,
    billiards,
    breakout,
    circles,
    cradle,
    dominoes,
    effects,
    hard_cases,
    one_dimension,
    pool,
    reflection,
    restitution,
    separating_axes,
    small_engine,
    soft_body,
    spin_and_friction,
    time_of_impact,
    what_accuracy_costs,
)


@dataclass(frozen=True)
class Exercise:
    """A file a student works through: its name, title and tasks."""

    name: str
    title: str
    tasks: tuple[Task, ...]
    suffix: str = ".ipynb"

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
        return root / "solutions" / f"{self.name}{self.suffix}"

    def student_copy(self, root: Path) -> Path:
        """Return where the student's copy stands in a workbook."""
        return root / "exercises" / f"{self.name}{self.suffix}"


EXERCISES = (
    Exercise("01_one_dimension", "One dimension", one_dimension.TASKS),
    Exercise("02_restitution", "Restitution", restitution.TASKS),
    Exercise("03_reflection", "Reflection", reflection.TASKS),
    Exercise("04_circles", "Circles", circles.TASKS),
    Exercise("05_spin_and_friction", "Spin and friction", spin_and_friction.TASKS),
    Exercise("06_sat_and_manifolds", "SAT and manifolds", separating_axes.TASKS),
    Exercise("07_time_of_impact", "Time of impact", time_of_impact.TASKS),
    Exercise("08_what_accuracy_costs", "What accuracy costs", what_accuracy_costs.TASKS),
    Exercise("09_hard_cases", "Hard cases", hard_cases.TASKS),
    Exercise("10_only_what_the_scene_needs", "Only what the scene needs", effects.TASKS),
    Exercise("11_the_small_engine", "The small engine", small_engine.TASKS),
    Exercise("pool", "Pool", pool.TASKS, suffix=".py"),
    Exercise("cradle", "Newton's cradle", cradle.TASKS, suffix=".py"),
    Exercise("breakout", "Breakout", breakout.TASKS, suffix=".py"),
    Exercise("dominoes", "Dominoes", dominoes.TASKS, suffix=".py"),
    Exercise("asteroids", "Asteroid field", asteroids.TASKS, suffix=".py"),
    Exercise("soft_body", "Soft body", soft_body.TASKS, suffix=".py"),
    Exercise("billiards", "Cushion-bounce billiards", billiards.TASKS, suffix=".py"),
)


def task_by_id(task_id: str) -> Task:
    """Return a task of the course by its number.

    Raises
    ------
    ValueError
        There is no such task.
    """
    for exercise in EXERCISES:
        for task in exercise.tasks:
            if task.id == task_id:
                return task
    known = ", ".join(task.id for exercise in EXERCISES for task in exercise.tasks)
    raise ValueError(f"task must be one of {known}, got {task_id!r}")


def exercise_by_name(name: str) -> Exercise:
    """Return an exercise by its name, or by the beginning of it (its number, say).

    Raises
    ------
    ValueError
        No exercise, or more than one, is called so.
    """
    found = [exercise for exercise in EXERCISES if exercise.name.startswith(name)]
    if len(found) != 1 or not name:
        known = ", ".join(exercise.name for exercise in EXERCISES)
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
    names = {exercise.name: exercise for exercise in EXERCISES}
    if submission.exercise in names:
        return names[submission.exercise]
    if submission.path.stem in names:
        return names[submission.path.stem]
    defined = set(submission.functions)
    ranked = sorted(EXERCISES, key=lambda exercise: -len(defined & set(exercise.task_ids)))
    if not defined & set(ranked[0].task_ids):
        raise ValueError(
            f"{submission.path}: neither its name nor its functions tell which exercise it is; "
            f"say it with --exercise"
        )
    return ranked[0]

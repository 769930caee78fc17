"""Practice checks: they judge as the course's own checks do, and hold none of them."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path

import pytest

from lesson_code.grading.exercises import EXERCISES, Exercise
from lesson_code.grading.in_process import call_here
from lesson_code.grading.practice import practice_of, practice_tasks, reference
from lesson_code.grading.task import KnownAnswer, Task
from lesson_code.grading.verdict import Verdict, judge

SEEDS = range(3)


@pytest.fixture(scope="module", params=EXERCISES, ids=lambda exercise: exercise.name)
def both(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Exercise, tuple[Task, ...]]:
    """Return an exercise, and its tasks with practice checks, written to a file and read again."""
    exercise: Exercise = request.param
    path = tmp_path_factory.mktemp("practice") / "tasks.json"
    path.write_text(practice_of(exercise.tasks), encoding="utf-8")
    return exercise, practice_tasks(path)


def verdicts(task: Task, answer: KnownAnswer) -> list[Verdict]:
    """Return what an answer earns in a task with some seeds."""
    call = partial(call_here, {task.function: answer.function})
    return [judge(task, call, seed) for seed in SEEDS]


def test_practice_gives_right_answers_full_marks(both: tuple[Exercise, tuple[Task, ...]]) -> None:
    """Every unusual right answer of the course passes them."""
    for own, practice in zip(both[0].tasks, both[1], strict=True):
        assert (practice.title, practice.points) == (own.title, own.points)
        for unusual in own.alternatives:
            assert all(verdict.is_full for verdict in verdicts(practice, unusual)), unusual.name


def test_practice_takes_points_from_wrong_models_and_recognises_them(
    both: tuple[Exercise, tuple[Task, ...]],
) -> None:
    """Each common mistake loses points and gets its own hint, without its formula being there."""
    for own, practice in zip(both[0].tasks, both[1], strict=True):
        for model in own.wrong_models:
            for verdict in verdicts(practice, model):
                assert not verdict.is_full, model.name
                assert verdict.recognised is not None, model.name
                assert verdict.recognised.name == model.name
                assert verdict.recognised.hint == model.hint
                assert verdict.recognised.misconception == model.misconception


def test_practice_says_what_the_courses_own_checks_say() -> None:
    """The message has the call, the answer, what was expected and why."""
    (task,) = [task for task in EXERCISES[0].tasks if task.id == "1.1"]
    text = practice_of([task])
    assert "momentum_before_and_after" in json.loads(text)[0]["explain"]


def test_practice_file_can_be_neither_read_nor_searched(
    both: tuple[Exercise, tuple[Task, ...]],
) -> None:
    """No number of a draw, no hint and no misconception stands in it as it is."""
    text = practice_of(both[0].tasks)
    for task in both[0].tasks:
        for model in task.wrong_models:
            assert model.hint not in text
            assert model.name not in text
    assert set(json.loads(text)[0]["criteria"][0]) == {"name", "points", "part", "draws"}


def test_reference_to_what_no_module_holds_is_refused() -> None:
    """A function inside another cannot be found again by another copy."""
    assert reference(json.dumps) == "json:dumps"
    with pytest.raises(ValueError, match="must stand at the top level of"):
        reference(lambda: None)


def test_practice_draws_are_the_same_each_time(tmp_path: Path) -> None:
    """Two releases of one workbook are the same bytes."""
    assert practice_of(EXERCISES[0].tasks) == practice_of(EXERCISES[0].tasks)

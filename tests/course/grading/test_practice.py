"""Practice checks: they judge as the course's own checks do, and hold none of them."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import NamedTuple

import pytest

from lesson_code.course.grading.exercises import Exercise, exercises, task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.practice import practice_of, practice_tasks, reference
from lesson_code.course.grading.task import KnownAnswer, Task
from lesson_code.course.grading.verdict import Verdict, judge

SEEDS = range(3)


class Practice(NamedTuple):
    """An exercise, and what a student's copy has of its tasks."""

    exercise: Exercise
    tasks: tuple[Task, ...]
    text: str


@pytest.fixture(scope="module", params=exercises(), ids=lambda exercise: exercise.name)
def practice(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Practice:
    """Return an exercise with its practice checks, written to a file and read again."""
    exercise: Exercise = request.param
    path = tmp_path_factory.mktemp("practice") / "tasks.json"
    text = practice_of(exercise.tasks)
    path.write_text(text, encoding="utf-8")
    return Practice(exercise, practice_tasks(path), text)


def verdicts(task: Task, answer: KnownAnswer) -> list[Verdict]:
    """Return what an answer earns in a task with some seeds."""
    call = partial(call_here, {task.function: answer.function})
    return [judge(task, call, seed) for seed in SEEDS]


@pytest.mark.one_in(12)
def test_practice_gives_right_answers_full_marks(practice: Practice) -> None:
    """Every unusual right answer of the course passes them."""
    for own, checked in zip(practice.exercise.tasks, practice.tasks, strict=True):
        assert (checked.title, checked.points) == (own.title, own.points)
        for unusual in own.alternatives:
            assert all(verdict.is_full for verdict in verdicts(checked, unusual)), unusual.name


@pytest.mark.one_in(12)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # a wrong answer may divide by 0
def test_practice_takes_points_from_wrong_models_and_recognises_them(practice: Practice) -> None:
    """Each common mistake loses points and gets its own hint, without its formula being there."""
    for own, checked in zip(practice.exercise.tasks, practice.tasks, strict=True):
        for model in own.wrong_models:
            for verdict in verdicts(checked, model):
                assert not verdict.is_full, model.name
                assert verdict.recognised is not None, model.name
                assert verdict.recognised.name == model.name
                assert verdict.recognised.hint == model.hint
                assert verdict.recognised.misconception == model.misconception


def test_practice_welcomes_a_set_where_any_order_is_right(tmp_path: Path) -> None:
    """What earns full marks in grading passes in the student's copy, too."""
    path = tmp_path / "tasks.json"
    own = task_by_id("11.1")
    path.write_text(practice_of([own]), encoding="utf-8")
    (task,) = practice_tasks(path)
    as_set = KnownAnswer(own.id, lambda boxes: set(own.expected(boxes)))
    assert all(verdict.is_full for verdict in verdicts(task, as_set))


def test_practice_says_what_the_courses_own_checks_say() -> None:
    """The message has the call, the answer, what was expected and why."""
    (task,) = [task for task in exercises()[0].tasks if task.id == "1.1"]
    text = practice_of([task])
    assert "momentum_before_and_after" in json.loads(text)[0]["explain"]


@pytest.mark.one_in(12)
def test_practice_file_can_be_neither_read_nor_searched(practice: Practice) -> None:
    """No number of a draw, no hint and no misconception stands in it as it is."""
    text = practice.text
    for task in practice.exercise.tasks:
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
    assert practice_of(exercises()[0].tasks) == practice_of(exercises()[0].tasks)

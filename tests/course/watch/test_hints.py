"""Help that comes a step at a time."""

from __future__ import annotations

import pytest

from lesson_code.course.grading.exercises import exercises, task_by_id
from lesson_code.course.grading.task import Task
from lesson_code.course.watch.hints import example

TASKS = [task for exercise in exercises() for task in exercise.tasks]


def test_example_is_a_right_answer_that_can_be_worked_out_by_hand() -> None:
    """The mirror image at a floor turns round the component across it."""
    said = example(task_by_id("3.1"))
    assert said.startswith("An example to follow by hand: reflect(incident=(-1.2, -5.22), normal=")
    assert said.endswith(" is (-1.2, 5.22).")


@pytest.mark.one_in(4)
@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.title)
def test_example_is_there_for_every_task(task: Task) -> None:
    """Each task has one, with the names of its arguments."""
    said = example(task)
    assert f"{task.function}({task.parameters[0]}=" in said

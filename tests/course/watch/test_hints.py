"""Help that comes a step at a time."""

from __future__ import annotations

import re

import nbformat
import pytest

from lesson_code.course.grading.exercises import Exercise, exercises, task_by_id
from lesson_code.course.grading.task import Task
from lesson_code.course.notebooks.root import find_root
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


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_section_to_read_again_is_there(exercise: Exercise) -> None:
    """It is one of its chapter's own, and neither the quiz nor a fault made on purpose."""
    path = find_root() / "notebooks" / f"{exercise.name}.ipynb"
    cells = nbformat.read(path, as_version=4).cells if path.exists() else []
    titles = {}
    for cell in cells:
        found = re.findall(r"^## (\d+) (.*)", cell.source, re.MULTILINE)
        titles |= {int(number): title for number, title in found}
    for task in exercise.tasks:
        assert (task.section is None) == (not titles), task.title
        if task.section is not None:
            assert not titles[task.section].startswith(("Quiz", "Break it")), task.title

"""Help that comes a step at a time."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from lesson_code.course.grading.exercises import Exercise, exercises, task_by_id
from lesson_code.course.grading.task import Task
from lesson_code.course.notebooks.parts import parts
from lesson_code.course.notebooks.root import find_root
from lesson_code.course.watch.hints import example, where_to_read

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
    titles = {}
    for part in parts(find_root(), exercise.name[:2]):
        found = re.findall(r"^## (\d+) (.*)", part.prose, re.MULTILINE)
        titles |= {int(number): (title, part.title) for number, title in found}
    for task in exercise.tasks:
        assert (task.section is None) == (not titles), task.title
        if task.section is not None:
            title, notebook = titles[task.section]
            assert not title.startswith(("Quiz", "Break it")), task.title
            said = where_to_read(task, exercise, find_root())
            assert said == f"Read section {task.section} of notebook {notebook} again."


def test_where_to_read_is_said_without_the_notebooks(tmp_path: Path) -> None:
    """Somebody may have only the exercises; the chapter's name tells them enough."""
    exercise = exercises()[0]
    said = where_to_read(exercise.tasks[0], exercise, tmp_path)
    assert said == "Read section 3 of notebook 01 One dimension again."

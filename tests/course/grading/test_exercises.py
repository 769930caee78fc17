"""The list of exercises, and how a submission is matched with one."""

from __future__ import annotations

from pathlib import Path

import pytest

from lesson_code.course.grading.exercises import (
    Exercise,
    exercise_by_name,
    exercise_of,
    exercises,
    task_by_id,
)
from lesson_code.course.grading.submission import read_submission

from ..conftest import Write

ALL_TASKS = [task for exercise in exercises() for task in exercise.tasks]


def test_exercises_names_tasks_and_functions_are_unique() -> None:
    """No two exercises or tasks share a name, and no exercise asks for a function twice."""
    assert len({exercise.name for exercise in exercises()}) == len(exercises())
    assert len({task.id for task in ALL_TASKS}) == len(ALL_TASKS)
    for exercise in exercises():
        assert len(exercise.task_ids) == len(exercise.tasks)


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_exercise_has_at_least_three_tasks_with_several_criteria(exercise: Exercise) -> None:
    """Every exercise has three tasks or more, and each task two criteria or more."""
    assert len(exercise.tasks) >= 3
    for task in exercise.tasks:
        assert len(task.criteria) >= 2
        assert len({criterion.name for criterion in task.criteria}) == len(task.criteria)
        assert task.objective


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_exercise_tasks_list_what_the_chapter_marks_for_them(exercise: Exercise) -> None:
    """Each marked answer is in one task, under its own number, in the order it is written."""
    for task in exercise.tasks:
        known = [mark for mark in exercise.known_answers if mark.task == task.id]
        assert [*task.wrong_models, *task.alternatives] == known
    listed = [m for task in exercise.tasks for m in (*task.wrong_models, *task.alternatives)]
    assert sorted(map(id, listed)) == sorted(map(id, exercise.known_answers))


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_exercise_files_stand_where_it_says(exercise: Exercise, root: Path) -> None:
    """Solution and student copy are there, and are recognised as this exercise."""
    for path in (exercise.solution(root), exercise.student_copy(root)):
        assert exercise_of(read_submission(path)) is exercise


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_exercise_student_copy_states_its_points(exercise: Exercise, root: Path) -> None:
    """The points written in a student notebook are those that the grader gives."""
    text = exercise.student_copy(root).read_text(encoding="utf-8")
    for task in exercise.tasks:
        assert f"Task {task.id}" in text
        if exercise.suffix == ".ipynb":
            line = next(line for line in text.splitlines() if f"## Task {task.id}" in line)
            assert f"({task.points} points)" in line


@pytest.mark.parametrize("task", ALL_TASKS, ids=lambda task: task.title)
def test_task_by_id_finds_each_task(task: object) -> None:
    """A task is found by its number."""
    assert task_by_id(task.id) is task  # type: ignore[attr-defined]


@pytest.mark.parametrize("task_id", ["", "9.9", "1", "1.1 ", "b.1"])
def test_task_by_id_refuses_another_by_name(task_id: str) -> None:
    """A number that no task has is refused, with those there are."""
    with pytest.raises(ValueError, match=r"task must be one of 1\.1, .*, got "):
        task_by_id(task_id)


@pytest.mark.parametrize(
    ("name", "found"),
    [("01", "01_one_dimension"), ("02_rest", "02_restitution"), ("billiards", "billiards")],
)
def test_exercise_by_name_takes_the_beginning(name: str, found: str) -> None:
    """The number, or any beginning of the name, is enough."""
    assert exercise_by_name(name).name == found


@pytest.mark.parametrize("name", ["", "0", "4", "01_one_dimension.ipynb", "one"])
def test_exercise_by_name_refuses_none_and_several(name: str) -> None:
    """A beginning that fits none, or several, is refused."""
    with pytest.raises(ValueError, match="exercise must be one of 01_one_dimension, "):
        exercise_by_name(name)


def test_exercise_of_takes_the_notebooks_word_first(write: Write) -> None:
    """What the notebook says goes before its file's name, and that before its functions."""
    source = "def reflect(): pass"
    says = write("02_restitution.ipynb", source, exercise="01_one_dimension")
    assert exercise_of(read_submission(says)).name == "01_one_dimension"
    named = write("02_restitution.py", source)
    assert exercise_of(read_submission(named)).name == "02_restitution"
    neither = write("mine.ipynb", source, exercise="no such exercise")
    assert exercise_of(read_submission(neither)).name == "03_reflection"


def test_exercise_of_goes_by_most_functions(write: Write) -> None:
    """The exercise with the most of its functions in the file is taken."""
    source = "def reflect(): pass\ndef collide_1d(): pass\ndef rest_time(): pass"
    assert exercise_of(read_submission(write("mine.py", source))).name == "02_restitution"


def test_exercise_of_nothing_known_is_refused(write: Write) -> None:
    """A file that gives no sign is refused, and the message says what to do."""
    submission = read_submission(write("mine.py", "def f(): pass"))
    with pytest.raises(ValueError, match=r"mine\.py: .* say it with --exercise"):
        exercise_of(submission)

"""The exercises put to the test: no fault here, and each kind of fault is found."""

from __future__ import annotations

import dataclasses
import json
import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from tiers import share

from lesson_code.course.grading import self_check, verdict
from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercises
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.self_check import faults
from lesson_code.course.grading.task import Alternative, KnownAnswer, Task, WrongModel

EXERCISE = exercises()[0]
TASK = EXERCISE.tasks[0]
STUDENT_COPY = "exercises/01_one_dimension.ipynb"
SOLUTION = "solutions/01_one_dimension.ipynb"
PROGRAM = "exercises/billiards.py"


@pytest.mark.full
@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # a wrong answer may divide by 0
def test_faults_none_in_this_workbook(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Stubs fail, solutions and alternatives pass, wrong models are recognised, nothing leaks.

    With one seed, or with all five in the full tier.
    """
    monkeypatch.setattr(self_check, "SEEDS", range(share(len(self_check.SEEDS))))
    told: list[str] = []
    assert list(faults(root, told.append)) == []
    for exercise in exercises():
        assert f"{exercise.name}: solution" in told
        assert all(f"{exercise.name}: task {task.title}" in told for task in exercise.tasks)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # a wrong answer may divide by 0
@pytest.mark.full
@pytest.mark.parametrize("seed", range(5, 11))
def test_known_answers_earn_the_same_with_any_seed(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a mistake costs is no matter of luck: the self-check asks for five seeds, this for more.

    What is said of the answers is left out: it takes most of the time.
    """
    monkeypatch.setattr(verdict, "diagnoses", lambda *_: ())

    def points(task: Task, answer: KnownAnswer, seed: int) -> int:
        call = partial(call_here, {task.function: answer.function})
        return verdict.judge(task, call, seed).points

    unlike = [
        f"{task.id} {answer.name}"
        for exercise in exercises()
        for task in exercise.tasks
        for answer in (*task.wrong_models, *task.alternatives)
        if points(task, answer, seed) != points(task, answer, 0)
    ]
    assert unlike == []


@pytest.fixture
def copied(root: Path, tmp_path: Path) -> Path:
    """Return a copy of the workbook's exercises and solutions, to be spoilt."""
    for folder in ("exercises", "solutions"):
        shutil.copytree(root / folder, tmp_path / folder)
    return tmp_path


@pytest.fixture
def found(copied: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[str]]:
    """Return a function that lists the faults of the copy, with one exercise in it."""
    monkeypatch.setattr(self_check, "SEEDS", range(1))

    def faults_of(exercise: Exercise) -> list[str]:
        for other in exercises():
            if other.name != exercise.name:
                other.solution(copied).unlink(missing_ok=True)
                other.student_copy(copied).unlink(missing_ok=True)
        monkeypatch.setattr(self_check, "exercises", lambda: (exercise,))
        return list(faults(copied))

    return faults_of


def with_task(task: Task) -> Exercise:
    """Return the first exercise with a task in place of its first."""
    exercise = Exercise(EXERCISE.chapter)
    vars(exercise)["tasks"] = (task, *EXERCISE.tasks[1:])
    return exercise


def right(m1: float, v1: float, m2: float, v2: float) -> Any:
    """Return the right answer to the first task."""
    return TASK.expected(m1, v1, m2, v2)


def mute(m1: float, v1: float, m2: float, v2: float) -> Any:  # noqa: D103 - on purpose
    return v2, v1


def swapped(m1: float, v1: float, m2: float, v2: float) -> Any:
    """They exchange velocities."""
    return v2, v1


def test_faults_of_wrong_models_and_alternatives_are_found(
    found: Callable[..., list[str]],
) -> None:
    """Wrong models that pass, that are not told apart or say nothing, and a wrong alternative."""
    models = (
        WrongModel("1.1", right, "Why?"),
        WrongModel("1.1", swapped, " "),
        WrongModel("1.1", mute, "Why?"),
    )
    spoilt = dataclasses.replace(
        TASK, wrong_models=models, alternatives=(Alternative("1.1", swapped),)
    )
    assert found(with_task(spoilt)) == [
        "task 1.1 elastic_1d: wrong model right passes (seed 0)",
        "task 1.1 elastic_1d: wrong model swapped has an empty hint or misconception",
        "task 1.1 elastic_1d: wrong model swapped is not recognised",
        "task 1.1 elastic_1d: wrong model mute has an empty hint or misconception",
        "task 1.1 elastic_1d: wrong model mute is not recognised",
        "task 1.1 elastic_1d: alternative swapped gets 1.1 elastic_1d: 1/4 points",
    ]


def with_luck(m1: float, v1: float, m2: float, v2: float) -> Any:
    """Exchange velocities if the first body is slow."""
    return TASK.expected(m1, v1, m2, v2) if v1 > 3.5 else (v2, v1)


def test_fault_of_a_wrong_model_that_earns_by_luck_is_found(
    found: Callable[..., list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody pays more for a mistake than another one does who makes it."""
    monkeypatch.setattr(self_check, "SEEDS", range(3))
    models = (WrongModel("1.1", with_luck, "Does it depend on the speed?"),)
    lines = found(with_task(dataclasses.replace(TASK, wrong_models=models)))
    assert "task 1.1 elastic_1d: wrong model with_luck earns [1, 2], by the seed" in lines


def test_faults_of_missing_wrong_models_and_alternatives_are_found(
    found: Callable[..., list[str]],
) -> None:
    """A task with two wrong models and no alternative is not finished."""
    bare = dataclasses.replace(TASK, wrong_models=TASK.wrong_models[:2], alternatives=())
    assert found(with_task(bare)) == [
        "task 1.1 elastic_1d: has fewer than 3 wrong models",
        "task 1.1 elastic_1d: has no alternative",
    ]


def test_faults_of_a_solution_are_found(copied: Path, found: Callable[..., list[str]]) -> None:
    """A solution that does not get full marks is found."""
    spoil(copied / SOLUTION, spoil_answer)
    assert found(EXERCISE) == ["01_one_dimension.ipynb: 1.2 inelastic_1d: 0/3 points"]


def spoil(path: Path, change: Callable[[dict[str, Any]], None]) -> None:
    """Change a notebook on disk."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    change(notebook)
    path.write_text(json.dumps(notebook), encoding="utf-8")


def cell_with(notebook: dict[str, Any], text: str) -> dict[str, Any]:
    """Return the first cell with a text in it."""
    return next(cell for cell in notebook["cells"] if text in "".join(cell["source"]))


def spoil_answer(notebook: dict[str, Any]) -> None:
    """Put a wrong answer into a solution."""
    cell_with(notebook, "def inelastic_1d")["source"] = "def inelastic_1d(*_):\n    return 0"


def put_answer(notebook: dict[str, Any]) -> None:
    """Replace the stub of task 1.2 by an answer."""
    cell_with(notebook, "Task 1.2: ")["source"] = "def inelastic_1d(m1, v1, m2, v2):\n    return 0"


def leave_line(notebook: dict[str, Any]) -> None:
    """Leave a line of the answer above the raise of task 1.2's stub."""
    cell = cell_with(notebook, "Task 1.2: ")
    cell["source"] = "".join(cell["source"]).replace("    raise", "    v = m1 * v1\n    raise")


def leave_comment(notebook: dict[str, Any]) -> None:
    """Leave a formula of the solution in a comment."""
    cell = cell_with(notebook, "Task 1.3: ")
    cell["source"] = "".join(cell["source"]) + "\n    # return 2*(v1 - v2) / (1/m1 + 1/m2)"


def drop_stub(notebook: dict[str, Any]) -> None:
    """Leave a stub out."""
    cell_with(notebook, "Task 1.1: ")["source"] = ""


def leave_output(notebook: dict[str, Any]) -> None:
    """Leave an output in the second cell."""
    notebook["cells"][1]["outputs"] = [{"output_type": "stream", "name": "stdout", "text": "1"}]


def leave_instructors_cell(notebook: dict[str, Any]) -> None:
    """Leave a cell of the solution."""
    notebook["cells"][0]["metadata"]["tags"] = ["solution"]


def test_faults_of_a_student_notebook_are_found(
    copied: Path, found: Callable[..., list[str]]
) -> None:
    """Answers, formulas, outputs and cells that are left in a student notebook are found."""
    for change in (drop_stub, put_answer, leave_comment, leave_output, leave_instructors_cell):
        spoil(copied / STUDENT_COPY, change)
    name = "01_one_dimension.ipynb"
    assert found(EXERCISE) == [
        f"{name}: the stub of task 1.1 elastic_1d is no stub",
        f"{name}: the stub of task 1.2 inelastic_1d is no stub",
        f"{name}: something of the solution of inelastic_1d is left in the stub",
        f"{name}: holds what the solution of elastic_impulse_1d has: "
        "return 2 * (v1 - v2) / (1 / m1 + 1 / m2)",
        f"{name}: cell 1 belongs to the solution",
        f"{name}: cell 2 has outputs",
    ]


def test_faults_of_a_stub_that_raises_late_are_found(
    copied: Path, found: Callable[..., list[str]]
) -> None:
    """A stub that fails as it should, but computes something first, is found too."""
    spoil(copied / STUDENT_COPY, leave_line)
    assert found(EXERCISE) == [
        "01_one_dimension.ipynb: something of the solution of inelastic_1d is left in the stub"
    ]


def test_faults_of_a_student_program_are_found(
    copied: Path, found: Callable[..., list[str]]
) -> None:
    """A formula left in a program, be it in a docstring, is found as in a notebook."""
    path = copied / PROGRAM
    text = path.read_text().replace("    1. Separate", "    position = position+depth*normal")
    path.write_text(text)
    assert found(exercise_by_name("billiards")) == [
        "billiards.py: holds what the solution of resolve has: position = position + depth * normal"
    ]


def test_faults_of_orphaned_files_are_found(copied: Path, found: Callable[..., list[str]]) -> None:
    """A notebook or program that no exercise lists is found, a picture is not."""
    (copied / "exercises" / "99_nothing.ipynb").write_text("{}")
    (copied / "solutions" / "nothing.py").write_text("")
    (copied / "solutions" / "nothing.png").write_text("")
    assert found(EXERCISE)[-2:] == [
        "exercises/99_nothing.ipynb: belongs to no exercise",
        "solutions/nothing.py: belongs to no exercise",
    ]


def test_faults_of_orphaned_marks_are_found(found: Callable[..., list[str]]) -> None:
    """A wrong model or alternative of a task that the chapter does not have is found."""
    exercise = Exercise(EXERCISE.chapter)
    orphans = (WrongModel("2.1", swapped, "Why?"), Alternative("9.9", mute))
    vars(exercise)["known_answers"] = (*exercise.known_answers, *orphans)
    assert found(exercise) == [
        "swapped: is marked for task 2.1, which 01_one_dimension does not have",
        "mute: is marked for task 9.9, which 01_one_dimension does not have",
    ]

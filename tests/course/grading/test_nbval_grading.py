"""nbval as a grader: it passes exactly what earns full marks."""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
import sysconfig
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercises, task_by_id
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.nbval_grading import CHECK_CALL, grade_under_nbval, merge
from lesson_code.course.grading.report import print_report
from lesson_code.course.grading.submission import SubmissionError, read_submission
from lesson_code.course.grading.task import WrongModel

from ..conftest import Write, source_as_answer

FOLDER = Path(__file__).parents[1] / "golden"
TABLE: dict[str, dict[str, Any]] = tomllib.loads((FOLDER / "golden.toml").read_text())
CHAPTERS = [exercise for exercise in exercises() if exercise.suffix == ".ipynb"]
WHY_NOT_UNDER_NBVAL = ("kills", "hangs", "floods", "takes the memory", "has no wall", "has nothing")
WORKBOOK = Path(sysconfig.get_path("scripts")) / "workbook"


def passed(path: Path, exercise: Exercise, root: Path) -> list[bool]:
    """Return for each task whether nbval passes it."""
    outcomes = grade_under_nbval(read_submission(path), exercise, root)
    assert [outcome.task for outcome in outcomes] == [task.id for task in exercise.tasks]
    return [outcome.passed for outcome in outcomes]


def full(grader: Grader, path: Path, exercise: Exercise) -> list[bool]:
    """Return for each task whether the grader gives full marks."""
    return [verdict.is_full for verdict in grader.grade(path, exercise=exercise.name).verdicts]


def with_answers(exercise: Exercise, root: Path, answers: dict[str, str]) -> dict[str, Any]:
    """Return the student copy with the solution's answers laid in, some replaced by others."""
    solution = json.loads(exercise.solution(root).read_text(encoding="utf-8"))
    notebook: dict[str, Any] = json.loads(exercise.student_copy(root).read_text(encoding="utf-8"))
    right = {name: source for cell in solution["cells"] for name, source in _defined(cell)}
    for cell in notebook["cells"]:
        for name, _ in _defined(cell):
            cell["source"] = answers.get(name, right[name])
    return notebook


def _defined(cell: dict[str, Any]) -> list[tuple[str, str]]:
    """Return name and source of the function that a cell is there for, if it is for one."""
    source = "".join(cell["source"])
    if "task" not in cell["metadata"].get("tags", []):
        return []
    return [(source.partition("def ")[2].partition("(")[0], source)]


@pytest.fixture
def student_notebook(root: Path, tmp_path: Path) -> Callable[..., Path]:
    """Return a function that writes a student's notebook, right but for the answers given."""

    def write_notebook(exercise: Exercise, **answers: str) -> Path:
        path = tmp_path / f"{exercise.name}.ipynb"
        path.write_text(json.dumps(with_answers(exercise, root, answers)), encoding="utf-8")
        return path

    return write_notebook


@pytest.mark.one_in(12)
@pytest.mark.parametrize("name", [name for name in TABLE if TABLE[name]["under_nbval"] == "agrees"])
def test_nbval_agrees_with_grade_on_golden_submission(name: str, root: Path) -> None:
    """Under nbval exactly the tasks with full marks pass."""
    exercise = exercise_by_name(TABLE[name]["exercise"])
    points = [task.points for task in exercise.tasks]
    expected = [got == most for got, most in zip(TABLE[name]["points"], points, strict=True)]
    assert passed(FOLDER / name, exercise, root) == expected


def test_nbval_is_run_on_a_dozen_and_the_others_say_why_not() -> None:
    """Every golden submission is run under nbval, or is like one that is, or kills its kernel."""
    run = {name for name, entry in TABLE.items() if entry["under_nbval"] == "agrees"}
    assert len(run) >= 12
    for name in set(TABLE) - run:
        reason = TABLE[name]["under_nbval"]
        like = reason.removeprefix("as ")
        assert like in run or reason.startswith(WHY_NOT_UNDER_NBVAL)


def test_nbval_and_grade_give_a_right_student_notebook_full_marks(
    root: Path, student_notebook: Callable[..., Path], grader: Grader
) -> None:
    """The student's copy with the solution's answers in it passes both, in chapter 01."""
    path = student_notebook(CHAPTERS[0])
    assert full(grader, path, CHAPTERS[0]) == passed(path, CHAPTERS[0], root) == [True] * 3


@pytest.mark.parametrize("exercise", CHAPTERS, ids=lambda exercise: exercise.name)
def test_grade_gives_a_right_student_notebook_full_marks(
    exercise: Exercise, student_notebook: Callable[..., Path], grader: Grader
) -> None:
    """The student's copy with the solution's answers in it earns full marks."""
    assert all(full(grader, student_notebook(exercise), exercise))


@pytest.mark.one_in(20)
@pytest.mark.parametrize(
    "model",
    [model for exercise in CHAPTERS for task in exercise.tasks for model in task.wrong_models],
    ids=lambda model: f"{model.task} {model.name}",
)
def test_grade_of_student_notebook_with_wrong_model_shows_its_hint(
    model: WrongModel, student_notebook: Callable[..., Path], grader: Grader
) -> None:
    """Handed in as by a student, a wrong model loses points, and its hint is printed."""
    printed = Console(file=io.StringIO())
    print_report(grader.grade(notebook_with(model, student_notebook), seed=7), printed)
    shown = " ".join(printed.file.getvalue().split())  # type: ignore[attr-defined]
    points = re.search(rf"{re.escape(task_by_id(model.task).title)}: (\d)/(\d) points", shown)
    assert points is not None
    assert points[1] < points[2]
    assert f"hint: {model.hint}" in shown


def notebook_with(model: WrongModel, student_notebook: Callable[..., Path]) -> Path:
    """Return a student's notebook that is right but for one wrong model."""
    task = task_by_id(model.task)
    exercise = next(exercise for exercise in CHAPTERS if task in exercise.tasks)
    answer = f"import numpy as np\n\n\n{source_as_answer(model, task.function)}"
    return student_notebook(exercise, **{task.function: answer})


@pytest.mark.one_in(12)
@pytest.mark.parametrize("exercise", CHAPTERS[1:], ids=lambda exercise: exercise.name)
def test_nbval_and_grade_take_marks_from_a_wrong_model_alone(
    exercise: Exercise, root: Path, student_notebook: Callable[..., Path], grader: Grader
) -> None:
    """With one wrong model in it, a notebook loses that task under both, and no other."""
    model = exercise.tasks[0].wrong_models[0]
    path = notebook_with(model, student_notebook)
    others = len(exercise.tasks) - 1
    assert full(grader, path, exercise) == passed(path, exercise, root) == [False] + [True] * others


@pytest.mark.parametrize("exercise", CHAPTERS, ids=lambda exercise: exercise.name)
def test_merge_keeps_every_check_with_the_output_of_full_marks(
    exercise: Exercise, root: Path
) -> None:
    """Each task has one check cell, with the line of full marks as its stored output."""
    merged = merge(read_submission(exercise.student_copy(root)), exercise, root)
    checks = {
        found.group(1): cell
        for cell in merged["cells"]
        if cell["cell_type"] == "code" and (found := CHECK_CALL.search("".join(cell["source"])))
    }
    assert list(checks) == [task.id for task in exercise.tasks]
    for task in exercise.tasks:
        (output,) = checks[task.id]["outputs"]
        full_marks = f"{task.id} {task.function}: {task.points}/{task.points} points\n"
        assert "".join(output["text"]) == full_marks
        assert "nbval-check-output" in checks[task.id]["metadata"]["tags"]


def test_merge_holds_no_code_but_the_students_and_the_checks(root: Path, write: Write) -> None:
    """Nothing of the solution's code is left for an answer to lean on."""
    submission = read_submission(write("answer.py", "x = 1\nimport lesson_code\ny = 2"))
    merged = merge(submission, CHAPTERS[2], root)
    code = ["".join(c["source"]) for c in merged["cells"] if c["cell_type"] == "code"]
    assert code[1:3] == ["x = 1", "y = 2"]
    assert "kept_apart" in code[0]
    assert code[3].splitlines()[-1] == "from lesson_code.course.grading import check_task"
    assert all(source.startswith("check_task(") for source in code[4:])
    assert len({cell["id"] for cell in merged["cells"]}) == len(merged["cells"])


def test_merge_leaves_the_solution_as_it_is(root: Path, write: Write) -> None:
    """Texts stay in their places, and the file on disk is not touched."""
    path = CHAPTERS[0].solution(root)
    before = path.read_bytes()
    merged = merge(read_submission(write("answer.py", "x = 1")), CHAPTERS[0], root)
    solution = json.loads(before)
    assert [c for c in merged["cells"] if c["cell_type"] == "markdown"] == [
        c for c in solution["cells"] if c["cell_type"] == "markdown"
    ]
    assert merged["metadata"] == solution["metadata"]
    assert path.read_bytes() == before


def test_merge_of_a_program_is_refused(root: Path, write: Write) -> None:
    """An exercise without a notebook cannot be graded by nbval, and says so."""
    submission = read_submission(write("billiards.py", "x = 1"))
    with pytest.raises(SubmissionError, match="billiards is a program: grade it without nbval"):
        merge(submission, exercise_by_name("billiards"), root)


@pytest.mark.full
def test_two_commands_by_hand_grade_a_submission(tmp_path: Path) -> None:
    """``workbook merge``, then ``pytest --nbval-lax``: the check of the wrong answer fails."""
    environment = {"PATH": str(WORKBOOK.parent), "HOME": str(tmp_path)}
    merging = subprocess.run(
        [WORKBOOK, "merge", FOLDER / "wrong_model.ipynb", "-o", "merged.ipynb"],
        cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    assert merging.returncode == 0, merging.stderr
    assert "pytest --nbval-lax merged.ipynb" in merging.stdout
    testing = subprocess.run(
        [sys.executable, "-m", "pytest", "--nbval-lax", "merged.ipynb", "-p", "no:cacheprovider"],
        cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    assert testing.returncode == 1
    assert "1 failed, 8 passed" in testing.stdout, testing.stdout
    assert 'check_task("1.1", elastic_1d)' in testing.stdout

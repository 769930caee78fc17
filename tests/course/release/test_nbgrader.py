"""The course folder for nbgrader: notebooks it accepts, whose cells earn what ``grade`` gives.

The keys are those of nbgrader's schema 3 (contributor guide, JSON Metadata Format); its marks are
the documented defaults. nbgrader itself is not needed here.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

import nbformat
import pytest
from typer.testing import CliRunner

from lesson_code.cli import app
from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercises
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.release.nbgrader import nbgrader_notebook

SEED = 7
CHAPTERS = [exercise for exercise in exercises() if exercise.suffix == ".ipynb"]
NAME = re.compile(r"[a-zA-Z0-9_\-]+")
HIDDEN = re.compile(r"### BEGIN HIDDEN TESTS\n.*?### END HIDDEN TESTS", re.DOTALL)
SOLUTION = re.compile(r"    ### BEGIN SOLUTION\n.*?### END SOLUTION", re.DOTALL)
SWAPS = "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n"
BORROWED = """
from lesson_code.formulas import elastic_1d as ours

def elastic_1d(*a):
    return ours(*a)
"""


def graded_cells(notebook: Any) -> list[Any]:
    """Return the cells that have points."""
    return [c for c in notebook.cells if c.metadata.get("nbgrader", {}).get("grade")]


def points_of(notebook: Any, answers: str) -> dict[str, int]:
    """Return what each graded cell earns after some answers, as nbgrader counts: all or nothing."""
    names: dict[str, Any] = {"__name__": "__main__"}
    exec(answers, names)  # noqa: S102 - as a kernel does
    earned = {}
    for cell in graded_cells(notebook):
        given = cell.metadata["nbgrader"]
        try:
            exec(cell.source, names)  # noqa: S102
            earned[given["grade_id"]] = given["points"]
        except Exception:
            earned[given["grade_id"]] = 0
    return earned


@pytest.mark.one_in(4)
@pytest.mark.parametrize("exercise", CHAPTERS, ids=lambda exercise: exercise.name)
def test_metadata_are_those_of_schema_3(exercise: Exercise, root: Path) -> None:
    """Every answer is a solution cell, every check is locked, every criterion has its points."""
    notebook = nbgrader_notebook(root, exercise, SEED)
    nbformat.validate(notebook)
    marked = [c for c in notebook.cells if "nbgrader" in c.metadata]
    for cell in marked:
        given = cell.metadata["nbgrader"]
        assert set(given) - {"points"} == {
            "grade", "solution", "locked", "task", "grade_id", "schema_version",
        }  # fmt: skip
        assert all(isinstance(given[role], bool) for role in ("grade", "solution", "locked"))
        assert given["schema_version"] == 3
        assert given["task"] is False
        assert NAME.fullmatch(given["grade_id"])
        assert ("points" in given) == given["grade"]
        assert cell.cell_type == "code"
    names = [cell.metadata["nbgrader"]["grade_id"] for cell in marked]
    assert len(set(names)) == len(names)
    points = [cell.metadata["nbgrader"]["points"] for cell in graded_cells(notebook)]
    assert points == [c.points for task in exercise.tasks for c in task.criteria]
    assert all(cell.metadata["nbgrader"]["locked"] for cell in graded_cells(notebook))


@pytest.mark.one_in(4)
@pytest.mark.parametrize("exercise", CHAPTERS, ids=lambda exercise: exercise.name)
def test_marks_enclose_the_answers_and_nothing_hidden_is_outside(
    exercise: Exercise, root: Path
) -> None:
    """With its marks the solution is the same code; without what they enclose it is the stub."""
    notebook = nbgrader_notebook(root, exercise, SEED)
    code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    solution = [s for u in read_submission(exercise.solution(root)).units for s in u.kept_sources]
    answers = [s for s in code if "### BEGIN SOLUTION" in s]
    for source in answers:
        assert any(ast.dump(ast.parse(source)) == ast.dump(ast.parse(s)) for s in solution)
    left = [SOLUTION.sub("    raise NotImplementedError()", HIDDEN.sub("", s)) for s in code]
    stubs = {s.name for source in left for s in ast.parse(source).body if is_stub(s)}
    assert stubs == set(exercise.task_ids)
    assert not re.search("check_criterion|seed|SOLUTION|HIDDEN", "".join(left))


def is_stub(statement: ast.stmt) -> bool:
    """Return whether a statement is a function that does nothing but raise."""
    return isinstance(statement, ast.FunctionDef) and isinstance(statement.body[-1], ast.Raise)


WRONG_BOUNCE = """
import numpy as np

def bounce(velocity, normal, restitution):
    return -velocity

def resolve_wall(position, velocity, normal, depth, restitution):
    return position + depth * normal, bounce(velocity, normal, restitution)
"""


def test_cells_earn_what_grade_gives(root: Path, tmp_path: Path) -> None:
    """Criterion by criterion; a wrong function that another answer calls is charged once."""
    chapters = {name: exercise_by_name(name) for name in ("01", "03")}
    notebooks = {name: nbgrader_notebook(root, e, SEED) for name, e in chapters.items()}
    solution = "\n".join(
        cell.source
        for cell in notebooks["01"].cells
        if cell.metadata.get("nbgrader", {}).get("solution")
    )
    cases = [("01", solution, 10), ("01", SWAPS, 1), ("01", BORROWED, 0), ("03", WRONG_BOUNCE, 4)]
    with Grader(hide_inputs=True) as grader:
        for name, answers, most in cases:
            path = tmp_path / "answers.py"
            path.write_text(answers)
            report = grader.grade(path, exercise=name, seed=SEED)
            given = [c.points for verdict in report.verdicts for c in verdict.criteria]
            assert list(points_of(notebooks[name], answers).values()) == given
            assert sum(given) == report.points == most


def test_command_writes_a_course_folder_of_chapters(tmp_path: Path) -> None:
    """Programs are no notebooks, and are refused by name."""
    runner, folder = CliRunner(), tmp_path / "course"
    ran = runner.invoke(app, ["release", str(folder), "--nbgrader", "--exercise", "01"])
    assert ran.exit_code == 0, ran.stderr
    assert "not for students" in ran.stdout
    written = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    assert written == {
        "nbgrader_config.py", "source/01_one_dimension/01_one_dimension.ipynb",
    }  # fmt: skip
    refused = runner.invoke(
        app, ["release", str(tmp_path / "x"), "--nbgrader", "--exercise", "pool"]
    )
    assert refused.exit_code == 2
    assert "pool is a program, and nbgrader grades notebooks alone" in refused.stderr

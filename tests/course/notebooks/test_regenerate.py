"""Derived files: what is committed is what its source says, or somebody is told."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nbformat
import pytest

from lesson_code.course.grading.exercises import exercises
from lesson_code.course.notebooks.regenerate import Derived, derived_files, drifted

ROOT = Path(__file__).parents[3]
ALL_TASKS = {exercise.name: exercise.task_ids for exercise in exercises()}

TASKS = {"01_line": {"double": "1.1"}, "game": {"step": "B.1"}}
NOTEBOOK = "# %% [markdown]\n# # A line\n\n# %%\nx = 2\n"
SOLUTION = (
    '# %%\ndef double(x):\n    """Double it."""\n    return 2 * x\n\n# %%\nprint(double(2))\n'
)
PROGRAM = '"""A game."""\n\n\ndef step(x):\n    return x + 1\n'


def written(path: Path, text: str) -> Path:
    """Write a file and the folders above it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture
def workbook(tmp_path: Path) -> Path:
    """Return a small workbook in which everything derived is as its source says."""
    written(tmp_path / "notebooks" / "source" / "01_line.py", NOTEBOOK)
    written(tmp_path / "solutions" / "source" / "01_line.py", SOLUTION)
    written(tmp_path / "solutions" / "game.py", PROGRAM)
    (tmp_path / "exercises").mkdir()
    for file in derived_files(tmp_path, TASKS):
        file.path.write_text(file.text(run=False), encoding="utf-8")
    assert drifted(tmp_path, TASKS) == []
    return tmp_path


def edited(path: Path, change: Callable[[dict[str, Any]], object]) -> None:
    """Change a notebook as somebody would in JupyterLab."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    change(notebook)
    path.write_text(json.dumps(notebook), encoding="utf-8")


def test_nothing_derived_has_drifted_in_this_workbook() -> None:
    """Every notebook, solution and student copy committed here is as its source says."""
    assert drifted(ROOT, ALL_TASKS) == []


def test_every_exercise_of_this_workbook_is_derived_from_its_solution() -> None:
    """No student copy is written by hand."""
    made = {file.path for file in derived_files(ROOT, ALL_TASKS)}
    assert {exercise.student_copy(ROOT) for exercise in exercises()} <= made
    assert {e.solution(ROOT) for e in exercises() if e.suffix == ".ipynb"} <= made


def test_derived_files_come_in_the_order_of_chapters(workbook: Path) -> None:
    """A solution is followed by its student copy; programs come last."""
    assert [f.path.relative_to(workbook).as_posix() for f in derived_files(workbook, TASKS)] == [
        "notebooks/01_line.ipynb",
        "solutions/01_line.ipynb",
        "exercises/01_line.ipynb",
        "exercises/game.py",
    ]


@pytest.mark.parametrize("name", ["notebooks/01_line.ipynb", "exercises/01_line.ipynb"])
def test_edited_cell_is_found(workbook: Path, name: str) -> None:
    """A cell changed in the notebook and not in its source is named."""
    edited(workbook / name, lambda notebook: notebook["cells"][0].update(source="# x = 3"))
    folder = "solutions" if name.startswith("exercises") else "notebooks"
    assert drifted(workbook, TASKS) == [f"{name}: differs from {folder}/source/01_line.py"]


def test_edited_source_is_found_in_everything_made_from_it(workbook: Path) -> None:
    """A solution changed in its source alone leaves notebook and student copy behind."""
    written(workbook / "solutions" / "source" / "01_line.py", SOLUTION + "\n# %%\n1 + 1\n")
    assert drifted(workbook, TASKS) == [
        "solutions/01_line.ipynb: differs from solutions/source/01_line.py",
        "exercises/01_line.ipynb: differs from solutions/source/01_line.py",
    ]


def test_edited_metadata_is_found(workbook: Path) -> None:
    """A tag taken off a cell is a difference too."""
    edited(
        workbook / "notebooks" / "01_line.ipynb",
        lambda notebook: notebook["cells"][1].update(metadata={"tags": ["mine"]}),
    )
    assert len(drifted(workbook, TASKS)) == 1


def test_edited_student_program_is_found(workbook: Path) -> None:
    """An answer left in the student's copy of a program is named."""
    written(workbook / "exercises" / "game.py", PROGRAM)
    assert drifted(workbook, TASKS) == ["exercises/game.py: differs from solutions/game.py"]


def test_outputs_are_compared_in_student_copies_only(workbook: Path) -> None:
    """What a notebook prints is for nbval to compare; a student copy holds no outputs at all."""
    outputs = [{"output_type": "stream", "name": "stdout", "text": "4\n"}]
    for folder in ("solutions", "exercises"):
        edited(
            workbook / folder / "01_line.ipynb",
            lambda nb: nb["cells"][1].update(outputs=outputs, execution_count=2),
        )
    [line] = drifted(workbook, TASKS)
    assert line == "exercises/01_line.ipynb: differs from solutions/source/01_line.py"


def test_missing_file_is_found_and_the_cure_is_named(workbook: Path) -> None:
    """A derived file that was never made, or deleted, is named with the command that makes it."""
    (workbook / "exercises" / "01_line.ipynb").unlink()
    assert drifted(workbook, TASKS) == [
        "exercises/01_line.ipynb: is missing; make it with workbook regenerate"
    ]


@pytest.mark.parametrize(
    "orphan",
    [
        "notebooks/02_old.ipynb",
        "solutions/02_old.ipynb",
        "exercises/02_old.ipynb",
        "exercises/old.py",
    ],
)
def test_orphan_is_found(workbook: Path, orphan: str) -> None:
    """A file in the folders of derived files that has no source is named."""
    written(workbook / orphan, "")
    assert drifted(workbook, TASKS) == [f"{orphan}: has no source"]


@pytest.mark.parametrize("text", ["no json", "[]", '{"cells": 3}', "{}"])
def test_notebook_that_cannot_be_read_is_found(workbook: Path, text: str) -> None:
    """A merge conflict in a notebook is a line in the list, not the end of the list."""
    written(workbook / "notebooks" / "01_line.ipynb", text)
    [line] = drifted(workbook, TASKS)
    assert line.startswith("notebooks/01_line.ipynb: cannot be read (")


def test_notebook_saved_by_a_front_end_without_changes_has_not_drifted(workbook: Path) -> None:
    """How the JSON is laid out does not matter: front ends write a list of lines."""
    path = workbook / "notebooks" / "01_line.ipynb"
    nbformat.write(nbformat.read(path, as_version=4), path)
    assert drifted(workbook, TASKS) == []


def test_solution_of_no_exercise_is_refused(workbook: Path) -> None:
    """A student copy cannot be made when nobody knows its tasks."""
    written(workbook / "solutions" / "source" / "09_new.py", SOLUTION)
    with pytest.raises(ValueError, match=r"solutions.source.09_new\.py: no exercise has this name"):
        drifted(workbook, TASKS)


def test_workbook_without_anything_has_nothing_drifted(tmp_path: Path) -> None:
    """An empty folder is no error."""
    assert drifted(tmp_path, TASKS) == []


def test_student_copy_is_never_run(workbook: Path) -> None:
    """A stub would only raise: its copy is written without outputs even when others run."""
    for file in derived_files(workbook, TASKS):
        if file.student_tasks is not None:
            assert file.text(run=True) == file.text(run=False)


def test_written_notebook_is_executed_and_has_not_drifted(workbook: Path) -> None:
    """The one run in a kernel: the file holds what the cells printed, with plain line ends."""
    path = workbook / "solutions" / "01_line.ipynb"
    Derived(path, workbook / "solutions" / "source" / "01_line.py").write()
    assert nbformat.read(path, as_version=4).cells[1].outputs[0].text == "4\n"
    assert b"\r" not in path.read_bytes()
    assert drifted(workbook, TASKS) == []

"""A course folder for nbgrader: the solutions as its source notebooks, with its metadata.

source/CHAPTER/CHAPTER.ipynb   answers between nbgrader's marks, checks locked
below each check               a cell a criterion, with its points and a hidden test

The hidden tests call our own judge, so that the points are those of ``workbook grade``. What
nbgrader has no form for is left behind: programs, which are no notebooks, and the wall, since it
runs answers in the kernel of the tests.
"""

from __future__ import annotations

import copy
import re
import secrets
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from lesson_code.course.fresh_copies import Files
from lesson_code.course.grading.check_task import LARGEST_SEED
from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercises
from lesson_code.course.grading.nbval_grading import CHECK_CALL
from lesson_code.course.grading.task import Task
from lesson_code.course.notebooks.root import require_instructors
from lesson_code.course.notebooks.sources import text_of
from lesson_code.course.notebooks.student_copy import marked_notebook

SCHEMA_VERSION = 3
BEGIN, END = "### BEGIN SOLUTION", "### END SOLUTION"

SECONDS_A_CELL = 120
"""A check cuts off a call after 3 s, or 15 s of the clock, once for each of up to 5 criteria."""

CONFIG = f"""\
c = get_config()
c.CourseDirectory.course_id = "collisions"
c.Execute.timeout = {SECONDS_A_CELL}
"""

TEST = """\
# {title}: {criterion} ({points} points). It is graded with calls that are not shown.
### BEGIN HIDDEN TESTS
from lesson_code.course.grading.check_task import check_criterion

check_criterion("{task}", {criterion!r}, {function}, seed={seed})
### END HIDDEN TESTS"""


def nbgrader_files(root: Path, names: Sequence[str] = ()) -> Files:
    """Return the files of a course folder that nbgrader makes assignments from.

    Parameters
    ----------
    root : Path
        The instructor's workbook.
    names : sequence of str
        Names or numbers of chapters; all if there are none.

    Raises
    ------
    ValueError
        There is no such exercise, it is a program, or the workbook is a student's copy.
    """
    require_instructors(root)
    chosen = [exercise_by_name(name) for name in names]
    for exercise in chosen:
        if exercise.suffix != ".ipynb":
            raise ValueError(f"{exercise.name} is a program, and nbgrader grades notebooks alone")
    chosen = chosen or [exercise for exercise in exercises() if exercise.suffix == ".ipynb"]
    files = {"nbgrader_config.py": CONFIG.encode()}
    for exercise in chosen:
        notebook = nbgrader_notebook(root, exercise, secrets.randbelow(LARGEST_SEED))
        files[f"source/{exercise.name}/{exercise.file_name}"] = text_of(notebook).encode()
    return files


def nbgrader_notebook(root: Path, exercise: Exercise, seed: int) -> Any:
    """Return the notebook of an exercise as nbgrader's source, graded with the inputs of a seed."""
    import nbformat

    solution: Any = nbformat.read(exercise.solution(root), as_version=4)  # type: ignore[no-untyped-call]
    notebook = marked_notebook(solution, exercise.task_ids, BEGIN, END)
    tasks = {task.id: task for task in exercise.tasks}
    answers = {task.function: task.id for task in exercise.tasks}
    cells: list[Any] = []
    for cell in notebook.cells:
        cells.append(cell)
        if cell.cell_type != "code":
            continue
        if BEGIN in cell.source:
            first = next(
                name for name in answers if re.search(rf"^def {name}\b", cell.source, re.M)
            )
            _mark(cell, f"answer-{_id(answers[first])}", solution=True)
        if check := CHECK_CALL.search(cell.source):
            _mark(cell, f"check-{_id(check[1])}", locked=True)
            cells += _tests(cell, tasks[check[1]], seed)
    notebook.cells = cells
    return notebook


def _tests(check: Any, task: Task, seed: int) -> Iterator[Any]:
    """Yield a cell for each criterion of a task."""
    for number, criterion in enumerate(task.criteria, start=1):
        cell = copy.deepcopy(check)
        cell.id = f"{check.id}-{number}"
        cell.metadata.pop("tags", None)
        cell.source = TEST.format(
            title=task.title,
            task=task.id,
            function=task.function,
            criterion=criterion.name,
            points=criterion.points,
            seed=seed,
        )
        name = f"test-{_id(task.id)}-{number}"
        yield _mark(cell, name, locked=True, grade=True, points=criterion.points)


def _mark(cell: Any, name: str, **roles: Any) -> Any:
    """Give a cell nbgrader's metadata, and return it."""
    none = dict.fromkeys(("grade", "solution", "locked", "task"), False)
    cell.metadata["nbgrader"] = none | roles | {"grade_id": name, "schema_version": SCHEMA_VERSION}
    return cell


def _id(task: str) -> str:
    """Return a task's number as nbgrader's names may hold it."""
    return task.replace(".", "-")

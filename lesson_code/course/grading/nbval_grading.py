"""Grading under nbval: the student's answers laid into the instructor's executed notebook.

The solution's check cells hold the outputs of a run with full marks. With the student's answers
in place of the solution's, such a cell reproduces its output only if the answer has full marks.
The student's code runs in a Jupyter kernel, with no isolation at all.
"""

from __future__ import annotations

import json
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.submission import Submission, SubmissionError
from lesson_code.course.notebooks.nbval_run import Watcher, run_notebooks
from lesson_code.course.notebooks.root import require_instructors

CHECK_CALL = re.compile(r"""check_task\(\s*["']([\w.]+)["']""")

CELL_SECONDS = 20
"""A check cuts off each call of an answer after 3 s, and stops at the first that hangs."""

BEFORE = """\
from contextlib import ExitStack

from lesson_code.course.grading.in_process import kept_apart

answers_alone = ExitStack()
answers_alone.enter_context(kept_apart())
"""
"""Stands before the answers in a merged notebook: imports of lesson_code fail in them."""

AFTER = """\
answers_alone.close()

from lesson_code.course.grading import check_task
"""
"""Stands behind them: they may not replace the check."""


@dataclass(frozen=True)
class TaskOutcome:
    """Whether a task's check cell reproduced the output of full marks."""

    task: str
    function: str
    passed: bool


def merge(submission: Submission, exercise: Exercise, root: Path) -> dict[str, Any]:
    """Return the solution notebook with a student's code in place of all its own.

    Of the solution's cells only texts and checks remain: an answer must not depend on its imports.

    Raises
    ------
    SubmissionError
        The exercise is a program, and has no notebook.
    ValueError
        The workbook is a student's copy, without solutions.
    """
    if exercise.suffix != ".ipynb":
        raise SubmissionError(f"{exercise.name} is a program: grade it without nbval")
    require_instructors(root)
    notebook = json.loads(exercise.solution(root).read_text(encoding="utf-8"))
    cells = [
        cell
        for cell in notebook["cells"]
        if cell["cell_type"] != "code" or _has_tag(cell, "check") or _has_tag(cell, "task")
    ]
    first = next(number for number, cell in enumerate(cells) if _has_tag(cell, "task"))
    kept = [cell for cell in cells if not _has_tag(cell, "task")]
    return {**notebook, "cells": [*kept[:first], *_answer_cells(submission), *kept[first:]]}


def _has_tag(cell: dict[str, Any], tag: str) -> bool:
    """Return whether a cell has a tag."""
    return tag in cell["metadata"].get("tags", [])


def _answer_cells(submission: Submission) -> list[dict[str, Any]]:
    """Return a student's code as cells, between the two that keep it apart."""
    answers = [source for unit in submission.units for source in unit.kept_sources]
    return [
        {
            "cell_type": "code",
            "execution_count": None,
            "id": f"answer-{number}",
            "metadata": {"tags": ["answer"]},
            "outputs": [],
            "source": source,
        }
        for number, source in enumerate([BEFORE, *answers, AFTER])
    ]


def grade_under_nbval(
    submission: Submission, exercise: Exercise, root: Path, watcher: Watcher | None = None
) -> list[TaskOutcome]:
    """Return for each task whether its check cell passes under ``pytest --nbval-lax``."""
    merged = merge(submission, exercise, root)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "merged.ipynb"
        path.write_text(json.dumps(merged), encoding="utf-8")
        results = run_notebooks([path], lax=True, cell_seconds=CELL_SECONDS, watcher=watcher)
    passed = {result.cell for result in results if result.passed}
    functions = {task.id: task.function for task in exercise.tasks}
    return [
        TaskOutcome(task, functions[task], cell in passed)
        for cell, task in _check_cells(merged).items()
    ]


def _check_cells(notebook: dict[str, Any]) -> dict[int, str]:
    """Return the task of each check cell, by its number among the code cells."""
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    return {
        number: found.group(1)
        for number, cell in enumerate(code)
        if _has_tag(cell, "check") and (found := CHECK_CALL.search("".join(cell["source"])))
    }

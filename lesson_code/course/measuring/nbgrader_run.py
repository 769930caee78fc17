"""nbgrader on the same tasks: the solution in its form, with the same inputs as assertions.

nbgrader is no dependency. It is measured where it is installed: in this Python's environment, or as
the command that WORKBOOK_NBGRADER names.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from itertools import count
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.grading.task import ANSWER_TOLERANCE, Task
from lesson_code.course.grading.verdict import drawn

ASSIGNMENT = "ps1"
CONFIG = "c = get_config()\nc.CourseDirectory.course_id = 'collisions'\n"


def command() -> str | None:
    """Return the nbgrader command, or None if there is none."""
    named = os.environ.get("WORKBOOK_NBGRADER")
    beside = Path(sys.executable).with_name("nbgrader")
    return named or (str(beside) if beside.exists() else shutil.which("nbgrader"))


def missing() -> str | None:
    """Return why nbgrader is not measured, if it is not."""
    return None if command() else "not installed (pip install nbgrader)"


class Course:
    """A course of one assignment in a folder, for nbgrader to grade."""

    def __init__(self, folder: Path, solution: Path, exercise: Exercise, seed: int) -> None:
        self._folder = folder
        self._students = count(1)
        self._notebook = json.dumps(_notebook(solution, exercise, seed))
        (folder / "nbgrader_config.py").write_text(CONFIG)
        self._write(folder / "source" / ASSIGNMENT)
        self._run("generate_assignment", ASSIGNMENT, "--create")

    def _write(self, folder: Path) -> None:
        """Write the notebook into a folder."""
        folder.mkdir(parents=True)
        (folder / "answers.ipynb").write_text(self._notebook, encoding="utf-8")

    def _run(self, *arguments: str) -> None:
        """Run nbgrader, in silence."""
        program = command() or "nbgrader"
        others = os.pathsep.join((str(Path(program).parent), os.environ.get("PATH", "")))
        ran = subprocess.run(  # noqa: S603 - the command the user has installed
            [program, *arguments],
            cwd=self._folder,
            env=os.environ | {"PATH": others, "PYTHONPATH": ""},  # it calls programs beside it
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            check=False,
        )
        if ran.returncode:
            raise RuntimeError(f"nbgrader failed: {ran.stderr.decode(errors='replace')[-500:]}")

    def grade(self, students: int) -> tuple[int, float, float]:
        """Grade some new students: how many, in what time, s, and for what CPU time, s."""
        for _ in range(students):
            self._write(self._folder / "submitted" / f"s{next(self._students)}" / ASSIGNMENT)
        before, began = _children_cpu(), time.perf_counter()
        self._run("autograde", ASSIGNMENT)
        return students, time.perf_counter() - began, _children_cpu() - before


def _children_cpu() -> float:
    """Return the processor's time of all ended children, s."""
    times = os.times()
    return times.children_user + times.children_system


def _notebook(solution: Path, exercise: Exercise, seed: int) -> dict[str, Any]:
    """Return the solution as nbgrader's own form of notebook."""
    answers = [s for unit in read_submission(solution).units for s in unit.kept_sources]
    cells = [_cell("import numpy as np", "imports")]
    cells += [_cell(source, f"answer-{n}") for n, source in enumerate(answers)]
    cells += [
        _cell(_test_of(task, seed), f"test-{task.id}", task.points) for task in exercise.tasks
    ]
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return {
        "cells": cells,
        "metadata": {"kernelspec": kernel},
        "nbformat": 4,
        "nbformat_minor": 5,
    }


def _cell(source: str, name: str, points: int | None = None) -> dict[str, Any]:
    """Return a code cell; with points, one whose assertions nbgrader runs."""
    name = name.replace(".", "-")
    grade = {
        "grade": True,
        "grade_id": name,
        "locked": True,
        "points": points,
        "schema_version": 3,
        "solution": False,
        "task": False,
    }
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": name,
        "metadata": {"nbgrader": grade} if points else {},
        "outputs": [],
        "source": source,
    }


def _test_of(task: Task, seed: int) -> str:
    """Return assertions with the inputs that our grader draws."""
    cases = [case for criterion in task.criteria for case in drawn(task, criterion, seed)]
    return (
        f"for arguments, expected in {cases!r}:\n"
        f"    got = {task.function}(*arguments)\n"
        f"    assert np.allclose(got, expected, rtol={ANSWER_TOLERANCE}, atol={ANSWER_TOLERANCE})"
    )

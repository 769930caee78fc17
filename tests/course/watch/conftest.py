"""What the tests of ``workbook watch`` share: a workbook with one exercise, and a session in it."""

from __future__ import annotations

import io
import json
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from rich.console import Console

from lesson_code.course.grading.exercises import exercise_by_name
from lesson_code.course.grading.grader import Grader
from lesson_code.course.watch import Screen, WatchSession

ONE, BILLIARDS = exercise_by_name("01"), exercise_by_name("billiards")
STUB = 'raise NotImplementedError("Task 1.1: elastic_1d")'
ANSWERS = {
    "right": "c = (m1 * v1 + m2 * v2) / (m1 + m2)\n    return 2 * c - v1, 2 * c - v2",
    "swaps": "return v2, v1",
    "stub": STUB,
}
"""Bodies of task 1.1."""


@dataclass
class Desk:
    """A student's workbook, and a session that watches it."""

    root: Path
    session: WatchSession
    written: io.StringIO

    def save(self, answer: str) -> None:
        """Write an answer to task 1.1 into the exercise, and let the session see it."""
        self.save_text(f"def elastic_1d(m1, v1, m2, v2):\n    {ANSWERS[answer]}\n")

    def save_text(self, text: str) -> None:
        """Write the exercise, and let the session see it."""
        path = ONE.student_copy(self.root)
        cells = [{"cell_type": "code", "source": text, "metadata": {}}]
        path.write_text(json.dumps({"cells": cells, "metadata": {}}), encoding="utf-8")
        self.session.saved(ONE)

    def said(self) -> str:
        """Return what was written since the last call."""
        text = self.written.getvalue()
        self.written.seek(0)
        self.written.truncate()
        return text


@pytest.fixture
def make_desk(root: Path, tmp_path: Path, grader: Grader) -> Callable[..., Desk]:
    """Return a function that opens a session in a workbook with exercise 01 and billiards."""

    def make(*, plain: bool = True) -> Desk:
        for exercise in (ONE, BILLIARDS):
            for path in (exercise.student_copy(root), exercise.solution(root)):
                copy = tmp_path / path.relative_to(root)
                copy.parent.mkdir(exist_ok=True)
                if not copy.exists():
                    shutil.copy(path, copy)
        written = io.StringIO()
        console = Console(file=written, width=80, force_terminal=not plain)
        screen = Screen(console, plain=plain)
        return Desk(tmp_path, WatchSession(tmp_path, (ONE, BILLIARDS), grader, screen), written)

    return make

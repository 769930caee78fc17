"""An exercise put back to its beginning, with what was written kept beside it."""

from __future__ import annotations

from pathlib import Path

from lesson_code.course.fresh_copies import fresh_exercise
from lesson_code.course.grading.exercises import Exercise

BACKUPS = "backups"
"""Folder beside the exercises that holds what was there before a reset."""


def put_back(exercise: Exercise, root: Path) -> Path | None:
    """Put an exercise back, and return where its backup stands; None if there was no file.

    Raises
    ------
    FileNotFoundError
        The workbook has neither the solution nor a fresh copy of the exercise.
    """
    path = exercise.student_copy(root)
    fresh = fresh_exercise(exercise, root)
    backup = None
    if path.exists():
        backup = _free_name(path)
        backup.parent.mkdir(exist_ok=True)
        path.replace(backup)
    path.write_text(fresh, encoding="utf-8", newline="\n")
    return backup


def _free_name(path: Path) -> Path:
    """Return where a backup may stand: no earlier one is overwritten."""
    folder, number = path.parent / BACKUPS, 1
    while (folder / f"{path.stem}-{number}{path.suffix}").exists():
        number += 1
    return folder / f"{path.stem}-{number}{path.suffix}"

"""An exercise put back: as it was given out, and with nothing lost."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from lesson_code.course.fresh_copies import KEPT_EXERCISES
from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.watch.reset import put_back


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_exercise_put_back_is_what_was_given_out(
    exercise: Exercise, root: Path, tmp_path: Path
) -> None:
    """Made from the solution, it is the committed student copy to the last byte."""
    solution = exercise.solution(tmp_path)
    solution.parent.mkdir()
    exercise.student_copy(tmp_path).parent.mkdir()
    shutil.copy(exercise.solution(root), solution)
    assert put_back(exercise, tmp_path) is None
    assert exercise.student_copy(tmp_path).read_bytes() == exercise.student_copy(root).read_bytes()


def test_every_reset_keeps_a_backup_of_its_own(tmp_path: Path) -> None:
    """No earlier one is overwritten; the fresh copy of a student's workbook needs no solution."""
    exercise = exercises()[-1]
    fresh = tmp_path / KEPT_EXERCISES / exercise.file_name
    path = exercise.student_copy(tmp_path)
    for folder in (fresh.parent, path.parent):
        folder.mkdir(parents=True)
    fresh.write_text("fresh")
    backups = []
    for text in ("first", "second"):
        path.write_text(text)
        backups.append(put_back(exercise, tmp_path))
        assert path.read_text() == "fresh"
    assert [backup and backup.read_text() for backup in backups] == ["first", "second"]


def test_reset_without_solution_or_fresh_copy_leaves_the_file(tmp_path: Path) -> None:
    """What cannot be put back is not taken away."""
    path = exercises()[0].student_copy(tmp_path)
    path.parent.mkdir()
    path.write_text("mine")
    with pytest.raises(FileNotFoundError):
        put_back(exercises()[0], tmp_path)
    assert path.read_text() == "mine"

"""Golden submissions of chapters 04 to 09: right, partly right and wrong; and nbval agrees."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from lesson_code.grading.exercises import exercise_by_name
from lesson_code.grading.grader import grade
from lesson_code.grading.nbval_grading import grade_under_nbval
from lesson_code.grading.submission import read_submission

FOLDER = Path(__file__).parent / "golden" / "chapters"
TABLE: dict[str, dict[str, Any]] = tomllib.loads((FOLDER / "chapters.toml").read_text())
CHAPTERS = ("04", "05", "06", "07", "08", "09")


def full_points(name: str) -> list[int]:
    """Return the full mark of each task of the exercise that a file answers."""
    return [task.points for task in exercise_by_name(TABLE[name]["exercise"]).tasks]


def test_golden_chapters_each_have_a_right_a_partly_right_and_a_wrong_submission() -> None:
    """Every file has its entry, every chapter one of each kind, and right means full marks."""
    assert {p.name for p in FOLDER.iterdir() if p.suffix in (".py", ".ipynb")} == set(TABLE)
    kinds = {(entry["exercise"], name.split("_")[0]) for name, entry in TABLE.items()}
    assert kinds == {(c, kind) for c in CHAPTERS for kind in ("right", "partly", "wrong")}
    for name in TABLE:
        assert (TABLE[name]["points"] == full_points(name)) == name.startswith("right_")


@pytest.mark.parametrize("name", TABLE)
def test_golden_chapter_submission_earns_its_points_and_its_hints(name: str) -> None:
    """Each task earns exactly its points, and each common mistake is recognised as itself."""
    report = grade(FOLDER / name, exercise=TABLE[name]["exercise"], seed=7)
    assert [verdict.points for verdict in report.verdicts] == TABLE[name]["points"]
    found = [verdict.recognised.name if verdict.recognised else "" for verdict in report.verdicts]
    assert found == TABLE[name]["hints"]


@pytest.mark.parametrize("name", TABLE)
def test_nbval_agrees_on_golden_chapter_submission(name: str, root: Path) -> None:
    """Under nbval exactly the tasks with full marks pass."""
    exercise = exercise_by_name(TABLE[name]["exercise"])
    outcomes = grade_under_nbval(read_submission(FOLDER / name), exercise, root)
    earned = zip(TABLE[name]["points"], full_points(name), strict=True)
    assert [outcome.passed for outcome in outcomes] == [got == full for got, full in earned]

"""Golden submissions: each earns what it should, and leaves the next one alone."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from lesson_code.course.grading.exercises import exercise_by_name
from lesson_code.course.grading.grader import Grader, grade
from lesson_code.course.isolation import Limits

FOLDER = Path(__file__).parents[1] / "golden"
TABLE: dict[str, dict[str, Any]] = tomllib.loads((FOLDER / "golden.toml").read_text())
RIGHT = "right_notebook.ipynb"
SEED_OF_HARD_CODED = 1
"""The seed whose answers hard_coded.py has learnt by heart."""
HARD_CODED = "hostile/hard_coded.py"


@pytest.fixture(scope="module")
def graders() -> Iterator[Callable[[dict[str, Any]], Grader]]:
    """Return a function that returns a grader with some limits: one for all that have the same."""
    with ExitStack() as stack:

        @cache
        def started(limits: Limits) -> Grader:
            return stack.enter_context(Grader(limits=limits))

        yield lambda limits: started(Limits(**limits))


def test_golden_table_lists_every_file_and_no_other() -> None:
    """Each committed submission has its expected points, and each entry its file."""
    files = {
        path.relative_to(FOLDER).as_posix()
        for path in FOLDER.rglob("*")
        if path.suffix in (".py", ".ipynb")
    }
    assert files == set(TABLE)


def test_golden_submissions_of_every_chapter_are_right_partly_right_and_wrong() -> None:
    """Each chapter from 04 has one of each kind, and only those that are right have full marks."""
    kinds = set()
    for name in (name for name in TABLE if name.startswith("chapters/")):
        exercise = exercise_by_name(TABLE[name]["exercise"])
        kind = Path(name).name.split("_")[0]
        kinds.add((exercise.name[:2], kind))
        points = TABLE[name]["points"]
        full = [task.points for task in exercise.tasks[: len(points)]]
        assert (points == full) == (kind == "right")
    chapters = ("04", "05", "06", "07", "08", "09")
    assert kinds == {(c, kind) for c in chapters for kind in ("right", "partly", "wrong")}


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", TABLE)
def test_golden_submission_earns_its_points_and_the_next_one_too(
    name: str, graders: Callable[[dict[str, Any]], Grader]
) -> None:
    """A submission earns exactly its points; a right one that follows a bad one, all of them."""
    expected = TABLE[name]
    grader = graders(expected.get("limits", {}))
    report = grader.grade(FOLDER / name, exercise=expected["exercise"], seed=7)
    earned, points = [verdict.points for verdict in report.verdicts], expected["points"]
    assert earned == points + [0] * (len(earned) - len(points))
    hints = [verdict.recognised.name for verdict in report.verdicts if verdict.recognised]
    assert hints == expected.get("hints", [])
    if expected["under_nbval"] != "agrees":
        assert grader.grade(FOLDER / RIGHT, seed=7).points == sum(TABLE[RIGHT]["points"])


def test_golden_hard_coded_answers_are_right_for_one_seed_alone() -> None:
    """Answers learnt by heart are right with the seed they were learnt from, and no other."""
    learnt = grade(FOLDER / HARD_CODED, exercise="01", seed=SEED_OF_HARD_CODED)
    assert learnt.is_full
    assert not grade(FOLDER / HARD_CODED, exercise="01", seed=SEED_OF_HARD_CODED + 1).is_full


def test_golden_marks_are_the_same_twice() -> None:
    """Graded again with the same seed, a submission gets the same report, word for word."""
    for name in ("wrong_model.ipynb", "raises.ipynb", "no_answers_of_the_right_kind.py"):
        path, exercise = FOLDER / name, TABLE[name]["exercise"]
        first, second = (grade(path, exercise=exercise, seed=7).as_dict() for _ in range(2))
        assert first == second

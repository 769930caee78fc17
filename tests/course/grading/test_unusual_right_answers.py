"""Right answers written by hand in unusual ways: full marks across the wall, or a reason."""

from __future__ import annotations

import pytest
from course.grading.unusual_right_answers import LACKING, RIGHT, Unusual

from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.verdict import Verdict

from ..conftest import Write

FEWEST = 40
"""Right answers by hand that the course promises to have tried."""

SEED = 23
"""Any; the answers are right for all."""

EXERCISE_OF = {task.id: exercise.name for exercise in exercises() for task in exercise.tasks}


def verdict_of(unusual: Unusual, grader: Grader, write: Write) -> Verdict:
    """Return what an answer earns as a submission of its own."""
    path = write("answer.py", unusual.source)
    report = grader.grade(path, exercise=EXERCISE_OF[unusual.task], seed=SEED)
    assert report.notes == ()
    return next(verdict for verdict in report.verdicts if verdict.task.id == unusual.task)


def named(unusual: Unusual) -> str:
    """Return what pytest calls an answer."""
    return f"{unusual.task} {unusual.way}"


@pytest.mark.one_in(3)
@pytest.mark.parametrize("unusual", RIGHT, ids=named)
def test_unusual_right_answer_earns_full_marks(
    unusual: Unusual, grader: Grader, write: Write
) -> None:
    """However it is written, what is right has full marks, and nothing is said of it."""
    verdict = verdict_of(unusual, grader, write)
    assert verdict.lines == [verdict.line]
    assert verdict.is_full


@pytest.mark.parametrize("unusual", LACKING, ids=named)
def test_right_answer_that_lacks_something_is_told_what(
    unusual: Unusual, grader: Grader, write: Write
) -> None:
    """What is right but for its form or its digits loses points, and the message says why."""
    verdict = verdict_of(unusual, grader, write)
    assert verdict.points < verdict.task.points
    assert unusual.says in " ".join(verdict.lines)


def test_unusual_right_answers_are_forty_over_most_chapters() -> None:
    """The table has the number that is promised, no way twice, and all chapters but a few."""
    assert len({named(unusual) for unusual in RIGHT}) == len(RIGHT) >= FEWEST
    assert {f"{chapter}." for chapter in range(1, 12)} <= {
        f"{unusual.task.partition('.')[0]}." for unusual in RIGHT
    }

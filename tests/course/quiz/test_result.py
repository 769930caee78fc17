"""The result: counts by chapter, and a form that JSON can hold."""

from __future__ import annotations

import json

from lesson_code.course.quiz.result import ChapterScore, QuestionResult, QuizResult

RESULT = QuizResult(
    (
        QuestionResult("01", "01-a", answers=("b",), right=True),
        QuestionResult("01", "01-b", answers=("1", "2"), right=True),
        QuestionResult("02", "02-a", answers=("c", "d"), right=False),
    ),
    finished=True,
)


def test_scores_count_by_chapter() -> None:
    """A question right at the second try counts as right, not as right first time."""
    assert RESULT.scores == (ChapterScore("01", 2, 1, 2), ChapterScore("02", 1, 0, 0))


def test_one_wrong_answer_is_not_right_first_time() -> None:
    """A quiz that broke off after one wrong answer counts the question as asked and wrong."""
    broken_off = QuizResult((QuestionResult("01", "01-a", ("c",), right=False),), finished=False)
    assert broken_off.scores == (ChapterScore("01", 1, 0, 0),)


def test_as_dict_survives_json() -> None:
    """The dictionary is versioned and comes back from JSON unchanged."""
    written = RESULT.as_dict()
    assert json.loads(json.dumps(written)) == written
    assert written["version"] == 1
    assert written["finished"] is True
    assert written["chapters"][0] == {"chapter": "01", "asked": 2, "right_first": 1, "right": 2}
    assert written["questions"][1] == {
        "chapter": "01",
        "id": "01-b",
        "answers": ["1", "2"],
        "right": True,
        "right_first": False,
    }

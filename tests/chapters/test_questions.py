"""The questions themselves: every number in the bank, worked out again without the bank.

The answers to a chapter's quiz stand in its folder here, in ``quiz_answers.py``.
"""

from __future__ import annotations

import runpy
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from lesson_code.course.quiz.bank import load_bank
from lesson_code.course.quiz.questions import ArrowQuestion, ChoiceQuestion, NumericQuestion

QUESTIONS = {
    question.id: question
    for quiz in load_bank()
    for question in (*quiz.questions, *quiz.predictions)
}
ARROWS = {key: q for key, q in QUESTIONS.items() if isinstance(q, ArrowQuestion)}
NUMERIC = {key: q for key, q in QUESTIONS.items() if isinstance(q, NumericQuestion)}
CHOICE = {key: q for key, q in QUESTIONS.items() if isinstance(q, ChoiceQuestion)}

TABLES = [
    runpy.run_path(str(path)) for path in sorted(Path(__file__).parent.glob("*/quiz_answers.py"))
]
ANSWERS: dict[str, tuple[Fraction | float, list[Fraction | float]]] = {
    key: answer for table in TABLES for key, answer in table["ANSWERS"].items()
}
RIGHT_OPTIONS: dict[str, str] = {
    key: said for table in TABLES for key, said in table.get("RIGHT_OPTIONS", {}).items()
}

TIPS: dict[str, tuple[Any, list[Any]]] = {
    key: answer for table in TABLES for key, answer in table.get("TIPS", {}).items()
}

ROUNDING = 1e-12
"""The bank writes a number to 16 digits; nothing else may separate it from the answer here."""

LONGEST_OPTION = 90
"""Characters: radio buttons do not wrap, and a notebook's page has room for no more."""


def test_numeric_questions_all_have_an_independent_answer() -> None:
    """No numeric question of the bank escapes the tables of the chapters."""
    assert set(ANSWERS) == set(NUMERIC)


@pytest.mark.parametrize("key", ANSWERS)
def test_value_equals_independent_answer(key: str) -> None:
    """The bank's answer is what exact arithmetic gives."""
    assert abs(NUMERIC[key].value - ANSWERS[key][0]) <= ROUNDING


@pytest.mark.parametrize("key", ANSWERS)
def test_wrong_values_equal_the_mistakes_they_are_named_for(key: str) -> None:
    """Each recognised wrong value is what its mistake gives, in exact arithmetic."""
    in_bank = [wrong.value for wrong in NUMERIC[key].wrong_values]
    assert len(in_bank) == len(ANSWERS[key][1])
    assert all(
        abs(w - x) <= ROUNDING for w, x in zip(in_bank, map(float, ANSWERS[key][1]), strict=True)
    )


def test_arrows_all_have_an_independent_answer() -> None:
    """Their tips, and those of the mistakes, are worked out in the chapters' tables as well."""
    assert set(TIPS) == set(ARROWS)
    for key, (tip, wrong_tips) in TIPS.items():
        assert ARROWS[key].value == tip
        assert [wrong.value for wrong in ARROWS[key].wrong_values] == wrong_tips


@pytest.mark.parametrize("key", RIGHT_OPTIONS)
def test_right_option_says(key: str) -> None:
    """The lesson's own questions are in the bank, with the answer the lesson gives."""
    assert RIGHT_OPTIONS[key] in CHOICE[key].right_option.text


def test_chapters_ask_four_to_six_questions_with_a_number_from_chapter_01_on() -> None:
    """Each chapter has four to six questions, and after the first one at least one number."""
    for quiz in load_bank():
        assert 4 <= len(quiz.questions) <= 6
        kinds = {type(question) for question in quiz.questions}
        assert NumericQuestion in kinds


def test_option_texts_fit_on_a_line() -> None:
    """No option is longer than a radio button's line."""
    texts = [option.text for question in CHOICE.values() for option in question.options]
    assert max(map(len, texts)) <= LONGEST_OPTION


def test_texts_hold_no_markup() -> None:
    """The same text is read in a terminal and in a notebook, so it has no Markdown or TeX."""
    for quiz in load_bank():
        assert not set(repr(quiz)) & set("`$*#\\")


def test_right_options_do_not_give_themselves_away() -> None:
    """Every letter up to d is right somewhere, and none more than half of the time."""
    answers = [question.answer for question in CHOICE.values()]
    assert set("abcd") <= set(answers)
    assert max(answers.count(letter) for letter in answers) <= len(answers) / 2

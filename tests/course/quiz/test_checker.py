"""The checker: what is right, what is a known mistake, and what is no answer at all."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from lesson_code.course.quiz.bank import load_bank
from lesson_code.course.quiz.checker import (
    CheckedAnswer,
    check_answer,
    expected_answer,
    right_answer,
)
from lesson_code.course.quiz.questions import (
    ArrowQuestion,
    ChoiceQuestion,
    NumericQuestion,
    Option,
    WrongValue,
)

CHOICE = ChoiceQuestion(
    id="07-side",
    text="Left or right?",
    options=(Option("Left", "Why left?"), Option("Right", "It is."), Option("Up", "Why up?")),
    answer="b",
)
HEIGHT = NumericQuestion(
    id="07-height",
    text="How high?",
    unit="kg m/s",
    value=-0.81,
    tolerance=0.001,
    right_feedback="Yes.",
    wrong_values=(WrongValue(0.81, "The sign?"),),
    wrong_feedback="Think again.",
)
ARROW = ArrowQuestion(
    id="03-arrow",
    text="Draw it.",
    unit="m/s",
    spacing=1.0,
    reach=3.0,
    value=(2.0, -1.0),
    right_feedback="Yes.",
    wrong_values=(WrongValue((0.0, 0.0), "Nothing moves?"),),
    wrong_feedback="No.",
    given={"v": (0.0, -2.0)},
)
RATIO = NumericQuestion("07-e", "e?", "", 0.5, 0.01, "Yes.", (), "No.")


@pytest.mark.parametrize("answer", ["b", "B", " b ", "b)", "b."])
def test_choice_right_letter_in_any_form(answer: str) -> None:
    """The right letter is right in either case, with spaces or a bracket."""
    assert check_answer(CHOICE, answer) == CheckedAnswer(True, "It is.")


@pytest.mark.parametrize(("answer", "feedback"), [("a", "Why left?"), ("C", "Why up?")])
def test_choice_wrong_letter_gets_its_own_feedback(answer: str, feedback: str) -> None:
    """Each wrong option answers with its own feedback."""
    assert check_answer(CHOICE, answer) == CheckedAnswer(False, feedback)


@pytest.mark.parametrize("answer", ["", " ", "d", "e", "ab", "1", 1, None, True, "b b"])
def test_choice_unreadable_says_which_letters_are_expected(answer: object) -> None:
    """What is no letter of the options is refused, and is not a wrong answer."""
    with pytest.raises(ValueError, match=r"the answer must be a letter from a to c, got"):
        check_answer(CHOICE, answer)


@pytest.mark.parametrize(
    "answer",
    [
        -0.81,
        -0.8105,
        Fraction(-81, 100),
        np.float64(-0.81),
        "-0.81",
        "-0,81",
        "-.81",
        "-,81",
        "-8.1e-1",
        " -0.81 ",
        "\N{MINUS SIGN}0.81",
        "\N{EN DASH}0.81",
        "-0.81 kg m/s",
        "-0,81kg·m/s",
        "-0.81 kg*m/s",
    ],
)
def test_number_right_in_any_form(answer: object) -> None:
    """A number is right as a number or as text, with either decimal mark, with its unit or not."""
    assert check_answer(HEIGHT, answer) == CheckedAnswer(True, "Yes.")


@pytest.mark.parametrize("answer", [0, 1, "1", "+1.", "1e0"])
def test_number_wrong_gets_the_general_feedback(answer: object) -> None:
    """A number that no mistake is known for gets the question's general feedback."""
    assert check_answer(HEIGHT, answer) == CheckedAnswer(False, "Think again.")


def test_number_of_a_known_mistake_gets_its_feedback() -> None:
    """A recognised wrong value gets the feedback of its mistake."""
    assert check_answer(HEIGHT, "0.8105 kg m/s") == CheckedAnswer(False, "The sign?")


@pytest.mark.parametrize(
    "answer",
    [
        "",
        " ",
        "nan",
        "inf",
        "-inf",
        "1e999",
        "high",
        "0.8.1",
        "1/2",
        "0.81 m",
        "kg m/s",
        "0x1",
        "１",  # noqa: RUF001 - a full-width digit is meant
        "0.81 kg m/s or so",
        math.nan,
        math.inf,
        10**400,
        True,
        None,
        1j,
        Decimal("0.81"),
        [0.81],
        b"0.81",
    ],
)
def test_number_unreadable_says_what_is_expected(answer: object) -> None:
    """What is no finite number in the question's unit is refused, and is not a wrong answer."""
    with pytest.raises(ValueError, match=r"the answer must be a number in kg m/s, such as"):
        check_answer(HEIGHT, answer)


def test_pure_number_refuses_a_unit() -> None:
    """A question without a unit takes none."""
    with pytest.raises(ValueError, match=r"the answer must be a number, such as 0.25, got '0.5 m'"):
        check_answer(RATIO, "0.5 m")


def test_unreadable_answer_is_quoted_in_part_only() -> None:
    """An answer of a million characters does not fill the screen."""
    with pytest.raises(ValueError, match="got 'xxx") as caught:
        check_answer(RATIO, "x" * 1_000_000)
    assert len(str(caught.value)) < 200


def test_expected_answer_names_letters_or_unit() -> None:
    """What is asked for is said in the question's own letters or unit."""
    assert expected_answer(CHOICE) == "a letter from a to c"
    assert expected_answer(HEIGHT) == "a number in kg m/s"
    assert expected_answer(RATIO) == "a number"


def test_right_answer_is_accepted_for_every_question_of_the_bank() -> None:
    """The answer that is told after the last try is itself right."""
    for chapter in load_bank():
        for question in (*chapter.questions, *chapter.predictions):
            told = right_answer(question)
            answer = told[0] if isinstance(question, ChoiceQuestion) else told
            assert check_answer(question, answer) == CheckedAnswer(True, question.right_feedback)


def test_every_wrong_answer_of_the_bank_gets_its_own_feedback() -> None:
    """Each distractor and each recognised value of the bank leads to its own feedback."""
    for chapter in load_bank():
        for question in (*chapter.questions, *chapter.predictions):
            if isinstance(question, ChoiceQuestion):
                wrong = {k: o.feedback for k, o in question.lettered if k != question.answer}
            else:
                wrong = {repr(w.value): w.feedback for w in question.wrong_values}
            for answer, feedback in wrong.items():
                assert check_answer(question, answer) == CheckedAnswer(False, feedback)


@pytest.mark.parametrize(
    ("written", "right"),
    [
        ("2, -1", True),
        (" (2; -1) ", True),
        ("2 \N{MINUS SIGN}1", True),
        ("2,2 -0,8", True),
        ("-1, 2", False),
        ("2.6, -1", False),
        ("1e300, 0", False),
    ],
)
def test_arrow_is_judged_by_the_crossing_at_its_tip(written: str, right: bool) -> None:
    """Components with a point or a comma; the crossing of the grid that is nearest counts."""
    assert check_answer(ARROW, written).right is right


def test_recognised_arrow_gets_its_own_feedback() -> None:
    """Another arrow gets the words for any other."""
    assert check_answer(ARROW, "0, 0").feedback == "Nothing moves?"
    assert check_answer(ARROW, "3, 3").feedback == "No."


@pytest.mark.parametrize("written", ["", "2", "2,-1", "1, 2, 3", "east", "nan, 1", "1e999, 0"])
def test_arrow_that_cannot_be_read_is_refused(written: str) -> None:
    """It needs two numbers with a space between them."""
    with pytest.raises(ValueError, match="the arrow's x and y in m/s, such as 1, -2, got"):
        check_answer(ARROW, written)

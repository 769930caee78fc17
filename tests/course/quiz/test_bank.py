"""The bank: what loads, and what each broken bank is refused for."""

from __future__ import annotations

import math
from typing import Any

import pytest

from lesson_code.course.quiz.bank import chapter_numbers, load_bank, load_quiz, read_quiz
from lesson_code.course.quiz.questions import (
    ArrowQuestion,
    ChoiceQuestion,
    NumericQuestion,
    Option,
    WrongValue,
)

CHOICE = """
[[question]]
id = "07-side"
kind = "choice"
text = "Left or right?"
[[question.option]]
text = "Left"
feedback = "Why left?"
[[question.option]]
text = "Right"
right = true
feedback = "It is right."
"""

NUMBER = """
[[question]]
id = "07-sum"
kind = "numeric"
text = "1 m + 1 m?"
unit = "m"
value = 2
tolerance = 0.1
right_feedback = "Two."
wrong_feedback = "Add them."
[[question.wrong_value]]
value = 1.0
feedback = "That is one of them."
"""

SOUND = f'title = "Sums"\n{CHOICE}{NUMBER}'


def test_sound_text_gives_its_questions_in_order() -> None:
    """A file's questions come as typed objects in the order of the file."""
    chapter = read_quiz("07", SOUND)
    side, number = chapter.questions
    assert (chapter.number, chapter.title) == ("07", "Sums")
    assert isinstance(side, ChoiceQuestion)
    assert isinstance(number, NumericQuestion)
    assert (side.answer, side.right_feedback) == ("b", "It is right.")
    assert (number.value, number.tolerance, number.unit) == (2.0, 0.1, "m")


def test_bank_loads_every_chapter() -> None:
    """The bank that is shipped is valid, and its chapters come in order."""
    assert tuple(chapter.number for chapter in load_bank()) == chapter_numbers()


def test_ids_are_unique_in_the_whole_bank() -> None:
    """No two questions of any chapters share an id."""
    ids = [question.id for chapter in load_bank() for question in chapter.questions]
    assert len(set(ids)) == len(ids)


def test_load_quiz_accepts_a_number_without_its_zero() -> None:
    """The chapter "3" is the chapter "03"."""
    assert load_quiz("3") == load_quiz("03")


def test_load_quiz_unknown_names_the_known_ones() -> None:
    """An unknown chapter is refused with the list of chapters."""
    with pytest.raises(ValueError, match=r"chapter must be one of 00, .*, got '99'"):
        load_quiz("99")


BROKEN = {
    "repeated id": (CHOICE, CHOICE + CHOICE, r"question 07-side: id must be unique"),
    "other chapter's id": ('"07-side"', '"08-side"', r"question 08-side: id must start with 07-"),
    "no id": ('id = "07-side"', "", r"chapter 07, question number 1: id must be a text, got None"),
    "empty text": ('"Left or right?"', '" "', r"question 07-side: text must not be empty"),
    "empty feedback": ('"Why left?"', '""', r"question 07-side, option a: feedback must not be"),
    "empty right feedback": ('"It is right."', '""', r"07-side, option b: feedback must not be"),
    "no right option": ("right = true", "", r"07-side: exactly one option must be right, got \[\]"),
    "two right options": (
        'feedback = "Why left?"',
        'feedback = "Why left?"\nright = true',
        r"question 07-side: exactly one option must be right, got \['a', 'b'\]",
    ),
    "same option twice": ('"Left"', '"Right"', r"question 07-side: options must differ"),
    "one option": (
        '[[question.option]]\ntext = "Left"\nfeedback = "Why left?"',
        "",
        r"question 07-side: options must number 2 to 5, got 1",
    ),
    "six options": (
        '[[question.option]]\ntext = "Left"',
        '[[question.option]]\ntext = "x"\nfeedback = "y"\n' * 4
        + '[[question.option]]\ntext = "Left"',
        r"question 07-side: options must number 2 to 5, got 6",
    ),
    "options no tables": (
        CHOICE,
        '[[question]]\nid = "07-side"\nkind = "choice"\ntext = "?"\noption = 3\n',
        r"question 07-side: option must be a list of tables, got 3",
    ),
    "unknown kind": ('"choice"', '"essay"', r"question 07-side: kind must be .*, got 'essay'"),
    "unknown key": (
        'kind = "choice"',
        'kind = "choice"\nhint = "b"',
        r"question 07-side: no other key may be given, got \['hint'\]",
    ),
    "missing key": ('unit = "m"', "", r"question 07-sum: unit must be given"),
    "value no number": ("value = 2\n", 'value = "2"\n', r"07-sum: value must be a number, got '2'"),
    "value nan": (
        "value = 2\n",
        "value = nan\n",
        r"question 07-sum: value must be finite, got nan",
    ),
    "tolerance zero": ("0.1", "0", r"question 07-sum: tolerance must be > 0 .*, got 0.0"),
    "tolerance nan": ("0.1", "nan", r"question 07-sum: tolerance must be > 0 .*, got nan"),
    "wrong value inf": ("1.0", "inf", r"question 07-sum: wrong value must be finite, got inf"),
    "wrong value is right": ("1.0", "2.05", r"07-sum: values must lie .* apart, got \(2.0, 2.05\)"),
    "wrong value in reach": ("1.0", "1.85", r"07-sum: values must lie .* apart, got \(2.0, 1.85\)"),
    "empty wrong value feedback": (
        '"That is one of them."',
        '""',
        r"question 07-sum, wrong value 1: feedback must not be empty",
    ),
    "empty general feedback": ('"Add them."', '""', r"07-sum: wrong_feedback must not be empty"),
    "empty numeric feedback": ('"Two."', '""', r"question 07-sum: right_feedback must not be"),
    "no title": ('title = "Sums"', "", r"chapter 07: title must be given"),
    "empty title": ('"Sums"', '""', r"chapter 07: title must not be empty"),
    "no questions": (SOUND, 'title = "Sums"\nquestion = []', r"chapter 07: it must ask something"),
    "no TOML": ('title = "Sums"', "title = ", r"chapter 07: the file must be TOML"),
}


@pytest.mark.parametrize(("old", "new", "message"), BROKEN.values(), ids=BROKEN)
def test_broken_bank_is_refused_by_name(old: str, new: str, message: str) -> None:
    """A bank that breaks a rule raises an error with the question, the rule and the value."""
    broken = SOUND.replace(old, new, 1)
    assert broken != SOUND
    with pytest.raises(ValueError, match=message):
        read_quiz("07", broken)


def test_choice_answer_outside_the_options_is_refused() -> None:
    """A question built in code needs an answer among its letters."""
    options = (Option("Left", "Why?"), Option("Right", "Yes."))
    with pytest.raises(
        ValueError, match=r"question 07-x: answer must be one letter of ab, got 'c'"
    ):
        ChoiceQuestion("07-x", "Which?", options, "c")


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"spacing": math.nan}, "spacing must be > 0"),
        ({"reach": math.nan}, "reach must be whole spacings"),
        ({"reach": 2.5}, "reach must be whole spacings"),
        ({"value": (math.nan, 0.0)}, "a tip must lie where lines cross"),
        ({"value": (0.5, 0.0)}, "a tip must lie where lines cross"),
        ({"value": (4.0, 0.0)}, "a tip must lie where lines cross"),
        ({"value": (1.0, 1.0)}, "tips must differ"),
        ({"given": {"v": (0.0, 0.0)}}, "v must have a length"),
        ({"wall": (0.0, 0.0)}, "wall must have a length"),
        ({"wall": (math.nan, 1.0)}, "wall must have a length"),
    ],
)
def test_arrow_that_breaks_a_rule_is_refused(changed: dict[str, Any], rule: str) -> None:
    """The error names the question, the rule and the value."""
    sound: dict[str, Any] = {
        "id": "03-x",
        "text": "Draw it.",
        "unit": "m/s",
        "spacing": 1.0,
        "reach": 3.0,
        "value": (2.0, 0.0),
        "right_feedback": "Yes.",
        "wrong_values": (WrongValue((1.0, 1.0), "No."),),
        "wrong_feedback": "No.",
        "given": {"v": (0.0, -2.0)},
    }
    assert ArrowQuestion(**sound).crossing((2.4, -0.5)) == (2, 0)
    with pytest.raises(ValueError, match=f"question 03-x: {rule}.*, got "):
        ArrowQuestion(**sound | changed)

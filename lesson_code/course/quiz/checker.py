"""The one judge of quiz answers, for the notebook and the terminal.

An answer that cannot be read is not a wrong answer. It raises a ValueError that says what is
expected, so that the caller can ask again.
"""

from __future__ import annotations

import math
import numbers
import re
from dataclasses import dataclass
from typing import Any

from lesson_code.course.quiz.questions import (
    LETTERS,
    ArrowQuestion,
    ChoiceQuestion,
    NumericQuestion,
    Question,
    Tip,
    foreseen,
)

NUMBER_AND_UNIT = re.compile(
    r"(?P<number>[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?)(?P<unit>.*)",
    re.DOTALL,
)
"""A decimal number with a point or a comma, then whatever follows it."""

MINUS_SIGNS = str.maketrans("\N{MINUS SIGN}\N{EN DASH}", "--")
"""Signs that are typed or pasted for a minus, and what Python reads."""

ANSWER_SHOWN = 40
"""Characters of an unreadable answer that are quoted back."""


@dataclass(frozen=True, slots=True)
class CheckedAnswer:
    """Whether an answer is right, and what to say to it."""

    right: bool
    feedback: str


def check_answer(question: Question, answer: object) -> CheckedAnswer:
    """Judge one answer.

    Parameters
    ----------
    question : Question
        The question that was asked.
    answer : str, int or float
        The letter of an option, upper or lower case; or a number, as such or as text with a
        decimal point or comma, with or without its unit; or both components of an arrow as text,
        such as "1, -2".

    Returns
    -------
    CheckedAnswer
        Right or not, with the feedback for this very answer.

    Raises
    ------
    ValueError
        The answer is not one of the letters, or not a finite number in the question's unit.

    Examples
    --------
    >>> from lesson_code.course.quiz.questions import NumericQuestion, WrongValue
    >>> question = NumericQuestion(
    ...     id="02-height", text="Dropped from 1 m, e = 0.9. How high after one bounce?",
    ...     unit="m", value=0.81, tolerance=0.001, right_feedback="e² h.",
    ...     wrong_values=(WrongValue(0.9, "Speeds shrink by e. And heights?"),),
    ...     wrong_feedback="How does the height depend on the speed?")
    >>> check_answer(question, "0,81 m")
    CheckedAnswer(right=True, feedback='e² h.')
    >>> check_answer(question, 0.9)
    CheckedAnswer(right=False, feedback='Speeds shrink by e. And heights?')
    >>> check_answer(question, "high")
    Traceback (most recent call last):
        ...
    ValueError: the answer must be a number in m, such as 0.25, got 'high'
    """
    if isinstance(question, ChoiceQuestion):
        return _check_choice(question, answer)
    if isinstance(question, ArrowQuestion):
        return _check_value(question, _read_arrow(question, answer))
    return _check_value(question, _read_number(question, answer))


def expected_answer(question: Question) -> str:
    """Return in a few words what an answer to the question looks like.

    >>> from lesson_code.course.quiz.bank import load_quiz
    >>> expected_answer(load_quiz("00").questions[0])
    'a letter from a to d'
    """
    if isinstance(question, ChoiceQuestion):
        return f"a letter from a to {LETTERS[len(question.options) - 1]}"
    if isinstance(question, ArrowQuestion):
        return f"the arrow's x and y in {question.unit}, such as 1, -2"
    return f"a number in {question.unit}" if question.unit else "a number"


def right_answer(question: Question) -> str:
    """Return the right answer as text, for after the last try."""
    if isinstance(question, ChoiceQuestion):
        return f"{question.answer}) {question.right_option.text}"
    if isinstance(question, ArrowQuestion):
        x, y = question.value
        return f"({x:g}, {y:g}) {question.unit}".replace("-", "\N{MINUS SIGN}")
    return f"{question.value:g} {question.unit}".rstrip().replace("-", "\N{MINUS SIGN}")


def _check_choice(question: ChoiceQuestion, answer: object) -> CheckedAnswer:
    """Judge a letter; "b", "B", "b)" and "b." are the same answer."""
    letter = answer.strip().rstrip(").").casefold() if isinstance(answer, str) else ""
    options = dict(question.lettered)
    if letter not in options:
        raise _unreadable(expected_answer(question), answer)
    return CheckedAnswer(letter == question.answer, options[letter].feedback)


def _check_value(question: NumericQuestion | ArrowQuestion, answer: Any) -> CheckedAnswer:
    """Judge a number or a tip: right, a recognised mistake, or some other."""
    for value, right, feedback in foreseen(question):
        if question.fits(answer, value):
            return CheckedAnswer(right, feedback)
    return CheckedAnswer(False, question.wrong_feedback)


def _read_arrow(question: ArrowQuestion, answer: object) -> Tip:
    """Return the two components in a text: numbers with a space or a semicolon between them."""
    written = answer.strip().removesuffix(question.unit) if isinstance(answer, str) else ""
    parts = re.split(r"[,;]?\s+|;", written.strip().strip("()"))
    tip = [_parse_number(part, "") for part in parts]
    if len(tip) != 2 or not all(map(math.isfinite, tip)):
        raise _unreadable(expected_answer(question), answer)
    return tip[0], tip[1]


def _read_number(question: NumericQuestion, answer: object) -> float:
    """Return the answer as a finite number in the question's unit."""
    expected = f"{expected_answer(question)}, such as 0.25"
    if isinstance(answer, str):
        value = _parse_number(answer, question.unit)
    elif isinstance(answer, bool) or not isinstance(answer, numbers.Real):
        value = math.nan
    else:
        value = _as_float(answer)
    if not math.isfinite(value):
        raise _unreadable(expected, answer)
    return value


def _parse_number(answer: str, unit: str) -> float:
    """Return the number at the start of a text, nan unless its unit or nothing follows."""
    written = NUMBER_AND_UNIT.fullmatch(answer.strip().translate(MINUS_SIGNS))
    if written is None or not _same_unit(written["unit"], unit):
        return math.nan
    return float(written["number"].replace(",", "."))


def _as_float(answer: numbers.Real) -> float:
    """Return a real number as a float, infinite when it is too large for one."""
    try:
        return float(answer)
    except OverflowError:
        return math.inf


def _same_unit(written: str, unit: str) -> bool:
    """Return whether a unit was left out, or written as the question has it."""
    return _bare(written) in ("", _bare(unit))


def _bare(unit: str) -> str:
    """Return a unit without the signs that may stand between its factors."""
    return re.sub(r"[\s·*]", "", unit).casefold()


def _unreadable(expected: str, answer: object) -> ValueError:
    """Return the error for an answer that cannot be judged."""
    shown = answer if not isinstance(answer, str) else answer[:ANSWER_SHOWN]
    return ValueError(f"the answer must be {expected}, got {shown!r}")

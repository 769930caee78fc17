"""The kinds of questions: a choice, a number, an arrow; and the rules that each of them obeys."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any, Generic, TypeAlias, TypeVar

LETTERS = "abcde"
"""Options are named by letter; no question has more of them."""

Tip: TypeAlias = tuple[float, float]
"""Where an arrow from the origin ends: its components."""

Value = TypeVar("Value")
"""What an answer is: a number, or the tip of an arrow."""


@dataclass(frozen=True, slots=True)
class Option:
    """One answer to choose from, and what is said to those who choose it."""

    text: str
    feedback: str


@dataclass(frozen=True, slots=True)
class ChoiceQuestion:
    """A question with lettered options, one of them right.

    Parameters
    ----------
    id : str
        Unique in the bank; starts with the chapter's number, as in "03-gate".
    text : str
        The question, as plain text.
    options : tuple of Option
        Two to five, no text twice. The right option's feedback says why it is right.
    answer : str
        Letter of the right option.

    Raises
    ------
    ValueError
        A rule above is broken, or a text or feedback is empty.

    Examples
    --------
    >>> pulled = Option("Downwards", "Gravity pulls it down.")
    >>> up = Option("Upwards", "Which way does gravity pull?")
    >>> question = ChoiceQuestion("00-fall", "A ball is let go. It moves:", (up, pulled), "b")
    >>> question.right_option.text
    'Downwards'
    """

    id: str
    text: str
    options: tuple[Option, ...]
    answer: str

    def __post_init__(self) -> None:
        where, letters = f"question {self.id}", LETTERS[: len(self.options)]
        require_words(where, {"text": self.text})
        require_option_count(where, len(self.options))
        for letter, option in self.lettered:
            words = {"text": option.text, "feedback": option.feedback}
            require_words(f"{where}, option {letter}", words)
        texts = [option.text for option in self.options]
        require(where, len(set(texts)) == len(texts), "options must differ", texts)
        known = len(self.answer) == 1 and self.answer in letters
        require(where, known, f"answer must be one letter of {letters}", self.answer)

    @property
    def lettered(self) -> tuple[tuple[str, Option], ...]:
        """Every option with its letter, in order."""
        return tuple(zip(LETTERS, self.options, strict=False))

    @property
    def right_option(self) -> Option:
        """The option that is right."""
        return self.options[LETTERS.index(self.answer)]

    @property
    def right_feedback(self) -> str:
        """Why that option is right."""
        return self.right_option.feedback


@dataclass(frozen=True, slots=True)
class WrongValue(Generic[Value]):
    """A wrong answer that gives away the mistake behind it, and the feedback to it."""

    value: Value
    feedback: str


@dataclass(frozen=True, slots=True)
class NumericQuestion:
    """A question answered by one number.

    Parameters
    ----------
    id : str
        Unique in the bank; starts with the chapter's number.
    text : str
        The question, as plain text.
    unit : str
        Unit of the answer; empty for a pure number.
    value : float
        The right answer.
    tolerance : float
        How far an answer may be from `value` and still be right, > 0.
    right_feedback : str
        Why the value is right.
    wrong_values : tuple of WrongValue
        Wrong numbers that are recognised, within the same tolerance. All of them and `value`
        lie more than two tolerances apart, so that no answer fits two of them.
    wrong_feedback : str
        What is said to any other number.

    Raises
    ------
    ValueError
        A rule above is broken, a number is not finite, or a text or feedback is empty.
    """

    id: str
    text: str
    unit: str
    value: float
    tolerance: float
    right_feedback: str
    wrong_values: tuple[WrongValue[float], ...]
    wrong_feedback: str

    def __post_init__(self) -> None:
        where = f"question {self.id}"
        names = ("text", "right_feedback", "wrong_feedback")
        require_words(where, {name: getattr(self, name) for name in names})
        require(where, math.isfinite(self.value), "value must be finite", self.value)
        sound = self.tolerance > 0 and math.isfinite(self.tolerance)
        require(where, sound, "tolerance must be > 0 and finite", self.tolerance)
        for wrong in self.wrong_values:
            require(where, math.isfinite(wrong.value), "wrong value must be finite", wrong.value)
            require_words(f"{where}, wrong value {wrong.value:g}", {"feedback": wrong.feedback})
        values = [self.value, *(wrong.value for wrong in self.wrong_values)]
        for a, b in combinations(values, 2):
            apart = abs(a - b) > 2 * self.tolerance
            require(where, apart, "values must lie over two tolerances apart", (a, b))

    def fits(self, answer: float, value: float) -> bool:
        """Return whether an answer is a value that is recognised."""
        return abs(answer - value) <= self.tolerance


@dataclass(frozen=True, slots=True)
class ArrowQuestion:
    """A question answered by an arrow, drawn from the middle of a sheet with a grid.

    Parameters
    ----------
    id : str
        Unique in the bank; starts with the chapter's number.
    text : str
        The question, as plain text.
    unit : str
        Unit of both components.
    spacing : float
        Distance between the lines of the grid, > 0: the tip of an arrow lies where two cross.
    reach : float
        How far the sheet goes from its middle to each side, a whole number of spacings.
    value : tuple of float
        The tip of the right arrow.
    right_feedback : str
        Why it is right.
    wrong_values : tuple of WrongValue
        Tips of wrong arrows that are recognised. All tips lie on the sheet, where lines cross.
    wrong_feedback : str
        What is said to any other arrow.
    given : dict of tuple of float
        The tips of the arrows that stand on the sheet from the start, by their names.
    wall : tuple of float, optional
        The normal of a wall through the middle, which is drawn.

    Raises
    ------
    ValueError
        A rule above is broken, or a text or feedback is empty.
    """

    id: str
    text: str
    unit: str
    spacing: float
    reach: float
    value: Tip
    right_feedback: str
    wrong_values: tuple[WrongValue[Tip], ...]
    wrong_feedback: str
    given: Mapping[str, Tip]
    wall: Tip | None = None

    def __post_init__(self) -> None:
        where = f"question {self.id}"
        names = ("text", "right_feedback", "wrong_feedback")
        require_words(where, {name: getattr(self, name) for name in names})
        require(where, self.spacing > 0, "spacing must be > 0", self.spacing)
        lines = self.reach / self.spacing
        whole = lines.is_integer() and lines > 0
        require(where, whole, "reach must be whole spacings, > 0", self.reach)
        for name, tip in {**self.given, **({"wall": self.wall} if self.wall else {})}.items():
            length = math.hypot(*tip)
            has_way = length > 0 and math.isfinite(length)
            require(where, has_way, f"{name} must have a length, > 0 and finite", tip)
        for wrong in self.wrong_values:
            require_words(f"{where}, wrong value {wrong.value}", {"feedback": wrong.feedback})
        tips = [self.value, *(wrong.value for wrong in self.wrong_values)]
        for tip in tips:
            on_sheet = all(abs(part) <= self.reach for part in tip)
            crossing = all((part / self.spacing).is_integer() for part in tip)
            require(where, on_sheet and crossing, "a tip must lie where lines cross", tip)
        require(where, len(set(tips)) == len(tips), "tips must differ", tips)

    def crossing(self, tip: Tip) -> tuple[int, int]:
        """Return the crossing nearest to a tip, counted in lines from the middle."""
        x, y = (math.floor(part / self.spacing + 0.5) for part in tip)
        return x, y

    def fits(self, answer: Tip, value: Tip) -> bool:
        """Return whether an answer is a tip that is recognised."""
        return self.crossing(answer) == self.crossing(value)

    @property
    def in_words(self) -> str:
        """What stands on the sheet, for who does not see it.

        >>> from lesson_code.course.quiz.bank import load_asked
        >>> (question,) = load_asked("04-angle").questions
        >>> question.in_words
        'Drawn: the arrow v1 at (4, 0), the arrow n at (1, 1). The grid has a line every 1 m/s.'
        """
        drawn = [f"the arrow {name} at ({x:g}, {y:g})" for name, (x, y) in self.given.items()]
        if self.wall is not None:
            drawn.insert(0, "a wall with the normal ({:g}, {:g})".format(*self.wall))
        return f"Drawn: {', '.join(drawn)}. The grid has a line every {self.spacing:g} {self.unit}."


Question: TypeAlias = ChoiceQuestion | NumericQuestion | ArrowQuestion
"""Anything the quiz can ask."""


def foreseen(question: NumericQuestion | ArrowQuestion) -> Iterator[tuple[Any, bool, str]]:
    """Yield each value that is recognised, whether it is right, and what is said to it."""
    yield question.value, True, question.right_feedback
    for wrong in question.wrong_values:
        yield wrong.value, False, wrong.feedback


def lines_below(question: Question) -> list[str]:
    """Return what stands below a question as text: its options, or what is drawn."""
    if isinstance(question, ChoiceQuestion):
        return [f"{letter}) {option.text}" for letter, option in question.lettered]
    return [question.in_words] if isinstance(question, ArrowQuestion) else []


def require(where: str, holds: bool, rule: str, got: object) -> None:
    """Raise an error that names the place, the rule and the value, unless the rule holds."""
    if not holds:
        raise ValueError(f"{where}: {rule}, got {got!r}")


def require_words(where: str, texts: Mapping[str, str]) -> None:
    """Refuse a text that is empty or blank."""
    for name, text in texts.items():
        require(where, bool(text.strip()), f"{name} must not be empty", text)


def require_option_count(where: str, count: int) -> None:
    """Refuse a question without a choice, and one with more options than letters."""
    require(where, 2 <= count <= len(LETTERS), f"options must number 2 to {len(LETTERS)}", count)

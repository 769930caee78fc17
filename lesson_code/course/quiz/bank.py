"""The question bank: what is asked, what is right, and what to say to every answer.

A chapter's questions stand in its folder, in ``quiz.toml``. A question there is a ``[[question]]``
table with ``kind = "choice"`` or ``kind = "numeric"``. A ``[[predict]]`` table has the same form:
the chapter's notebook asks it before it shows a result. Questions and options keep the order of
the file. Every rule a question must obey is checked while it is built, so a bank that loads is a
valid bank.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass
from itertools import combinations
from typing import Any, TypeAlias

from lesson_code.course.chapters import chapters_with
from lesson_code.course.quiz.sealing import open_question

Table: TypeAlias = Mapping[str, Any]
"""A table of a TOML file, not yet checked."""

QUIZ = "quiz.toml"
"""A chapter's file of questions."""

LETTERS = "abcde"
"""Options are named by letter; no question has more of them."""


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
        _require_words(where, {"text": self.text})
        _require_option_count(where, len(self.options))
        for letter, option in self.lettered:
            words = {"text": option.text, "feedback": option.feedback}
            _require_words(f"{where}, option {letter}", words)
        texts = [option.text for option in self.options]
        _require(where, len(set(texts)) == len(texts), "options must differ", texts)
        known = len(self.answer) == 1 and self.answer in letters
        _require(where, known, f"answer must be one letter of {letters}", self.answer)

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
class WrongValue:
    """A wrong number that gives away the mistake behind it, and the feedback to it."""

    value: float
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
    wrong_values: tuple[WrongValue, ...]
    wrong_feedback: str

    def __post_init__(self) -> None:
        where = f"question {self.id}"
        names = ("text", "right_feedback", "wrong_feedback")
        _require_words(where, {name: getattr(self, name) for name in names})
        _require(where, math.isfinite(self.value), "value must be finite", self.value)
        sound = self.tolerance > 0 and math.isfinite(self.tolerance)
        _require(where, sound, "tolerance must be > 0 and finite", self.tolerance)
        for wrong in self.wrong_values:
            _require(where, math.isfinite(wrong.value), "wrong value must be finite", wrong.value)
            _require_words(f"{where}, wrong value {wrong.value:g}", {"feedback": wrong.feedback})
        values = [self.value, *(wrong.value for wrong in self.wrong_values)]
        for a, b in combinations(values, 2):
            apart = abs(a - b) > 2 * self.tolerance
            _require(where, apart, "values must lie over two tolerances apart", (a, b))


Question: TypeAlias = ChoiceQuestion | NumericQuestion
"""Anything the quiz can ask."""


@dataclass(frozen=True, slots=True)
class Quiz:
    """The questions of a chapter, in the order in which they are asked.

    Parameters
    ----------
    number : str
        Two digits, as in the notebook's name.
    title : str
        What the chapter is about.
    questions : tuple of Question
        At least one; every id starts with the chapter's number, and none stands twice.
    predictions : tuple of Question
        What the notebook asks before it shows a result; their ids follow the same rules.
    """

    number: str
    title: str
    questions: tuple[Question, ...]
    predictions: tuple[Question, ...] = ()

    def __post_init__(self) -> None:
        where = f"chapter {self.number}"
        _require_words(where, {"title": self.title})
        _require(where, len(self.questions) > 0, "it must ask something", self.questions)
        seen: set[str] = set()
        for question in (*self.questions, *self.predictions):
            where, prefix = f"question {question.id}", f"{self.number}-"
            _require(
                where, question.id.startswith(prefix), f"id must start with {prefix}", question.id
            )
            _require(where, question.id not in seen, "id must be unique", question.id)
            seen.add(question.id)


def chapter_numbers() -> tuple[str, ...]:
    """Return the numbers of the chapters that have a quiz, in order.

    >>> chapter_numbers()[:3]
    ('00', '01', '02')
    """
    return tuple(chapter.number for chapter in chapters_with(QUIZ))


def load_quiz(number: str) -> Quiz:
    """Return the quiz of one chapter.

    Parameters
    ----------
    number : str
        "03", or "3" for short.

    Raises
    ------
    ValueError
        There is no such chapter, or its file breaks a rule.

    Examples
    --------
    >>> load_quiz("03").title
    'Reflection'
    """
    padded, known = str(number).zfill(2), {c.number: c for c in chapters_with(QUIZ)}
    if padded not in known:
        raise ValueError(f"chapter must be one of {', '.join(known)}, got {number!r}")
    return read_quiz(padded, known[padded].file(QUIZ).read_text(encoding="utf-8"))


def load_bank() -> tuple[Quiz, ...]:
    """Return the quiz of every chapter, in order."""
    return tuple(load_quiz(number) for number in chapter_numbers())


def read_quiz(number: str, toml: str) -> Quiz:
    """Return the quiz written in a TOML text.

    Parameters
    ----------
    number : str
        The chapter's number, two digits.
    toml : str
        The text of its file.

    Raises
    ------
    ValueError
        The text is not TOML, a key is missing, unknown or of the wrong type, or a question
        breaks a rule. The error names the question, the rule and the value.
    """
    where = f"chapter {number}"
    try:
        table = tomllib.loads(toml)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{where}: the file must be TOML, got: {error}") from None
    _require_keys(where, table, {"title", "question"}, {"predict"})
    questions = _read_questions(where, "question", table)
    predictions = _read_questions(where, "predict", {"predict": []} | dict(table))
    return Quiz(number, _text(where, table, "title"), questions, predictions)


def _read_questions(where: str, key: str, table: Table) -> tuple[Question, ...]:
    """Return the questions in one list of a chapter's file."""
    return tuple(
        _read_question(f"{where}, {key} number {place}", open_question(dict(entry)))
        for place, entry in enumerate(_tables(where, table, key), start=1)
    )


def _read_question(place: str, table: Table) -> Question:
    """Return one question; until its id is known, errors name its place."""
    where = f"question {_text(place, table, 'id')}"
    kind = _text(where, table, "kind")
    _require(where, kind in ("choice", "numeric"), "kind must be choice or numeric", kind)
    return _read_choice(where, table) if kind == "choice" else _read_numeric(where, table)


def _read_choice(where: str, table: Table) -> ChoiceQuestion:
    """Return a choice question; one of its options says ``right = true``."""
    _require_keys(where, table, {"id", "kind", "text", "option"})
    entries = _tables(where, table, "option")
    _require_option_count(where, len(entries))
    for letter, entry in zip(LETTERS, entries, strict=False):
        _require_keys(f"{where}, option {letter}", entry, {"text", "feedback"}, {"right"})
    right = [letter for letter, e in zip(LETTERS, entries, strict=False) if e.get("right") is True]
    _require(where, len(right) == 1, "exactly one option must be right", right)
    options = [Option(_text(where, e, "text"), _text(where, e, "feedback")) for e in entries]
    words = {key: _text(where, table, key) for key in ("id", "text")}
    return ChoiceQuestion(options=tuple(options), answer=right[0], **words)


def _read_numeric(where: str, table: Table) -> NumericQuestion:
    """Return a numeric question."""
    words = {"id", "text", "unit", "right_feedback", "wrong_feedback"}
    _require_keys(where, table, {"kind", "value", "tolerance", "wrong_value"} | words)
    value, tolerance = _number(where, table, "value"), _number(where, table, "tolerance")
    wrong_values = tuple(_read_wrong(where, e) for e in _tables(where, table, "wrong_value"))
    texts: dict[str, Any] = {key: _text(where, table, key) for key in words}
    return NumericQuestion(value=value, tolerance=tolerance, wrong_values=wrong_values, **texts)


def _read_wrong(where: str, table: Table) -> WrongValue:
    """Return one recognised wrong value."""
    _require_keys(where, table, {"value", "feedback"})
    return WrongValue(_number(where, table, "value"), _text(where, table, "feedback"))


def _require(where: str, holds: bool, rule: str, got: object) -> None:
    """Raise an error that names the place, the rule and the value, unless the rule holds."""
    if not holds:
        raise ValueError(f"{where}: {rule}, got {got!r}")


def _require_words(where: str, texts: Mapping[str, str]) -> None:
    """Refuse a text that is empty or blank."""
    for name, text in texts.items():
        _require(where, bool(text.strip()), f"{name} must not be empty", text)


def _require_option_count(where: str, count: int) -> None:
    """Refuse a question without a choice, and one with more options than letters."""
    _require(where, 2 <= count <= len(LETTERS), f"options must number 2 to {len(LETTERS)}", count)


def _require_keys(
    where: str, table: Table, required: Set[str], optional: Set[str] = frozenset()
) -> None:
    """Refuse missing keys, and keys that nothing would read."""
    missing = sorted(required - table.keys())
    _require(where, not missing, f"{', '.join(missing)} must be given", sorted(table))
    unknown = sorted(table.keys() - required - optional)
    _require(where, not unknown, "no other key may be given", unknown)


def _text(where: str, table: Table, key: str) -> str:
    """Return a text from the table, its lines joined to one."""
    value = table.get(key)
    _require(where, isinstance(value, str), f"{key} must be a text", value)
    return " ".join(str(value).split())


def _number(where: str, table: Table, key: str) -> float:
    """Return a number from the table."""
    value: Any = table.get(key)
    numeric = isinstance(value, int | float) and not isinstance(value, bool)
    _require(where, numeric, f"{key} must be a number", value)
    return float(value)


def _tables(where: str, table: Table, key: str) -> Sequence[Table]:
    """Return a list of tables from the table."""
    value: Any = table.get(key)
    listed = isinstance(value, list) and all(isinstance(entry, dict) for entry in value)
    _require(where, listed, f"{key} must be a list of tables", value)
    return list(value)

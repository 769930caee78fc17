"""The question bank: what is asked, what is right, and what to say to every answer.

A chapter's questions stand in its folder, in ``quiz.toml``. A question there is a ``[[question]]``
table, and its ``kind`` is "choice", "numeric" or "arrow". A ``[[predict]]`` table has the same
form: the chapter's notebook asks it before it shows a result. Questions and options keep the
order of the file. Every rule a question must obey is checked while it is built, so a bank that
loads is a valid bank.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import Any, TypeAlias

from lesson_code.course.chapters import chapters_with
from lesson_code.course.quiz.questions import (
    LETTERS,
    ArrowQuestion,
    ChoiceQuestion,
    NumericQuestion,
    Option,
    Question,
    Tip,
    WrongValue,
    require,
    require_option_count,
    require_words,
)
from lesson_code.course.quiz.sealing import open_question

Table: TypeAlias = Mapping[str, Any]
"""A table of a TOML file, not yet checked."""

QUIZ = "quiz.toml"
"""A chapter's file of questions."""


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
        require_words(where, {"title": self.title})
        require(where, len(self.questions) > 0, "it must ask something", self.questions)
        seen: set[str] = set()
        for question in (*self.questions, *self.predictions):
            where, prefix = f"question {question.id}", f"{self.number}-"
            require(
                where, question.id.startswith(prefix), f"id must start with {prefix}", question.id
            )
            require(where, question.id not in seen, "id must be unique", question.id)
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


def load_asked(name: str) -> Quiz:
    """Return what a name stands for: the quiz of a chapter, or one question of its file.

    Parameters
    ----------
    name : str
        A chapter's number, or the id of one of its questions or predictions.

    Raises
    ------
    ValueError
        There is no such chapter or question.

    Examples
    --------
    >>> [question.id for question in load_asked("03-once").questions]
    ['03-once']
    """
    number, dash, _ = name.partition("-")
    quiz = load_quiz(number)
    if not dash:
        return quiz
    known = {question.id: question for question in (*quiz.questions, *quiz.predictions)}
    if name not in known:
        raise ValueError(f"question must be one of {', '.join(known)}, got {name!r}")
    return Quiz(quiz.number, quiz.title, (known[name],))


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
    require(where, kind in READERS, f"kind must be one of {', '.join(READERS)}", kind)
    return READERS[kind](where, table)


def _read_choice(where: str, table: Table) -> ChoiceQuestion:
    """Return a choice question; one of its options says ``right = true``."""
    _require_keys(where, table, {"id", "kind", "text", "option"})
    entries = _tables(where, table, "option")
    require_option_count(where, len(entries))
    for letter, entry in zip(LETTERS, entries, strict=False):
        _require_keys(f"{where}, option {letter}", entry, {"text", "feedback"}, {"right"})
    right = [letter for letter, e in zip(LETTERS, entries, strict=False) if e.get("right") is True]
    require(where, len(right) == 1, "exactly one option must be right", right)
    options = [Option(_text(where, e, "text"), _text(where, e, "feedback")) for e in entries]
    words = {key: _text(where, table, key) for key in ("id", "text")}
    return ChoiceQuestion(options=tuple(options), answer=right[0], **words)


def _read_numeric(where: str, table: Table) -> NumericQuestion:
    """Return a numeric question."""
    words = {"id", "text", "unit", "right_feedback", "wrong_feedback"}
    _require_keys(where, table, {"kind", "value", "tolerance", "wrong_value"} | words)
    value, tolerance = _number(where, table, "value"), _number(where, table, "tolerance")
    wrong_values = tuple(
        WrongValue(_number(where, entry, "value"), feedback)
        for entry, feedback in _wrong_values(where, table)
    )
    texts: dict[str, Any] = {key: _text(where, table, key) for key in words}
    return NumericQuestion(value=value, tolerance=tolerance, wrong_values=wrong_values, **texts)


def _read_arrow(where: str, table: Table) -> ArrowQuestion:
    """Return a question that is answered by an arrow."""
    words = {"id", "text", "unit", "right_feedback", "wrong_feedback"}
    sheet = {"spacing", "reach"}
    required = {"kind", "value", "wrong_value", "given"} | sheet | words
    _require_keys(where, table, required, {"wall"})
    given = table["given"]
    require(where, isinstance(given, dict), "given must be a table of arrows", given)
    wrong_values = tuple(
        WrongValue(_tip(where, entry, "value"), feedback)
        for entry, feedback in _wrong_values(where, table)
    )
    words_and_sizes: dict[str, Any] = {key: _text(where, table, key) for key in words}
    words_and_sizes |= {key: _number(where, table, key) for key in sheet}
    return ArrowQuestion(
        value=_tip(where, table, "value"),
        wrong_values=wrong_values,
        given={name: _tip(where, given, name) for name in given},
        wall=_tip(where, table, "wall") if "wall" in table else None,
        **words_and_sizes,
    )


READERS: dict[str, Callable[[str, Table], Question]] = {
    "choice": _read_choice,
    "numeric": _read_numeric,
    "arrow": _read_arrow,
}
"""What reads a question of each kind."""


def _wrong_values(where: str, table: Table) -> Iterator[tuple[Table, str]]:
    """Yield each entry of the recognised wrong answers, with its feedback."""
    for entry in _tables(where, table, "wrong_value"):
        _require_keys(where, entry, {"value", "feedback"})
        yield entry, _text(where, entry, "feedback")


def _require_keys(
    where: str, table: Table, required: Set[str], optional: Set[str] = frozenset()
) -> None:
    """Refuse missing keys, and keys that nothing would read."""
    missing = sorted(required - table.keys())
    require(where, not missing, f"{', '.join(missing)} must be given", sorted(table))
    unknown = sorted(table.keys() - required - optional)
    require(where, not unknown, "no other key may be given", unknown)


def _text(where: str, table: Table, key: str) -> str:
    """Return a text from the table, its lines joined to one."""
    value = table.get(key)
    require(where, isinstance(value, str), f"{key} must be a text", value)
    return " ".join(str(value).split())


def _number(where: str, table: Table, key: str) -> float:
    """Return a number from the table."""
    value: Any = table.get(key)
    numeric = isinstance(value, int | float) and not isinstance(value, bool)
    require(where, numeric, f"{key} must be a number", value)
    return float(value)


def _tip(where: str, table: Table, key: str) -> Tip:
    """Return the tip of an arrow from the table: two numbers."""
    value: Any = table.get(key)
    pair = isinstance(value, list) and len(value) == 2
    require(where, pair, f"{key} must be a list of two numbers", value)
    x, y = (_number(where, {key: part}, key) for part in value)
    return x, y


def _tables(where: str, table: Table, key: str) -> Sequence[Table]:
    """Return a list of tables from the table."""
    value: Any = table.get(key)
    listed = isinstance(value, list) and all(isinstance(entry, dict) for entry in value)
    require(where, listed, f"{key} must be a list of tables", value)
    return list(value)

"""The quiz in a page: judged in the browser, with the same verdicts as everywhere else.

The page does not hold the answers in the clear. What is said to an answer, and whether it is
right, is sealed with that answer: ``quiz.js`` can open it only when the answer is given. For a
number, which has a tolerance, the key is the drawer it lies in, two tolerances wide; inside stands
the exact value. So a look at the page's source gives nothing away. It is no protection against
somebody who tries all answers.
"""

from __future__ import annotations

import hashlib
import itertools
import json
import math
from collections.abc import Iterator
from html import escape
from typing import Any, TypeAlias

from lesson_code.course.quiz.bank import ChoiceQuestion, NumericQuestion, Question, Quiz
from lesson_code.course.quiz.checker import expected_answer

Sealed: TypeAlias = dict[str, str]
"""For each key's name the sealed text, both in hexadecimal digits."""

NAME_LENGTH = 16
"""Digits of a key's name."""

ROUNDING = 1e-6
"""Of a tolerance: how much further the drawers reach, so that no answer at its edge is missed."""


def quiz_html(quiz: Quiz) -> str:
    """Return a chapter's quiz, a form for each question, for ``quiz.js`` to bring to life."""
    questions = "\n".join(
        _form(place, question) for place, question in enumerate(quiz.questions, start=1)
    )
    title = escape(f"Quiz {quiz.number}: {quiz.title}")
    return (
        f'<div class="quiz" role="group" aria-label="{title}">\n<p><strong>{title}</strong></p>\n'
        f'{questions}\n<p class="count" role="status"></p>\n'
        "<noscript>To answer here, allow scripts; or run the notebook.</noscript>\n</div>"
    )


def sealed_answers(question: Question) -> Sealed:
    """Return what is said to each foreseen answer, sealed with that answer."""
    return {
        key_name(question.id, answer): seal(question.id, answer, json.dumps(said))
        for answer, said in _foreseen(question)
    }


def key_name(question: str, answer: str) -> str:
    """Return how the sealed text for an answer is found, without naming the answer."""
    return _hash(f"{question}|{answer}|name").hex()[:NAME_LENGTH]


def seal(question: str, answer: str, text: str) -> str:
    """Return a text that can be read with the answer alone, as hexadecimal digits.

    Its bytes are combined by exclusive or with SHA-256 of the key and the number of the block.
    """
    clear = text.encode()
    stream = itertools.chain.from_iterable(
        _hash(f"{question}|{answer}|{block}") for block in itertools.count()
    )
    return bytes(a ^ b for a, b in zip(clear, stream, strict=False)).hex()


def _foreseen(question: Question) -> Iterator[tuple[str, Any]]:
    """Yield each key, and the verdicts that lie behind it."""
    if isinstance(question, ChoiceQuestion):
        for letter, option in question.lettered:
            yield letter, [{"right": letter == question.answer, "feedback": option.feedback}]
        return
    drawers: dict[int, list[Any]] = {}
    for value, right, feedback in _values(question):
        said = {"value": value, "right": right, "feedback": feedback}
        for drawer in _drawers(value, question.tolerance):
            drawers.setdefault(drawer, []).append(said)
    for drawer, verdicts in drawers.items():
        yield str(drawer), verdicts


def _values(question: NumericQuestion) -> Iterator[tuple[float, bool, str]]:
    """Yield each value that is recognised, whether it is right, and what is said to it."""
    yield question.value, True, question.right_feedback
    for wrong in question.wrong_values:
        yield wrong.value, False, wrong.feedback


def _drawers(value: float, tolerance: float) -> range:
    """Return the drawers in which answers within a tolerance of a value lie."""
    reach, width = tolerance * (1 + ROUNDING), 2 * tolerance
    return range(math.floor((value - reach) / width), math.floor((value + reach) / width) + 1)


def _hash(text: str) -> bytes:
    """Return SHA-256 of a text."""
    return hashlib.sha256(text.encode()).digest()


def _form(place: int, question: Question) -> str:
    """Return a question with its answers, its button and the place of its feedback."""
    data: dict[str, Any] = {"id": question.id, "sealed": sealed_answers(question)}
    data["expected"] = expected_answer(question)
    if isinstance(question, NumericQuestion):
        data |= {"unit": question.unit, "tolerance": question.tolerance}
        data["otherwise"] = question.wrong_feedback
    return (
        f'<form data-question="{escape(json.dumps(data))}" autocomplete="off">\n'
        f"<fieldset>\n<legend>{place}. {escape(question.text)}</legend>\n{_answers(question)}\n"
        f'<button type="submit" aria-label="Check question {place}">Check</button>\n'
        f'<p class="verdict" role="status"></p>\n</fieldset>\n</form>'
    )


def _answers(question: Question) -> str:
    """Return the radio buttons, or the box for a number."""
    if isinstance(question, ChoiceQuestion):
        return "\n".join(
            f'<label><input type="radio" name="{question.id}" value="{letter}"> '
            f"<span>{letter}) {escape(option.text)}</span></label>"
            for letter, option in question.lettered
        )
    label = f"Answer: {escape(expected_answer(question))}."
    return f'<label>{label} <input type="text" name="{question.id}"></label>'

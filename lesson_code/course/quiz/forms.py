"""Questions as forms of HTML, for notebooks and pages, judged in the browser without a kernel.

Each quiz and each prediction carries its style and its script, ``quiz.css`` and ``quiz.js``, so
that it needs no other file. The verdicts are those of the one judge.

A form does not hold its answers in the clear. What is said to an answer, and whether it is right,
is sealed with that answer: the script can open it only when the answer is given. For a number,
which has a tolerance, the key is the drawer it lies in, two tolerances wide; inside stands the
exact value. For an arrow the key is the crossing of the grid at its tip. What is said to any other
number or arrow is sealed with the question's id. So a look at the source gives nothing away. It is
no protection against somebody who tries all answers.
"""

from __future__ import annotations

import hashlib
import itertools
import json
import math
import re
from collections.abc import Iterator
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any, TypeAlias

from lesson_code.course.quiz.arrows import sheet
from lesson_code.course.quiz.bank import Quiz
from lesson_code.course.quiz.checker import expected_answer
from lesson_code.course.quiz.questions import (
    ArrowQuestion,
    ChoiceQuestion,
    NumericQuestion,
    Question,
    foreseen,
)

Sealed: TypeAlias = dict[str, str]
"""For each key's name the sealed text, both in hexadecimal digits."""

OTHERWISE = "otherwise"
"""The key of what is said to a number or an arrow that nobody foresaw."""

NAME_LENGTH = 16
"""Digits of a key's name."""

ROUNDING = 1e-6
"""Of a tolerance: how much further the drawers reach, so that no answer at its edge is missed."""


def asleep(name: str) -> str:
    """Return what stands below a form until its script runs, and below its text.

    `name` is what ``workbook quiz`` asks in its place: a chapter or one question.
    """
    here = "To answer here, run the notebook, or allow scripts."
    return f"{here} In a terminal: workbook quiz {name}"


MOST_FOLDED = 8
"""Folded cells below a prediction that can belong to its answer."""


def quiz_html(quiz: Quiz) -> str:
    """Return a chapter's quiz: a form for each question, and the count of right answers."""
    questions = "\n".join(
        _form(question, f"{place}. {question.text}", _check_button(place))
        for place, question in enumerate(quiz.questions, start=1)
    )
    title = f"Quiz {quiz.number}: {quiz.title}"
    count = '<p class="count" role="status"></p>'
    head = f"<p><strong>{escape(title)}</strong></p>"
    return _group(quiz.number, "", title, f"{head}\n{questions}\n{count}")


def prediction_html(question: Question) -> str:
    """Return one question; an answer to it opens the folded cells below it."""
    buttons = (
        '<button type="submit">Commit</button> '
        '<button type="button" class="reveal">Show me without an answer</button>'
    )
    form = _form(question, f"Predict: {question.text}", buttons)
    return _group(question.id, " predict", "Prediction", form)


def _group(name: str, kind: str, label: str, forms: str) -> str:
    """Return forms with what brings them to life."""
    return (
        f'<div class="quiz{kind}" role="group" aria-label="{escape(label)}">\n{forms}\n'
        f'<p class="asleep">{asleep(name)}</p>\n{_style_and_script()}</div>'
    )


@cache
def _style_and_script() -> str:
    """Return the style and the script of a group of forms, without comments."""
    style, script = (
        files("lesson_code.course.quiz").joinpath(name).read_text("utf-8")
        for name in ("quiz.css", "quiz.js")
    )
    style = re.sub(r"/\*.*?\*/\n?", "", style, flags=re.DOTALL) + _folded_answers()
    script = re.sub(r"^ *//.*\n|^\n", "", script, flags=re.MULTILINE)
    return f"<style>\n{style}</style>\n<script>\n{script}</script>\n"


def _folded_answers() -> str:
    """Return the rules that keep an answer out of sight in JupyterLab until it is unfolded.

    JupyterLab unfolds an output whenever its cell is run, but not the source. So the output of a
    cell below a prediction is shown when its source is. It does not fold text: a text with a mark
    of the class ``answer`` is shown when the cell above it is.
    """
    code = ".jp-CodeCell:not(:has(.quiz)):has(> .jp-Cell-inputWrapper .jp-InputPlaceholder)"
    text = ".jp-MarkdownCell:has(.answer)"
    rows = [
        f".jp-Cell:has(.predict){f' + :is({code}, {text})' * count} > .jp-Cell-outputWrapper"
        for count in range(1, MOST_FOLDED + 1)
    ]
    places = ",\n".join([*rows, f"{code} + {text}"])
    return f"{places} {{ display: none; }}\n"


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
    said: dict[str, list[Any]] = {}
    for value, right, feedback in foreseen(question):
        for key in _keys(question, value):
            verdict = {"value": value, "right": right, "feedback": feedback}
            said.setdefault(key, []).append(verdict)
    yield from said.items()
    yield OTHERWISE, [{"right": False, "feedback": question.wrong_feedback}]


def _keys(question: NumericQuestion | ArrowQuestion, value: Any) -> list[str]:
    """Return the keys of the answers that are a value: drawers, or the crossing of the grid."""
    if isinstance(question, ArrowQuestion):
        return [" ".join(map(str, question.crossing(value)))]
    return [str(drawer) for drawer in _drawers(value, question.tolerance)]


def _drawers(value: float, tolerance: float) -> range:
    """Return the drawers in which answers within a tolerance of a value lie."""
    reach, width = tolerance * (1 + ROUNDING), 2 * tolerance
    return range(math.floor((value - reach) / width), math.floor((value + reach) / width) + 1)


def _hash(text: str) -> bytes:
    """Return SHA-256 of a text."""
    return hashlib.sha256(text.encode()).digest()


def _form(question: Question, legend: str, buttons: str) -> str:
    """Return a question with its answers, its buttons and the place of its feedback."""
    data: dict[str, Any] = {"id": question.id, "sealed": sealed_answers(question)}
    data["expected"] = expected_answer(question)
    if isinstance(question, NumericQuestion):
        data |= {"unit": question.unit, "tolerance": question.tolerance}
    if isinstance(question, ArrowQuestion):
        data |= {"spacing": question.spacing, "reach": question.reach}
    return (
        f'<form data-question="{escape(json.dumps(data))}" autocomplete="off" '
        f'data-lm-suppress-shortcuts="true">\n'
        f"<fieldset>\n<legend>{escape(legend)}</legend>\n{_answers(question)}\n{buttons}\n"
        f'<p class="verdict" role="status"></p>\n</fieldset>\n</form>'
    )


def _check_button(place: int) -> str:
    """Return the button that judges one question of a quiz."""
    return f'<button type="submit" aria-label="Check question {place}">Check</button>'


def _answers(question: Question) -> str:
    """Return the radio buttons, the box for a number, or the sheet for an arrow with two boxes."""
    if isinstance(question, ChoiceQuestion):
        return "\n".join(
            f'<label><input type="radio" name="{question.id}" value="{letter}"> '
            f"<span>{letter}) {escape(option.text)}</span></label>"
            for letter, option in question.lettered
        )
    if isinstance(question, ArrowQuestion):
        boxes = "\n".join(
            f'<label>{axis} in {escape(question.unit)}: <input type="text" name="{question.id}">'
            "</label>"
            for axis in "xy"
        )
        return f'{sheet(question)}\n<div class="components">\n{boxes}\n</div>'
    label = f"Answer: {escape(expected_answer(question))}."
    return f'<label>{label} <input type="text" name="{question.id}"></label>'

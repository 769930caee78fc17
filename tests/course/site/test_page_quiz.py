"""The quiz of a page: what stands in it, and what only an answer can open."""

from __future__ import annotations

import hashlib
import json
import re
from html import unescape
from typing import Any

import pytest

from lesson_code.course.quiz.bank import ChoiceQuestion, NumericQuestion, Quiz, load_bank
from lesson_code.course.site.page_quiz import key_name, quiz_html, seal, sealed_answers

CHAPTERS = pytest.mark.parametrize("chapter", load_bank(), ids=lambda chapter: chapter.number)


def opened(question: str, answer: str, sealed: str) -> str:
    """Return a sealed text, opened as the docstring of `seal` says."""
    data = bytes.fromhex(sealed)
    blocks = range(len(data) // 32 + 1)
    stream = b"".join(hashlib.sha256(f"{question}|{answer}|{k}".encode()).digest() for k in blocks)
    return bytes(a ^ b for a, b in zip(data, stream, strict=False)).decode()


def read(question: Any, answer: str) -> Any:
    """Return what is said to an answer, or None for one that was not foreseen."""
    sealed = sealed_answers(question).get(key_name(question.id, answer))
    return None if sealed is None else json.loads(opened(question.id, answer, sealed))


def test_sealed_text_is_read_with_its_answer_alone() -> None:
    """Another answer gives no part of it, and no word of it stands in the clear."""
    text = "Momentum is kept. " * 5
    sealed = seal("01-kept", "b", text)
    assert opened("01-kept", "b", sealed) == text
    assert text[:32].encode().hex() not in sealed
    wrong = bytes.fromhex(sealed)[0] ^ hashlib.sha256(b"01-kept|c|0").digest()[0]
    assert wrong != ord(text[0])


@CHAPTERS
def test_page_holds_no_answer_in_the_clear(chapter: Quiz) -> None:
    """No feedback but that to any other number, no value, and no word which option is right."""
    html = unescape(quiz_html(chapter))
    for question in chapter.questions:
        if isinstance(question, ChoiceQuestion):
            assert all(option.feedback not in html for option in question.options)
        else:
            assert question.right_feedback not in html
            assert f'"value": {question.value}' not in html
    assert '"right"' not in html


@CHAPTERS
def test_letters_open_their_feedback(chapter: Quiz) -> None:
    """Each option's letter opens what is said to it, and one of them is right."""
    for question in chapter.questions:
        if isinstance(question, ChoiceQuestion):
            said = {letter: read(question, letter) for letter, _ in question.lettered}
            feedback = {letter: [option.feedback] for letter, option in question.lettered}
            assert {k: [v["feedback"] for v in found] for k, found in said.items()} == feedback
            right = [letter for letter, [verdict] in said.items() if verdict["right"]]
            assert right == [question.answer]


@CHAPTERS
def test_drawers_of_a_value_open_its_feedback(chapter: Quiz) -> None:
    """The drawers at a value and at both edges of its tolerance hold the exact value."""
    for question in chapter.questions:
        if isinstance(question, NumericQuestion):
            reach = question.tolerance
            for value in (question.value, *(wrong.value for wrong in question.wrong_values)):
                for given in (value - reach, value, value + reach):
                    said = read(question, str(int(given // (2 * reach))))
                    assert value in [verdict["value"] for verdict in said]


def test_value_far_off_opens_nothing() -> None:
    """A number that nobody foresaw has no drawer; the page has words for it in the clear."""
    [question] = [q for q in load_bank()[2].questions if q.id == "02-measure"]
    assert isinstance(question, NumericQuestion)
    assert read(question, str(int(17 // (2 * question.tolerance)))) is None
    assert question.wrong_feedback in unescape(quiz_html(load_bank()[2]))


@CHAPTERS
def test_every_question_is_a_form_with_its_text_and_options(chapter: Quiz) -> None:
    """A legend, a button with a name of its own, a place that is read out, and all options."""
    html = quiz_html(chapter)
    places = [str(place + 1) for place in range(len(chapter.questions))]
    assert html.count("<form") == html.count('class="verdict" role="status"') == len(places)
    assert re.findall(r'aria-label="Check question (\d)"', html) == places
    for place, question in enumerate(chapter.questions, start=1):
        assert f"<legend>{place}. {question.text}</legend>" in unescape(html)
        for option in getattr(question, "options", ()):
            assert f") {option.text}</span>" in unescape(html)

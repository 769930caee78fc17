"""Questions as forms: what stands in them, and what only an answer can open."""

from __future__ import annotations

import hashlib
import json
import re
from html import unescape
from typing import Any

import pytest

from lesson_code.course.quiz.bank import Quiz, load_bank
from lesson_code.course.quiz.forms import (
    OTHERWISE,
    key_name,
    prediction_html,
    quiz_html,
    seal,
    sealed_answers,
)
from lesson_code.course.quiz.questions import (
    ArrowQuestion,
    ChoiceQuestion,
    NumericQuestion,
    Option,
    Question,
)

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
def test_form_holds_no_answer_in_the_clear(chapter: Quiz) -> None:
    """No feedback, no value, and no word which option is right."""
    html = unescape(quiz_html(chapter) + "".join(map(prediction_html, chapter.predictions)))
    for question in (*chapter.questions, *chapter.predictions):
        if isinstance(question, ChoiceQuestion):
            assert all(option.feedback not in html for option in question.options)
        else:
            assert question.right_feedback not in html
            assert question.wrong_feedback not in html
            assert f'"value": {question.value}' not in html
    assert '"right":' not in html


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


@CHAPTERS
def test_tips_of_arrows_open_their_feedback(chapter: Quiz) -> None:
    """Each tip that is recognised has its own words; the sheet shows the given arrows only."""
    for question in chapter.predictions:
        if isinstance(question, ArrowQuestion):
            for tip, feedback in (
                (question.value, question.right_feedback),
                *((wrong.value, wrong.feedback) for wrong in question.wrong_values),
            ):
                x, y = question.crossing(tip)
                assert [said["feedback"] for said in read(question, f"{x} {y}")] == [feedback]
            html = prediction_html(question)
            assert html.count('class="given"') == len(question.given) > 0
            assert 'class="drawn" d=""' in html


def test_value_far_off_opens_nothing() -> None:
    """A number that nobody foresaw has no drawer; the words for it are sealed with the id alone."""
    [question] = [q for q in load_bank()[2].questions if q.id == "02-measure"]
    assert isinstance(question, NumericQuestion)
    assert read(question, str(int(17 // (2 * question.tolerance)))) is None
    assert read(question, OTHERWISE)[0]["feedback"] == question.wrong_feedback


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


def test_texts_are_escaped() -> None:
    """Text that looks like HTML is shown as text."""
    options = (Option("<script>", "<i>No</i> & no."), Option("a & b", 'Yes, "<".'))
    tricky: Question = ChoiceQuestion("07-x", "Is <b>x</b> < y?", options, "b")
    for html in (quiz_html(Quiz("07", "Less < more", (tricky,))), prediction_html(tricky)):
        form = html[: html.index("<style>")]
        assert "&lt;b&gt;x&lt;/b&gt; &lt; y?" in form
        assert "&lt;script&gt;" in form
        assert not [raw for raw in ("<b>x", "<script>", "<i>", "Less < more") if raw in form]


def test_prediction_can_be_passed_over() -> None:
    """Beside the button that commits stands one that opens the answer without."""
    html = prediction_html(load_bank()[1].predictions[0])
    assert html.count('<button type="submit">') == html.count('<button type="button"') == 1

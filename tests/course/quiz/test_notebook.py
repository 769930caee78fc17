"""Quiz and predictions in a notebook: what is displayed, as a form and as text."""

from __future__ import annotations

import subprocess
import sys
from html import escape
from typing import Any

import pytest

from lesson_code.course.quiz import notebook
from lesson_code.course.quiz.bank import load_bank, load_quiz
from lesson_code.course.quiz.forms import asleep, prediction_html, quiz_html
from lesson_code.course.quiz.notebook import predict, quiz_as_text, show_quiz
from lesson_code.course.quiz.questions import ChoiceQuestion, NumericQuestion, Question

PREDICTIONS = [question for quiz in load_bank() for question in quiz.predictions]
ASKED = [question for quiz in load_bank() for question in quiz.questions] + PREDICTIONS


@pytest.fixture
def displayed(monkeypatch: pytest.MonkeyPatch) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Collect what is displayed, in place of a notebook's front end."""
    calls: list[tuple[dict[str, Any], dict[str, Any]]] = []
    monkeypatch.setattr(notebook, "display", lambda data, **options: calls.append((data, options)))
    return calls


def said_to_answers(question: Question) -> list[str]:
    """Return what is said to the answers of a question."""
    if isinstance(question, ChoiceQuestion):
        return [option.feedback for option in question.options]
    wrong = [wrong.feedback for wrong in question.wrong_values]
    return [question.right_feedback, question.wrong_feedback, *wrong]


def test_quiz_is_displayed_as_a_form_and_as_text(displayed: Any) -> None:
    """One bundle holds the form and the same as plain text."""
    show_quiz("03")
    [(bundle, options)] = displayed
    quiz = load_quiz("03")
    assert options == {"raw": True}
    assert bundle == {"text/html": quiz_html(quiz), "text/plain": quiz_as_text(quiz)}


@pytest.mark.parametrize("question", PREDICTIONS, ids=lambda question: question.id)
def test_prediction_is_displayed_as_a_form_and_as_text(displayed: Any, question: Question) -> None:
    """Question, options, unit and how to answer stand in both; no answer stands in either."""
    predict(question.id)
    [(bundle, _)] = displayed
    assert set(bundle) == {"text/html", "text/plain"}
    for text, written in ((bundle["text/html"], escape), (bundle["text/plain"], str)):
        assert written(question.text) in text
        assert asleep(question.id) in text
        for option in getattr(question, "options", ()):
            assert written(option.text) in text
        if isinstance(question, NumericQuestion) and question.unit:
            assert f"a number in {written(question.unit)}" in text
        assert not [said for said in said_to_answers(question) if written(said) in text]


def test_unknown_prediction_is_refused_by_name(displayed: Any) -> None:
    """A question of the quiz is no prediction."""
    asked = load_quiz("01").questions[0].id
    with pytest.raises(ValueError, match=f"question must be a prediction.*'{asked}'"):
        predict(asked)
    assert displayed == []


def test_forms_are_the_same_on_every_run() -> None:
    """Another process makes the same bytes: nbval compares them."""
    program = (
        "import sys; from lesson_code.course.quiz.forms import *;"
        "from lesson_code.course.quiz.bank import load_quiz; quiz = load_quiz('01');"
        "made = quiz_html(quiz) + prediction_html(quiz.predictions[0]);"
        "sys.stdout.buffer.write(made.encode())"
    )
    elsewhere = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    quiz = load_quiz("01")
    assert elsewhere.stdout.decode() == quiz_html(quiz) + prediction_html(quiz.predictions[0])


@pytest.mark.parametrize("quiz", load_bank(), ids=lambda quiz: quiz.number)
def test_text_of_a_quiz_holds_every_question_and_option(quiz: Any) -> None:
    """A reader without a browser sees what is asked, and no answer."""
    text = quiz_as_text(quiz)
    for question in quiz.questions:
        assert question.text in text
        assert all(option.text in text for option in getattr(question, "options", ()))
        assert not [said for said in said_to_answers(question) if said in text]

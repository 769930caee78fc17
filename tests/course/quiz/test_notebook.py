"""The notebook quiz: clicks, feedback, and what a reader without a kernel sees."""

from __future__ import annotations

import subprocess
import sys
from html import escape
from html.parser import HTMLParser
from typing import Any

import ipywidgets as widgets
import pytest

from lesson_code.course.quiz import notebook
from lesson_code.course.quiz.bank import (
    ChoiceQuestion,
    NumericQuestion,
    Option,
    Quiz,
    chapter_numbers,
    load_bank,
    load_quiz,
)
from lesson_code.course.quiz.checker import right_answer
from lesson_code.course.quiz.notebook import (
    HOW_TO_ANSWER,
    QuestionForm,
    QuizForm,
    questions_as_html,
    questions_as_text,
    show_quiz,
)

WIDGET = "application/vnd.jupyter.widget-view+json"
TRICKY = Quiz(
    "07",
    "Less < more & 'more'",
    (
        ChoiceQuestion(
            "07-x",
            "Is <b>x</b> < y?",
            (Option("<script>", "<i>No</i> & no."), Option("a & b", 'Yes, "<".')),
            "b",
        ),
    ),
)


def shown(form: QuestionForm, answer: str | None) -> str:
    """Answer a question, click, and return the feedback."""
    form.answer.value = answer
    form.button.click()
    return str(form.feedback.value)


def right(form: QuestionForm) -> str:
    """Return what to enter for a right answer."""
    question = form.question
    return question.answer if isinstance(question, ChoiceQuestion) else right_answer(question)


def descendants(widget: Any) -> list[Any]:
    """Return a widget and all widgets in it."""
    inside = [w for child in getattr(widget, "children", ()) for w in descendants(child)]
    return [widget, *inside]


@pytest.fixture
def displayed(monkeypatch: pytest.MonkeyPatch) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Collect what is displayed, in place of a notebook's front end."""
    calls: list[tuple[dict[str, Any], dict[str, Any]]] = []
    monkeypatch.setattr(notebook, "display", lambda data, **options: calls.append((data, options)))
    return calls


@pytest.mark.parametrize("number", chapter_numbers())
def test_right_answers_count_up_to_all(number: str) -> None:
    """Right answers, clicked one by one, get their reason and count up to all."""
    quiz = QuizForm(load_quiz(number))
    total = len(quiz.questions)
    assert f"0 of {total} right" in quiz.count.value
    for count, form in enumerate(quiz.questions, start=1):
        feedback = shown(form, right(form))
        assert escape(form.question.right_feedback) in feedback
        assert ": right." in feedback
        assert f"{count} of {total} right" in quiz.count.value


def test_wrong_option_gets_its_own_feedback_and_does_not_count() -> None:
    """A wrong option is answered with its feedback, naming the answer it speaks of."""
    quiz = QuizForm(load_quiz("03"))
    form = quiz.questions[0]
    assert isinstance(form.question, ChoiceQuestion)
    feedback = shown(form, "a")
    assert "a: not right." in feedback
    assert escape(form.question.options[0].feedback) in feedback
    assert "0 of 6 right" in quiz.count.value


def test_recognised_wrong_number_gets_its_hint() -> None:
    """A number from a known mistake is answered with that mistake's feedback."""
    quiz = QuizForm(load_quiz("03"))
    form = next(f for f in quiz.questions if isinstance(f.question, NumericQuestion))
    assert isinstance(form.question, NumericQuestion)
    mistake = form.question.wrong_values[0]
    assert escape(mistake.feedback) in shown(form, f"{mistake.value} m/s")


def test_answer_changed_to_wrong_counts_no_longer() -> None:
    """The count follows the answer that was last checked."""
    quiz = QuizForm(load_quiz("03"))
    form = quiz.questions[0]
    shown(form, right(form))
    shown(form, "a")
    assert "0 of 6 right" in quiz.count.value


@pytest.mark.parametrize(
    ("place", "answer", "expected"),
    [
        (0, None, "Please give a letter from a to e."),
        (3, "", "Please give a number in m/s."),
        (3, "<b>fast</b>", "Please give a number in m/s."),
    ],
)
def test_unreadable_answer_asks_for_one(place: int, answer: str | None, expected: str) -> None:
    """A click without an answer that can be read says what is expected, and judges nothing."""
    form = QuizForm(load_quiz("03")).questions[place]
    feedback = shown(form, answer)
    assert expected in feedback
    assert "right" not in feedback


def test_feedback_and_count_stand_in_status_regions() -> None:
    """Screen readers are told of feedback and count: both are status regions from the start."""
    quiz = QuizForm(load_quiz("00"))
    for region in [quiz.count, *(form.feedback for form in quiz.questions)]:
        assert region.value.startswith('<div role="status" aria-live="polite">')


def test_widgets_can_be_used_from_the_keyboard() -> None:
    """The quiz is radio buttons, text boxes and buttons, all left in the tab order."""
    for chapter in load_bank():
        everything = descendants(QuizForm(chapter).box)
        kinds = {type(widget) for widget in everything}
        assert kinds <= {
            widgets.VBox,
            widgets.HTML,
            widgets.RadioButtons,
            widgets.Text,
            widgets.Button,
        }
        assert all(widget.tabbable is not False for widget in everything)


def test_nothing_is_chosen_at_first() -> None:
    """A quiz opens without an answer, and so without a hint."""
    for form in QuizForm(load_quiz("03")).questions:
        assert form.answer.value in (None, "")


def test_long_options_are_not_cut() -> None:
    """Radio buttons are as wide as their longest option and have no empty label before them."""
    for form in QuizForm(load_quiz("03")).questions:
        if isinstance(form.question, ChoiceQuestion):
            assert form.answer.layout.width == "max-content"
            assert form.answer.description == ""


def test_all_texts_are_escaped_in_html() -> None:
    """Text that looks like HTML is shown as text, in the widgets and in the stored page."""
    quiz = QuizForm(TRICKY)
    page = questions_as_html(TRICKY)
    feedback = [shown(quiz.questions[0], letter) for letter in "ab"]
    values = [w.value for w in descendants(quiz.box) if isinstance(w, widgets.HTML)]
    for text in [page, *feedback, *values]:
        for raw in ("<b>x</b>", "<script>", "<i>", "& ", '"<"'):
            assert raw not in text.replace("&amp; ", "")
    assert "&lt;script&gt;" in page


def test_show_quiz_displays_one_bundle(displayed: Any) -> None:
    """One bundle holds the live widget, the page for readers, and the same as plain text."""
    show_quiz("03")
    [(bundle, options)] = displayed
    assert options == {"raw": True}
    assert set(bundle) == {WIDGET, "text/html", "text/plain"}
    assert bundle[WIDGET]["model_id"]
    assert bundle["text/html"] == questions_as_html(load_quiz("03"))
    assert bundle["text/plain"] == questions_as_text(load_quiz("03"))


def test_stored_texts_are_the_same_on_every_run(displayed: Any) -> None:
    """Another quiz, even in another process, stores the same bytes: nbval compares them."""
    show_quiz("03")
    show_quiz("03")
    (first, _), (second, _) = displayed
    program = (
        "import sys; from lesson_code.course.quiz.notebook import *;"
        "sys.stdout.buffer.write(questions_as_html(load_quiz('03')).encode())"
    )
    elsewhere = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    for kind in ("text/html", "text/plain"):
        assert first[kind] == second[kind]
    assert elsewhere.stdout.decode() == first["text/html"]


@pytest.mark.parametrize("number", chapter_numbers())
def test_stored_texts_hold_every_question_and_option(number: str) -> None:
    """A reader without a kernel sees what is asked, and how to answer."""
    chapter = load_quiz(number)
    page, text = questions_as_html(chapter), questions_as_text(chapter)
    for question in chapter.questions:
        wanted = [question.text]
        if isinstance(question, ChoiceQuestion):
            wanted += [option.text for option in question.options]
        for line in wanted:
            assert escape(line) in page
            assert line in text
    assert HOW_TO_ANSWER in page
    assert HOW_TO_ANSWER in text


@pytest.mark.parametrize("number", chapter_numbers())
def test_stored_texts_give_no_answer_away(number: str) -> None:
    """No feedback, no value and no mark of the right option is stored in the notebook."""
    chapter = load_quiz(number)
    page, text = questions_as_html(chapter), questions_as_text(chapter)
    for question in chapter.questions:
        feedback = [question.right_feedback]
        if isinstance(question, ChoiceQuestion):
            feedback += [option.feedback for option in question.options]
        else:
            feedback += [question.wrong_feedback, *(w.feedback for w in question.wrong_values)]
        for line in feedback:
            assert escape(line) not in page
            assert line not in text


def test_stored_texts_do_not_depend_on_which_option_is_right() -> None:
    """With another key the stored page and text are the same bytes: they hold no mark of it."""
    [question] = TRICKY.questions
    assert isinstance(question, ChoiceQuestion)
    other = ChoiceQuestion(question.id, question.text, question.options, "a")
    rekeyed = Quiz(TRICKY.number, TRICKY.title, (other,))
    assert questions_as_html(rekeyed) == questions_as_html(TRICKY)
    assert questions_as_text(rekeyed) == questions_as_text(TRICKY)


def test_stored_page_closes_every_element() -> None:
    """The stored page is well-formed: a list of questions with lists of options."""
    opened: list[str] = []

    class Balance(HTMLParser):
        def handle_starttag(self, tag: str, attrs: Any) -> None:  # noqa: ARG002
            opened.append(tag)

        def handle_endtag(self, tag: str) -> None:
            assert opened.pop() == tag

    for chapter in load_bank():
        Balance().feed(questions_as_html(chapter))
        assert opened == []

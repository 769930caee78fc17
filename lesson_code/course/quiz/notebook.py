"""The quiz in a notebook: radio buttons and number boxes, each answer judged at a click.

What is displayed holds the widgets, and for a reader without a kernel the questions as HTML and
as plain text. Those two never contain an answer and are the same on every run.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from typing import Any

import ipywidgets as widgets
from IPython.display import display

from lesson_code.course.quiz.bank import (
    ChoiceQuestion,
    NumericQuestion,
    Question,
    Quiz,
    load_quiz,
)
from lesson_code.course.quiz.checker import check_answer, expected_answer

HOW_TO_ANSWER = "Run this cell to answer."
"""What a stored notebook says to its reader in place of the buttons."""

WHOLE_LABEL = {"description_width": "initial"}
"""A label beside a box takes the room its text needs."""


def show_quiz(chapter: str) -> None:
    """Display the quiz of one chapter.

    Parameters
    ----------
    chapter : str
        The chapter's number, "03".

    Raises
    ------
    ValueError
        There is no such chapter.
    """
    loaded = load_quiz(chapter)
    form = QuizForm(loaded)
    bundle = dict(form.box._repr_mimebundle_())
    bundle["text/html"] = questions_as_html(loaded)
    bundle["text/plain"] = questions_as_text(loaded)
    display(bundle, raw=True)  # type: ignore[no-untyped-call,unused-ignore]


class QuestionForm:
    """One question with its buttons and the place where its feedback appears.

    Parameters
    ----------
    place : int
        The question's number in the quiz, from 1.
    question : Question
        What is asked.
    when_checked : callable
        Called after each answer has been judged.

    Attributes
    ----------
    answer : ipywidgets.RadioButtons or ipywidgets.Text
        Where the answer is given.
    button : ipywidgets.Button
        Judges the answer.
    feedback : ipywidgets.HTML
        Says what there is to say to it.
    right : bool
        Whether the answer that was last judged is right.
    box : ipywidgets.VBox
        All of them together.
    """

    def __init__(self, place: int, question: Question, when_checked: Callable[[], None]) -> None:
        self.question = question
        self.right = False
        self.answer = _answer_widget(question)
        self.button = widgets.Button(description="Check", tooltip=f"Check question {place}")
        self.feedback = widgets.HTML(value=_status())
        self.box = widgets.VBox(
            [
                widgets.HTML(value=f"<p><b>{place}.</b> {escape(question.text)}</p>"),
                self.answer,
                self.button,
                self.feedback,
            ]
        )
        self._when_checked = when_checked
        self.button.on_click(self._check)

    def _check(self, _button: Any) -> None:
        """Judge the answer and say so; one that cannot be read is neither right nor wrong."""
        given = self.answer.value
        try:
            verdict = check_answer(self.question, given)
        except ValueError:
            self.feedback.value = _status("", f"Please give {expected_answer(self.question)}.")
            return
        self.right = verdict.right
        word = "right" if verdict.right else "not right"
        self.feedback.value = _status(f"{given.strip()}: {word}.", verdict.feedback)
        self._when_checked()


class QuizForm:
    """A quiz, and the count of those answered right.

    Parameters
    ----------
    quiz : Quiz
        What is asked.

    Attributes
    ----------
    questions : list of QuestionForm
        In the order of the quiz.
    count : ipywidgets.HTML
        "2 of 5 right".
    box : ipywidgets.VBox
        The whole quiz.
    """

    def __init__(self, quiz: Quiz) -> None:
        self.questions = [
            QuestionForm(place, question, self._count)
            for place, question in enumerate(quiz.questions, start=1)
        ]
        self.count = widgets.HTML()
        self._count()
        title = widgets.HTML(value=f"<p><b>{escape(_title(quiz))}</b></p>")
        self.box = widgets.VBox([title, *(form.box for form in self.questions), self.count])

    def _count(self) -> None:
        """Write how many questions are answered right by now."""
        right = sum(form.right for form in self.questions)
        self.count.value = _status(f"{right} of {len(self.questions)} right")


def questions_as_html(quiz: Quiz) -> str:
    """Return a chapter's questions and options as an ordered list, without answers."""
    items = "\n".join(_item(question) for question in quiz.questions)
    return (
        f"<p><b>{escape(_title(quiz))}</b></p>\n<ol>\n{items}\n</ol>\n"
        f"<p>{escape(HOW_TO_ANSWER)}</p>"
    )


def questions_as_text(quiz: Quiz) -> str:
    """Return a chapter's questions and options as plain text, without answers."""
    lines = [_title(quiz)]
    for place, question in enumerate(quiz.questions, start=1):
        lines += ["", f"{place}. {question.text}"]
        lines += [f"   {line}" for line in _lines_below(question)]
    return "\n".join([*lines, "", HOW_TO_ANSWER])


def _item(question: Question) -> str:
    """Return a question as an item of a list."""
    if isinstance(question, NumericQuestion):
        return f"<li>{escape(question.text)} {escape(_answer_line(question))}</li>"
    options = "".join(f"<li>{escape(option.text)}</li>" for option in question.options)
    return f'<li>{escape(question.text)}\n<ol type="a">{options}</ol></li>'


def _lines_below(question: Question) -> list[str]:
    """Return what stands below a question: its options, or what kind of number it wants."""
    if isinstance(question, NumericQuestion):
        return [_answer_line(question)]
    return [_labelled(letter, option.text) for letter, option in question.lettered]


def _answer_widget(question: Question) -> Any:
    """Return the empty widget that takes the answer."""
    if isinstance(question, ChoiceQuestion):
        options = [(_labelled(letter, option.text), letter) for letter, option in question.lettered]
        # Radio buttons cut long labels off unless they are as wide as the longest.
        return widgets.RadioButtons(
            options=options, value=None, description="", layout={"width": "max-content"}
        )
    return widgets.Text(description=_answer_line(question), style=WHOLE_LABEL)


def _answer_line(question: Question) -> str:
    """Return the label of a number box."""
    return f"Answer: {expected_answer(question)}."


def _labelled(letter: str, text: str) -> str:
    """Return an option with its letter."""
    return f"{letter}) {text}"


def _title(quiz: Quiz) -> str:
    """Return the quiz's heading."""
    return f"Quiz {quiz.number}: {quiz.title}"


def _status(strong: str = "", text: str = "") -> str:
    """Return a line that a screen reader reads out when it changes."""
    words = f"<b>{escape(strong)}</b> {escape(text)}" if strong else escape(text)
    return f'<div role="status" aria-live="polite">{words.strip()}</div>'

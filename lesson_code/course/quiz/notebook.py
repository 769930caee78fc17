"""The questions of a chapter in its notebook: predictions before a result, and the quiz at the end.

What is displayed is a form that is judged where it stands (:mod:`lesson_code.course.quiz.forms`),
and the question as plain text. Neither holds an answer that can be read, and both are the same on
every run.
"""

from __future__ import annotations

from IPython.display import display

from lesson_code.course.quiz.bank import Quiz, load_quiz
from lesson_code.course.quiz.checker import expected_answer
from lesson_code.course.quiz.forms import asleep, prediction_html, quiz_html
from lesson_code.course.quiz.questions import ChoiceQuestion, Question, lines_below


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
    quiz = load_quiz(chapter)
    _display(quiz_html(quiz), quiz_as_text(quiz))


def predict(question: str) -> None:
    """Ask for a prediction; an answer to it opens the folded cells below this one.

    The cells that show the result follow directly and carry the tag ``answer``. A reader who does
    not want to answer opens them with a button, or one by one.

    Parameters
    ----------
    question : str
        Its id in the chapter's ``quiz.toml``, such as "03-once".

    Raises
    ------
    ValueError
        There is no such prediction.

    Examples
    --------
    >>> predict("03-never-asked")
    Traceback (most recent call last):
        ...
    ValueError: question must be a prediction of chapter 03, got '03-never-asked'
    """
    chapter = question[:2]
    known = {asked.id: asked for asked in load_quiz(chapter).predictions}
    if question not in known:
        raise ValueError(f"question must be a prediction of chapter {chapter}, got {question!r}")
    asked = known[question]
    text = "\n".join([f"Predict: {asked.text}", *_lines_below(asked), "", asleep(question)])
    _display(prediction_html(asked), text)


def quiz_as_text(quiz: Quiz) -> str:
    """Return a chapter's questions and options as plain text, without answers."""
    lines = [f"Quiz {quiz.number}: {quiz.title}"]
    for place, question in enumerate(quiz.questions, start=1):
        lines += ["", f"{place}. {question.text}", *_lines_below(question)]
    return "\n".join([*lines, "", asleep(quiz.number)])


def _lines_below(question: Question) -> list[str]:
    """Return what stands below a question: its options, or what kind of number it wants."""
    lines = lines_below(question)
    if not isinstance(question, ChoiceQuestion):
        lines.append(f"Answer: {expected_answer(question)}.")
    return [f"   {line}" for line in lines]


def _display(html: str, text: str) -> None:
    """Display a form, and its text where no form can be shown."""
    display({"text/html": html, "text/plain": text}, raw=True)  # type: ignore[no-untyped-call]

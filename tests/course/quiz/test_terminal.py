"""The terminal quiz, with scripted answers."""

from __future__ import annotations

import io
import subprocess
import sys
from collections.abc import Callable, Iterable

import pytest
from rich.console import Console

from lesson_code.course.quiz.bank import load_asked, load_quiz
from lesson_code.course.quiz.checker import right_answer
from lesson_code.course.quiz.questions import ChoiceQuestion, NumericQuestion, Question
from lesson_code.course.quiz.result import ChapterScore
from lesson_code.course.quiz.terminal import run_quiz

CHAPTER = load_quiz("02")
FIRST, SECOND = CHAPTER.questions[:2]
WIDE = 1000
"""Columns, so that no text is wrapped and each can be searched for."""


def console() -> Console:
    """Return a console that writes to memory."""
    return Console(file=io.StringIO(), width=WIDE)


def written(console: Console) -> str:
    """Return what was printed."""
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue()


def scripted(answers: Iterable[str], end: type[BaseException] = EOFError) -> Callable[[str], str]:
    """Return an `ask` that gives these answers, then ends."""
    remaining = iter(answers)

    def ask(prompt: str) -> str:
        for answer in remaining:
            return answer
        raise end

    return ask


def right(question: Question) -> str:
    """Return the right answer as it is typed."""
    if isinstance(question, ChoiceQuestion):
        return question.answer
    return right_answer(question)


def test_all_right_counts_every_question() -> None:
    """Right answers to two chapters give two full rows and a finished quiz."""
    chapters = [load_quiz("01"), load_quiz("03")]
    out = console()
    answers = [right(question) for chapter in chapters for question in chapter.questions]
    result = run_quiz(["01", "03"], out, scripted(answers))
    assert result.finished
    assert result.scores == tuple(ChapterScore(c.number, *[len(c.questions)] * 3) for c in chapters)
    for chapter in chapters:
        for question in chapter.questions:
            assert question.text in written(out)
            assert question.right_feedback in written(out)
    assert "Not right." not in written(out)


def test_wrong_then_right_gets_feedback_and_a_second_try() -> None:
    """A wrong answer gets its own feedback; the second try is not right first time."""
    assert isinstance(FIRST, ChoiceQuestion)
    out = console()
    result = run_quiz(["02"], out, scripted(["a", right(FIRST)]))
    assert f"Not right. {FIRST.options[0].feedback}" in written(out)
    assert "You have one more try." in written(out)
    assert result.scores == (ChapterScore("02", asked=1, right_first=0, right=1),)


def test_wrong_twice_tells_the_answer() -> None:
    """After the second wrong answer the right one is told, with its reason."""
    assert isinstance(FIRST, ChoiceQuestion)
    out = console()
    result = run_quiz(["02"], out, scripted(["a", "b"]))
    assert f"The answer is {FIRST.answer}) {FIRST.right_option.text}." in written(out)
    assert FIRST.right_feedback in written(out)
    assert result.questions[0].answers == ("a", "b")
    assert not result.questions[0].right


def test_answer_is_not_told_before_the_last_try() -> None:
    """One wrong answer does not give the right one away."""
    out = console()
    run_quiz(["02"], out, scripted(["a"]))
    assert "The answer is" not in written(out)
    assert FIRST.right_feedback not in written(out)


def test_unreadable_answer_is_asked_again_and_costs_no_try() -> None:
    """Bad input is not a wrong answer."""
    out = console()
    result = run_quiz(["02"], out, scripted(["", "z", "12", right(FIRST), "much"]))
    assert written(out).count("Please try again: the answer must be a letter from a to d") == 3
    assert "Please try again: the answer must be a number, such as 0.25, got 'much'." in written(
        out
    )
    assert result.scores == (ChapterScore("02", asked=1, right_first=1, right=1),)


def test_recognised_wrong_number_gets_its_hint() -> None:
    """A number from a known mistake is answered with that mistake's feedback."""
    assert isinstance(SECOND, NumericQuestion)
    out = console()
    mistake = SECOND.wrong_values[0]
    run_quiz(["02"], out, scripted([right(FIRST), str(mistake.value)]))
    assert mistake.feedback in written(out)


@pytest.mark.parametrize("name", ["02-ruler", "03-bumper", "05-gain"])
def test_one_prediction_is_asked_by_its_id(name: str) -> None:
    """A number, an arrow and a choice: what a notebook asks can be answered as text."""
    (question,) = load_asked(name).questions
    out = console()
    result = run_quiz([name], out, scripted([right(question)]))
    assert [asked.id for asked in result.questions] == [name]
    assert result.finished
    assert result.scores[0].right_first == 1
    assert question.right_feedback in written(out)


def test_unknown_question_is_refused_before_anything_is_asked() -> None:
    """The error names those of the chapter."""
    with pytest.raises(ValueError, match=r"question must be one of .*02-ruler.*, got '02-rulers'"):
        run_quiz(["01", "02-rulers"], console(), scripted([]))


@pytest.mark.parametrize("end", [EOFError, KeyboardInterrupt])
def test_end_of_input_ends_politely_with_the_summary(end: type[BaseException]) -> None:
    """The end of input or Ctrl-C keeps what was answered, a half-answered question too."""
    out = console()
    result = run_quiz(["02"], out, scripted([right(FIRST), "-0.75"], end))
    assert not result.finished
    assert result.scores == (ChapterScore("02", asked=2, right_first=1, right=1),)
    assert "The quiz ends here." in written(out)
    assert "02 Restitution" in written(out)


def test_end_before_the_first_answer_says_so() -> None:
    """Without an answer there is no table, and nothing was asked."""
    out = console()
    result = run_quiz(["02"], out, scripted([]))
    assert result.questions == ()
    assert "No question was answered." in written(out)


def test_unknown_chapter_is_refused_before_anything_is_asked() -> None:
    """A wrong chapter number costs the student no answers."""
    out = console()
    with pytest.raises(ValueError, match="chapter must be one of"):
        run_quiz(["02", "99"], out, scripted([]))
    assert written(out) == ""


def test_output_is_the_same_on_every_run() -> None:
    """Questions and options keep their order."""
    first, second = console(), console()
    for out in (first, second):
        run_quiz(["00", "01"], out, scripted(["a", "b", "c", "d"]))
    assert written(first) == written(second)


def test_piped_input_is_read_and_echoed() -> None:
    """From a pipe, answers are shown after their prompts and the end is polite."""
    program = (
        "from rich.console import Console; from lesson_code.course.quiz.terminal import run_quiz;"
        "run_quiz(['02'], Console(width=200))"
    )
    run = subprocess.run(
        [sys.executable, "-c", program],
        input=f"{right(FIRST)}\n",
        capture_output=True,
        encoding="utf-8",
        env={"PYTHONIOENCODING": "utf-8"},
        timeout=60,
        check=True,
    )
    assert f"Your answer (a letter from a to d): {right(FIRST)}\nRight. " in run.stdout
    assert "The quiz ends here." in run.stdout
    assert run.stderr == ""

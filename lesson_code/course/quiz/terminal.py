"""The quiz in a terminal: one question after the other, each answer judged at once.

A wrong answer gets its feedback and a second try; then the right answer is shown. The end of input
or Ctrl-C ends the quiz with the summary of what has been answered so far. Standard input need not
be a terminal.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from typing import TypeAlias

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from lesson_code.course.quiz.bank import Quiz, load_asked
from lesson_code.course.quiz.checker import (
    CheckedAnswer,
    check_answer,
    expected_answer,
    right_answer,
)
from lesson_code.course.quiz.questions import Question, lines_below
from lesson_code.course.quiz.result import QuestionResult, QuizResult

TRIES = 2
"""Answers a question takes: the second one shows whether the feedback was understood."""

Ask: TypeAlias = Callable[[str], str]
"""Takes a prompt, returns an answer; EOFError or KeyboardInterrupt ends the quiz."""


def run_quiz(names: Sequence[str], console: Console, ask: Ask | None = None) -> QuizResult:
    """Ask every question of some chapters, or single ones, and print a summary.

    Parameters
    ----------
    names : sequence of str
        The chapters' numbers, or ids of questions, in the order in which they are asked.
    console : rich.console.Console
        Where everything is printed.
    ask : callable, optional
        Takes a prompt and returns an answer; EOFError or KeyboardInterrupt ends the quiz.
        Without it answers are read from standard input, as :func:`reader` does.

    Returns
    -------
    QuizResult
        Every answer given, and whether the quiz was finished.

    Raises
    ------
    ValueError
        A chapter or a question does not exist, before anything is asked.
    """
    loaded = [load_asked(name) for name in names]
    results: list[QuestionResult] = []
    try:
        for quiz in loaded:
            _ask_quiz(quiz, console, ask or reader(console), results)
        finished = True
    except (EOFError, KeyboardInterrupt):
        console.print("\n\nThe quiz ends here.")
        finished = False
    result = QuizResult(tuple(results), finished)
    _print_summary(result, loaded, console)
    return result


def reader(console: Console) -> Ask:
    """Return the function that reads an answer from standard input.

    When standard input is not a terminal, the answer is printed after its prompt, so that the
    output reads like that of a terminal.
    """

    def read(prompt: str) -> str:
        answer = console.input(Text(prompt))
        if not sys.stdin.isatty():
            console.print(Text(answer))
        return answer

    return read


def _ask_quiz(quiz: Quiz, console: Console, ask: Ask, results: list[QuestionResult]) -> None:
    """Ask a chapter's questions; each goes to the results, even when its answers break off."""
    console.rule(Text(f"Chapter {quiz.number}: {quiz.title}"))
    for place, question in enumerate(quiz.questions, start=1):
        _print_question(f"{place} of {len(quiz.questions)}", question, console)
        answers: list[str] = []
        verdicts: list[CheckedAnswer] = []
        try:
            _ask_question(question, console, ask, answers, verdicts)
        finally:
            if verdicts:
                right = verdicts[-1].right
                results.append(QuestionResult(quiz.number, question.id, tuple(answers), right))


def _ask_question(
    question: Question,
    console: Console,
    ask: Ask,
    answers: list[str],
    verdicts: list[CheckedAnswer],
) -> None:
    """Collect answers and their verdicts until one is right or the tries are used up."""
    for tries_left in reversed(range(TRIES)):
        answer, verdict = _ask_until_readable(question, console, ask)
        answers.append(answer)
        verdicts.append(verdict)
        _print_verdict(verdict, console)
        if verdict.right:
            return
        if tries_left:
            console.print("You have one more try.")
    console.print(Text(f"The answer is {right_answer(question)}."))
    console.print(Text(question.right_feedback))


def _ask_until_readable(
    question: Question, console: Console, ask: Ask
) -> tuple[str, CheckedAnswer]:
    """Return an answer and its verdict; what cannot be read costs no try."""
    while True:
        answer = ask(f"Your answer ({expected_answer(question)}): ").strip()
        try:
            return answer, check_answer(question, answer)
        except ValueError as error:
            console.print(Text(f"Please try again: {error}."))


def _print_question(place: str, question: Question, console: Console) -> None:
    """Print the question and its options."""
    console.print()
    console.print(Text.assemble((f"{place}. ", "bold"), question.text))
    for line in lines_below(question):
        console.print(Padding(Text(line), (0, 0, 0, 3), expand=False))


def _print_verdict(verdict: CheckedAnswer, console: Console) -> None:
    """Print the verdict in words, not in colour alone, and the feedback."""
    word = ("Right. ", "bold green") if verdict.right else ("Not right. ", "bold red")
    console.print(Text.assemble(word, verdict.feedback))


def _print_summary(result: QuizResult, quizzes: Sequence[Quiz], console: Console) -> None:
    """Print how many questions of each chapter were right at the first try."""
    if not result.questions:
        console.print("No question was answered.")
        return
    titles = {quiz.number: quiz.title for quiz in quizzes}
    table = Table("Chapter", "Right first time", "Asked", title="Summary")
    for score in result.scores:
        name = Text(f"{score.chapter} {titles[score.chapter]}")
        table.add_row(name, str(score.right_first), str(score.asked))
    console.print()
    console.print(table)

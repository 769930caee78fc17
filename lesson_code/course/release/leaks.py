"""A student's copy searched for what it must not hold: answers, hidden checks, values and keys.

The lesson itself is not searched: its notebooks and modules say what the exercises ask to be
rebuilt, and a graded answer cannot import them. The rules of programs are: they are the answers.
"""

from __future__ import annotations

import ast
import inspect
import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import Any

from lesson_code.course.fresh_copies import KEPT_EXERCISES, Files
from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.self_check import answers_in, formulas_in, squeezed
from lesson_code.course.grading.task import Function, Task
from lesson_code.course.grading.verdict import stream_of
from lesson_code.course.isolation.inside.answers import arguments_from, plain
from lesson_code.course.quiz.bank import load_bank
from lesson_code.course.quiz.questions import ChoiceQuestion, Question
from lesson_code.course.quiz.sealing import SECRET
from lesson_code.course.release.bundle import holds_answers, holds_checks, holds_rules, is_quiz

NOT_FOR_STUDENTS = ("solutions", "tests", "source", "golden")
"""Folders that stay with the instructor."""

HIDDEN_SEEDS = (7, 2_718, 9_999)
"""Seeds with which values are drawn that a copy must not hold."""

NUMBER = re.compile(r"\d+\.\d{11,}")
"""Numbers long enough that no two are the same by chance."""

DIGITS = 13
"""Characters of a number that are compared."""

ROUND = 6
"""Decimals of a number that was rounded when it was drawn: many are the same by chance."""


def leaks(files: Files, root: Path) -> Iterator[str]:
    """Yield in a line each what a student's copy holds and must not.

    Parameters
    ----------
    files : dict of str to bytes
        What stands in the files of the copy.
    root : Path
        The workbook it was made from.
    """
    texts = {name: _text(name, content) for name, content in files.items()}
    yield from _folders(files)
    yield from _answers({n: t for n, t in texts.items() if _is_searched(n)}, root)
    yield from _hidden_checks(texts)
    yield from _values(texts)
    yield from _keys(texts)


def _text(name: str, content: bytes) -> str:
    """Return what can be read in a file: all cells of a notebook, nothing of a picture."""
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        return ""
    if not name.endswith(".ipynb"):
        return text
    return "\n".join(_strings(json.loads(text)))


def _strings(value: Any) -> Iterator[str]:
    """Yield every text in a JSON value; lines of a list make one."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, list) and all(isinstance(item, str) for item in value):
        yield "".join(value)
    elif isinstance(value, list | dict):
        for item in value.values() if isinstance(value, dict) else value:
            yield from _strings(item)


def _is_searched(name: str) -> bool:
    """Return whether no line of an answer may stand in a file: it is not the lesson itself."""
    path = PurePosixPath(name)
    is_course = path.is_relative_to("lesson_code/course") or path.parts[0] == "exercises"
    is_course |= path.is_relative_to(KEPT_EXERCISES.as_posix())
    return is_course or holds_checks(path) or holds_answers(path) or is_quiz(path)


def _folders(files: Files) -> Iterator[str]:
    """Yield which files stand in folders that are not for students."""
    for name in files:
        if set(PurePosixPath(name).parts) & set(NOT_FOR_STUDENTS):
            yield f"{name}: is not for students"


def _answers(texts: Mapping[str, str], root: Path) -> Iterator[str]:
    """Yield which lines of solutions stand outside the lesson.

    A wrong model that a notebook shows may share a line with the answer; it may not be the answer.
    """
    lines = {name: squeezed(text) for name, text in texts.items()}
    shown = {n: _bodies(text) for n, text in texts.items() if holds_answers(PurePosixPath(n))}
    for exercise in exercises():
        for answer, source in answers_in(exercise.solution(root), exercise):
            for formula in formulas_in(answer, source):
                for name, text in lines.items():
                    if squeezed(formula) in text and name not in shown:
                        yield f"{name}: holds a line of the solution of {answer.name}: {formula}"
            for name, bodies in shown.items():
                if _body(answer) in bodies:
                    yield f"{name}: holds the solution of {answer.name}"


def _bodies(source: str) -> set[str]:
    """Return the bodies of all functions in some code."""
    return {_body(n) for n in ast.walk(ast.parse(source)) if isinstance(n, ast.FunctionDef)}


def _body(function: ast.FunctionDef) -> str:
    """Return what a function does, without its docstring."""
    start = 1 if ast.get_docstring(function) is not None else 0
    return "\n".join(map(ast.dump, function.body[start:]))


def _hidden_checks(texts: Mapping[str, str]) -> Iterator[str]:
    """Yield which functions that draw inputs or work out what is expected are left."""
    hidden = {
        function.__name__
        for task in _tasks()
        for function in (task.expected, *(criterion.cases for criterion in task.criteria))
        if _holds_answers_of_ours(_path_of(function))
    }
    for name, text in texts.items():
        if _holds_answers_of_ours(PurePosixPath(name)):
            defined = {n.name for n in ast.parse(text).body if isinstance(n, ast.FunctionDef)}
            for function in sorted(defined & hidden):
                yield f"{name}: holds {function}, which is for the instructor alone"


def _holds_answers_of_ours(path: PurePosixPath) -> bool:
    """Return whether a file of the instructor's workbook holds what answers are compared with."""
    return holds_checks(path) or holds_rules(path)


def _path_of(function: Function) -> PurePosixPath:
    """Return the file of the workbook that a function stands in."""
    module = getattr(inspect.getmodule(function), "__name__", "")
    return PurePosixPath(module.replace(".", "/") + ".py")


def _values(texts: Mapping[str, str]) -> Iterator[str]:
    """Yield where an expected value stands that a grader's seed draws."""
    hidden = _drawn_values()
    for name, text in texts.items():
        for found in sorted({number[:DIGITS] for number in NUMBER.findall(text)} & hidden):
            yield f"{name}: holds an expected value, {found}..."


def _drawn_values() -> set[str]:
    """Return the numbers that are expected with the hidden seeds, those of every seed left out."""
    drawn = [
        {number for task in _tasks() for number in _expected_numbers(task, seed)}
        for seed in HIDDEN_SEEDS
    ]
    return set[str]().union(*drawn) - drawn[0].intersection(*drawn[1:])


def _expected_numbers(task: Task, seed: int) -> Iterator[str]:
    """Yield the beginnings of the long numbers that a task expects with a seed."""
    for criterion in task.criteria:
        for arguments in criterion.cases(stream_of(task, criterion, seed)):
            expected = plain(task.expected(*arguments_from(arguments)))
            for number in NUMBER.findall(repr(expected)):
                if abs(float(number) - round(float(number), ROUND)) > 10.0 ** (1 - DIGITS):
                    yield number[:DIGITS]


def _keys(texts: Mapping[str, str]) -> Iterator[str]:
    """Yield where a key of the quiz, or what is said to an answer, can be read."""
    for name, text in texts.items():
        if is_quiz(PurePosixPath(name)):
            table = tomllib.loads(text)
            for question in (*table["question"], *table.get("predict", [])):
                if set(SECRET[question["kind"]]) & set(question):
                    yield f"{name}: question {question['id']} is not sealed"
    words = {
        squeezed(said)
        for quiz in load_bank()
        for question in (*quiz.questions, *quiz.predictions)
        for said in _said(question)
    }
    for name, text in texts.items():
        line = squeezed(text)
        for said in sorted(words):
            if said in line:
                yield f"{name}: holds what the quiz says to an answer: {said[:60]}"


def _said(question: Question) -> Iterator[str]:
    """Yield what is said to the answers of a question."""
    if isinstance(question, ChoiceQuestion):
        yield from (option.feedback for option in question.options)
    else:
        yield from (question.right_feedback, question.wrong_feedback)
        yield from (wrong.feedback for wrong in question.wrong_values)


def _tasks() -> Iterator[Task]:
    """Yield every task of the course."""
    return (task for exercise in exercises() for task in exercise.tasks)

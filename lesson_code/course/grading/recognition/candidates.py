"""All wrong models of a task: those its chapter lists, slips of a machine, and pairs of both."""

from __future__ import annotations

import ast
import contextlib
import sys
from collections.abc import Callable, Iterator
from functools import cache
from itertools import chain, islice, zip_longest
from random import Random
from typing import Any

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.grading.recognition.around import (
    last_slips_around,
    of_the_answer,
    rarer_slips_around,
    slips_around,
)
from lesson_code.course.grading.recognition.hints import HINTS, SAYS
from lesson_code.course.grading.recognition.in_source import (
    RightAnswer,
    model,
    of_function,
    pairs_in,
    rarer_slips_in,
    slips_in,
)
from lesson_code.course.grading.recognition.trees import name_of
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.grading.task import Function, Task, WrongModel
from lesson_code.course.isolation.inside.answers import arguments_from, load
from lesson_code.course.notebooks.root import home

SECOND_SLIPS = ("gate", "sign", "factor", "other", "exchanged", "divisor", "precedence", "clamp")
"""Kinds of slips that are looked for beside another mistake."""

WHERE_WRONG = (
    "This holds where your numbers are wrong. Elsewhere they are right, so ask also: when? "
)
"""Stands before the hint of a mistake that is made in some cases only."""

MOST_PAIRS = 600
"""Pairs of mistakes that are tried for one task."""

MOST_LINES = 300_000
"""Lines of Python that the slips of a task may take for one call: some tenths of a second, once."""


def listed(task: Task) -> tuple[WrongModel, ...]:
    """Return the wrong models that the chapter lists."""
    return task.wrong_models


@cache
def slips(task: Task) -> tuple[WrongModel, ...]:
    """Return the slips in the right answers to a task of the course."""
    return tuple(islice(_slips(task, slips_in, slips_around), most_models(task)))


@cache
def inherited(task: Task) -> tuple[WrongModel, ...]:
    """Return right answers that call another task's function, with a mistake of that task in it."""
    return tuple(islice(_inherited(task), most_models(task)))


def _inherited(task: Task) -> Iterator[WrongModel]:
    """Yield each mistake of the tasks whose functions a right answer calls, once."""
    (others,) = [each.tasks for each in exercises() if task in each.tasks] or [()]
    made: set[Task] = set()
    for answer in right_answers(task.id, task.function):
        calls = [node for node in ast.walk(answer.definition) if isinstance(node, ast.Call)]
        called = {name_of(call.func) for call in calls}
        code = answer.compiled()
        for other in [one for one in others if one.function in called and one not in made]:
            made.add(other)
            for wrong in (*other.wrong_models, *inherited(other)):
                function = answer.function(code, **{other.function: wrong.function})
                function.__name__, function.__doc__ = wrong.name, wrong.misconception
                yield WrongModel(task.id, function, wrong.hint)


@cache
def rarer_slips(task: Task) -> tuple[WrongModel, ...]:
    """Return slips that are looked for where no other explains an answer."""
    found = chain(
        _slips(task, rarer_slips_in, rarer_slips_around),
        _slips(task, lambda *_: iter(()), last_slips_around),
    )
    return tuple(islice(found, most_models(task)))


def _slips(
    task: Task,
    slips_in: Callable[[RightAnswer, str], Iterator[WrongModel]],
    slips_around: Callable[[Function, str, list[str]], Iterator[WrongModel]],
) -> Iterator[WrongModel]:
    """Yield slips around the first right answer, and in the source of all."""
    found = right_answers(task.id, task.function)
    for answer in found:
        answer.most_rounds = max(answer.most_rounds, 2 * _work_of(task)[1])
    inside = chain.from_iterable(slips_in(answer, task.id) for answer in found)
    for answer in found[:1]:
        whole = answer.function(answer.compiled())
        around = slips_around(whole, task.id, answer.parameters)
        for both_kinds in zip_longest(inside, around):  # where few are tried, some of either
            yield from filter(None, both_kinds)


@cache
def pairs(task: Task) -> tuple[WrongModel, ...]:
    """Return pairs of mistakes: a listed one or a missed condition, and a slip beside it."""
    return tuple(islice(_pairs(task), min(MOST_PAIRS, most_models(task))))


def _pairs(task: Task) -> Iterator[WrongModel]:
    """Yield pairs of mistakes, the likelier first."""
    for first in task.wrong_models:
        yield from _with_a_slip(first)
    for answer in right_answers(task.id, task.function)[:2]:
        for gate, slip in pairs_in(answer, task.id, ["gate"], SECOND_SLIPS):
            yield both(gate, slip)


@cache
def parameters(task: Task) -> tuple[str, ...]:
    """Return the names of a task's arguments, as a right answer gives them."""
    found = right_answers(task.id, task.function)
    return tuple(found[0].parameters) if found else ()


def most_models(task: Task) -> int:
    """Return how many slips may be tried: fewer where a right answer takes much work.

    Work is counted in lines of Python, so that it is the same on every machine.
    """
    lines, _ = _work_of(task)
    return len(task.criteria) * MOST_LINES // lines


@cache
def _work_of(task: Task) -> tuple[int, int]:
    """Return how many lines a right answer runs, for a call of each criterion, and rounds at most.

    Counting stops at more than all slips may take.
    """
    lines = rounds = 0

    def count(_frame: Any, event: str, _argument: Any) -> Any:
        nonlocal lines
        lines += event == "line"
        if lines > MOST_LINES:
            raise TooMuchWorkError
        return count

    found = right_answers(task.id, task.function)[:1]
    for answer in found:
        answer.most_rounds = MOST_LINES
    right = found[0].function(found[0].compiled()) if found else task.expected
    before = sys.gettrace()
    for criterion in task.criteria:
        arguments = arguments_from(next(iter(criterion.cases(Random(0)))))  # noqa: S311
        sys.settrace(count)
        try:
            right(*arguments)
        except TooMuchWorkError:
            return lines * len(task.criteria), 0
        finally:
            sys.settrace(before)
        rounds = max([rounds, *(answer.rounds for answer in found)])
    return max(lines, 1), rounds


class TooMuchWorkError(Exception):
    """Raised in a right answer that takes so much work that slips in it are not tried."""


def _with_a_slip(first: WrongModel) -> Iterator[WrongModel]:
    """Yield a listed wrong model with a slip in its source or its answer."""
    with contextlib.suppress(OSError, TypeError, SyntaxError):  # practice checks have no source
        for slip in slips_in(of_function(first.function), first.task, SECOND_SLIPS):
            yield both(first, slip)
    for slip in of_the_answer(first.function, first.task):
        yield both(first, slip)


def both(first: WrongModel, second: WrongModel) -> WrongModel:
    """Return two mistakes in one, of which the second has the function."""

    def function(*arguments: Any) -> Any:
        return second.function(*arguments)

    function.__name__ = f"{first.name} and {second.name}"
    function.__doc__ = f"{first.misconception} {second.misconception}"
    says = second.hint.removeprefix(SAYS)
    return WrongModel(first.task, function, f"{first.hint} And besides, {says}")


def right_answers(task_id: str, function: str) -> list[RightAnswer]:
    """Return the right answers to a task whose source is known: the solution, and unusual ones."""
    found = []
    for exercise in exercises():
        for task in exercise.tasks:
            if (task.id, task.function) == (task_id, function):
                found += _in_the_solution(exercise, function)
                found += [of_function(known.function) for known in task.alternatives]
    return found


def _in_the_solution(exercise: Exercise, function: str) -> list[RightAnswer]:
    """Return the solution's answer, where this copy of the workbook holds the solutions."""
    path = exercise.solution(home())
    if not path.is_file():
        return []
    units = read_submission(path).units
    names: dict[str, Any] = {}
    list(load([unit.as_request() for unit in units], names))
    return [
        RightAnswer(statement, names)
        for unit in units
        for statement in unit.statements
        if isinstance(statement, ast.FunctionDef) and statement.name == function
    ]


def in_general(found: WrongModel) -> WrongModel:
    """Return a slip without names; any other wrong model as it is."""
    if found.name not in HINTS:
        return found
    return model(found.task, found.name, lambda *arguments: found.function(*arguments), {})


def in_cases(found: WrongModel) -> WrongModel:
    """Return a mistake as one that is made in some cases only."""

    def function(*arguments: Any) -> Any:
        return found.function(*arguments)

    function.__name__, function.__doc__ = found.name, f"In some cases: {found.misconception}"
    return WrongModel(found.task, function, f"{WHERE_WRONG}{found.hint}")


def passed_over(found: WrongModel) -> WrongModel:
    """Return that a loop reaches too few, where it cannot be seen in which way."""
    return model(found.task, "passed_over", lambda *given: found.function(*given), {})


def any_case(found: WrongModel) -> WrongModel:
    """Return that cases are told apart wrongly, where several mistakes give the same there."""
    return model(found.task, "case", lambda *given: found.function(*given), {})

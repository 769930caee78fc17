"""Whatever a function returns, the grader judges it: no error, no warning, no flood, in time."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from functools import cache, partial
from random import Random
from typing import Any

import pytest
from clock import at_most
from tiers import share

from lesson_code.course.grading import difference
from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.task import Arguments, Task
from lesson_code.course.grading.tried import of_any_answer
from lesson_code.course.grading.verdict import Verdict, drawn, judge
from lesson_code.course.isolation.call_outcome import CallOutcome, call_outcome
from lesson_code.course.isolation.inside.answers import MOST_NUMBERS

SEED = 0
"""Of the inputs: the same throughout, as in a class."""

TASKS = {task.id: task for exercise in exercises() for task in exercise.tasks}
ANSWERS_A_TASK = 140
"""With 75 tasks these are more than 10,000 answers."""

FEW_ANSWERS, ONE_IN = 20, 9
"""The quick tier draws this many, for one task in so many: a task's first answer takes a second."""

LONGEST_LINE = 2_000
"""Characters of a line of feedback; of an answer it shows 300, but all of the arguments."""

MOST_SECONDS = 3.0
"""For the largest answers to all calls of a task; a usual one takes 0.01 s.

Searches for slips without a bound took 20 s."""

FEW = (0, 1, -1, 2**53, 2**64, 2**70, 10**308, -(10**308), 10**400, True, False, 0.0, -0.0)
NUMBERS = (*FEW, 5e-324, 1e-300, 1e-9, 0.1, 1e300, 1e308, -1e308, math.inf, -math.inf, math.nan)
WORDS = ("", "left", "nan", "=cmd()", "\x1b[2J", "\u202e", "\ud800", "x" * 5000)
EMPTY = ([], {}, [[]], [[[]]], [None], {"v": 1.0})
LARGE = (
    [0.5] * (MOST_NUMBERS - 1),
    [[0.5, 1.5]] * (MOST_NUMBERS // 3 - 1),
    [[1.0] * 90] * 90,
    [[[1e308, -1e308]] * 2] * 1000,
    [1e-300 * number for number in range(MOST_NUMBERS - 1)],
    list(range(MOST_NUMBERS - 1)),
    "x" * (MOST_NUMBERS - 1),
)


def leaf(stream: Random) -> Any:
    """Return a value of any kind that may stand where a number belongs."""
    kind = stream.random()
    if kind < 0.6:
        return stream.choice(NUMBERS)
    if kind < 0.8:
        return stream.gauss(0, 1) * 10.0 ** stream.randint(-320, 308)
    return stream.choice((*WORDS, *EMPTY, None))


def nested(stream: Random, depth: int = 4) -> Any:
    """Return lists of lists of such values."""
    if depth == 0 or stream.random() < 0.4:
        return leaf(stream)
    return [nested(stream, depth - 1) for _ in range(stream.randint(0, 4))]


def bent(stream: Random, right: Any) -> Any:
    """Return a right answer with some of it exchanged, scaled, added, left out or wrapped."""
    if isinstance(right, list):
        items = [bent(stream, item) if stream.random() < 0.5 else item for item in right]
        changes: tuple[Callable[[], Any], ...] = (
            lambda: [*items, leaf(stream)],
            lambda: items[1:],
            lambda: [items],
            lambda: leaf(stream),
        )
        return stream.choice(changes)() if stream.random() < 0.3 else items
    if isinstance(right, float) and stream.random() < 0.5:
        return right * stream.choice((-1, 2, 0.5, 1e300, 1e-300, 1 + 1e-7, math.inf, math.nan))
    return leaf(stream)


def any_answers(stream: Random, task: Task) -> Callable[[str, Arguments], CallOutcome]:
    """Return a function that answers every call of a task by something, as if it came by wire."""
    right = {
        repr(arguments): expected
        for criterion in task.criteria
        for arguments, expected in drawn(task, criterion, SEED)
    }
    same = nested(stream)
    makers: tuple[Callable[[Any], Any], ...] = (
        lambda _: same,
        lambda _: nested(stream),
        lambda expected: bent(stream, expected),
        lambda expected: bent(stream, expected) if stream.random() < 0.5 else expected,
    )
    make = stream.choice(makers)
    return lambda _, arguments: from_the_wire(make(right[repr(arguments)]))


def from_the_wire(value: Any) -> CallOutcome:
    """Return what the parent makes of a value that a child has sent."""
    return call_outcome(json.loads(json.dumps({"kind": "returned", "value": value})))


@cache
def judged_before(task: Task) -> Verdict:
    """Judge a wrong answer: the first one of a class makes the slips that all are compared with."""
    return judge(task, lambda *_: from_the_wire(1.2345678), SEED)


def judge_in_time(task: Task, call: Callable[[str, Arguments], CallOutcome]) -> None:
    """Judge an answer, and hold what is said of it, and the time, to the bounds."""
    judged_before(task)
    with at_most(MOST_SECONDS):
        verdict = judge(task, call, SEED)
    for line in verdict.lines:
        assert line.isprintable()
        assert len(line) < LONGEST_LINE


@pytest.mark.one_in(ONE_IN)
@pytest.mark.parametrize("task_id", TASKS)
def test_any_answer_to_any_task_is_judged(task_id: str) -> None:
    """Floats to 1e308, nan, inf, any integers, words, lists of any form: all get their marks.

    In tests warnings are errors, so that none is printed either.
    """
    stream = Random(task_id)  # noqa: S311
    for _ in range(share(ANSWERS_A_TASK, ANSWERS_A_TASK // FEW_ANSWERS)):
        judge_in_time(TASKS[task_id], any_answers(stream, TASKS[task_id]))


@pytest.mark.one_in(ONE_IN)
@pytest.mark.parametrize("task_id", TASKS)
def test_largest_answers_are_judged_in_time(task_id: str) -> None:
    """Answers with as many numbers as may be sent cost the grader a bounded time."""
    for value in LARGE:
        outcome = from_the_wire(value)
        assert outcome.kind == "returned"
        judge_in_time(TASKS[task_id], lambda *_, outcome=outcome: outcome)


@pytest.mark.parametrize("value", [1e308, -1e308, 1e200])
def test_time_of_impact_beyond_all_floats_is_judged(value: float) -> None:
    """In 7.2 the height after 1e308 s, which is said in the feedback, ended the grader."""
    verdict = judge(TASKS["7.2"], lambda *_: from_the_wire(value), SEED)
    assert not verdict.is_full


@pytest.mark.parametrize("answer", [[[1.0], [2.0]], [[], []], [[[1.0]]]], ids=str)
def test_column_where_nothing_was_expected_is_told_its_form(answer: list[Any]) -> None:
    """In B.1 an answer such as [[1], [2]] to a call with an empty answer ended the grader."""
    assert difference.of_form(answer, []) != ""


@pytest.mark.parametrize("error", [KeyError, AttributeError, AssertionError, RecursionError])
def test_error_in_a_chapters_own_words_is_none_of_the_grader(error: type[Exception]) -> None:
    """What a chapter says of an answer may fail in any way; nothing is said then."""

    def fail() -> str:
        raise error

    assert of_any_answer(fail, "") == ""


def test_answer_that_stops_early_changes_no_diagnosis_of_another() -> None:
    """Its criterion's other calls are not made; what models make of calls is kept for the class."""
    task, seed = TASKS["1.1"], 77
    swaps = next(model for model in task.wrong_models if model.name == "always_swaps")
    dies = iter([call_outcome({"kind": "died"})])
    judge(task, lambda *_: next(dies, from_the_wire([1.0, 2.0])), seed)
    verdict = judge(task, partial(call_here, {task.function: swaps.function}), seed)
    assert verdict.recognised is swaps

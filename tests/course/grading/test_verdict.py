"""From answers to marks: criteria, messages, wrong models recognised."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.course.grading.exercises import exercises, task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.recognition.candidates import WHERE_WRONG
from lesson_code.course.grading.task import Arguments, Criterion, Task, WrongModel
from lesson_code.course.grading.verdict import Verdict, judge, stream_of
from lesson_code.course.isolation.call_outcome import CallOutcome

ALL_TASKS = [task for exercise in exercises() for task in exercise.tasks]


def judged(task: Task, function: Callable[..., Any], seed: int = 1) -> Verdict:
    """Return what a function earns for a task, called in this process."""
    return judge(task, partial(call_here, {task.function: function}), seed)


def small(stream: Random) -> Iterator[Arguments]:
    """Draw two numbers below 1."""
    yield from ((stream.random(),) for _ in range(2))


def vectors(stream: Random) -> Iterator[Arguments]:
    """Draw a vector."""
    yield ((stream.random(), 2.0),)


def never_called_answer(x: Any) -> Any:
    """Return the answer of the task made up here: twice the number."""
    return 2 * x


def thrice(x: Any) -> Any:
    """Two and one make three."""
    return 3 * x


def made_up(*criteria: Criterion, **options: Any) -> Task:
    """Return a task that asks for twice a number."""
    return Task(
        "9.1", "twice", "", never_called_answer, criteria or (Criterion("small", small),), **options
    )


@pytest.mark.parametrize("task", ALL_TASKS, ids=lambda task: task.title)
def test_judge_expected_answer_earns_every_point(task: Task) -> None:
    """The expected answer itself earns full marks, without message or hint."""
    verdict = judged(task, task.expected)
    assert verdict.is_full
    assert verdict.points == task.points == sum(c.full_points for c in verdict.criteria)
    assert verdict.recognised is None
    assert {criterion.message for criterion in verdict.criteria} == {""}
    assert verdict.line == f"{task.id} {task.function}: {task.points}/{task.points} points"


@pytest.mark.one_in(100)
@pytest.mark.parametrize(
    "answer",
    [
        None,
        math.nan,
        math.inf,
        0.0,
        True,
        "text",
        (),
        (math.nan, math.nan),
        (math.inf, -math.inf),
        (None, None),
        ("a", "b"),
        (1.0, (2.0, 3.0)),
        ((1.0, 2.0), 3.0),
        ([], []),
        (1e308, 1e308),
        {"a": 1},
        object(),
    ],
    ids=range(17),
)
@pytest.mark.parametrize("task", ALL_TASKS, ids=lambda task: task.title)
def test_judge_nonsense_earns_nothing_and_gets_a_message(task: Task, answer: Any) -> None:
    """Whatever form an answer has, it is judged, with a message and without an error."""
    verdict = judged(task, lambda *_: answer)
    for criterion in verdict.criteria:
        assert (criterion.points == 0) is bool(criterion.message)
    if not (task.id.startswith("B") and answer in (None, ())):  # a free table has no contacts
        assert verdict.points == 0


def test_judge_points_are_given_criterion_by_criterion() -> None:
    """An answer that is right in one criterion alone earns that criterion's points."""
    task = made_up(Criterion("numbers", small, points=2), Criterion("vectors", vectors, points=3))
    numbers_only = judged(task, lambda x: 2 * x if np.ndim(x) == 0 else None)
    assert [c.points for c in numbers_only.criteria] == [2, 0]
    assert (numbers_only.points, task.points) == (2, 5)
    vectors_only = judged(task, lambda x: x if np.ndim(x) == 0 else (2 * x[0], 4))
    assert [c.points for c in vectors_only.criteria] == [0, 3]
    assert not vectors_only.is_full


def test_judge_criterion_is_all_or_nothing() -> None:
    """One wrong call of several loses the criterion's points."""
    calls: list[float] = []

    def right_once(x: float) -> float:
        calls.append(x)
        return 2 * x if len(calls) == 1 else 0.0

    assert judged(made_up(), right_once).points == 0
    assert len(calls) == 2


def test_judge_nan_fails_although_no_comparison_finds_it_larger() -> None:
    """Nan is a wrong answer, alone and inside a vector."""
    assert judged(made_up(), lambda x: math.nan * x).points == 0
    assert judged(made_up(Criterion("v", vectors)), lambda x: (2 * x[0], math.nan)).points == 0


def test_judge_arguments_may_be_changed_in_place() -> None:
    """An answer that changes the vector it was given is judged on what it returns."""

    def in_place(x: Any) -> Any:
        x *= 2
        return x

    task = made_up(Criterion("vectors", vectors), Criterion("again", vectors))
    assert judged(task, in_place).is_full


def test_judge_part_looks_at_that_part_alone() -> None:
    """With a part, the rest of the answer may be anything, and an answer without it fails."""
    task = made_up(Criterion("first", vectors, part=lambda answer: answer[0]))
    assert judged(task, lambda x: (2 * x[0], "anything", None)).is_full
    for answer in (None, 3.0, (), {}):
        verdict = judged(task, lambda _, answer=answer: answer)
        assert verdict.points == 0
    assert "It returned 3; expected (" in judged(task, lambda _: 3.0).criteria[0].message


def test_judge_stops_a_criterion_after_a_crash() -> None:
    """After a call that hangs or kills its process, the criterion makes no more calls."""
    calls: list[Arguments] = []

    def crashes(_: str, arguments: Arguments) -> CallOutcome:
        calls.append(arguments)
        return CallOutcome("crashed", text="it ended the process")

    task = made_up(Criterion("small", small), Criterion("vectors", vectors))
    verdict = judge(task, crashes, 1)
    assert len(calls) == 2
    assert verdict.points == 0
    assert verdict.criteria[0].message.endswith(". It ended the process.")


@pytest.mark.parametrize("task", ALL_TASKS, ids=lambda task: task.title)
def test_judge_same_seed_draws_the_same_inputs(task: Task) -> None:
    """A seed reproduces the inputs exactly; another one draws others."""

    def inputs(seed: int) -> list[list[Arguments]]:
        return [list(each.cases(stream_of(task, each, seed))) for each in task.criteria]

    assert inputs(3) == inputs(3)
    assert inputs(3) != inputs(4)


def test_judge_inputs_do_not_depend_on_the_answer() -> None:
    """A criterion draws the same inputs whatever came of the ones before."""
    task = task_by_id("1.1")
    full = judged(task, task.expected, seed=5)
    never = judged(task, lambda *_: None, seed=5)
    assert full.criteria[0].points == 1
    again = judged(task, lambda *_: 1 / 0, seed=5)
    called = never.criteria[3].message.partition(" It ")[0]
    assert again.criteria[3].message.startswith(called)


def test_judge_answer_recognised_in_a_part_gets_the_hint_for_that_part() -> None:
    """Where an answer agrees with a wrong model in some criteria only, the hint names these."""
    model = WrongModel("9.1", thrice, "Count again?")
    task = made_up(Criterion("a", small), Criterion("b", vectors), wrong_models=(model,))
    assert judged(task, thrice).recognised is model
    half = judged(task, lambda x: 3 * x if np.ndim(x) == 0 else 4 * x)
    assert half.recognised is model
    assert half.lines[-1] == "  hint: in a: Count again?"


def test_judge_answer_that_is_right_where_a_wrong_model_is_wrong_is_told_so() -> None:
    """A right answer that a model does not give rules it out, but for some cases."""
    model = WrongModel("9.1", thrice, "Count again?")
    task = made_up(Criterion("a", small), Criterion("b", vectors), wrong_models=(model,))
    found = judged(task, lambda x: 3 * x if np.ndim(x) == 0 else 2 * x).recognised
    assert found is not None
    assert found.hint == f"{WHERE_WRONG}Count again?"


def test_judge_right_answer_gets_no_hint_from_a_model_that_is_right() -> None:
    """No hint is shown where nothing is wrong, even if a wrong model gives the same."""
    model = WrongModel("9.1", never_called_answer, "?")
    assert judged(made_up(wrong_models=(model,)), lambda x: x + x).recognised is None


def test_judge_wrong_model_that_fails_is_not_recognised() -> None:
    """A wrong model that raises on some inputs stands for no number."""
    model = WrongModel("9.1", lambda _: 1 / 0, "?")
    verdict = judged(made_up(wrong_models=(model,)), lambda _: "failed: division by zero of mine")
    assert verdict.recognised is None


def test_message_says_call_answer_expectation_and_reason() -> None:
    """A message reads: what was called, what came, what was expected, and why."""
    message = (
        judged(task_by_id("1.1"), lambda *given: (given[3], given[1]), seed=1).criteria[1].message
    )
    assert message == (
        "Called elastic_1d(m1=0.82, v1=4.69, m2=4.85, v2=0). It returned (0, 4.69); expected "
        "(-3.33346, 1.35654). Momentum before 3.8458 kg m/s, after yours 22.7465 kg m/s."
    )


@pytest.mark.parametrize(
    ("function", "end"),
    [
        (lambda _: 1 / 0, "It stopped with ZeroDivisionError: division by zero."),
        (lambda _: {}, "It returned an object of type dict, which is no number, vector or tuple."),
        (lambda x: 2 * x + 1e-8, "5e-09."),
        (lambda _: "a\nb", "It returned 'a\\nb'; expected "),
        (lambda _: [0.0] * 9999, "...; expected "),
    ],
)
def test_message_of_an_unusual_failure(function: Callable[[Any], Any], end: str) -> None:
    """Errors, unusable objects, near misses, text and long answers are each said plainly."""
    task = made_up(Criterion("one", lambda _: [(2.5e-9,)]))
    message = judged(task, function).criteria[0].message
    assert message.startswith("Called twice(2.5e-09). ")
    assert end in message
    assert len(message) < 1000


def test_message_of_a_pair_that_keeps_its_momentum_says_what_differs() -> None:
    """Where before and after are the same, it is said that this is right, and what is not."""
    left_alone = judged(task_by_id("1.1"), lambda *given: (given[1], given[3]))
    message = left_alone.criteria[1].message
    assert "Momentum stays 3.8458 kg m/s, as it should." in message
    assert message.endswith("The bodies approach at 4.69 m/s and part, by yours, at -4.69 m/s.")


def test_message_of_none_does_not_ask_for_a_return_where_none_is_legal() -> None:
    """Circles that do not touch are answered by None, so that a wrong None was meant."""
    message = judged(task_by_id("4.1"), lambda *_: None).criteria[0].message
    assert message.endswith("Two values were asked for here: None is right in other cases only.")
    assert "is a return missing?" in judged(task_by_id("1.1"), lambda *_: None).lines[1]


def test_message_of_an_answer_that_is_not_there() -> None:
    """A stub is "not written yet", and a missing function is named."""

    def stub(_: Any) -> Any:
        raise NotImplementedError("Task 9.1: twice")

    assert judged(made_up(), stub).criteria[0].message == "not written yet"
    missing = judge(made_up(), partial(call_here, {}), 1)
    assert missing.criteria[0].message == "there is no function named twice"


def test_message_without_a_reason_where_the_reason_cannot_be_said() -> None:
    """A task's explanation that fails on an odd answer is left out, and no error."""

    def explain(_: Arguments, answer: Any) -> str:
        return f"{answer[0]:.3f}"

    task = made_up(explain=explain)
    for answer in (None, "text", [None], 5.0, []):
        message = judged(task, lambda _, answer=answer: answer).criteria[0].message
        assert message.endswith((".", "?"))

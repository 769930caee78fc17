"""From the answers to the marks: which criteria hold, and which wrong model was recognised."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from random import Random
from typing import Any, TypeAlias

from lesson_code.course.grading.feedback import NO_ORDER, NOT_WRITTEN, hidden_message, message
from lesson_code.course.grading.recognition import Diagnosis, diagnoses
from lesson_code.course.grading.task import Arguments, Criterion, Task, WrongModel
from lesson_code.course.grading.tried import TriedCall, quietly
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import GOES_ON, arguments_from, plain

CONSTANT = "It returned the same for every call, which is right here only by chance."

Call: TypeAlias = Callable[[str, Arguments], CallOutcome]
"""Calls a student's function by name: in this process, or across the wall."""


@dataclass(frozen=True)
class CriterionVerdict:
    """The marks for one criterion, and if they are not full a message and its reason in short."""

    name: str
    points: int
    full_points: int
    message: str = ""
    reason: str = ""


@dataclass(frozen=True)
class Verdict:
    """The marks for a task, criterion by criterion, and what explains the answer.

    `lent` are the earlier tasks whose functions the answer was given in place of its own.
    """

    task: Task
    criteria: tuple[CriterionVerdict, ...]
    diagnoses: tuple[Diagnosis, ...]
    seed: int
    lent: tuple[Task, ...] = ()

    @property
    def recognised(self) -> WrongModel | None:
        """The mistake that was recognised, if one alone explains the most."""
        mistakes = self.diagnoses[0].mistakes if self.diagnoses else ()
        return mistakes[0] if len(mistakes) == 1 else None

    @property
    def points(self) -> int:
        """The points earned."""
        return sum(criterion.points for criterion in self.criteria)

    @property
    def is_full(self) -> bool:
        """Whether every criterion holds."""
        return self.points == self.task.points

    @property
    def line(self) -> str:
        """The line a check cell prints."""
        return f"{self.task.title}: {self.points}/{self.task.points} points"

    @property
    def said_of_lent(self) -> str:
        """That the answer was marked with some of our functions, or nothing.

        >>> task = Task("4.3", "separate", "", max, (Criterion("any", iter),))
        >>> Verdict(task, (), (), 0, (task,)).said_of_lent
        "marked with the workbook's `separate` in place of yours, which lost points in 4.3"
        """
        names = " and ".join(f"`{task.function}`" for task in self.lent)
        places = " and ".join(task.id for task in self.lent)
        said = (
            f"marked with the workbook's {names} in place of yours, which lost points in {places}"
        )
        return said if self.lent else ""

    @property
    def lines(self) -> list[str]:
        """What to tell the student: the marks, what is right, what is not and why, the hint.

        Of failures for the same reason, or behind which the same wrong model was recognised, one
        is told, and the others are named.
        """
        said = [f"  {self.said_of_lent}"] if self.lent else []
        if self.is_full:
            return [self.line, *said]
        failed = [criterion for criterion in self.criteria if criterion.message]
        messages = {criterion.message for criterion in failed}
        if messages == {NOT_WRITTEN}:
            return [f"{self.line} ({NOT_WRITTEN})"]
        if len(messages) == 1 and len(failed) == len(self.criteria) > 1:  # nothing was called
            return [self.line, *said, *(f"  {message}" for message in messages)]
        lines = [self.line, *said]
        lines += [f"  right: {each.name}" for each in self.criteria if not each.message]
        for first, *others in _by_reason(failed, self.diagnoses):
            lines.append(f"  {first.name}: {first.message}")
            if others:
                lines.append(f"  for the same reason: {'; '.join(each.name for each in others)}")
        for diagnosis in self.diagnoses:
            where = "" if diagnosis.is_all else f"in {'; '.join(diagnosis.criteria)}: "
            lines.append(f"  hint: {where}{diagnosis.hint}")
        return lines


def _by_reason(
    failed: list[CriterionVerdict], diagnoses: Sequence[Diagnosis]
) -> list[list[CriterionVerdict]]:
    """Return failures in groups of the same reason, in the order of the first of each."""
    explained = {name: diagnosis.name for diagnosis in diagnoses for name in diagnosis.criteria}
    groups: dict[str, list[CriterionVerdict]] = {}
    for criterion in failed:
        key = explained.get(criterion.name) or criterion.reason or criterion.name
        groups.setdefault(key, []).append(criterion)
    return list(groups.values())


def judge(task: Task, call: Call, seed: int, *, hide_inputs: bool = False) -> Verdict:
    """Return the marks for a task.

    Parameters
    ----------
    task : Task
        What is asked.
    call : Call
        Calls the student's function.
    seed : int
        Draws the inputs; the same seed draws the same ones again.
    hide_inputs : bool
        Keep inputs, values and the words of errors out of every message.
    """
    tried = [(criterion, _try(task, criterion, call, seed)) for criterion in task.criteria]
    may_be_none = any(
        expected is None for each in task.criteria for _, expected in drawn(task, each, seed)
    )
    calls = [call for _, calls in tried for call in calls]
    with quietly():
        marks = [_mark(task, each, some, hide_inputs, may_be_none) for each, some in tried]
        if _is_constant(calls):
            marks = [mark if mark.message else _by_chance(mark) for mark in marks]
        is_written = {mark.message for mark in marks if mark.message} != {NOT_WRITTEN}
        found = diagnoses(task, calls, seed) if is_written else ()
    return Verdict(task, tuple(marks), found, seed)


def better(theirs: Verdict, ours: Verdict, lent: tuple[Task, ...]) -> Verdict:
    """Return the verdict that counts: with our functions in place of some, unless that is worse.

    Where the points are the same, it says what is wrong with this answer, and not with another.
    """
    return replace(ours, lent=lent) if lent and ours.points >= theirs.points else theirs


def _is_constant(calls: list[TriedCall]) -> bool:
    """Return whether an answer does not depend on its inputs, where what is expected does."""
    first = calls[0]
    return all(
        call.outcome.kind == "returned" and call.outcome.value == first.outcome.value
        for call in calls
    ) and any(call.expected != first.expected for call in calls)


def _by_chance(mark: CriterionVerdict) -> CriterionVerdict:
    """Return the marks for what a constant got right: none."""
    return replace(mark, points=0, message=CONSTANT, reason=CONSTANT)


def _try(task: Task, criterion: Criterion, call: Call, seed: int) -> list[TriedCall]:
    """Make the calls of one criterion; after one that hangs, crashes or is not there, no more."""
    trials: list[TriedCall] = []
    for arguments, expected in drawn(task, criterion, seed):
        outcome = call(task.function, arguments)
        if not outcome.sets <= {task.any_order}:
            outcome = CallOutcome("unusable", text=NO_ORDER)
        trials.append(TriedCall(criterion, arguments, expected, outcome))
        if outcome.kind not in GOES_ON:
            break
    return trials


def calls_of(tasks: Sequence[Task], seed: int) -> list[list[tuple[str, Arguments]]]:
    """Return the calls that judging some tasks makes, criterion by criterion."""
    return [
        [(task.function, arguments) for arguments, _ in drawn(task, criterion, seed)]
        for task in tasks
        for criterion in task.criteria
    ]


@lru_cache(maxsize=1000)
def drawn(task: Task, criterion: Criterion, seed: int) -> tuple[tuple[Arguments, Any], ...]:
    """Return the arguments that a seed draws, and what is expected of each: once for a class."""
    return tuple(
        (arguments, plain(task.expected(*arguments_from(arguments))))
        for arguments in criterion.cases(stream_of(task, criterion, seed))
    )


def stream_of(task: Task, criterion: Criterion, seed: int) -> Random:
    """Return the random stream that a seed draws the inputs of a criterion from."""
    return Random(zlib.crc32(f"{seed} {task.id} {criterion.name}".encode()))  # noqa: S311


def _mark(
    task: Task, criterion: Criterion, trials: list[TriedCall], hidden: bool, may_be_none: bool
) -> CriterionVerdict:
    """Return the marks for one criterion: all of its points or none."""
    failed = next((trial for trial in trials if not trial.is_right), None)
    if failed is None:
        return CriterionVerdict(criterion.name, criterion.points, criterion.points)
    said, reason = _message(task, failed, hidden, may_be_none)
    return CriterionVerdict(criterion.name, 0, criterion.points, said, reason)


def _message(task: Task, trial: TriedCall, hidden: bool, may_be_none: bool) -> tuple[str, str]:
    """Return what to say of a trial that failed, in the part that its criterion looks at."""
    if hidden:
        return hidden_message(trial)
    return message(task, trial, may_be_none=may_be_none)

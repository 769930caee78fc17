"""From the answers to the marks: which criteria hold, and which wrong model was recognised."""

from __future__ import annotations

import zlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from random import Random
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.compare import agrees
from lesson_code.course.grading.feedback import NOT_WRITTEN, hidden_message, message
from lesson_code.course.grading.task import Arguments, Criterion, Part, Task, WrongModel
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import arguments_from, plain

Call: TypeAlias = Callable[[str, Arguments], CallOutcome]
"""Calls a student's function by name: in this process, or across the wall."""


@dataclass(frozen=True)
class TriedCall:
    """One call: its arguments, what was expected, and what came."""

    arguments: Arguments
    expected: Any
    outcome: CallOutcome

    def agrees(self, part: Part | None) -> bool:
        """Return whether the answer is right, in the part that is looked at."""
        if self.outcome.kind != "returned":
            return False
        if part is None:
            return agrees(self.outcome.value, self.expected)
        return agrees(_part(part, self.outcome.value), plain(part(self.expected)))


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
    """The marks for a task, criterion by criterion, and the hint for a recognised wrong model."""

    task: Task
    criteria: tuple[CriterionVerdict, ...]
    recognised: WrongModel | None
    seed: int

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
    def lines(self) -> list[str]:
        """What to tell the student: the marks, what is right, what is not and why, the hint.

        Of failures for the same reason, or behind which the same wrong model was recognised, one
        is told, and the others are named.
        """
        if self.is_full:
            return [self.line]
        failed = [criterion for criterion in self.criteria if criterion.message]
        messages = {criterion.message for criterion in failed}
        if messages == {NOT_WRITTEN}:
            return [f"{self.line} ({NOT_WRITTEN})"]
        if len(messages) == 1 and len(failed) == len(self.criteria) > 1:  # nothing was called
            return [self.line, *(f"  {message}" for message in messages)]
        lines = [self.line]
        lines += [f"  right: {each.name}" for each in self.criteria if not each.message]
        for first, *others in _by_reason(failed, self.recognised):
            lines.append(f"  {first.name}: {first.message}")
            if others:
                lines.append(f"  for the same reason: {'; '.join(each.name for each in others)}")
        if self.recognised is not None:
            lines.append(f"  hint: {self.recognised.hint}")
        return lines


def _by_reason(
    failed: list[CriterionVerdict], recognised: WrongModel | None
) -> list[list[CriterionVerdict]]:
    """Return failures in groups of the same reason, in the order of the first of each."""
    groups: dict[str, list[CriterionVerdict]] = {}
    for criterion in failed:
        key = "recognised" if recognised else criterion.reason or criterion.name
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
    return Verdict(
        task,
        tuple(_mark(task, criterion, some, hide_inputs) for criterion, some in tried),
        _recognised(task, tried),
        seed,
    )


def _try(task: Task, criterion: Criterion, call: Call, seed: int) -> list[TriedCall]:
    """Make the calls of one criterion; after one that hangs, crashes or is not there, no more."""
    trials: list[TriedCall] = []
    for arguments, expected in drawn(task, criterion, seed):
        outcome = call(task.function, arguments)
        trials.append(TriedCall(arguments, expected, outcome))
        if outcome.kind not in ("returned", "raised"):
            break
    return trials


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
    task: Task, criterion: Criterion, trials: list[TriedCall], hidden: bool
) -> CriterionVerdict:
    """Return the marks for one criterion: all of its points or none."""
    failed = next((trial for trial in trials if not trial.agrees(criterion.part)), None)
    if failed is None:
        return CriterionVerdict(criterion.name, criterion.points, criterion.points)
    said, reason = _message(task, criterion, failed, hidden)
    return CriterionVerdict(criterion.name, 0, criterion.points, said, reason)


def _message(task: Task, criterion: Criterion, trial: TriedCall, hidden: bool) -> tuple[str, str]:
    """Return what to say of a trial that failed, in the part that its criterion looks at."""
    if hidden:
        return hidden_message(trial.outcome)
    got, expected = trial.outcome.value, trial.expected
    if criterion.part is not None and trial.outcome.kind == "returned":
        got, expected = _part(criterion.part, got), plain(criterion.part(expected))
    return message(task, trial.arguments, trial.outcome, got, expected)


def _part(part: Part, answer: Any) -> Any:
    """Return the part of an answer that is looked at; of an answer of another form, None."""
    try:
        return plain(part(answer))
    except (TypeError, ValueError, IndexError):
        return None


def _recognised(task: Task, tried: list[tuple[Criterion, list[TriedCall]]]) -> WrongModel | None:
    """Return the wrong model that gives just what the student's function gave, if one does.

    As for the marks, only that part of an answer counts which its criterion looks at.
    """
    returned = [
        (criterion.part, trial)
        for criterion, trials in tried
        for trial in trials
        if trial.outcome.kind == "returned"
    ]
    if all(trial.agrees(part) for part, trial in returned):
        return None
    for model in task.wrong_models:
        if all(
            agrees(_looked_at(part, trial), _wrong_answer(model, part, trial))
            for part, trial in returned
        ):
            return model
    return None


def _looked_at(part: Part | None, trial: TriedCall) -> Any:
    """Return what a criterion looks at of the answer that came."""
    return trial.outcome.value if part is None else _part(part, trial.outcome.value)


def _wrong_answer(model: WrongModel, part: Part | None, trial: TriedCall) -> Any:
    """Return what a wrong model makes of a trial's arguments, or words where it fails."""
    try:
        with np.errstate(all="ignore"):
            answer = plain(model(*arguments_from(trial.arguments)))
            return answer if part is None else plain(part(answer))
    except Exception as error:  # a wrong model may fail in any way
        return f"failed: {error}"

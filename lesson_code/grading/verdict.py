"""From the answers to the marks: which criteria hold, and which wrong model was recognised."""

from __future__ import annotations

import zlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from random import Random
from typing import Any, TypeAlias

import numpy as np

from lesson_code.grading.compare import agrees, told_apart, written
from lesson_code.grading.isolation.inside.answers import arguments_from, plain
from lesson_code.grading.isolation.outcome import Outcome
from lesson_code.grading.task import Arguments, Criterion, Part, Task, WrongModel

Call: TypeAlias = Callable[[str, Arguments], Outcome]
"""Calls a student's function by name: in this process, or across the wall."""


@dataclass(frozen=True)
class Trial:
    """One call: its arguments, what was expected, and what came."""

    arguments: Arguments
    expected: Any
    outcome: Outcome

    def agrees(self, part: Part | None) -> bool:
        """Return whether the answer is right, in the part that is looked at."""
        if self.outcome.kind != "returned":
            return False
        if part is None:
            return agrees(self.outcome.value, self.expected)
        return agrees(_part(part, self.outcome.value), plain(part(self.expected)))


@dataclass(frozen=True)
class CriterionVerdict:
    """The marks for one criterion, and a message if they are not full."""

    name: str
    points: int
    full_points: int
    message: str = ""


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


def judge(task: Task, call: Call, seed: int) -> Verdict:
    """Return the marks for a task.

    Parameters
    ----------
    task : Task
        What is asked.
    call : Call
        Calls the student's function.
    seed : int
        Draws the inputs; the same seed draws the same ones again.
    """
    tried = [(criterion, _try(task, criterion, call, seed)) for criterion in task.criteria]
    return Verdict(
        task,
        tuple(_mark(task, criterion, some) for criterion, some in tried),
        _recognised(task, tried),
        seed,
    )


def _try(task: Task, criterion: Criterion, call: Call, seed: int) -> list[Trial]:
    """Make the calls of one criterion; after one that hangs, crashes or is not there, no more."""
    trials: list[Trial] = []
    for arguments, expected in _drawn(task, criterion, seed):
        outcome = call(task.function, arguments)
        trials.append(Trial(arguments, expected, outcome))
        if outcome.kind not in ("returned", "raised"):
            break
    return trials


@lru_cache(maxsize=1000)
def _drawn(task: Task, criterion: Criterion, seed: int) -> tuple[tuple[Arguments, Any], ...]:
    """Return the arguments that a seed draws, and what is expected of each: once for a class."""
    return tuple(
        (arguments, plain(task.expected(*arguments_from(arguments))))
        for arguments in criterion.cases(stream_of(task, criterion, seed))
    )


def stream_of(task: Task, criterion: Criterion, seed: int) -> Random:
    """Return the random stream that a seed draws the inputs of a criterion from."""
    return Random(zlib.crc32(f"{seed} {task.id} {criterion.name}".encode()))  # noqa: S311


def _mark(task: Task, criterion: Criterion, trials: list[Trial]) -> CriterionVerdict:
    """Return the marks for one criterion: all of its points or none."""
    failed = next((trial for trial in trials if not trial.agrees(criterion.part)), None)
    if failed is None:
        return CriterionVerdict(criterion.name, criterion.points, criterion.points)
    return CriterionVerdict(criterion.name, 0, criterion.points, _message(task, criterion, failed))


def _message(task: Task, criterion: Criterion, trial: Trial) -> str:
    """Return what was called, what came, and what was expected and why."""
    outcome = trial.outcome
    if outcome.kind == "not written":
        return "not written yet"
    if outcome.kind == "missing":
        return outcome.text
    called = f"Called {task.function}{written(trial.arguments)}."
    if outcome.kind == "raised":
        return f"{called} It stopped with {outcome.text}."
    if outcome.kind == "unusable":
        return f"{called} It {outcome.text}."
    if outcome.kind != "returned":
        return f"{called} {outcome.text[:1].upper()}{outcome.text[1:]}."
    got, expected = outcome.value, trial.expected
    if criterion.part is not None:
        got, expected = _part(criterion.part, got), plain(criterion.part(expected))
    got_written, expected_written = told_apart(got, expected)
    says = f"{called} It returned {got_written}; expected {expected_written}."
    return f"{says} {_why(task, trial)}".rstrip()


def _why(task: Task, trial: Trial) -> str:
    """Return why a trial's answer is wrong, if the task can say it of an answer of this form."""
    if task.explain is None:
        return ""
    try:
        with np.errstate(all="ignore"):
            return task.explain(trial.arguments, trial.outcome.value)
    except (TypeError, ValueError, IndexError):
        return ""


def _part(part: Part, answer: Any) -> Any:
    """Return the part of an answer that is looked at; of an answer of another form, None."""
    try:
        return plain(part(answer))
    except (TypeError, ValueError, IndexError):
        return None


def _recognised(task: Task, tried: list[tuple[Criterion, list[Trial]]]) -> WrongModel | None:
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


def _looked_at(part: Part | None, trial: Trial) -> Any:
    """Return what a criterion looks at of the answer that came."""
    return trial.outcome.value if part is None else _part(part, trial.outcome.value)


def _wrong_answer(model: WrongModel, part: Part | None, trial: Trial) -> Any:
    """Return what a wrong model makes of a trial's arguments, or words where it fails."""
    try:
        with np.errstate(all="ignore"):
            answer = plain(model(*arguments_from(trial.arguments)))
            return answer if part is None else plain(part(answer))
    except Exception as error:  # a wrong model may fail in any way
        return f"failed: {error}"

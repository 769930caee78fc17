"""What became of a task: its result, or the error that kept it from one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

MOST_LISTED = 3
"""Errors that a message lists; the group holds all of them."""


class WorkerDiedError(RuntimeError):
    """A task whose worker ended without an answer, each time that it was tried."""


@dataclass(frozen=True)
class Outcome:
    """What became of one task.

    Attributes
    ----------
    index : int
        The task's place among the tasks, from 0.
    name : str
        What it is called in errors.
    result : object
        What the function returned; None where there is an error.
    error : Exception, optional
        What the function raised, or a WorkerDiedError. Its notes name the task.
    """

    index: int
    name: str
    result: Any = None
    error: Exception | None = None

    @classmethod
    def failed(cls, index: int, name: str, error: Exception) -> Outcome:
        """Return the outcome of a task that came to nothing; a note in the error names it."""
        error.add_note(f"in {name}")
        return cls(index, name, error=error)


class TasksFailedError(ExceptionGroup[Exception], RuntimeError):
    """Some tasks failed: a group of their errors, in the order of the tasks.

    Attributes
    ----------
    outcomes : tuple of Outcome
        Of all tasks, in their order: what the others gave is not lost.
    """

    outcomes: tuple[Outcome, ...]

    def __new__(cls, outcomes: Sequence[Outcome]) -> TasksFailedError:
        """Return the group of the errors in some outcomes, of which there must be one."""
        failed = [(outcome.name, outcome.error) for outcome in outcomes if outcome.error]
        lines = [f"{name}: {type(error).__name__}: {error}" for name, error in failed]
        more = f"; and {len(lines) - MOST_LISTED} more" if len(lines) > MOST_LISTED else ""
        listed = "; ".join(lines[:MOST_LISTED])
        message = f"{len(failed)} of {len(outcomes)} tasks failed: {listed}{more}"
        group = super().__new__(cls, message, [error for _, error in failed])
        group.outcomes = tuple(outcomes)
        return group

    def __str__(self) -> str:
        """Return the message alone: it counts the errors itself."""
        return self.message

"""One mistake is charged once: later tasks that call a wrong function are tried with ours.

Ours never crosses the wall, where the student's code could read it. The child asks for one value
after another; it is worked out in a process of the course's own, since a student chooses the
arguments, and with them how much work there is.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Task
from lesson_code.course.isolation.clerk import Clerk, one_a_process
from lesson_code.course.isolation.inside import limits
from lesson_code.course.isolation.inside.answers import (
    NotPlainError,
    arguments_from,
    lendable,
    plain,
)

SECONDS, MOST_MEMORY = 2, 1_500_000_000
"""Of the processor, and bytes, that one value may take; the slowest takes 10 ms."""

MOST_VALUES = 10_000
"""Values that a submission is lent; the fall of the soft body asks for 2,770."""

MOST_SECONDS = 10.0
"""Of the processor, for all values that a submission is lent."""

MOST_KEPT, LONGEST_KEPT = 20_000, 2_000
"""Values that are kept, and characters of one with its arguments: 40 MB at most."""


@one_a_process
def _clerk() -> Clerk:
    """Return the process that works out values."""
    path = [*filter(None, sys.path), str(Path(__file__).parents[3])]
    boot = f"import sys; sys.path[:] = {path!r}; from {__name__} import main; main()"
    return Clerk([sys.executable, "-P", "-c", boot], os.environ, SECONDS)  # nothing of this folder


class Allowance:
    """What is left of what a submission may borrow."""

    def __init__(self) -> None:
        self.values = MOST_VALUES
        self.seconds = MOST_SECONDS


class Lent:
    """Lends values of the right functions of some tasks, and notes which were asked for."""

    def __init__(self, tasks: Sequence[Task], allowance: Allowance) -> None:
        self._tasks = {task.function: task for task in tasks}
        self._allowance = allowance
        self._asked: set[str] = set()

    @property
    def parameters(self) -> Mapping[str, Sequence[str]]:
        """The parameters of each function that is lent, by its name."""
        return {name: task.parameters for name, task in self._tasks.items()}

    @property
    def used(self) -> tuple[Task, ...]:
        """The tasks whose functions were called, in their order."""
        return tuple(task for name, task in self._tasks.items() if name in self._asked)

    def reply(self, function: str, arguments: Any) -> dict[str, Any] | None:
        """Return the value of a call in the form of ``inside.answers``, or why there is none.

        None says that nothing more is lent.
        """
        self._asked.add(function)
        left = self._allowance
        left.values -= 1
        if left.values < 0 or left.seconds <= 0:
            return None
        try:
            given = plain(arguments)
        except (NotPlainError, OverflowError) as error:
            return {"refused": str(error)}
        answer = _kept_value(self._tasks[function].id, given)
        if answer is None:
            left.seconds = 0.0
            return {"refused": f"{function} takes too long with such arguments"}
        left.seconds -= answer["seconds"]
        return {name: value for name, value in answer.items() if name != "seconds"}


_kept: dict[str, dict[str, Any]] = {}
"""Values that were lent, by what was asked: a class that has the same inputs asks for the same."""


def _kept_value(task_id: str, arguments: list[Any]) -> dict[str, Any] | None:
    """Return a value with the time that it took, worked out only the first time it is asked for."""
    key = json.dumps([task_id, arguments])
    if key in _kept:
        return _kept[key]
    answer: dict[str, Any] | None = _clerk().ask(task_id, arguments)
    if answer is not None and len(key) + len(json.dumps(answer)) <= LONGEST_KEPT:
        if len(_kept) == MOST_KEPT:
            _kept.clear()
        _kept[key] = answer
    return answer


def value_of(task_id: str, arguments: Sequence[Any]) -> dict[str, Any]:
    """Return the right value of a call, or that there is none, and what time it took."""
    began = time.process_time()
    task = task_by_id(task_id)
    try:
        value = {"value": lendable(task.expected(*arguments_from(arguments)))}
    except Exception:  # a student may call it with anything
        value = {"refused": f"{task.function} cannot be called with such arguments"}
    return value | {"seconds": time.process_time() - began}


def main() -> None:
    """Answer requests, each a task and the arguments of a call.

    One that takes more than its time ends the process.
    """
    limits.lower_memory(MOST_MEMORY)
    for line in sys.stdin.buffer:
        limits.bound_time_from_now(SECONDS)
        answer = value_of(*json.loads(line))
        sys.stdout.buffer.write(json.dumps(answer).encode() + b"\n")
        sys.stdout.buffer.flush()

"""The check cell of an exercise: marks one answer in the notebook it was written in."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from functools import partial
from typing import Any

from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.verdict import Verdict, judge

LARGEST_SEED = 10_000
"""Seeds are small enough to be typed again."""


def check_task(task_id: str, function: Callable[..., Any], *, seed: int | None = None) -> None:
    """Print the marks for an answer: one line, and more only where something is wrong.

    Parameters
    ----------
    task_id : str
        The task's number, such as "3.2".
    function : callable
        The answer.
    seed : int, optional
        Draws the inputs. By default they differ from call to call.

    Raises
    ------
    ValueError
        There is no such task.

    Examples
    --------
    >>> from lesson_code.formulas import reflect
    >>> check_task("3.1", reflect)
    3.1 reflect: 4/4 points
    """
    task = task_by_id(task_id)
    drawn = secrets.randbelow(LARGEST_SEED) if seed is None else seed
    verdict = judge(task, partial(call_here, {task.function: function}), drawn)
    print("\n".join(lines_of(verdict)))  # noqa: T201 - what a check cell is for


def lines_of(verdict: Verdict) -> list[str]:
    """Return what there is to say about an answer, with the seed that repeats it."""
    if len(verdict.lines) == 1:
        return verdict.lines
    return [*verdict.lines, f"  (inputs drawn with seed {verdict.seed})"]

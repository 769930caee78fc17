"""The check cell of an exercise: marks one answer in the notebook it was written in."""

from __future__ import annotations

import inspect
import secrets
from collections.abc import Callable, Iterator
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
    print("\n".join([*lines_of(verdict), *left_out_of(function)]))  # noqa: T201 - a check cell's


def left_out_of(function: Callable[..., Any]) -> list[str]:
    """Return in a line which names an answer takes from lesson_code: grading leaves these out.

    Helpers that the answer calls, if they stand in the same notebook, are looked through, too.
    """
    names = sorted(_borrowed(function, set()))
    if not names:
        return []
    return [f"  grading leaves out imports of lesson_code, and so {', '.join(names)}"]


def _borrowed(function: Any, seen: set[Any]) -> Iterator[str]:
    """Yield the names that a function of a notebook has from lesson_code."""
    code = getattr(inspect.unwrap(function), "__code__", None)
    if code is None or code in seen or _is_ours(function):
        return
    seen.add(code)
    for name in code.co_names:
        value = inspect.unwrap(function).__globals__.get(name)
        if _is_ours(value):
            yield name
        elif inspect.isfunction(value) and value.__module__ == function.__module__:
            yield from _borrowed(value, seen)


def _is_ours(value: Any) -> bool:
    """Return whether an object is of lesson_code, or one of its modules."""
    home = value.__name__ if inspect.ismodule(value) else getattr(value, "__module__", None)
    return isinstance(home, str) and home.partition(".")[0] == "lesson_code"


def lines_of(verdict: Verdict) -> list[str]:
    """Return what there is to say about an answer, with the seed that repeats it."""
    if len(verdict.lines) == 1:
        return verdict.lines
    return [*verdict.lines, f"  (inputs drawn with seed {verdict.seed})"]

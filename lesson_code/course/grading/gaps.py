"""Gaps in a notebook: a line or two that its reader writes, checked at once and used further down.

A chapter describes its gaps in ``gaps.py``. In the notebook a gap is a function whose body holds
``...``; the decorator :func:`gap` checks what stands there instead. Until it is right, our function
is lent under the same name, so that the notebook runs from top to bottom whatever is written.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from random import Random

from lesson_code.course.chapters import chapters_with
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.task import Arguments, Criterion, Function, Task, WrongModel
from lesson_code.course.grading.verdict import judge

GAPS = "gaps.py"
"""A chapter's file of gaps."""

CALLS = 12
"""Drawn inputs that a gap is tried on; a wrong formula is right on one of them by luck at most."""

SEED = 1
"""The inputs are the same every time: a gap earns nothing, and what it prints reproduces."""


@dataclass(frozen=True)
class Gap:
    """A function of a notebook that its reader writes.

    Parameters
    ----------
    id : str
        The chapter's number and a name: "02-restitution".
    ours : callable
        The right function, which is lent until the reader's is right.
    draw : callable
        Draws the arguments of one call from a random stream; vectors are tuples.
    wrong_models : tuple of WrongModel
        Mistakes that are recognised, each with its hint.
    """

    id: str
    ours: Function
    draw: Callable[[Random], Arguments]
    wrong_models: tuple[WrongModel, ...]

    def task(self, function: str) -> Task:
        """Return the gap as a task with a single criterion, for a function of this name."""
        return Task(
            id=self.id,
            function=function,
            objective="",
            expected=self.ours,
            criteria=(Criterion(f"{CALLS} drawn inputs", self._cases),),
            wrong_models=self.wrong_models,
            parameters=tuple(inspect.signature(self.ours).parameters),
        )

    def _cases(self, stream: Random) -> Iterator[Arguments]:
        return (self.draw(stream) for _ in range(CALLS))


def gap(gap_id: str) -> Callable[[Function], Function]:
    """Check what a reader has written, and return it if it is right, or ours if it is not.

    Parameters
    ----------
    gap_id : str
        The gap's id in the chapter's ``gaps.py``.

    Raises
    ------
    ValueError
        There is no such gap.

    Examples
    --------
    >>> @gap("01-centre")
    ... def centre(m1, v1, m2, v2):
    ...     return (v1 + v2) / 2
    Not yet. Called ...
    hint: A truck meets a fly head on. Does the truck lose half its speed?
    Until yours is right, ours is used:
    lesson_code.chapters.ch01_one_dimension.gaps.centre_velocity
    """
    asked = gap_by_id(gap_id)
    return lambda function: _checked(asked, function)


def gap_by_id(gap_id: str) -> Gap:
    """Return a gap of the course.

    Raises
    ------
    ValueError
        There is no such gap.
    """
    known = {asked.id: asked for asked in all_gaps()}
    if gap_id not in known:
        raise ValueError(f"gap must be one of {', '.join(known)}, got {gap_id!r}")
    return known[gap_id]


def all_gaps() -> tuple[Gap, ...]:
    """Return every gap of the course, in the order of the chapters."""
    return tuple(each for chapter in chapters_with(GAPS) for each in chapter.module("gaps").GAPS)


def is_open(function: Function) -> bool:
    """Return whether a function still holds the ``...`` that its reader is to replace."""
    return Ellipsis in function.__code__.co_consts


def _checked(asked: Gap, function: Function) -> Function:
    """Return the reader's function or ours, and say which and why."""
    name = function.__name__
    ours = f"{asked.ours.__module__}.{asked.ours.__name__}"
    if is_open(function):
        print(f"{name} is yours to write. Until then ours is used:\n{ours}")  # noqa: T201
        return asked.ours
    verdict = judge(asked.task(name), partial(call_here, {name: function}), SEED)
    if verdict.is_full:
        print(f"{name} is right on {CALLS} drawn inputs. From here on yours is used.")  # noqa: T201
        return function
    said = [f"Not yet. {criterion.message}" for criterion in verdict.criteria]
    said += [f"hint: {diagnosis.hint}" for diagnosis in verdict.diagnoses]
    print("\n".join([*said, f"Until yours is right, ours is used:\n{ours}"]))  # noqa: T201
    return asked.ours

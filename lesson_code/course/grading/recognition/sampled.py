"""Whether numbers of an answer have been tried one after the other, in small steps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import chain
from typing import Any

from lesson_code.course.grading.recognition.in_source import model
from lesson_code.course.grading.task import Task, WrongModel
from lesson_code.course.grading.tried import TriedCall
from lesson_code.course.isolation.inside.answers import plain

STEPS = (10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000)
"""Into how many steps somebody divides a span, or one second; `linspace` makes one less."""

SPANS = ("dt", "duration")
"""Arguments that are spans of time."""

FEWEST_CALLS = 3
"""Wrong calls that must show the same steps: by luck none does."""

WHOLE = 1e-6
"""How near to a whole number a number of steps must be: far above the rounding of an answer."""


def samples_of(task: Task, names: Sequence[str], calls: Sequence[TriedCall]) -> WrongModel | None:
    """Return that an answer is the first of some numbers that fits, if it should lie between two.

    Parameters
    ----------
    task : Task
        What was asked.
    names : Sequence of str
        Of its arguments.
    calls : Sequence of TriedCall
        The wrong calls.
    """
    for span in ("", *SPANS):
        shown = [
            (_first(call.got), _first(call.wanted), _span(span, names, call)) for call in calls
        ]
        known = [each for each in shown if all(map(math.isfinite, each))]
        if len(known) < FEWEST_CALLS:
            continue
        for steps in chain(STEPS, (count - 1 for count in STEPS)):
            if all(_is_next_sample(*each, steps) for each in known):
                return model(task.id, "sampled", lambda *_: None, {})
    return None


def _first(value: Any) -> float:
    """Return a number, or the first one of several; nan where there is none."""
    first = value[0] if isinstance(value, list) and value else value
    return first if isinstance(first, float) else math.nan


def _span(name: str, names: Sequence[str], call: TriedCall) -> float:
    """Return the span of time that is given to a call under a name; 1 s without a name."""
    given = dict(zip(names, plain(list(call.arguments)), strict=False))
    return float(given.get(name, math.nan)) if name else 1.0


def _is_next_sample(got: float, wanted: float, span: float, steps: int) -> bool:
    """Return whether a number is the next of so many in a span, after the right one.

    How late it is comes first: the place of any other number may lie beyond all floats.
    """
    if not 0 < (got - wanted) * steps / span <= 1 + WHOLE:
        return False
    place = got * steps / span
    return abs(place - round(place)) <= WHOLE

"""Tasks of dominoes: when one topples, what that takes, and a row that falls in order."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import count
from random import Random
from typing import Any

from lesson_code.chapters import draws
from lesson_code.chapters.dominoes import rules as dominoes_rules
from lesson_code.course.grading.task import Arguments, Criterion, Task

COUNT, HEIGHT, SPACING, DT = 8, 0.6, 0.3, 1 / 60
"""Dominoes in a row; m, m and s."""

FALLEN = math.asin(SPACING / HEIGHT)
"""rad: a domino that leans further has fallen."""


def thin(stream: Random) -> Iterator[Arguments]:
    """Draw a thin domino."""
    yield _size(stream, 0.2)


def thick(stream: Random) -> Iterator[Arguments]:
    """Draw a thick one."""
    yield _size(stream, 0.7)


def _size(stream: Random, share: float) -> Arguments:
    """Return width and height, the width about a given share of the height."""
    height = round(stream.uniform(0.3, 1.5), 2)
    return round(height * share * stream.uniform(0.9, 1.1), 3), height


def short_runs(stream: Random) -> Iterator[Arguments]:
    """Draw rows in any state, for a few steps; in some of them dominoes touch.

    In the first one the fastest does not quite touch the next: its angle lies between spacing over
    height, 0.5, of which the arc tangent is 0.464, and the arc sine, 0.524, after the step.
    In the second one each pushes the next, and in the third only the second one does. In the last
    one those in front are faster, the second by .5 rad/s or more.
    """
    almost = tuple(round(stream.uniform(0.485, 0.495) - 0.15 * k, 3) for k in range(4))
    yield almost, (round(stream.uniform(1.0, 1.3), 2), 0.4, 0.3, 0.2), HEIGHT, SPACING, DT, 1
    for first in (1.56, 0.2):
        angles = (first, *(round(stream.uniform(a, a + 0.1), 3) for a in (0.75, 0.6, 0.1)))
        falling = tuple(round(stream.uniform(r, r + 0.5), 2) for r in (3.0, 1.5, 0.3, 0.0))
        yield angles, falling, HEIGHT, SPACING, DT, 1
    for steps in (1, 5):
        angles = tuple(round(stream.uniform(0.6, 0.9) - 0.2 * k, 3) for k in range(4))
        rates = _rates(stream)
        if steps > 1:
            rates = draws.until(lambda r: r[1] > r[0] + 0.5, lambda: sorted(_rates(stream)))
        yield angles, tuple(rates), HEIGHT, SPACING, DT, steps


def _rates(stream: Random) -> list[float]:
    """Return how fast four dominoes turn, rad/s."""
    return [round(stream.uniform(0.5, 3.0), 2) for _ in range(4)]


def while_it_falls(stream: Random) -> Iterator[Arguments]:
    """Draw a row that is pushed, when some have fallen, and shortly before the last one has."""
    rate = round(stream.uniform(0.9, 1.2), 2)
    last = next(n for n in count(1) if all(who_has_fallen(dominoes_rules.chain(*_pushed(rate, n)))))
    for steps in (28, 49, last - 2):
        yield _pushed(rate, steps)


def when_all_is_over(stream: Random) -> Iterator[Arguments]:
    """Draw a row that is pushed, long after."""
    yield _pushed(round(stream.uniform(0.9, 1.2), 2), 175)


def _pushed(rate: float, steps: int) -> Arguments:
    """Return a standing row whose first domino is pushed."""
    standing = (0.0,) * COUNT
    return standing, (rate, *standing[1:]), HEIGHT, SPACING, DT, steps


def who_has_fallen(answer: Any) -> list[bool]:
    """Return for each domino whether it has fallen."""
    return [bool(angle > FALLEN) for angle in answer[0]]


TASKS = (
    Task(
        id="D.1",
        function="tipping_angle",
        objective="How far a domino can lean.",
        expected=dominoes_rules.tipping_angle,
        criteria=(Criterion("thin ones", thin), Criterion("thick ones", thick)),
    ),
    Task(
        id="D.2",
        function="toppling_rate",
        objective="What it takes to topple one.",
        expected=dominoes_rules.toppling_rate,
        criteria=(Criterion("thin ones", thin), Criterion("thick ones", thick)),
    ),
    Task(
        id="D.3",
        function="chain",
        objective="A row of dominoes, judged on who falls, and in what order.",
        expected=dominoes_rules.chain,
        criteria=(
            Criterion("a few steps", short_runs, points=2),
            Criterion("they fall in order", while_it_falls, points=2, part=who_has_fallen),
            Criterion("every domino falls", when_all_is_over, part=who_has_fallen),
        ),
    ),
)

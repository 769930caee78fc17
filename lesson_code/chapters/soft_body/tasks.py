"""Tasks of the soft body: area, springs, pressure, and a fall after which it keeps its area."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.soft_body import rules as soft_body_rules
from lesson_code.chapters.soft_body.rules import BLOB
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.formulas.arithmetic import cross

MASSES, RADIUS = 12, 0.7
"""Masses in the ring that falls; m."""

AREA = MASSES / 2 * RADIUS**2 * math.sin(2 * math.pi / MASSES)
"""m^2: of that ring at rest."""

KEPT = 0.05
"""Of the area: a ring that falls from 1.5 m loses and gains less than this, in every run."""

LANDING, RESTING = 330, 1500
"""Steps, of 1/600 s: the ring that falls from 1.5 m is flattest, lies still."""

AT_REST = 0.05
"""J: what is left then, at the most; the fall brings 9 J. A ring that falls by the rules has 0.03
left in every run, without air 0.13, with springs that are not damped 0.07."""


def rings(stream: Random) -> Iterator[Arguments]:
    """Draw an uneven ring, counter-clockwise."""
    yield (draws.convex_polygon(stream, 6, draws.position(stream)),)


def clockwise_rings(stream: Random) -> Iterator[Arguments]:
    """Draw an uneven ring, clockwise."""
    yield (draws.convex_polygon(stream, 6, draws.position(stream))[::-1],)


def still_rings(stream: Random) -> Iterator[Arguments]:
    """Draw uneven rings at rest."""
    yield _ring(stream), ((0.0, 0.0),) * 5, 0.6, round(stream.uniform(20, 90), 1), 3.0


def moving_rings(stream: Random) -> Iterator[Arguments]:
    """Draw uneven rings whose masses move."""
    for _ in range(2):
        velocities = tuple((draws.speed(stream), -draws.speed(stream)) for _ in range(5))
        damping = round(stream.uniform(1.0, 4.0), 2)
        yield _ring(stream), velocities, 0.6, round(stream.uniform(20, 90), 1), damping


def small_rings(stream: Random) -> Iterator[Arguments]:
    """Draw an uneven ring that is too small for its gas."""
    yield _with_gas(stream, 1.4)


def large_rings(stream: Random) -> Iterator[Arguments]:
    """Draw an uneven ring that is too large for its gas."""
    yield _with_gas(stream, 0.7)


def _with_gas(stream: Random, share: float) -> Arguments:
    """Return an uneven ring whose area at rest is a share of its own."""
    ring = _ring(stream)
    return ring, round(share * soft_body_rules.ring_area(ring), 3), round(stream.uniform(20, 90), 1)


def _ring(stream: Random) -> tuple[draws.Vector, ...]:
    """Return an uneven ring of five, counter-clockwise."""
    return draws.convex_polygon(stream, 5, draws.position(stream))


def short_falls(stream: Random) -> Iterator[Arguments]:
    """Draw a ring that is about to land, moving to one side."""
    yield _falling(stream, height=0.72, sideways=1.0, steps=40)


def long_falls(stream: Random) -> Iterator[Arguments]:
    """Draw a ring that is let fall, when it is flattest."""
    yield _falling(stream, height=1.5, sideways=0.0, steps=LANDING)


def landed(stream: Random) -> Iterator[Arguments]:
    """Draw a ring that is let fall, once it lies still."""
    yield _falling(stream, height=1.5, sideways=0.0, steps=RESTING)


def _falling(stream: Random, height: float, sideways: float, steps: int) -> Arguments:
    """Return the arguments of a round ring that falls."""
    first = stream.uniform(0, 0.5)
    turns = [first + 2 * math.pi * k / MASSES for k in range(MASSES)]
    ring = tuple((RADIUS * math.cos(t), height + RADIUS * math.sin(t)) for t in turns)
    edge = 2 * RADIUS * math.sin(math.pi / MASSES)
    down = -round(stream.uniform(1.0, 2.0), 2) if sideways else 0.0
    return ring, ((sideways, down),) * MASSES, edge, AREA, steps


def keeps_area(answer: Any) -> list[bool]:
    """Return whether the area is kept, and no mass is below the floor."""
    positions = np.asarray(answer[0], dtype=float)
    area = cross(positions.T, np.roll(positions, -1, axis=0).T).sum() / 2
    is_kept = abs(area / AREA - 1) <= KEPT
    return [bool(is_kept), bool(positions[:, 1].min() >= 0)]


def is_at_rest(answer: Any) -> list[bool]:
    """Return whether nothing moves any more, on the floor, with the area that it began with."""
    positions, velocities = (np.asarray(part, dtype=float) for part in answer)
    energy = BLOB.mass * (velocities**2).sum() / 2
    is_low = 0 <= positions[:, 1].min() <= 0.01
    return [bool(energy <= AT_REST and is_low), *keeps_area(answer)]


TASKS = (
    Task(
        id="S.1",
        function="ring_area",
        objective="The area inside a ring, with its sign.",
        expected=soft_body_rules.ring_area,
        criteria=(Criterion("counter-clockwise", rings), Criterion("clockwise", clockwise_rings)),
    ),
    Task(
        id="S.2",
        function="ring_forces",
        objective="Damped springs round a ring.",
        expected=soft_body_rules.ring_forces,
        criteria=(
            Criterion("at rest", still_rings),
            Criterion("in motion", moving_rings, points=2),
        ),
    ),
    Task(
        id="S.3",
        function="pressure_forces",
        objective="A gas inside that keeps the area.",
        expected=soft_body_rules.pressure_forces,
        criteria=(Criterion("too small", small_rings), Criterion("too large", large_rings)),
    ),
    Task(
        id="S.4",
        function="drop",
        objective="A fall, judged on area and rest.",
        expected=soft_body_rules.drop,
        criteria=(
            Criterion("the landing", short_falls),
            Criterion("it keeps its area", long_falls, part=keeps_area),
            Criterion("it comes to rest", landed, part=is_at_rest),
        ),
    ),
)

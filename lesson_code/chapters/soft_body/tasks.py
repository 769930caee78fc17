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

LANDING, RISING = 70, 160
"""Steps, of 1/600 s, after which a ring that meets the floor at SPEED is flattest, and rises."""

SPEED = 3.6
"""m/s: that of a fall of 0.66 m; the ring has 7.8 J then."""

KEPT = 0.05
"""Of the area: a ring that lands by the rules loses and gains less than this, in every run."""

REBOUND = 0.82, 0.92
"""J: what is left while it rises. A ring that falls by the rules has 0.86 to 0.88 in every run,
with a floor that throws it back 0.96 or more, without air 1.5."""


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
    down = round(stream.uniform(1.0, 2.0), 2)
    yield _falling(stream, height=0.72, velocity=(1.0, -down), steps=40)


def landings(stream: Random) -> Iterator[Arguments]:
    """Draw a ring that meets the floor, when it is flattest."""
    yield _falling(stream, height=RADIUS, velocity=(0.0, -SPEED), steps=LANDING)


def rebounds(stream: Random) -> Iterator[Arguments]:
    """Draw a ring that meets the floor, when it rises."""
    yield _falling(stream, height=RADIUS, velocity=(0.0, -SPEED), steps=RISING)


def _falling(stream: Random, height: float, velocity: draws.Vector, steps: int) -> Arguments:
    """Return the arguments of a round ring that falls."""
    first = stream.uniform(0, 0.1)
    turns = [first + 2 * math.pi * k / MASSES for k in range(MASSES)]
    ring = tuple((RADIUS * math.cos(t), height + RADIUS * math.sin(t)) for t in turns)
    edge = 2 * RADIUS * math.sin(math.pi / MASSES)
    return ring, (velocity,) * MASSES, edge, AREA, steps


WIDER = 1.3
"""Width of the squashed ring over its height, at least: it is 1.6 when it is flattest."""


def keeps_area(answer: Any) -> list[bool]:
    """Return whether the area is kept, no mass is below the floor, and the blow has squashed it."""
    positions = np.asarray(answer[0], dtype=float)
    area = cross(positions.T, np.roll(positions, -1, axis=0).T).sum() / 2
    is_kept = abs(area / AREA - 1) <= KEPT
    width, height = np.ptp(positions, axis=0)
    return [bool(is_kept), bool(positions[:, 1].min() >= 0), bool(width >= WIDER * height)]


def is_damped(answer: Any) -> list[bool]:
    """Return whether what moves has lost as much energy as it should, and the area is kept."""
    low, high = REBOUND
    energy = BLOB.mass * (np.asarray(answer[1], dtype=float) ** 2).sum() / 2
    return [bool(low <= energy <= high), *keeps_area(answer)]


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
        objective="A fall, judged on its area and its energy.",
        expected=soft_body_rules.drop,
        criteria=(
            Criterion("the landing", short_falls),
            Criterion("it keeps its area", landings, part=keeps_area),
            Criterion("it rises with little energy", rebounds, part=is_damped),
        ),
    ),
)

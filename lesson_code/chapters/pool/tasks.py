"""Tasks of pool: the rack, the stroke, and a break that is as symmetric as the rack."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.pool import rules as pool_rules
from lesson_code.course.grading.task import Arguments, Criterion, Task

RADIUS = 0.03
SYMMETRIC = 1e-9
"""m/s: what rounding leaves of a mirror image, and much less than any order of pairs does."""

ROWS = 3
"""Of a rack that is broken where symmetry or momentum is looked at: few balls, and little work."""

MIRRORED = [0, *(1 + row * (row + 1) // 2 + row - k for row in range(ROWS) for k in range(row + 1))]
"""For the cue ball and each ball of such a rack: the place of its mirror image."""


def racks(stream: Random) -> Iterator[Arguments]:
    """Draw racks of touching balls."""
    for _ in range(2):
        yield draws.position(stream), round(stream.uniform(0.02, 0.05), 4), 0.0


def loose_racks(stream: Random) -> Iterator[Arguments]:
    """Draw racks with gaps."""
    for _ in range(2):
        yield draws.position(stream), round(stream.uniform(0.2, 0.5), 3), 0.05


def strokes(stream: Random) -> Iterator[Arguments]:
    """Draw strokes to the left and to the right of the centre, in any direction."""
    for side in (1, -1):
        x, y = draws.oblique_normal(stream)
        size, radius = stream.uniform(0.2, 0.9), round(stream.uniform(0.02, 0.04), 4)
        offset = side * round(stream.uniform(0.2, 0.5) * radius, 5)
        yield (size * x, size * y), offset, round(stream.uniform(0.1, 0.3), 3), radius


def centre_strokes(stream: Random) -> Iterator[Arguments]:
    """Draw a stroke at the centre."""
    for x, y, _, _ in [(stream.uniform(0.2, 0.9), stream.uniform(-0.9, -0.2), 0, 0)]:
        yield (x, y), 0.0, round(stream.uniform(0.1, 0.3), 3), 0.03


def two_balls(stream: Random) -> Iterator[Arguments]:
    """Draw two balls that touch, meeting at an angle; and two that touch and part.

    Then two that only just count as touching, and two that approach and do not touch yet.
    """
    for sign, apart in ((1, 2.0), (-1, 2.0), (1, 2.0005), (1, 2.2)):
        x, y = draws.oblique_normal(stream)
        speed = sign * draws.speed(stream)
        places = ((0.0, 0.0), (apart * RADIUS * x, apart * RADIUS * y))
        yield places, ((speed * x + 0.4, speed * y), (0.4, 0.3)), RADIUS, draws.restitution(stream)


def straight_breaks(stream: Random) -> Iterator[Arguments]:
    """Draw a break along the axis of the rack."""
    yield _break(stream, 0.0, ROWS)


def small_oblique_breaks(stream: Random) -> Iterator[Arguments]:
    """Draw a break of some rows with some motion across."""
    yield _break(stream, stream.uniform(0.3, 0.6), ROWS)


def oblique_breaks(stream: Random) -> Iterator[Arguments]:
    """Draw a break of more rows with some motion across; the balls are listed in any order."""
    places, moving, *rest = _break(stream, stream.uniform(0.3, 0.6), ROWS + 1)
    order = stream.sample(range(len(places)), len(places))
    yield tuple(places[n] for n in order), tuple(moving[n] for n in order), *rest


def _break(stream: Random, across: float, rows: int) -> Arguments:
    """Return the arguments of a break of some rows: the cue ball touches the apex."""
    balls = rows * (rows + 1) // 2
    places = [(-2 * RADIUS, 0.0), *pool_rules.rack((0.0, 0.0), RADIUS, 0.0)[:balls]]
    moving = [(round(stream.uniform(4, 8), 2), across), *[(0.0, 0.0)] * balls]
    return tuple(places), tuple(moving), RADIUS, draws.restitution(stream)


def is_symmetric(velocities: Any) -> bool:
    """Return whether what a straight break has made is its own mirror image."""
    v = np.asarray(velocities, dtype=float)
    return bool(np.abs(v[MIRRORED] * (1.0, -1.0) - v).max() <= SYMMETRIC)


def total(velocities: Any) -> Any:
    """Return the sum of all velocities: the momentum of equal balls, over their mass."""
    return np.asarray(velocities, dtype=float).sum(axis=0)


TASKS = (
    Task(
        id="P.1",
        function="rack",
        objective="Fifteen balls in a triangle.",
        expected=pool_rules.rack,
        criteria=(
            Criterion("balls that touch", racks, points=2),
            Criterion("balls with gaps", loose_racks),
        ),
    ),
    Task(
        id="P.2",
        function="strike",
        objective="What a cue gives a ball: velocity and spin.",
        expected=pool_rules.strike,
        criteria=(
            Criterion("beside the centre", strokes, points=2),
            Criterion("at the centre", centre_strokes),
        ),
    ),
    Task(
        id="P.3",
        function="share_impact",
        objective="An impact of many balls, as symmetric as they lie.",
        expected=pool_rules.share_impact,
        criteria=(
            Criterion("two balls", two_balls),
            Criterion("the rack breaks symmetrically", straight_breaks, part=is_symmetric),
            Criterion("a break keeps the momentum", small_oblique_breaks, part=total),
            Criterion("a break", oblique_breaks, points=2),
        ),
    ),
)

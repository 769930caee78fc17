"""Tasks of Newton's cradle: k balls in, k balls out."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.chapters import draws, rows_of_balls
from lesson_code.chapters.cradle import rules as cradle_rules
from lesson_code.course.grading.task import Arguments, Criterion, Task

BALLS, PULL = 5, 0.5
"""Balls in the cradle; rad, how far they are pulled out."""

OUT = 0.6
"""Of the pull: a ball that is farther out counts as out."""

DT, ACROSS, DOWN = 1 / 100, 90, 46
"""s; steps in which balls pulled out on a string of 0.8 m reach the other side: 0.9 s; and steps to
the one in which they meet the others, from 0.5 to 0.54 rad."""


def equal_rows(stream: Random) -> Iterator[Arguments]:
    """Draw k of 5 equal, elastic balls that come in at one speed, for all k."""
    for k in range(1, BALLS):
        speed = draws.speed(stream)
        yield (2.0,) * BALLS, (speed,) * k + (0.0,) * (BALLS - k), 1.0


def unequal_rows(stream: Random) -> Iterator[Arguments]:
    """Draw rows of unequal masses with some restitution, in the first of which one ball comes in.

    In the others all balls move, and each shows one other order of the collisions; in the last one
    two approach slowly.
    """
    masses = tuple(round(stream.uniform(1.0, 4.0), 2) for _ in range(4))
    yield masses, (draws.speed(stream), 0.0, 0.0, 0.0), _restitution(stream)
    for other in rows_of_balls.ORDERS:
        if other is not rows_of_balls.leftmost:
            e = _restitution(stream)
            leftmost = rows_of_balls.leftmost
            yield *rows_of_balls.row_in_which_order_counts(stream, e, leftmost, other), e
    v = draws.speed(stream)
    yield draws.unequal_masses(stream), (v + draws.creep(stream), v), _restitution(stream)


def _restitution(stream: Random) -> float:
    """Return a restitution with which few collisions are the end."""
    return round(stream.uniform(0.7, 0.95), 2)


def parting_rows(stream: Random) -> Iterator[Arguments]:
    """Draw a row in which nothing approaches."""
    speeds = sorted(round(stream.uniform(-3, 3), 2) for _ in range(4))
    yield (1.0, 3.0, 2.0, 1.5), tuple(speeds), 0.8


def short_strings(stream: Random) -> Iterator[Arguments]:
    """Draw a ball far out on a short string."""
    yield _swing(stream, 1, 0.4, 0.7)


def long_strings(stream: Random) -> Iterator[Arguments]:
    """Draw a ball far out on a long string, on the other side."""
    yield _swing(stream, -1, 2.0, 3.0)


def _swing(stream: Random, side: int, shortest: float, longest: float) -> Arguments:
    """Return the arguments of a step far out on one side."""
    angle, length = round(stream.uniform(0.7, 1.3), 3), round(stream.uniform(shortest, longest), 2)
    return side * angle, draws.angular_velocity(stream), length, 0.01


def pulled_out(stream: Random) -> Iterator[Arguments]:
    """Draw k of 5 balls that are let go, for all k, until they are out on the other side."""
    for k in range(1, BALLS):
        yield _cradle(k, PULL + stream.uniform(-0.05, 0.05), ACROSS)


def half_way(stream: Random) -> Iterator[Arguments]:
    """Draw two balls that are let go, just after the impact, and three in whose last step it is."""
    yield _cradle(2, PULL + stream.uniform(-0.05, 0.05), 3 * ACROSS // 4)
    yield _cradle(3, PULL + stream.uniform(0.0, 0.04), DOWN)


def _cradle(pulled: int, angle: float, steps: int) -> Arguments:
    """Return the arguments of a cradle at rest, some balls pulled out."""
    angles = (-round(angle, 3),) * pulled + (0.0,) * (BALLS - pulled)
    return angles, (0.0,) * BALLS, 0.8, DT, steps


def balls_out(answer: Any) -> list[str]:
    """Return for each ball whether it is out on the left, on the right, or inside."""
    limit = OUT * PULL
    sides = [(angle > limit) - (angle < -limit) for angle in answer[0]]
    return [("inside", "right", "left")[side] for side in sides]


TASKS = (
    Task(
        id="C.1",
        function="collide_row",
        objective="All collisions in a row of balls.",
        expected=cradle_rules.collide_row,
        criteria=(
            Criterion("k balls in, k balls out", equal_rows),
            Criterion("unequal masses", unequal_rows, points=2),
            Criterion("nothing approaches", parting_rows),
        ),
    ),
    Task(
        id="C.2",
        function="swing_step",
        objective="One step of a ball on a string.",
        expected=cradle_rules.swing_step,
        criteria=(
            Criterion("short strings", short_strings),
            Criterion("long strings", long_strings),
        ),
    ),
    Task(
        id="C.3",
        function="cradle",
        objective="The whole cradle, judged on who is out on which side.",
        expected=cradle_rules.cradle,
        criteria=(
            Criterion("k balls in, k balls out", pulled_out, points=3, part=balls_out),
            Criterion("angles and rates", half_way),
        ),
    ),
)

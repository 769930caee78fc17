"""Tasks of Breakout: the paddle, the time of impact, and a flight that no brick lets through."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.chapters import draws
from lesson_code.chapters.breakout import rules as breakout_rules
from lesson_code.course.grading.task import Arguments, Criterion, Task

RADIUS = 0.1
BOX = (0.74, 0.24)
"""m: width and height of a brick."""


def on_the_paddle(stream: Random) -> Iterator[Arguments]:
    """Draw hits on either side of the middle."""
    for side in (1, -1):
        yield side * round(stream.uniform(0.3, 0.9), 3), draws.speed(stream)


def beyond_the_ends(stream: Random) -> Iterator[Arguments]:
    """Draw hits beyond the paddle's ends."""
    for side in (1, -1):
        yield side * round(stream.uniform(1.1, 1.4), 3), draws.speed(stream)


def into_faces(stream: Random) -> Iterator[Arguments]:
    """Draw balls that meet each face of a brick at an angle, the last one slowly."""
    for across in ((0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)):
        yield _towards(stream, across, across)
    box = _box(stream)
    below = (box[0] + stream.uniform(0.2, 0.5), box[1] - RADIUS - 0.03)
    yield below, (0.02, round(stream.uniform(0.05, 0.09), 3)), RADIUS, box


def into_corners(stream: Random) -> Iterator[Arguments]:
    """Draw balls that meet each corner, off the diagonal."""
    for x, y in ((-1, -1), (1, 1), (-1, 1), (1, -1)):
        angle = math.radians(stream.uniform(30, 40))
        normal = (x * math.cos(angle), y * math.sin(angle))
        yield _towards(stream, (float(x), float(y)), normal)


def at_corners(stream: Random) -> Iterator[Arguments]:
    """Draw balls that meet corners, one that just does not, one that flies away, one too late.

    One meets a corner that is not the nearest when it sets out.
    """
    yield from into_corners(stream)
    yield _over_the_top(stream)
    box = _box(stream)
    x, y = box[0] + box[2], box[1] + box[3]
    slip = 1.05 * RADIUS * math.sqrt(0.5)
    yield (x + slip - 0.5, y + slip + 0.5), (2.0, -2.0), RADIUS, box
    yield (x + 1.0, y + 0.5), (2.0, 1.0), RADIUS, box
    yield (box[0] + 0.3, box[1] - 3.0), (0.1, 1.0), RADIUS, box


def at_any_speed(stream: Random) -> Iterator[Arguments]:
    """Draw balls that are in front of a brick now and a kilometre behind it in a second."""
    for speed in (1e3, 1e6):
        box = _box(stream)
        below = (box[0] + stream.uniform(0.2, 0.5), box[1] - stream.uniform(2.1, 4.9))
        yield below, (stream.uniform(-0.01, 0.01) * speed, speed), RADIUS, box


def _over_the_top(stream: Random) -> Arguments:
    """Return a ball above the left half of a brick that falls past its face at the right corner."""
    x, y, wide, high = box = _box(stream)
    angle, before = math.radians(stream.uniform(25, 35)), stream.uniform(0.3, 0.5)
    touch = x + wide + RADIUS * math.sin(angle), y + high + RADIUS * math.cos(angle)
    vx = (0.6 * wide + RADIUS) / before
    return (touch[0] - vx * before, touch[1] + 1.5 * vx * before), (vx, -1.5 * vx), RADIUS, box


def _box(stream: Random) -> tuple[float, ...]:
    """Return a brick somewhere."""
    return (*draws.position(stream), *BOX)


def _towards(stream: Random, at: draws.Vector, normal: draws.Vector) -> Arguments:
    """Return a ball on its way to a brick's face or corner, which it meets with a normal."""
    box = _box(stream)
    part = stream.uniform(0.35, 0.65)
    foot = [box[k] + box[2 + k] * (part if at[k] == 0 else (1 + at[k]) / 2) for k in (0, 1)]
    touch = [foot[k] + RADIUS * normal[k] for k in (0, 1)]
    vx, vy = draws.velocity_into(stream, normal)
    before = stream.uniform(0.2, 0.7)
    return (touch[0] - vx * before, touch[1] - vy * before), (vx, vy), RADIUS, box


def single_bricks(stream: Random) -> Iterator[Arguments]:
    """Draw flights into one brick's corner, with time left after it."""
    for position, velocity, radius, box in into_corners(stream):
        yield position, velocity, radius, (box,), 0.95


def walls_of_bricks(stream: Random) -> Iterator[Arguments]:
    """Draw flights between two rows of bricks, the far one first in the list.

    In the first of them the ball meets a corner. The last ball flies to and fro, and comes to where
    a brick was that it has broken.
    """
    yield draws.until(_meets_a_corner, lambda: _between_rows(stream))
    yield _between_rows(stream)
    column = tuple((0.0, y, *BOX) for y in (2.0, 1.0, -0.5))
    yield (0.4, 0.3), (0.0, round(stream.uniform(4.5, 5.0), 2)), RADIUS, column, 0.95


def _between_rows(stream: Random) -> Arguments:
    """Return a flight between two rows of bricks."""
    rows = [(0.02 + 0.78 * k, y, *BOX) for y in (2.0, 1.0, -0.5) for k in range(6)]
    velocity = (stream.uniform(1.5, 2.5), stream.uniform(7.0, 9.0))
    return (stream.uniform(0.5, 1.0), 0.3), velocity, RADIUS, tuple(rows), 0.6


def _meets_a_corner(flight: Arguments) -> bool:
    """Return whether a bounce of a flight changes its velocity across: faces are level."""
    _, velocity, _ = breakout_rules.fly(*flight)
    return bool(abs(velocity[0] - flight[1][0]) > 0.1)


def fast_flights(stream: Random) -> Iterator[Arguments]:
    """Draw a ball so fast that a frame takes it through all rows, were they not there."""
    for speed in (600.0, 60_000.0):
        rows = [(0.02 + 0.78 * k, 1.0 + 0.3 * y, *BOX) for y in range(3) for k in range(6)]
        yield (stream.uniform(2.0, 2.2), 0.3), (0.0, speed), RADIUS, tuple(rows), 1 / 60


def free_flights(stream: Random) -> Iterator[Arguments]:
    """Draw a flight that ends before the brick."""
    yield (0.5, 0.0), (stream.uniform(-0.1, 0.1), 1.0), RADIUS, ((0.0, 2.0, *BOX),), 0.9


def what_broke(answer: Any) -> Any:
    """Return which bricks broke, and whether the ball came back."""
    return [answer[2], answer[1][1] < 0]


TASKS = (
    Task(
        id="K.1",
        function="paddle_bounce",
        objective="A paddle that decides the angle, and keeps the speed.",
        expected=breakout_rules.paddle_bounce,
        criteria=(
            Criterion("on the paddle", on_the_paddle),
            Criterion("beyond its ends", beyond_the_ends),
        ),
    ),
    Task(
        id="K.2",
        function="brick_impact",
        objective="When a ball meets a brick, and with what normal, at any speed.",
        expected=breakout_rules.brick_impact,
        criteria=(
            Criterion("faces", into_faces),
            Criterion("corners, met and missed", at_corners, points=2),
            Criterion("at any speed", at_any_speed),
        ),
    ),
    Task(
        id="K.3",
        function="fly",
        objective="A flight among bricks; none lets the ball through.",
        expected=breakout_rules.fly,
        criteria=(
            Criterion("one brick", single_bricks),
            Criterion("rows of bricks", walls_of_bricks, points=2),
            Criterion("no ball through a brick at any speed", fast_flights, part=what_broke),
            Criterion("no brick in reach", free_flights),
        ),
    ),
)

"""Tasks of the billiards: contacts, one step, and the clock, judged on the world's state."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.chapters import draws
from lesson_code.chapters.billiards import rules as billiards_table
from lesson_code.chapters.billiards.rules import LAUNCH, TABLE, TIME_STEP
from lesson_code.course.grading.task import Arguments, Criterion, Task

REACH = TABLE.radius + TABLE.bumper_half_thickness
"""A ball whose centre is nearer to the bumper's middle line overlaps it, px."""


HAIR = 0.05
"""px: what counts as an overlap, or a gap, like any other."""


def at_one_wall(stream: Random) -> Iterator[Arguments]:
    """Draw a ball that overlaps each wall once, by less than its radius; by a hair; and by more."""
    for x, y in ((0.5, 0.0), (0.5, 1.0), (0.0, 0.7), (1.0, 0.3)):
        yield (_at_edge(stream, x, y),)
    yield ((round(stream.uniform(50, 200), 1), TABLE.radius - HAIR),)
    yield ((TABLE.width + round(stream.uniform(1, 5), 1), round(stream.uniform(50, 150), 1)),)


def in_corners(stream: Random) -> Iterator[Arguments]:
    """Draw a ball in two of the corners."""
    for x, y in ((0.0, 1.0), (1.0, 0.0)):
        yield (_at_edge(stream, x, y),)


def on_free_table(stream: Random) -> Iterator[Arguments]:
    """Draw balls that overlap no wall, one of them just not; one touches two."""
    yield ((round(stream.uniform(50, 200), 1), round(stream.uniform(50, 150), 1)),)
    yield ((TABLE.radius + HAIR, TABLE.height - TABLE.radius - HAIR),)
    yield ((TABLE.width - TABLE.radius, TABLE.radius),)


def _at_edge(stream: Random, x: float, y: float) -> draws.Vector:
    """Return a place on the table in parts of its size; 0 and 1 are inside that wall."""
    return _inside(stream, x, TABLE.width), _inside(stream, y, TABLE.height)


def _inside(stream: Random, part: float, size: float) -> float:
    """Return a coordinate; parts 0 and 1 overlap the wall there by less than the radius."""
    depth = stream.uniform(0.2, 0.8) * TABLE.radius
    if part in (0.0, 1.0):
        return round(TABLE.radius - depth if part == 0.0 else size - TABLE.radius + depth, 2)
    return round(part * size, 2)


def beside_the_bumper(stream: Random) -> Iterator[Arguments]:
    """Draw balls that overlap one side of the bumper and the other, well and by a hair."""
    for side in (1.0, -1.0):
        yield (_near_bumper(stream.uniform(0.2, 0.8), side, stream),)
        yield (_beside_bumper(stream.uniform(0.2, 0.8), side * (REACH - HAIR)),)


def at_the_ends(stream: Random) -> Iterator[Arguments]:
    """Draw balls that overlap the round ends, off the line of the bumper."""
    along_x, along_y = _along()
    for (x, y), sign in ((TABLE.bumper_start, -1.0), (TABLE.bumper_end, 1.0)):
        angle = math.radians(stream.uniform(20, 50))
        d_x = sign * (along_x * math.cos(angle) - along_y * math.sin(angle))
        d_y = sign * (along_y * math.cos(angle) + along_x * math.sin(angle))
        yield ((round(x + 15 * d_x, 3), round(y + 15 * d_y, 3)),)


def off_the_bumper(stream: Random) -> Iterator[Arguments]:
    """Draw balls that do not overlap: far behind, beyond an end in line with it, just off."""
    yield (_beside_bumper(stream.uniform(0.2, 0.8), REACH + HAIR),)
    yield ((round(stream.uniform(60, 120), 1), round(stream.uniform(300, 340), 1)),)
    along_x, along_y = _along()
    x, y = TABLE.bumper_end
    yield ((round(x + 40 * along_x + 2, 2), round(y + 40 * along_y - 2, 2)),)


def _near_bumper(part: float, side: float, stream: Random) -> draws.Vector:
    """Return a place that overlaps the bumper's side, `part` of the way along it."""
    return _beside_bumper(part, side * stream.uniform(0.7, 0.9) * REACH)


def _beside_bumper(part: float, distance: float) -> draws.Vector:
    """Return a place at a distance from the bumper's middle line, `part` of the way along it."""
    (x1, y1), (x2, y2) = TABLE.bumper_start, TABLE.bumper_end
    n_x, n_y = TABLE.bumper_normal
    x, y = x1 + part * (x2 - x1) + distance * n_x, y1 + part * (y2 - y1) + distance * n_y
    return round(x, 3), round(y, 3)


def _along() -> draws.Vector:
    """Return the bumper's direction, from its start to its end."""
    n_x, n_y = TABLE.bumper_normal
    return -n_y, n_x


def overlapping(stream: Random, *, leaving: bool) -> Iterator[Arguments]:
    """Draw balls that overlap something tilted and move into it, or away from it, slowly, too."""
    for how_fast in (draws.speed, draws.creep):
        normal = draws.oblique_normal(stream)
        v = (draws.velocity_away if leaving else draws.velocity_into)(stream, normal, how_fast)
        velocity = round(10 * v[0], 4), round(10 * v[1], 4)
        yield (200.0, 100.0), velocity, normal, round(stream.uniform(1, 8), 2)


def moving_in(stream: Random) -> Iterator[Arguments]:
    """Draw balls that move into what they overlap."""
    return overlapping(stream, leaving=False)


def moving_out(stream: Random) -> Iterator[Arguments]:
    """Draw balls that are already leaving what they overlap."""
    return overlapping(stream, leaving=True)


def free_steps(stream: Random) -> Iterator[Arguments]:
    """Draw steps without any contact, the last one of another length."""
    for position in ((120.0, 120.0), (450.0, 300.0)):
        yield position, _velocity(stream, 1, -1), TIME_STEP
    yield (120.0, 120.0), _velocity(stream, 1, -1), round(stream.uniform(0.02, 0.04), 3)


def wall_steps(stream: Random) -> Iterator[Arguments]:
    """Draw steps into a wall, and one that starts inside a wall but leads out of it."""
    yield (300.0, TABLE.radius + 1.0), _velocity(stream, 1, -1), TIME_STEP
    yield (TABLE.width - TABLE.radius - 1.0, 90.0), _velocity(stream, 1, 1), TIME_STEP
    yield (TABLE.radius - 8.0, 250.0), _velocity(stream, 0.5, 1), TIME_STEP


def corner_steps(stream: Random) -> Iterator[Arguments]:
    """Draw steps into two of the corners."""
    near, far = TABLE.radius + 1.0, TABLE.height - TABLE.radius - 1.0
    yield (near, near), _velocity(stream, -1, -1), TIME_STEP
    yield (near, far), _velocity(stream, -1, 1), TIME_STEP


def bumper_steps(stream: Random) -> Iterator[Arguments]:
    """Draw steps into both sides of the bumper, and one out of it."""
    for side, into in ((1.0, 1.0), (-1.0, 1.0), (1.0, -0.1)):
        position = _near_bumper(stream.uniform(0.3, 0.7), side, stream)
        speed = -side * into * stream.uniform(200, 300)
        n_x, n_y = TABLE.bumper_normal
        velocity = round(speed * n_x + 40, 2), round(speed * n_y + 40, 2)
        yield position, velocity, TIME_STEP


def _velocity(stream: Random, x: float, y: float) -> draws.Vector:
    """Return a velocity, px/s, whose components have the given signs and weights."""
    return round(x * stream.uniform(150, 300), 1), round(y * stream.uniform(150, 300), 1)


def whole_seconds(stream: Random) -> Iterator[Arguments]:
    """Draw frames of one second, and of a half as the sum of 30 steps, which lacks 1e-16 s.

    In the last one a fast ball meets the bottom and the top twice.
    """
    for elapsed in (1.0, sum(30 * [TIME_STEP], 0.0)):
        yield LAUNCH[0], _velocity(stream, 1, -1), elapsed
    yield (100.0, 200.0), (20.0, round(stream.uniform(1600, 1800), 1)), 1.0


def frames_with_a_rest(stream: Random) -> Iterator[Arguments]:
    """Draw frames that are no whole number of steps."""
    for steps in (6.6, 0.4):
        yield (100.0, 200.0), _velocity(stream, 0.5, 0.5), round(steps / 60, 6)


def the_launch(_: Random) -> Iterator[Arguments]:
    """Return the launch that meets all four walls and the bumper within 8 s."""
    yield (*LAUNCH, 8.0)


def names_hit(answer: Any) -> list[str]:
    """Return what the ball has hit, each once: the third part of what advance returns."""
    return sorted(set(answer[2]))


TASKS = (
    Task(
        id="B.1",
        function="wall_contacts",
        objective="Every wall that the ball overlaps.",
        expected=billiards_table.wall_contacts,
        criteria=(
            Criterion("each wall", at_one_wall),
            Criterion("corners", in_corners),
            Criterion("no wall", on_free_table),
        ),
    ),
    Task(
        id="B.2",
        function="bumper_contact",
        objective="How the ball overlaps the bumper, on both sides and at both ends.",
        expected=billiards_table.bumper_contact,
        criteria=(
            Criterion("both sides", beside_the_bumper, points=2),
            Criterion("both ends", at_the_ends),
            Criterion("no overlap", off_the_bumper),
        ),
    ),
    Task(
        id="B.3",
        function="resolve",
        objective="Separate first, then bounce; the tangent part is kept.",
        expected=billiards_table.resolve,
        criteria=(
            Criterion("a ball moving in", moving_in, points=2),
            Criterion("a ball moving out", moving_out),
        ),
    ),
    Task(
        id="B.4",
        function="step",
        objective="One step: move, bumper, walls.",
        expected=billiards_table.step,
        criteria=(
            Criterion("free flight", free_steps),
            Criterion("walls", wall_steps),
            Criterion("corners", corner_steps),
            Criterion("the bumper", bumper_steps),
        ),
    ),
    Task(
        id="B.5",
        function="advance",
        objective="The clock: whole steps only, and the time that is left over.",
        expected=billiards_table.advance,
        criteria=(
            Criterion("1 s is 60 steps", whole_seconds, points=2),
            Criterion("frames with a rest", frames_with_a_rest),
            Criterion("all four walls and the bumper within 8 s", the_launch, part=names_hit),
        ),
    ),
)

"""Tasks of chapter 07: when things meet, and what happens in the rest of the step."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from itertools import combinations
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.ch07_time_of_impact import draws as flights
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.geometry.impact_times import line_impact_time
from lesson_code.geometry.straight_impact_times import straight_impact_time
from lesson_code.reference.event_closed_forms import block_collisions

# 7.2: the floor


def thrown_down(stream: Random) -> Iterator[Arguments]:
    """Draw balls that start downwards."""
    for gravity in _gravities(stream, 2):
        yield _height(stream), -draws.speed(stream), gravity


def thrown_up_or_dropped(stream: Random) -> Iterator[Arguments]:
    """Draw a ball that starts upwards, and one that is let go."""
    up, none = _gravities(stream, 2)
    yield _height(stream), draws.speed(stream), up
    yield _height(stream), 0.0, none


def at_the_floor(stream: Random) -> Iterator[Arguments]:
    """Draw balls on the floor: two have just bounced, one of them slowly, and one is about to."""
    balls = ((1, draws.speed), (-1, draws.speed), (1, draws.creep))
    for (way, how_fast), gravity in zip(balls, _gravities(stream, 3), strict=True):
        yield 0.0, way * how_fast(stream), gravity


def nearly_weightless(stream: Random) -> Iterator[Arguments]:
    """Draw balls that drift down without gravity or nearly so, and up: one is never back.

    Of two that are let go, one stays where it is.
    """
    little, less = (1e-15 * gravity for gravity in _gravities(stream, 2))
    for gravity in (little, 0.0):
        yield _height(stream), -round(stream.uniform(0.2, 0.8), 2), gravity
        yield _height(stream), draws.speed(stream), gravity
    yield _height(stream), 0.0, less
    yield _height(stream), 0.0, 0.0


def _height(stream: Random) -> float:
    """Return the height of a ball above the floor, m."""
    return round(stream.uniform(1.0, 9.0), 2)


def _gravities(stream: Random, count: int) -> list[float]:
    """Return different gravities among those on the earth, on Mars and on the moon, m/s^2."""
    return stream.sample((9.81, 3.71, 1.62), count)


# 7.3: the rest of the step


def without_an_impact(stream: Random) -> Iterator[Arguments]:
    """Draw balls that reach no wall."""
    for _ in range(2):
        yield _in_a_room(stream, hits=0)


def with_one_impact(stream: Random) -> Iterator[Arguments]:
    """Draw balls that reach one wall: a left or lower one, the upper one, one of two before them.

    Of these two, the other one is nearer.
    """
    for holds in (_meets_a_wall_at_0, _meets_the_upper_wall, _meets_the_farther_wall):
        yield draws.until(holds, partial(_in_a_room, stream, hits=1))


def with_several_impacts(stream: Random) -> Iterator[Arguments]:
    """Draw steps so long that a ball bounces several times, on both pairs of walls.

    In the first one, the wall that is hit last is not the nearest one then.
    """
    yield draws.until(_ends_at_the_farther_wall, partial(_in_a_room, stream, hits=3))
    yield _in_a_room(stream, hits=8)


def starting_at_a_wall(stream: Random) -> Iterator[Arguments]:
    """Draw balls that start at a wall, two on the way into it and one on the way off."""
    for into, side in ((True, 0), (True, 1), (False, 0)):
        p, v, room, e, dt = _in_a_room(stream, hits=0)
        away = abs(v[0]) if side == 0 else -abs(v[0])
        yield (side * room[0], p[1]), (-away if into else away, v[1]), room, e, dt


def _in_a_room(stream: Random, hits: int) -> Arguments:
    """Return p, v, room, restitution and a step in which the ball hits `count` walls."""
    room = (round(stream.uniform(3.0, 4.0), 2), round(stream.uniform(2.0, 2.8), 2))
    p = tuple(round(size * stream.uniform(0.3, 0.7), 2) for size in room)
    v = tuple(stream.choice((-1, 1)) * draws.speed(stream) for _ in range(2))
    e = draws.restitution(stream)
    ends = [0.0, *_impact_times(p, v, room, e, hits + 1)]
    part = stream.uniform(0.4, 0.7)
    return p, v, room, e, (1 - part) * ends[hits] + part * ends[hits + 1]


def _meets_a_wall_at_0(drawn: Arguments) -> bool:
    """Return whether the wall that is met first is the left or the lower one."""
    _, times = _ways_and_times(drawn)
    return bool(drawn[1][times.index(min(times))] < 0)


def _meets_the_upper_wall(drawn: Arguments) -> bool:
    """Return whether the wall that is met first is the upper one."""
    _, times = _ways_and_times(drawn)
    return bool(drawn[1][1] > 0 and times[1] < times[0])


def _meets_the_farther_wall(drawn: Arguments) -> bool:
    """Return whether the wall that is met first is not the nearest of those before a ball."""
    ways, times = _ways_and_times(drawn)
    return ways.index(min(ways)) != times.index(min(times))


def _ends_at_the_farther_wall(drawn: Arguments) -> bool:
    """Return whether the last wall that is met is not the nearest, after the hit before it."""
    p, v, room, e, dt = drawn
    *_, before, _ = (t for t in _impact_times(p, v, room, e, 4) if t < dt)
    p, v = _advance(np.array(p), np.array(v), room, e, before + 1e-9)
    return _meets_the_farther_wall((p, v, room))


def _ways_and_times(drawn: Arguments) -> tuple[list[float], list[float]]:
    """Return how far the walls before a ball are along x and along y, m, and when it is there."""
    p, v, room, *_ = drawn
    ways = [size - x if u > 0 else x for x, u, size in zip(p, v, room, strict=True)]
    return ways, [way / abs(u) for way, u in zip(ways, v, strict=True)]


def _impact_times(p: Any, v: Any, room: Any, e: float, count: int) -> list[float]:
    """Return the times of the first impacts, s: each axis is a geometric series of its own."""
    times = []
    for x, speed, size in zip(p, v, room, strict=True):
        first = (size - x if speed > 0 else x) / abs(speed)
        ways = [size / (abs(speed) * e**n) for n in range(1, count)]
        times += [first + sum(ways[:n]) for n in range(count)]
    return sorted(times)[:count]


# 7.5: two blocks and a wall


def hundreds(_stream: Random) -> Iterator[Arguments]:
    """Yield mass ratios that are powers of 100."""
    for digits in range(4):
        yield (100.0**digits,)


def any_ratio(stream: Random) -> Iterator[Arguments]:
    """Draw mass ratios for which the count is not made of digits of pi, and one large one.

    The outer block is the heavier one in three cases, and the lighter one in the next. The first
    count is odd: then the last collision is one of the blocks, after which no wall is hit.
    """
    yield (_ratio(stream, 10, off_pi=True, odd=True),)
    for most in (10, 10, 0.25):
        yield (_ratio(stream, most, off_pi=True),)
    yield (_ratio(stream, most=900, off_pi=False),)


def _ratio(stream: Random, most: float, off_pi: bool, odd: bool = False) -> float:
    """Return a mass ratio that is clearly between two counts."""

    def is_clear(ratio: float) -> bool:
        turns = math.pi / math.atan(1 / math.sqrt(ratio))
        by_digits, count = int(math.pi * math.sqrt(ratio)), block_collisions(ratio)
        is_wanted = not (off_pi and by_digits == count) and (count % 2 == 1 or not odd)
        return 0.1 < turns % 1 < 0.9 and is_wanted

    return draws.until(is_clear, lambda: round(stream.uniform(most / 5, most), 2))


# What is expected


def _sweep_circles(
    p1: Any, v1: Any, r1: float, p2: Any, v2: Any, r2: float, dt: float
) -> float | None:
    """Return when two circles first touch, or None."""
    (dx, dy), (vx, vy) = p2 - p1, v2 - v1
    t = straight_impact_time(dx, dy, vx, vy, r1 + r2)
    return t if t <= dt and t < math.inf else None


def _time_to_floor(height: float, velocity: float, gravity: float) -> float | None:
    """Return when a ball under gravity next hits the floor, or None if it never does."""
    t = line_impact_time(height, velocity, -gravity)
    return t if t < math.inf else None


def _advance(p: Any, v: Any, room: Any, restitution: float, dt: float) -> tuple[Any, Any]:
    """Return where a ball is after a step in a room, and its velocity, all impacts included."""
    left = dt
    while True:
        times = [
            math.inf if v_k == 0 else (size - x if v_k > 0 else -x) / v_k
            for x, v_k, size in zip(p, v, room, strict=True)
        ]
        axis = int(np.argmin(times))
        if times[axis] >= left:
            return p + v * left, v
        p, left = p + v * times[axis], left - times[axis]
        v = np.where(np.arange(2) == axis, -restitution * v, v)


def _next_event(positions: Any, velocities: Any, radii: Any) -> tuple[float, int, int] | None:
    """Return (t, i, j) of the pair that meets first, or None."""
    meetings = [
        (t, i, j)
        for i, j in combinations(range(len(radii)), 2)
        if (t := _time_of_pair(positions, velocities, radii, i, j)) is not None
    ]
    return min(meetings, default=None)


def _time_of_pair(positions: Any, velocities: Any, radii: Any, i: int, j: int) -> float | None:
    """Return when circles i and j meet, however late, or None."""
    (dx, dy), (vx, vy) = positions[j] - positions[i], velocities[j] - velocities[i]
    t = straight_impact_time(dx, dy, vx, vy, float(radii[i] + radii[j]))
    return t if t < math.inf else None


# Why


def distance_at_the_answer(arguments: Arguments, answer: Any) -> str:
    """Say how far the centres are apart at the time that was returned, or how near they come."""
    p1, v1, r1, p2, v2, r2, dt = arguments
    (dx, dy), (vx, vy) = _relative(p1, p2), _relative(v1, v2)
    if answer is None:
        nearest = math.hypot(*_at(dx, dy, vx, vy, min(_nearest_time(dx, dy, vx, vy), dt)))
        says = f"In the step the centres come as near as {written(nearest)} m"
    else:
        apart = math.hypot(*_at(dx, dy, vx, vy, answer))
        says = f"At your t the centres are {written(apart)} m apart"
    change = written((dx * vx + dy * vy) / math.hypot(dx, dy))
    return f"{says}; r1 + r2 is {written(r1 + r2)} m. At the start that changes by {change} m/s."


def _relative(one: Any, other: Any) -> tuple[float, float]:
    """Return the way from one to the other."""
    return other[0] - one[0], other[1] - one[1]


def _at(dx: float, dy: float, vx: float, vy: float, t: float) -> tuple[float, float]:
    """Return where something is after a time that is at (dx, dy) now."""
    return dx + vx * t, dy + vy * t


def _nearest_time(dx: float, dy: float, vx: float, vy: float) -> float:
    """Return when it comes nearest to the origin, s: now, if it moves away or stands still."""
    speed_2 = vx * vx + vy * vy
    return max(-(dx * vx + dy * vy) / speed_2, 0.0) if speed_2 else 0.0


def height_at_the_answer(arguments: Arguments, answer: Any) -> str:
    """Say how high the ball is at the time that was returned."""
    height, velocity, gravity = arguments
    if answer is None:
        return ""
    then = height + velocity * answer - gravity * answer**2 / 2
    return f"After your t the ball is {written(then)} m above the floor."


def impacts_in_the_step(arguments: Arguments, _answer: Any) -> str:
    """Say when in the step the ball meets walls."""
    p, v, room, e, dt = arguments
    times = [t for t in _impact_times(p, v, room, e, MOST_TIMES_NAMED) if t < dt]
    return f"Impacts in this step of {written(dt)} s: {', '.join(map(written, times)) or 'none'}."


MOST_TIMES_NAMED = 12
"""More impacts than any step of the task has."""


def what_all_pairs_do(arguments: Arguments, _answer: Any) -> str:
    """Say which pairs meet, and when."""
    radii = arguments[2]
    meetings = [
        f"{i} and {j} at {written(t)} s"
        for i, j in combinations(range(len(radii)), 2)
        if (t := _meeting_time(arguments, i, j)) is not None
    ]
    return f"Left alone, these meet: {'; '.join(meetings) or 'none'}."


def _meeting_time(arguments: Arguments, i: int, j: int) -> float | None:
    """Return when i and j meet: before they are nearest, as long as Pythagoras says; or None."""
    positions, velocities, radii = arguments
    d, v = _relative(positions[i], positions[j]), _relative(velocities[i], velocities[j])
    nearest_time = _nearest_time(*d, *v)
    left = (radii[i] + radii[j]) ** 2 - math.hypot(*_at(*d, *v, nearest_time)) ** 2
    if nearest_time == 0 or left < 0:
        return None
    return max(nearest_time - math.sqrt(left) / math.hypot(*v), 0.0)


TASKS = (
    Task(
        id="7.1",
        function="sweep_circles",
        section=3,
        objective="When two moving circles meet, if they do so within the step.",
        expected=_sweep_circles,
        criteria=(
            Criterion("a hit within the step", flights.hits, points=2),
            Criterion("a fast graze", flights.fast_grazes),
            Criterion("a hit after the end of the step", flights.late_hits),
            Criterion("circles that never meet, and two that do", flights.misses),
            Criterion("circles that touch or overlap at the start", flights.in_touch),
        ),
        explain=distance_at_the_answer,
    ),
    Task(
        id="7.2",
        function="time_to_floor",
        section=4,
        objective="When a ball under gravity next hits the floor.",
        expected=_time_to_floor,
        criteria=(
            Criterion("thrown down", thrown_down),
            Criterion("thrown up, or dropped", thrown_up_or_dropped),
            Criterion("on the floor at the start", at_the_floor),
            Criterion("next to no gravity", nearly_weightless),
        ),
        explain=height_at_the_answer,
    ),
    Task(
        id="7.3",
        function="advance",
        section=7,
        objective="A whole step of a ball in a room: to the impact, bounce, and on.",
        expected=_advance,
        criteria=(
            Criterion("a step without an impact", without_an_impact),
            Criterion("one impact", with_one_impact, points=2),
            Criterion("several impacts", with_several_impacts),
            Criterion("at a wall at the start", starting_at_a_wall),
        ),
        explain=impacts_in_the_step,
    ),
    Task(
        id="7.4",
        function="next_event",
        section=8,
        objective="Which of all pairs of circles meets first, and when.",
        expected=_next_event,
        criteria=(
            Criterion("the earliest of several", flights.crowds_soon_and_late, points=2),
            Criterion("a pair that meets now", flights.crowds_with_a_hit_now),
            Criterion("crowds in which no pair meets", flights.crowds_that_part),
        ),
        explain=what_all_pairs_do,
    ),
    Task(
        id="7.5",
        function="pi_collisions",
        section=9,
        objective="How often two blocks and a wall collide, from collision to collision.",
        expected=block_collisions,
        criteria=(
            Criterion("mass ratios 1, 100, 10,000, ...", hundreds),
            Criterion("any mass ratio", any_ratio, points=2),
        ),
        has_one_form=True,
    ),
)

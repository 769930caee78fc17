"""For how long two moving bodies certainly keep their distance: the step of a conservative search.

Along any axis n the bodies are at least as far apart as their intervals are. Let the axis turn at
the rate s. The gap along it between a corner p of A and a corner q of B,

    gap = n . (d + q - p),   has the rate   n . v + s n' . d + (w_b - s) n . q' - (w_a - s) n . p'

(a dash: turned by +90 degrees; a corner turns against the axis at the difference of both rates),
and a second derivative of at most

    k = (w_a - s)^2 abs(p) + (w_b - s)^2 abs(q) + s^2 abs(d) + 2 abs(s) abs(v)

in size. Hence the gap is never below gap + rate t - k t^2 / 2, and the time in which the lowest of
these parabolas falls to a target is safe. Three axes are tried, and the longest time counts: the
best face of A, turning with A; the best face of B, turning with B; and the direction between the
nearest points, at rest. Near an impact one of them is right but for terms in t^2, so that every
step squares the error. A body that spins fast is also tried as the circle that holds it at
every angle: it has one point along n, at `size`, which neither moves nor bends.

========  ==================================================================  =======
symbol    meaning                                                             unit
========  ==================================================================  =======
d, v      B's position and velocity, seen from A                              m, m/s
w         angular velocity                                                    rad/s
p, q      a corner of A, of B, seen from its body's position                  m
size      distance of a body's farthest corner from its position              m
n, s      unit normal of the axis; the rate at which the axis turns           -, rad/s
========  ==================================================================  =======
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

from lesson_code.geometry.impact_times import line_impact_time
from lesson_code.geometry.rows import Corner
from lesson_code.geometry.separation import (
    Outline,
    RelativePose,
    best_face,
    face_normal,
    seen_from_b,
    seen_turned,
)
from lesson_code.geometry.straight_impact_times import straight_impact_time


class Axis(NamedTuple):
    """A direction along which a gap is measured: a unit vector, and the rate at which it turns."""

    nx: float
    ny: float
    turning: float  # rad/s


class MovingOutline(Outline, Protocol):
    """The fields of a body that say how it moves."""

    vx: float
    vy: float
    w: float


class Motion(NamedTuple):
    """How two bodies move, and how far their outlines reach from their positions."""

    vx: float  # m/s, of B, seen from A
    vy: float
    w_a: float  # rad/s
    w_b: float
    size_a: float  # m, distance of the farthest corner; 0 for a circle
    size_b: float


def motion_of(corners: Sequence[Corner], a: MovingOutline, b: MovingOutline) -> Motion:
    """Return how two bodies move. A circle may turn as it likes."""
    w_a = a.w if a.corner_count > 0 else 0.0
    w_b = b.w if b.corner_count > 0 else 0.0
    return Motion(b.vx - a.vx, b.vy - a.vy, w_a, w_b, size_of(corners, a), size_of(corners, b))


def size_of(corners: Sequence[Corner], body: Outline) -> float:
    """Return the distance of a body's farthest corner from its position, m."""
    most = 0.0
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        most = max(most, math.sqrt(c.local_x * c.local_x + c.local_y * c.local_y))
    return most


def motion_seen_from_b(motion: Motion) -> Motion:
    """Return how two bodies move, with A and B exchanged."""
    return Motion(
        0.0 - motion.vx,
        0.0 - motion.vy,
        motion.w_b,
        motion.w_a,
        motion.size_b,
        motion.size_a,
    )


def safe_time(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    gap: float,
    nx: float,
    ny: float,
    target: float,
    limit: float,
) -> float:
    """Return a time in which the distance does not fall below the target; inf if over the limit."""
    spin = abs(motion.w_a) * motion.size_a + abs(motion.w_b) * motion.size_b
    closing = spin - (motion.vx * nx + motion.vy * ny)
    step = (gap - target) / closing if closing > 0.0 else math.inf
    step = max(step, wait_for_bounds(a, b, at, motion, target))
    if step > limit:
        return math.inf
    back, motion_back = seen_from_b(at), motion_seen_from_b(motion)
    step = max(step, axis_time(corners, a, b, at, motion, Axis(nx, ny, 0.0), target, limit))
    step = max(step, face_time(corners, a, b, at, motion, target, limit))
    return max(step, face_time(corners, b, a, back, motion_back, target, limit))


def wait_for_bounds(
    a: Outline, b: Outline, at: RelativePose, motion: Motion, target: float
) -> float:
    """Return when the circles that hold the bodies at any angle meet, s; 0 if they overlap."""
    radius_sum = a.radius + b.radius + motion.size_a + motion.size_b + max(target, 0.0)
    if at.dx * at.dx + at.dy * at.dy <= radius_sum * radius_sum:
        return 0.0
    return straight_impact_time(at.dx, at.dy, motion.vx, motion.vy, radius_sum)


def face_time(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    target: float,
    limit: float,
) -> float:
    """Return the safe time along the best face of A, which turns with A."""
    _, k = best_face(corners, a, b, at)
    if k < 0:
        return 0.0
    nx, ny = face_normal(corners, at, k)
    axis = Axis(nx, ny, motion.w_a)
    return axis_time(corners, a, b, at, motion, axis, target, limit)


def axis_time(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    axis: Axis,
    target: float,
    limit: float,
) -> float:
    """Return a time, at most the limit, in which the gap along an axis stays above the target.

    It is the longest that is found with corners, or with circles instead where a body turns
    against the axis.
    """
    if axis.turning != 0.0:
        limit = min(limit, 1.0 / abs(axis.turning))
    turns_a, turns_b = motion.w_a != axis.turning, motion.w_b != axis.turning
    time = fall_time(corners, a, b, at, motion, axis, target, limit, False, False)
    if turns_a:
        time = max(time, fall_time(corners, a, b, at, motion, axis, target, limit, True, False))
    if turns_b:
        time = max(time, fall_time(corners, a, b, at, motion, axis, target, limit, False, True))
    if turns_a and turns_b:
        time = max(time, fall_time(corners, a, b, at, motion, axis, target, limit, True, True))
    return time


def fall_time(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    axis: Axis,
    target: float,
    limit: float,
    as_circle_a: bool,
    as_circle_b: bool,
) -> float:
    """Return when the lowest parabola falls to the target, at most the limit; 0 if it is below now.

    First the two corners are taken that lead at the limit. If their parabola falls to the target
    before, the limit moves there, and others may lead; each choice of corners comes up once.
    """
    gap, _, _ = leading_gap(corners, a, b, at, motion, axis, as_circle_a, as_circle_b, 0.0)
    if gap <= target:
        return 0.0
    bend = bend_of_axis(at, motion, axis.turning, limit)
    time = limit
    for _ in range(a.corner_count + b.corner_count + 1):
        gap, rate, more = leading_gap(
            corners, a, b, at, motion, axis, as_circle_a, as_circle_b, time
        )
        fall = line_impact_time(gap - target, rate, -(bend + more))
        if fall >= time:
            break
        time = fall
    return time


def leading_gap(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    axis: Axis,
    as_circle_a: bool,
    as_circle_b: bool,
    after: float,
) -> tuple[float, float, float]:
    """Return gap, rate and bend of the corners whose gap may be least after a time.

    In m, m/s and m/s^2; the bend is the part of k that comes of the corners.
    """
    nx, ny, turning = axis
    bend = 0.0
    gap = at.dx * nx + at.dy * ny - a.radius - b.radius
    rate = motion.vx * nx + motion.vy * ny + turning * (at.dy * nx - at.dx * ny)
    if as_circle_a:
        gap -= motion.size_a
    else:
        mx, my = seen_turned(nx, ny, at.cos_a, at.sin_a)
        height, rise, more = leading_corner(corners, a, mx, my, motion.w_a - turning, after)
        gap, rate, bend = gap - height, rate - rise, bend + more
    if as_circle_b:
        gap -= motion.size_b
    else:
        mx, my = seen_turned(-nx, -ny, at.cos_b, at.sin_b)
        height, rise, more = leading_corner(corners, b, mx, my, motion.w_b - turning, after)
        gap, rate, bend = gap - height, rate - rise, bend + more
    return gap, rate, bend


def bend_of_axis(at: RelativePose, motion: Motion, turning: float, limit: float) -> float:
    """Return the part of k that comes of the axis' turning, within the limit, m/s^2."""
    end_x, end_y = at.dx + motion.vx * limit, at.dy + motion.vy * limit
    distance = math.sqrt(max(at.dx * at.dx + at.dy * at.dy, end_x * end_x + end_y * end_y))
    speed = math.sqrt(motion.vx * motion.vx + motion.vy * motion.vy)
    return turning * turning * distance + 2.0 * abs(turning) * speed


def leading_corner(
    corners: Sequence[Corner], body: Outline, mx: float, my: float, spin: float, after: float
) -> tuple[float, float, float]:
    """Return height, rate and bend along m of the corner that may lead after a time: m, m/s, m/s^2.

    Heights go on at their present rates, spin (p x m), and are bent by spin^2 abs(p) at the most;
    for the body's centre 0.
    """
    most, height, rise, bent = -math.inf, 0.0, 0.0, 0.0
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        here = c.local_x * mx + c.local_y * my
        rate = spin * (c.local_x * my - c.local_y * mx)
        bend = spin * spin * math.sqrt(c.local_x * c.local_x + c.local_y * c.local_y)
        there = here + (rate + 0.5 * bend * after) * after
        if there > most:
            most, height, rise, bent = there, here, rate, bend
    return height, rise, bent

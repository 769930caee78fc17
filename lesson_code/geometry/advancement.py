"""When turning shapes first touch: conservative advancement, by steps that cannot go too far.

The place of a turning corner is made of sines and cosines, and no formula gives the time at which
it meets another shape. So: measure the distance, step by a time in which it certainly cannot be
used up, and measure again, until it is within a tolerance.

**It ends.** No gap changes faster than top_speed = abs(v) + abs(w_a) size_a + abs(w_b) size_b. A
step lets the distance change by half the tolerance or more, and so takes tolerance / (2 top_speed)
or more: there are at most 2 top_speed duration / tolerance + 2 looks. That is the guarantee. Usual
are 5 to 15, since near an impact every step squares the error: 7 in the middle for shapes that turn
at 3 rad/s and meet after 1 s, 9 at 30 rad/s, 11 at 300 rad/s. Shapes that turn within reach of each
other and do not meet take some 5 for every radian.

**It misses nothing.** Bodies that are apart are so until the time that is returned. At that time
their distance is at most the tolerance, and shrinking. The time is thus never after the true
impact (but for rounding of the places then), and before it by no more than the bodies need to close
a gap as small as the tolerance. A pass nearer than the tolerance may be called an impact. Bodies
that touch at the start and part may come back unnoticed if they then overlap by less than two
tolerances; and those that overlap may come nearer for a while by 1e-4 of their depth.

========  ==================================================================  =======
symbol    meaning                                                             unit
========  ==================================================================  =======
v         velocity of B, seen from A                                          m/s
w         angular velocity                                                    rad/s
size      distance of a body's farthest corner from its position              m
gap       distance between the surfaces, negative when they overlap           m
========  ==================================================================  =======
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from lesson_code.geometry.closing import is_closing
from lesson_code.geometry.rows import Corner
from lesson_code.geometry.safe_time import Motion, motion_of, safe_time
from lesson_code.geometry.separation import RelativePose, separation_rows

TOLERANCE = 1e-12
"""Of the bodies' sizes, together: a gap as small as this is an impact. At 1e-15 rounding
decides; at 1e-6 the impact comes too early by 1e-6 s at 1 m/s, for a gain of one look."""

DEEPER = 1e-4
"""Of the depth: from one look to the next, bodies that overlap come nearer by no more. With the
tolerance in its place, a corner that goes along a face for 3 s took millions of looks."""

MOST_LOOKS = 100_000
"""Then the search is given up. Two gears that turn without touching take some 30 looks for a
turn; without this a search over a million turns would seem to hang."""

NEXT_FLOAT = 1.0 + 2.3e-16
"""Times a float: the next one above it. A time that is too large to be added to still goes on."""


class SweptBody(Protocol):
    """The fields of a body that a sweep reads; a row may have more than these."""

    x: float
    y: float
    angle: float
    vx: float
    vy: float
    w: float
    radius: float
    first_corner: int
    corner_count: int


@dataclass(slots=True)
class Moving:
    """A shape that moves: no more of a body than a sweep needs."""

    x: float = 0.0  # m, position
    y: float = 0.0
    angle: float = 0.0  # rad, counter-clockwise
    vx: float = 0.0  # m/s
    vy: float = 0.0
    w: float = 0.0  # rad/s, counter-clockwise
    radius: float = 0.0  # m, how far the shape reaches beyond its outline
    first_corner: int = 0  # where its outline begins in the table of corners
    corner_count: int = 0  # 0 circle, 2 segment, 3 and more polygon


def advance_to_impact(
    corners: Sequence[Corner], a: SweptBody, b: SweptBody, duration: float, tolerance: float
) -> float:
    """Return when two bodies that may turn first touch, s; inf if not within the duration.

    They keep their velocities until then. At the time that is returned they are within the
    tolerance of each other and closing; it is never after the true impact. If the search has been
    given up, they only certainly do not touch before it.

    Parameters
    ----------
    corners : sequence of Corner
        Table with both outlines. Only their places at angle 0 are read; nothing is changed.
    a, b : SweptBody
        Both rows; they are not changed.
    duration : float
        s, >= 0.
    tolerance : float
        m, > 0: :data:`TOLERANCE` times the sum of both bounding radii, say.

    Returns
    -------
    float
        s, >= 0.

    References
    ----------
    Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, PhD thesis, University of
    California, Berkeley (1996): conservative advancement, there with one axis that does not turn.

    Examples
    --------
    A rod that reaches 2 m up from its pivot turns by 30 degrees in 1 s. Then its tip is 1 m to the
    side, at a wall:

    >>> from lesson_code.geometry.rows import corner_rows
    >>> corners = corner_rows([(0.0, 2.0), (0.0, 0.0)]) + corner_rows([(1.0, 9.0), (1.0, 0.0)])
    >>> rod = Moving(w=-math.pi / 6, first_corner=0, corner_count=2)
    >>> wall = Moving(first_corner=2, corner_count=2)
    >>> round(advance_to_impact(corners, rod, wall, duration=5.0, tolerance=1e-12), 9)
    1.0
    """
    time, _ = advance(corners, a, b, duration, tolerance)
    return time


def advance(
    corners: Sequence[Corner], a: SweptBody, b: SweptBody, duration: float, tolerance: float
) -> tuple[float, bool]:
    """Return the time of :func:`advance_to_impact`, and whether the search came to its end."""
    motion = motion_of(corners, a, b)
    t = before = 0.0
    for _ in range(MOST_LOOKS):
        at = pose_at(a, b, t)
        gap, nx, ny = separation_rows(corners, a, b, at)
        if gap <= tolerance and is_closing(corners, a, b, at, motion, gap, nx, ny, tolerance):
            if gap < -tolerance:
                t = start_of_closing(corners, a, b, motion, before, t, tolerance)
            return t, True
        before = t
        target = 0.5 * tolerance if gap > tolerance else gap - max(tolerance, -DEEPER * gap)
        step = safe_time(corners, a, b, at, motion, gap, nx, ny, target, duration - t)
        if gap < -tolerance:  # not beyond the end of the overlap
            step = min(step, shortest_way_out(motion, -gap))
        if t + step > duration:
            return math.inf, True
        if t + step == t and gap > tolerance:
            return t, True  # as near as floats of this size can tell
        t = max(t + step, t * NEXT_FLOAT)
    return t, False


def start_of_closing(
    corners: Sequence[Corner],
    a: SweptBody,
    b: SweptBody,
    motion: Motion,
    before: float,
    after: float,
    tolerance: float,
) -> float:
    """Return when bodies that overlap come nearer again, s, by halving the time between two looks.

    At the first look they part, at the second one they close: where their depth is least, it
    hardly changes, and looks that follow the depth come too late by the root of the tolerance.
    """
    while True:
        t = 0.5 * (before + after)
        if t <= before or t >= after:
            return after
        at = pose_at(a, b, t)
        gap, nx, ny = separation_rows(corners, a, b, at)
        touching = gap <= tolerance  # a look on the way may find them apart
        if touching and is_closing(corners, a, b, at, motion, gap, nx, ny, tolerance):
            after = t
        else:
            before = t


def shortest_way_out(motion: Motion, depth: float) -> float:
    """Return the time in which no overlap as deep as this can end, s."""
    speed = math.sqrt(motion.vx * motion.vx + motion.vy * motion.vy)
    speed += abs(motion.w_a) * motion.size_a + abs(motion.w_b) * motion.size_b
    return depth / speed if speed > 0.0 else math.inf


def pose_at(a: SweptBody, b: SweptBody, t: float) -> RelativePose:
    """Return where two bodies are after a time."""
    angle_a, angle_b = a.angle + a.w * t, b.angle + b.w * t
    return RelativePose(
        (b.x - a.x) + (b.vx - a.vx) * t,
        (b.y - a.y) + (b.vy - a.vy) * t,
        math.cos(angle_a),
        math.sin(angle_a),
        math.cos(angle_b),
        math.sin(angle_b),
    )

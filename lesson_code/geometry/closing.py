"""Whether two bodies come nearer right now: the first question about shapes that touch.

The distance of two bodies is the largest gap along any axis. Where several gaps are as large,
as between two boxes of which one stands flat on the other, the distance shrinks only if
all of them shrink.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.geometry.rows import Corner
from lesson_code.geometry.safe_time import Axis, Motion, motion_seen_from_b
from lesson_code.geometry.separation import (
    Outline,
    RelativePose,
    face_gap,
    face_normal,
    farthest,
    seen_from_b,
    seen_turned,
)

AT_REST = 1e-14
"""Of the speeds involved: what closes more slowly than this does so by rounding only."""


def is_closing(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    gap: float,
    nx: float,
    ny: float,
    tolerance: float,
) -> bool:
    """Return whether the distance of two bodies shrinks right after now.

    The distance is the largest gap along any axis, so that it shrinks only if the gaps along all
    those axes shrink that are as large: within a quarter of the tolerance, so that the two sides
    of a line are told apart where another comes as near as half of it.
    """
    if not axis_is_closing(corners, a, b, at, motion, Axis(nx, ny, 0.0), tolerance):
        return False
    least = gap + a.radius + b.radius - 0.25 * tolerance
    back, motion_back = seen_from_b(at), motion_seen_from_b(motion)
    return faces_are_closing(corners, a, b, at, motion, least, tolerance) and faces_are_closing(
        corners, b, a, back, motion_back, least, tolerance
    )


def faces_are_closing(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    least: float,
    tolerance: float,
) -> bool:
    """Return whether the gaps shrink along the normals of those faces of A with the least gap."""
    for k in range(a.first_corner, a.first_corner + a.corner_count):
        if face_gap(corners, b, at, k) >= least:
            nx, ny = face_normal(corners, at, k)
            axis = Axis(nx, ny, motion.w_a)
            if not axis_is_closing(corners, a, b, at, motion, axis, tolerance):
                return False
    return True


def axis_is_closing(
    corners: Sequence[Corner],
    a: Outline,
    b: Outline,
    at: RelativePose,
    motion: Motion,
    axis: Axis,
    tolerance: float,
) -> bool:
    """Return whether the gap along an axis shrinks: faster than by rounding of the speeds."""
    nx, ny, turning = axis
    ax, ay = seen_turned(nx, ny, at.cos_a, at.sin_a)
    bx, by = seen_turned(-nx, -ny, at.cos_b, at.sin_b)
    rate = motion.vx * nx + motion.vy * ny + turning * (at.dy * nx - at.dx * ny)
    rate -= fastest_rise(corners, a, ax, ay, motion.w_a - turning, tolerance)
    rate -= fastest_rise(corners, b, bx, by, motion.w_b - turning, tolerance)
    speeds = abs(motion.vx) + abs(motion.vy) + abs(turning) * (abs(at.dx) + abs(at.dy))
    speeds += abs(motion.w_a) * motion.size_a + abs(motion.w_b) * motion.size_b
    return rate < -AT_REST * speeds


def fastest_rise(
    corners: Sequence[Corner], body: Outline, mx: float, my: float, spin: float, tolerance: float
) -> float:
    """Return the largest rate along m of the corners that lead along m, within the tolerance."""
    least = farthest(corners, body, mx, my) - tolerance
    most = -math.inf
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        if c.local_x * mx + c.local_y * my >= least:
            most = max(most, spin * (c.local_x * my - c.local_y * mx))
    return most if body.corner_count > 0 else 0.0

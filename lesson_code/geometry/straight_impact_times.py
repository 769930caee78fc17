"""Times of impact of a circle that flies straight: no parabola is needed for them.

:mod:`lesson_code.geometry.impact_times` turns to these functions wherever the acceleration is 0;
what never accelerates needs no others. Both give the same bits.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.geometry.nearest_feature import (
    is_approaching,
    is_corner_hit,
    is_nearest,
    nearest_feature,
)
from lesson_code.geometry.rows import Corner, PlacedBody


def straight_face_time(gap: float, v: float) -> float:
    """Return when a height falls to 0 at a constant velocity: now, if it has fallen below.

    >>> straight_face_time(5.0, -2.0), straight_face_time(5.0, 2.0), straight_face_time(-1.0, -2.0)
    (2.5, inf, 0.0)
    """
    if v >= 0.0:
        return math.inf
    return gap / -v if gap > 0.0 else 0.0


def straight_impact_time(dx: float, dy: float, vx: float, vy: float, radius_sum: float) -> float:
    """Return when two circles without relative acceleration touch and come nearer.

    t = c / (-b + sqrt(b^2 - v^2 c)),   b = d . v,   c = d^2 - r^2

    This form of the root adds two positive numbers. Both differences of squares are taken as
    products, c = (abs(d) - r) (abs(d) + r) with r the sum of the radii and, with d x v = abs(v)
    times the distance at which the centres would pass, b^2 - v^2 c = (r abs(v))^2 - (d x v)^2
    likewise.

    >>> straight_impact_time(4.0, 0.0, -2.0, 0.0, 1.0)
    1.5
    """
    b = dx * vx + dy * vy
    if b >= 0.0:
        return math.inf
    distance = math.sqrt(dx * dx + dy * dy)
    if distance <= radius_sum:
        return 0.0
    passing = abs(dx * vy - dy * vx)
    touching = radius_sum * math.sqrt(vx * vx + vy * vy)
    if passing >= touching:
        return math.inf
    root = math.sqrt((touching - passing) * (touching + passing))
    return (distance - radius_sum) * (distance + radius_sum) / (root - b)


def straight_outline_impact_time(
    corners: Sequence[Corner],
    body: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    radius: float,
) -> tuple[float, int]:
    """Return when a circle without acceleration touches an outline that does not turn, and where.

    What is asked and answered is as in :func:`.circle_outline_impact_time`. A circle
    that flies straight and has parted does not come back.

    >>> from lesson_code.geometry.rows import place
    >>> corners = []
    >>> floor = place([(9.0, 0.0), (-9.0, 0.0)], 0.0, (0.0, 0.0, 0.0), corners)
    >>> straight_outline_impact_time(corners, floor, 0.0, 2.625, 0.0, -1.0, 0.625)
    (2.0, 0)
    """
    radius_sum = radius + body.radius
    distance, feature = nearest_feature(corners, body, dx, dy)
    if distance <= radius_sum:
        comes = is_approaching(corners, feature, dx, dy, vx, vy, 0.0, 0.0)
        return 0.0 if comes else math.inf, feature
    time, soonest = first_straight_face_time(corners, body, dx, dy, vx, vy, radius_sum)
    if soonest < time:  # else no corner can be hit before
        time = min(time, first_straight_corner_time(corners, body, dx, dy, vx, vy, radius_sum))
    if time < math.inf:
        _, feature = nearest_feature(corners, body, dx + time * vx, dy + time * vy)
    return time, feature


def first_straight_face_time(
    corners: Sequence[Corner],
    body: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    radius_sum: float,
) -> tuple[float, float]:
    """Return what :func:`first_face_time` does for a circle without acceleration."""
    time, soonest = math.inf, 0.0
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        gap = (dx - c.x) * c.nx + (dy - c.y) * c.ny - radius_sum
        if gap > 0.0:
            t = straight_face_time(gap, vx * c.nx + vy * c.ny)
            soonest = max(soonest, t)
            if t < time:
                px, py = dx + t * vx, dy + t * vy
                if is_nearest(corners, body, (px - c.x) * c.nx + (py - c.y) * c.ny, c, px, py):
                    time = t
    return time, soonest


def first_straight_corner_time(
    corners: Sequence[Corner],
    body: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    radius_sum: float,
) -> float:
    """Return the earliest impact on a corner, > 0, of a circle without acceleration."""
    time = math.inf
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        t = straight_impact_time(dx - c.x, dy - c.y, vx, vy, radius_sum)
        if t < time and is_corner_hit(corners, body, c, dx, dy, vx, vy, 0.0, 0.0, t):
            time = t
    return time

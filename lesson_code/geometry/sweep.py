"""The time of impact of two moving shapes: the public door, and which way leads to the answer.

========================================  ====================================================
pair                                      way
========================================  ====================================================
two circles                               closed form: the distance of the centres
circle, and an outline that does not      closed form: a face, or a corner as a circle
turn
two outlines that do not turn             closed form: every corner of one against the other
an outline that turns                     conservative advancement, to a stated tolerance
========================================  ====================================================

A circle may spin about its centre as it likes: it looks the same at any angle.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from lesson_code.formulas.validation import Vector, finite, non_negative, one_number
from lesson_code.geometry.advancement import MOST_LOOKS, TOLERANCE, Moving, advance
from lesson_code.geometry.closing import is_closing
from lesson_code.geometry.impact_times import circle_impact_time, circle_outline_impact_time
from lesson_code.geometry.rows import Corner, Placed, PlacedBody, place
from lesson_code.geometry.safe_time import Motion
from lesson_code.geometry.sat import TIE
from lesson_code.geometry.separation import RelativePose, separation_rows
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape


def time_of_impact(
    shape_a: Shape,
    pose_a: Vector,
    velocity_a: Vector,
    shape_b: Shape,
    pose_b: Vector,
    velocity_b: Vector,
    duration: float,
) -> float | None:
    """Return when two moving shapes first touch and come nearer.

    Both keep their velocities. Nothing is sampled: no speed is too high and no wall too thin.

    Parameters
    ----------
    shape_a, shape_b : Circle, Polygon or Segment
        The shapes.
    pose_a, pose_b : (x, y, angle)
        Where they are at the start: position in m, angle in rad, counter-clockwise.
    velocity_a, velocity_b : (vx, vy, w)
        Velocity of the position in m/s, angular velocity in rad/s, counter-clockwise.
    duration : float
        How long to look ahead, s, >= 0.

    Returns
    -------
    float or None
        Time of impact, s, from 0 to the duration. 0.0 is a time: shapes that touch or overlap
        and come nearer meet now. Those that touch or overlap and part do not meet, unless
        they come back; nor do those that graze, touching without ever overlapping. None for no
        impact. If a polygon or segment turns, the time is that at which the shapes are
        still apart by up to 1e-12 of their sizes, and never later than the impact; else it is a
        root in closed form.

    Raises
    ------
    TypeError
        A shape is something else.
    ValueError
        A pose or velocity is not three finite numbers, or the duration is negative or not finite;
        or shapes turn past each other so often that the search is given up.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 5.5.

    Examples
    --------
    A disc of radius 0.5 m at 1,000 m/s, 3 m from a wall of no thickness; then 60 frames a second:

    >>> disc, wall = Circle(0.5), Segment((0, -1), (0, 1))
    >>> time_of_impact(disc, (-3, 0, 0), (1000, 0, 0), wall, (0, 0, 0), (0, 0, 0), 1 / 60)
    0.0025
    >>> time_of_impact(disc, (-3, 0, 0), (1, 0, 0), wall, (0, 0, 0), (0, 0, 0), 1 / 60) is None
    True

    A rod of 4 m whose middle is 1 m from the wall turns by 30 degrees a second until it hits it:

    >>> rod = Segment((0, -2), (0, 2))
    >>> turning, still = (0, 0, -math.pi / 6), (0, 0, 0)
    >>> time = time_of_impact(rod, (-1, 0, 0), turning, wall, (0, 1, 0), still, 9)
    >>> round(time, 9)
    1.0
    """
    corners: list[Corner] = []
    a, moving_a = _rows("a", shape_a, pose_a, velocity_a, corners)
    b, moving_b = _rows("b", shape_b, pose_b, velocity_b, corners)
    horizon = one_number("duration", duration, non_negative)
    if (a.corner_count and moving_a.w) or (b.corner_count and moving_b.w):
        time = _turning_impact_time(shape_a, moving_a, shape_b, moving_b, corners, horizon)
    else:
        vx, vy = moving_b.vx - moving_a.vx, moving_b.vy - moving_a.vy
        time = impact_time(corners, a, b, vx, vy)
    return time if time <= horizon else None


def impact_time(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, vx: float, vy: float
) -> float:
    """Return the time of impact of two bodies that do not turn, s; inf for none.

    The outlines of both stand in the table of corners, turned with their bodies; (vx, vy) is B's
    velocity, seen from A.
    """
    if a.corner_count > 0 and b.corner_count > 0:
        return outlines_impact_time(corners, a, b, vx, vy)
    return impact_time_with_circle(corners, a, b, vx, vy)


def impact_time_with_circle(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, vx: float, vy: float
) -> float:
    """Return the same for two bodies of which one at least is a circle."""
    dx, dy = b.x - a.x, b.y - a.y
    if a.corner_count > 0:
        return circle_outline_impact_time(corners, a, dx, dy, vx, vy, 0.0, 0.0, b.radius)[0]
    if b.corner_count > 0:
        return circle_outline_impact_time(corners, b, -dx, -dy, -vx, -vy, 0.0, 0.0, a.radius)[0]
    return circle_impact_time(dx, dy, vx, vy, 0.0, 0.0, a.radius + b.radius)


def outlines_impact_time(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, vx: float, vy: float
) -> float:
    """Return the time of impact of two polygons or segments that do not turn, s; inf for none.

    Where convex outlines first touch, a corner of one touches the other. Every corner moves as
    the centre of a circle as wide as its outline's rounding. Parallel lines without thickness can
    only touch and never overlap. They meet all the same, side to side, but not end to end, and not
    if they touch at the start.
    """
    dx, dy = b.x - a.x, b.y - a.y
    if separation_rows(corners, a, b, _pose(a, b, dx, dy))[0] <= 0.0:
        time = 0.0
    else:
        time = corners_impact_time(corners, a, b, dx, dy, vx, vy)
        time = min(time, corners_impact_time(corners, b, a, -dx, -dy, -vx, -vy))
        if are_parallel_lines(corners, a, b):
            return time
    if time < math.inf and is_grazing(corners, a, b, dx + vx * time, dy + vy * time, vx, vy):
        return math.inf
    return time


def are_parallel_lines(corners: Sequence[Corner], a: PlacedBody, b: PlacedBody) -> bool:
    """Return whether both outlines are lines without thickness, in one direction."""
    if a.corner_count > 2 or b.corner_count > 2 or a.radius + b.radius > 0.0:
        return False
    c, e = corners[a.first_corner], corners[b.first_corner]
    return abs(c.nx * e.ny - c.ny * e.nx) <= TIE


def corners_impact_time(
    corners: Sequence[Corner],
    a: PlacedBody,
    b: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
) -> float:
    """Return the earliest impact of a corner of B on A, s; inf for none."""
    earliest = math.inf
    for k in range(b.first_corner, b.first_corner + b.corner_count):
        x, y = dx + corners[k].x, dy + corners[k].y
        time, _ = circle_outline_impact_time(corners, a, x, y, vx, vy, 0.0, 0.0, b.radius)
        earliest = min(earliest, time)
    return earliest


def is_grazing(
    corners: Sequence[Corner],
    a: PlacedBody,
    b: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
) -> bool:
    """Return whether two outlines that touch or overlap do not come nearer, but slide or part."""
    at = _pose(a, b, dx, dy)
    gap, nx, ny = separation_rows(corners, a, b, at)
    first = corners[a.first_corner]
    tie = TIE * (abs(dx) + abs(dy) + abs(first.x) + abs(first.y))
    motion = Motion(vx, vy, 0.0, 0.0, 0.0, 0.0)
    return not is_closing(corners, a, b, at, motion, gap, nx, ny, tie)


def _pose(a: PlacedBody, b: PlacedBody, dx: float, dy: float) -> RelativePose:
    """Return where two bodies that do not turn are."""
    return RelativePose(dx, dy, a.cos, a.sin, b.cos, b.sin)


def _turning_impact_time(
    shape_a: Shape,
    a: Moving,
    shape_b: Shape,
    b: Moving,
    corners: Sequence[Corner],
    duration: float,
) -> float:
    """Return the time of impact of two bodies of which one turns, or raise an error."""
    tolerance = TOLERANCE * (shape_a.bounding_radius + shape_b.bounding_radius)
    time, is_certain = advance(corners, a, b, duration, tolerance)
    if not is_certain:
        raise ValueError(
            f"duration must be shorter: {MOST_LOOKS} looks at shapes that turn past each other at "
            f"{a.w:g} and {b.w:g} rad/s lead no farther than {time:g} s, got {duration:g}"
        )
    return time


def _rows(
    which: str, shape: Shape, pose: Vector, velocity: Vector, corners: list[Corner]
) -> tuple[Placed, Moving]:
    """Return the rows of a shape at a pose, at rest and moving, or raise an error."""
    if not isinstance(shape, (Circle, Polygon, Segment)):
        raise TypeError(f"shape_{which} must be a Circle, Polygon or Segment, got {shape!r}")
    x, y, angle = _three(f"pose_{which}", pose, "(x, y, angle)")
    vx, vy, w = _three(f"velocity_{which}", velocity, "(vx, vy, w)")
    first, count = len(corners), len(shape.outline)
    placed = place(shape.outline, shape.rounding, (x, y, angle), corners)
    return placed, Moving(x, y, angle, vx, vy, w, shape.rounding, first, count)


def _three(name: str, value: Vector, meaning: str) -> tuple[float, float, float]:
    """Return three finite numbers, or raise a ValueError that names them."""
    numbers = np.asarray(finite(name, value), dtype=float)
    if numbers.shape != (3,):
        raise ValueError(f"{name} must be {meaning}, got shape {numbers.shape}")
    first, second, third = numbers.tolist()
    return first, second, third

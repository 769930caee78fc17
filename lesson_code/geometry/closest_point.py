"""Narrow phase of a ball against a wall: the point of a segment that is closest to the ball.

A wall is a capsule: all points within `half_thickness` of the segment from `start` to `end`, so
that it has two sides and two round ends. A half thickness of 0 makes it a line.

These are the doors for single questions; what stands behind them are lines of `edges` and
`circle_contact`, which the engine runs too.

========  ==========================================================  =====
symbol    meaning                                                     unit
========  ==========================================================  =====
p         the point, or the circle's centre                           m
a, b      start and end of the segment                                m
u         unit direction of the segment, (b - a) / |b - a|            -
s         how far along the segment the closest point lies            m
c         the closest point, a + s u                                  m
n         unit normal of the contact, from the wall to the ball       -
========  ==========================================================  =====
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.formulas.validation import (
    Number,
    Vector,
    non_negative,
    one_number,
    one_vector,
    positive,
)
from lesson_code.geometry.circle_contact import collide_outline_circle
from lesson_code.geometry.edges import closest_on_edge, direction
from lesson_code.geometry.rows import Corner, ManifoldRow, Placed, place


def closest_point_on_segment(point: Vector, start: Vector, end: Vector) -> Any:
    """Return the point of a segment that is closest to a given point.

    c = a + s u,   s = (p - a) . u, clamped to the segment: 0 <= s <= |b - a|

    Parameters
    ----------
    point : array_like, shape (2,)
        m.
    start, end : array_like, shape (2,)
        Ends of the segment, m; they must differ.

    Returns
    -------
    ndarray, shape (2,)
        The closest point, m. It is exactly `start` or `end` when an end is closest.

    Raises
    ------
    ValueError
        A component is not finite, a shape is not (2,), or the segment has no length.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 5.1.2.

    Examples
    --------
    >>> closest_point_on_segment(point=(1, 5), start=(0, 0), end=(4, 0))
    array([1., 0.])
    >>> closest_point_on_segment(point=(7, 5), start=(0, 0), end=(4, 0))
    array([4., 0.])
    """
    px, py = one_vector("point", point).tolist()
    (ax, ay), (bx, by) = (point.tolist() for point in segment_ends(start, end))
    _, ux, uy = direction(bx - ax, by - ay, 1.0, 0.0)
    return np.array(closest_on_edge(px, py, ax, ay, bx, by, ux, uy))


def circle_against_segment(
    centre: Vector, radius: Number, start: Vector, end: Vector, half_thickness: Number = 0.0
) -> tuple[Any, float] | None:
    """Return how a circle overlaps a wall: the contact normal and the penetration.

    n = (p - c) / |p - c|,   penetration = radius + half_thickness - |p - c|

    Both sides of the wall and its round ends push away from the closest point c. A centre that
    lies exactly on the segment has no such direction; it gets the segment's left normal, its
    direction turned by +90 degrees.

    Parameters
    ----------
    centre : array_like, shape (2,)
        Centre of the circle, m.
    radius : float
        m, > 0.
    start, end : array_like, shape (2,)
        Ends of the wall's middle line, m; they must differ.
    half_thickness : float
        Distance from the middle line to the wall's surface, m, >= 0.

    Returns
    -------
    (normal, penetration) or None
        The unit normal from the wall to the circle, an ndarray of shape (2,), and the
        penetration in m, > 0. None when the two do not overlap: touching is not overlapping.

    Raises
    ------
    ValueError
        As for :func:`closest_point_on_segment`; the radius is not > 0 or the half thickness is
        negative.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 4.5.1: a sphere against a capsule.

    Examples
    --------
    >>> circle_against_segment(centre=(1, 2), radius=2, start=(0, 0), end=(4, 0)) is None
    True
    >>> normal, penetration = circle_against_segment((1, -2), 2.5, (0, 0), (4, 0))
    >>> normal, float(penetration)
    (array([ 0., -1.]), 0.5)
    """
    px, py = one_vector("centre", centre).tolist()
    a, b = segment_ends(start, end)
    ball = Placed(px, py, radius=one_number("radius", radius, positive))
    thickness = one_number("half_thickness", half_thickness, non_negative)
    corners: list[Corner] = []
    wall = place([tuple(b.tolist()), tuple(a.tolist())], thickness, (0.0, 0.0, 0.0), corners)
    m = ManifoldRow()
    collide_outline_circle(corners, wall, ball, m)
    return (np.array([m.nx, m.ny]), m.penetration0) if m.count else None


def segment_ends(start: Vector, end: Vector) -> tuple[Any, Any]:
    """Return both ends of a segment as float arrays, or raise a ValueError if they coincide.

    >>> segment_ends((0, 0), (4, 0))
    (array([0., 0.]), array([4., 0.]))
    """
    a, b = one_vector("start", start), one_vector("end", end)
    if np.array_equal(a, b):
        raise ValueError(
            f"start and end must differ: a segment has a length > 0 m, got {a.tolist()} twice"
        )
    return a, b

"""One edge at a time: its direction, its outward normal, and its point closest to another.

The narrow phase runs these lines for every pair of bodies. They know plain numbers only, so they
are short to read and leave nothing that a compiler could not take.

========  ==========================================================  =====
symbol    meaning                                                     unit
========  ==========================================================  =====
p         a point                                                     m
a, b      start and end of the edge                                   m
u         unit direction of the edge, (b - a) / abs(b - a)            -
s         how far along the edge the closest point lies               m
c         the closest point, a + s u                                  m
========  ==========================================================  =====
"""

from __future__ import annotations

import math

SMALLEST_SQUARE, LARGEST_SQUARE = 1e-280, 1e280
"""m^2: between these a square keeps all its digits (floats end at 1e-308 and 1e308)."""


def direction(x: float, y: float, else_x: float, else_y: float) -> tuple[float, float, float]:
    """Return the length of a vector and its unit direction.

    A vector of no length has no direction; it is given the one of `else_x` and `else_y`.

    >>> direction(3.0, 4.0, 1.0, 0.0)
    (5.0, 0.6, 0.8)
    >>> direction(0.0, 0.0, 1.0, 0.0)
    (0.0, 1.0, 0.0)
    """
    square = x * x + y * y
    if SMALLEST_SQUARE < square < LARGEST_SQUARE:
        length = math.sqrt(square)
        return length, x / length, y / length
    size = max(abs(x), abs(y))
    if size == 0.0:
        return 0.0, else_x, else_y
    length = math.sqrt((x / size) * (x / size) + (y / size) * (y / size))
    return size * length, x / size / length, y / size / length


def outward_normal(ax: float, ay: float, bx: float, by: float) -> tuple[float, float]:
    """Return the unit normal of an edge that points out of a counter-clockwise outline.

    n = (u_y, -u_x): the edge's direction turned by -90 degrees, to its right.

    >>> outward_normal(0.0, 0.0, 2.0, 0.0)
    (0.0, -1.0)
    """
    _, ux, uy = direction(bx - ax, by - ay, 1.0, 0.0)
    return uy, 0.0 - ux  # and not -ux, which would make -0.0 of 0.0


def closest_on_edge(
    px: float, py: float, ax: float, ay: float, bx: float, by: float, ux: float, uy: float
) -> tuple[float, float]:
    """Return the point of an edge that is closest to a point; beyond an end it is that end.

    c = a + s u,   s = (p - a) . u, clamped to the edge: 0 <= s <= (b - a) . u

    >>> closest_on_edge(1.0, 5.0, 0.0, 0.0, 4.0, 0.0, 1.0, 0.0)
    (1.0, 0.0)
    >>> closest_on_edge(7.0, 5.0, 0.0, 0.0, 4.0, 0.0, 1.0, 0.0)
    (4.0, 0.0)
    """
    s = (px - ax) * ux + (py - ay) * uy
    if s <= 0.0:
        return ax, ay
    if s >= (bx - ax) * ux + (by - ay) * uy:
        return bx, by
    return ax + s * ux, ay + s * uy

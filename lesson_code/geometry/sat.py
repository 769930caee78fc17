"""The separating axis theorem: whether two convex outlines overlap, and the shortest way out.

Two convex shapes are apart exactly when a line fits between them, and if one does, then one
parallel to an edge does. So it is enough to look along the outward normal of every edge.

========  ================================================================  =====
symbol    meaning                                                           unit
========  ================================================================  =====
n         outward unit normal of an edge: the axis                          -
low       smallest p . n over the points p of a shape                       m
high      largest p . n                                                     m
overlap   how far B must move along n until A's interval is left behind     m
========  ================================================================  =====

An edge's normal says which way it pushes: out of its own shape. Of the two ways out along an axis
it stands for one. The way back is the business of the edges that look that way, and the
shortest way out of all is always along the outward normal of an edge, of A or of B. Thus depth
and direction are right when one shape is deep inside the other, and wherever the shapes'
origins lie.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from lesson_code.formulas.validation import Vector, one_vector, unit_vector, vector
from lesson_code.geometry.outline import convex_outline
from lesson_code.geometry.rows import Corner, Placed, PlacedBody, place

TIE = 1e-14
"""Of the lengths involved: overlaps this near each other are equal, but for rounding."""


def sat_axes(vertices: Vector) -> Any:
    """Return the axes to test for a convex polygon: the outward unit normals of its edges.

    n = (u_y, -u_x),   u the direction of an edge, counter-clockwise

    Parameters
    ----------
    vertices : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3.

    Returns
    -------
    ndarray, shape (K, 2)
        One normal an edge, counter-clockwise from the edge at the first vertex. K is less than N
        if vertices lie on the straight line between their neighbours.

    Raises
    ------
    ValueError
        The vertices are not those of a convex polygon: see :class:`Polygon`.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 5.2.1: separating-axis test.

    Examples
    --------
    >>> sat_axes([(0, 0), (2, 0), (2, 1), (0, 1)])
    array([[ 0., -1.], [ 1.,  0.], [ 0.,  1.], [-1.,  0.]])
    """
    corners: list[Corner] = []
    _place_outline("vertices", vertices, corners)
    return np.array([(corner.nx, corner.ny) for corner in corners])


def project(vertices: Vector, axis: Vector) -> tuple[float, float]:
    """Return the interval that points cover along an axis: their shadow on it.

    low = min p . n,   high = max p . n

    Parameters
    ----------
    vertices : array_like, shape (N, 2)
        m, N >= 1, in any order.
    axis : array_like, shape (2,)
        n, a unit vector.

    Returns
    -------
    (low, high) : tuple of float
        m, low <= high.

    Raises
    ------
    ValueError
        A number is not finite, a shape is wrong, or the axis is not unit.

    Examples
    --------
    >>> project([(0, 0), (2, 0), (2, 1), (0, 1)], axis=(0.6, 0.8))
    (0.0, 2.0)
    """
    points = vector("vertices", vertices)
    if points.ndim != 2 or len(points) == 0:
        raise ValueError(f"vertices must have shape (N, 2), N >= 1, got shape {points.shape}")
    nx, ny = unit_vector("axis", one_vector("axis", axis)).tolist()
    corners = [Corner(x=x, y=y) for x, y in points.tolist()]
    return project_corners(corners, Placed(corner_count=len(corners)), nx, ny)


def overlap(interval_a: Vector, interval_b: Vector) -> float | None:
    """Return how far two intervals of one axis overlap: the shorter of the two ways out.

    overlap = min(high_a - low_b, high_b - low_a)

    B leaves A upwards after high_a - low_b, downwards after high_b - low_a. Where one interval
    contains the other this is more than the part they share.

    Parameters
    ----------
    interval_a, interval_b : (low, high)
        m, low <= high.

    Returns
    -------
    float or None
        m, > 0. None when the intervals are apart or only touch.

    Raises
    ------
    ValueError
        A number is not finite, or an interval has its ends the wrong way round.

    Examples
    --------
    >>> overlap((0, 3), (2, 5))
    1.0
    >>> overlap((0, 10), (4, 5))
    5.0
    >>> overlap((0, 3), (3, 5)) is None
    True
    """
    low_a, high_a = _interval("interval_a", interval_a)
    low_b, high_b = _interval("interval_b", interval_b)
    shortest = min(exit_distance(high_a, low_b), exit_distance(high_b, low_a))
    return shortest if shortest > 0 else None


def mtv(vertices_a: Vector, vertices_b: Vector) -> tuple[Any, float] | None:
    """Return the minimum translation vector of two convex polygons: the shortest way apart.

    B moved by depth * n, or A by -depth * n, and they only touch.

    Parameters
    ----------
    vertices_a, vertices_b : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3; both in the same coordinates.

    Returns
    -------
    (normal, depth) or None
        Unit normal n from A to B, an ndarray of shape (2,), and the depth in m, > 0. None when
        they do not overlap: touching is not overlapping.

    Raises
    ------
    ValueError
        The vertices are not those of a convex polygon: see :class:`Polygon`.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 5.2.1.

    Examples
    --------
    >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    >>> normal, depth = mtv(square, [(3, 1), (6, 1), (6, 2), (3, 2)])
    >>> normal, depth
    (array([1., 0.]), 1.0)
    >>> mtv(square, [(4, 0), (6, 0), (6, 2)]) is None
    True
    """
    corners: list[Corner] = []
    a = _place_outline("vertices_a", vertices_a, corners)
    b = _place_outline("vertices_b", vertices_b, corners)
    depth, nx, ny, _, _ = minimum_translation(corners, a, b)
    return (np.array([nx, ny]), depth) if depth > 0 else None


def project_corners(
    corners: Sequence[Corner], body: PlacedBody, nx: float, ny: float
) -> tuple[float, float]:
    """Return low and high of a body's outline along n, m, seen from the body's position.

    A circle has no outline but its centre: (0, 0). Low and high are found apart, without `elif`:
    where only one is wanted, the compiler leaves out the other, and needs no branch.
    """
    if body.corner_count == 0:
        return 0.0, 0.0
    c = corners[body.first_corner]
    low = high = c.x * nx + c.y * ny
    for k in range(body.first_corner + 1, body.first_corner + body.corner_count):
        c = corners[k]
        along = c.x * nx + c.y * ny
        if along < low:
            low = along
        if along > high:
            high = along
    return low, high


def exit_distance(high_a: float, low_b: float) -> float:
    """Return how far B must move up an axis until A's interval is left behind, m."""
    return high_a - low_b


def least_overlap(corners: Sequence[Corner], a: PlacedBody, b: PlacedBody) -> tuple[float, int]:
    """Return the least overlap along the outward normals of A's edges, and that edge's index.

    It is the overlap of the outlines, without their rounding, in m; negative when they are
    apart. The search ends at the first gap that the rounding does not bridge. Along each axis
    A's edge is the zero, so that numbers are small where shapes nearly touch: A ends at 0.
    """
    dx, dy = b.x - a.x, b.y - a.y
    radius_sum = a.radius + b.radius
    least, edge = math.inf, -1
    for k in range(a.first_corner, a.first_corner + a.corner_count):
        c = corners[k]
        nx, ny = c.nx, c.ny
        low_b, _ = project_corners(corners, b, nx, ny)
        overlap = exit_distance(0.0, (dx - c.x) * nx + (dy - c.y) * ny + low_b)
        if overlap < least:
            least, edge = overlap, k
            if least + radius_sum <= 0.0:
                break
    return least, edge


def minimum_translation(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody
) -> tuple[float, float, float, int, bool]:
    """Return overlap, normal (two numbers, from A to B), its edge, and whether that is A's.

    The overlap is that of the outlines, in m; where it does not exceed minus the sum of both
    roundings, there is no contact and the rest means nothing. Faces of A and of B that are
    equally good (two boxes, one flat on the other) count as A's, so that rounding does not
    decide; the overlap may then be too large by TIE of the lengths involved.
    """
    overlap_a, edge_a = least_overlap(corners, a, b)
    if overlap_a + a.radius + b.radius <= 0.0:
        return overlap_a, 0.0, 0.0, edge_a, True
    overlap_b, edge_b = least_overlap(corners, b, a)
    face_a, face_b = corners[edge_a], corners[edge_b]
    if overlap_a <= overlap_b + TIE * lengths_involved(a, b, face_a, face_b):
        return overlap_a, face_a.nx, face_a.ny, edge_a, True
    return overlap_b, 0.0 - face_b.nx, 0.0 - face_b.ny, edge_b, False


def lengths_involved(a: PlacedBody, b: PlacedBody, corner_a: Corner, corner_b: Corner) -> float:
    """Return the sum of the lengths that go into an overlap: its rounding is in proportion, m."""
    between = abs(b.x - a.x) + abs(b.y - a.y)
    return between + abs(corner_a.x) + abs(corner_a.y) + abs(corner_b.x) + abs(corner_b.y)


def _place_outline(name: str, vertices: Vector, corners: list[Corner]) -> Placed:
    """Return the row of a polygon, its first corner as its position; append its corners."""
    outline = convex_outline(name, vertices)
    x0, y0 = outline[0]
    return place([(x - x0, y - y0) for x, y in outline], 0.0, (x0, y0, 0.0), corners)


def _interval(name: str, value: Vector) -> tuple[float, float]:
    """Return an interval as two floats, or raise a ValueError that names it."""
    low, high = one_vector(name, value).tolist()
    if low > high:
        raise ValueError(f"{name} must be (low, high) with low <= high, got ({low}, {high})")
    return low, high

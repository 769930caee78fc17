"""The door of every polygon: its corners must go once round a convex area.

The rules for what is no corner:

- A vertex that repeats its neighbour makes an edge of no length, which has no normal. It is
  refused, with its place in the list: usually the first vertex was written down again at the end.
- A vertex on the straight line between its neighbours is no corner. It is left out, so that
  no axis is tested twice and no feature exists twice.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from lesson_code.formulas.arithmetic import cross, dot
from lesson_code.formulas.rigid_body import polygon_area
from lesson_code.formulas.validation import Vector, polygon_vertices
from lesson_code.geometry.edges import closest_on_edge, direction

Point: TypeAlias = tuple[float, float]

STRAIGHT = 1e-4
"""Of the width: what is nearer to a straight line is taken to lie on it.

A side in two halves that are all but parallel touches a floor now with one, now with the other
half, and a tower of such bodies trembles until it falls. A regular polygon has corners so flat from
some 300 sides on. At 0.01 it would from 32.
"""

LAST_DIGITS = 1e-14
"""Of the largest coordinate: the same, as rounding makes it (45 times that of the coordinate)."""


def convex_outline(name: str, vertices: Vector) -> list[Point]:
    """Return the corners of a convex polygon counter-clockwise, beginning with the first.

    Parameters
    ----------
    name : str
        What the vertices are called in an error.
    vertices : array_like, shape (N, 2)
        In order, either way round, m; N >= 3.

    Returns
    -------
    list of (x, y)
        The corners, m, at least 3; vertices on a straight line, or as good as on it (``STRAIGHT``),
        are left out.

    Raises
    ------
    ValueError
        The shape is not (N, 2), a coordinate is not finite, all lie on one line, a vertex repeats
        its neighbour, or the outline is not convex or crosses itself.

    Examples
    --------
    >>> convex_outline("vertices", [(0, 0), (0, 1), (1, 1), (1, 0), (0.5, 0)])
    [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    """
    points = [(x, y) for x, y in polygon_vertices(name, vertices).tolist()]
    _refuse_repeats(name, points)
    corners = _corners(points)
    turns = [_turn(points, corners, k) for k in range(len(corners))]
    around = math.copysign(1.0, sum(turns))  # 1 counter-clockwise, -1 clockwise
    for corner, turn in zip(corners, turns, strict=True):
        if turn * around <= 0:
            raise ValueError(
                f"{name} must be convex: all corners must turn the same way, got "
                f"{points[corner]} at index {corner}, which turns the other way"
            )
    _refuse_crossing(name, abs(sum(turns)))
    if around < 0:
        corners = corners[:1] + corners[:0:-1]
    return [points[k] for k in corners]


def _refuse_repeats(name: str, points: list[Point]) -> None:
    """Raise a ValueError if a vertex is equal to the one before it."""
    for k, point in enumerate(points):
        if point == points[k - 1]:
            raise ValueError(
                f"{name} must not repeat a neighbour (an edge has a length > 0 m, also the one "
                f"back to the first vertex), got {point} at index {(k - 1) % len(points)} and {k}"
            )


def _corners(points: list[Point]) -> list[int]:
    """Return the indices of the vertices that are not on the line between their neighbours.

    All vertices that are left out lie on the line that stands for them.
    """
    size = max(max(abs(x), abs(y)) for x, y in points)
    tolerance = STRAIGHT * _width(points) + LAST_DIGITS * size
    kept, count = list(range(len(points))), len(points)
    for k in reversed(range(count)):
        before, after = kept[k - 1], kept[(k + 1) % len(kept)]
        between = [points[n % count] for n in range(before + 1, before + (after - before) % count)]
        line = points[before], points[after]
        if len(kept) > 3 and all(_distance(point, *line) <= tolerance for point in between):
            del kept[k]
    return kept


def _width(points: list[Point]) -> float:
    """Return the area over the larger extent, m: about the smallest width."""
    extent: float = max(max(along) - min(along) for along in zip(*points, strict=True))
    return polygon_area(points) / extent


def _distance(point: Point, start: Point, end: Point) -> float:
    """Return the distance from a point to the straight line between two others."""
    _, ux, uy = direction(end[0] - start[0], end[1] - start[1], 1.0, 0.0)
    return math.dist(point, closest_on_edge(*point, *start, *end, ux, uy))


def _turn(points: list[Point], corners: list[int], k: int) -> float:
    """Return the angle by which the outline turns at corner `k`, rad, counter-clockwise."""
    before, here, after = (points[corners[(k + i) % len(corners)]] for i in (-1, 0, 1))
    a = (here[0] - before[0], here[1] - before[1])
    b = (after[0] - here[0], after[1] - here[1])
    return math.atan2(cross(a, b), dot(a, b))


def _refuse_crossing(name: str, turned: float) -> None:
    """Raise a ValueError if the outline turned by more than one full circle (a pentagram)."""
    rounds = round(turned / (2 * math.pi))
    if rounds > 1:
        raise ValueError(f"{name} must go round once and not cross itself, got {rounds} times")

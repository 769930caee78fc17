"""Pairs of polygons, each for one thing that the separating axis test has to get right.

A pair is written down once and then turned, enlarged and moved at random, which changes none of
what it is for. In each that overlaps, the shortest way out is shorter than the next one by at
least a tenth of a metre, so that no two tie.
"""

from __future__ import annotations

import math
from random import Random
from typing import TypeAlias

from lesson_code.chapters.draws import Vector

Polygon: TypeAlias = tuple[Vector, ...]
Pair: TypeAlias = tuple[Polygon, Polygon]

_BASE: Polygon = ((-1.8, 0.8), (-2.0, -0.6), (2.0, -1.8), (2.4, 0.2))

CORNER_INSIDE: Pair = (_BASE, ((0.3, 0.0), (2.2, 1.2), (-0.3, 2.0)))
"""A corner of B is in A; the shortest way out is along the normal of the last edge of A."""

PARTED: Pair = (_BASE, ((0.3, 0.7), (2.2, 1.9), (-0.3, 2.7)))
"""Apart, and only an edge of A has the gap before it."""

NESTED: Pair = (
    ((-3.0, -2.0), (2.5, -2.4), (3.2, 0.5), (0.4, 2.6), (-2.8, 1.4)),
    ((1.2, -0.6), (2.2, -0.4), (1.5, 0.2)),
)
"""B is inside A, away from the middle."""

PAST_THE_MIDDLE: tuple[Pair, Pair] = (
    (
        ((1.7, 1.9), (-1.5, 1.4), (-1.7, 1.1), (-0.4, -0.9)),
        ((0.4, 0.3), (1.0, 0.7), (-2.3, 0.9), (-0.1, 0.3)),
    ),
    (((2.7, 1.0), (-2.4, 0.7), (-0.1, -0.3)), ((1.4, 1.1), (-1.6, 1.7), (1.7, -0.9))),
)
"""So deep that the middle of B lies on the far side of A's: the way out leads back past it. The
shortest way out is along the normal of a first edge: A's in the first pair, B's in the second."""


def swapped(pair: Pair) -> Pair:
    """Return a pair with A and B exchanged."""
    return pair[1], pair[0]


def placed(stream: Random, pair: Pair) -> Pair:
    """Return a pair turned, enlarged and moved, with its vertices to two decimals, m."""
    angle, size = stream.uniform(0, 2 * math.pi), stream.uniform(1.0, 1.6)
    turn = complex(size * math.cos(angle), size * math.sin(angle))
    shift = complex(stream.uniform(-5, 5), stream.uniform(-5, 5))
    a, b = (tuple(_seen(shift + turn * complex(*vertex)) for vertex in each) for each in pair)
    return a, b


def _seen(place: complex) -> Vector:
    """Return a complex number as a vector with two decimals."""
    return round(place.real, 2), round(place.imag, 2)


def square(x: float, y: float) -> Polygon:
    """Return a square of 2 m by 2 m with its lower left corner at (x, y)."""
    return (x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2)

"""The few operations that are shared: dot and cross product, perpendicular, clamp, whole parts.

A vector's two components come first, so that ``a[0]`` is every x and ``a[1]`` every y:
the same lines serve one vector of shape (2,) and a batch of shape (2, ...).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.formulas.validation import Number, Vector


def dot(a: Vector, b: Vector) -> Number:
    """Return the dot product a_x b_x + a_y b_y.

    >>> dot((3.0, 4.0), (0.0, 1.0))
    4.0
    """
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Vector, b: Vector) -> Number:
    """Return the cross product a_x b_y - a_y b_x: positive when b lies counter-clockwise of a.

    >>> cross((1.0, 0.0), (0.0, 2.0))
    2.0
    """
    return a[0] * b[1] - a[1] * b[0]


def perpendicular(a: Vector) -> Vector:
    """Return `a` turned by a right angle, counter-clockwise: (-a_y, a_x).

    >>> perpendicular(np.array([3.0, 4.0]))
    array([-4.,  3.])
    """
    return np.stack((-a[1], a[0]))


def clamp(value: Number, low: Number, high: Number) -> Any:
    """Return `value`, or the nearer end of [low, high] when it lies outside.

    >>> clamp(-3.0, -2.0, 2.0)
    -2.0
    """
    if isinstance(value, np.ndarray) or isinstance(high, np.ndarray):
        return np.clip(value, low, high)
    return min(max(value, low), high)


ROUNDING_OF_PARTS = 1e-9
"""Of a part: 30 parts may come out of a division as 29.999999999999996, and are 30 all the same."""


def whole_parts(total: float, part: float) -> int:
    """Return how many whole parts fit into a total: the steps in a duration, say.

    >>> whole_parts(1.0, 1 / 60), whole_parts(0.11, 1 / 60)
    (60, 6)
    """
    return math.floor(total / part + ROUNDING_OF_PARTS)

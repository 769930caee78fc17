"""Random convex polygons, for asking two methods the same question many times."""

from __future__ import annotations

from typing import Any

import numpy as np

NEAREST = 0.05
"""rad between neighbouring corners, seen from the middle of the ellipse they lie on."""


def random_polygon(rng: np.random.Generator, reach: float = 0.0) -> Any:
    """Return the corners of a convex polygon, counter-clockwise, shape (N, 2), m.

    Three to eight corners lie at random angles on an ellipse, 2 m long, which is tilted at
    random. The middle of the ellipse is up to `reach` from the origin in x and in y, m.

    >>> random_polygon(np.random.default_rng(seed=1)).shape
    (5, 2)
    """
    turns = np.sort(rng.uniform(0, 2 * np.pi, rng.integers(3, 9)))
    while np.diff(turns, append=turns[0] + 2 * np.pi).min() < NEAREST:
        turns = np.sort(rng.uniform(0, 2 * np.pi, len(turns)))
    x, y = np.cos(turns), rng.uniform(0.3, 1) * np.sin(turns)
    tilt = rng.uniform(0, np.pi)
    cos, sin = np.cos(tilt), np.sin(tilt)
    middle = rng.uniform(-reach, reach, 2)
    return np.column_stack((cos * x - sin * y, sin * x + cos * y)) + middle

"""Random convex polygons: for asking two methods the same question many times, and for a pile."""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.geometry import Polygon, Segment

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


def trough(count: int, rng: np.random.Generator) -> Scene:
    """Return random polygons above each other, which fall into a trough of three walls."""
    rough = Material(restitution=0.1, friction=0.5)
    walls = [((-3, 0), (3, 0)), ((-2.2, 0), (-2.8, 6)), ((2.2, 0), (2.8, 6))]
    static = [Body(Segment(start, end, 0.1), material=rough) for start, end in walls]
    falling = [
        Body(
            Polygon(0.55 * random_polygon(rng)),
            position=(rng.uniform(-1.2, 1.2), 1 + 0.9 * n),
            angle=rng.uniform(0, 6),
            mass=1,
            material=rough,
        )
        for n in range(count)
    ]
    return Scene(static + falling, gravity=(0, -10))

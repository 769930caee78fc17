"""A body on a rough slope: it rolls, slides, stays or tips.

A slope is a floor on which gravity is tilted. So the floor is left level, and gravity is tilted:
x points down the slope, y away from it.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.formulas.validation import finite, one_number
from lesson_code.geometry.shapes import Circle, Polygon, Segment

GRAVITY = 9.81
"""m/s^2."""

HALF_LENGTH = 100.0
"""m: of the slope; far more than a body slides in some seconds."""

TIPPED = 0.2
"""rad: a box that has turned this far does not come back; one that stands turns by under 1e-3."""

STICKS = 2.0
"""A friction coefficient at which nothing slides on a slope below 63 degrees."""


def body_on_slope(
    shape: Circle | Polygon,
    degrees: float,
    friction: float,
    *,
    sunk: float = 0.0,
    mass: float = 1.0,
) -> Scene:
    """Return a slope, and a body at rest on it, which is body 1.

    Parameters
    ----------
    shape : Circle or Polygon
        It touches the slope with its lowest point or edge.
    degrees : float
        How steep the slope is, from the horizontal.
    friction : float
        Friction coefficient of body and slope, >= 0; the restitution is 0.
    sunk : float
        How deep the body stands in the slope, as a share of its height above it.
    mass : float
        Of the body, kg.
    """
    theta = math.radians(one_number("degrees", degrees, finite))
    lowest = -shape.radius if isinstance(shape, Circle) else min(y for _, y in shape.outline)
    surface = Material(restitution=0.0, friction=friction)
    body = Body(shape, position=(0.0, -lowest * (1 - sunk)), mass=mass, material=surface)
    slope = Body(Segment((-HALF_LENGTH, 0), (HALF_LENGTH, 0)))
    return Scene([slope, body], gravity=(GRAVITY * math.sin(theta), -GRAVITY * math.cos(theta)))

"""Free flight: whether any two bodies can meet.

Until the first impact every body flies freely, in a straight line or a parabola.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from lesson_code.engine.core.columns import Floats
from lesson_code.engine.core.scene import Scene


class Box(NamedTuple):
    """What a body and all of its way lie in, m."""

    min_x: float
    max_x: float
    min_y: float
    max_y: float
    is_static: bool


def can_meet(scene: Scene, duration: float, dt: float) -> bool:
    """Return whether two bodies, one of which can be pushed, can meet within a run.

    Until the first impact every body flies freely. So it is enough that the boxes around these
    flights stay apart. They are visited from left to right; two static ones are not compared.

    Parameters
    ----------
    scene : Scene
        Bodies, gravity, damping.
    duration : float
        s; ``math.inf``: unknown.
    dt : float
        s, the time step: between two steps positions lag behind the parabola by up to g t dt / 2.

    Examples
    --------
    >>> from lesson_code import Body, Circle
    >>> ball = Body(Circle(1), mass=1.0, velocity=(1, 0))
    >>> wall = Body(Circle(1), position=(9, 0))
    >>> [can_meet(Scene([ball, wall]), duration, dt=0.01) for duration in (5.0, 8.0)]
    [False, True]
    """
    if not scene.columns.is_free.any() or len(scene.bodies) < 2:
        return False
    if math.isinf(duration):
        return True
    free: list[Box] = []
    static: list[Box] = []
    for box in _boxes_of_ways(scene, duration + dt):
        free = [other for other in free if other.max_x >= box.min_x]
        if any(_share_y(box, other) for other in free):
            return True
        if box.is_static:
            static.append(box)
            continue
        static = [other for other in static if other.max_x >= box.min_x]
        if any(_share_y(box, other) for other in static):
            return True
        free.append(box)
    return False


def _boxes_of_ways(scene: Scene, time: float) -> Iterator[Box]:
    """Yield a box around each body's flight, m, from left to right."""
    c = scene.columns
    with np.errstate(over="ignore", invalid="ignore"):
        low, high = _spans(
            np.array([c.x, c.y]),
            np.array([c.vx, c.vy]),
            np.outer(scene.gravity, c.is_free),
            time,
            is_damped=scene.damping > 0.0,
        )
        low, high = low - c.bounding_radius, high + c.bounding_radius
    order = np.argsort(low[0], kind="stable")
    sides = [low[0], high[0], low[1], high[1], ~c.is_free]
    return map(Box._make, zip(*(side[order].tolist() for side in sides), strict=True))


def _spans(
    start: Floats, speed: Floats, gain: Floats, time: float, *, is_damped: bool
) -> tuple[Floats, Floats]:
    """Return the least and the largest of start + speed t + gain t^2 / 2, m; wider if damped."""
    if is_damped:
        way = abs(speed) * time + 0.5 * abs(gain) * time * time
        return start - way, start + way
    end = start + speed * time + 0.5 * gain * time * time
    low, high = np.minimum(start, end), np.maximum(start, end)
    if gain.any():
        turning = np.divide(-speed, gain, out=np.zeros_like(speed), where=gain != 0.0)
        turning[(turning < 0.0) | (turning > time)] = 0.0
        middle = start + speed * turning + 0.5 * gain * turning * turning
        low, high = np.minimum(low, middle), np.maximum(high, middle)
    return low, high


def _share_y(a: Box, b: Box) -> bool:
    """Return whether two boxes overlap along y."""
    return a.min_y <= b.max_y and b.min_y <= a.max_y

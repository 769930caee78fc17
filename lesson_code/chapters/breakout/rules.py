"""The rules of Breakout: the paddle's angle, and a ball that no brick lets through."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from lesson_code.formulas import reflect
from lesson_code.formulas.validation import Vector
from lesson_code.geometry import Circle, Polygon, time_of_impact

Point = tuple[float, float]
Box = Sequence[float]
"""x and y of its lower left corner, width and height, m."""

STEEPEST = math.radians(60)
"""From the vertical: how far the paddle's ends turn a ball aside."""

MOST_HITS = 100
"""In one call; a ball between two bricks could go on for ever."""


def paddle_bounce(offset: float, speed: float) -> Point:
    """Return the velocity of a ball that leaves the paddle, m/s.

    The angle from the vertical is offset times :data:`STEEPEST`, however the ball has come.

    Parameters
    ----------
    offset : float
        Where it hits: -1 at the left end, 0 in the middle, 1 at the right end; what lies beyond
        counts as the end.
    speed : float
        m/s, which the ball keeps.

    Examples
    --------
    >>> paddle_bounce(0.0, 5.0)
    (0.0, 5.0)
    """
    angle = min(max(offset, -1.0), 1.0) * STEEPEST
    return speed * math.sin(angle), speed * math.cos(angle)


def brick_impact(
    position: Vector, velocity: Vector, radius: float, box: Box
) -> tuple[float, Point] | None:
    """Return when a ball first touches a brick within 1 s, and the normal there.

    Parameters
    ----------
    position, velocity : array_like, shape (2,)
        Of the ball's centre, outside of the brick, m and m/s.
    radius : float
        m.
    box : (x, y, width, height)
        The brick: its lower left corner and its size, m.

    Returns
    -------
    (time, normal) or None
        s, and the unit normal from the brick to the ball. None: it does not come to that.

    Examples
    --------
    >>> brick_impact((0.5, 0.0), (0.0, 4.0), 0.5, (0.0, 2.5, 1.0, 1.0))
    (0.5, (0.0, -1.0))
    """
    x, y, width, height = (float(value) for value in box)
    disc, brick = Circle(radius), Polygon.box(width, height)
    px, py = float(position[0]), float(position[1])
    vx, vy = float(velocity[0]), float(velocity[1])
    middle = x + width / 2, y + height / 2
    time = time_of_impact(disc, (px, py, 0), (vx, vy, 0), brick, (*middle, 0), (0, 0, 0), 1.0)
    if time is None:
        return None
    px, py = px + vx * time, py + vy * time
    nearest = min(max(px, x), x + width), min(max(py, y), y + height)
    nx, ny = px - nearest[0], py - nearest[1]
    length = math.hypot(nx, ny)
    return time, (nx / length, ny / length)


def fly(
    position: Vector, velocity: Vector, radius: float, bricks: Sequence[Box], duration: float
) -> tuple[Point, Point, list[int]]:
    """Return a ball after a flight among bricks: each that it meets turns it and breaks.

    Parameters
    ----------
    position, velocity : array_like, shape (2,)
        m and m/s.
    radius : float
        m.
    bricks : sequence of (x, y, width, height)
        m.
    duration : float
        s, at most 1.

    Returns
    -------
    (position, velocity, broken)
        m, m/s, and the places in `bricks` of those that broke, in order.

    Examples
    --------
    >>> fly((0.5, 0.0), (0.0, 4.0), 0.5, [(0.0, 2.5, 1.0, 1.0)], 1.0)
    ((0.5, 0.0), (0.0, -4.0), [0])
    """
    p, v = np.array(position, dtype=float), np.array(velocity, dtype=float)
    left, broken = float(duration), list[int]()
    for _ in range(MOST_HITS):
        hits = {
            k: hit
            for k, brick in enumerate(bricks)
            if k not in broken and (hit := brick_impact(p, v, radius, brick)) is not None
        }
        first = min(hits, key=lambda k: hits[k][0], default=None)
        if first is None or hits[first][0] > left:
            break
        time, normal = hits[first]
        p, left = p + v * time, left - time
        v = np.asarray(reflect(v, normal))
        broken.append(first)
    p = p + v * left
    return (float(p[0]), float(p[1])), (float(v[0]), float(v[1])), broken

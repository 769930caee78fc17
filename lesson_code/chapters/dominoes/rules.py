"""The rules of dominoes: when one topples, what that takes, and a row of thin ones."""

from __future__ import annotations

import math
from collections.abc import Sequence

GRAVITY = 9.81
"""m/s^2."""


def tipping_angle(width: float, height: float) -> float:
    """Return how far a domino can lean before it falls, rad: its centre is above its edge then.

    >>> round(math.degrees(tipping_angle(1.0, 1.0)), 9)
    45.0
    """
    return math.atan2(width, height)


def toppling_rate(width: float, height: float) -> float:
    """Return the least angular velocity at which a standing domino topples over its edge, rad/s.

    I w^2 / 2 = m g rise,   I = m (width^2 + height^2) / 3,   rise = (diagonal - height) / 2

    >>> round(toppling_rate(0.1, 0.6), 3)
    0.811
    """
    diagonal = math.hypot(width, height)
    rise = (diagonal - height) / 2
    return math.sqrt(6 * GRAVITY * rise) / diagonal


def chain(
    angles: Sequence[float],
    rates: Sequence[float],
    height: float,
    spacing: float,
    dt: float,
    steps: int,
) -> tuple[list[float], list[float]]:
    """Return angles and rates of a row of thin dominoes after some steps.

    Each turns about its foot: rate' = rate + 3 g / (2 height) sin(angle) dt, then
    angle' = angle + rate' dt. Then, from the first to the last but one: a domino that leans by
    more than asin(spacing / height) touches the next one; if it turns faster than that one, both
    go on with the mean of their rates. Nothing turns beyond 90 degrees: there the rate is 0.

    Parameters
    ----------
    angles, rates : sequence of float
        rad from upright and rad/s, towards the next domino.
    height, spacing : float
        m; the spacing is the smaller.
    dt : float
        s.
    steps : int
        How many.

    Examples
    --------
    >>> chain([0.0, 0.0], [1.0, 0.0], height=1.0, spacing=0.5, dt=0.1, steps=1)
    ([0.1, 0.0], [1.0, 0.0])
    """
    a, r = [float(angle) for angle in angles], [float(rate) for rate in rates]
    touch, pull = math.asin(spacing / height), 3 * GRAVITY / (2 * height)
    for _ in range(int(steps)):
        for k in range(len(a)):
            r[k] += pull * math.sin(a[k]) * dt
            a[k] += r[k] * dt
        for k in range(len(a) - 1):
            if a[k] > touch and r[k] > r[k + 1]:
                r[k] = r[k + 1] = (r[k] + r[k + 1]) / 2
        for k, angle in enumerate(a):
            if angle > math.pi / 2:
                a[k], r[k] = math.pi / 2, 0.0
    return a, r

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
    0.8
    """
    diagonal = math.hypot(width, height)
    rise = (diagonal - height) / 2
    return math.sqrt(6 * GRAVITY * rise) / diagonal


def chain_step(
    angles: Sequence[float], rates: Sequence[float], height: float, spacing: float, dt: float
) -> tuple[list[float], list[float]]:
    """Return angles and rates of a row of thin dominoes after one step.

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

    Examples
    --------
    >>> chain_step([0.0, 0.0], [1.0, 0.0], height=1.0, spacing=0.5, dt=0.1)
    ([0.1, 0.0], [1.0, 0.0])
    """
    touch = math.asin(spacing / height)
    pull = 3 * GRAVITY / (2 * height)
    turned = [r + pull * math.sin(a) * dt for a, r in zip(angles, rates, strict=True)]
    leaning = [float(a) + r * dt for a, r in zip(angles, turned, strict=True)]
    for k in range(len(leaning) - 1):
        if leaning[k] > touch and turned[k] > turned[k + 1]:
            turned[k] = turned[k + 1] = (turned[k] + turned[k + 1]) / 2
    for k, angle in enumerate(leaning):
        if angle > math.pi / 2:
            leaning[k], turned[k] = math.pi / 2, 0.0
    return leaning, [float(rate) for rate in turned]

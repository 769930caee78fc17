"""The rules of Newton's cradle: swaps along a row, and a ball on a string."""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.formulas import collide_1d

STRING = 3.0
"""m, from the pivot to the ball's centre."""

GRAVITY = 9.81
"""m/s^2."""


def collide_row(
    masses: Sequence[float], velocities: Sequence[float], restitution: float
) -> list[float]:
    """Return the velocities of a row of balls after all their collisions, from left to right.

    Neighbours that approach collide, the leftmost such pair first, until no pair approaches.

    Parameters
    ----------
    masses : sequence of float
        kg, > 0.
    velocities : sequence of float
        m/s, to the right.
    restitution : float
        Of each pair. With 1 it always ends; with less, pairs may go on without end, so that no
        more than 1,000 collisions are made.

    Examples
    --------
    >>> collide_row([1, 1, 1], [2.0, 0.0, 0.0], 1.0)
    [0.0, 0.0, 2.0]
    """
    v = [float(value) for value in velocities]
    for _ in range(1000):
        pair = next((k for k in range(len(v) - 1) if v[k] - v[k + 1] > 1e-12), None)
        if pair is None:
            break
        v[pair : pair + 2] = collide_1d(
            masses[pair], v[pair], masses[pair + 1], v[pair + 1], restitution
        )
    return [float(value) for value in v]


def swing_step(angle: float, rate: float, length: float, dt: float) -> tuple[float, float]:
    """Return angle and rate of a pendulum after a step, by semi-implicit Euler.

    rate' = rate - g/length sin(angle) dt,   angle' = angle + rate' dt

    >>> swing_step(0.0, 1.0, 2.0, 0.1)
    (0.1, 1.0)
    """
    rate = rate - GRAVITY / length * math.sin(angle) * dt
    return angle + rate * dt, rate


def cradle(
    angles: Sequence[float], rates: Sequence[float], length: float, dt: float, steps: int
) -> tuple[list[float], list[float]]:
    """Return angles and rates of a cradle of equal, elastic balls after some steps.

    The balls hang side by side and just touch at rest, so that two neighbours touch as soon as
    the left one's angle is the larger, or both are equal. In each step every ball swings, then
    neighbours that touch and approach swap their rates, the leftmost such pair first, until none
    does.

    Parameters
    ----------
    angles, rates : sequence of float
        rad and rad/s, from the left; positive to the right.
    length : float
        m.
    dt : float
        s.
    steps : int
        How many.

    Examples
    --------
    >>> cradle([0.0, 0.0], [1.0, 0.0], 9.81, 0.001, 1)[1]
    [0.0, 1.0]
    """
    a, r = [float(angle) for angle in angles], [float(rate) for rate in rates]
    for _ in range(int(steps)):
        for k in range(len(a)):
            a[k], r[k] = swing_step(a[k], r[k], length, dt)
        while (pair := _first_meeting(a, r)) is not None:
            r[pair], r[pair + 1] = r[pair + 1], r[pair]
    return a, r


def _first_meeting(angles: Sequence[float], rates: Sequence[float]) -> int | None:
    """Return the left ball of the first pair of neighbours that touch and approach."""
    for k in range(len(angles) - 1):
        if angles[k] >= angles[k + 1] and rates[k] > rates[k + 1]:
            return k
    return None

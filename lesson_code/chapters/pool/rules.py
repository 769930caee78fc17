"""The rules of pool: the rack, the cue's stroke, the cloth, and an impact of many balls at once."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any

import numpy as np

from lesson_code.formulas.validation import Vector

ROWS = 5
SQRT_3 = math.sqrt(3.0)

ROLLING, SPINNING = 0.01, 0.044
"""Coefficients of the cloth: for a ball that rolls, and for one that turns on the spot."""

GRAVITY = 9.81
"""m/s^2."""

ROUNDS = 20
"""Rounds in which an impact of many balls is shared out."""

TOUCHING = 2.001
"""Radii between the centres of two balls that touch, at most."""


def rack(apex: Vector, radius: float, gap: float) -> list[tuple[float, float]]:
    """Return the centres of 15 balls in a triangle, row by row from the apex, to the right, m.

    Neighbours are `gap` apart. In each row y grows.

    >>> [(round(x, 3), y) for x, y in rack((0.0, 0.0), 0.5, 0.0)[:3]]
    [(0.0, 0.0), (0.866, -0.5), (0.866, 0.5)]
    """
    step = 2 * radius + gap
    return [
        (float(apex[0] + row * step * SQRT_3 / 2), float(apex[1] + (place - row / 2) * step))
        for row in range(ROWS)
        for place in range(row + 1)
    ]


def strike(
    impulse: Vector, offset: float, mass: float, radius: float
) -> tuple[tuple[float, float], float]:
    """Return velocity and spin of a ball at rest that a cue strikes.

    v = J / m,   w = -offset |J| / I,   I = 2/5 m r^2

    Parameters
    ----------
    impulse : array_like, shape (2,)
        N s, the way the cue points.
    offset : float
        m: how far to the left of the centre the cue hits, seen along the cue.
    mass, radius : float
        kg, m.

    Examples
    --------
    >>> strike((0.4, 0.0), 0.25, 0.5, 1.0)
    ((0.8, 0.0), -0.5)
    """
    jx, jy = float(impulse[0]), float(impulse[1])
    inertia = 0.4 * mass * radius**2
    return (jx / mass, jy / mass), -offset * math.hypot(jx, jy) / inertia


def roll(
    velocity: Vector, spin: float, radius: float, dt: float
) -> tuple[tuple[float, float], float]:
    """Return velocity and spin after the cloth has acted for a time.

    The speed falls by ROLLING g dt, the rim's speed by 5/2 SPINNING g dt, each to 0 and no further.

    >>> roll((0.0, 2.0), 0.0, 0.03, 1.0)
    ((0.0, 1.9019), 0.0)
    """
    vx, vy = float(velocity[0]), float(velocity[1])
    speed = math.hypot(vx, vy)
    kept = max(speed - ROLLING * GRAVITY * dt, 0.0) / speed if speed > 0 else 0.0
    lost = 2.5 * SPINNING * GRAVITY * dt / radius
    return (vx * kept, vy * kept), math.copysign(max(abs(spin) - lost, 0.0), spin)


def share_impact(positions: Vector, velocities: Vector, radius: float, restitution: float) -> Any:
    """Return the velocities of equal balls after an impact in which many touch at once, (N, 2).

    In each of :data:`ROUNDS` rounds every touching pair that approaches gets the impulse that it
    alone would need, divided by how many such pairs the busier of its two balls is in. All
    impulses of a round come from the velocities at its beginning, so that no pair is before
    another: what is symmetric stays so. The momentum is kept, and the energy never grows.

    Parameters
    ----------
    positions, velocities : array_like, shape (N, 2)
        m and m/s. Balls touch whose centres are at most TOUCHING radii apart.
    radius : float
        m.
    restitution : float
        Of each pair.

    Examples
    --------
    >>> share_impact([(0, 0), (2, 0)], [(1, 0), (0, 0)], 1.0, 1.0).tolist()
    [[0.0, 0.0], [1.0, 0.0]]
    """
    p, v = np.asarray(positions, dtype=float), np.array(velocities, dtype=float)
    pairs = [
        (a, b)
        for a, b in combinations(range(len(p)), 2)
        if math.dist(p[a], p[b]) <= TOUCHING * radius
    ]
    if not pairs:
        return v
    a, b = np.array(pairs).T
    n = p[b] - p[a]
    n /= np.hypot(n[:, 0], n[:, 1])[:, None]
    for _ in range(ROUNDS):
        approach = ((v[a] - v[b]) * n).sum(axis=1)
        meets = approach > 0
        counts = np.bincount(np.concatenate([a[meets], b[meets]]), minlength=len(v))
        share = np.where(meets, approach, 0.0) / np.maximum(np.maximum(counts[a], counts[b]), 1)
        change = ((1 + restitution) / 2 * share)[:, None] * n
        np.subtract.at(v, a, change)
        np.add.at(v, b, change)
    return v

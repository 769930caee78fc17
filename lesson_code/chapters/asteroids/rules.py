"""The rules of the asteroid field: splitting, recoil, and a field whose edges are joined."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from lesson_code.formulas.validation import Vector


def split(velocity: Vector, masses: Sequence[float], speed: float, heading: float) -> Any:
    """Return the velocities of the pieces of an asteroid that bursts, shape (N, 2), m/s.

    The pieces fly apart at `speed` in directions that are spread evenly round the circle, the
    first at `heading`. Then the same velocity is taken from all, so that the momentum is kept.

    v_k = velocity + speed d_k - sum(m_i speed d_i) / sum(m_i)

    Parameters
    ----------
    velocity : array_like, shape (2,)
        Of the asteroid, m/s.
    masses : sequence of float
        Of the pieces, kg.
    speed, heading : float
        m/s, and rad from the x axis.

    Examples
    --------
    >>> split((1.0, 0.5), [1.0, 1.0], 2.0, 0.0).round(9).tolist()
    [[3.0, 0.5], [-1.0, 0.5]]
    """
    m = np.asarray(masses, dtype=float)
    turns = heading + 2 * math.pi * np.arange(len(m)) / len(m)
    apart = speed * np.column_stack([np.cos(turns), np.sin(turns)])
    return np.asarray(velocity, dtype=float) + apart - m @ apart / m.sum()


def fire(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> tuple[Any, Any]:
    """Return the velocities of ship and shot after a shot, m/s: the momentum is kept.

    The ship, which carried the shot, has `ship_mass` without it. Seen from the ship the shot
    leaves at `muzzle_speed`.

    Examples
    --------
    >>> ship, shot = fire((0.0, 0.0), 3.0, 1.0, 8.0, 0.0)
    >>> ship.tolist(), shot.tolist()
    ([-2.0, 0.0], [6.0, 0.0])
    """
    v = np.asarray(velocity, dtype=float)
    relative = muzzle_speed * np.array([math.cos(heading), math.sin(heading)])
    ship = v - shot_mass / (ship_mass + shot_mass) * relative
    return ship, ship + relative


def wrap(position: Vector, size: Vector, reach: float) -> tuple[float, float]:
    """Return where a body is that has left a field: just outside of the opposite edge.

    One that can still be seen, and so reaches less than `reach` beyond an edge, stays where it is.

    >>> wrap((8.6, 3.0), (8.0, 6.0), 0.5), wrap((8.4, 3.0), (8.0, 6.0), 0.5)
    ((-0.5, 3.0), (8.4, 3.0))
    """
    x, y = (_wrapped(float(p), float(s), reach) for p, s in zip(position, size, strict=True))
    return x, y


def _wrapped(place: float, size: float, reach: float) -> float:
    """Return one coordinate of a body after it has left, or as it is."""
    if place > size + reach:
        return -reach
    return size + reach if place < -reach else place


def collide_all(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Return the velocities after every overlapping pair that approaches has collided, m/s.

    Pairs come in the order (0, 1), (0, 2), ..., (1, 2), ...; each finds the velocities that the
    ones before have left. The impulse j = (1 + e) v_n / (1/m_a + 1/m_b) acts along the line of
    centres. A pair at one and the same place is left alone.

    Examples
    --------
    >>> collide_all([(0, 0), (1.5, 0)], [(2, 0), (0, 0)], [1, 1], [1, 1], 1.0).tolist()
    [[0.0, 0.0], [2.0, 0.0]]
    """
    p, v = np.asarray(positions, dtype=float), np.array(velocities, dtype=float)
    m, r = np.asarray(masses, dtype=float), np.asarray(radii, dtype=float)
    for a in range(len(m)):
        for b in range(a + 1, len(m)):
            offset = p[b] - p[a]
            distance = math.hypot(offset[0], offset[1])
            if 0 < distance < r[a] + r[b]:
                normal = offset / distance
                approach = float((v[a] - v[b]) @ normal)
                if approach > 0:
                    impulse = (1 + restitution) * approach / (1 / m[a] + 1 / m[b])
                    v[a] -= impulse / m[a] * normal
                    v[b] += impulse / m[b] * normal
    return v

"""The rules of soft bodies: springs with damping, an area, and the pressure that keeps it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.formulas.validation import Vector


def ring_area(positions: Vector) -> float:
    """Return the area inside a ring of points, m^2; positive counter-clockwise.

    area = 1/2 sum(x_k y_{k+1} - x_{k+1} y_k)

    Parameters
    ----------
    positions : array_like, shape (N, 2)
        m.

    Examples
    --------
    >>> ring_area([(0, 0), (2, 0), (2, 3), (0, 3)])
    6.0
    """
    p = np.asarray(positions, dtype=float)
    following = _following(p)
    return float((p[:, 0] * following[:, 1] - following[:, 0] * p[:, 1]).sum() / 2)


def _following(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return what the next mass of a ring has, for each of its masses."""
    return np.concatenate([values[1:], values[:1]])


def _preceding(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return what the mass before it has, for each mass of a ring."""
    return np.concatenate([values[-1:], values[:-1]])


def ring_forces(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """Return the forces of damped springs from each mass of a ring to the next, N, (N, 2).

    Along u, the direction from a mass to the next, a spring pulls the mass by

    F = stiffness (distance - length) + damping (v_next - v) . u

    and the next one by the opposite.

    Parameters
    ----------
    positions, velocities : array_like, shape (N, 2)
        m and m/s.
    length : float
        m, of each spring at rest.
    stiffness, damping : float
        N/m and N s/m.

    Examples
    --------
    >>> ring_forces([(0, 0), (3, 0), (3, 3), (0, 3)], [(0, 0)] * 4, 2.0, 5.0, 0.0)[0].tolist()
    [5.0, 5.0]
    """
    p, v = np.asarray(positions, dtype=float), np.asarray(velocities, dtype=float)
    along = _following(p) - p
    distance = np.hypot(along[:, 0], along[:, 1])
    u = along / np.where(distance > 0, distance, 1.0)[:, None]
    faster = ((_following(v) - v) * u).sum(axis=1)
    pull = (stiffness * (distance - length) + damping * faster)[:, None] * u
    return pull - _preceding(pull)


def pressure_forces(positions: Vector, area: float, stiffness: float) -> Any:
    """Return the forces of a gas inside a ring of points, N, shape (N, 2).

    The pressure is stiffness (area / ring_area - 1), and less than 0 where the ring is too large.
    Each edge is pushed outward by pressure times its length, half of it at each end. The ring is
    counter-clockwise.

    Parameters
    ----------
    positions : array_like, shape (N, 2)
        m.
    area : float
        m^2, at rest.
    stiffness : float
        N/m: the pressure that would halve the area.

    Examples
    --------
    >>> pressure_forces([(0, 0), (1, 0), (1, 1), (0, 1)], 2.0, 4.0).tolist()
    [[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]]
    """
    p = np.asarray(positions, dtype=float)
    pressure = stiffness * (area / ring_area(p) - 1)
    edges = _following(p) - p
    push = pressure * np.column_stack([edges[:, 1], -edges[:, 0]]) / 2
    return push + _preceding(push)


@dataclass(frozen=True)
class Blob:
    """The soft body of the exercise: a ring on a floor at y = 0."""

    mass: float = 0.1  # kg, of each of its masses
    stiffness: float = 300.0  # N/m
    damping: float = 10.0  # N s/m
    pressure: float = 800.0  # N/m
    grip: float = 0.98  # of the velocity along the floor: what a step leaves to a mass on it
    air: float = 1.5  # 1/s, what the air takes of every velocity
    gravity: float = 9.81  # m/s^2
    dt: float = 1 / 600  # s


BLOB = Blob()


def drop(positions: Vector, velocities: Vector, length: float, area: float, steps: int) -> Any:
    """Return positions and velocities of a ring above a floor after some steps.

    In each step: forces F of springs and pressure at the positions as they are; then
    v' = v + (F / m - air v + g) dt, x' = x + v' dt. A mass below the floor is put onto it; its vy
    is no longer negative, and its vx is reduced to `grip` of it.

    Parameters
    ----------
    positions, velocities : array_like, shape (N, 2)
        m and m/s; counter-clockwise.
    length, area : float
        m and m^2, at rest.
    steps : int
        How many.

    Examples
    --------
    >>> ring = [(1, 5), (0, 6), (-1, 5), (0, 4)]
    >>> positions, velocities = drop(ring, [(0, 0)] * 4, 2**0.5, 2.0, 1)
    >>> velocities[:, 1].round(5).tolist()
    [-0.01635, -0.01635, -0.01635, -0.01635]
    """
    p, v = np.array(positions, dtype=float), np.array(velocities, dtype=float)
    for _ in range(int(steps)):
        forces = ring_forces(p, v, length, BLOB.stiffness, BLOB.damping)
        forces = forces + pressure_forces(p, area, BLOB.pressure)
        v = v + (forces / BLOB.mass - BLOB.air * v + (0.0, -BLOB.gravity)) * BLOB.dt
        p = p + v * BLOB.dt
        below = p[:, 1] < 0
        p[below, 1] = 0.0
        v[below, 1] = np.maximum(v[below, 1], 0.0)
        v[below, 0] *= BLOB.grip
    return p, v

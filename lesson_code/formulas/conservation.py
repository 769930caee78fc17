"""What a collision may not change, summed over all bodies: momentum, angular momentum, energy.

Masses have shape (N,), positions and velocities (N, 2), for N bodies; with a leading axis for
time, (F, N, 2), every frame is summed for itself. One body may be given as a number and a
vector of shape (2,).

A body of infinite mass must be at rest; it is the ground the others move on, and adds nothing.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.formulas.arithmetic import cross
from lesson_code.formulas.validation import Number, Vector, finite, mass, non_negative, vector


def momentum(masses: Number, velocities: Vector) -> Any:
    """Return the momentum of all bodies together.

    p = sum of m v

    Parameters
    ----------
    masses : array_like, shape (N,)
        kg, > 0; ``math.inf`` for a body at rest that cannot be moved.
    velocities : array_like, shape (..., N, 2)
        m/s.

    Returns
    -------
    ndarray, shape (..., 2)
        Momentum, kg m/s.

    Raises
    ------
    ValueError
        A mass is not > 0, a velocity is not finite, shapes do not fit, or a body of infinite
        mass moves.

    Examples
    --------
    >>> momentum(masses=[1, 2], velocities=[(3, 0), (0, -1)])
    array([ 3., -2.])
    """
    m, v = _bodies(masses, velocities)
    return (m[..., np.newaxis] * v).sum(axis=-2)


def kinetic_energy(
    masses: Number, velocities: Vector, inertias: Number = 0.0, angular_velocities: Number = 0.0
) -> Any:
    """Return the kinetic energy of all bodies together, spin included.

    E = sum of 1/2 m v^2 + 1/2 I w^2

    Parameters
    ----------
    masses : array_like, shape (N,)
        kg, > 0; ``math.inf`` for a body at rest that cannot be moved.
    velocities : array_like, shape (..., N, 2)
        m/s.
    inertias : array_like, shape (N,)
        Moments of inertia about each body's centre of mass, kg m^2, >= 0.
    angular_velocities : array_like, shape (..., N)
        rad/s, counter-clockwise.

    Returns
    -------
    float or ndarray, shape (...)
        Energy, J.

    Raises
    ------
    ValueError
        As for :func:`momentum`; an inertia is negative or an angular velocity not finite.

    Examples
    --------
    >>> float(kinetic_energy(masses=[2], velocities=[(3, 0)]))
    9.0
    """
    m, v = _bodies(masses, velocities)
    inertia, w = _spins(inertias, angular_velocities, v)
    return (m * np.square(v).sum(axis=-1) / 2 + inertia * np.square(w) / 2).sum(axis=-1)


def angular_momentum(
    masses: Number,
    positions: Vector,
    velocities: Vector,
    inertias: Number = 0.0,
    angular_velocities: Number = 0.0,
    about: Vector = (0.0, 0.0),
) -> Any:
    """Return the angular momentum of all bodies together about a fixed point.

    L = sum of m (r x v) + I w,   r = position - about

    Parameters
    ----------
    masses : array_like, shape (N,)
        kg, > 0; ``math.inf`` for a body at rest that cannot be moved.
    positions, velocities : array_like, shape (..., N, 2)
        m and m/s.
    inertias : array_like, shape (N,)
        Moments of inertia about each body's centre of mass, kg m^2, >= 0.
    angular_velocities : array_like, shape (..., N)
        rad/s, counter-clockwise.
    about : array_like, shape (2,)
        The fixed point, m.

    Returns
    -------
    float or ndarray, shape (...)
        Angular momentum, kg m^2/s, counter-clockwise.

    Raises
    ------
    ValueError
        As for :func:`kinetic_energy`; a position is not finite.

    Examples
    --------
    >>> float(angular_momentum(masses=[2], positions=[(3, 0)], velocities=[(0, 1)]))
    6.0
    """
    m, v = _bodies(masses, velocities)
    inertia, w = _spins(inertias, angular_velocities, v)
    centre = _fitted("about", vector("about", about), (2,))
    r = _fitted("positions", vector("positions", positions), v.shape) - centre
    orbit = m * cross(np.moveaxis(r, -1, 0), np.moveaxis(v, -1, 0))
    return (orbit + inertia * w).sum(axis=-1)


def _bodies(masses: Number, velocities: Vector) -> tuple[Any, Any]:
    """Return checked masses (..., N), 0 for immovable ones, and velocities (..., N, 2)."""
    v = np.atleast_2d(vector("velocities", velocities))
    m = _fitted("masses", mass("masses", masses), v.shape[:-1])
    immovable = np.isinf(m)
    if np.any(immovable[..., np.newaxis] & (v != 0)):
        raise ValueError("masses must be finite for bodies that move, got inf")
    return np.where(immovable, 0.0, m), v


def _spins(inertias: Number, angular_velocities: Number, v: Any) -> tuple[Any, Any]:
    """Return checked inertias and angular velocities (..., N), one for each velocity."""
    return (
        _fitted("inertias", non_negative("inertias", inertias), v.shape[:-1]),
        _fitted(
            "angular_velocities", finite("angular_velocities", angular_velocities), v.shape[:-1]
        ),
    )


def _fitted(name: str, values: Any, shape: tuple[int, ...]) -> Any:
    """Return numbers as floats of `shape`, which bodies and frames have set."""
    array = np.asarray(values, dtype=float)
    try:
        return np.broadcast_to(array, shape)
    except ValueError:
        raise ValueError(
            f"{name} must have shape {shape} or broadcast to it, got shape {array.shape}"
        ) from None

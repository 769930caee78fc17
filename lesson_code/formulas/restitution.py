"""Restitution: how much of the approach comes back, and what that costs in energy.

The restitution e of a collision is a ratio of speeds, measured along the line of impact:

    e = (v2' - v1') / (v1 - v2)          speed of separation over speed of approach

Only the energy of the relative motion can be lost; the centre of mass keeps its own:

    energy lost = 1/2 m_r (1 - e^2) (v1 - v2)^2,     1/m_r = 1/m1 + 1/m2
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.formulas.validation import (
    Number,
    equation,
    finite,
    formula,
    mass,
    not_both_immovable,
    unit_interval,
)


def _approaching(values: dict[str, Any]) -> None:
    """Refuse equal velocities before: bodies that do not approach have no restitution."""
    equal = np.asarray(np.equal(values["v1"], values["v2"]))
    if equal.any():
        both = np.broadcast_to(values["v1"], equal.shape)[equal][0]
        raise ValueError(
            f"v1 and v2 must differ: bodies at rest to each other do not collide, got {both} twice"
        )


@formula(together=_approaching, v1=finite, v2=finite, v1_after=finite, v2_after=finite)
def restitution_1d(v1: Number, v2: Number, v1_after: Number, v2_after: Number) -> Number:
    """Return the restitution that a collision on a line has shown.

    e = (v2' - v1') / (v1 - v2)

    Parameters
    ----------
    v1, v2 : float or array
        Velocities before, m/s; they must differ.
    v1_after, v2_after : float or array
        Velocities after, m/s.

    Returns
    -------
    float or array
        The ratio of separation to approach. Nothing is clipped: a value outside [0, 1] says
        that the velocities given belong to no passive collision.

    Raises
    ------
    ValueError
        A velocity is not finite, or v1 = v2.

    References
    ----------
    Newton, Principia (1687), scholium to the laws of motion: the ratio of the relative
    velocities of two given balls after and before they meet is constant.

    Examples
    --------
    >>> restitution_1d(v1=3, v2=-1, v1_after=-1, v2_after=1)
    0.5
    """
    return (v2_after - v1_after) / (v1 - v2)


@formula(together=not_both_immovable, m1=mass, m2=mass)
def reduced_mass(m1: Number, m2: Number) -> Number:
    """Return the reduced mass, m1 m2 / (m1 + m2): the inertia of the relative motion.

    It is the lighter mass, made lighter still by the other's yielding, and is computed so:
    light / (1 + light/heavy). Against an infinite mass it is exactly the other mass.

    Parameters
    ----------
    m1, m2 : float or array
        Masses, kg, > 0; one of a pair may be ``math.inf``.

    Returns
    -------
    float or array
        Reduced mass, kg.

    Raises
    ------
    ValueError
        A mass is not > 0, or both are infinite.

    Examples
    --------
    >>> from math import inf
    >>> float(reduced_mass(1, 3)), float(reduced_mass(2, inf))
    (0.75, 2.0)
    """
    light, heavy = np.minimum(m1, m2), np.maximum(m1, m2)
    return light / (1 + light / heavy)


@formula(
    together=not_both_immovable, m1=mass, v1=finite, m2=mass, v2=finite, restitution=unit_interval
)
def energy_lost_1d(m1: Number, v1: Number, m2: Number, v2: Number, restitution: Number) -> Number:
    """Return the kinetic energy that a collision on a line turns into heat.

    energy lost = 1/2 m_r (1 - e^2) (v1 - v2)^2

    Parameters
    ----------
    m1, m2 : float or array
        Masses, kg, > 0; one of a pair may be ``math.inf``.
    v1, v2 : float or array
        Velocities before, m/s.
    restitution : float or array
        0 to 1.

    Returns
    -------
    float or array
        Energy lost, J, >= 0.

    Raises
    ------
    ValueError
        As for :func:`lesson_code.formulas.collide_1d`.

    References
    ----------
    Goldstein, Poole and Safko, Classical Mechanics, 3rd ed., section 3.11.

    Examples
    --------
    >>> float(energy_lost_1d(m1=1, v1=2, m2=3, v2=-2, restitution=0.5))
    4.5
    """
    e, approach = restitution, v1 - v2
    return equation(reduced_mass)(m1, m2) * (1 - e) * (1 + e) * (approach * approach) / 2

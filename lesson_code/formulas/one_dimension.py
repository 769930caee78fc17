"""Collisions on a line: two bodies, one equation, three names.

The pair's centre of mass moves on with velocity V, whatever the bodies do to each other. Seen
from there each body's velocity is turned round and multiplied by the restitution e:

    V   = w1 v1 + w2 v2                   w1 = m1 / (m1 + m2),  w2 = m2 / (m1 + m2)
    v1' = V - e (v1 - V)                  v1 - V =  w2 (v1 - v2)
    v2' = V - e (v2 - V)                  v2 - V = -w1 (v1 - v2)

========  ===========================================  =====
symbol    meaning                                      unit
========  ===========================================  =====
m1, m2    masses; ``math.inf`` is an immovable body    kg
v1, v2    velocities before, positive to the right     m/s
v1', v2'  velocities after                             m/s
e         restitution: 1 elastic, 0 sticking           -
========  ===========================================  =====

Whether the two meet at all is not asked here: that needs their positions.
"""

from __future__ import annotations

from lesson_code.formulas.validation import (
    Number,
    equation,
    finite,
    formula,
    mass,
    not_both_immovable,
    unit_interval,
)


@formula(together=not_both_immovable, m1=mass, m2=mass)
def mass_fraction(m1: Number, m2: Number) -> Number:
    """Return the first body's part of the pair's mass: m1 / (m1 + m2).

    Written as 1 / (1 + m2/m1) it is exactly 1 or 0 when one mass is infinite, and cannot
    overflow.

    Parameters
    ----------
    m1, m2 : float or array
        Masses, kg, > 0; one of a pair may be ``math.inf``.

    Returns
    -------
    float or array
        The fraction, between 0 and 1.

    Raises
    ------
    ValueError
        A mass is not > 0, or both are infinite.

    Examples
    --------
    >>> from math import inf
    >>> mass_fraction(3, 1), mass_fraction(inf, 1), mass_fraction(1, inf)
    (0.75, 1.0, 0.0)
    """
    return 1 / (1 + m2 / m1)


@formula(
    together=not_both_immovable, m1=mass, v1=finite, m2=mass, v2=finite, restitution=unit_interval
)
def collide_1d(
    m1: Number, v1: Number, m2: Number, v2: Number, restitution: Number
) -> tuple[Number, Number]:
    """Return both velocities after a collision with restitution.

    v1' = V - e w2 (v1 - v2),  v2' = V + e w1 (v1 - v2),  V = w1 v1 + w2 v2

    Parameters
    ----------
    m1, m2 : float or array
        Masses, kg, > 0; one of a pair may be ``math.inf``.
    v1, v2 : float or array
        Velocities before, m/s.
    restitution : float or array
        Speed of separation over speed of approach, 0 to 1.

    Returns
    -------
    (v1', v2') : tuple of float or array
        Velocities after, m/s.

    Raises
    ------
    ValueError
        A mass is not > 0 or both are infinite, a velocity is not finite, or the restitution
        lies outside [0, 1].

    References
    ----------
    Goldstein, Poole and Safko, Classical Mechanics, 3rd ed., section 3.11: a collision seen
    from the centre of mass.

    Examples
    --------
    >>> collide_1d(m1=1, v1=2, m2=3, v2=-2, restitution=0.5)
    (-2.5, -0.5)
    """
    w1 = equation(mass_fraction)(m1, m2)
    w2 = equation(mass_fraction)(m2, m1)
    v_centre = w1 * v1 + w2 * v2
    v1_after = v_centre - restitution * w2 * (v1 - v2)
    v2_after = v_centre + restitution * w1 * (v1 - v2)
    return v1_after, v2_after


@formula(together=not_both_immovable, m1=mass, v1=finite, m2=mass, v2=finite)
def elastic_1d(m1: Number, v1: Number, m2: Number, v2: Number) -> tuple[Number, Number]:
    """Return both velocities after an elastic collision: restitution 1, no energy is lost.

    v1' = ((m1 - m2) v1 + 2 m2 v2) / (m1 + m2), and the same with 1 and 2 exchanged.

    Parameters, errors and source are those of :func:`collide_1d`.

    Examples
    --------
    Equal masses exchange their velocities; a wall sends a ball back.

    >>> from math import inf
    >>> elastic_1d(1, 3, 1, -1)
    (-1.0, 3.0)
    >>> elastic_1d(1, 3, inf, 0)
    (-3.0, 0.0)
    """
    return equation(collide_1d)(m1, v1, m2, v2, 1)


@formula(together=not_both_immovable, m1=mass, v1=finite, m2=mass, v2=finite)
def inelastic_1d(m1: Number, v1: Number, m2: Number, v2: Number) -> tuple[Number, Number]:
    """Return both velocities after a perfectly inelastic collision: the bodies stick together.

    v1' = v2' = (m1 v1 + m2 v2) / (m1 + m2), the velocity of the centre of mass.

    Parameters, errors and source are those of :func:`collide_1d`.

    Examples
    --------
    >>> inelastic_1d(1, 3, 3, -1)
    (0.0, 0.0)
    """
    return equation(collide_1d)(m1, v1, m2, v2, 0)

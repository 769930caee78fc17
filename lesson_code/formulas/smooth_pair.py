"""Two smooth bodies that meet: they push each other along the normal, and in no other direction.

    velocities   v1' = v1 - J / m1,    v2' = v2 + J / m2,    J = jn n
    positions    p1' = p1 - P / m1,    p2' = p2 + P / m2,    P = depth m_eff n

Whatever J and P are, the momentum and the centre of mass stay as they were, and the heavier
body changes less.

======  ===============================================================  =====
symbol  meaning                                                          unit
======  ===============================================================  =====
v, p    velocity and position of each body's centre of mass              m/s, m
n       unit normal, from body 1 to body 2                               -
m_eff   effective mass, 1 / (1/m1 + 1/m2)                                kg
J       impulse on body 2; body 1 receives -J                            N s
P       push on body 2, which undoes an overlap; body 1 receives -P      kg m
======  ===============================================================  =====
"""

from __future__ import annotations

from lesson_code.formulas.arithmetic import dot
from lesson_code.formulas.contact import effective_mass, normal_impulse
from lesson_code.formulas.validation import (
    Number,
    Vector,
    equation,
    formula,
    mass,
    non_negative,
    not_both_immovable,
    unit_interval,
    unit_vector,
    vector,
)


@formula(
    returns_vector=True,
    together=not_both_immovable,
    v1=vector,
    m1=mass,
    v2=vector,
    m2=mass,
    normal=unit_vector,
    restitution=unit_interval,
)
def smooth_impulse(
    v1: Vector, m1: Number, v2: Vector, m2: Number, normal: Vector, restitution: Number
) -> Vector:
    """Return the impulse that body 2 receives from body 1 where they touch.

    J = jn n,   jn = -(1 + e) vn m_eff if vn < 0, else 0,   vn = (v2 - v1) . n

    Parameters
    ----------
    v1, v2 : array_like, shape (..., 2)
        Velocities before, m/s, of bodies that do not spin, or of discs.
    m1, m2 : float or array
        Masses, kg, > 0; one of a pair may be ``math.inf``.
    normal : array_like, shape (..., 2)
        Unit normal from body 1 to body 2, length 1 within 1e-9.
    restitution : float or array
        0 to 1.

    Returns
    -------
    ndarray, shape (..., 2)
        Impulse on body 2, N s, along the normal; zero for bodies that already separate.

    Raises
    ------
    ValueError
        A component is not finite, a shape is not (..., 2), a mass is not > 0 or both are
        infinite, the normal is not unit or the restitution lies outside [0, 1].

    References
    ----------
    Mirtich and Canny, Impulse-based Simulation of Rigid Bodies (1995), section 3.

    Examples
    --------
    A ball of 1 kg runs into one of 3 kg; across the normal nothing happens.

    >>> smooth_impulse(v1=(4, 1), m1=1, v2=(0, 0), m2=3, normal=(1, 0), restitution=1)
    array([6., 0.])
    >>> smooth_impulse(v1=(4, 1), m1=1, v2=(5, 0), m2=3, normal=(1, 0), restitution=1)
    array([0., 0.])
    """
    vn = dot(v2 - v1, normal)
    m_eff = equation(effective_mass)(1 / m1, 1 / m2)
    return equation(normal_impulse)(vn, m_eff, restitution) * normal


@formula(
    returns_vector=True,
    together=not_both_immovable,
    m1=mass,
    m2=mass,
    normal=unit_vector,
    depth=non_negative,
)
def separating_push(m1: Number, m2: Number, normal: Vector, depth: Number) -> Vector:
    """Return the push that moves two bodies apart by a depth, the lighter one further.

    P = depth m_eff n: each body moves by P over its mass

    Parameters
    ----------
    m1, m2 : float or array
        Masses, kg, > 0; one of a pair may be ``math.inf``: it stays.
    normal : array_like, shape (..., 2)
        Unit normal from body 1 to body 2, length 1 within 1e-9.
    depth : float or array
        Of the overlap, m, >= 0.

    Returns
    -------
    ndarray, shape (..., 2)
        Push on body 2, kg m, along the normal.

    Raises
    ------
    ValueError
        A mass is not > 0 or both are infinite, the normal is not unit, or the depth is
        negative or not finite.

    Examples
    --------
    1 kg and 3 kg overlap by 0.4 m: they move by 0.3 m and 0.1 m.

    >>> push = separating_push(m1=1, m2=3, normal=(1, 0), depth=0.4)
    >>> (-push / 1).round(12), (push / 3).round(12)
    (array([-0.3, -0. ]), array([0.1, 0. ]))
    """
    return depth * equation(effective_mass)(1 / m1, 1 / m2) * normal

"""What one contact does: the impulse along its normal, and the friction along its tangent.

=============  ===========================================================  =============
symbol         meaning                                                      unit
=============  ===========================================================  =============
inv_m, inv_i   1 / mass and 1 / moment of inertia; 0 for what cannot yield  1/kg, 1/(kg m^2)
r_x_n          cross(r, n), r from the centre of mass to the contact:       m
               the lever arm of an impulse along n
vn, vt         relative velocity at the contact, along normal and tangent;  m/s
               vn < 0 is approach
m_eff          effective mass: impulse needed for a change of relative      kg
               velocity
jn, jt         normal and tangent impulse; jn >= 0, it can only push        N s
mu             friction coefficient                                         -
=============  ===========================================================  =============

One impact is one call. Several contacts that disturb each other need many calls, each of which
corrects the impulse that its contact has received so far; that is the argument `accumulated`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.formulas.arithmetic import clamp
from lesson_code.formulas.validation import (
    Number,
    finite,
    formula,
    non_negative,
    positive,
    unit_interval,
)


def _one_yields(values: dict[str, Any]) -> None:
    """Refuse two bodies of which neither can be moved at the contact."""
    by_moving = values["inv_m_a"] + values["inv_m_b"]
    by_turning = sum(abs(values[f"r{body}_x_n"]) * values[f"inv_i_{body}"] for body in "ab")
    if not np.all(by_moving + by_turning > 0):
        raise ValueError(
            "inv_m_a and inv_m_b must not both be 0 unless a body can turn: "
            "one of them has to yield, got 0"
        )


@formula(
    together=_one_yields,
    inv_m_a=non_negative,
    inv_m_b=non_negative,
    inv_i_a=non_negative,
    inv_i_b=non_negative,
    ra_x_n=finite,
    rb_x_n=finite,
)
def effective_mass(
    inv_m_a: Number,
    inv_m_b: Number,
    inv_i_a: Number = 0,
    inv_i_b: Number = 0,
    ra_x_n: Number = 0,
    rb_x_n: Number = 0,
) -> Number:
    """Return the mass that two bodies show at a contact, along one direction n.

    m_eff = 1 / (1/m_a + 1/m_b + (ra x n)^2 / I_a + (rb x n)^2 / I_b)

    An impulse of 1 N s between the bodies changes their relative velocity at the contact by
    1 / m_eff. A body yields by moving and by turning; the longer the lever arm, the more. With
    the tangent in place of n it is the effective mass for friction.

    Parameters
    ----------
    inv_m_a, inv_m_b : float or array
        Inverse masses, 1/kg, >= 0; 0 for a body that cannot be moved.
    inv_i_a, inv_i_b : float or array
        Inverse moments of inertia about the centres of mass, 1/(kg m^2), >= 0; 0 for a body
        that cannot turn.
    ra_x_n, rb_x_n : float or array
        Lever arms cross(r, n), m, r from each body's centre of mass to the contact. Their
        signs do not matter.

    Returns
    -------
    float or array
        Effective mass, kg, > 0.

    Raises
    ------
    ValueError
        An inverse is negative or not finite, a lever arm is not finite, or neither body can
        yield.

    References
    ----------
    Mirtich and Canny, Impulse-based Simulation of Rigid Bodies (1995), section 3; Catto,
    Iterative Dynamics with Temporal Coherence (2005).

    Examples
    --------
    Two free bodies of 2 kg show the reduced mass; hit off its centre, the first yields more.

    >>> effective_mass(inv_m_a=0.5, inv_m_b=0.5)
    1.0
    >>> effective_mass(inv_m_a=0.5, inv_m_b=0.5, inv_i_a=3.0, ra_x_n=1.0)
    0.25
    """
    by_moving = inv_m_a + inv_m_b
    by_turning = ra_x_n * ra_x_n * inv_i_a + rb_x_n * rb_x_n * inv_i_b
    return 1 / (by_moving + by_turning)


@formula(vn=finite, m_eff=positive, restitution=unit_interval, accumulated=non_negative)
def normal_impulse(
    vn: Number, m_eff: Number, restitution: Number, accumulated: Number = 0
) -> Number:
    """Return the impulse that stops the approach and returns the fraction e of its speed.

    jn = accumulated - (1 + e) vn m_eff, but no less than 0

    One impact has received nothing before: jn = -(1 + e) vn m_eff if vn < 0, else 0. A solver
    that visits its contacts again and again passes what it has already given; the total it
    gets back may be less than that, but never pulls. There, vn is the velocity that is still
    wrong: what it is now less what it should become, with a restitution of 0.

    Parameters
    ----------
    vn : float or array
        Relative velocity along the normal, m/s; negative means approaching.
    m_eff : float or array
        Effective mass along the normal, kg, > 0.
    restitution : float or array
        0 to 1.
    accumulated : float or array
        Normal impulse that this contact has already received, N s, >= 0.

    Returns
    -------
    float or array
        Normal impulse in total, N s, >= 0: bodies that part are left alone. What to apply now
        is this less `accumulated`.

    Raises
    ------
    ValueError
        vn is not finite, m_eff is not > 0, the restitution lies outside [0, 1] or the
        accumulated impulse is negative.

    References
    ----------
    Mirtich and Canny, Impulse-based Simulation of Rigid Bodies (1995), section 3: one impact.
    Catto, Fast and Simple Physics using Sequential Impulses (2006): clamping the total.

    Examples
    --------
    >>> normal_impulse(vn=-4.0, m_eff=0.5, restitution=0.5)
    3.0
    >>> normal_impulse(vn=4.0, m_eff=0.5, restitution=0.5)
    0.0

    A neighbour has since pushed the bodies apart at 2 m/s, so 3 N s were 1 N s too many:

    >>> normal_impulse(vn=2.0, m_eff=0.5, restitution=0.0, accumulated=3.0)
    2.0
    """
    return clamp(accumulated - (1 + restitution) * vn * m_eff, 0.0, math.inf)


@formula(
    vt=finite,
    m_eff_t=positive,
    friction=non_negative,
    normal_impulse=non_negative,
    accumulated=finite,
)
def friction_impulse(
    vt: Number, m_eff_t: Number, friction: Number, normal_impulse: Number, accumulated: Number = 0
) -> Number:
    """Return the impulse of dry friction: it stops the sliding, or fails at Coulomb's limit.

    jt = accumulated - vt m_eff_t, but no larger than mu jn either way

    One impact has received nothing before: accumulated = 0. A solver that visits its contacts
    again and again passes what it has already given, so that the limit holds for the total.

    Parameters
    ----------
    vt : float or array
        Relative velocity along the tangent, m/s.
    m_eff_t : float or array
        Effective mass along the tangent, kg, > 0.
    friction : float or array
        Friction coefficient mu, >= 0.
    normal_impulse : float or array
        jn in total, N s, >= 0.
    accumulated : float or array
        Tangent impulse that this contact has already received, N s.

    Returns
    -------
    float or array
        Tangent impulse in total, N s, against the sliding. What to apply now is this less
        `accumulated`.

    Raises
    ------
    ValueError
        vt or the accumulated impulse is not finite, m_eff_t is not > 0, or mu or jn is negative.

    References
    ----------
    Catto, Iterative Dynamics with Temporal Coherence (2005), section 4: the clamp. Catto, Fast
    and Simple Physics using Sequential Impulses (2006): clamping the total.

    Examples
    --------
    Strong friction stops the sliding; weak friction only slows it.

    >>> friction_impulse(vt=2.0, m_eff_t=1.0, friction=1.0, normal_impulse=3.0)
    -2.0
    >>> friction_impulse(vt=2.0, m_eff_t=1.0, friction=0.1, normal_impulse=3.0)
    -0.30000000000000004
    """
    limit = friction * normal_impulse
    return clamp(accumulated - vt * m_eff_t, -limit, limit)

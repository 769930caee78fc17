"""What one contact does: the impulse along its normal, and the friction along its tangent.

======  ==================================================================  =====
symbol  meaning                                                             unit
======  ==================================================================  =====
vn, vt  relative velocity at the contact, along normal and tangent;         m/s
        vn < 0 is approach
m_eff   effective mass: impulse needed for a change of relative velocity    kg
jn, jt  normal and tangent impulse; jn >= 0, it can only push               N s
mu      friction coefficient                                                -
======  ==================================================================  =====
"""

from __future__ import annotations

import math

from lesson_code.formulas.arithmetic import clamp
from lesson_code.formulas.validation import (
    Number,
    finite,
    formula,
    non_negative,
    positive,
    unit_interval,
)


@formula(vn=finite, m_eff=positive, restitution=unit_interval)
def normal_impulse(vn: Number, m_eff: Number, restitution: Number) -> Number:
    """Return the impulse that stops the approach and gives back the part e of it.

    jn = -(1 + e) vn m_eff  if vn < 0, else 0

    Parameters
    ----------
    vn : float or array
        Relative velocity along the normal, m/s; negative means approaching.
    m_eff : float or array
        Effective mass along the normal, kg, > 0.
    restitution : float or array
        0 to 1.

    Returns
    -------
    float or array
        Normal impulse, N s, >= 0: bodies that part are left alone.

    Raises
    ------
    ValueError
        vn is not finite, m_eff is not > 0 or the restitution lies outside [0, 1].

    References
    ----------
    Mirtich and Canny, Impulse-based Simulation of Rigid Bodies (1995), section 3.

    Examples
    --------
    >>> normal_impulse(vn=-4.0, m_eff=0.5, restitution=0.5)
    3.0
    >>> normal_impulse(vn=4.0, m_eff=0.5, restitution=0.5)
    0.0
    """
    return clamp(-(1 + restitution) * vn * m_eff, 0.0, math.inf)


@formula(vt=finite, m_eff_t=positive, friction=non_negative, normal_impulse=non_negative)
def friction_impulse(
    vt: Number, m_eff_t: Number, friction: Number, normal_impulse: Number
) -> Number:
    """Return the impulse of dry friction: it stops the sliding, or fails at Coulomb's limit.

    jt = -vt m_eff_t, but no larger than mu jn either way

    Parameters
    ----------
    vt : float or array
        Relative velocity along the tangent, m/s.
    m_eff_t : float or array
        Effective mass along the tangent, kg, > 0.
    friction : float or array
        Friction coefficient mu, >= 0.
    normal_impulse : float or array
        jn, N s, >= 0.

    Returns
    -------
    float or array
        Tangent impulse, N s, against the sliding.

    Raises
    ------
    ValueError
        vt is not finite, m_eff_t is not > 0, or mu or jn is negative.

    References
    ----------
    Catto, Iterative Dynamics with Temporal Coherence (2005), section 4: the clamp.

    Examples
    --------
    Strong friction stops the sliding; weak friction only slows it.

    >>> friction_impulse(vt=2.0, m_eff_t=1.0, friction=1.0, normal_impulse=3.0)
    -2.0
    >>> friction_impulse(vt=2.0, m_eff_t=1.0, friction=0.1, normal_impulse=3.0)
    -0.30000000000000004
    """
    limit = friction * normal_impulse
    return clamp(-vt * m_eff_t, -limit, limit)

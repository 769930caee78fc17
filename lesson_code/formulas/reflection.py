"""A ball against something immovable: the mirror, the bounce, and a variant mistaken for it.

======  ======================================================================  =====
symbol  meaning                                                                 unit
======  ======================================================================  =====
I, v    velocity before                                                         m/s
N, n    unit normal of the wall, pointing inward: from the wall to the ball     -
R       mirror image of I                                                       m/s
e       restitution: acts on the normal part alone                              -
======  ======================================================================  =====
"""

from __future__ import annotations

from lesson_code.formulas.arithmetic import dot, perpendicular
from lesson_code.formulas.contact import friction_impulse, normal_impulse
from lesson_code.formulas.validation import (
    Number,
    Vector,
    equation,
    formula,
    non_negative,
    unit_interval,
    unit_vector,
    vector,
)


@formula(returns_vector=True, incident=vector, normal=unit_vector)
def reflect(incident: Vector, normal: Vector) -> Vector:
    """Return the mirror image of a velocity at a wall.

    R = I - 2 (I . N) N

    The part of I along N is removed twice: once to stop it, once more to send it back. N and -N
    give the same R, so which way the normal points does not matter here.

    Parameters
    ----------
    incident : array_like, shape (..., 2)
        Velocity before, m/s.
    normal : array_like, shape (..., 2)
        Unit normal of the wall, length 1 within 1e-9.

    Returns
    -------
    ndarray, shape (..., 2)
        Velocity after, m/s: the same speed.

    Raises
    ------
    ValueError
        A component is not finite, a shape is not (..., 2), or the normal is not unit.

    References
    ----------
    Householder, Unitary Triangularization of a Nonsymmetric Matrix, J. ACM 5 (1958): the
    matrix 1 - 2 N N^T of this mirror.

    Examples
    --------
    >>> reflect(incident=(3, -4), normal=(0, 1))
    array([3., 4.])
    """
    return incident - 2 * dot(incident, normal) * normal


@formula(
    returns_vector=True,
    velocity=vector,
    normal=unit_vector,
    restitution=unit_interval,
    friction=non_negative,
)
def bounce(velocity: Vector, normal: Vector, restitution: Number, friction: Number = 0.0) -> Vector:
    """Return the velocity after a bounce off an immovable wall.

    v' = v + jn n + jt t        jn = -(1 + e)(v . n) if v . n < 0, else 0
                                jt = -(v . t), at most mu jn either way

    The impulses are those of a contact, per unit mass of the ball: a velocity that already
    leads away from the wall is left alone, restitution acts on the normal part only, and
    without friction the tangent part is kept.

    Parameters
    ----------
    velocity : array_like, shape (..., 2)
        Velocity before, m/s.
    normal : array_like, shape (..., 2)
        Unit normal from the wall to the ball, length 1 within 1e-9.
    restitution : float or array
        0 to 1.
    friction : float or array
        Friction coefficient mu, >= 0, of a ball that cannot spin.

    Returns
    -------
    ndarray, shape (..., 2)
        Velocity after, m/s.

    Raises
    ------
    ValueError
        A component is not finite, a shape is not (..., 2), the normal is not unit, the
        restitution lies outside [0, 1] or the friction is negative.

    References
    ----------
    Brach, Mechanical Impact Dynamics (1991), chapter 1: a particle against a massive surface.

    Examples
    --------
    >>> bounce(velocity=(3, -4), normal=(0, 1), restitution=0.5)
    array([3., 2.])
    >>> bounce(velocity=(3, 4), normal=(0, 1), restitution=0.5)
    array([3., 4.])
    """
    tangent = perpendicular(normal)
    jn = equation(normal_impulse)(dot(velocity, normal), 1.0, restitution)
    jt = equation(friction_impulse)(dot(velocity, tangent), 1.0, friction, jn)
    return velocity + jn * normal + jt * tangent


@formula(returns_vector=True, velocity=vector, normal=unit_vector, restitution=unit_interval)
def scaled_reflection(velocity: Vector, normal: Vector, restitution: Number) -> Vector:
    """Return e R: the whole mirror image scaled, the tangent part too.

    v' = e (v - 2 (v . n) n)  if v . n < 0, else v

    Often written where :func:`bounce` is meant. It loses more energy: a factor e^2 of all of
    it instead of the normal part alone. Real walls behave so only when friction happens to
    take the same part of the tangent.

    Parameters
    ----------
    velocity : array_like, shape (..., 2)
        Velocity before, m/s.
    normal : array_like, shape (..., 2)
        Unit normal from the wall to the ball, length 1 within 1e-9.
    restitution : float or array
        0 to 1.

    Returns
    -------
    ndarray, shape (..., 2)
        Velocity after, m/s.

    Raises
    ------
    ValueError
        As for :func:`bounce`.

    Examples
    --------
    >>> scaled_reflection(velocity=(3, -4), normal=(0, 1), restitution=0.5)
    array([1.5, 2. ])
    """
    approaching = dot(velocity, normal) < 0
    reflected = equation(reflect)(velocity, normal)
    return approaching * restitution * reflected + (1 - approaching) * velocity

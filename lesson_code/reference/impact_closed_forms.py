"""Reference: the results of some well-known impacts, from algebra alone.

Nothing here uses the lesson's equations (only the rules for arguments are shared).

=============  ==================================================================  =====
symbol         meaning                                                             unit
=============  ==================================================================  =====
v, v'          velocity before and after                                           m/s
w'             angular velocity after, counter-clockwise                           rad/s
e              restitution                                                         -
m, M, I        masses; moment of inertia about the centre of mass                  kg, kg m^2
=============  ==================================================================  =====

Where three bodies or more touch at once, momentum and restitution do not fix the answer; each
docstring says which further assumption it makes.
"""

from __future__ import annotations

import math
import operator
from fractions import Fraction
from typing import Any

import numpy as np

from lesson_code.formulas.validation import (
    Number,
    finite,
    non_negative,
    one_number,
    positive,
    unit_interval,
)


def off_centre_hit(
    ball_mass: float,
    ball_velocity: float,
    body_mass: float,
    body_inertia: float,
    arm: float,
    restitution: float,
) -> tuple[float, float, float]:
    """Return the impact of a ball that hits a free body at rest off its centre, head-on.

    m v' + M V'     = m v             momentum
    m b v' + I w'   = m b v           angular momentum about the body's place
    V' + b w' - v'  = e v             separation = e * approach, where they touch

    Everything moves along one line; the arm b is measured across it, so that b > 0 turns the
    body counter-clockwise when the ball goes up. No friction acts.

    Parameters
    ----------
    ball_mass, body_mass, body_inertia : float
        m and M, kg; I about the body's centre of mass, kg m^2; > 0.
    ball_velocity : float
        v, m/s.
    arm : float
        b, m.
    restitution : float
        e, 0 to 1.

    Returns
    -------
    (v', V', w') : tuple of float
        Velocities of the ball and of the body's centre, m/s; its angular velocity, rad/s.

    Raises
    ------
    ValueError
        A mass or inertia is not > 0, a number not finite, or e lies outside [0, 1].

    Examples
    --------
    A ball hits the end of a rod of 2 m, both of 1 kg:

    >>> [round(x, 12) for x in off_centre_hit(1.0, 1.0, 1.0, 1 / 3, arm=1.0, restitution=1.0)]
    [0.6, 0.4, 1.2]
    """
    m, v = one_number("ball_mass", ball_mass, positive), one_number("ball_velocity", ball_velocity)
    big = one_number("body_mass", body_mass, positive)
    inertia = one_number("body_inertia", body_inertia, positive)
    b, e = one_number("arm", arm), one_number("restitution", restitution, unit_interval)
    equations = np.array([[m, big, 0.0], [m * b, 0.0, inertia], [-1.0, 1.0, b]])
    ball, body, turning = np.linalg.solve(equations, [m * v, m * b * v, e * v])
    return float(ball), float(body), float(turning)


def flat_landing(
    width: float, height: float, speed: float, restitution: float, sweeps: float = math.inf
) -> tuple[float, float]:
    """Return how a box that lands flat leaves the floor, after some sweeps of a solver.

    v' = e v and w' = 0 in the end. After n sweeps the impulses at the first and the second corner
    are the parts 1 - rho^(2n - 1) and 1 - rho^(2n) of the right ones,

    rho = -k12 / k11,   k11 = 1 + 3 s,   k12 = 1 - 3 s,   s = width^2 / (width^2 + height^2)

    Both corners must reach the velocity e v, and an impulse j at one of them changes its own
    velocity by k11 j/m and the other's by k12 j/m. A solver that visits them in turn, from no
    impulse, leaves rho of the one's error to the other. A tall box is slow: its rho is near -1.

    Parameters
    ----------
    width, height : float
        m, > 0; the mass is spread evenly.
    speed : float
        v downwards before, m/s, >= 0.
    restitution : float
        e, 0 to 1.
    sweeps : int or math.inf
        n, visits of both corners, the left one first; >= 1.

    Returns
    -------
    (v', w') : tuple of float
        Velocity upwards, m/s, and angular velocity, rad/s, counter-clockwise.

    Raises
    ------
    ValueError
        A length is not > 0, the speed is negative, e lies outside [0, 1], or the sweeps are no
        whole number >= 1.

    Examples
    --------
    A tall box after 10 sweeps is not yet flat:

    >>> flat_landing(width=1.0, height=10.0, speed=1.0, restitution=0.5)
    (0.5, 0.0)
    >>> v, w = flat_landing(width=1.0, height=10.0, speed=1.0, restitution=0.5, sweeps=10)
    >>> round(v, 4), round(w, 4)
    (0.514, -0.028)
    """
    w, h = one_number("width", width, positive), one_number("height", height, positive)
    v, e = (
        one_number("speed", speed, non_negative),
        one_number("restitution", restitution, unit_interval),
    )
    n = sweeps if sweeps == math.inf else _count("sweeps", sweeps, 1)
    share = 3 * w**2 / (w**2 + h**2)
    rho = -(1 - share) / (1 + share)
    left, right = ((1 + e) * v / 2 * (1 - rho ** (2 * n - i)) for i in (1, 0))
    return left + right - v, (right - left) * (w / 2) * 12 / (w**2 + h**2)


def two_ball_drop(
    lower_mass: Number, upper_mass: Number, speed: Number
) -> tuple[Fraction, Fraction]:
    """Return the velocities of two elastic balls that are dropped one on top of the other.

    lower: (M - 3 m)/(M + m) v,   upper: (3 M - m)/(M + m) v

    The lower ball turns first, at the floor, and then meets the upper one at the speed 2 v: there
    is a gap, however small, so that no three bodies touch at once.

    Parameters
    ----------
    lower_mass, upper_mass : int, float or Fraction
        M and m, kg, > 0 and finite.
    speed : int, float or Fraction
        v, with which both fall, m/s.

    Returns
    -------
    (lower, upper) : tuple of Fraction
        Velocities upwards, m/s; nearly 3 v for a light ball on a heavy one.

    Raises
    ------
    ValueError
        A mass is not > 0 or not finite, or the speed is not finite.

    Examples
    --------
    >>> two_ball_drop(lower_mass=3, upper_mass=1, speed=1)
    (Fraction(0, 1), Fraction(2, 1))
    """
    big, small = (
        Fraction(positive("lower_mass", lower_mass)),
        Fraction(positive("upper_mass", upper_mass)),
    )
    v = Fraction(finite("speed", speed))
    return (big - 3 * small) / (big + small) * v, (3 * big - small) / (big + small) * v


def cradle_one_by_one(count: int, speed: float) -> Any:
    """Return the velocities of a row of equal elastic balls after the first hits the others.

    (0, ..., 0, v)

    The balls have gaps, however small, so that they meet two at a time; each hands its velocity
    on. So does a real cradle, nearly.

    Parameters
    ----------
    count : int
        Number of balls, >= 2.
    speed : float
        v of the first, m/s.

    Returns
    -------
    ndarray, shape (count,)
        Velocities, m/s.

    Raises
    ------
    ValueError
        The count is below 2, or the speed is not finite.

    Examples
    --------
    >>> cradle_one_by_one(count=4, speed=2.0)
    array([0., 0., 0., 2.])
    """
    velocities = np.zeros(_count("count", count, 2))
    velocities[-1] = one_number("speed", speed)
    return velocities


def cradle_all_at_once(count: int, speed: float) -> Any:
    """Return the cradle's velocities if all contacts obey Newton's rule at the same instant.

    (-(n - 2)/n v, 2/n v, ..., 2/n v)

    All contacts but the first had no approach, so that their balls stay together; the first
    parts as fast as it met, and momentum is kept. Energy is kept too: it cannot tell this from
    :func:`cradle_one_by_one`.

    Parameters
    ----------
    count : int
        Number of balls n, >= 2.
    speed : float
        v of the first, m/s.

    Returns
    -------
    ndarray, shape (count,)
        Velocities, m/s.

    Raises
    ------
    ValueError
        The count is below 2, or the speed is not finite.

    Examples
    --------
    >>> cradle_all_at_once(count=5, speed=1.0)
    array([-0.6,  0.4,  0.4,  0.4,  0.4])
    """
    n, v = _count("count", count, 2), one_number("speed", speed)
    return np.array([-(n - 2) * v / n] + [2 * v / n] * (n - 1))


def break_shot(speed: float, restitution: float) -> Any:
    """Return the impact of a cue ball that hits two equal touching balls at once, head-on.

    cue: v (1 - 3 (1 + e)/5, 0),   the others: v (1 + e)/10 (3, +-sqrt(3))

    The three centres form an equilateral triangle, so that the normals are 30 degrees off. By
    symmetry both impulses are one J: each ball goes off at J/m along its normal, the cue loses
    2 J/m cos(30 deg), and restitution gives J/m = (1 + e) v cos(30 deg) / (1 + 2 cos^2(30 deg)).
    No friction acts, and the two balls do not push each other: they part.

    Parameters
    ----------
    speed : float
        v of the cue ball along x, m/s.
    restitution : float
        e, 0 to 1.

    Returns
    -------
    ndarray, shape (3, 2)
        Velocities of the cue, the upper and the lower ball, m/s.

    Raises
    ------
    ValueError
        The speed is not finite, or the restitution lies outside [0, 1].

    Examples
    --------
    >>> break_shot(speed=1.0, restitution=1.0).round(5)
    array([[-0.2    ,  0.     ],
           [ 0.6    ,  0.34641],
           [ 0.6    , -0.34641]])
    """
    v, e = one_number("speed", speed), one_number("restitution", restitution, unit_interval)
    part = (1 + e) * v / 10
    return np.array(
        [(v - 6 * part, 0), (3 * part, math.sqrt(3) * part), (3 * part, -math.sqrt(3) * part)]
    )


def _count(name: str, value: Any, least: int) -> int:
    """Return `value` if it is a whole number >= `least`, else raise an error that names it."""
    if operator.index(value) < least:
        raise ValueError(f"{name} must be >= {least}, got {value}")
    return operator.index(value)

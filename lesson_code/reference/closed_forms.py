"""Reference: answers that follow from algebra alone.

Nothing here uses the lesson's equations (only the rules for arguments are shared), so that an
error in one of them cannot hide in its own check.

==============  ===================================================  =====
symbol          meaning                                              unit
==============  ===================================================  =====
h, g, e         height dropped from, gravity, restitution            m, m/s^2, -
T               time of the first fall, sqrt(2 h / g)                s
t_n             time of the n-th impact, n = 1, 2, ...               s
h_n             height reached after the n-th impact                 m
==============  ===================================================  =====
"""

from __future__ import annotations

import operator
from fractions import Fraction
from typing import Any

import numpy as np

from lesson_code.formulas.validation import (
    Number,
    Vector,
    equation,
    finite,
    formula,
    non_negative,
    one_vector,
    positive,
    unit_interval,
)


def two_body_exact(
    m1: Number, v1: Number, m2: Number, v2: Number, restitution: Number
) -> tuple[Fraction, Fraction]:
    """Return both velocities after a collision on a line, as exact fractions.

    The two statements of the collision are two linear equations, solved by Cramer's rule:

        m1 v1' + m2 v2' = m1 v1 + m2 v2        momentum is kept
          -v1' +    v2' = e (v1 - v2)          separation = e * approach

    Parameters
    ----------
    m1, m2 : int, float or Fraction
        Masses, kg, > 0 and finite.
    v1, v2 : int, float or Fraction
        Velocities before, m/s.
    restitution : int, float or Fraction
        0 to 1.

    Returns
    -------
    (v1', v2') : tuple of Fraction
        Velocities after, m/s. A float argument stands for the exact binary number it is.

    Raises
    ------
    ValueError
        A mass is not > 0 or not finite, a velocity is not finite, or the restitution lies
        outside [0, 1].

    References
    ----------
    Newton, Principia (1687), corollary 3 to the laws of motion (momentum) and the scholium
    (restitution).

    Examples
    --------
    >>> two_body_exact(m1=1, v1=2, m2=3, v2=-1, restitution=Fraction(7, 10))
    (Fraction(-73, 40), Fraction(11, 40))
    """
    a1, a2 = Fraction(positive("m1", m1)), Fraction(positive("m2", m2))
    u1, u2 = Fraction(finite("v1", v1)), Fraction(finite("v2", v2))
    e = Fraction(unit_interval("restitution", restitution))
    momentum, separation = a1 * u1 + a2 * u2, e * (u1 - u2)
    determinant = a1 * 1 - a2 * -1
    v1_after = (momentum * 1 - a2 * separation) / determinant
    v2_after = (a1 * separation - momentum * -1) / determinant
    return v1_after, v2_after


def bounce_heights(height: float, restitution: float, count: int) -> Any:
    """Return how high a dropped ball rises after each impact.

    h_n = e^(2 n) h

    Parameters
    ----------
    height : float
        Height the ball is dropped from, m, > 0.
    restitution : float
        0 to 1.
    count : int
        Number of impacts, >= 0.

    Returns
    -------
    ndarray, shape (count,)
        Heights after impact 1, 2, ..., count, m.

    Raises
    ------
    ValueError
        The height is not > 0, the restitution lies outside [0, 1] or the count is negative.

    Examples
    --------
    >>> bounce_heights(height=16, restitution=0.5, count=3)
    array([4.  , 1.  , 0.25])
    """
    h, e = positive("height", height), unit_interval("restitution", restitution)
    return h * float(e) ** (2 * np.arange(1, _count(count) + 1))


def bounce_times(height: float, restitution: float, count: int, gravity: float) -> Any:
    """Return when a dropped ball hits the floor.

    t_n = T + 2 e T + 2 e^2 T + ... + 2 e^(n-1) T,   T = sqrt(2 h / g)

    Parameters
    ----------
    height : float
        Height the ball is dropped from at time 0, m, > 0.
    restitution : float
        0 to 1.
    count : int
        Number of impacts, >= 0.
    gravity : float
        Acceleration downwards, m/s^2, > 0.

    Returns
    -------
    ndarray, shape (count,)
        Times of impact 1, 2, ..., count, s. With e = 0 the ball stays down, and they are all T.

    Raises
    ------
    ValueError
        The height or gravity is not > 0, the restitution lies outside [0, 1] or the count is
        negative.

    Examples
    --------
    >>> bounce_times(height=5, restitution=0.5, count=4, gravity=10)
    array([1.  , 2.  , 2.5 , 2.75])
    """
    e = unit_interval("restitution", restitution)
    powers = float(e) ** np.arange(_count(count))
    return _fall_time(height, gravity) * (2 * np.cumsum(powers) - 1)


def _comes_to_rest(values: dict[str, Any]) -> None:
    """Refuse a restitution of 1: that ball bounces for ever."""
    if values["restitution"] == 1:
        raise ValueError("restitution must be < 1 for a ball that comes to rest, got 1")


@formula(together=_comes_to_rest, height=positive, restitution=unit_interval, gravity=positive)
def rest_time(height: float, restitution: float, gravity: float) -> float:
    """Return when a dropped ball comes to rest, after infinitely many impacts.

    t = T (1 + 2 e + 2 e^2 + ...) = sqrt(2 h / g) (1 + e) / (1 - e)

    Parameters
    ----------
    height : float
        Height the ball is dropped from at time 0, m, > 0.
    restitution : float
        0 to 1, but less than 1.
    gravity : float
        Acceleration downwards, m/s^2, > 0.

    Returns
    -------
    float
        Time, s.

    Raises
    ------
    ValueError
        The height or gravity is not > 0, the restitution lies outside [0, 1], or it is 1: then
        the ball never rests.

    Examples
    --------
    >>> rest_time(height=5, restitution=0.5, gravity=10)
    3.0
    """
    e = restitution
    return equation(_fall_time)(height, gravity) * float((1 + e) / (1 - e))


def bouncing_ball(times: Number, height: float, restitution: float, gravity: float) -> Any:
    """Return the height of a dropped ball at any time, bounces and final rest included.

    y = g/2 (t - t_n) (d_n - (t - t_n)),   t_n <= t < t_n + d_n,   d_n = 2 e^n T

    Flight n begins with impact n and lasts d_n; the first fall is the second half of flight 0,
    which would have begun at -T. Which flight t falls in comes from the geometric series

        t_n = T (2 (1 - e^n)/(1 - e) - 1) <= t

    solved for n with a logarithm. Next to an impact, where rounding may choose the
    neighbouring flight, both flights say 0.

    Parameters
    ----------
    times : float or array_like
        Times since the drop, s, >= 0.
    height : float
        Height the ball is dropped from, m, > 0.
    restitution : float
        0 to 1.
    gravity : float
        Acceleration downwards, m/s^2, > 0.

    Returns
    -------
    ndarray, shape of `times`
        Height of the ball above the floor, m, >= 0; 0 from :func:`rest_time` on.

    Raises
    ------
    ValueError
        A time is negative or not finite, the height or gravity is not > 0, or the restitution
        lies outside [0, 1].

    Examples
    --------
    >>> bouncing_ball(times=[0, 1, 1.5, 2, 4], height=5, restitution=0.5, gravity=10)
    array([5.  , 0.  , 1.25, 0.  , 0.  ])
    """
    fall = _fall_time(height, gravity)
    e = float(unit_interval("restitution", restitution))
    t = np.asarray(non_negative("times", times), dtype=float)
    start, duration = _flight(t / fall, e)
    since = t - fall * start
    y = gravity / 2 * since * (fall * duration - since)
    in_flight = np.ones_like(t, dtype=bool) if e == 1 else t < rest_time(height, e, gravity)
    return np.where(in_flight, np.maximum(y, 0.0), 0.0)


def ball_in_box(
    position: Vector, velocity: Vector, radius: float, width: float, height: float, time: float
) -> tuple[Any, Any]:
    """Return where a ball is that bounces elastically in a box, without gravity.

    Each wall hit is undone by mirroring the box instead of the ball: in the unfolded plane the
    ball flies straight on. Folding back gives, for each axis with its room L = width - 2 radius,
    the triangle wave of period 2 L. It is worked out in exact fractions, so the answer is the
    true one rounded once, after any number of bounces.

    Parameters
    ----------
    position : array_like, shape (2,)
        Centre of the ball at time 0, m, inside the box [0, width] x [0, height].
    velocity : array_like, shape (2,)
        m/s at time 0.
    radius : float
        m, > 0.
    width, height : float
        Size of the box, m, > 2 radius.
    time : float
        s, >= 0.

    Returns
    -------
    (position, velocity) : tuple of ndarray, shape (2,)
        m and m/s at that time; at the instant of an impact the velocity is that after it.

    Raises
    ------
    ValueError
        A number is not finite, the box has no room for the ball, the ball does not start
        inside, or the time is negative.

    References
    ----------
    Tabachnikov, Geometry and Billiards (2005), chapter 2: unfolding.

    Examples
    --------
    >>> ball_in_box((1, 1), (1, 2), radius=0.5, width=3, height=2, time=2)
    (array([2., 1.]), array([-1.,  2.]))
    """
    r, t = Fraction(positive("radius", radius)), Fraction(non_negative("time", time))
    x, v = one_vector("position", position), one_vector("velocity", velocity)
    axes = (("width", width, x[0], v[0]), ("height", height, x[1], v[1]))
    folded = [
        _fold(_inside(name, size, x_axis, r), Fraction(v_axis), _room(name, size, r), t)
        for name, size, x_axis, v_axis in axes
    ]
    return (
        np.array([float(place + r) for place, _ in folded]),
        np.array([float(speed) for _, speed in folded]),
    )


@formula(height=positive, gravity=positive)
def _fall_time(height: float, gravity: float) -> float:
    """Return T = sqrt(2 h / g), the time of the first fall, s."""
    return float(np.sqrt(2 * height / gravity))


def _flight(t: Any, e: float) -> tuple[Any, Any]:
    """Return start and duration of the flight at time `t`, all in units of the fall time T."""
    if e == 0:
        n = np.zeros_like(t)
        return n - 1, n + 2
    if e == 1:
        n = np.floor((t + 1) / 2)
        return 2 * n - 1, 2.0
    part_of_series = np.minimum((t + 1) * (1 - e) / 2, 1 - np.finfo(float).epsneg)
    n = np.floor(np.log1p(-part_of_series) / np.log(e))
    return -2 * np.expm1(n * np.log(e)) / (1 - e) - 1, 2 * e**n


def _fold(x: Fraction, v: Fraction, room: Fraction, t: Fraction) -> tuple[Fraction, Fraction]:
    """Return place and velocity on one axis, from x in [0, room], after time `t`."""
    start = x if v >= 0 else -x
    unfolded = (start + abs(v) * t) % (2 * room)
    if v != 0 and unfolded >= room:
        return 2 * room - unfolded, -abs(v)
    return unfolded, abs(v)


def _room(name: str, size: float, radius: Fraction) -> Fraction:
    """Return the room that a ball's centre has along one side of the box, m."""
    room = Fraction(positive(name, size)) - 2 * radius
    if not room > 0:
        raise ValueError(f"{name} must be > 2 radius = {float(2 * radius)} m, got {size}")
    return room


def _inside(name: str, size: float, x: float, radius: Fraction) -> Fraction:
    """Return how far the ball's centre may still move towards the wall at 0, m."""
    place = Fraction(x) - radius
    if not 0 <= place <= _room(name, size, radius):
        raise ValueError(
            f"position must be at least one radius inside the box: between {float(radius)} "
            f"and {name} - {float(radius)} m, got {x}"
        )
    return place


def _count(value: int) -> int:
    """Return `value` if it is a whole number >= 0, else raise an error that names it."""
    if operator.index(value) < 0:
        raise ValueError(f"count must be >= 0, got {value}")
    return operator.index(value)

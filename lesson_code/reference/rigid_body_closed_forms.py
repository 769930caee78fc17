"""Reference: how rigid bodies slide, roll, tip and rest, from algebra alone.

Nothing here uses the lesson's equations (only the rules for arguments are shared).

=========  =========================================================================  ========
symbol     meaning                                                                    unit
=========  =========================================================================  ========
v, w       velocity along the floor; angular velocity, counter-clockwise              m/s, rad/s
r, k       radius; I / (m r^2): 1/2 for a disc, 1 for a hoop, 2/5 for a ball          m, -
u          velocity of the lowest point, v + w r: 0 when rolling                      m/s
mu, g      friction coefficient, gravity                                              -, m/s^2
theta      steepness of an incline, from the horizontal                               rad
=========  =========================================================================  ========
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from lesson_code.formulas.validation import (
    Number,
    finite,
    non_negative,
    one_number,
    positive,
)


class Rolling(NamedTuple):
    """When and where a body begins to roll, and how it moves from then on."""

    time: float
    """s since it was set down."""
    distance: float
    """m along the floor, in the direction of positive v."""
    velocity: float
    """m/s."""
    angular_velocity: float
    """rad/s, counter-clockwise: -velocity / radius."""


def rolling_begins(
    velocity: float,
    angular_velocity: float,
    radius: float,
    inertia_ratio: float,
    friction: float,
    gravity: float,
) -> Rolling:
    """Return when a round body that slides on a level floor begins to roll.

    v' = (v - k w r) / (1 + k),   t = k abs(u) / ((1 + k) mu g)

    Friction acts at the floor and has no lever arm about any point of it, so that the angular
    momentum I w - m r v about such a point is kept; put w' = -v'/r into it. Friction is mu m g
    until then, and u changes by (1 + 1/k) mu g a second.

    Parameters
    ----------
    velocity : float
        v at the start, m/s.
    angular_velocity : float
        w at the start, rad/s, counter-clockwise; rolling forwards is -v/r.
    radius : float
        m, > 0.
    inertia_ratio : float
        k = I / (m r^2), > 0.
    friction : float
        mu, > 0.
    gravity : float
        m/s^2, > 0.

    Returns
    -------
    Rolling
        Time, distance, velocity and angular velocity.

    Raises
    ------
    ValueError
        A velocity is not finite, or another argument is not > 0.

    Examples
    --------
    A disc set down at 3 m/s without spin keeps two thirds of it, whatever the friction:

    >>> rolling_begins(3.0, 0.0, radius=0.5, inertia_ratio=0.5, friction=0.1, gravity=10.0)
    Rolling(time=1.0, distance=2.5, velocity=2.0, angular_velocity=-4.0)
    """
    v, w = one_number("velocity", velocity), one_number("angular_velocity", angular_velocity)
    r, k = one_number("radius", radius, positive), _ratio(inertia_ratio)
    deceleration = one_number("friction", friction, positive) * _gravity(gravity)
    time = k * abs(v + w * r) / ((1 + k) * deceleration)
    rolling = (v - k * w * r) / (1 + k)
    return Rolling(time, (v + rolling) / 2 * time, rolling, -rolling / r)


def slide_to_roll(
    times: Number,
    velocity: float,
    angular_velocity: float,
    radius: float,
    inertia_ratio: float,
    friction: float,
    gravity: float,
) -> tuple[Any, Any]:
    """Return the velocities of a round body on a level floor at any time, sliding or rolling.

    v goes to v' and w to w' in straight lines, reached at the time of :func:`rolling_begins`.

    Parameters
    ----------
    times : float or array_like
        s since it was set down, >= 0.
    velocity, angular_velocity, radius, inertia_ratio, friction, gravity : float
        As for :func:`rolling_begins`.

    Returns
    -------
    (velocity, angular_velocity) : tuple of ndarray, shape of `times`
        m/s and rad/s, counter-clockwise.

    Raises
    ------
    ValueError
        A time is negative, or as for :func:`rolling_begins`.

    Examples
    --------
    >>> v, w = slide_to_roll([0, 0.5, 1, 9], 3.0, 0.0, 0.5, 0.5, friction=0.1, gravity=10.0)
    >>> v, w
    (array([3. , 2.5, 2. , 2. ]), array([ 0., -2., -4., -4.]))
    """
    rolling = rolling_begins(velocity, angular_velocity, radius, inertia_ratio, friction, gravity)
    t = np.asarray(non_negative("times", times), dtype=float)
    gone = np.ones_like(t) if rolling.time == 0 else np.minimum(t / rolling.time, 1.0)
    return (
        velocity + gone * (rolling.velocity - velocity),
        angular_velocity + gone * (rolling.angular_velocity - angular_velocity),
    )


def friction_to_roll(angle: float, inertia_ratio: float) -> float:
    """Return the least friction coefficient with which a round body rolls down an incline.

    mu = tan(theta) k / (1 + k)

    Rolling takes a friction force of k m a = m g sin(theta) k / (1 + k), and there are at most
    mu m g cos(theta).

    Parameters
    ----------
    angle : float
        theta, rad, from 0 to below pi/2.
    inertia_ratio : float
        k = I / (m r^2), > 0.

    Returns
    -------
    float
        Friction coefficient; tan(theta)/3 for a disc, tan(theta)/2 for a hoop.

    Raises
    ------
    ValueError
        The angle lies outside [0, pi/2), or the ratio is not > 0.

    Examples
    --------
    >>> round(friction_to_roll(math.atan(0.75), inertia_ratio=0.5), 12)
    0.25
    """
    k = _ratio(inertia_ratio)
    return math.tan(_slope(angle)) * k / (1 + k)


def roll_down(
    angle: float, inertia_ratio: float, friction: float, gravity: float
) -> tuple[float, float]:
    """Return the accelerations of a round body on an incline: of its centre, and of its rim.

    rolling:    a = g sin(theta) / (1 + k),             rim: the same
    slipping:   a = g (sin(theta) - mu cos(theta)),     rim: mu g cos(theta) / k

    Parameters
    ----------
    angle : float
        theta, rad, from 0 to below pi/2.
    inertia_ratio : float
        k = I / (m r^2), > 0.
    friction : float
        mu, >= 0; it slips below :func:`friction_to_roll`.
    gravity : float
        m/s^2, > 0.

    Returns
    -------
    (acceleration, rim acceleration) : tuple of float
        Of the centre down the incline, and the angular acceleration times r, m/s^2.

    Raises
    ------
    ValueError
        The angle lies outside [0, pi/2), the ratio or gravity is not > 0, or mu is negative.

    Examples
    --------
    A slope of 3 in 5; the disc rolls on one floor and slips on another:

    >>> a, rim = roll_down(math.asin(0.6), inertia_ratio=0.5, friction=0.3, gravity=10.0)
    >>> round(a, 12), round(rim, 12)
    (4.0, 4.0)
    >>> a, rim = roll_down(math.asin(0.6), inertia_ratio=0.5, friction=0.125, gravity=10.0)
    >>> round(a, 12), round(rim, 12)
    (5.0, 2.0)
    """
    k, g, theta = _ratio(inertia_ratio), _gravity(gravity), _slope(angle)
    mu = one_number("friction", friction, non_negative)
    if mu >= friction_to_roll(angle, inertia_ratio):
        rolling = g * math.sin(theta) / (1 + k)
        return rolling, rolling
    return g * (math.sin(theta) - mu * math.cos(theta)), mu * g * math.cos(theta) / k


def slide_down(angle: float, friction: float, gravity: float) -> float:
    """Return the acceleration of a box released on an incline, if it does not tip.

    a = g (sin(theta) - mu cos(theta)),   or 0 if mu >= tan(theta)

    Parameters
    ----------
    angle : float
        theta, rad, from 0 to below pi/2.
    friction : float
        mu, >= 0.
    gravity : float
        m/s^2, > 0.

    Returns
    -------
    float
        Acceleration down the incline, m/s^2, >= 0.

    Raises
    ------
    ValueError
        The angle lies outside [0, pi/2), mu is negative, or gravity is not > 0.

    Examples
    --------
    >>> round(slide_down(math.asin(0.6), friction=0.5, gravity=10.0), 12)
    2.0
    >>> slide_down(math.asin(0.6), friction=0.8, gravity=10.0)
    0.0
    """
    g, theta = _gravity(gravity), _slope(angle)
    mu = one_number("friction", friction, non_negative)
    sticks = mu >= math.tan(theta)
    return 0.0 if sticks else g * (math.sin(theta) - mu * math.cos(theta))


def tipping_angle(width: float, height: float) -> float:
    """Return how steep an incline may be before a box that does not slide tips over.

    theta = atan(width / height)

    Then its centre of mass stands exactly above its lower corner.

    Parameters
    ----------
    width : float
        Along the incline, m, > 0.
    height : float
        Away from it, m, > 0.

    Returns
    -------
    float
        Angle, rad.

    Raises
    ------
    ValueError
        A length is not > 0.

    Examples
    --------
    >>> round(math.degrees(tipping_angle(width=1.0, height=2.0)), 3)
    26.565
    """
    return math.atan2(one_number("width", width, positive), one_number("height", height, positive))


def wedge_forces(weight: float, left_angle: float, right_angle: float) -> tuple[float, float]:
    """Return the force of each of two smooth walls on a disc that lies between them.

    F_left = W sin(right) / sin(left + right),   F_right = W sin(left) / sin(left + right)

    Three forces in balance are as the sines of the angles between the other two (Lami). With
    both walls at theta, each force is W / (2 cos(theta)).

    Parameters
    ----------
    weight : float
        W = m g, N, > 0.
    left_angle, right_angle : float
        How steep each wall is, rad from the horizontal: between 0 and pi/2, both included, but
        not both 0 (a floor) nor both pi/2 (nothing holds the disc).

    Returns
    -------
    (left, right) : tuple of float
        Forces, N, >= 0.

    Raises
    ------
    ValueError
        The weight is not > 0, an angle lies outside [0, pi/2], or the walls hold no disc.

    Examples
    --------
    >>> left, right = wedge_forces(10.0, math.pi / 4, math.pi / 4)
    >>> round(left, 12), round(right, 12)
    (7.071067811865, 7.071067811865)
    """
    w, left, right = one_number("weight", weight, positive), *_walls(left_angle, right_angle)
    between = math.sin(left + right)
    return w * math.sin(right) / between, w * math.sin(left) / between


def stack_forces(masses: Number, gravity: float) -> Any:
    """Return the force under every body of a stack at rest.

    F_i = g (m_i + m_(i+1) + ... + m_top): each contact carries all that is above it.

    Parameters
    ----------
    masses : array_like, shape (N,)
        kg, > 0, from the lowest body to the highest.
    gravity : float
        m/s^2, > 0.

    Returns
    -------
    ndarray, shape (N,)
        Forces, N: on the floor, on the lowest body, and so on. A solver's impulse in a step is
        this times the length of the step.

    Raises
    ------
    ValueError
        A mass or gravity is not > 0.

    Examples
    --------
    >>> stack_forces([3.0, 2.0, 1.0], gravity=10.0)
    array([60., 30., 10.])
    """
    m = np.asarray(positive("masses", masses), dtype=float)
    return _gravity(gravity) * np.cumsum(m[::-1])[::-1]


def _ratio(value: float) -> float:
    """Return `value` if it is a k = I / (m r^2) > 0, else raise an error that names it."""
    return one_number("inertia_ratio", value, positive)


def _gravity(value: float) -> float:
    """Return `value` if it is a gravity > 0, else raise an error that names it."""
    return one_number("gravity", value, positive)


def _slope(value: float) -> float:
    """Return `value` if an incline can have this angle, else raise an error that names it."""
    angle = one_number("angle", value, finite)
    if not 0 <= angle < math.pi / 2:
        raise ValueError(f"angle must be from 0 to below pi/2 rad, got {value}")
    return angle


def _walls(left: float, right: float) -> tuple[float, float]:
    """Return the angles of two walls that can hold a disc, or raise an error."""
    for name, angle in (("left_angle", left), ("right_angle", right)):
        if not 0 <= one_number(name, angle) <= math.pi / 2:
            raise ValueError(f"{name} must be between 0 and pi/2 rad, got {angle}")
    if not 0 < left + right < math.pi:
        raise ValueError(
            f"left_angle and right_angle must not both be 0 or both pi/2, got {left} twice"
        )
    return left, right

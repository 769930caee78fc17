"""Reference: closed forms for bodies that fly freely and collide instantaneously.

Nothing here uses the lesson's equations (only the rules for arguments are shared).

=============  ==================================================================  =====
symbol         meaning                                                             unit
=============  ==================================================================  =====
v, h           speed; length of a time step                                        m/s, s
s, R           way between two samples; sum of two radii                           m
r, th          radius of a ball, thickness of a wall                               m
M              mass of the block that comes, over that of the block at the wall    -
N, A           number of discs, area of the box                                    -, m^2
sigma, m       diameter and mass of a disc                                         m, kg
T              mean kinetic energy of a disc: "temperature", with k_B = 1          J
eta            share of the area that discs cover, N pi sigma^2 / (4 A)            -
=============  ==================================================================  =====
"""

from __future__ import annotations

import math

from lesson_code.formulas.validation import finite, non_negative, one_number, positive

CLOSEST_PACKING = math.pi / math.sqrt(12)
"""Largest share of a plane that equal discs can cover."""


def escape_fraction(speed: float, dt: float, radius: float, thickness: float) -> float:
    """Return the share of balls that pass a wall that is checked only at the ends of steps.

    1 - (r + th/2) / (v h),   or 0 if that is negative

    The centre advances by v h a step. A ball is stopped if it is found before the wall's middle
    and within r + th/2 of it, so that the normal points back. Found beyond the middle it is let
    out on the far side, because there it already leaves. The place of the first step is random,
    so the part of the way v h that stops a ball is also the part of the balls that is stopped.

    Parameters
    ----------
    speed : float
        v, straight at the wall, m/s, > 0.
    dt : float
        h, s, > 0.
    radius, thickness : float
        r and th, m, >= 0.

    Returns
    -------
    float
        0 to 1.

    Raises
    ------
    ValueError
        A number is out of its range.

    Examples
    --------
    A way of 0.5 m a step, and 0.2 m in which the ball is seen in time:

    >>> escape_fraction(speed=5, dt=0.1, radius=0.1, thickness=0.2)
    0.6
    """
    step = one_number("speed", speed, positive) * one_number("dt", dt, positive)
    reach = (
        one_number("radius", radius, non_negative)
        + one_number("thickness", thickness, non_negative) / 2
    )
    return max(0.0, 1 - reach / step)


def missed_by_samples(spacing: float, reach: float) -> float:
    """Return the share of all hits of two circles that lie entirely between two samples.

    1 - sqrt(1 - k^2)/2 - arcsin(k)/(2 k)   for k <= 1,   about k^2/6 for a small k
    1 - pi/(4 k)                            for k >= 1,   k = s / (2 R)

    The circles pass each other at a distance that is anything from 0 to R = r1 + r2. So long as
    they overlap they make a way L, a chord of a circle of radius R. Samples stand at every s of
    that way, and the chance that none of them lies in the chord is 1 - L/s if that is positive.

    Parameters
    ----------
    spacing : float
        s: the way that one circle makes between two samples, seen from the other, m, > 0.
    reach : float
        R, m, > 0.

    Returns
    -------
    float
        0 to 1.

    Raises
    ------
    ValueError
        A number is not > 0, or not finite.

    Examples
    --------
    Circles of 1 m across, looked at every 2 m: the mean chord is pi/2 m long.

    >>> missed_by_samples(spacing=2.0, reach=1.0) == 1 - math.pi / 4
    True
    """
    k = one_number("spacing", spacing, positive) / (2 * one_number("reach", reach, positive))
    if k >= 1:
        return 1 - math.pi / (4 * k)
    return 1 - math.sqrt(1 - k * k) / 2 - math.asin(k) / (2 * k)


def block_collisions(mass_ratio: float) -> int:
    """Return the total number of collisions between two elastic blocks and a wall.

    ceil(pi / theta) - 1,   tan(theta) = 1 / sqrt(M)

    A block at rest stands in front of a wall; a block of M times its mass approaches. In the plane
    of (sqrt(m1) x1, sqrt(m2) x2) the two are one point that flies in a wedge of the angle theta:
    one side is the wall, the other the contact of the blocks, and every collision is a reflection.
    Unfolded, the way is a straight line along one side. Seen from the tip of the wedge it turns by
    pi in all, and at each multiple of theta on the way it crosses a side. For M = 100^k the count
    is made of the first k + 1 digits of pi.

    Parameters
    ----------
    mass_ratio : float
        M, > 0.

    Returns
    -------
    int
        Collisions of the two blocks, and of the light block with the wall.

    Raises
    ------
    ValueError
        The ratio is not > 0, or not finite.

    References
    ----------
    Galperin, Playing pool with pi, Regular and Chaotic Dynamics 8 (2003), 375.

    Examples
    --------
    >>> [block_collisions(ratio) for ratio in (1, 100, 10000)]
    [3, 31, 314]
    """
    ratio = one_number("mass_ratio", mass_ratio, positive)
    return math.ceil(math.pi / math.atan(1 / math.sqrt(ratio))) - 1


def blocks_at(time: float, mass_ratio: float, inner: float, outer: float) -> tuple[float, float]:
    """Return where two elastic blocks and a wall are after any time and any number of collisions.

    x1 = r sin(phi),   sqrt(M) x2 = r cos(phi)

    In the plane of :func:`block_collisions` the two blocks are one point. Its way, unfolded, is the
    straight line (inner, sqrt(M) (outer - t)). It turns about the tip of the wedge, and phi is what
    is left of its angle when every mirror is undone: the distance to the nearest multiple of
    2 theta.

    Parameters
    ----------
    time : float
        s, >= 0.
    mass_ratio : float
        M, > 0: of the outer block, which comes at 1 m/s, and of the inner one, which is at rest.
    inner, outer : float
        Of the inner block from the wall at the start, and of the outer one from where it would be
        if the inner one were pressed to the wall, m, 0 <= inner <= outer.

    Returns
    -------
    (x1, x2) : tuple of float
        The same after that time, m.

    Raises
    ------
    ValueError
        An argument is out of its range.

    References
    ----------
    Galperin, Playing pool with pi, Regular and Chaotic Dynamics 8 (2003), 375.

    Examples
    --------
    Equal blocks swap their velocities. The inner one starts after 2 s, is at the wall after 3 s and
    back after 4 s; the outer one has waited there, and is 1 m further out after 5 s.

    >>> [round(place, 12) for place in blocks_at(3.5, 1.0, inner=1.0, outer=3.0)]
    [0.5, 1.0]
    >>> [round(place, 12) for place in blocks_at(5.0, 1.0, inner=1.0, outer=3.0)]
    [1.0, 2.0]
    """
    ratio = one_number("mass_ratio", mass_ratio, positive)
    t = one_number("time", time, non_negative)
    x1 = one_number("inner", inner, non_negative)
    x2 = one_number("outer", outer, non_negative)
    if x1 > x2:
        raise ValueError(f"inner must be <= outer, got {x1} and {x2}")
    root = math.sqrt(ratio)
    theta = math.atan(1 / root)
    unfolded = math.hypot(x1, root * (x2 - t)), math.atan2(x1, root * (x2 - t))
    phi = abs(math.remainder(unfolded[1], 2 * theta))
    return unfolded[0] * math.sin(phi), unfolded[0] * math.cos(phi) / root


def hard_disc_compressibility(covered: float) -> float:
    """Return the pressure of a gas of discs relative to that of points, p A / (N T).

    Z = (1 + eta^2 / 8) / (1 - eta)^2

    An approximation, right to a few parts in a thousand up to eta = 0.6.

    Parameters
    ----------
    covered : float
        eta, >= 0, and less than discs can cover at all.

    Returns
    -------
    float
        Z, >= 1.

    Raises
    ------
    ValueError
        eta lies outside its range.

    References
    ----------
    Henderson, A simple equation of state for hard discs, Molecular Physics 30 (1975), 971.

    Examples
    --------
    >>> hard_disc_compressibility(0.0)
    1.0
    >>> round(hard_disc_compressibility(0.5), 3)
    4.125
    """
    eta = _covered(covered)
    return (1 + eta**2 / 8) / (1 - eta) ** 2


def hard_disc_collision_rate(covered: float, diameter: float, mass: float, energy: float) -> float:
    """Return how often a disc of a gas meets another one, 1/s.

    2 sqrt(pi) n sigma sqrt(T / m) chi
    n = 4 eta / (pi sigma^2),   chi = (1 - 7 eta / 16) / (1 - eta)^2

    chi says how much more often than in a thin gas two discs are found in touch. Enskog's theory
    assumes that the velocities of two colliding discs are uncorrelated.

    Parameters
    ----------
    covered : float
        eta, >= 0, and less than discs can cover at all.
    diameter : float
        sigma, m, > 0.
    mass : float
        m, kg, > 0.
    energy : float
        T, J, >= 0: the kinetic energy of all discs over their number.

    Returns
    -------
    float
        Collisions of one disc in a second. In each, two discs take part.

    Raises
    ------
    ValueError
        A number is out of its range.

    References
    ----------
    Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases (1970), chapter 16.

    Examples
    --------
    >>> hard_disc_collision_rate(covered=0.0, diameter=1.0, mass=1.0, energy=1.0)
    0.0
    """
    eta, sigma = _covered(covered), one_number("diameter", diameter, positive)
    m, t = one_number("mass", mass, positive), one_number("energy", energy, non_negative)
    n = 4 * eta / (math.pi * sigma**2)
    chi = (1 - 7 * eta / 16) / (1 - eta) ** 2
    return 2 * math.sqrt(math.pi) * n * sigma * math.sqrt(t / m) * chi


def _covered(value: float) -> float:
    """Return a share of the area that discs can cover, or refuse it."""
    eta = one_number("covered", value, finite)
    if not 0 <= eta < CLOSEST_PACKING:
        raise ValueError(f"covered must be >= 0 and < {CLOSEST_PACKING:.4f}, got {value}")
    return eta

"""When two circles touch if one accelerates against the other: its path is then a parabola.

f(t) = (d + v t + a t^2 / 2)^2 - r^2, with r the sum of the radii, is a polynomial of degree 4. Its
slope is twice the rate g(t) = p . u, with p and u the place and velocity at t: of degree 3. The
slope of g is of degree 2, and its roots are known in closed form. They cut time into pieces in
which g only grows or only falls and so has at most one root; the roots of g cut time into pieces in
which f only grows or only falls. Thus the first fall of f through 0 is found in a bracket that
holds it and no other root, however near they lie to each other.

========  ==================================================================  =======
symbol    meaning                                                             unit
========  ==================================================================  =======
d, v, a   position, velocity and acceleration of the second centre,           m, m/s,
          seen from the first, at t = 0; a is not 0                           m/s^2
p, u      place and velocity at t: d + v t + a t^2 / 2 and v + a t            m, m/s
f         p^2 - r^2, negative when the circles overlap                        m^2
g         p . u, negative when they come nearer; half the slope of f          m^2/s
========  ==================================================================  =======
"""

from __future__ import annotations

import math

MOST_STEPS = 200
"""For one root. Newton's method is slowest at a fourfold root, where a step leaves 3/4 of the
error: 130 steps for 16 digits. Usual are 4 to 8."""

LAST_BIT = 1.2e-16
"""Of the time: a step below half its last bit changes nothing."""


def parabola_impact_time(
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    radius_sum: float,
    since: float,
) -> float:
    """Return when two circles with a relative acceleration first touch and come nearer.

    Approaches that began at or before the time `since` are left out; -1 leaves out none. For all
    else see :func:`lesson_code.geometry.impact_times.circle_impact_time`.

    >>> parabola_impact_time(0.0, 1.0, 0.0, 5.0, 0.0, -10.0, 1.0, -1.0)
    1.0
    """
    start = 0.0
    for end in turning_times(dx, dy, vx, vy, ax, ay):
        middle = 0.5 * (start + end)
        if start < end and start > since and rate(dx, dy, vx, vy, ax, ay, middle) < 0.0:
            if overlap_square(dx, dy, vx, vy, ax, ay, radius_sum, start) <= 0.0:
                return start
            if overlap_square(dx, dy, vx, vy, ax, ay, radius_sum, end) < 0.0:
                return touching_time(dx, dy, vx, vy, ax, ay, radius_sum, start, end)
        start = end
    return math.inf


def turning_times(
    dx: float, dy: float, vx: float, vy: float, ax: float, ay: float
) -> tuple[float, float, float]:
    """Return when the circles change from coming nearer to parting or back, in order, s.

    These are the roots t > 0 of g. Where there are fewer than three, one before is repeated, or 0.
    After the last the circles part for ever.

    A ball thrown up 1 m above a centre turns after 0.5 s and passes the centre after 1.17 s:

    >>> turning_times(0.0, 1.0, 0.0, 5.0, 0.0, -10.0)
    (0.0, 0.5, 1.170820393249937)
    """
    first, second = turns_of_rate(dx, dy, vx, vy, ax, ay)
    last = latest_turning_time(dx, dy, vx, vy, ax, ay)
    t1 = turning_time(dx, dy, vx, vy, ax, ay, 0.0, first, 0.0)
    t2 = turning_time(dx, dy, vx, vy, ax, ay, first, second, t1)
    t3 = turning_time(dx, dy, vx, vy, ax, ay, second, max(second, last), t2)
    return t1, t2, t3


def turns_of_rate(
    dx: float, dy: float, vx: float, vy: float, ax: float, ay: float
) -> tuple[float, float]:
    """Return when g turns, in order, s; 0.0 for what lies before t = 0 or does not exist.

    g' = v . v + d . a + 3 v . a t + (3/2) a . a t^2, in the form that does not cancel.
    """
    c = vx * vx + vy * vy + dx * ax + dy * ay
    b = 1.5 * (vx * ax + vy * ay)
    a = 1.5 * (ax * ax + ay * ay)
    square = b * b - a * c
    if square <= 0.0 or a == 0.0:
        return 0.0, 0.0
    if b > 0.0:  # at most the later one is > 0
        return 0.0, max(0.0, -c / (b + math.sqrt(square)))
    q = math.sqrt(square) - b
    return max(0.0, c / q), q / a


def latest_turning_time(dx: float, dy: float, vx: float, vy: float, ax: float, ay: float) -> float:
    """Return a time after which g > 0: 3 (abs(v) / abs(a) + sqrt(abs(d) / abs(a))), s.

    With x = abs(v) / abs(a) and y^2 = abs(d) / abs(a), whatever the directions,
    g / a^2 >= t^3 / 2 - 3 x t^2 / 2 + (x^2 - y^2) t - x y^2. At t = 3 (x + y), with x + y = 1, that
    is 21/2 - 15 x / 2 - x (1 - x)^2 > 2, and from there on it grows.
    """
    acceleration = math.sqrt(ax * ax + ay * ay)
    speed, distance = math.sqrt(vx * vx + vy * vy), math.sqrt(dx * dx + dy * dy)
    return 3.0 * (speed / acceleration + math.sqrt(distance / acceleration))


def turning_time(
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    low: float,
    high: float,
    otherwise: float,
) -> float:
    """Return the root of g between two times, where g only grows or only falls; or `otherwise`.

    A rate of 0 counts as parting, so that signs at the ends of the pieces fit together.
    """
    rate_low = rate(dx, dy, vx, vy, ax, ay, low)
    is_nearing_at_low = rate_low < 0.0
    if is_nearing_at_low == (rate(dx, dy, vx, vy, ax, ay, high) < 0.0):
        return otherwise
    if rate_low == 0.0:
        return low
    t = 0.5 * (low + high)
    for _ in range(MOST_STEPS):
        px, py, ux, uy = place_and_velocity(dx, dy, vx, vy, ax, ay, t)
        g = px * ux + py * uy
        if (g < 0.0) == is_nearing_at_low:
            low = t
        else:
            high = t
        before = t
        t = next_guess(t, g, ux * ux + uy * uy + px * ax + py * ay, low, high)
        if abs(t - before) <= LAST_BIT * t:
            break
    return t


def touching_time(
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    radius_sum: float,
    low: float,
    high: float,
) -> float:
    """Return the root of f between two times between which the circles come nearer, s."""
    t = 0.5 * (low + high)
    for _ in range(MOST_STEPS):
        f = overlap_square(dx, dy, vx, vy, ax, ay, radius_sum, t)
        if f > 0.0:
            low = t
        else:
            high = t
        before = t
        t = next_guess(t, f, 2.0 * rate(dx, dy, vx, vy, ax, ay, t), low, high)
        if abs(t - before) <= LAST_BIT * t:
            break
    return t


def next_guess(t: float, value: float, slope: float, low: float, high: float) -> float:
    """Return Newton's next guess for a root or, if that leaves the bracket, the bracket's middle.

    >>> next_guess(3.0, 3.0, 6.0, 0.0, 3.0), next_guess(3.0, 3.0, 0.0, 0.0, 3.0)
    (2.5, 1.5)
    """
    if slope != 0.0:
        guess = t - value / slope
        if low <= guess <= high:
            return guess
    return 0.5 * (low + high)


def overlap_square(
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    radius_sum: float,
    t: float,
) -> float:
    """Return f = p^2 - r^2, with as few digits lost as the numbers allow.

    Early on p = d + s is known best by its change s = v t + a t^2 / 2, and
    f = (abs(d) - r) (abs(d) + r) + s . (2 d + s). Later it is the distance that counts:
    f = (abs(p) - r) (abs(p) + r), with r the sum of the radii.
    """
    sx, sy = t * (vx + 0.5 * t * ax), t * (vy + 0.5 * t * ay)
    if abs(sx) + abs(sy) < radius_sum:
        distance = math.sqrt(dx * dx + dy * dy)
        change = sx * (2.0 * dx + sx) + sy * (2.0 * dy + sy)
        return (distance - radius_sum) * (distance + radius_sum) + change
    px, py = dx + sx, dy + sy
    distance = math.sqrt(px * px + py * py)
    return (distance - radius_sum) * (distance + radius_sum)


def rate(dx: float, dy: float, vx: float, vy: float, ax: float, ay: float, t: float) -> float:
    """Return g = p . u, m^2/s."""
    px, py, ux, uy = place_and_velocity(dx, dy, vx, vy, ax, ay, t)
    return px * ux + py * uy


def place_and_velocity(
    dx: float, dy: float, vx: float, vy: float, ax: float, ay: float, t: float
) -> tuple[float, float, float, float]:
    """Return p = d + v t + a t^2 / 2 and u = v + a t."""
    return dx + t * (vx + 0.5 * t * ax), dy + t * (vy + 0.5 * t * ay), vx + t * ax, vy + t * ay

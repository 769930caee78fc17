"""When a moving circle first touches a flat face, another circle, or an outline that does not turn.

Between impacts a body that nothing touches moves along d + v t + a t^2 / 2. Its impact is then the
root of a polynomial: of degree 2 for a face, or for a circle without acceleration, and of degree 4
for a circle with acceleration. Nothing is sampled and nothing is stepped, so that nothing is
missed at any speed.

One rule serves all functions. The impact is the earliest time t >= 0 at which the shapes touch or
overlap and come nearer right after t:

- apart, and they will meet: the time at which they touch;
- touching or overlapping, and coming nearer: now, 0.0;
- touching or overlapping, and parting: not that contact. With acceleration they may come back: then
  the time at which they touch again or, if they never part fully, at which they turn back;
- grazing, touching without ever overlapping: no impact, as touching is not overlapping.

No impact is ``math.inf`` here, which compares as a time should; the public door,
:func:`lesson_code.geometry.time_of_impact`, makes None of it.

========  ==================================================================  =======
symbol    meaning                                                             unit
========  ==================================================================  =======
d, v, a   position, velocity and acceleration of the (second) circle's        m, m/s,
          centre, seen from the other body                                    m/s^2
r         sum of the radii: the distance between centres that touch           m
gap       distance between the surfaces, negative when they overlap           m
n         outward unit normal of a face                                       -
========  ==================================================================  =======
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.geometry.nearest_feature import (
    is_approaching,
    is_corner_hit,
    is_nearest,
    nearest_feature,
    path_point,
)
from lesson_code.geometry.parabola import parabola_impact_time
from lesson_code.geometry.rows import Corner, PlacedBody
from lesson_code.geometry.straight_impact_times import (
    straight_face_time,
    straight_impact_time,
    straight_outline_impact_time,
)


def line_impact_time(gap: float, v: float, a: float) -> float:
    """Return when a height falls to 0: a circle's impact on a flat face without ends.

    gap + v t + a t^2 / 2 = 0,   while falling

    The quadratic is solved in the form that does not subtract nearly equal numbers.

    Parameters
    ----------
    gap : float
        Distance from the face to the circle's surface, m; negative when they overlap.
    v, a : float
        Velocity and acceleration of the circle along the face's outward normal, m/s and m/s^2.

    Returns
    -------
    float
        Time of impact, s, >= 0; inf for none. A caller that has just resolved an impact knows the
        gap to be 0 and should say so: a rounding of it is a fault if the bounce is as small.

    Examples
    --------
    A ball 5 m above the floor, let go, with g = 10 m/s^2; then thrown up from the floor at 5 m/s:

    >>> line_impact_time(5.0, 0.0, -10.0)
    1.0
    >>> line_impact_time(0.0, 5.0, -10.0)
    1.0
    >>> line_impact_time(0.0, -5.0, -10.0)
    0.0
    """
    if a == 0.0:
        return straight_face_time(gap, v)
    if gap <= 0.0 and (v < 0.0 or (v == 0.0 and a < 0.0)):
        return 0.0
    if v >= 0.0 and a >= 0.0:
        return math.inf
    square = v * v - 2.0 * a * gap  # of the speed at which it arrives
    if v >= 0.0:  # up first, then down; if it turns below the face, at the turn
        return (v + math.sqrt(max(square, 0.0))) / -a
    if square <= 0.0:
        return math.inf  # turns before the face, or just on it
    return 2.0 * gap / (math.sqrt(square) - v)


def circle_impact_time(
    dx: float, dy: float, vx: float, vy: float, ax: float, ay: float, radius_sum: float
) -> float:
    """Return when two circles touch and come nearer.

    abs(d + v t + a t^2 / 2) = radius_sum

    Parameters
    ----------
    dx, dy, vx, vy, ax, ay : float
        Position, velocity and acceleration of the second centre, seen from the first; m, s.
    radius_sum : float
        Sum of the radii, m, >= 0.

    Returns
    -------
    float
        Time of impact, s, >= 0; inf for none.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 5.5.5, for circles without acceleration.

    Examples
    --------
    Two discs of radius 0.5 m, 4 m apart, closing at 2 m/s; then grazing; then a ball thrown up from
    the top of a disc at rest:

    >>> circle_impact_time(4.0, 0.0, -2.0, 0.0, 0.0, 0.0, 1.0)
    1.5
    >>> circle_impact_time(4.0, 1.0, -2.0, 0.0, 0.0, 0.0, 1.0)
    inf
    >>> circle_impact_time(0.0, 1.0, 0.0, 5.0, 0.0, -10.0, 1.0)
    1.0
    """
    if ax * ax + ay * ay == 0.0:
        return straight_impact_time(dx, dy, vx, vy, radius_sum)
    return parabola_impact_time(dx, dy, vx, vy, ax, ay, radius_sum, -1.0)


def circle_outline_impact_time(
    corners: Sequence[Corner],
    body: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    radius: float,
) -> tuple[float, int]:
    """Return when a circle touches a polygon or segment that does not turn, and where.

    The circle's centre touches the outline rounded by radius_sum, the sum of both radii: flat
    faces, shifted outwards by it, with a circle about every corner. The impact is the earliest
    with a face or a corner that is the nearest part of the outline then.

    Parameters
    ----------
    corners : sequence of Corner
        Table with the outline's corners, turned with the body.
    body : PlacedBody
        The outline's row.
    dx, dy, vx, vy, ax, ay : float
        Position, velocity and acceleration of the circle's centre, seen from the outline's
        position; m, s.
    radius : float
        Of the circle, m, >= 0.

    Returns
    -------
    (time, feature) : (float, int)
        Time of impact, s, >= 0, inf for none; and what is hit: k >= 0 for the face of the edge
        that starts at corner k of the table, -1 - k for corner k itself. Without an impact the
        feature is the one that is nearest now.

    Examples
    --------
    A ball of radius 0.625 m falls on a floor; far to the right it hits the end of the floor:

    >>> from lesson_code.geometry.rows import place
    >>> corners = []
    >>> floor = place([(9.0, 0.0), (-9.0, 0.0)], 0.0, (0.0, 0.0, 0.0), corners)
    >>> circle_outline_impact_time(corners, floor, 0.0, 2.625, 0.0, -1.0, 0.0, 0.0, 0.625)
    (2.0, 0)
    >>> circle_outline_impact_time(corners, floor, 9.375, 2.5, 0.0, -1.0, 0.0, 0.0, 0.625)
    (2.0, -1)
    """
    if ax == 0.0 and ay == 0.0:
        return straight_outline_impact_time(corners, body, dx, dy, vx, vy, radius)
    radius_sum = radius + body.radius
    distance, feature = nearest_feature(corners, body, dx, dy)
    if distance <= radius_sum and is_approaching(corners, feature, dx, dy, vx, vy, ax, ay):
        return 0.0, feature
    time, soonest = first_face_time(corners, body, dx, dy, vx, vy, ax, ay, radius_sum)
    if soonest < time:  # else no corner can be hit before
        time = min(time, first_corner_time(corners, body, dx, dy, vx, vy, ax, ay, radius_sum))
    if time < math.inf:
        px, py = path_point(dx, dy, vx, vy, ax, ay, time)
        _, feature = nearest_feature(corners, body, px, py)
    return time, feature


def first_face_time(
    corners: Sequence[Corner],
    body: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    radius_sum: float,
) -> tuple[float, float]:
    """Return the earliest impact on a face, > 0, and a time before which nothing can be hit.

    A circle that touches the outline is at most level with all its faces. It cannot do so before
    it has fallen to the last of those that it is above; if it never falls to one, it never does.
    """
    time, soonest = math.inf, 0.0
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        gap = (dx - c.x) * c.nx + (dy - c.y) * c.ny - radius_sum
        t = line_impact_time(gap, vx * c.nx + vy * c.ny, ax * c.nx + ay * c.ny)
        if gap > 0.0 and t > soonest:
            soonest = t
        if 0.0 < t < time:
            px, py = path_point(dx, dy, vx, vy, ax, ay, t)
            if is_nearest(corners, body, (px - c.x) * c.nx + (py - c.y) * c.ny, c, px, py):
                time = t
    return time, soonest


def first_corner_time(
    corners: Sequence[Corner],
    body: PlacedBody,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    radius_sum: float,
) -> float:
    """Return the earliest impact on a corner, > 0.

    A circle that is leaving a face may meet a corner's circle inside the outline, where the corner
    is not the nearest part. Then its second approach to the corner counts; it has at most two.
    """
    time, is_accelerated = math.inf, ax * ax + ay * ay > 0.0
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        t = circle_impact_time(dx - c.x, dy - c.y, vx, vy, ax, ay, radius_sum)
        if t < time and is_corner_hit(corners, body, c, dx, dy, vx, vy, ax, ay, t):
            time = t
        elif t < time and is_accelerated:
            t = parabola_impact_time(dx - c.x, dy - c.y, vx, vy, ax, ay, radius_sum, t)
            if t < time and is_corner_hit(corners, body, c, dx, dy, vx, vy, ax, ay, t):
                time = t
    return time

"""Which face or corner of an outline is nearest to a point, and whether the point comes nearer."""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.geometry.circle_contact import is_on_line
from lesson_code.geometry.rows import Corner, PlacedBody, following
from lesson_code.geometry.sat import TIE


def nearest_feature(
    corners: Sequence[Corner], body: PlacedBody, px: float, py: float
) -> tuple[float, int]:
    """Return the distance from a point to an outline, without its rounding, and to which part.

    The distance is negative inside a polygon, and the part is then the nearest face. Features are
    numbered as in :func:`lesson_code.geometry.impact_times.circle_outline_impact_time`, and chosen
    as the narrow phase chooses.
    """
    height, edge = -math.inf, -1
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        along = (px - c.x) * c.nx + (py - c.y) * c.ny
        if along > height:
            height, edge = along, k
    next_edge = following(body, edge)
    face, end = corners[edge], corners[next_edge]
    if body.corner_count == 2 and is_on_line(px, py, face, end):
        height, edge, next_edge = 0.0, body.first_corner, body.first_corner + 1
        face, end = corners[edge], corners[next_edge]
    from_start = (px - face.x) * -face.ny + (py - face.y) * face.nx
    from_end = (px - end.x) * -face.ny + (py - end.y) * face.nx
    inside = height <= 0.0 and body.corner_count > 2
    if inside or from_start >= 0.0 >= from_end:
        return height, edge
    k = edge if from_start < 0.0 else next_edge
    c = corners[k]
    away_x, away_y = px - c.x, py - c.y
    distance = math.sqrt(away_x * away_x + away_y * away_y)
    lengths = abs(px) + abs(py) + abs(face.x) + abs(face.y) + abs(c.x) + abs(c.y)
    if distance <= TIE * lengths:  # at the corner, from where no direction leads
        return height, edge
    return distance, -1 - k


def is_nearest(
    corners: Sequence[Corner], body: PlacedBody, distance: float, c: Corner, px: float, py: float
) -> bool:
    """Return whether a face or corner this far from a point is the nearest part, but for rounding.

    Where a face ends and the circle about its corner begins, both are: neither must be missed.
    """
    nearest, _ = nearest_feature(corners, body, px, py)
    lengths = abs(px) + abs(py) + abs(c.x) + abs(c.y)
    return abs(nearest - distance) <= TIE * lengths


def is_corner_hit(
    corners: Sequence[Corner],
    body: PlacedBody,
    c: Corner,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    t: float,
) -> bool:
    """Return whether a corner is the nearest part of the outline at a time > 0."""
    px, py = path_point(dx, dy, vx, vy, ax, ay, t)
    distance = math.sqrt((px - c.x) * (px - c.x) + (py - c.y) * (py - c.y))
    return t > 0.0 and is_nearest(corners, body, distance, c, px, py)


def is_approaching(
    corners: Sequence[Corner],
    feature: int,
    px: float,
    py: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
) -> bool:
    """Return whether a point comes nearer to a face or corner: the first derivative that is not 0.

    Of a face's height these are v . n and a . n; of half the squared distance to a corner,
    r . v, then v . v + r . a, then v . a, with r from the corner to the point.
    """
    if feature >= 0:
        c = corners[feature]
        speed = vx * c.nx + vy * c.ny
        return speed < 0.0 or (speed == 0.0 and ax * c.nx + ay * c.ny < 0.0)
    c = corners[-1 - feature]
    rx, ry = px - c.x, py - c.y
    rate = rx * vx + ry * vy
    if rate == 0.0:
        rate = vx * vx + vy * vy + rx * ax + ry * ay
    if rate == 0.0:
        rate = vx * ax + vy * ay
    return rate < 0.0


def path_point(
    dx: float, dy: float, vx: float, vy: float, ax: float, ay: float, t: float
) -> tuple[float, float]:
    """Return the centre's place at a time: d + v t + a t^2 / 2."""
    return dx + t * (vx + 0.5 * t * ax), dy + t * (vy + 0.5 * t * ay)

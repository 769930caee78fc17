"""How far apart two shapes are, at any angle: the distance of convex outlines, with sign.

Apart, it is the shortest distance between the surfaces. Overlapping, it is negative: minus the
shortest way out. Both are the distance of one point, B's position seen from A's, from the outline
of all places at which B would touch A: a convex polygon whose edges are those of A and of B. Its
nearest part is always the edge that the point is farthest above, or one of that edge's ends. So the
separating axis theorem leaves two edges to look at, one of A and one of B.

A body's corners are read where they are when its angle is 0, and directions are turned into its
frame instead: angles can be tried without changing a table.

========  ==================================================================  =====
symbol    meaning                                                             unit
========  ==================================================================  =====
d         B's position, seen from A's                                         m
n         unit direction from A to B, in the world                            -
m         the same direction seen by a body: turned back by its angle         -
gap       distance along n between the outlines, without their rounding       m
========  ==================================================================  =====
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

from lesson_code.geometry.edges import closest_on_edge, direction
from lesson_code.geometry.rows import Corner
from lesson_code.geometry.sat import TIE


class Outline(Protocol):
    """The fields of a body that say what it is made of; see :class:`PlacedBody`."""

    radius: float
    first_corner: int
    corner_count: int


class RelativePose(NamedTuple):
    """Where two bodies are: B's position seen from A's, m, and the cosine and sine of angles."""

    dx: float
    dy: float
    cos_a: float
    sin_a: float
    cos_b: float
    sin_b: float


def separation_rows(
    corners: Sequence[Corner], a: Outline, b: Outline, at: RelativePose
) -> tuple[float, float, float]:
    """Return the distance between two bodies, m, negative when they overlap, and its direction.

    The direction, of two numbers, is the unit normal from A to B.
    """
    radius_sum = a.radius + b.radius
    if a.corner_count == 0 and b.corner_count == 0:
        distance, nx, ny = direction(at.dx, at.dy, 1.0, 0.0)
        return distance - radius_sum, nx, ny
    gap_a, edge_a = best_face(corners, a, b, at)
    back = seen_from_b(at)
    gap_b, edge_b = best_face(corners, b, a, back)
    if gap_a >= gap_b:
        gap, nx, ny = from_face(corners, a, b, at, gap_a, edge_a)
    else:
        gap, nx, ny = from_face(corners, b, a, back, gap_b, edge_b)
        nx, ny = 0.0 - nx, 0.0 - ny
    return gap - radius_sum, nx, ny


def seen_from_b(at: RelativePose) -> RelativePose:
    """Return where two bodies are, with A and B exchanged."""
    return RelativePose(0.0 - at.dx, 0.0 - at.dy, at.cos_b, at.sin_b, at.cos_a, at.sin_a)


def best_face(
    corners: Sequence[Corner], a: Outline, b: Outline, at: RelativePose
) -> tuple[float, int]:
    """Return the largest gap along the outward normals of A's edges, m, and that edge.

    A circle has no edges: its gap is minus infinity.
    """
    most, edge = -math.inf, -1
    for k in range(a.first_corner, a.first_corner + a.corner_count):
        gap = face_gap(corners, b, at, k)
        if gap > most:
            most, edge = gap, k
    return most, edge


def face_gap(corners: Sequence[Corner], b: Outline, at: RelativePose, k: int) -> float:
    """Return how far B lies above one of A's edges: its lowest corner; negative below it, m."""
    c = corners[k]
    nx, ny = face_normal(corners, at, k)
    along = at.dx * nx + at.dy * ny - (c.local_x * c.local_nx + c.local_y * c.local_ny)
    mx, my = seen_turned(-nx, -ny, at.cos_b, at.sin_b)
    return along - farthest(corners, b, mx, my)


def face_normal(corners: Sequence[Corner], at: RelativePose, k: int) -> tuple[float, float]:
    """Return the outward unit normal of one of A's edges, turned with A."""
    c = corners[k]
    nx = at.cos_a * c.local_nx - at.sin_a * c.local_ny
    return nx, at.sin_a * c.local_nx + at.cos_a * c.local_ny


def seen_turned(nx: float, ny: float, cos: float, sin: float) -> tuple[float, float]:
    """Return a direction of the world as a body sees it that is turned by an angle.

    >>> seen_turned(0.0, 1.0, 0.0, 1.0)
    (1.0, 0.0)
    """
    return cos * nx + sin * ny, cos * ny - sin * nx


def farthest(corners: Sequence[Corner], body: Outline, mx: float, my: float) -> float:
    """Return how far a body's outline reaches along m, seen by the body, m; 0 for a circle."""
    if body.corner_count == 0:
        return 0.0
    most = -math.inf
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        along = corners[k].local_x * mx + corners[k].local_y * my
        if along > most:
            most = along
    return most


def from_face(
    corners: Sequence[Corner], a: Outline, b: Outline, at: RelativePose, gap: float, edge: int
) -> tuple[float, float, float]:
    """Return the distance between the outlines, and its direction, given the best face.

    It is the gap along the face's normal, unless the nearest points are farther than that: then
    they are two corners, and the direction leads from one to the other.
    """
    nx, ny = face_normal(corners, at, edge)
    c = corners[edge]
    lengths = abs(at.dx) + abs(at.dy) + abs(c.local_x) + abs(c.local_y)
    if gap >= -TIE * lengths:
        x, y = gap_from_edge(corners, a, b, at, edge)
        distance, ux, uy = direction(x, y, nx, ny)
        if distance - gap > TIE * lengths:
            return distance, ux, uy
    return gap, nx, ny


def gap_from_edge(
    corners: Sequence[Corner], a: Outline, b: Outline, at: RelativePose, edge: int
) -> tuple[float, float]:
    """Return the shortest vector from an edge of A to the edge of B that faces it.

    One of the two points that it joins is an end of an edge, so four vectors are compared.
    """
    nx, ny = face_normal(corners, at, edge)
    a0x, a0y, a1x, a1y = edge_ends(corners, a, edge, 0.0, 0.0, at.cos_a, at.sin_a)
    facing = facing_edge(corners, b, nx, ny, at.cos_b, at.sin_b)
    b0x, b0y, b1x, b1y = edge_ends(corners, b, facing, at.dx, at.dy, at.cos_b, at.sin_b)
    x, y = shortest_to_edge(b0x, b0y, b1x, b1y, a0x, a0y, a1x, a1y)
    back_x, back_y = shortest_to_edge(a0x, a0y, a1x, a1y, b0x, b0y, b1x, b1y)
    if back_x * back_x + back_y * back_y < x * x + y * y:
        return back_x, back_y
    return 0.0 - x, 0.0 - y


def edge_ends(
    corners: Sequence[Corner], body: Outline, edge: int, x: float, y: float, cos: float, sin: float
) -> tuple[float, float, float, float]:
    """Return both ends of an edge of a body at (x, y); for a circle its centre, twice."""
    if body.corner_count == 0:
        return x, y, x, y
    last = body.first_corner + body.corner_count - 1
    c, e = corners[edge], corners[body.first_corner if edge == last else edge + 1]
    return (
        x + (cos * c.local_x - sin * c.local_y),
        y + (sin * c.local_x + cos * c.local_y),
        x + (cos * e.local_x - sin * e.local_y),
        y + (sin * e.local_x + cos * e.local_y),
    )


def facing_edge(
    corners: Sequence[Corner], body: Outline, nx: float, ny: float, cos: float, sin: float
) -> int:
    """Return the edge of a body whose outward normal is most against n; -1 for a circle."""
    mx, my = seen_turned(nx, ny, cos, sin)
    least, edge = math.inf, -1
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        along = corners[k].local_nx * mx + corners[k].local_ny * my
        if along < least:
            least, edge = along, k
    return edge


def shortest_to_edge(
    p0x: float,
    p0y: float,
    p1x: float,
    p1y: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
) -> tuple[float, float]:
    """Return the shorter of the vectors from two points to the points of an edge closest to them.

    >>> shortest_to_edge(1.0, 3.0, 2.0, 2.0, 0.0, 0.0, 4.0, 0.0)
    (0.0, -2.0)
    """
    _, ux, uy = direction(bx - ax, by - ay, 1.0, 0.0)
    c0x, c0y = closest_on_edge(p0x, p0y, ax, ay, bx, by, ux, uy)
    c1x, c1y = closest_on_edge(p1x, p1y, ax, ay, bx, by, ux, uy)
    x0, y0, x1, y1 = c0x - p0x, c0y - p0y, c1x - p1x, c1y - p1y
    return (x1, y1) if x1 * x1 + y1 * y1 < x0 * x0 + y0 * y0 else (x0, y0)

"""Contacts of circles: with each other, and with polygons and segments.

A circle touches anything at one point, so that all its contacts have the feature id 0: a ball that
rolls from an edge round a corner keeps its contact. The functions fill a ManifoldRow, whose
count is 0 when they are called.
"""

from __future__ import annotations

from collections.abc import Sequence

from lesson_code.geometry.edges import direction
from lesson_code.geometry.rows import Corner, ManifoldRow, PlacedBody, following
from lesson_code.geometry.sat import TIE, least_overlap, lengths_involved

FAR = 1.0 + 1e-15
"""Of the square of the radius sum: beyond it there is no overlap, and no root needs to be taken."""


def collide_circles(a: PlacedBody, b: PlacedBody, m: ManifoldRow) -> None:
    """Fill the manifold of two circles; its count is 0 when they do not overlap.

    n = d / abs(d),   penetration = radius_a + radius_b - abs(d)

    d leads from A's centre to B's. Coincident centres get the normal (1, 0).
    """
    m.count = 0
    dx, dy, radius_sum = b.x - a.x, b.y - a.y, a.radius + b.radius
    if dx * dx + dy * dy > FAR * radius_sum * radius_sum:
        return
    distance, nx, ny = direction(dx, dy, 1.0, 0.0)
    penetration = radius_sum - distance
    if penetration > 0.0:
        fill_single(m, nx, ny, nx * a.radius, ny * a.radius, b.radius, penetration)


def collide_outline_circle(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, m: ManifoldRow
) -> None:
    """Fill the manifold of a polygon or segment A and a circle B.

    The edge with the least overlap decides. A centre inside the outline, on that edge or straight
    above it is pushed along the edge's normal; any other is pushed away from the edge's nearer
    end. A segment has two edges, its left side first; it pushes a centre on it to the left.
    """
    overlap, edge = least_overlap(corners, a, b)
    radius_sum = a.radius + b.radius
    if overlap + radius_sum <= 0.0:
        return
    px, py = b.x - a.x, b.y - a.y
    if a.corner_count == 2 and is_on_line(px, py, corners[edge], corners[following(a, edge)]):
        overlap, edge = 0.0, a.first_corner
    face, end = corners[edge], corners[following(a, edge)]
    # Along the edge, whose direction is the normal turned by +90 degrees: before, on or beyond it?
    from_start = (px - face.x) * -face.ny + (py - face.y) * face.nx
    from_end = (px - end.x) * -face.ny + (py - end.y) * face.nx
    inside = overlap >= 0.0 and a.corner_count > 2
    if inside or from_start >= 0.0 >= from_end:
        shift = a.radius + overlap  # from the centre along n to A's surface
        ax, ay = px + face.nx * shift, py + face.ny * shift
        fill_single(m, face.nx, face.ny, ax, ay, b.radius, overlap + radius_sum)
    else:
        push_from_corner(m, a, face, face if from_start < 0.0 else end, b)


def is_on_line(px: float, py: float, start: Corner, end: Corner) -> bool:
    """Return whether a point lies on the line through two corners: (p - a) x (b - a) = 0."""
    return (px - start.x) * (end.y - start.y) == (py - start.y) * (end.x - start.x)


def push_from_corner(
    m: ManifoldRow, a: PlacedBody, face: Corner, corner: Corner, b: PlacedBody
) -> None:
    """Fill the manifold of a corner of A, rounded by A's radius, and a circle B.

    A centre at the corner, but for rounding, has no sure direction; it takes the face's normal.
    """
    away_x, away_y = b.x - a.x - corner.x, b.y - a.y - corner.y
    distance, nx, ny = direction(away_x, away_y, face.nx, face.ny)
    if distance <= TIE * lengths_involved(a, b, face, corner):
        nx, ny = face.nx, face.ny
    penetration = a.radius + b.radius - distance
    if penetration > 0.0:
        ax, ay = corner.x + nx * a.radius, corner.y + ny * a.radius
        fill_single(m, nx, ny, ax, ay, b.radius, penetration)


def fill_single(
    m: ManifoldRow,
    nx: float,
    ny: float,
    ax: float,
    ay: float,
    radius_b: float,
    penetration: float,
) -> None:
    """Write one contact: the normal, the point on A, and the point on the circle B, -n radius."""
    m.count = 1
    m.nx, m.ny = nx, ny
    m.ax0, m.ay0 = ax, ay
    m.bx0, m.by0 = 0.0 - nx * radius_b, 0.0 - ny * radius_b
    m.penetration0 = penetration
    m.feature0 = 0

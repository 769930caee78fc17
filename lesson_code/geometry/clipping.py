"""Contacts of two outlines, polygons or segments: one or two points.

The normal comes first: that of the edge with the least overlap, or, where rounded outlines lie
apart and only their rounding overlaps, the direction between their nearest points. Then the two
edges that face each other along the normal are cut to the stretch that they share along the
tangent. At each end of that stretch lies a point on A's edge and one on B's; they are a contact
if they overlap.

A feature id says which edge of A meets which edge of B, and at which end of the stretch. It does
not say whose normal it was, so that it stays when rounding makes the other edge the better one.

========  ================================================================  =====
symbol    meaning                                                           unit
========  ================================================================  =====
n, t      unit normal from A to B; tangent, n turned by +90 degrees         -
s         place along t, seen from A's position                             m
r         sum of both roundings                                             m
depth     overlap of the rounded outlines along n                           m
========  ================================================================  =====
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.geometry.edges import closest_on_edge, direction
from lesson_code.geometry.rows import Corner, ManifoldRow, PlacedBody, following
from lesson_code.geometry.sat import TIE, lengths_involved, minimum_translation


def collide_outlines(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, m: ManifoldRow
) -> None:
    """Fill the manifold of two outlines, whose count is 0 when this is called."""
    overlap, nx, ny, edge, is_of_a = minimum_translation(corners, a, b)
    radius_sum = a.radius + b.radius
    if overlap + radius_sum <= 0.0:
        return
    edge_a = edge if is_of_a else facing_edge(corners, a, nx, ny)
    edge_b = facing_edge(corners, b, -nx, -ny) if is_of_a else edge
    rounding_error = TIE * lengths_involved(a, b, corners[edge_a], corners[edge_b])
    if radius_sum > 0.0 and overlap <= rounding_error:
        gap_x, gap_y = nearest_gap(corners, a, edge_a, b, edge_b)
        gap, to_b_x, to_b_y = direction(gap_x, gap_y, nx, ny)
        # Farther than the face is: corner against corner. Outlines that overlap by a rounding error
        # have a gap, too, but it points back, or anywhere if it is a rounding error itself.
        is_farther = gap + min(overlap, 0.0) > rounding_error
        if is_farther and to_b_x * nx + to_b_y * ny > -0.5:
            nx, ny, overlap = to_b_x, to_b_y, -gap
            edge_a = facing_edge(corners, a, nx, ny)
            edge_b = facing_edge(corners, b, -nx, -ny)
    if overlap + radius_sum > 0.0:
        m.nx, m.ny = nx, ny
        cut_to_shared(corners, a, edge_a, b, edge_b, m)
    if m.count > 0:
        measure_penetrations(a, b, m)
        keep_overlapping(m, overlap + radius_sum)


def facing_edge(corners: Sequence[Corner], body: PlacedBody, nx: float, ny: float) -> int:
    """Return the table index of the edge whose outward normal is most along (nx, ny)."""
    most, edge = -math.inf, -1
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        along = corners[k].nx * nx + corners[k].ny * ny
        if along > most:
            most, edge = along, k
    return edge


def nearest_gap(
    corners: Sequence[Corner], a: PlacedBody, edge_a: int, b: PlacedBody, edge_b: int
) -> tuple[float, float]:
    """Return the shortest vector from an edge of A to an edge of B that does not cross it.

    One of the two points that it joins is an end of an edge, so four vectors are compared.
    """
    dx, dy = b.x - a.x, b.y - a.y
    start_a, end_a = corners[edge_a], corners[following(a, edge_a)]
    start_b, end_b = corners[edge_b], corners[following(b, edge_b)]
    x, y = towards_edge(start_a.x - dx, start_a.y - dy, start_b, end_b)
    next_x, next_y = towards_edge(end_a.x - dx, end_a.y - dy, start_b, end_b)
    x, y = shorter(x, y, next_x, next_y)
    next_x, next_y = towards_edge(start_b.x + dx, start_b.y + dy, start_a, end_a)
    x, y = shorter(x, y, -next_x, -next_y)
    next_x, next_y = towards_edge(end_b.x + dx, end_b.y + dy, start_a, end_a)
    return shorter(x, y, -next_x, -next_y)


def towards_edge(px: float, py: float, start: Corner, end: Corner) -> tuple[float, float]:
    """Return the vector from a point to the closest point of an edge."""
    cx, cy = closest_on_edge(px, py, start.x, start.y, end.x, end.y, -start.ny, start.nx)
    return cx - px, cy - py


def shorter(ax: float, ay: float, bx: float, by: float) -> tuple[float, float]:
    """Return the shorter of two vectors."""
    return (bx, by) if bx * bx + by * by < ax * ax + ay * ay else (ax, ay)


def cut_to_shared(
    corners: Sequence[Corner],
    a: PlacedBody,
    edge_a: int,
    b: PlacedBody,
    edge_b: int,
    m: ManifoldRow,
) -> None:
    """Write both ends of the stretch that two edges share along the tangent of the manifold.

    A's edge runs with the tangent, B's against it: the start of A's lies near the end of B's. A
    stretch without length counts as one point; no stretch leaves the count at 0.
    """
    tx, ty = -m.ny, m.nx
    dx, dy = b.x - a.x, b.y - a.y
    start_a, end_a = corners[edge_a], corners[following(a, edge_a)]
    start_b, end_b = corners[edge_b], corners[following(b, edge_b)]
    s_start_a, s_end_a = start_a.x * tx + start_a.y * ty, end_a.x * tx + end_a.y * ty
    s_start_b = (start_b.x + dx) * tx + (start_b.y + dy) * ty
    s_end_b = (end_b.x + dx) * tx + (end_b.y + dy) * ty
    low, high = max(s_start_a, s_end_b), min(s_end_a, s_start_b)
    no_length = TIE * lengths_involved(a, b, start_a, start_b)
    if high - low < -no_length:
        return
    m.count = 2 if high - low > no_length else 1
    m.ax0, m.ay0 = point_at(low, start_a, s_start_a, end_a, s_end_a)
    m.bx0, m.by0 = point_at(low, end_b, s_end_b, start_b, s_start_b)
    m.ax1, m.ay1 = point_at(high, end_a, s_end_a, start_a, s_start_a)
    m.bx1, m.by1 = point_at(high, start_b, s_start_b, end_b, s_end_b)
    pair = (edge_a - a.first_corner) * b.corner_count + edge_b - b.first_corner
    m.feature0, m.feature1 = 2 * pair, 2 * pair + 1


def point_at(
    s: float, start: Corner, s_start: float, end: Corner, s_end: float
) -> tuple[float, float]:
    """Return the point of an edge at the place s of its tangent; outside the edge, that end."""
    if (s - s_start) * (s_end - s_start) <= 0.0:
        return start.x, start.y
    part = min((s - s_start) / (s_end - s_start), 1.0)
    return start.x + part * (end.x - start.x), start.y + part * (end.y - start.y)


def measure_penetrations(a: PlacedBody, b: PlacedBody, m: ManifoldRow) -> None:
    """Move the points from the outlines to the rounded surfaces, and measure the penetrations.

    penetration = (position_A + a - position_B - b) . n
    """
    m.ax0, m.ay0 = m.ax0 + m.nx * a.radius, m.ay0 + m.ny * a.radius
    m.ax1, m.ay1 = m.ax1 + m.nx * a.radius, m.ay1 + m.ny * a.radius
    m.bx0, m.by0 = m.bx0 - m.nx * b.radius, m.by0 - m.ny * b.radius
    m.bx1, m.by1 = m.bx1 - m.nx * b.radius, m.by1 - m.ny * b.radius
    dx, dy = b.x - a.x, b.y - a.y
    m.penetration0 = (m.ax0 - m.bx0 - dx) * m.nx + (m.ay0 - m.by0 - dy) * m.ny
    m.penetration1 = (m.ax1 - m.bx1 - dx) * m.nx + (m.ay1 - m.by1 - dy) * m.ny


def keep_overlapping(m: ManifoldRow, depth: float) -> None:
    """Keep the points that overlap; of a stretch without length, the deeper one.

    The deeper point overlaps by the depth. Where that is so small that rounding has left no
    penetration, it is given it.
    """
    if m.count == 2 and m.penetration0 > 0.0 and m.penetration1 > 0.0:
        return
    if m.penetration1 > m.penetration0:
        m.ax0, m.ay0, m.bx0, m.by0 = m.ax1, m.ay1, m.bx1, m.by1
        m.penetration0, m.feature0 = m.penetration1, m.feature1
    if m.penetration0 <= 0.0:
        m.penetration0 = depth
    m.count = 1

"""Unusual right answers to chapter 06: separating axes, clipping, circle against polygon."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import alternative
from lesson_code.geometry import closest_point_on_segment, project, sat_axes

Vector: TypeAlias = Any


@alternative("6.1")
def as_complex_numbers(vertices: Vector) -> list[complex]:
    """An edge turned by -90 degrees is its number times -i; the last edge comes first."""
    z = [complex(x, y) for x, y in vertices]
    edges = [z[k] - z[k - 1] for k in range(len(z))]
    return [-1j * edge / abs(edge) for edge in edges if edge]


@alternative("6.1")
def inward_and_backward(vertices: Vector) -> Vector:
    """The normals point inward, in the opposite order, as one array."""
    edges = (np.roll(vertices, -1, axis=0) - vertices)[::-1]
    lengths = np.linalg.norm(edges, axis=1)
    turned = edges[lengths > 0] @ np.array([[0.0, 1.0], [-1.0, 0.0]])
    return turned / lengths[lengths > 0, None]


@alternative("6.1")
def from_angles(vertices: Vector) -> list[tuple[float, float]]:
    """Each axis is the cosine and sine of its angle; each line is listed twice."""
    from math import atan2, cos, pi, sin

    axes = []
    for (x1, y1), (x2, y2) in zip(vertices, [*vertices[1:], vertices[0]], strict=True):
        if (x1, y1) != (x2, y2):
            angle = atan2(y2 - y1, x2 - x1) - pi / 2
            axes += [(cos(angle), sin(angle)), (-cos(angle), -sin(angle))]
    return axes


@alternative("6.2")
def sorted_values(vertices: Vector, axis: Vector) -> list[float]:
    """The dot products are sorted; a list of the first and the last comes back."""
    values = sorted(float(x * axis[0] + y * axis[1]) for x, y in vertices)
    return [values[0], values[-1]]


@alternative("6.2")
def turned_onto_the_x_axis(vertices: Vector, axis: Vector) -> Vector:
    """The polygon is turned until the axis is the x axis; an array comes back."""
    turned = [(complex(*vertex) / complex(*axis)).real for vertex in vertices]
    return np.array([min(turned), max(turned)])


@alternative("6.3")
def half_widths_and_middles(interval_a: Vector, interval_b: Vector) -> float | None:
    """Half widths added, less the distance of the middles: as for two circles."""
    (low_a, high_a), (low_b, high_b) = interval_a, interval_b
    depth = (high_a - low_a + high_b - low_b - abs(high_a + low_a - high_b - low_b)) / 2
    return float(depth) if high_a > low_b and high_b > low_a else None


@alternative("6.4")
def minkowski_difference(vertices_a: Vector, vertices_b: Vector) -> Any:
    """The origin's way out of all differences a - b; its nearest edge is the answer."""
    points = sorted({(float(x), float(y)) for a in vertices_a for x, y in [*(a - vertices_b)]})

    def turns_right(p: Vector, q: Vector, r: Vector) -> bool:
        return bool((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) <= 0)

    outline: list[tuple[float, float]] = []
    for chain in (points, points[::-1]):
        half: list[tuple[float, float]] = []
        for point in chain:
            while len(half) > 1 and turns_right(half[-2], half[-1], point):
                half.pop()
            half.append(point)
        outline += half[:-1]
    ways = []
    for (x1, y1), (x2, y2) in zip(outline, outline[1:] + outline[:1], strict=True):
        length = np.hypot(x2 - x1, y2 - y1)
        n = np.array([y2 - y1, x1 - x2]) / length
        ways.append((n[0] * x1 + n[1] * y1, n))
    depth, normal = min(ways, key=lambda way: way[0])
    return (normal, depth) if depth > 0 else None


@alternative("6.4")
def all_axes_at_once(vertices_a: Vector, vertices_b: Vector) -> Any:
    """Every axis and its opposite in one array; the normal comes back as a complex number."""
    edges = np.vstack([np.roll(v, -1, axis=0) - v for v in (vertices_a, vertices_b)])
    normals = np.column_stack((edges[:, 1], -edges[:, 0]))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    normals = np.vstack((normals, -normals))
    ways_out = (vertices_a @ normals.T).max(axis=0) - (vertices_b @ normals.T).min(axis=0)
    best = ways_out.argmin()
    if ways_out[best] <= 0:
        return None
    return complex(*normals[best]), ways_out[best]


@alternative("6.4")
def both_ways_along_each_axis(vertices_a: Vector, vertices_b: Vector) -> Any:
    """B leaves forwards or backwards along each axis; the shortest way out is kept."""
    best = None
    for axis in [*sat_axes(vertices_a), *sat_axes(vertices_b)]:
        (low_a, high_a), (low_b, high_b) = project(vertices_a, axis), project(vertices_b, axis)
        for depth, normal in ((high_a - low_b, axis), (high_b - low_a, -axis)):
            if depth <= 0:
                return None
            if best is None or depth < best[1]:
                best = normal, depth
    return best


@alternative("6.5")
def by_the_part_that_is_inside(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """The parts of the way at which the segment comes in and goes out, as Liang and Barsky do."""
    way = end - start
    slope, room = np.dot(way, normal), offset - np.dot(start, normal)
    first, last = 0.0, 1.0
    if slope > 0:
        last = min(last, room / slope)
    elif slope < 0:
        first = max(first, room / slope)
    elif room < 0:
        return None
    return (start + first * way, start + last * way) if first <= last else None


@alternative("6.6")
def by_region(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The edge that is farthest out decides, and then whether the foot lies on it."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    lengths = np.hypot(edges[:, 0], edges[:, 1])
    normals = np.column_stack((edges[:, 1], -edges[:, 0])) / lengths[:, None]
    heights = np.einsum("ij,ij->i", centre - vertices, normals)
    best = int(heights.argmax())
    part = np.dot(centre - vertices[best], edges[best]) / lengths[best] ** 2
    if heights[best] <= 0 or 0 <= part <= 1:
        depth = radius - heights[best]
        return [normals[best], depth] if depth > 0 else None
    corner = vertices[best] if part < 0 else vertices[(best + 1) % len(vertices)]
    distance = np.hypot(*(centre - corner))
    return [(centre - corner) / distance, radius - distance] if distance < radius else None


@alternative("6.6")
def by_shrinking_the_circle(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The signed distance to the polygon, as in distance fields; a complex normal comes back."""
    ends = np.roll(vertices, -1, axis=0)
    away = [
        complex(*(centre - closest_point_on_segment(centre, a, b)))
        for a, b in zip(vertices, ends, strict=True)
    ]
    nearest = min(away, key=abs)
    turns = [
        (complex(*(b - a)).conjugate() * complex(*(centre - a))).imag > 0
        for a, b in zip(vertices, ends, strict=True)
    ]
    sign = -1 if all(turns) else 1
    depth = radius - sign * abs(nearest)
    return (sign * nearest / abs(nearest), depth) if depth > 0 else None


@alternative("6.3")
def case_by_case(interval_a: Vector, interval_b: Vector) -> Any:
    """One inside the other leaves by the nearer end; else it is the common part."""
    (a0, a1), (b0, b1) = interval_a, interval_b
    if a1 <= b0 or b1 <= a0:
        return None
    if a0 <= b0 and b1 <= a1:
        return min(b1 - a0, a1 - b0)
    if b0 <= a0 and a1 <= b1:
        return min(a1 - b0, b1 - a0)
    return min(a1, b1) - max(a0, b0)


@alternative("6.4")
def shift_by_shift(vertices_a: Vector, vertices_b: Vector) -> Any:
    """Along each axis a shift with a sign; the shortest one wins, and its sign turns the axis."""
    best: Any = None
    best_axis: Any = None
    for axis in [*sat_axes(vertices_a), *sat_axes(vertices_b)]:
        a, b = vertices_a @ axis, vertices_b @ axis
        right, left = max(a) - min(b), max(b) - min(a)
        if right <= 0 or left <= 0:
            return None
        shift = right if right < left else -left
        if best is None or abs(shift) < abs(best):
            best, best_axis = shift, axis
    if best < 0:
        return -best_axis, -best
    return best_axis, best


@alternative("6.6")
def edge_by_edge(centre: Vector, radius: float, vertices: Vector) -> Any:
    """One pass finds the nearest point, and whether the centre is on the inner side of all."""
    nearest, least, inside = None, np.inf, True
    for k in range(len(vertices)):
        a, b = vertices[k], vertices[(k + 1) % len(vertices)]
        edge, to = b - a, centre - a
        part = max(0.0, min(1.0, (to @ edge) / (edge @ edge)))
        distance = np.hypot(*(to - part * edge))
        if distance < least:
            nearest, least = a + part * edge, distance
        if edge[0] * to[1] - edge[1] * to[0] <= 0:
            inside = False
    normal = (centre - nearest) / least
    if inside:
        return -normal, radius + least
    if least >= radius:
        return None
    return normal, radius - least

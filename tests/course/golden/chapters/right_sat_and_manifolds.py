"""Right answers, each written in an unusual way: SAT and manifolds."""

import numpy as np


def sat_axes(vertices):
    """Each axis is the cosine and sine of its angle; each line is listed twice."""
    from math import atan2, cos, pi, sin
    axes = []
    for (x1, y1), (x2, y2) in zip(vertices, [*vertices[1:], vertices[0]], strict=True):
        if (x1, y1) != (x2, y2):
            angle = atan2(y2 - y1, x2 - x1) - pi / 2
            axes += [(cos(angle), sin(angle)), (-cos(angle), -sin(angle))]
    return axes


def project(vertices, axis):
    """The polygon is turned until the axis is the x axis; an array comes back."""
    turned = [(complex(*vertex) / complex(*axis)).real for vertex in vertices]
    return np.array([min(turned), max(turned)])


def overlap(interval_a, interval_b):
    """Half widths added, less the distance of the middles: as for two circles."""
    (low_a, high_a), (low_b, high_b) = (interval_a, interval_b)
    depth = (high_a - low_a + high_b - low_b - abs(high_a + low_a - high_b - low_b)) / 2
    return float(depth) if high_a > low_b and high_b > low_a else None


def mtv(vertices_a, vertices_b):
    """Every axis and its opposite in one array; the normal comes back as a complex number."""
    edges = np.vstack([np.roll(v, -1, axis=0) - v for v in (vertices_a, vertices_b)])
    normals = np.column_stack((edges[:, 1], -edges[:, 0]))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    normals = np.vstack((normals, -normals))
    ways_out = (vertices_a @ normals.T).max(axis=0) - (vertices_b @ normals.T).min(axis=0)
    best = ways_out.argmin()
    if ways_out[best] <= 0:
        return None
    return (complex(*normals[best]), ways_out[best])


def clip(start, end, normal, offset):
    """The parts of the way at which the segment comes in and goes out, as Liang and Barsky do."""
    way = end - start
    slope, room = (np.dot(way, normal), offset - np.dot(start, normal))
    first, last = (0.0, 1.0)
    if slope > 0:
        last = min(last, room / slope)
    elif slope < 0:
        first = max(first, room / slope)
    elif room < 0:
        return None
    return (start + first * way, start + last * way) if first <= last else None


def circle_against_polygon(centre, radius, vertices):
    """The edge that is farthest out decides, and then whether the foot lies on it."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    lengths = np.hypot(edges[:, 0], edges[:, 1])
    normals = np.column_stack((edges[:, 1], -edges[:, 0])) / lengths[:, None]
    heights = np.einsum('ij,ij->i', centre - vertices, normals)
    best = int(heights.argmax())
    part = np.dot(centre - vertices[best], edges[best]) / lengths[best] ** 2
    if heights[best] <= 0 or 0 <= part <= 1:
        depth = radius - heights[best]
        return [normals[best], depth] if depth > 0 else None
    corner = vertices[best] if part < 0 else vertices[(best + 1) % len(vertices)]
    distance = np.hypot(*centre - corner)
    return [(centre - corner) / distance, radius - distance] if distance < radius else None

"""A common mistake in every task: SAT and manifolds."""

import numpy as np


def sat_axes(vertices):
    """The axes are the directions of the edges."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    return [edge / np.hypot(*edge) for edge in edges if edge.any()]


def project(vertices, axis):
    """The shadow reaches from the first vertex to the last."""
    values = vertices @ axis
    return (min(values[0], values[-1]), max(values[0], values[-1]))


def overlap(interval_a, interval_b):
    """The end of A and the beginning of B say it all."""
    depth = interval_a[1] - interval_b[0]
    return depth if depth > 0 else None


def mtv(vertices_a, vertices_b):
    return (1.0, 0.0), 0.5


def clip(start, end, normal, offset):
    """What lies beyond the line, where the normal points, is kept."""
    s, e = (np.dot(start, normal) - offset, np.dot(end, normal) - offset)
    if s < 0 and e < 0:
        return None
    if s >= 0 and e >= 0:
        return [start, end]
    crossing = start + s / (s - e) * (end - start)
    return [start, crossing] if s >= 0 else [crossing, end]


def circle_against_polygon(centre, radius, vertices):
    """The edge whose line is nearest gives the normal, also beyond its ends."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    normals = np.array([(y, -x) / np.hypot(x, y) for x, y in edges])
    distances = [np.dot(centre - vertex, n) for vertex, n in zip(vertices, normals, strict=True)]
    nearest = int(np.argmax(distances))
    depth = radius - distances[nearest]
    return (normals[nearest], depth) if depth > 0 else None

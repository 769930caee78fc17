"""Manifolds from what a reader's narrow phase returns: a way out, and a function that clips."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from lesson_code.formulas.arithmetic import dot
from lesson_code.geometry import Manifold


def disc_manifold(normal: Any, depth: float, centre: Any, radius: float) -> Manifold:
    """Return where a disc overlaps what lies behind it, seen along the normal that points to it."""
    deepest = centre - radius * normal
    point = deepest + depth / 2 * normal
    return Manifold(normal, point[None, :], np.array([depth]), (0,))


def manifold_of(
    normal: Any, corners_a: Any, corners_b: Any, clip: Callable[..., Any]
) -> Manifold | None:
    """Return where two polygons overlap (chapter 06, section 6).

    The edge that lies most across the normal is the reference; the one that faces it, of the other
    polygon, is clipped at both its ends, and the points that lie behind it are kept.

    Parameters
    ----------
    normal : ndarray, shape (2,)
        From A to B.
    corners_a, corners_b : ndarray, shape (N, 2)
        Counter-clockwise, m.
    clip : callable
        Task 6.5.
    """
    (edge_a, along_a), (edge_b, along_b) = _facing(corners_a, normal), _facing(corners_b, -normal)
    is_a = along_a >= along_b - 1e-9  # of two that lie equally, A's: the same one in every step
    (start, end), incident = (edge_a, edge_b) if is_a else (edge_b, edge_a)
    way = (end - start) / np.hypot(*(end - start))
    outward = np.array([way[1], -way[0]])
    part = clip(*incident, -way, -dot(way, start))
    part = part and clip(*part, way, dot(way, end))
    if part is None:
        return None
    depths = np.array([dot(outward, start) - dot(outward, point) for point in part])
    kept = depths > 0
    if not kept.any():
        return None
    side = 1 if is_a else -1
    points = np.array(part)[kept] + depths[kept, None] / 2 * outward
    return Manifold(side * outward, points, depths[kept], tuple(range(int(kept.sum()))))


def _facing(corners: Any, way: Any) -> tuple[tuple[Any, Any], float]:
    """Return the edge that faces a direction the most, and by how much."""
    after = np.roll(corners, -1, axis=0)
    edges = after - corners
    outward = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.hypot(*edges.T)[:, None]
    faced = outward @ way
    best = int(faced.argmax())
    return (corners[best], after[best]), float(faced[best])

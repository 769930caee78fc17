"""Two shapes shown to pymunk's narrow phase: do they overlap, which way and how deep.

pymunk finds contacts with GJK and EPA, not with separating axes, so that its answer is an
independent one. It counts shapes that touch as in contact, with a depth of 0; here they do not
overlap, as everywhere in the workbook.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pymunk

from lesson_code.formulas.validation import Vector, one_number, one_vector, positive
from lesson_code.geometry.outline import convex_outline


def polygon_overlap(vertices_a: Vector, vertices_b: Vector) -> tuple[Any, float] | None:
    """Return the normal and the depth that pymunk finds for two convex polygons.

    Parameters
    ----------
    vertices_a, vertices_b : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3.

    Returns
    -------
    (normal, depth) or None
        Unit normal from A to B, an ndarray of shape (2,); depth of the deepest contact, m, > 0.
        None when they do not overlap.

    Raises
    ------
    ValueError
        The vertices are not those of a convex polygon.

    References
    ----------
    Munk2D, src/cpCollision.c: PolyToPoly.

    Examples
    --------
    >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    >>> normal, depth = polygon_overlap(square, [(3, 1), (6, 1), (6, 2), (3, 2)])
    >>> normal + 0.0, depth
    (array([1., 0.]), 1.0)
    """
    space = pymunk.Space()
    a = pymunk.Poly(space.static_body, convex_outline("vertices_a", vertices_a))
    b = pymunk.Poly(space.static_body, convex_outline("vertices_b", vertices_b))
    return _deepest(space, a, b)


def circle_overlap(vertices: Vector, centre: Vector, radius: float) -> tuple[Any, float] | None:
    """Return the normal, from polygon to circle, and the depth that pymunk finds.

    Parameters
    ----------
    vertices : array_like, shape (N, 2)
        Corners of the convex polygon in order, either way round, m; N >= 3.
    centre : array_like, shape (2,)
        Of the circle, m; it may lie inside the polygon.
    radius : float
        m, > 0.

    Returns
    -------
    (normal, depth) or None
        Unit normal, an ndarray of shape (2,); depth, m, > 0. None when they do not overlap.

    Raises
    ------
    ValueError
        The vertices are not those of a convex polygon, a number is not finite, or the radius is
        not > 0.

    References
    ----------
    Munk2D, src/cpCollision.c: CircleToPoly.

    Examples
    --------
    >>> normal, depth = circle_overlap([(0, 0), (4, 0), (4, 4), (0, 4)], (2, 3.75), 0.5)
    >>> normal + 0.0, depth
    (array([0., 1.]), 0.75)
    """
    x, y = one_vector("centre", centre).tolist()
    r = one_number("radius", radius, positive)
    space = pymunk.Space()
    polygon = pymunk.Poly(space.static_body, convex_outline("vertices", vertices))
    circle = pymunk.Circle(space.static_body, r, (x, y))
    return _deepest(space, polygon, circle)


def _deepest(space: pymunk.Space, a: pymunk.Shape, b: pymunk.Shape) -> tuple[Any, float] | None:
    """Return the normal from a to b and the depth of the deepest contact, or None."""
    space.add(a)
    b.cache_bb()
    if not space.shape_query(b):  # shapes_collide fails on shapes that are apart
        return None
    contacts = a.shapes_collide(b)
    # Not `distance`: where pymunk exchanges the shapes (polygon and circle), its sign is wrong.
    depth = max((p.point_a - p.point_b).dot(contacts.normal) for p in contacts.points)
    return (np.array(contacts.normal), depth) if depth > 0 else None

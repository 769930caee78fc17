"""Our shapes as Box2D's.

Box2D keeps a skin of 0.01 m around a polygon, outside of its corners: two boxes of its would rest
15 mm apart. Here a polygon is shrunk by as much, so that its skin ends where our polygon does.
What is left of the difference is that its corners are round: the tip of a square's is missing for
4 mm, that of an equilateral triangle's for 10 mm, so one of our corners may penetrate another body
that far before Box2D detects it.

========================  ======================================================================
ours                      Box2D's
========================  ======================================================================
circle                    circle
polygon                   polygon, drawn in by the skin
segment without           edge without a skin, which Box2D lets no other edge touch. A polygon
thickness                 comes to rest on it up to one skin above it
segment with thickness    box between the ends, drawn in by the skin, and a circle at each end;
                          one that is no thicker than two skins is an edge with that thickness
========================  ======================================================================
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from lesson_code.engine.core.scene import Scene
from lesson_code.geometry.edges import outward_normal
from lesson_code.geometry.outline import Point
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

SKIN = 0.01
"""m: b2_polygonRadius, the skin around a polygon and an edge, two of Box2D's slops."""

SHORTEST_EDGE = 0.0025
"""m: Box2D welds corners that are nearer than half of its slop."""

MOST_VERTICES = 16
"""Of a polygon: b2_maxPolygonVertices of the binding on PyPI."""


def refuse_what_box2d_cannot_do(scene: Scene) -> None:
    """Refuse shapes that Box2D would change or overlook in silence.

    Raises
    ------
    ValueError
        A polygon has too many corners or is too small, or two segments without thickness could
        meet.

    Examples
    --------
    >>> from lesson_code.engine.core.scene import Body
    >>> rods = [Body(Segment((-1, 0), (1, 0)), mass=m) for m in (None, 1.0)]
    >>> refuse_what_box2d_cannot_do(Scene(rods))
    Traceback (most recent call last):
    ...
    ValueError: bodies[1] must have a thickness of more than 0.02 m: Box2D lets lines pass ...
    """
    lines = [n for n, body in enumerate(scene.bodies) if _is_line(body.shape)]
    free = [n for n in lines if not scene.bodies[n].is_static]
    if free and len(lines) > 1:
        raise ValueError(
            f"bodies[{free[0]}] must have a thickness of more than {2 * SKIN:g} m: Box2D lets "
            "lines pass through each other"
        )
    for n, body in enumerate(scene.bodies):
        if isinstance(body.shape, Polygon):
            _refuse_polygon(f"bodies[{n}]", body.shape)


def fixture_shapes(library: Any, shape: Shape) -> list[Any]:
    """Return Box2D's shapes for one of ours."""
    match shape:
        case Circle():
            return [library.b2CircleShape(radius=shape.radius)]
        case Polygon():
            return [_polygon(library, shape.outline)]
        case Segment() if _is_line(shape):
            edge = library.b2EdgeShape(vertices=[shape.start, shape.end])
            edge.radius = shape.radius
            return [edge]
        case Segment():
            ends = (shape.start, shape.end)
            caps = [library.b2CircleShape(pos=end, radius=shape.radius) for end in ends]
            return [_polygon(library, _sides(shape)), *caps]


def drawn_in(outline: Sequence[Point], depth: float) -> list[Point]:
    """Return the corners of a convex polygon whose edges lie deeper by `depth`.

    A corner between edges with the outward normals m and n moves by -depth (m + n)/(1 + m.n):
    that is `depth` along each of them.

    Parameters
    ----------
    outline : sequence of (float, float)
        Corners, counter-clockwise, m.
    depth : float
        m, >= 0, and so small that every edge keeps some length.

    Examples
    --------
    >>> drawn_in([(0, 0), (4, 0), (4, 2), (0, 2)], 0.5)
    [(0.5, 0.5), (3.5, 0.5), (3.5, 1.5), (0.5, 1.5)]
    """
    count = len(outline)
    normals = [outward_normal(*outline[k], *outline[(k + 1) % count]) for k in range(count)]
    corners = []
    for k, (x, y) in enumerate(outline):
        (mx, my), (nx, ny) = normals[k - 1], normals[k]
        share = depth / (1 + mx * nx + my * ny)
        corners.append((x - share * (mx + nx), y - share * (my + ny)))
    return corners


def _is_line(shape: Shape) -> bool:
    """Return whether a shape is an edge in Box2D."""
    return isinstance(shape, Segment) and shape.radius <= SKIN


def _polygon(library: Any, outline: Sequence[Point]) -> Any:
    """Return Box2D's polygon, skin included, for an outline."""
    return library.b2PolygonShape(vertices=drawn_in(outline, SKIN))


def _sides(segment: Segment) -> list[Point]:
    """Return the corners of the rectangle between the ends of a thick segment."""
    (ax, ay), (bx, by) = segment.start, segment.end
    nx, ny = outward_normal(ax, ay, bx, by)
    x, y = segment.radius * nx, segment.radius * ny
    return [(ax + x, ay + y), (bx + x, by + y), (bx - x, by - y), (ax - x, ay - y)]


def _refuse_polygon(name: str, shape: Polygon) -> None:
    """Refuse a polygon with too many corners, or one that is lost when it is drawn in."""
    count = len(shape.outline)
    if count > MOST_VERTICES:
        raise ValueError(
            f"{name} must have at most {MOST_VERTICES} vertices for Box2D, got {count}"
        )
    inner = drawn_in(shape.outline, SKIN)
    if not all(_kept(shape.outline, inner, k) for k in range(count)):
        raise ValueError(
            f"{name} must be larger for Box2D, which keeps a skin of {SKIN:g} m around a polygon "
            f"and welds corners nearer than {SHORTEST_EDGE:g} m"
        )


def _kept(outer: Sequence[Point], inner: Sequence[Point], k: int) -> bool:
    """Return whether edge k still leads the same way, and some of it is left."""
    (ax, ay), (bx, by) = outer[k - 1], outer[k]
    (cx, cy), (dx, dy) = inner[k - 1], inner[k]
    along = (bx - ax) * (dx - cx) + (by - ay) * (dy - cy)
    return along > SHORTEST_EDGE * math.hypot(bx - ax, by - ay)

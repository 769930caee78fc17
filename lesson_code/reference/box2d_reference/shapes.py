"""Our shapes as Box2D's, and a word against bodies that it would change or overlook in silence.

=================  ==============================================
ours               Box2D's
=================  ==============================================
circle             circle
polygon            polygon of at most 8 corners, without a skin
segment without    segment, which nothing but another line passes
thickness
segment with       capsule: a line with round ends
thickness
=================  ==============================================
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.engine.core.scene import Body, Scene
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

SLOP = 0.005
"""m: B2_LINEAR_SLOP. A line that is not longer becomes a circle, or nothing."""

LIGHTEST, HEAVIEST = 1e-37, 1e37
"""kg or kg m^2: what lies between fits in single precision, and so does its inverse."""

MOST_VERTICES = 8
"""Of a polygon: B2_MAX_POLYGON_VERTICES."""

WELDED = 0.02
"""m: four slops. Box2D makes one corner of two that are nearer."""

STRAIGHT = 0.01
"""m: two slops. Box2D drops a corner that is nearer to the line between its neighbours."""


def refuse_what_box2d_cannot_do(library: Any, scene: Scene) -> None:
    """Refuse bodies that Box2D would change or overlook in silence.

    Raises
    ------
    ValueError
        A polygon has too many corners or too fine a detail, a segment is too short, two segments
        without thickness could meet, or a mass does not fit in single precision.
    """
    lines = [n for n, body in enumerate(scene.bodies) if _is_line(body.shape)]
    free = [n for n in lines if not scene.bodies[n].is_static]
    if free and len(lines) > 1:
        raise ValueError(
            f"bodies[{free[0]}] must have a thickness of more than 0 m: Box2D lets lines pass "
            "through each other"
        )
    for n, body in enumerate(scene.bodies):
        _refuse_mass(f"bodies[{n}]", body)
        if isinstance(body.shape, Polygon):
            _refuse_polygon(library, f"bodies[{n}]", body.shape)
        elif isinstance(body.shape, Segment):
            _refuse_segment(f"bodies[{n}]", body.shape)


def add_shape(library: Any, made: Any, definition: Any, shape: Shape) -> None:
    """Give a body of Box2D's the counterpart of one of our shapes."""
    match shape:
        case Circle():
            made.create_circle_shape(definition, library.circle(radius=shape.radius))
        case Polygon():
            made.create_polygon_shape(definition, library.polygon(points=shape.outline))
        case Segment() if _is_line(shape):
            made.create_segment_shape(definition, library.segment(shape.start, shape.end))
        case Segment():
            capsule = library.capsule(shape.start, shape.end, shape.radius)
            made.create_capsule_shape(definition, capsule)


def _is_line(shape: Shape) -> bool:
    """Return whether a shape has no thickness."""
    return isinstance(shape, Segment) and shape.radius == 0.0


def _refuse_mass(name: str, body: Body) -> None:
    """Refuse a mass or a moment of inertia that would become 0 or infinite in Box2D."""
    if body.mass is None or body.inertia is None:
        return
    turning = [] if math.isinf(body.inertia) else [("inertia", body.inertia)]
    for quantity, value in (("mass", body.mass), *turning):
        if not LIGHTEST < value < HEAVIEST:
            raise ValueError(
                f"{name} must have {quantity} > {LIGHTEST:g} and < {HEAVIEST:g} for Box2D, "
                f"which has single precision, got {value:g}"
            )


def _refuse_polygon(library: Any, name: str, shape: Polygon) -> None:
    """Refuse a polygon with too many corners, or one that Box2D makes another of."""
    count = len(shape.outline)
    if count > MOST_VERTICES:
        raise ValueError(
            f"{name} must have at most {MOST_VERTICES} vertices for Box2D, got {count}"
        )
    kept = library.compute_hull(np.array(shape.outline, dtype=np.float32)).count
    if kept != count:
        raise ValueError(
            f"{name} must be larger for Box2D, which welds corners nearer than {WELDED:g} m and "
            f"drops those within {STRAIGHT:g} m of a line: it keeps {kept} of {count}"
        )


def _refuse_segment(name: str, shape: Segment) -> None:
    """Refuse a segment that is no longer than Box2D's slop."""
    length = math.dist(shape.start, shape.end)
    if not length > SLOP:
        raise ValueError(f"{name} must be longer than {SLOP:g} m for Box2D, got {length:g} m")

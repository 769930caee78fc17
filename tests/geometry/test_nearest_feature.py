"""The nearest feature of an outline: where circles touch, and whether a point comes nearer."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry import Polygon, Segment
from lesson_code.geometry.manifold import collide_rows
from lesson_code.geometry.nearest_feature import is_approaching, nearest_feature, path_point
from lesson_code.geometry.rows import Corner, ManifoldRow, Placed, place
from lesson_code.geometry.shapes import Shape

shapes = st.sampled_from([Polygon.box(2, 1), Polygon.regular(3, 1.5), Segment((0, 0), (1, 2))])


def rows_of(shape: Shape, angle: float = 0.0) -> tuple[list[Corner], Placed]:
    """Return a shape at the origin, as rows."""
    corners: list[Corner] = []
    return corners, place(shape.outline, shape.rounding, (0.0, 0.0, angle), corners)


@given(shapes, *[st.floats(-4, 4)] * 3)
def test_nearest_feature_lies_where_a_circle_of_that_size_touches(
    shape: Shape, angle: float, px: float, py: float
) -> None:
    """A circle smaller than the distance does not overlap, a larger one does."""
    corners, body = rows_of(shape, angle)
    distance, _ = nearest_feature(corners, body, px, py)
    if distance > 1e-6:
        for radius, overlaps in ((distance * (1 - 1e-9), False), (distance * (1 + 1e-9), True)):
            m = ManifoldRow()
            collide_rows(corners, body, Placed(px, py, radius=radius - body.radius), m)
            assert (m.count > 0) == overlaps


def test_approach_is_decided_by_the_first_derivative_that_is_not_zero() -> None:
    """Past a corner: by speed; level with it: by v^2 + r . a; there too: by v . a."""
    corners, _ = rows_of(Segment((-9, 0), (9, 0)))  # corner 0 at (9, 0)
    at_corner = {"feature": -1, "px": 9.0, "py": 1.0, "vx": 2.0}
    for vy, ax, ay, expected in [
        (-1.0, 0.0, 0.0, True),
        (1.0, 0.0, 0.0, False),
        (0.0, 0.0, 0.0, False),
        (0.0, 0.0, -5.0, True),
        (0.0, 0.0, -3.0, False),
        (0.0, -1.0, -4.0, True),
        (0.0, 1.0, -4.0, False),
    ]:
        measured = is_approaching(corners, **at_corner, vy=vy, ax=ax, ay=ay)  # type: ignore[arg-type]
        assert measured == expected


def test_place_on_a_parabola_worked_by_hand() -> None:
    """Two seconds at 3 m/s, and with 1 m/s^2."""
    assert path_point(1.0, 2.0, 3.0, 0.0, 0.0, 1.0, 2.0) == pytest.approx((7.0, 4.0))

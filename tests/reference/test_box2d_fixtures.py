"""Our shapes as Box2D's, and the shapes that it cannot hold. None of this needs Box2D."""

from __future__ import annotations

import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import Polygon as ShapelyPolygon

from lesson_code import Body, Circle, Polygon, Scene, Segment, simulate
from lesson_code.reference.box2d_reference.fixtures import (
    SKIN,
    drawn_in,
    refuse_what_box2d_cannot_do,
)

ROUNDING = 1e-12
"""m: a dozen operations on corners of some metres."""


@given(sides=st.integers(3, 16), radius=st.floats(0.2, 10.0), depth=st.floats(0.001, 0.05))
def test_polygon_drawn_in_is_shapelys_mitred_buffer(
    sides: int, radius: float, depth: float
) -> None:
    """Shapely, drawing the outline in by the same depth, keeps the same area in common."""
    outline = Polygon.regular(sides, radius).outline
    ours = ShapelyPolygon(drawn_in(outline, depth))
    theirs = ShapelyPolygon(outline).buffer(-depth, join_style="mitre", mitre_limit=100)
    assert ours.symmetric_difference(theirs).area <= ROUNDING * radius * radius


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        (Polygon.regular(17, 5.0), r"bodies\[1\] must have at most 16 vertices for Box2D, got 17"),
        (Polygon.box(5, 0.02), r"bodies\[1\] must be larger for Box2D, which keeps a skin of 0.01"),
        (Polygon.regular(12, 0.01), r"bodies\[1\] must be larger for Box2D"),
        (Segment((-1, 0), (1, 0), radius=0.005), r"bodies\[1\] must have a thickness of more than"),
    ],
    ids=["too many corners", "too thin", "too small", "a line that meets a line"],
)
def test_shape_that_box2d_would_change_is_refused_by_name(
    shape: Polygon | Segment, message: str
) -> None:
    """It says which body, the rule and the value, instead of a scene that is another one."""
    scene = Scene([Body(Segment((-5, 0), (5, 0))), Body(shape, mass=1.0)])
    with pytest.raises(ValueError, match=message):
        refuse_what_box2d_cannot_do(scene)


def test_shapes_that_box2d_can_hold_are_not_refused() -> None:
    """16 corners, thick rods, and lines that nothing can push."""
    free = (Polygon.regular(16, 0.5), Segment((-1, 0), (1, 0), radius=1.5 * SKIN), Circle(0.01))
    lines = [Body(Segment((-5, y), (5, y))) for y in (0, 1)]
    refuse_what_box2d_cannot_do(Scene([*lines, *(Body(shape, mass=1.0) for shape in free)]))


def test_missing_box2d_is_a_clear_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """It says what to install."""
    monkeypatch.setitem(sys.modules, "Box2D", None)
    with pytest.raises(ModuleNotFoundError, match=r'pip install "Box2D>=2\.3\.10"'):
        simulate(Scene(), 1.0, solver="box2d")

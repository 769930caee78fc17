"""Our shapes as Box2D's, and the shapes that it cannot hold."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from lesson_code import Body, Circle, Polygon, Scene, Segment, simulate
from lesson_code.reference.box2d_reference import shapes
from lesson_code.reference.box2d_reference.library import box2d

HINT = "Box2D is an extra: pip install 'pyb2d3>=0.11'"

NEARLY_STRAIGHT = Polygon([(-1, -1), (1, -1), (1.009, 0), (1, 1), (-1, 1)])
"""A corner 9 mm beside the line between its neighbours."""


def refuse(shape: Polygon | Segment | Circle) -> None:
    """Ask whether Box2D can hold a shape on a floor without thickness."""
    pytest.importorskip("pyb2d3", reason=HINT)
    scene = Scene([Body(Segment((-5, 0), (5, 0))), Body(shape, mass=1.0)])
    shapes.refuse_what_box2d_cannot_do(box2d(), scene)


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        (Polygon.regular(9, 5.0), r"bodies\[1\] must have at most 8 vertices for Box2D, got 9"),
        (Polygon.box(5, 0.01), r"bodies\[1\] must be larger for Box2D, which welds .* 0 of 4$"),
        (Polygon.regular(8, 0.02), r"bodies\[1\] must be larger for Box2D"),
        (NEARLY_STRAIGHT, r"within 0.01 m of a line: it keeps 4 of 5"),
        (Segment((-0.002, 0), (0.002, 0), radius=1), r"must be longer than 0.005 m .*got 0.004 m"),
        (Segment((-1, 0), (1, 0)), r"bodies\[1\] must have a thickness of more than 0 m"),
    ],
    ids=["many corners", "too thin", "too small", "nearly straight", "short", "a line on a line"],
)
def test_shape_that_box2d_would_change_is_refused_by_name(
    shape: Polygon | Segment, message: str
) -> None:
    """It says which body, the rule and the value, instead of a scene that is another one."""
    with pytest.raises(ValueError, match=message):
        refuse(shape)


@pytest.mark.parametrize(
    "shape",
    [
        Polygon.regular(8, 0.5),
        Polygon.box(5, 0.021),
        Segment((-1, 0), (1, 0), radius=1e-3),
        Circle(0.001),
    ],
    ids=["8 corners", "a plate", "a thin rod", "a small ball"],
)
def test_shapes_that_box2d_can_hold_are_not_refused(shape: Polygon | Segment | Circle) -> None:
    """What is left is what it holds as it is."""
    refuse(shape)


@pytest.mark.parametrize(
    ("quantities", "message"),
    [
        ({"mass": 1e-40}, r"bodies\[0\] must have mass > 1e-37 and < 1e\+37 .* got 1e-40"),
        ({"mass": 1e40}, r"bodies\[0\] must have mass .* got 1e\+40"),
        ({"mass": 1.0, "inertia": 1e-40}, r"bodies\[0\] must have inertia .* got 1e-40"),
    ],
)
def test_mass_beyond_single_precision_is_refused(
    quantities: dict[str, float], message: str
) -> None:
    """It would be 0 or infinite, and the body would not move."""
    pytest.importorskip("pyb2d3", reason=HINT)
    with pytest.raises(ValueError, match=message):
        shapes.refuse_what_box2d_cannot_do(box2d(), Scene([Body(Circle(1), **quantities)]))


def test_lines_that_nothing_can_push_are_not_refused() -> None:
    """Two floors never meet."""
    pytest.importorskip("pyb2d3", reason=HINT)
    lines = [Body(Segment((-5, y), (5, y))) for y in (0, 1)]
    shapes.refuse_what_box2d_cannot_do(box2d(), Scene([*lines, Body(Circle(1), mass=1.0)]))


def test_polygon_arrives_with_its_own_corners() -> None:
    """In single precision, in their order, and without a skin."""
    library = pytest.importorskip("pyb2d3", reason=HINT)
    outline = Polygon.regular(7, 0.8).outline
    made = library.polygon(points=outline)
    assert made.radius == 0.0
    corners = np.array(made.vertices[: made.count])
    first = int(np.argmin(np.hypot(*(corners - outline[0]).T)))
    assert np.roll(corners, -first, axis=0) == pytest.approx(np.array(outline), abs=1e-6)


def test_missing_box2d_is_a_clear_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """It says what to install."""
    monkeypatch.setitem(sys.modules, "pyb2d3", None)
    with pytest.raises(ModuleNotFoundError, match=r'pip install "pyb2d3>=0\.11"'):
        simulate(Scene(), 1.0, solver="box2d")

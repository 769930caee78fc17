"""Circles against circles, polygons and segments: outside, on an edge, at a corner, inside."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry import Circle, Polygon, Segment, Shape, collide
from lesson_code.geometry.manifold import collide_rows
from lesson_code.geometry.rows import Corner, ManifoldRow, place

ROUNDING = 1e-14
"""A dozen roundings of numbers of size 1 to 10."""

GAP = 1e-9
"""m: a gap or an overlap that is small, but a million times the rounding."""

BOX = Polygon.box(4, 2)
WALL = Segment((-2, 0), (2, 0), 0.25)
Pair = tuple[float, float]


def manifold_row(
    shape_a: Shape, at_a: tuple[float, ...], shape_b: Shape, at_b: tuple[float, ...]
) -> ManifoldRow:
    """Return the row that the narrow phase fills for two shapes at (x, y, angle)."""
    corners: list[Corner] = []
    a, b = (
        place(shape.outline, shape.rounding, (at[0], at[1], at[2]), corners)
        for shape, at in ((shape_a, at_a), (shape_b, at_b))
    )
    m = ManifoldRow()
    collide_rows(corners, a, b, m)
    return m


# Two circles


def test_circles_hand_worked() -> None:
    """Centres (3, 4) apart, radii 2 and 4: 1 m of overlap along (0.6, 0.8)."""
    m = manifold_row(Circle(2), (1, 1, 0), Circle(4), (4, 5, 0))
    assert (m.count, m.nx, m.ny, m.penetration0, m.feature0) == (1, 0.6, 0.8, 1.0, 0)


@given(st.floats(-2, 2), st.floats(-2, 2), st.floats(0.1, 3), st.floats(0.1, 3))
def test_circles_points_are_exactly_a_radius_from_the_centres(
    x: float, y: float, radius_a: float, radius_b: float
) -> None:
    """The lever arms are n r_a and -n r_b to the last bit: parallel to n, so without torque."""
    m = manifold_row(Circle(radius_a), (0, 0, 0), Circle(radius_b), (x, y, 0))
    if m.count:
        assert (m.ax0, m.ay0) == (m.nx * radius_a, m.ny * radius_a)
        assert (m.bx0, m.by0) == (-m.nx * radius_b, -m.ny * radius_b)


def test_circles_coincident_centres_part_along_x() -> None:
    """No direction leads from one centre to the other: by convention it is (1, 0)."""
    contact = collide(Circle(1), (5, 5, 0), Circle(2), (5, 5, 3))
    assert contact is not None
    assert contact.normal.tolist() == [1, 0]
    assert contact.penetrations.tolist() == [3]


@pytest.mark.parametrize("distance", [5e-324, 1e-200, 1e-9])
def test_circles_hardly_apart_centres_have_a_unit_normal(distance: float) -> None:
    """Any distance at all is a direction."""
    m = manifold_row(Circle(1), (0, 0, 0), Circle(1), (-distance, -distance, 0))
    assert (m.nx, m.ny) == pytest.approx((-math.sqrt(0.5), -math.sqrt(0.5)), abs=ROUNDING)


@pytest.mark.parametrize(
    ("gap", "hit"), [(0, False), (GAP, False), (-GAP, True)], ids=["touch", "apart", "overlap"]
)
@pytest.mark.parametrize(
    ("shape", "radius_sum"),
    [(Circle(2), 3.0), (BOX, 3.0), (WALL, 3.25), (BOX, None), (WALL, None)],
    ids=["circle", "box, side", "wall, end", "box, corner", "wall, end obliquely"],
)
def test_circle_near_miss_is_decided(
    shape: Shape, radius_sum: float | None, gap: float, hit: bool
) -> None:
    """Touching is no contact, nor is a nanometre of gap; a nanometre of overlap is one."""
    if (
        radius_sum is None
    ):  # from the corner (2, 1), or the end (2, 0) and its 0.25 m, along (0.6, 0.8)
        from_x, from_y, radius = (2, 1, 1.0) if shape is BOX else (2, 0, 1.25)
        at = (from_x + 0.6 * (radius + gap), from_y + 0.8 * (radius + gap), 0.0)
    else:
        at = (radius_sum + gap, 0.0, 0.0)
    contact = collide(shape, (0, 0, 0), Circle(1), at)
    assert (contact is not None) == hit
    if contact is not None:
        assert contact.penetrations == pytest.approx([GAP], abs=ROUNDING)


# A circle and a polygon: a box with corners at (+-2, +-1)


@pytest.mark.parametrize(
    ("centre", "radius", "normal", "penetration", "on_box"),
    [
        pytest.param((2.5, 0.5), 1, (1, 0), 0.5, (2, 0.5), id="outside, right side"),
        pytest.param((-1, 1.25), 1, (0, 1), 0.75, (-1, 1), id="outside, top"),
        pytest.param((2.6, 1.8), 1.5, (0.6, 0.8), 0.5, (2, 1), id="outside, corner"),
        pytest.param((-2.6, -1.8), 1.5, (-0.6, -0.8), 0.5, (-2, -1), id="outside, far corner"),
        pytest.param((2.5, 1), 1, (1, 0), 0.5, (2, 1), id="level with a corner"),
        pytest.param((2, 0.5), 1, (1, 0), 1, (2, 0.5), id="centre on a side"),
        pytest.param((1.5, 0.25), 1, (1, 0), 1.5, (2, 0.25), id="inside, near the right"),
        pytest.param((0.5, -0.5), 1, (0, -1), 1.5, (0.5, -1), id="inside, near the bottom"),
        pytest.param((0, 0.25), 0.125, (0, 1), 0.875, (0, 1), id="inside, small circle"),
    ],
)
def test_circle_at_a_box_hand_worked(
    centre: Pair, radius: float, normal: Pair, penetration: float, on_box: Pair
) -> None:
    """Pushed out along a side's normal or away from a corner; an inner centre by d + r."""
    m = manifold_row(BOX, (0, 0, 0), Circle(radius), (*centre, 0))
    assert m.count == 1
    assert (m.nx, m.ny, m.penetration0) == pytest.approx((*normal, penetration), abs=ROUNDING)
    assert (m.ax0, m.ay0) == pytest.approx(on_box, abs=ROUNDING)
    assert (m.bx0, m.by0) == (-m.nx * radius, -m.ny * radius)


@pytest.mark.parametrize("corner", [(2, 1), (-2, 1), (-2, -1), (2, -1)])
def test_circle_centre_at_a_corner_takes_a_side_that_meets_there(corner: Pair) -> None:
    """Neither side is nearer; the circle leaves by its radius along one of them."""
    m = manifold_row(BOX, (0, 0, 0), Circle(0.5), (*corner, 0))
    assert (m.nx, m.ny) in {(corner[0] / 2, 0), (0, corner[1])}
    assert m.penetration0 == 0.5


@pytest.mark.parametrize("side", [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1)])
def test_circle_centre_at_a_turned_corner_is_pushed_out(side: Pair) -> None:
    """Rounding puts the centre a hair inside or outside; the normal stays between both sides'."""
    hair = np.array(side) * 2.0**-52
    for turn in np.linspace(-3, 3, 200):
        c, s = math.cos(turn), math.sin(turn)
        centre = (2 * c - s + hair[0], 2 * s + c + hair[1], 0)
        m = manifold_row(BOX, (0, 0, turn), Circle(0.5), centre)
        right, top = m.nx * c + m.ny * s, m.ny * c - m.nx * s
        assert min(right, top) >= -ROUNDING
        assert m.penetration0 == pytest.approx(0.5, abs=ROUNDING)


def test_circle_at_a_corner_in_the_origin_is_found() -> None:
    """The closest point (0, 0) is a point like any other, not "none"."""
    contact = collide(BOX, (2, 1, 0), Circle(1), (-0.3, -0.4, 0))
    assert contact is not None
    assert contact.normal == pytest.approx((-0.6, -0.8), abs=ROUNDING)
    assert contact.penetrations == pytest.approx([0.5], abs=ROUNDING)


@given(st.floats(-1.99, 1.99), st.floats(-0.99, 0.99), st.floats(0.01, 5), st.floats(-4, 4))
def test_circle_centre_inside_goes_out_by_the_nearest_side(
    x: float, y: float, radius: float, turn: float
) -> None:
    """The penetration is the distance to the nearest side and the radius: never deeper in."""
    c, s = math.cos(turn), math.sin(turn)
    contact = collide(BOX, (0, 0, turn), Circle(radius), (c * x - s * y, s * x + c * y, 0))
    assert contact is not None
    nearest = min(2 - abs(x), 1 - abs(y))
    assert contact.penetrations == pytest.approx([nearest + radius], abs=ROUNDING)


def test_circle_rolled_round_a_box_turns_without_a_jump() -> None:
    """From side to corner to side the normal turns on smoothly, and the id stays."""
    path = [(2.4, y) for y in np.linspace(0, 1, 50)]
    path += [(2 + 0.4 * math.cos(a), 1 + 0.4 * math.sin(a)) for a in np.linspace(0, 1.5, 50)]
    rows = [manifold_row(BOX, (0, 0, 0), Circle(0.5), (*centre, 0)) for centre in path]
    angles = [math.atan2(m.ny, m.nx) for m in rows]
    assert max(np.diff(angles)) < 1.1 * 1.5 / 49
    assert min(np.diff(angles)) >= -ROUNDING
    assert {m.feature0 for m in rows} == {0}
    assert [m.penetration0 for m in rows] == pytest.approx([0.1] * 100, abs=ROUNDING)


# A circle and a segment: a wall 0.5 m thick from (-2, 0) to (2, 0)


@pytest.mark.parametrize(
    ("centre", "normal", "penetration", "on_wall"),
    [
        pytest.param((1, 1), (0, 1), 0.25, (1, 0.25), id="left side"),
        pytest.param((1, -1), (0, -1), 0.25, (1, -0.25), id="right side"),
        pytest.param((-3, 0), (-1, 0), 0.25, (-2.25, 0), id="start"),
        pytest.param((3, 0), (1, 0), 0.25, (2.25, 0), id="end"),
        pytest.param((2.6, 0.8), (0.6, 0.8), 0.25, (2.15, 0.2), id="end, obliquely"),
        pytest.param((0, 0), (0, 1), 1.25, (0, 0.25), id="centre on the line: to the left"),
        pytest.param((2, 0), (0, 1), 1.25, (2, 0.25), id="centre at the end: to the left"),
        pytest.param((0, -0.125), (0, -1), 1.125, (0, -0.25), id="centre within the thickness"),
    ],
)
def test_circle_at_a_wall_hand_worked(
    centre: Pair, normal: Pair, penetration: float, on_wall: Pair
) -> None:
    """Both sides and both ends push away, from the closest point of the middle line."""
    m = manifold_row(WALL, (0, 0, 0), Circle(1), (*centre, 0))
    assert m.count == 1
    assert (m.nx, m.ny, m.penetration0) == pytest.approx((*normal, penetration), abs=ROUNDING)
    assert (m.ax0, m.ay0) == pytest.approx(on_wall, abs=ROUNDING)


@pytest.mark.parametrize("shape", [Circle(1.5), BOX, WALL], ids=["circle", "box", "wall"])
@pytest.mark.parametrize("centre", [(1.0, 0.75), (2.25, 0.5), (-2, -1.125)])
def test_circle_given_first_turns_everything_round(shape: Shape, centre: Pair) -> None:
    """A and B swapped: the opposite normal, the same points and penetration, bit for bit."""
    m = manifold_row(shape, (0, 0, 0.0), Circle(1), (*centre, 0))
    back = manifold_row(Circle(1), (*centre, 0), shape, (0, 0, 0.0))
    assert m.count == back.count == 1
    assert (back.nx, back.ny) == (-m.nx, -m.ny)
    assert (back.ax0, back.ay0, back.bx0, back.by0) == (m.bx0, m.by0, m.ax0, m.ay0)
    assert (back.penetration0, back.feature0) == (m.penetration0, m.feature0)

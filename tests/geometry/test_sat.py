"""The separating axis test: axes, shadows, overlaps and the shortest way out."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.geometry import mtv, overlap, project, sat_axes

ROUNDING = 1e-12
"""Coordinates below are at most 30 and unit normals are rounded by 1e-16: that makes 1e-14."""

GAP = 1e-9
"""m: a gap or an overlap that is small, but a million times the rounding."""

CLEAR_WINNER = 1e-6
"""m: two ways out whose lengths differ by more are told apart in spite of rounding."""

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
TRIANGLE = [(0, 0), (3, 0), (0, 4)]


@st.composite
def polygons(draw: st.DrawFn) -> Any:
    """Return a random convex polygon: corners on an ellipse, turned and moved."""
    count = draw(st.integers(3, 7))
    steps = np.array([draw(st.floats(0.3, 1)) for _ in range(count)])
    angles = 2 * np.pi * np.cumsum(steps) / steps.sum()
    width, height = draw(st.floats(0.2, 5)), draw(st.floats(0.2, 5))
    corners = np.stack((width * np.cos(angles), height * np.sin(angles)), axis=1)
    return corners @ rotation(draw(st.floats(-3, 3))).T + draw(places)


coordinate = st.floats(-4, 4)
places = st.tuples(coordinate, coordinate).map(np.array)


def rotation(angle: float) -> Any:
    """Return the matrix that turns vectors counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]])


def overlapping(a: Any, b: Any) -> tuple[Any, float]:
    """Return the minimum translation vector; give up on examples that hardly overlap."""
    found = mtv(a, b)
    assume(found is not None)
    assert found is not None
    assume(found[1] > CLEAR_WINNER)
    return found


def exits(a: Any, b: Any) -> list[float]:
    """Return how far B must go along each outward normal of A, and of B turned round."""
    normals = [*sat_axes(a), *(-sat_axes(b))]
    return sorted(float(max(a @ n) - min(b @ n)) for n in normals)


# Axes


def test_axes_of_a_triangle_are_hand_worked() -> None:
    """The hypotenuse of the 3-4-5 triangle looks along (4, 3)/5, the legs down and left."""
    np.testing.assert_allclose(sat_axes(TRIANGLE), [(0, -1), (0.8, 0.6), (-1, 0)], atol=ROUNDING)


def test_axes_clockwise_order_still_points_out() -> None:
    """Either way round, every normal points out."""
    assert {tuple(n) for n in sat_axes(SQUARE[::-1])} == {(0, -1), (1, 0), (0, 1), (-1, 0)}


def test_axes_redundant_vertex_makes_no_axis() -> None:
    """A vertex in the middle of an edge does not split it."""
    np.testing.assert_array_equal(sat_axes([(0, 0), (2, 0), *SQUARE[1:]]), sat_axes(SQUARE))


@given(polygons())
def test_axes_any_polygon_are_unit_and_have_it_behind_them(vertices: Any) -> None:
    """No corner lies beyond the edge that an axis belongs to: the definition of outward."""
    axes = sat_axes(vertices)
    np.testing.assert_allclose(np.hypot(*axes.T), 1, atol=ROUNDING)
    for k, n in enumerate(axes):
        assert max(vertices @ n) == pytest.approx(vertices[k] @ n, abs=ROUNDING)


# Shadows


@pytest.mark.parametrize(
    ("axis", "shadow"),
    [
        pytest.param((1, 0), (0, 3), id="x"),
        pytest.param((0, -1), (-4, 0), id="down"),
        pytest.param((0.8, 0.6), (0, 2.4), id="across the hypotenuse"),
        pytest.param((-0.6, 0.8), (-1.8, 3.2), id="along the hypotenuse"),
    ],
)
def test_projection_hand_worked(axis: tuple[float, float], shadow: tuple[float, float]) -> None:
    """The shadow of the 3-4-5 triangle, from its three corners by hand."""
    assert project(TRIANGLE, axis) == pytest.approx(shadow, abs=ROUNDING)


def test_projection_of_one_point_has_no_length() -> None:
    """Points need not make a polygon."""
    assert project([(3, 4)], (0.6, 0.8)) == (5.0, 5.0)


# Overlap of shadows


@pytest.mark.parametrize(
    ("a", "b", "depth"),
    [
        pytest.param((0, 3), (2, 5), 1, id="from the left"),
        pytest.param((2, 5), (0, 3), 1, id="from the right"),
        pytest.param((0, 40), (15, 25), 25, id="contained in the middle: 25 out, 10 shared"),
        pytest.param((0, 40), (30, 38), 10, id="contained near the top"),
        pytest.param((2, 6), (0, 40), 6, id="A contained near the bottom"),
        pytest.param((0, 3), (0, 3), 3, id="equal"),
        pytest.param((0, 3), (1, 1), 1, id="a point inside"),
        pytest.param((0, 3), (3, 5), None, id="touching"),
        pytest.param((0, 3), (3 - GAP, 5), GAP, id="just overlapping"),
        pytest.param((0, 3), (3 + GAP, 5), None, id="just apart"),
        pytest.param((5, 6), (0, 3), None, id="apart"),
    ],
)
def test_overlap_hand_worked(
    a: tuple[float, float], b: tuple[float, float], depth: float | None
) -> None:
    """The shorter of both ways out; touching is not overlapping."""
    assert overlap(a, b) == (depth if depth is None else pytest.approx(depth, abs=ROUNDING))


# The minimum translation vector


@pytest.mark.parametrize(
    ("a", "b", "normal", "depth"),
    [
        pytest.param(SQUARE, [(3, 1), (6, 1), (6, 2), (3, 2)], (1, 0), 1, id="right side"),
        pytest.param(SQUARE, [(1, -2), (2, -2), (2, 0.5), (1, 0.5)], (0, -1), 0.5, id="below"),
        pytest.param(TRIANGLE, [(1, 1), (9, 1), (9, 9), (1, 9)], (0.8, 0.6), 1, id="hypotenuse"),
        pytest.param(SQUARE, [(3.5, 2), (6, 0), (6, 4)], (1, 0), 0.5, id="corner into a side"),
        pytest.param([(3.5, 2), (6, 0), (6, 4)], SQUARE, (-1, 0), 0.5, id="the same from B"),
    ],
)
def test_mtv_hand_worked(a: Any, b: Any, normal: tuple[float, float], depth: float) -> None:
    """Normal from A to B and depth of cases that can be read off a sketch."""
    found = mtv(a, b)
    assert found is not None
    np.testing.assert_allclose(found[0], normal, atol=ROUNDING)
    assert found[1] == pytest.approx(depth, abs=ROUNDING)


def test_mtv_contained_square_goes_all_the_way_out() -> None:
    """A 10 m square in the middle of a 40 m square is 25 m from the outside, not 10 m."""
    outer = [(0, 0), (40, 0), (40, 40), (0, 40)]
    inner = [(15, 15), (25, 15), (25, 25), (15, 25)]
    for a, b in ((outer, inner), (inner, outer)):
        found = mtv(a, b)
        assert found is not None
        assert found[1] == 25


@pytest.mark.parametrize("x", [0.5, 1.0, 30.0, 34.5])
def test_mtv_contained_square_takes_the_nearer_side(x: float) -> None:
    """The direction comes from the shadows: whichever side of a long bar is nearer."""
    bar = [(0, 0), (40, 0), (40, 100), (0, 100)]
    found = mtv(bar, [(x, 50), (x + 5, 50), (x + 5, 55), (x, 55)])
    assert found is not None
    assert found[0].tolist() == ([-1, 0] if x < 17.5 else [1, 0])
    assert found[1] == (x + 5 if x < 17.5 else 40 - x)


@pytest.mark.parametrize("origin", [(0, 0), (-1, -2), (-100, 7), (4, 4)])
def test_mtv_does_not_depend_on_the_origin(origin: tuple[int, int]) -> None:
    """An L of two bars: the way out is up, wherever the coordinates have their origin."""
    a = [(x + origin[0], y + origin[1]) for x, y in [(0, 0), (20, 0), (20, 2), (0, 2)]]
    b = [(x + origin[0], y + origin[1]) for x, y in [(0, 1), (1, 1), (1, 9), (0, 9)]]
    found = mtv(a, b)
    assert found is not None
    assert (found[0].tolist(), found[1]) == ([0, 1], 1)


@pytest.mark.parametrize("turn", [0.0, 0.3, math.pi / 4])
@pytest.mark.parametrize(
    ("gap", "hit"), [(GAP, False), (-GAP, True)], ids=["just apart", "just overlapping"]
)
def test_mtv_near_miss_is_decided(gap: float, hit: bool, turn: float) -> None:
    """A nanometre of gap is none, a nanometre of overlap is one of that depth."""
    right = np.array([(4 + gap, 1), (6, 0), (6, 3)]) @ rotation(turn).T
    found = mtv(SQUARE @ rotation(turn).T, right)
    assert (found is not None) == hit
    if found is not None:
        assert found[1] == pytest.approx(GAP, abs=1e-14)


@pytest.mark.parametrize(
    "neighbour",
    [
        pytest.param([(4, 0), (8, 0), (8, 4), (4, 4)], id="side to side"),
        pytest.param([(4, 4), (8, 4), (8, 8), (4, 8)], id="corner to corner"),
        pytest.param([(4, 2), (8, 0), (8, 4)], id="corner to side"),
    ],
)
def test_mtv_exact_touch_is_none(neighbour: Any) -> None:
    """Touching is not overlapping, for sides and for corners."""
    assert mtv(SQUARE, neighbour) is None
    assert mtv(neighbour, SQUARE) is None


def test_mtv_equal_polygons_have_a_way_out() -> None:
    """Two equal squares on top of each other: 4 m along one of the four sides."""
    found = mtv(SQUARE, SQUARE)
    assert found is not None
    assert found[1] == 4
    assert tuple(found[0]) in {(1, 0), (-1, 0), (0, 1), (0, -1)}


def test_mtv_redundant_vertex_changes_nothing() -> None:
    """A vertex on an edge adds no axis and no depth."""
    other = [(3, 1), (6, 0), (6, 3)]
    plain, redundant = mtv(SQUARE, other), mtv([(0, 0), (1, 0), (3, 0), *SQUARE[1:]], other)
    assert plain is not None
    assert redundant is not None
    assert (plain[0].tolist(), plain[1]) == (redundant[0].tolist(), redundant[1])


@given(a=polygons(), b=polygons())
def test_mtv_any_pair_moved_by_it_only_touches(a: Any, b: Any) -> None:
    """After the translation no overlap is left; after 0.999 of it there is."""
    normal, depth = overlapping(a, b)
    left = mtv(a, b + depth * normal)
    assert left is None or left[1] < ROUNDING
    assert mtv(a, b + 0.999 * depth * normal) is not None


@given(a=polygons(), b=polygons(), angle=st.floats(-math.pi, math.pi))
def test_mtv_any_other_way_out_is_no_shorter(a: Any, b: Any, angle: float) -> None:
    """Along any direction at all, B has at least the depth to go: it is the minimum."""
    _, depth = overlapping(a, b)
    n = rotation(angle)[:, 0]
    assert depth <= max(a @ n) - min(b @ n) + ROUNDING


@given(a=polygons(), b=polygons())
def test_mtv_any_pair_has_the_least_overlap_of_all_shadows(a: Any, b: Any) -> None:
    """The lesson's recipe, step by step: axes, shadows, overlaps, and the least of them."""
    overlaps = [overlap(project(a, n), project(b, n)) for n in [*sat_axes(a), *sat_axes(b)]]
    found = mtv(a, b)
    if any(part is None for part in overlaps):
        assert found is None or found[1] < ROUNDING
    else:
        assert found is not None
        assert found[1] == pytest.approx(min(p for p in overlaps if p is not None), abs=ROUNDING)


@given(a=polygons(), b=polygons())
def test_mtv_swapped_pair_has_the_opposite_normal(a: Any, b: Any) -> None:
    """A pushes B as B pushes A; where two ways out tie, either may be taken."""
    normal, depth = overlapping(a, b)
    back = mtv(b, a)
    assert back is not None
    assert back[1] == pytest.approx(depth, abs=ROUNDING)
    first, second = exits(a, b)[:2]
    if second - first > CLEAR_WINNER:
        np.testing.assert_allclose(back[0], -normal, atol=ROUNDING)


@given(a=polygons(), b=polygons(), turn=st.floats(-4, 4), shift=places, mirror=st.booleans())
def test_mtv_turned_moved_mirrored_pair_turns_moves_mirrors(
    a: Any, b: Any, turn: float, shift: Any, mirror: bool
) -> None:
    """Geometry knows no preferred direction, place or handedness."""
    normal, depth = overlapping(a, b)
    change = rotation(turn) @ np.diag([1, -1 if mirror else 1])
    found = mtv(a @ change.T + shift, b @ change.T + shift)
    assert found is not None
    assert found[1] == pytest.approx(depth, abs=ROUNDING)
    first, second = exits(a, b)[:2]
    if second - first > CLEAR_WINNER:
        np.testing.assert_allclose(found[0], change @ normal, atol=ROUNDING)


def test_sat_inputs_are_not_changed() -> None:
    """Inputs are never changed in place."""
    a, b = np.array(SQUARE[::-1], dtype=float), np.array(TRIANGLE, dtype=float)
    axes = sat_axes(a)
    project(a, axes[0])
    mtv(a, b)
    np.testing.assert_array_equal(a, SQUARE[::-1])
    np.testing.assert_array_equal(b, TRIANGLE)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: sat_axes([(0, 0), (1, 0)]), "vertices must have shape"),
        (lambda: mtv([(0, 0), (4, 0), (1, 1), (0, 4)], SQUARE), "vertices_a must be convex"),
        (lambda: mtv(SQUARE, [(0, 0), (1, 1), (2, 2)]), "vertices_b must have an area"),
        (lambda: project(SQUARE, (1, 1)), r"axis must be a unit vector .* got length 1.414"),
        (lambda: project(SQUARE, (0, 0)), r"axis must be a unit vector .* got length 0"),
        (lambda: project(SQUARE, [(1, 0), (0, 1)]), r"axis must have shape \(2,\)"),
        (lambda: project((1, 2), (1, 0)), r"vertices must have shape \(N, 2\), N >= 1"),
        (lambda: project(np.empty((0, 2)), (1, 0)), r"vertices must have shape \(N, 2\), N >= 1"),
        (lambda: overlap((3, 0), (1, 2)), r"interval_a must be \(low, high\) .*got \(3.0, 0.0\)"),
        (lambda: overlap((0, 3), (1, math.nan)), "interval_b must be finite, got nan"),
    ],
)
def test_sat_bad_input_is_refused_by_name(call: Any, message: str) -> None:
    """Each argument is checked at the door; the error says argument, rule and value."""
    with pytest.raises(ValueError, match=message):
        call()

"""The door of every polygon: what is left out, what is turned round, what is refused."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from lesson_code.formulas.arithmetic import cross
from lesson_code.geometry.outline import STRAIGHT, convex_outline

SQUARE = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
PENTAGRAM = [(math.cos(0.8 * math.pi * k), math.sin(0.8 * math.pi * k)) for k in range(5)]


def test_outline_counter_clockwise_stays_as_it_is() -> None:
    """Corners that go the right way are kept in their order."""
    assert convex_outline("vertices", SQUARE) == SQUARE


def test_outline_clockwise_is_turned_round_and_keeps_its_first_corner() -> None:
    """The other way round is the same polygon, begun at the same corner."""
    assert convex_outline("vertices", SQUARE[:1] + SQUARE[:0:-1]) == SQUARE


@pytest.mark.parametrize("place", range(4))
@pytest.mark.parametrize("part", [0.5, 0.1, 1 / 3])
def test_outline_vertex_on_an_edge_is_left_out(place: int, part: float) -> None:
    """A vertex between two corners is no corner, wherever it stands in the list."""
    (ax, ay), (bx, by) = SQUARE[place], SQUARE[(place + 1) % 4]
    extra = (ax + part * (bx - ax), ay + part * (by - ay))
    longer = [*SQUARE[: place + 1], extra, *SQUARE[place + 1 :]]
    assert convex_outline("vertices", longer) == SQUARE


def test_outline_first_vertex_on_an_edge_is_left_out() -> None:
    """Then the outline begins with the first vertex that is a corner."""
    assert (
        convex_outline("vertices", [(1.0, 0.0), *SQUARE[1:], SQUARE[0]]) == SQUARE[1:] + SQUARE[:1]
    )


def test_outline_many_vertices_on_every_edge_are_left_out() -> None:
    """A square drawn in 400 small steps has four corners."""
    steps = [
        (ax + (bx - ax) * k / 100, ay + (by - ay) * k / 100)
        for (ax, ay), (bx, by) in zip(SQUARE, SQUARE[1:] + SQUARE[:1], strict=True)
        for k in range(100)
    ]
    assert convex_outline("vertices", steps) == SQUARE


@given(
    turn=st.floats(-4, 4), x=st.floats(-1e6, 1e6), y=st.floats(-1e6, 1e6), part=st.floats(0.1, 0.9)
)
def test_outline_vertex_on_an_edge_but_for_rounding_is_left_out(
    turn: float, x: float, y: float, part: float
) -> None:
    """A turned and moved edge's inner vertex is off it by rounding, inwards or outwards."""
    c, s = math.cos(turn), math.sin(turn)
    vertices = [*SQUARE, (0.0, 2 * part)]
    moved = [(x + c * px - s * py, y + s * px + c * py) for px, py in vertices]
    assert convex_outline("vertices", moved) == moved[:4]


@given(st.floats(-3, 3), st.floats(0.1, 1.9))
def test_outline_corner_that_stands_out_by_less_than_a_ten_thousandth_is_none(
    power: float, at: float
) -> None:
    """Inwards it is no dent, outwards no corner; by more than that it is one or the other."""
    off = STRAIGHT * 10.0**power * 2.0
    corners = [*SQUARE, (-off, at)]
    assume(abs(power) > 0.1)
    assert len(convex_outline("vertices", corners)) == (4 if power < 0 else 5)


@settings(deadline=None)
@given(st.integers(3, 3000), st.floats(0.01, 100))
def test_outline_of_many_corners_stays_where_it_is(sides: int, radius: float) -> None:
    """However many vertices are left out, the polygon still reaches as far as the circle."""
    circle = [
        (radius * math.cos(2 * math.pi * k / sides), radius * math.sin(2 * math.pi * k / sides))
        for k in range(sides)
    ]
    corners = convex_outline("vertices", circle)
    ends = corners[1:] + corners[:1]
    within = min(abs(cross(a, b)) / math.dist(a, b) for a, b in zip(corners, ends, strict=True))
    deepest = radius * math.cos(math.pi / sides)
    assert within >= deepest - 2.1 * STRAIGHT * radius


def test_outline_tiny_triangle_far_away_keeps_its_three_corners() -> None:
    """A nanometre wide and a million metres from the origin there is still an area."""
    far, side = 2.0**20, 2.0**-30
    triangle = [(far, 0.0), (far + side, 0.0), (far, side)]
    assert convex_outline("vertices", triangle) == triangle


@pytest.mark.parametrize(
    ("vertices", "message"),
    [
        ([(0, 0), (4, 0), (1, 1), (0, 4)], r"must be convex: .* got \(1.0, 1.0\) at index 2"),
        ([*SQUARE, (1e-3, 1.0)], r"must be convex: .* got \(0.001, 1.0\) at index 4"),
        (PENTAGRAM, "must go round once and not cross itself, got 2 times"),
        ([(0, 0), (4, 0), (0, 2), (5, 5)], "must be convex"),
        ([(0, 0), (4, 0), (2, 0), (2, 3)], "must be convex"),
        ([*SQUARE, SQUARE[0]], r"must not repeat a neighbour .* \(0.0, 0.0\) at index 4 and 0"),
        ([*SQUARE[:2], *SQUARE[1:]], r"must not repeat a neighbour .* at index 1 and 2"),
        ([(0, 0), (1, 1), (2, 2)], r"must have an area > 0 m\^2"),
        ([(0, 0), (1, 0)], r"must have shape \(N, 2\), N >= 3, got shape \(2, 2\)"),
        ([(0, 0, 0)] * 3, r"must have shape \(N, 2\), N >= 3, got shape \(3, 3\)"),
        ([(0, 0), (1, math.nan), (0, 1)], r"must be finite, got nan at index \(1, 1\)"),
        ([(0, 0), (math.inf, 0), (0, 1)], r"must be finite, got inf"),
    ],
    ids=[
        "dent",
        "dent of a millimetre",
        "pentagram",
        "bow tie",
        "spike",
        "closed ring",
        "repeated vertex",
        "on one line",
        "two vertices",
        "three coordinates",
        "nan",
        "infinite",
    ],
)
def test_outline_bad_vertices_are_refused_by_name(vertices: Any, message: str) -> None:
    """The error says which argument, which rule and which vertex."""
    with pytest.raises(ValueError, match="^vertices " + message):
        convex_outline("vertices", vertices)


def test_outline_not_numbers_is_a_type_error() -> None:
    """Words are no coordinates."""
    with pytest.raises(TypeError, match="vertices must be a real number or an array of them"):
        convex_outline("vertices", [("a", "b"), ("c", "d"), ("e", "f")])

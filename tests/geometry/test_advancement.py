"""Turning shapes: times by hand, the promised side of the impact, and that the search ends."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.engine.core.rows import BodyRow
from lesson_code.geometry import Circle, Polygon, Segment, Shape, advancement
from lesson_code.geometry.advancement import (
    TOLERANCE,
    Moving,
    advance,
    advance_to_impact,
    pose_at,
    shortest_way_out,
)
from lesson_code.geometry.rows import Corner, corner_rows
from lesson_code.geometry.safe_time import Motion
from lesson_code.geometry.separation import separation_rows

CLOSE = 1e-11
"""s: a gap of some 1e-12 m at some 1 m/s, and roundings."""

DURATION = 2.0
"""s."""

BOX = Polygon.box(2, 2)
ROD = Segment((-1, 0), (1, 0))
THIN = Segment((0, -1), (0, 1), 0.0005)
WALL = Segment((0, -9), (0, 9))
DISC = Circle(0.5)

State = tuple[float, float, float]


def pair(
    shape_a: Shape, pose_a: State, move_a: State, shape_b: Shape, pose_b: State, move_b: State
) -> tuple[list[Corner], Moving, Moving, float]:
    """Return two moving shapes as rows, and the usual tolerance for them."""
    corners: list[Corner] = []
    rows = []
    for shape, pose, velocity in ((shape_a, pose_a, move_a), (shape_b, pose_b, move_b)):
        first = len(corners)
        corners += corner_rows(shape.outline)
        rows.append(Moving(*pose, *velocity, shape.rounding, first, len(shape.outline)))
    sizes = shape_a.bounding_radius + shape_b.bounding_radius
    return corners, rows[0], rows[1], TOLERANCE * sizes


def looks(monkeypatch: pytest.MonkeyPatch, *shapes_and_states: object) -> int:
    """Return how often the search looks at the distance."""
    count = 0

    def counted(*arguments: object) -> tuple[float, float, float]:
        nonlocal count
        count += 1
        return separation_rows(*arguments)  # type: ignore[arg-type]

    corners, a, b, tolerance = pair(*shapes_and_states)  # type: ignore[arg-type]
    with monkeypatch.context() as patch:
        patch.setattr(advancement, "separation_rows", counted)
        _, is_certain = advance(corners, a, b, 10.0, tolerance)
    assert is_certain
    return count


STILL = (0.0, 0.0, 0.0)


def time_of_turning_rod() -> float:
    """Return when t + abs(cos t) = 1 + pi / 2, after pi / 2, by bisection."""
    low, high = math.pi / 2, math.pi
    for _ in range(60):
        middle = (low + high) / 2
        if middle + abs(math.cos(middle)) < 1 + math.pi / 2:
            low = middle
        else:
            high = middle
    return low


@pytest.mark.parametrize(
    ("shape", "pose", "velocity", "time"),
    [
        pytest.param(ROD, (-0.5, 0, math.pi / 2), (0, 0, -1), math.pi / 6, id="rod, on its tip"),
        pytest.param(ROD, (-0.5, 0, math.pi / 2), (0, 0, 1), math.pi / 6, id="rod, other tip"),
        pytest.param(ROD, (-3, 0, math.pi / 2), (1, 0, 0), 3, id="rod, flat, not turning"),
        pytest.param(
            ROD, (-1 - math.pi / 2, 0, 0), (1, 0, 1), time_of_turning_rod(), id="rod, coming"
        ),
        pytest.param(ROD, (-2, 0, math.pi / 2), (0, 0, 9), math.inf, id="rod, too short"),
        pytest.param(ROD, (-3, 0, 0), (0, 5, 5), math.inf, id="rod, passing"),
        pytest.param(
            BOX,
            (-1.25, 0, 0),
            (0, 0, 1),
            math.asin(1.25 / math.sqrt(2)) - math.pi / 4,  # sqrt(2) sin(45 deg + angle) = 1.25
            id="box, on its corner",
        ),
        pytest.param(DISC, (-3, 0, 0), (1, 0, 99), 2.5, id="disc, its spin does not matter"),
        pytest.param(BOX, (-1, 0, 0), (0, 0, 1), 0, id="box, flat, turning into the wall"),
        pytest.param(BOX, (-1, 0, 0), (-2, 0, 1), math.inf, id="box, flat, leaving"),
        pytest.param(BOX, (-1, 0, 0), (0, 1, 0), math.inf, id="box, flat, sliding"),
        pytest.param(BOX, (-0.5, 0, 0), (1, 0, 0), 0, id="box, overlapping, coming"),
        pytest.param(BOX, (-0.5, 0, 0), (-1, 0, 0), math.inf, id="box, overlapping, leaving"),
    ],
)
def test_impact_on_a_wall_hand_worked(
    shape: Shape, pose: State, velocity: State, time: float
) -> None:
    """Where the angle at impact is known, and at every kind of start."""
    corners, a, b, tolerance = pair(shape, pose, velocity, WALL, STILL, STILL)
    measured = advance_to_impact(corners, a, b, 10.0, tolerance)
    assert measured == pytest.approx(time, abs=CLOSE)
    if 0 < time < math.inf:
        assert measured <= time


shapes = st.sampled_from([BOX, ROD, THIN, DISC, Polygon.regular(5, 1.3), Segment((0, 0), (2, 1))])
states = st.tuples(*[st.floats(-4, 4)] * 3)
spins = st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(-30, 30))


@given(shapes, states, spins, shapes, states, spins)
def test_impact_is_never_late_and_within_the_tolerance(
    shape_a: Shape,
    pose_a: State,
    velocity_a: State,
    shape_b: Shape,
    pose_b: State,
    velocity_b: State,
) -> None:
    """From a start apart: apart at every sample before, and within the tolerance at the time."""
    corners, a, b, tolerance = pair(shape_a, pose_a, velocity_a, shape_b, pose_b, velocity_b)

    def gap(t: float) -> float:
        return separation_rows(corners, a, b, pose_at(a, b, t))[0]

    assume(gap(0.0) > tolerance)
    time = advance_to_impact(corners, a, b, DURATION, tolerance)
    until = min(time, DURATION)
    assert all(gap(until * k / 200) > 0 for k in range(200))
    if time < math.inf:
        assert 0 < gap(time) <= tolerance


@given(shapes, states, spins, shapes, states, spins)
def test_impact_bodies_swapped_is_the_same(
    shape_a: Shape,
    pose_a: State,
    velocity_a: State,
    shape_b: Shape,
    pose_b: State,
    velocity_b: State,
) -> None:
    """Either order finds a time at which the gap is within the tolerance, or none.

    Positions in one place have the normal (1, 0), whichever comes first: there the order counts.
    """
    assume(pose_a[:2] != pose_b[:2])
    corners, a, b, tolerance = pair(shape_a, pose_a, velocity_a, shape_b, pose_b, velocity_b)
    there = advance_to_impact(corners, a, b, DURATION, tolerance)
    back = advance_to_impact(corners, b, a, DURATION, tolerance)
    if there == math.inf or back == math.inf:
        assert there == back
    else:
        for time in (there, back):
            assert separation_rows(corners, a, b, pose_at(a, b, time))[0] <= tolerance
        assert there == pytest.approx(back, abs=1e-6)  # a graze closes slowly


@pytest.mark.parametrize("speed", [1.0, 1e2, 1e4, 1e6])
@pytest.mark.parametrize("spin", [1.0, 1e3, 1e6])
@pytest.mark.parametrize("thickness", [1e-3, 1.0])
def test_impact_spinning_rod_never_tunnels(speed: float, spin: float, thickness: float) -> None:
    """At any speed and spin a rod meets a wall between the circle round it and its middle."""
    wall = Segment((0, -9), (0, 9), thickness / 2)
    corners, a, b, tolerance = pair(ROD, (-5, 0, 1), (speed, 0, spin), wall, STILL, STILL)
    time, is_certain = advance(corners, a, b, 10.0, tolerance)
    assert is_certain
    assert 4 - thickness / 2 - CLOSE < speed * time < 5 - thickness / 2
    assert separation_rows(corners, a, b, pose_at(a, b, time))[0] <= tolerance


@pytest.mark.parametrize(
    ("case", "most"),
    [
        pytest.param((BOX, (-5, 0, 0), (1, 0, 0), WALL, STILL, STILL), 2, id="not turning"),
        pytest.param((ROD, (-3, 0, 0), (1, 0, 1), WALL, STILL, STILL), 8, id="turning"),
        pytest.param((ROD, (-3, 0, 0), (1, 0, 1e6), WALL, STILL, STILL), 30, id="fast spin"),
        pytest.param((BOX, (-4, 0, 0), (1, 0, 5), BOX, (1, 0, 1), (0, 0, -7)), 25, id="two boxes"),
        pytest.param(
            (Polygon.regular(64, 1), (-5, 0, 0), (1, 0, 1e3), WALL, STILL, STILL),
            25,
            id="wheel of 64 corners",
        ),
        pytest.param((ROD, (-1.001, 0, 0), (0, 0, 100), WALL, STILL, STILL), 3, id="spin, no hit"),
        pytest.param((BOX, (0, 0, 0), (0, 0, 3), BOX, (5, 0, 0), (0, 0, 3)), 3, id="far apart"),
    ],
)
def test_search_ends_after_few_looks(
    monkeypatch: pytest.MonkeyPatch, case: tuple[object, ...], most: int
) -> None:
    """Each step squares the error, and a body that spins fast waits for the circle round it."""
    assert looks(monkeypatch, *case) <= most


def test_search_of_gears_takes_some_looks_a_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two squares that turn past each other for 10 s at 1 rad/s, and never touch."""
    gears = (BOX, STILL, (0, 0, 1), BOX, (2.45, 0, math.pi / 4), (0, 0, -1))
    assert looks(monkeypatch, *gears) < 100


def test_search_that_is_given_up_says_how_far_it_came(monkeypatch: pytest.MonkeyPatch) -> None:
    """The time is one until which the bodies do not touch, and it is marked."""
    monkeypatch.setattr(advancement, "MOST_LOOKS", 50)
    corners, a, b, tolerance = pair(BOX, STILL, (0, 0, 1), BOX, (2.45, 0, math.pi / 4), (0, 0, -1))
    time, is_certain = advance(corners, a, b, 1e6, tolerance)
    assert not is_certain
    assert 1 < time < 100
    assert advance_to_impact(corners, a, b, 1e6, tolerance) == time


def test_search_far_in_time_ends_where_floats_do() -> None:
    """After 1e9 s a float of time is 1e-7 s wide; the search ends on it, and does not hang."""
    corners, a, b, tolerance = pair(BOX, (-1e9, 0, 0), (1, 0, 1e-9), BOX, (2, 0, 0), STILL)
    time, is_certain = advance(corners, a, b, 1e10, tolerance)
    assert is_certain
    assert time == pytest.approx(1e9, rel=1e-6)


def test_overlap_that_is_left_does_not_hide_the_next_impact() -> None:
    """A rod that starts across a wall and swings out of it comes round and hits it again.

    Its middle is 0.9 m before the wall and moves back at 0.01 m/s: its other end still reaches it.
    """
    corners, a, b, tolerance = pair(ROD, (-0.9, 0, 0), (-0.01, 0, 1), WALL, STILL, STILL)
    time = advance_to_impact(corners, a, b, 10.0, tolerance)
    assert math.pi / 2 < time < math.pi
    gap = separation_rows(corners, a, b, pose_at(a, b, time))[0]
    assert abs(gap) <= tolerance


def test_shortest_way_out_hand_worked() -> None:
    """At 3 m/s and 2 rad/s on an arm of 1 m no point is faster than 5 m/s."""
    assert shortest_way_out(Motion(3.0, 0.0, 2.0, 0.0, 1.0, 9.0), 10.0) == 2.0
    assert shortest_way_out(Motion(0.0, 0.0, 0.0, 0.0, 1.0, 1.0), 10.0) == math.inf


def test_rows_of_the_engine_are_taken_as_they_are_and_not_changed() -> None:
    """A BodyRow has all the fields that are read; neither it nor the corners change."""
    corners = corner_rows(BOX.outline) + corner_rows(WALL.outline)
    before = [(c.x, c.y, c.nx, c.ny) for c in corners]
    box = BodyRow(x=-3.0, vx=1.0, w=1.0, first_corner=0, corner_count=4)
    wall = BodyRow(first_corner=4, corner_count=2)
    time = advance_to_impact(corners, box, wall, 10.0, 1e-12)
    assert 3 - math.sqrt(2) < time < 2
    assert [(c.x, c.y, c.nx, c.ny) for c in corners] == before
    assert (box.x, box.angle, box.cos) == (-3.0, 0.0, 1.0)

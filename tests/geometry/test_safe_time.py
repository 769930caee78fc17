"""Safe times: never too long, whatever turns; and long enough to get there."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.geometry import Circle, Polygon, Segment, Shape
from lesson_code.geometry.advancement import Moving, pose_at
from lesson_code.geometry.rows import Corner, corner_rows
from lesson_code.geometry.safe_time import (
    Axis,
    axis_time,
    leading_corner,
    motion_of,
    motion_seen_from_b,
    safe_time,
    wait_for_bounds,
)
from lesson_code.geometry.separation import separation_rows

FEW_ROUNDINGS = 1e-14
"""Of lengths and times of size 1 to 10."""

LIMIT = 2.0
"""s."""

LOOKS = 40
"""At how many times of a safe time the distance is measured."""

BOX = Polygon.box(2, 2)
ROD = Segment((-1, 0), (1, 0))
PLANK = Segment((-2, 0), (1, 0), 0.2)
DISC = Circle(0.5)

State = tuple[float, float, float]


def moving(shape: Shape, pose: State, velocity: State, corners: list[Corner]) -> Moving:
    """Return the row of a moving shape, and append its outline to the corners."""
    first = len(corners)
    corners += corner_rows(shape.outline)
    return Moving(*pose, *velocity, shape.rounding, first, len(shape.outline))


shapes = st.sampled_from([BOX, ROD, PLANK, DISC, Polygon.regular(5, 1.3)])
states = st.tuples(*[st.floats(-4, 4)] * 3)
spins = st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(-30, 30))


@given(shapes, states, spins, shapes, states, spins, st.floats(0, 0.5))
def test_safe_time_distance_never_falls_below_the_target(
    shape_a: Shape,
    pose_a: State,
    velocity_a: State,
    shape_b: Shape,
    pose_b: State,
    velocity_b: State,
    target: float,
) -> None:
    """For all of a safe time the distance stays above the target."""
    corners: list[Corner] = []
    a = moving(shape_a, pose_a, velocity_a, corners)
    b = moving(shape_b, pose_b, velocity_b, corners)
    at, motion = pose_at(a, b, 0.0), motion_of(corners, a, b)
    gap, nx, ny = separation_rows(corners, a, b, at)
    assume(gap > target)
    safe = safe_time(corners, a, b, at, motion, gap, nx, ny, target, LIMIT)
    assert safe > 0
    for k in range(LOOKS + 1):
        later = pose_at(a, b, min(safe, LIMIT) * k / LOOKS)
        assert separation_rows(corners, a, b, later)[0] > target - FEW_ROUNDINGS


@given(shapes, states, spins, shapes, states, spins)
def test_safe_time_is_at_least_distance_over_the_largest_speed(
    shape_a: Shape,
    pose_a: State,
    velocity_a: State,
    shape_b: Shape,
    pose_b: State,
    velocity_b: State,
) -> None:
    """On this the proof rests that the search ends."""
    corners: list[Corner] = []
    a = moving(shape_a, pose_a, velocity_a, corners)
    b = moving(shape_b, pose_b, velocity_b, corners)
    at, motion = pose_at(a, b, 0.0), motion_of(corners, a, b)
    gap, nx, ny = separation_rows(corners, a, b, at)
    speed = math.hypot(motion.vx, motion.vy)
    speed += abs(motion.w_a) * motion.size_a + abs(motion.w_b) * motion.size_b
    assume(gap > 0)
    assume(speed > 0)
    safe = safe_time(corners, a, b, at, motion, gap, nx, ny, 0.0, LIMIT)
    assert safe * speed >= min(gap, LIMIT * speed) * (1 - FEW_ROUNDINGS)


@pytest.mark.parametrize(
    ("velocity", "expected"),
    [
        pytest.param((-2, 0, 0), 1.5, id="not turning: to the touch in one step"),
        pytest.param((2, 0, 0), math.inf, id="leaving"),
        pytest.param((0, 9, 0), math.inf, id="passing at a distance"),
        pytest.param((-2, 0, 1e9), 1.5, id="disc: its spin does not matter"),
    ],
)
def test_safe_time_of_a_disc_hand_worked(velocity: State, expected: float) -> None:
    """A box whose face is at x = 1, and a disc of radius 0.5 m whose surface is at x = 4."""
    corners: list[Corner] = []
    a = moving(BOX, (0, 0, 0), (0, 0, 0), corners)
    b = moving(DISC, (4.5, 0, 0), velocity, corners)
    at, motion = pose_at(a, b, 0.0), motion_of(corners, a, b)
    gap, nx, ny = separation_rows(corners, a, b, at)
    safe = safe_time(corners, a, b, at, motion, gap, nx, ny, 0.0, 10.0)
    assert safe == pytest.approx(expected, rel=FEW_ROUNDINGS)


def test_safe_time_of_a_fast_spin_waits_for_the_circle_round_it() -> None:
    """A rod of half length 1 m, 3 m away, cannot arrive before 2 s at 1 m/s, however it spins."""
    corners: list[Corner] = []
    wall = moving(Segment((0, -9), (0, 9)), (0, 0, 0), (0, 0, 0), corners)
    rod = moving(ROD, (3, 0, math.pi / 2), (-1, 0, 1e6), corners)
    at, motion = pose_at(wall, rod, 0.0), motion_of(corners, wall, rod)
    gap, nx, ny = separation_rows(corners, wall, rod, at)
    assert gap == pytest.approx(3)
    safe = safe_time(corners, wall, rod, at, motion, gap, nx, ny, 0.0, 10.0)
    assert safe == pytest.approx(2, rel=FEW_ROUNDINGS)


@pytest.mark.parametrize("part", [1e-1, 1e-2, 1e-3])
def test_safe_time_error_is_of_second_order(part: float) -> None:
    """Halfway to an impact at t, a step reaches it but for about t^2: Newton's convergence.

    The tip of a rod of 1 m, turning at 1 rad/s, comes down on a floor.
    """
    corners: list[Corner] = []
    floor = moving(Segment((-9, 0), (9, 0)), (0, 0, 0), (0, 0, 0), corners)
    rod = moving(Segment((0, 0), (1, 0)), (0, math.sin(0.5 + part), 0), (0, 0, -1), corners)
    rod.angle = -0.5
    at, motion = pose_at(floor, rod, 0.0), motion_of(corners, floor, rod)
    gap, nx, ny = separation_rows(corners, floor, rod, at)
    safe = safe_time(corners, floor, rod, at, motion, gap, nx, ny, 0.0, 10.0)
    assert part - part**2 < safe < part


def test_axis_time_axis_without_a_gap_is_zero() -> None:
    """Along an axis on which the intervals overlap nothing can be said."""
    corners: list[Corner] = []
    a = moving(BOX, (0, 0, 0), (0, 0, 1), corners)
    b = moving(BOX, (5, 1, 0), (0, 1, 0), corners)
    at, motion = pose_at(a, b, 0.0), motion_of(corners, a, b)
    for turning in (0.0, 1.0):
        axis = Axis(0.0, 1.0, turning)
        assert axis_time(corners, a, b, at, motion, axis, 0.0, LIMIT) == 0.0


def test_leading_corner_is_the_one_that_leads_later() -> None:
    """A rod at rest on its left end: the right one is lower now, but rises and leads after 1 s.

    Heights of (-1, 0) and (1, -0.5): 0 and -0.5 m; rates at 1 rad/s: -1 and 1 m/s; bends: 1 m/s^2
    times the distance from the rod's position.
    """
    corners = corner_rows([(-1.0, 0.0), (1.0, -0.5)])
    rod = Moving(first_corner=0, corner_count=2)
    assert leading_corner(corners, rod, 0.0, 1.0, 1.0, 0.0) == (0.0, -1.0, 1.0)
    assert leading_corner(corners, rod, 0.0, 1.0, 1.0, 1.0) == (-0.5, 1.0, math.sqrt(1.25))


def test_corner_at_its_body_s_position_does_not_bend_the_gap() -> None:
    """A door turns about its hinge, which lies on a wall: safe until the door comes round.

    The hinge stays where it is, for ever at the distance 0; the door's end is at height 2 and
    falls as a parabola with 2 m/s^2 at first.
    """
    corners = corner_rows([(0.0, 0.0), (0.0, 2.0), (-9.0, 0.0), (9.0, 0.0)])
    door = Moving(w=1.0, first_corner=0, corner_count=2)
    wall = Moving(first_corner=2, corner_count=2)
    at, motion = pose_at(wall, door, 0.0), motion_of(corners, wall, door)
    axis = Axis(0.0, 1.0, 0.0)
    time = axis_time(corners, wall, door, at, motion, axis, -1e-12, 3.0)
    assert time == pytest.approx(math.sqrt(2.0), rel=1e-9)


def test_bounds_that_overlap_give_nothing_to_wait_for() -> None:
    """Circles round the rods, 1 m each: 2.5 m apart they wait 0.5 s, 1.5 m apart not."""
    for distance, wait in ((2.5, 0.5), (1.5, 0.0)):
        corners: list[Corner] = []
        a = moving(ROD, (0, 0, 0), (0, 0, 1), corners)
        b = moving(ROD, (distance, 0, 0), (-1, 0, 1), corners)
        motion = motion_of(corners, a, b)
        assert wait_for_bounds(a, b, pose_at(a, b, 0.0), motion, 0.0) == pytest.approx(wait)


def test_motion_seen_from_b_twice_is_as_before() -> None:
    """Exchanging the bodies is its own inverse. A circle's spin is left out."""
    corners: list[Corner] = []
    a = moving(BOX, (0, 0, 0), (1, 2, 3), corners)
    b = moving(DISC, (5, 0, 0), (4, 4, 4), corners)
    motion = motion_of(corners, a, b)
    assert motion == (3, 2, 3, 0, pytest.approx(2**0.5), 0)
    assert motion_seen_from_b(motion)[:4] == (-3, -2, 0, 3)
    assert motion_seen_from_b(motion_seen_from_b(motion)) == motion

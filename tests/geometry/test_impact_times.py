"""Impacts of a circle in closed form: by hand, at the degenerate places, and against motion."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry import Circle, Polygon, Segment, collide
from lesson_code.geometry.impact_times import (
    circle_impact_time,
    circle_outline_impact_time,
    line_impact_time,
)
from lesson_code.geometry.manifold import collide_rows
from lesson_code.geometry.nearest_feature import path_point
from lesson_code.geometry.rows import Corner, ManifoldRow, Placed, place
from lesson_code.geometry.shapes import Shape
from lesson_code.geometry.straight_impact_times import straight_impact_time

FEW_ROUNDINGS = 1e-14
"""Of times and lengths of size 1: some dozen operations, rounded to 1e-16 each."""

SAMPLES = 4_001
"""In 4 s: 1 ms apart, in which a body here moves by 4 mm at most."""

SAMPLED = 2.1e-3
"""s: two samples."""

never = math.inf
number = st.floats(-4, 4)
size = st.floats(0.1, 2)


def outline_rows(shape: Shape, angle: float = 0.0) -> tuple[list[Corner], Placed]:
    """Return a shape at the origin, as rows."""
    corners: list[Corner] = []
    return corners, place(shape.outline, shape.rounding, (0.0, 0.0, angle), corners)


@pytest.mark.parametrize(
    ("gap", "v", "a", "time"),
    [
        pytest.param(3, -2, 0, 1.5, id="steady"),
        pytest.param(5, 0, -10, 1, id="let go"),
        pytest.param(15, 10, -10, 3, id="thrown up"),
        pytest.param(15, -10, -10, 1, id="thrown down"),
        pytest.param(4, -5, 2, 1, id="braking, but arrives"),
        pytest.param(4, -4, 2, never, id="braking, stops just at the face: it grazes"),
        pytest.param(4, -3, 2, never, id="braking, stops before"),
        pytest.param(3, 2, 0, never, id="leaving"),
        pytest.param(3, 2, 1, never, id="leaving ever faster"),
        pytest.param(3, 0, 0, never, id="at rest, apart"),
        pytest.param(0, -1, 0, 0, id="touching, coming"),
        pytest.param(0, -1, 9, 0, id="touching, coming, braking"),
        pytest.param(0, 1, 0, never, id="touching, leaving"),
        pytest.param(0, 0, 0, never, id="touching, at rest"),
        pytest.param(0, 0, -10, 0, id="touching, at rest, pulled in"),
        pytest.param(0, 0, 10, never, id="touching, at rest, pulled out"),
        pytest.param(0, 5, -10, 1, id="thrown up from the face"),
        pytest.param(-1, -1, 5, 0, id="overlapping, coming"),
        pytest.param(-1, 1, 0, never, id="overlapping, leaving"),
        pytest.param(-1, 6, -10, 1, id="overlapping, leaves and comes back"),
        pytest.param(-10, 10, -10, 1, id="overlapping, turns before it has left"),
        pytest.param(-0.5, 0, -1, 0, id="overlapping, at rest, pulled in"),
        pytest.param(-0.5, 0, 1, never, id="overlapping, at rest, pulled out"),
    ],
)
def test_line_time_hand_worked(gap: float, v: float, a: float, time: float) -> None:
    """Roots of gap + v t + a t^2 / 2 with whole numbers, and every kind of start."""
    assert line_impact_time(float(gap), float(v), float(a)) == time


def test_line_time_after_a_bounce_is_that_of_the_next_one() -> None:
    """A gap that is 0 but for rounding is not a new impact: the ball flies for 2 v / g."""
    for gap in (1e-17, 0.0, -1e-17):
        assert line_impact_time(gap, 3.0, -9.81) == pytest.approx(
            6 / 9.81, rel=FEW_ROUNDINGS, abs=0
        )


def test_line_time_small_gap_keeps_all_its_digits() -> None:
    """The textbook form of the root would subtract 1 from 1.000...: nothing would be left."""
    gap = 1e-18
    assert line_impact_time(gap, -1.0, -10.0) == pytest.approx(gap, rel=FEW_ROUNDINGS, abs=0)
    textbook = (-1.0 + math.sqrt(1.0 + 20.0 * gap)) / 10.0
    assert textbook == 0.0


@pytest.mark.parametrize(
    ("d", "v", "a", "radius_sum", "time"),
    [
        pytest.param((4, 0), (-2, 0), (0, 0), 1, 1.5, id="head-on"),
        pytest.param((5, 4), (-1, 0), (0, 0), 5, 2, id="3-4-5"),
        pytest.param((4, 1), (-2, 0), (0, 0), 1, never, id="grazing"),
        pytest.param((4, 1.5), (-2, 0), (0, 0), 1, never, id="passing"),
        pytest.param((4, 0), (2, 0), (0, 0), 1, never, id="parting"),
        pytest.param((4, 0), (0, 0), (0, 0), 1, never, id="at rest"),
        pytest.param((1, 0), (-1, 0), (0, 0), 1, 0, id="touching, coming"),
        pytest.param((1, 0), (1, 0), (0, 0), 1, never, id="touching, parting"),
        pytest.param((1, 0), (0, 1), (0, 0), 1, never, id="touching, passing"),
        pytest.param((0.5, 0), (-1, 0), (0, 0), 1, 0, id="overlapping, coming"),
        pytest.param((0.5, 0), (1, 0), (0, 0), 1, never, id="overlapping, parting"),
        pytest.param((0, 0), (1, 0), (0, 0), 1, never, id="coincident: it can only part"),
        pytest.param((0, 0), (0, 0), (0, 0), 1, never, id="coincident, at rest"),
        pytest.param((0, 6), (0, 0), (0, -10), 1, 1, id="let go above a disc"),
        pytest.param((0, 1), (0, 5), (0, -10), 1, 1, id="thrown up from a disc"),
        pytest.param((0, 1), (0, 0), (0, -10), 1, 0, id="resting on a disc"),
        pytest.param((0, 1), (1, 0), (0, -10), 1, 0, id="rolling over it slowly: pulled in"),
        pytest.param((0, 1), (4, 0), (0, -10), 1, never, id="rolling over it fast: flies off"),
        pytest.param((0, -1), (0, 0), (0, -10), 1, never, id="hanging below a disc: falls"),
        pytest.param((0, 0.5), (0, 5), (0, -10), 1, (5 + 15**0.5) / 10, id="up from within"),
        pytest.param((0, 0.5), (0, 1), (0, -10), 1, 0.1, id="up from within, not out of it"),
        pytest.param((0, -7), (0, 10), (0, -10), 1, never, id="thrown up, turns 1 m below it"),
        pytest.param((0, -6), (0, 10), (0, -10), 1, never, id="thrown up, just reaches it"),
        pytest.param((2, 0), (0, 0), (0, 0), 0, never, id="a point has no size to be hit"),
    ],
)
def test_circle_time_hand_worked(
    d: tuple[float, float],
    v: tuple[float, float],
    a: tuple[float, float],
    radius_sum: float,
    time: float,
) -> None:
    """Times with few digits, and every kind of start."""
    assert circle_impact_time(*map(float, (*d, *v, *a)), float(radius_sum)) == pytest.approx(
        time, abs=FEW_ROUNDINGS
    )


@pytest.mark.parametrize("speed", [1e-6, 1.0, 1e6, 1e100])
def test_circle_time_any_speed_is_distance_over_speed(speed: float) -> None:
    """A speed only sets the clock: 3 m at any speed, and no step that could jump over a hit."""
    assert straight_impact_time(4.0, 0.0, -speed, 0.0, 1.0) == pytest.approx(
        3 / speed, rel=FEW_ROUNDINGS, abs=0
    )


def test_circle_time_hair_above_grazing_is_a_hit() -> None:
    """One float less than grazing overlaps for 4e-8 m of the way, and is found."""
    below = math.nextafter(1.0, 0.0)
    assert circle_impact_time(4.0, 1.0, -1.0, 0.0, 0.0, 0.0, 1.0) == never
    assert circle_impact_time(4.0, below, -1.0, 0.0, 0.0, 0.0, 1.0) == pytest.approx(4.0, abs=1e-7)


def test_circle_time_vanishing_acceleration_is_none() -> None:
    """An acceleration whose square is no float changes nothing, and divides nothing by 0."""
    straight = circle_impact_time(4.0, 0.5, -2.0, 0.0, 0.0, 0.0, 1.0)
    for a in (1e-30, 1e-160, 1e-200, 5e-324):
        assert circle_impact_time(4.0, 0.5, -2.0, 0.0, a, -a, 1.0) == pytest.approx(
            straight, rel=FEW_ROUNDINGS
        )


FLOOR = Segment((-9, 0), (9, 0))
PLANK = Segment((-2, 0), (2, 0), 0.25)
BOX = Polygon.box(4, 2)


@pytest.mark.parametrize(
    ("shape", "d", "v", "radius", "time", "feature"),
    [
        pytest.param(FLOOR, (0, 3), (0, -1), 1, 2, 0, id="line, from its left side"),
        pytest.param(FLOOR, (0, -3), (0, 1), 1, 2, 1, id="line, from its right side"),
        pytest.param(FLOOR, (11, 0), (-1, 0), 1, 1, -1, id="line, on its end"),
        pytest.param(FLOOR, (-11, 0), (1, 0), 1, 1, -2, id="line, on its start"),
        pytest.param(FLOOR, (9.375, 2.5), (0, -1), 0.625, 2, -1, id="line, round its end"),
        pytest.param(FLOOR, (11, 1), (-1, 0), 1, never, -1, id="line, grazing its side"),
        pytest.param(FLOOR, (0, 1), (1, 0), 1, never, 0, id="line, sliding on it"),
        pytest.param(FLOOR, (0, 1), (0, 1), 1, never, 0, id="line, touching and leaving"),
        pytest.param(FLOOR, (0, 1), (0, -1), 1, 0, 0, id="line, touching and coming"),
        pytest.param(PLANK, (0, 3.25), (0, -1), 1, 2, 0, id="plank, face"),
        pytest.param(PLANK, (4.25, 0), (-1, 0), 1, 1, -1, id="plank, end"),
        pytest.param(BOX, (0, 4), (0, -1), 1, 2, 2, id="box, top"),
        pytest.param(BOX, (5, 0), (-1, 0), 1, 2, 1, id="box, side"),
        pytest.param(BOX, (2.375, 3.5), (0, -1), 0.625, 2, -3, id="box, corner"),
        pytest.param(BOX, (4, 3), (-1, -1), 0.625, 2 - 0.625 / 2**0.5, -3, id="box, corner on"),
        pytest.param(BOX, (9, 2), (-1, 0), 1, never, -3, id="box, grazing its top"),
        pytest.param(BOX, (9, 9), (-1, 1), 1, never, -3, id="box, missed"),
        pytest.param(BOX, (0, 0.5), (0, -1), 1, 0, 2, id="box, centre inside, coming"),
        pytest.param(BOX, (0, 0.5), (0, 1), 1, never, 2, id="box, centre inside, leaving"),
        pytest.param(BOX, (0, 0.5), (1, 0), 1, never, 2, id="box, centre inside, sliding"),
        pytest.param(BOX, (2.3, 1.4), (1, 1), 1, never, -3, id="box, over a corner, leaving"),
        pytest.param(BOX, (2.3, 1.4), (-1, 0), 1, 0, -3, id="box, over a corner, coming"),
        pytest.param(BOX, (0, 5), (0, 0), 1, never, 2, id="box, at rest"),
    ],
)
def test_outline_time_hand_worked(
    shape: Shape,
    d: tuple[float, float],
    v: tuple[float, float],
    radius: float,
    time: float,
    feature: int,
) -> None:
    """Faces, ends and corners, hit, grazed, touched and left, with their names."""
    measured = circle_outline_impact_time(*outline_rows(shape), *d, *v, 0.0, 0.0, radius)
    assert measured == (pytest.approx(time, abs=FEW_ROUNDINGS), feature)


@pytest.mark.parametrize(
    ("d", "v", "time", "feature"),
    [
        pytest.param((0, 7), (0, 0), 1, 2, id="falls on the top"),
        pytest.param((0, 2), (0, 5), 1, 2, id="thrown up from the top"),
        pytest.param((0, 2), (1, 0), 0, 2, id="slides on the top: pulled in"),
        pytest.param((-5, 0.5), (2, 5), 1, 3, id="lobbed against the side"),
        pytest.param((-4.6, 1.8), (2, 5), 1, -4, id="lobbed at the corner"),
        pytest.param((0, -5), (0, 5), never, 0, id="thrown up from below, not far enough"),
        pytest.param((0, 1.5), (0, 1), 0.1, 2, id="overlapping, turns before it has left"),
        pytest.param((0, -1.5), (0, 0), never, 0, id="overlapping below, falls out"),
    ],
)
def test_outline_time_with_gravity_hand_worked(
    d: tuple[float, float], v: tuple[float, float], time: float, feature: int
) -> None:
    """A ball of radius 1 m and a box, with g = 10 m/s^2."""
    measured = circle_outline_impact_time(*outline_rows(BOX), *d, *v, 0.0, -10.0, 1.0)
    assert measured == (pytest.approx(time, abs=FEW_ROUNDINGS), feature)


def test_outline_time_ball_that_leaves_a_face_comes_back_to_the_corner() -> None:
    """A ball thrown up from a box sinks into a corner's circle only when it has come down beside.

    While it overlaps the top, it also overlaps the circle about the corner; that is not an impact.
    """
    corners, box = outline_rows(BOX)
    d, v, a = (1.5, 1.9), (0.7, 5.0), (0.0, -10.0)
    time, feature = circle_outline_impact_time(corners, box, *d, *v, *a, 1.0)
    x, y = path_point(*d, *v, *a, time)
    assert feature == -3
    assert x > 2
    assert math.hypot(x - 2, y - 1) == pytest.approx(1, abs=FEW_ROUNDINGS)


shapes = st.sampled_from(
    [FLOOR, PLANK, BOX, Polygon.regular(3, 1.5), Polygon.regular(7, 0.7), Segment((0, 0), (1, 2))]
)


@given(shapes, st.floats(-4, 4), *[number] * 4, size)
def test_outline_time_overlapping_feature_is_the_contacts(
    shape: Shape, angle: float, dx: float, dy: float, vx: float, vy: float, radius: float
) -> None:
    """Overlapping means now or never, by the normal that the narrow phase finds."""
    corners, body = outline_rows(shape, angle)
    m = ManifoldRow()
    collide_rows(corners, body, Placed(dx, dy, radius=radius), m)
    if m.count == 0:
        return
    time, feature = circle_outline_impact_time(corners, body, dx, dy, vx, vy, 0.0, 0.0, radius)
    if feature >= 0:
        normal = (corners[feature].nx, corners[feature].ny)
    else:
        c = corners[-1 - feature]
        distance = math.hypot(dx - c.x, dy - c.y)
        normal = ((dx - c.x) / distance, (dy - c.y) / distance)
    assert (m.nx, m.ny) == pytest.approx(normal, abs=FEW_ROUNDINGS)
    if abs(vx * m.nx + vy * m.ny) > FEW_ROUNDINGS:
        assert time == (0.0 if vx * m.nx + vy * m.ny < 0 else never)


def gaps(shape: Shape, angle: float, radius: float, places: np.ndarray) -> np.ndarray:
    """Return the distance of a circle from a shape at many places; 0 where they overlap.

    Written with the closest points of all edges, and a count of crossings for the inside.
    """
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    outline = np.array(shape.outline) @ turn
    nearest, inside = np.full(len(places), np.inf), np.zeros(len(places), dtype=bool)
    for a, b in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        edge, from_a = b - a, places - a
        s = np.clip(from_a @ edge / (edge @ edge), 0, 1)
        nearest = np.minimum(nearest, np.hypot(*(from_a - s[:, None] * edge).T))
        if len(outline) > 2:
            crosses = (a[1] > places[:, 1]) != (b[1] > places[:, 1])
            side = edge[0] * from_a[:, 1] - edge[1] * from_a[:, 0]
            inside ^= crosses & ((side > 0) == (edge[1] > 0))
    return np.where(inside, 0.0, np.maximum(nearest - radius - shape.rounding, 0.0))


@given(shapes, *[number] * 4, st.sampled_from([(0, 0), (0, -2), (1, 1), (-3, 0.5)]), size)
def test_outline_time_is_the_first_overlap_of_a_sampled_path(
    shape: Shape,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    acceleration: tuple[float, float],
    radius: float,
) -> None:
    """From a start without overlap: no sample overlaps before the time, and one does after."""
    times = np.linspace(0, 4, SAMPLES)[:, None]
    velocity, a = np.array((vx, vy)), np.array(acceleration, dtype=float)
    places = np.array((dx, dy)) + velocity * times + a * times**2 / 2
    gap = gaps(shape, 0.3, radius, places)
    if gap[0] == 0:
        return
    corners, body = outline_rows(shape, 0.3)
    time, _ = circle_outline_impact_time(corners, body, dx, dy, vx, vy, *a.tolist(), radius)
    sampled = times[gap == 0, 0]
    if len(sampled):
        assert sampled[0] - SAMPLED < time <= sampled[0]
    elif time <= 4 - SAMPLED:  # overlaps between two samples only
        k = int(time / 1e-3)
        assert min(gap[k], gap[k + 1]) < SAMPLED**2


def test_contact_at_the_time_of_impact_has_no_penetration() -> None:
    """A hair later the narrow phase sees the contact, at the very feature; a hair before, none."""
    ball, ramp = Circle(0.5), Polygon([(0, 0), (4, 0), (0, 3)])
    corners, body = outline_rows(ramp)
    time, feature = circle_outline_impact_time(corners, body, 3.0, 4.0, -1.0, -2.0, 0.0, 0.0, 0.5)
    after, before = ((3.0 - t, 4.0 - 2 * t, 0.0) for t in (time + 1e-9, time - 1e-9))
    contact = collide(ramp, (0, 0, 0), ball, after)
    assert contact is not None
    assert contact.normal == pytest.approx((0.6, 0.8), abs=FEW_ROUNDINGS)
    assert (corners[feature].nx, corners[feature].ny) == pytest.approx((0.6, 0.8))
    assert contact.penetrations[0] == pytest.approx(2.2e-9, rel=1e-6, abs=0)
    assert collide(ramp, (0, 0, 0), ball, before) is None

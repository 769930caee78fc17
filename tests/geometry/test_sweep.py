"""The time of impact of two shapes: laws of motion, every kind of pair, and the faults it ends."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, example, given, reject
from hypothesis import strategies as st

from lesson_code.formulas import effective_mass, normal_impulse
from lesson_code.geometry import (
    Circle,
    Polygon,
    Segment,
    Shape,
    advancement,
    collide,
    time_of_impact,
)
from lesson_code.geometry.rows import Corner, place
from lesson_code.geometry.sweep import impact_time, is_grazing

FEW_ROUNDINGS = 1e-14
"""Of times and lengths of size 1 to 10: some dozen operations, rounded to 1e-16 each."""

SAME = 1e-9
"""s: two ways to one time differ by roundings of 1e-15 m, or for turning shapes by the tolerance of
1e-12 of their sizes, over the speed at which they close; slower than 0.01 m/s is left out."""

HAIR = 1e-6
"""s: a body that closes at 0.01 m/s overlaps by 1e-8 m after it."""

DURATION = 3.0
"""s."""

BOX = Polygon.box(2, 2)
ROD = Segment((-1, 0), (1, 0))
PLANK = Segment((-2, 0), (1, 0), 0.2)
FLOOR = Segment((-9, 0), (9, 0))
DISC = Circle(0.5)

State = tuple[float, float, float]
STILL = (0.0, 0.0, 0.0)

shapes = st.sampled_from([BOX, ROD, PLANK, DISC, Polygon.regular(5, 1.3), Segment((0, 0), (2, 1))])
poses = st.tuples(*[st.floats(-4, 4)] * 3)
velocities = st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.sampled_from([0.0, 0.0, -2.0, 5.0]))
Moving = tuple[Shape, State, State]


@st.composite
def meetings(draw: st.DrawFn) -> tuple[Moving, Moving]:
    """Return two moving shapes whose positions pass each other nearby within the duration."""
    a, b = draw(st.tuples(shapes, poses, velocities)), draw(st.tuples(shapes, poses, velocities))
    when, off_x, off_y = draw(st.floats(1, 2)), draw(st.floats(-1, 1)), draw(st.floats(-1, 1))
    vx = a[2][0] + (a[1][0] - b[1][0] + off_x) / when
    vy = a[2][1] + (a[1][1] - b[1][1] + off_y) / when
    return a, (b[0], b[1], (vx, vy, b[2][2]))


def moved(state: Moving, time: float) -> tuple[Shape, State]:
    """Return a shape and its pose after a time."""
    shape, (x, y, angle), (vx, vy, w) = state
    return shape, (x + vx * time, y + vy * time, angle + w * time)


def time_of(a: Moving, b: Moving, duration: float) -> float | None:
    """Return the time of impact of a drawn pair.

    A pair that slides along each other as it turns is left out: its search may be given up.
    """
    try:
        return time_of_impact(*a, *b, duration)
    except ValueError:
        reject()


def is_well_met(a: Moving, b: Moving, time: float | None) -> bool:
    """Return whether there is an impact that closes and is no graze: a hair later they overlap.

    Then a time is known well, whichever way it is found.
    """
    if time is None or time < HAIR:
        return False
    contact = collide(*moved(a, time + HAIR), *moved(b, time + HAIR))
    return contact is not None and max(contact.penetrations) > 1e-8


@pytest.mark.parametrize(
    ("a", "b", "time"),
    [
        pytest.param((DISC, (0, 0, 0), (2, 0, 0)), (DISC, (4, 0, 0), STILL), 1.5, id="discs"),
        pytest.param((DISC, (0, 0, 0), (2, 0, 9)), (DISC, (4, 0, 0), STILL), 1.5, id="spin"),
        pytest.param((DISC, (0, 0, 0), (2, 0, 0)), (DISC, (4, 0, 0), (1, 0, 0)), 3, id="chase"),
        pytest.param((DISC, (0, 0, 0), (2, 0, 0)), (DISC, (4, 0, 0), (2, 0, 0)), None, id="equal"),
        pytest.param((DISC, (0, 3, 0), (0, -1, 0)), (FLOOR, STILL, STILL), 2.5, id="disc, line"),
        pytest.param((PLANK, (0, 3, 0), (0, -1, 0)), (FLOOR, STILL, STILL), 2.8, id="plank, line"),
        pytest.param((BOX, (0, 3, 0), (0, -1, 0)), (FLOOR, STILL, STILL), 2, id="box, line"),
        pytest.param((BOX, (0, 3, 0), (0, -1, 0)), (BOX, (1.5, 0, 0), STILL), 1, id="boxes"),
        pytest.param((BOX, (0, 3, 0), (0, -1, 0)), (BOX, (2, 0, 0), STILL), None, id="flush"),
        pytest.param((BOX, (0, 2, 0), (0, -1, 0)), (BOX, STILL, STILL), 0, id="boxes, touching"),
        pytest.param((BOX, (0, 2, 0), (1, 0, 0)), (BOX, STILL, STILL), None, id="boxes, sliding"),
        pytest.param((BOX, (0, 1, 0), (0, 1, 0)), (BOX, STILL, STILL), None, id="boxes, leaving"),
        pytest.param((BOX, (0, 1, 0), (0, -1, 0)), (BOX, STILL, STILL), 0, id="boxes, sinking"),
        pytest.param((BOX, (4, 4, 0), (-1, -1, 0)), (BOX, STILL, STILL), 2, id="corner to corner"),
        pytest.param((BOX, (4, 0, 0), (-1, 1, 0)), (BOX, (0, 4, 0), (1, -1, 0)), 1, id="crossing"),
        pytest.param((ROD, (0, 2, 0), (0, -1, 0)), (ROD, STILL, STILL), 2, id="line on line"),
        pytest.param((ROD, (5, 0, 0), (-1, 0, 0)), (ROD, STILL, STILL), None, id="lines, end on"),
        pytest.param((ROD, (5, 1, 0), (-1, 0, 0)), (ROD, STILL, STILL), None, id="lines, beside"),
        pytest.param((BOX, STILL, STILL), (BOX, (3, 0, 0), STILL), None, id="at rest"),
    ],
)
def test_time_hand_worked(a: Moving, b: Moving, time: float | None) -> None:
    """Every kind of pair, in either order."""
    expected = None if time is None else pytest.approx(time, abs=FEW_ROUNDINGS)
    assert time_of_impact(*a, *b, 4.0) == expected
    assert time_of_impact(*b, *a, 4.0) == expected


@given(meetings())
def test_time_bodies_swapped_is_the_same(pair: tuple[Moving, Moving]) -> None:
    """Which body is called A does not matter."""
    a, b = pair
    time = time_of(a, b, DURATION)
    assume(is_well_met(a, b, time))
    assert time_of(b, a, DURATION + SAME) == pytest.approx(time, abs=SAME)


@given(meetings(), st.floats(-3, 3), st.floats(-3, 3))
def test_time_seen_from_a_moving_frame_is_the_same(
    pair: tuple[Moving, Moving], ux: float, uy: float
) -> None:
    """Galileo: a velocity added to both changes nothing."""
    a, b = pair
    time = time_of(a, b, DURATION)
    assume(is_well_met(a, b, time))
    a, b = ((s, pose, (vx + ux, vy + uy, w)) for s, pose, (vx, vy, w) in (a, b))
    assert time_of(a, b, DURATION + SAME) == pytest.approx(time, abs=SAME)


@example(((BOX, STILL, STILL), (ROD, (1, 0, 0), (-1, 0, -2.0))), 0.1)
@given(meetings(), st.sampled_from([0.1, 3.0, 1e3]))
def test_time_faster_motion_is_shorter_in_proportion(
    pair: tuple[Moving, Moving], factor: float
) -> None:
    """All velocities times k: the same film, k times as fast."""
    a, b = pair
    time = time_of(a, b, DURATION)
    assume(is_well_met(a, b, time))
    a, b = ((s, pose, tuple(factor * v for v in velocity)) for s, pose, velocity in (a, b))
    measured = time_of(a, b, (DURATION + SAME) / factor)
    assert measured is not None
    assert measured * factor == pytest.approx(time, abs=SAME)


@given(meetings(), st.floats(-4, 4))
def test_time_turned_picture_is_the_same(pair: tuple[Moving, Moving], angle: float) -> None:
    """Turning places and velocities together changes nothing."""
    a, b = pair
    time = time_of(a, b, DURATION)
    assume(is_well_met(a, b, time))
    c, s = math.cos(angle), math.sin(angle)

    def turned(state: Moving) -> Moving:
        shape, (x, y, at), (vx, vy, w) = state
        place = (c * x - s * y, s * x + c * y, at + angle)
        return shape, place, (c * vx - s * vy, s * vx + c * vy, w)

    assert time_of(turned(a), turned(b), DURATION + SAME) == pytest.approx(time, abs=SAME)


@given(meetings(), st.floats(0.1, 0.9))
def test_time_started_later_is_shorter_by_as_much(pair: tuple[Moving, Moving], part: float) -> None:
    """A search that starts on the way arrives at the same instant."""
    a, b = pair
    assume(collide(*a[:2], *b[:2]) is None)
    time = time_of(a, b, DURATION)
    assume(is_well_met(a, b, time))
    assert time is not None
    later = part * time
    a, b = ((*moved(state, later), state[2]) for state in (a, b))
    assert time_of(a, b, DURATION) == pytest.approx(time - later, abs=SAME)


def test_time_of_shapes_that_overlap_is_when_their_depth_is_least() -> None:
    """A rod in a box goes left at 1 m/s and turns at 2 rad/s: out by turning, in by going on.

    From the right side its left end is t + abs(cos(2 t)) m deep, least where it stands upright.
    """
    time = time_of_impact(BOX, STILL, STILL, ROD, (1, 0, 0), (-1, 0, -2.0), DURATION)
    assert time == pytest.approx(math.pi / 4, abs=SAME)


@given(meetings())
def test_time_there_is_no_contact_before(pair: tuple[Moving, Moving]) -> None:
    """From a start apart the narrow phase finds nothing until the time of impact."""
    a, b = pair
    assume(collide(*a[:2], *b[:2]) is None)
    time = time_of(a, b, DURATION)
    until = DURATION if time is None else time
    for part in np.linspace(0, 1, 50, endpoint=False).tolist():
        contact = collide(*moved(a, part * until), *moved(b, part * until))
        assert contact is None or max(contact.penetrations) < FEW_ROUNDINGS


@pytest.mark.parametrize("speed", [1.0, 1e2, 1e4, 1e6])
@pytest.mark.parametrize("thickness", [1e-3, 0.1, 1.0])
@pytest.mark.parametrize("spin", [0.0, 100.0])
def test_nothing_tunnels_at_any_speed(speed: float, thickness: float, spin: float) -> None:
    """Ball, box and rod against a wall and against a wall that comes, in frames of 1/60 s."""
    wall = Polygon.box(thickness, 10)
    for shape, back in itertools.product((Circle(0.01), Polygon.box(0.02, 0.02), ROD), (0.0, -3.0)):
        duration = 10 / speed
        a = (shape, (-3, 0, 0), (speed, 0, spin))
        time = time_of_impact(*a, wall, STILL, (back, 0, 0), duration)
        assert time is not None
        nearest = 3 - thickness / 2 - shape.bounding_radius
        assert nearest <= (speed - back) * time * (1 + FEW_ROUNDINGS)
        assert (speed - back) * time < 3 - thickness / 2 + FEW_ROUNDINGS


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 1e3, 1e9])
def test_time_of_small_and_large_shapes_is_that_of_their_model(scale: float) -> None:
    """A grain or a planet: all lengths and speeds times k, the same time."""
    small, large = Polygon.regular(5, scale), Polygon.box(2 * scale, scale)
    for spin in (0.0, 3.0):
        expected = time_of_impact(
            Polygon.regular(5, 1), (0, 0, 0), (1, 0.1, spin), Polygon.box(2, 1), (5, 0, 1), STILL, 9
        )
        measured = time_of_impact(
            small,
            (0, 0, 0),
            (scale, 0.1 * scale, spin),
            large,
            (5 * scale, 0, 1),
            STILL,
            9,
        )
        assert measured == pytest.approx(expected, rel=1e-11)


def sampled_time(d: Any, v: Any, radius_sum: float, duration: float) -> float | None:
    """Return the first of 11 samples of a frame at which two discs overlap: the usual mistake."""
    for k in range(11):
        if np.hypot(*(d + v * duration * k / 10)) < radius_sum:
            return duration * k / 10
    return None


def missed_share(stride: float) -> float:
    """Return which part of all hits samples miss that are `stride` radii apart, stride <= 2.

    A path at the distance h from the centre is inside for a chord of 2 sqrt(1 - h^2). Chords
    shorter than the stride fall between two samples with the probability 1 - chord / stride:
    share = integral of that over h from sqrt(1 - stride^2 / 4) to 1.
    """
    h = math.sqrt(1 - stride * stride / 4)
    return 1 - h - (math.acos(h) - h * math.sqrt(1 - h * h)) / stride


PATHS = 3_000

SCATTER = 4.0
"""Standard deviations of a count."""


@pytest.mark.parametrize("stride", [0.5, 1.0, 2.0])
def test_ten_samples_a_frame_miss_hits_and_are_late(stride: float) -> None:
    """As many hits are missed as the law says, and the others are up to a tenth of a frame late.

    The closed form finds every one. Discs pass each other within a frame, at any distance up to
    their reach.
    """
    rng = np.random.default_rng(20_240_705)
    duration, radius_sum = 1 / 60, 1.0
    speed = 10 * stride * radius_sum / duration
    missed, lateness = 0, []
    a, b = Circle(0.4), Circle(0.6)
    for _ in range(PATHS):
        d = np.array((rng.uniform(-8 * stride, -2 * stride), rng.uniform(-1, 1))) * radius_sum
        v = np.array((speed, 0.0))
        if min(np.hypot(*d), np.hypot(*(d + v * duration))) <= radius_sum:
            continue
        time = time_of_impact(a, STILL, STILL, b, (*d, 0), (*v, 0), duration)
        assert time is not None
        sample = sampled_time(d, v, radius_sum, duration)
        missed += sample is None
        if sample is not None:
            lateness.append((sample - time) / duration)
    hits = missed + len(lateness)
    expected = missed_share(stride)
    scatter = SCATTER * math.sqrt(expected * (1 - expected) / hits)
    assert missed / hits == pytest.approx(expected, abs=scatter)
    assert min(lateness) >= 0
    assert 0.09 < max(lateness) <= 0.1


def test_resolving_at_the_time_of_impact_always_changes_the_velocities() -> None:
    """Then the shapes only touch, and a test for overlap finds nothing in many cases.

    The impulse must be taken from the time itself: the discs close along the line of centres.
    """
    rng = np.random.default_rng(20_240_706)
    no_overlap = resolved = 0
    a, b = Circle(0.4), Circle(0.6)
    for _ in range(500):
        d, v = rng.uniform(1, 5, 2), -rng.uniform(0.5, 5, 2)
        time = time_of_impact(a, STILL, STILL, b, (*d, 0), (*v, 0), 10)
        if time is None:
            continue
        at = d + v * time
        no_overlap += collide(a, STILL, b, (*at, 0)) is None
        normal = at / np.hypot(*at)
        impulse = normal_impulse(v @ normal, effective_mass(1.0, 1.0), 1.0)
        after = v + impulse * normal * 2.0  # of B against A: both change by j / m
        assert after @ normal == pytest.approx(-(v @ normal))
        assert after @ normal > 0
        resolved += 1
    assert resolved > 200
    assert 0.2 < no_overlap / resolved < 0.8


@pytest.mark.parametrize("turning", [1.0, -2.0])
def test_door_comes_round_to_its_wall(turning: float) -> None:
    """Its hinge lies on the wall all the time; its end, 90 degrees away, gets there in time."""
    door, wall = Segment((0, 0), (0, 2)), Polygon.box(18, 2)
    time = time_of_impact(door, STILL, (0, 0, turning), wall, (0, -1, 0), STILL, DURATION)
    assert time == pytest.approx(math.pi / 2 / abs(turning), abs=SAME)


def test_corner_that_goes_along_a_face_is_no_impact() -> None:
    """A pentagon turns in a box, always as deep: once a search of a million looks."""
    pentagon = Polygon.regular(5, 1.3)
    spinning = (pentagon, (-1, -1, 0), (0, 0, 5.0))
    assert time_of_impact(BOX, STILL, STILL, *spinning, 0.1) is None


def test_time_zero_is_a_time() -> None:
    """Touching and closing: 0.0, which is not None, though an `if` takes it for nothing."""
    time = time_of_impact(DISC, STILL, (1, 0, 0), DISC, (1, 0, 0), STILL, 1)
    assert time == 0.0
    assert isinstance(time, float)
    assert time is not None
    assert not time


@pytest.mark.parametrize("spin", [0.0, 2.0])
def test_time_at_the_end_of_the_duration_counts(spin: float) -> None:
    """From 0 to the duration, both included; a duration of 0 asks about now only."""
    a, b = (Circle(0.5), STILL, (2, 0, spin)), (ROD, (4, 0, math.pi / 2), STILL)
    assert time_of_impact(*a, *b, 1.75) == 1.75
    assert time_of_impact(*a, *b, math.nextafter(1.75, 0)) is None
    assert time_of_impact(*a, *b, 0) is None
    assert time_of_impact(DISC, STILL, (1, 0, 0), DISC, (1, 0, 0), STILL, 0) == 0.0


@pytest.mark.parametrize("value", [1e-160, 1e-300, 1e100, 1e150])
def test_time_at_the_ends_of_float_range_is_a_time_or_none(value: float) -> None:
    """Speeds that no float can square make no nan and no error."""
    for shape, spin in itertools.product((DISC, BOX), (0.0, 1.0)):
        for b in (DISC, BOX):
            time = time_of_impact(shape, STILL, (value, 0, spin), b, (4, 0, 0), STILL, 1)
            assert time is None or 0 <= time <= 1


def test_rows_of_bodies_that_do_not_turn_are_taken_as_they_stand() -> None:
    """The engine's rows go the same way: a turned box, 1 m above a floor's end."""
    corners: list[Corner] = []
    floor = place(FLOOR.outline, 0.0, STILL, corners)
    box = place(BOX.outline, 0.0, (9, 1 + math.sqrt(2), math.pi / 4), corners)
    assert impact_time(corners, floor, box, 0.0, -2.0) == pytest.approx(0.5, rel=FEW_ROUNDINGS)
    assert impact_time(corners, box, floor, 0.0, 2.0) == pytest.approx(0.5, rel=FEW_ROUNDINGS)
    assert is_grazing(corners, floor, box, 8.0, math.sqrt(2), 1.0, 0.0)
    assert not is_grazing(corners, floor, box, 8.0, math.sqrt(2), 1.0, -0.1)


@pytest.mark.parametrize(
    ("changed", "error", "message"),
    [
        ({"shape_a": "disc"}, TypeError, "shape_a must be a Circle, Polygon or Segment"),
        ({"shape_b": None}, TypeError, "shape_b must be a Circle, Polygon or Segment"),
        ({"pose_a": (0, 0)}, ValueError, r"pose_a must be \(x, y, angle\), got shape \(2,\)"),
        ({"pose_b": (0, math.nan, 0)}, ValueError, "pose_b must be finite, got nan"),
        ({"velocity_a": 3}, ValueError, r"velocity_a must be \(vx, vy, w\), got shape \(\)"),
        ({"velocity_b": (math.inf, 0, 0)}, ValueError, "velocity_b must be finite, got inf"),
        ({"duration": -1}, ValueError, "duration must be >= 0 and finite, got -1"),
        ({"duration": math.inf}, ValueError, "duration must be >= 0 and finite, got inf"),
    ],
)
def test_bad_input_is_refused_by_name(
    changed: dict[str, Any], error: type[Exception], message: str
) -> None:
    """The error says which argument, which rule and which value."""
    arguments: dict[str, Any] = {
        "shape_a": DISC,
        "pose_a": STILL,
        "velocity_a": STILL,
        "shape_b": BOX,
        "pose_b": (4, 0, 0),
        "velocity_b": STILL,
        "duration": 1,
    }
    with pytest.raises(error, match=message):
        time_of_impact(**arguments | changed)


def test_search_without_end_is_refused_and_not_guessed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Gears that would turn for a million turns: an error that says how far the search came."""
    monkeypatch.setattr(advancement, "MOST_LOOKS", 50)
    gears = (BOX, STILL, (0, 0, 1)), (BOX, (2.45, 0, math.pi / 4), (0, 0, -1))
    with pytest.raises(ValueError, match=r"duration must be shorter: .* 1 and -1 rad/s"):
        time_of_impact(*gears[0], *gears[1], 1e6)

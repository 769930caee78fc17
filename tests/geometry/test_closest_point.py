"""The closest point of a segment, and a circle against a wall: hand-worked cases and laws."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from lesson_code.geometry import circle_against_segment, closest_point_on_segment

ROUNDING = 1e-12
"""Coordinates below are at most 100, so that rounding stays below 100 * 1e-16 * a few steps."""

SHORT_ARM = 1e-10
"""A direction is read off a distance that may be as short as 0.01 m: 100 times as uncertain."""

coordinate = st.floats(-100, 100)
place = st.tuples(coordinate, coordinate)
angle = st.floats(-math.pi, math.pi)
reaching = st.floats(50, 150)


@pytest.mark.parametrize(
    ("point", "closest"),
    [
        pytest.param((1, 3), (1, 0), id="left side"),
        pytest.param((1, -3), (1, 0), id="right side"),
        pytest.param((-2, 5), (0, 0), id="beyond start"),
        pytest.param((9, 5), (4, 0), id="beyond end"),
        pytest.param((3, 0), (3, 0), id="on the segment"),
        pytest.param((7, 0), (4, 0), id="on its line, beyond end"),
    ],
)
def test_closest_point_hand_worked_is_foot_or_end(
    point: tuple[float, float], closest: tuple[float, float]
) -> None:
    """The closest point is the foot of the perpendicular, or else the nearer end."""
    measured = closest_point_on_segment(point, start=(0, 0), end=(4, 0))
    np.testing.assert_array_equal(measured, closest)


def test_closest_point_three_four_five_is_the_foot() -> None:
    """On the line through (0, 0) and (8, 6), the foot below (1, 7) is (4, 3): 50 = 25 + 25."""
    measured = closest_point_on_segment((1, 7), start=(0, 0), end=(8, 6))
    np.testing.assert_allclose(measured, (4, 3), atol=ROUNDING)


@settings(derandomize=True)
@given(point=place, start=place, end=place, part=st.floats(0, 1))
def test_closest_point_any_segment_beats_every_other_point(
    point: tuple[float, float],
    start: tuple[float, float],
    end: tuple[float, float],
    part: float,
) -> None:
    """No point of the segment is nearer: the definition of the closest point."""
    assume(start != end)
    closest = closest_point_on_segment(point, start, end)
    other = (1 - part) * np.array(start) + part * np.array(end)
    assert math.dist(point, closest) <= math.dist(point, other) + ROUNDING


@settings(derandomize=True)
@given(point=place, start=place, end=place)
def test_closest_point_any_segment_lies_on_it(
    point: tuple[float, float], start: tuple[float, float], end: tuple[float, float]
) -> None:
    """The distances from the closest point to both ends add up to the segment's length."""
    assume(start != end)
    closest = closest_point_on_segment(point, start, end)
    detour = math.dist(start, closest) + math.dist(closest, end)
    assert detour == pytest.approx(math.dist(start, end), abs=ROUNDING)


@pytest.mark.parametrize("length", [5e-324, 1e-300, 1e-160, 1e160, 1e300])
def test_closest_point_extreme_length_still_finds_the_ends(length: float) -> None:
    """Squaring a length of 1e-160 or 1e160 would leave the range of floats; it is not squared."""
    beyond = closest_point_on_segment((2 * length, 0), start=(0, 0), end=(length, 0))
    np.testing.assert_array_equal(beyond, (length, 0))


@pytest.mark.parametrize(
    ("centre", "normal", "penetration"),
    [
        pytest.param((1, 1.25), (0, 1), 0.75, id="left side"),
        pytest.param((1, -1.25), (0, -1), 0.75, id="right side"),
        pytest.param((-1.5, 0), (-1, 0), 0.5, id="start, head on"),
        pytest.param((5.5, 0), (1, 0), 0.5, id="end, head on"),
        pytest.param((4.75, 1), (0.6, 0.8), 0.75, id="end, oblique"),
    ],
)
def test_contact_hand_worked_pushes_from_closest_point(
    centre: tuple[float, float], normal: tuple[float, float], penetration: float
) -> None:
    """A circle of radius 1.5 m at a wall 1 m thick from (0, 0) to (4, 0), worked by hand."""
    contact = circle_against_segment(centre, 1.5, (0, 0), (4, 0), half_thickness=0.5)
    assert contact is not None
    np.testing.assert_allclose(contact[0], normal, atol=ROUNDING)
    assert contact[1] == pytest.approx(penetration, abs=ROUNDING)


@pytest.mark.parametrize("half_thickness", [0.0, 0.5])
@pytest.mark.parametrize("toward", [(0, 1), (0, -1)], ids=["left side", "right side"])
def test_contact_exact_touch_is_none(toward: tuple[int, int], half_thickness: float) -> None:
    """Touching is not overlapping; one bit closer is (conventions, part C)."""
    radius_sum = 2.0 + half_thickness
    inside = math.nextafter(radius_sum, 0)
    touching = circle_against_segment(
        (1, toward[1] * radius_sum), 2.0, (0, 0), (4, 0), half_thickness
    )
    overlapping = circle_against_segment(
        (1, toward[1] * inside), 2.0, (0, 0), (4, 0), half_thickness
    )
    assert touching is None
    assert overlapping is not None
    assert overlapping[1] == radius_sum - inside


def test_contact_far_behind_a_wall_is_none() -> None:
    """A wall is a capsule and no half-plane: a ball 200 px behind it is untouched (fault 28)."""
    assert circle_against_segment((200, -200), 10, (0, 0), (100, 100), 5) is None


@pytest.mark.parametrize(
    ("end", "left"),
    [((4, 0), (0, 1)), ((-4, 0), (0, -1)), ((0, 4), (-1, 0)), ((3, 4), (-0.8, 0.6))],
)
@pytest.mark.parametrize("part", [0.0, 0.5, 1.0], ids=["start", "middle", "end"])
def test_contact_centre_on_segment_takes_left_normal(
    end: tuple[float, float], left: tuple[float, float], part: float
) -> None:
    """A centre on the segment is pushed to the left of its direction, by radius and thickness."""
    centre = (part * end[0], part * end[1])
    contact = circle_against_segment(centre, 1.0, (0, 0), end, half_thickness=0.25)
    assert contact is not None
    np.testing.assert_allclose(contact[0], left, atol=ROUNDING)
    assert contact[1] == 1.25


@pytest.mark.parametrize("distance", [5e-324, 1e-310, 1e-200])
def test_contact_tiny_distance_keeps_unit_normal(distance: float) -> None:
    """A centre next to the segment still gets a normal of length 1, on its own side."""
    contact = circle_against_segment((1, -distance), 1.0, (0, 0), (4, 0))
    assert contact is not None
    np.testing.assert_array_equal(contact[0], (0, -1))


@settings(derandomize=True)
@given(centre=place, start=place, end=place, radius=reaching, turn=angle, shift=place)
def test_contact_moved_and_turned_scene_moves_and_turns(
    centre: tuple[float, float],
    start: tuple[float, float],
    end: tuple[float, float],
    radius: float,
    turn: float,
    shift: tuple[float, float],
) -> None:
    """Turning and shifting the whole scene turns the normal and keeps the penetration."""
    assume(math.dist(start, end) > 0.1)
    normal, penetration = circle_against_segment(centre, radius, start, end) or (None, 0)
    # The direction of a short distance is uncertain, and so is whether two just touch.
    assume(1e-6 < penetration < radius - 0.01)
    c, s = math.cos(turn), math.sin(turn)
    rotation = np.array([[c, -s], [s, c]])
    moved = [rotation @ np.array(p) + shift for p in (centre, start, end)]
    here = circle_against_segment(moved[0], radius, moved[1], moved[2])
    assert here is not None
    np.testing.assert_allclose(here[0], rotation @ normal, atol=SHORT_ARM)
    assert here[1] == pytest.approx(penetration, abs=ROUNDING)


@settings(derandomize=True)
@given(centre=place, start=place, end=place, radius=reaching)
def test_contact_push_by_penetration_makes_it_touch(
    centre: tuple[float, float],
    start: tuple[float, float],
    end: tuple[float, float],
    radius: float,
) -> None:
    """Pushed along the normal by the penetration, the circle is one radius away."""
    assume(math.dist(start, end) > 0.1)
    normal, penetration = circle_against_segment(centre, radius, start, end) or (None, 0)
    assume(0 < penetration < radius - 0.01)
    assert normal is not None
    pushed = np.array(centre) + penetration * normal
    distance = math.dist(pushed, closest_point_on_segment(pushed, start, end))
    assert math.hypot(*normal) == pytest.approx(1, abs=ROUNDING)
    assert distance == pytest.approx(radius, abs=radius * SHORT_ARM)


def test_contact_inputs_are_not_changed() -> None:
    """Inputs are never changed in place, and the result shares no memory with them."""
    p, a, b = np.array([9.0, 1.0]), np.array([0.0, 0.0]), np.array([4.0, 0.0])
    closest = closest_point_on_segment(p, a, b)
    closest += 1.0
    np.testing.assert_array_equal([p, a, b], [(9, 1), (0, 0), (4, 0)])


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"end": (0, 0)}, r"start and end must differ.*\[0.0, 0.0\] twice"),
        ({"centre": (1, math.nan)}, "centre must be finite, got nan"),
        ({"centre": (1, 2, 3)}, r"centre must have shape \(\.\.\., 2\)"),
        ({"centre": [(1, 2), (3, 4)]}, r"centre must have shape \(2,\), got shape \(2, 2\)"),
        ({"start": (math.inf, 0)}, "start must be finite, got inf"),
        ({"radius": 0}, "radius must be > 0 and finite, got 0"),
        ({"radius": math.nan}, "radius must be > 0 and finite, got nan"),
        ({"half_thickness": -0.5}, "half_thickness must be >= 0 and finite, got -0.5"),
    ],
)
def test_contact_bad_input_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """Each argument is checked at the door; the error says argument, rule and value."""
    good: dict[str, Any] = {
        "centre": (1, 1),
        "radius": 2.0,
        "start": (0, 0),
        "end": (4, 0),
        "half_thickness": 0.0,
    }
    with pytest.raises(ValueError, match=message):
        circle_against_segment(**(good | wrong))


def test_closest_point_zero_length_segment_is_refused() -> None:
    """A segment without length has no direction, and so no sides (fault 21)."""
    with pytest.raises(ValueError, match="start and end must differ"):
        closest_point_on_segment((1, 1), start=(2, 3), end=(2, 3))

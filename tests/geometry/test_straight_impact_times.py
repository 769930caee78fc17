"""Impacts of a circle that flies straight: as with next to no acceleration, but to every digit."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry import Polygon, Segment
from lesson_code.geometry.impact_times import circle_outline_impact_time, line_impact_time
from lesson_code.geometry.rows import Corner, place
from lesson_code.geometry.shapes import Shape
from lesson_code.geometry.straight_impact_times import (
    straight_face_time,
    straight_outline_impact_time,
)

NEARLY_NONE = 1e-13
"""m/s^2: in 8 s, the longest flight here, it moves a circle by 3e-12 m."""

BENT = 1e-5
"""s: what 3e-12 m make of the time at a corner that is all but grazed, at most: their root."""

shapes = st.sampled_from([Polygon.box(2, 1), Polygon.regular(5, 1.2), Segment((-1, 0), (1, 1))])


@pytest.mark.parametrize(
    ("gap", "v", "time"),
    [
        (3.0, -2.0, 1.5),
        (3.0, 2.0, math.inf),
        (3.0, 0.0, math.inf),
        (0.0, -1.0, 0.0),
        (-1.0, -1.0, 0.0),
        (-1.0, 1.0, math.inf),
        (1.0, -1e-200, 1e200),
    ],
)
def test_face_time_worked_by_hand(gap: float, v: float, time: float) -> None:
    """The way over the speed, however slow; and the door for any acceleration gives the same."""
    assert straight_face_time(gap, v) == time
    assert line_impact_time(gap, v, 0.0) == time


@given(
    shapes,
    st.floats(-3, 3),
    st.floats(0, 2 * math.pi),
    st.floats(0, 2 * math.pi),
    st.floats(0.1, 1),
)
def test_outline_time_is_that_of_a_path_that_is_all_but_straight(
    shape: Shape, angle: float, place_angle: float, aim: float, radius: float
) -> None:
    """The rules for parabolas, at 1e-13 m/s^2; for a circle that just grazes either is right."""
    corners: list[Corner] = []
    body = place(shape.outline, shape.rounding, (0.0, 0.0, angle), corners)
    dx, dy = 4 * math.cos(place_angle), 4 * math.sin(place_angle)
    vx, vy = math.cos(aim), math.sin(aim)
    time, _ = straight_outline_impact_time(corners, body, dx, dy, vx, vy, radius)
    larger, smaller = (
        straight_outline_impact_time(corners, body, dx, dy, vx, vy, radius * scale)[0]
        for scale in (1 + 1e-9, 1 - 1e-9)
    )
    bent, _ = circle_outline_impact_time(
        corners, body, dx, dy, vx, vy, NEARLY_NONE, -NEARLY_NONE, radius
    )
    if math.isinf(larger) == math.isinf(smaller):
        assert bent == pytest.approx(time, abs=BENT)

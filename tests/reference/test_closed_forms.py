"""The closed forms themselves: hand-worked cases, limits, and what they refuse."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from lesson_code.reference.closed_forms import (
    ball_in_box,
    bounce_heights,
    bounce_times,
    bouncing_ball,
    rest_time,
    two_body_exact,
)

ROUNDING = 1e-14
"""A few roundings of numbers of size 1 to 10."""


@pytest.mark.parametrize(
    ("arguments", "after"),
    [
        pytest.param((1, 2, 3, -1, Fraction(7, 10)), (Fraction(-73, 40), Fraction(11, 40)), id="1"),
        pytest.param((1, 2, 1, -3, 1), (-3, 2), id="equal masses swap"),
        pytest.param((1, 3, 3, -1, 0), (0, 0), id="sticking"),
        pytest.param((2, 5, 4, 5, Fraction(1, 2)), (5, 5), id="no approach, no change"),
    ],
)
def test_two_body_hand_worked_is_exact(
    arguments: tuple[Any, ...], after: tuple[Fraction | int, Fraction | int]
) -> None:
    """Worked by hand; the first is hard case 1: v' = -1.825 and 0.275."""
    assert two_body_exact(*arguments) == after


def test_two_body_float_stands_for_its_binary_value() -> None:
    """0.1 is not a tenth but the float nearest to it, and is taken as that."""
    assert two_body_exact(1, 0.1, 1, 0, 1) == (Fraction(0), Fraction(0.1))
    assert Fraction(0.1) != Fraction(1, 10)


def test_bounce_heights_restitution_limits_are_kept_and_lost() -> None:
    """h_n = e^(2n) h: all of it for e = 1, nothing for e = 0."""
    np.testing.assert_array_equal(bounce_heights(2, 1, 3), [2, 2, 2])
    np.testing.assert_array_equal(bounce_heights(2, 0, 3), [0, 0, 0])


def test_bounce_times_elastic_are_odd_multiples_of_the_fall() -> None:
    """With e = 1 impacts come at T, 3T, 5T, ...; h = 5 m and g = 10 m/s^2 make T = 1 s."""
    np.testing.assert_array_equal(bounce_times(5, 1, 4, 10), [1, 3, 5, 7])


def test_bounce_times_no_restitution_are_all_the_first() -> None:
    """With e = 0 the ball stays down after the first impact at T = 1 s."""
    np.testing.assert_array_equal(bounce_times(5, 0, 3, 10), [1, 1, 1])


def test_bounce_count_zero_is_empty() -> None:
    """No impacts, no heights and no times."""
    assert bounce_heights(1, 0.5, 0).shape == (0,)
    assert bounce_times(1, 0.5, 0, 9.81).shape == (0,)


def test_rest_time_zeno_ball_is_the_published_value() -> None:
    """1 m, e = 0.8, g = 10 m/s^2: rest at 4.02492 s (hard case 6)."""
    assert rest_time(1, 0.8, 10) == pytest.approx(9 * math.sqrt(0.2), rel=ROUNDING)
    assert round(rest_time(1, 0.8, 10), 5) == 4.02492


def test_bouncing_ball_quarter_restitution_hand_worked() -> None:
    """With h = 5, g = 10, e = 1/2: T = 1 s, peaks of 5/4 m and 5/16 m, rest at 3 s."""
    times = [0, 0.5, 1, 1.25, 1.5, 2, 2.25, 2.5, 3, 100]
    expected = [5, 3.75, 0, 0.9375, 1.25, 0, 0.3125, 0, 0, 0]
    np.testing.assert_allclose(bouncing_ball(times, 5, 0.5, 10), expected, atol=ROUNDING)


def test_bouncing_ball_elastic_is_periodic() -> None:
    """With e = 1 the motion repeats every 2T for ever: T = 1 s, so the ball tops at even times."""
    times = np.array([0, 1, 2, 2.5, 3, 1_000_000, 1_000_001])
    expected = [5, 0, 5, 3.75, 0, 5, 0]
    np.testing.assert_array_equal(bouncing_ball(times, 5, 1, 10), expected)


def test_bouncing_ball_no_restitution_rests_after_first_fall() -> None:
    """With e = 0 the ball falls, y = 5 - 5 t^2, and stays down from T = 1 s on."""
    np.testing.assert_allclose(
        bouncing_ball([0, 0.5, 1, 1.5, 9], 5, 0, 10), [5, 3.75, 0, 0, 0], atol=ROUNDING
    )


def test_bouncing_ball_shape_of_times_is_kept() -> None:
    """One time gives one height, an array of any shape gives heights of that shape."""
    assert bouncing_ball(0.5, 5, 0.5, 10).shape == ()
    assert bouncing_ball(np.zeros((2, 3)), 5, 0.5, 10).shape == (2, 3)


@pytest.mark.parametrize(
    ("time", "position", "velocity"),
    [
        pytest.param(0, (1, 1), (1, 2), id="start"),
        pytest.param(0.25, (1.25, 1.5), (1, -2), id="at the top wall, after the impact"),
        pytest.param(1.5, (2.5, 1), (-1, -2), id="at the right wall, after the impact"),
        pytest.param(4, (1, 1), (1, 2), id="both periods, 4 s and 1 s"),
        pytest.param(4e15, (1, 1), (1, 2), id="after 8e15 impacts and more"),
    ],
)
def test_ball_in_box_hand_worked_unfolds(
    time: float, position: tuple[float, float], velocity: tuple[float, float]
) -> None:
    """Box 3 m x 2 m, radius 0.5 m: rooms of 2 m and 1 m, crossed at 1 and 2 m/s."""
    p, v = ball_in_box((1, 1), (1, 2), radius=0.5, width=3, height=2, time=time)
    np.testing.assert_array_equal(p, position)
    np.testing.assert_array_equal(v, velocity)


def test_ball_in_box_moving_into_the_wall_it_touches_turns_at_once() -> None:
    """A ball that starts at the wall, moving outward, has its impact at time 0."""
    p, v = ball_in_box((0.5, 1), (-1, 0), radius=0.5, width=3, height=2, time=0)
    np.testing.assert_array_equal((p, v), [(0.5, 1), (1, 0)])


BALL: dict[str, Any] = {"height": 1, "restitution": 0.5, "gravity": 10}
BOX: dict[str, Any] = {
    "position": (1, 1),
    "velocity": (1, 2),
    "radius": 0.5,
    "width": 3,
    "height": 2,
    "time": 1,
}
PAIR: dict[str, Any] = {"m1": 1, "v1": 1, "m2": 1, "v2": 0, "restitution": 1}


@pytest.mark.parametrize(
    ("function", "arguments", "message"),
    [
        (two_body_exact, PAIR | {"m1": 0}, "m1 must be > 0 and finite, got 0"),
        (two_body_exact, PAIR | {"m2": math.inf}, "m2 must be > 0 and finite, got inf"),
        (two_body_exact, PAIR | {"v2": math.nan}, "v2 must be finite, got nan"),
        (two_body_exact, PAIR | {"restitution": 1.5}, "restitution must be between 0 and 1"),
        (rest_time, BALL | {"restitution": 1}, "restitution must be < 1 .* got 1"),
        (rest_time, BALL | {"height": -1}, "height must be > 0 and finite, got -1"),
        (rest_time, BALL | {"gravity": 0}, "gravity must be > 0 and finite, got 0"),
        (bouncing_ball, BALL | {"times": [0, -1]}, "times must be >= 0 .* got -1.0 at index"),
        (bouncing_ball, BALL | {"times": 1, "restitution": -0.1}, "restitution must be between"),
        (bounce_times, BALL | {"count": -1}, "count must be >= 0, got -1"),
        (ball_in_box, BOX | {"width": 1}, r"width must be > 2 radius = 1.0 m, got 1"),
        (ball_in_box, BOX | {"position": (0.25, 1)}, "position must be at least one radius inside"),
        (ball_in_box, BOX | {"position": (1, 1.75)}, "position must be at least one radius inside"),
        (ball_in_box, BOX | {"velocity": (1, math.nan)}, "velocity must be finite, got nan"),
        (ball_in_box, BOX | {"time": -1}, "time must be >= 0 and finite, got -1"),
    ],
)
def test_closed_form_bad_input_is_refused_by_name(
    function: Callable[..., Any], arguments: dict[str, Any], message: str
) -> None:
    """The error says argument, rule and value."""
    with pytest.raises(ValueError, match=message):
        function(**arguments)


def test_bounce_count_must_be_a_whole_number() -> None:
    """Half an impact is a TypeError, as it is for range."""
    with pytest.raises(TypeError):
        bounce_times(1, 0.5, count=2.5, gravity=10)  # type: ignore[arg-type]

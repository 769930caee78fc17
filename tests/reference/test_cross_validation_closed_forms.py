"""The closed forms against answers found another way: event by event, in exact fractions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice, takewhile

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lesson_code.formulas import reflect
from lesson_code.reference.closed_forms import (
    ball_in_box,
    bounce_heights,
    bounce_times,
    bouncing_ball,
    rest_time,
)

SEED = 20_240_303

HEIGHT_ERROR = 1e-13
"""In units of the height dropped from; measured: 2e-14, at times of many falls."""

TIME_ERROR = 1e-14
"""In units of the time itself: a sum of fewer than 100 terms; measured: 4e-16."""

LONG_SUM_ERROR = 1e-13
"""The same for a sum of 400 terms; measured: 5e-15."""

MIRROR_ERROR = 1e-14
"""In units of the speed: two trigonometric functions of angles up to 10 rad; measured: 1.3e-15."""

SLOWEST = Fraction(1, 10**18)
"""m/s: flights slower than this together last less than 1e-17 s."""

FALL, GRAVITY = Fraction(1, 2), Fraction(8)
"""s and m/s^2: a drop from exactly 1 m."""

Flight = tuple[Fraction, Fraction]
"""When a flight begins, s, and with what speed upwards, m/s."""


def flights(fall_time: Fraction, e: Fraction, gravity: Fraction) -> Iterator[Flight]:
    """Go from impact to impact: fall, turn the speed round, fly, and so on for ever.

    The drop is the second half of a flight that began one fall time before 0.
    """
    start, speed = -fall_time, gravity * fall_time
    while True:
        yield start, speed
        start, speed = start + 2 * speed / gravity, e * speed


def height_by_events(t: Fraction, table: list[Flight], gravity: Fraction) -> Fraction:
    """Return the ball's height at time t: that of the last flight begun by then."""
    start, speed = [flight for flight in table if flight[0] <= t][-1]
    since = t - start
    return max(speed * since - gravity * since**2 / 2, Fraction(0))


@pytest.mark.parametrize(
    "e", [Fraction(0), Fraction(1, 16), Fraction(1, 2), Fraction(7, 8), Fraction(127, 128), 1]
)
def test_bouncing_ball_random_times_equal_event_by_event(e: Fraction) -> None:
    """300 random times and every impact of 40 flights, in exact fractions."""
    table = list(islice(flights(FALL, Fraction(e), GRAVITY), 41))
    last = table[-1][0]
    rng = np.random.default_rng(SEED)
    times = [Fraction(t) for t in rng.uniform(0, float(last), 300) if Fraction(t) < last]
    times += [start for start, _ in table[1:-1]]
    expected = [float(height_by_events(t, table, GRAVITY)) for t in times]
    measured = bouncing_ball([float(t) for t in times], 1.0, float(e), 8.0)
    np.testing.assert_allclose(measured, expected, atol=HEIGHT_ERROR)


@settings(derandomize=True)
@given(
    height=st.floats(1e-3, 1e3),
    e=st.floats(0, 1),
    gravity=st.floats(1e-2, 1e2),
    falls=st.floats(0, 1e3),
)
def test_bouncing_ball_anywhere_stays_between_floor_and_start(
    height: float, e: float, gravity: float, falls: float
) -> None:
    """No restitution between 0 and 1 and no time gives a height below 0, above h, or nan."""
    time = falls * math.sqrt(2 * height / gravity)
    y = float(bouncing_ball(time, height, e, gravity))
    assert 0 <= y <= height * (1 + HEIGHT_ERROR)


@settings(derandomize=True)
@given(height=st.floats(1e-3, 1e3), e=st.floats(0.01, 1), gravity=st.floats(1e-2, 1e2))
def test_bouncing_ball_at_and_between_impacts_is_zero_and_peak(
    height: float, e: float, gravity: float
) -> None:
    """At t_n the height is 0, half way between t_n and t_(n+1) it is e^(2n) h: two more forms."""
    times = bounce_times(height, e, 6, gravity)
    at_impact = bouncing_ball(times, height, e, gravity)
    half_way = bouncing_ball((times[:-1] + times[1:]) / 2, height, e, gravity)
    np.testing.assert_allclose(at_impact, 0, atol=height * HEIGHT_ERROR)
    peaks = bounce_heights(height, e, 5)
    np.testing.assert_allclose(half_way, peaks, atol=height * HEIGHT_ERROR)


@pytest.mark.parametrize("e", [Fraction(0), Fraction(1, 2), Fraction(15, 16), Fraction(1)])
def test_bounce_times_event_by_event_are_the_impacts(e: Fraction) -> None:
    """The time of each impact is where the flights of the event loop begin."""
    table = list(islice(flights(FALL, e, GRAVITY), 81))
    expected = [float(start) for start, _ in table[1:]]
    np.testing.assert_allclose(bounce_times(1, float(e), 80, 8), expected, rtol=TIME_ERROR)


@pytest.mark.parametrize("e", [Fraction(0), Fraction(1, 10), Fraction(4, 5), Fraction(19, 20)])
def test_rest_time_is_the_limit_of_the_impacts(e: Fraction) -> None:
    """Zeno: the series of flight times, summed until no term is left, ends at rest_time."""
    still_flying = takewhile(lambda flight: flight[1] > SLOWEST, flights(FALL, e, GRAVITY))
    last_start, last_speed = list(still_flying)[-1]
    end = last_start + 2 * last_speed / GRAVITY
    assert rest_time(1, float(e), 8) == pytest.approx(float(end), rel=TIME_ERROR)


@settings(derandomize=True)
@given(height=st.floats(1e-3, 1e3), e=st.floats(0, 0.9), gravity=st.floats(1e-2, 1e2))
def test_rest_time_any_ball_is_where_the_impacts_end(
    height: float, e: float, gravity: float
) -> None:
    """After 400 impacts with e <= 0.9 less than e^400 < 1e-18 of the time is left."""
    last = bounce_times(height, e, 400, gravity)[-1]
    assert rest_time(height, e, gravity) == pytest.approx(last, rel=LONG_SUM_ERROR)


def bounce_between(
    x: Fraction, v: Fraction, low: Fraction, high: Fraction, time: Fraction
) -> tuple[Fraction, Fraction]:
    """Fly to the wall ahead, turn round, and so on until the time is used up."""
    while v:
        ahead = high if v > 0 else low
        until = (ahead - x) / v
        if until > time:
            return x + v * time, v
        x, v, time = ahead, -v, time - until
    return x, v


def test_ball_in_box_random_flights_equal_event_by_event() -> None:
    """500 random boxes: unfolding is, to the last bit, the exact loop over all wall hits."""
    rng = np.random.default_rng(SEED)
    for _ in range(500):
        radius, (width, height) = rng.uniform(0.1, 1), rng.uniform(2.5, 10, 2)
        position = rng.uniform(radius, (width - radius, height - radius))
        velocity, time = rng.uniform(-20, 20, 2), rng.uniform(0, 10)
        p, v = ball_in_box(position, velocity, radius, width, height, time)
        for axis, size in enumerate((width, height)):
            low, high = Fraction(radius), Fraction(size) - Fraction(radius)
            x, vx = bounce_between(
                Fraction(position[axis]), Fraction(velocity[axis]), low, high, Fraction(time)
            )
            assert (p[axis], v[axis]) == (float(x), float(vx))


@settings(derandomize=True)
@given(
    speeds=st.tuples(st.integers(-8, 8), st.integers(-8, 8)),
    place=st.tuples(st.integers(0, 8), st.integers(0, 8)),
    quarters=st.integers(0, 200),
)
def test_ball_in_box_impact_instants_equal_event_by_event(
    speeds: tuple[int, int], place: tuple[int, int], quarters: int
) -> None:
    """On a grid of whole numbers impacts fall on the very instants asked for, corners too."""
    time = Fraction(quarters, 4)
    position = (1 + place[0], 1 + place[1])
    p, v = ball_in_box(position, speeds, radius=1, width=10, height=10, time=float(time))
    for axis in (0, 1):
        x, vx = bounce_between(
            Fraction(position[axis]), Fraction(speeds[axis]), Fraction(1), Fraction(9), time
        )
        assert (p[axis], v[axis]) == (x, vx)


def test_mirror_random_walls_equals_reflect() -> None:
    """Equal angles and R = I - 2 (I . N) N are one law: 10,000 random walls and velocities.

    Euclid, Catoptrics, proposition 1: equal angles on both sides of the mirror.
    """
    rng = np.random.default_rng(SEED)
    wall = rng.uniform(-math.pi, math.pi, 10_000)
    normal = np.stack((-np.sin(wall), np.cos(wall)), axis=-1)
    velocity = rng.uniform(-100, 100, (10_000, 2))
    speed = np.hypot(*velocity.T)
    angle = 2 * wall - np.arctan2(*velocity.T[::-1])
    difference = reflect(velocity, normal) - np.stack(
        (speed * np.cos(angle), speed * np.sin(angle)), axis=-1
    )
    assert np.max(np.hypot(*difference.T) / speed) < MIRROR_ERROR

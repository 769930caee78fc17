"""A circle on a parabola: turning times, brackets and roots, by hand and as exact fractions."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.geometry.parabola import (
    latest_turning_time,
    next_guess,
    overlap_square,
    parabola_impact_time,
    place_and_velocity,
    rate,
    touching_time,
    turning_times,
    turns_of_rate,
)

FEW_ROUNDINGS = 1e-14
"""Of times and lengths of size 1: some dozen operations, rounded to 1e-16 each."""

number = st.floats(-4, 4)
state = st.tuples(*[number] * 6)


def exact_rate(motion: tuple[float, ...], t: float) -> Fraction:
    """Return p . u without rounding."""
    dx, dy, vx, vy, ax, ay, at = (Fraction(x) for x in (*motion, t))
    px, py = dx + vx * at + ax * at**2 / 2, dy + vy * at + ay * at**2 / 2
    return px * (vx + ax * at) + py * (vy + ay * at)


def test_place_and_velocity_hand_worked() -> None:
    """Thrown at (3, 20) m/s with g = 10 m/s^2: after 1 s 15 m up, at (3, 10) m/s."""
    assert place_and_velocity(1.0, 0.0, 3.0, 20.0, 0.0, -10.0, 1.0) == (4.0, 15.0, 3.0, 10.0)


@pytest.mark.parametrize(
    ("motion", "times"),
    [
        pytest.param((0, 1, 0, 5, 0, -10), [0.5, (5 + 45**0.5) / 10], id="up, and down through"),
        pytest.param((0, 1, 0, 0, 0, -10), [0.2**0.5], id="let go above: through the centre"),
        pytest.param((0, -1, 0, 0, 0, -10), [], id="let go below: parts for ever"),
        pytest.param((0, -5, 0, 10, 0, -10), [1], id="up to the centre: a threefold root"),
        pytest.param((0, -6, 0, 10, 0, -10), [1], id="up to 1 m below the centre"),
        pytest.param(
            (0, -3.75, 0, 10, 0, -10), [0.5, 1, 1.5], id="up through the centre, and back"
        ),
    ],
)
def test_turning_times_hand_worked(motion: tuple[float, ...], times: list[float]) -> None:
    """Where a ball that flies straight up turns and where it passes the centre."""
    measured = turning_times(*map(float, motion))
    assert sorted(measured) == list(measured)
    assert sorted({t for t in measured if t > 0}) == pytest.approx(times, abs=1e-5)


@given(state)
def test_rate_has_one_sign_between_turning_times(motion: tuple[float, ...]) -> None:
    """Between two turning times the circles only come nearer or only part: the exact rate says so.

    A rate within rounding of 0 has no sign to be trusted.
    """
    assume(motion[4] ** 2 + motion[5] ** 2 > 0)
    times = turning_times(*motion)
    for start, end in pairwise((0.0, *times, times[-1] + 1)):
        inside = [start + (end - start) * part for part in (0.01, 0.3, 0.5, 0.8, 0.99)]
        rates = [exact_rate(motion, t) for t in inside]
        clear = [g for t, g in zip(inside, rates, strict=True) if abs(g) > 1e-11 * (1 + t**3)]
        assert all(g > 0 for g in clear) or all(g < 0 for g in clear)


@given(state, st.floats(1, 100))
def test_rate_after_the_latest_turning_time_is_positive(
    motion: tuple[float, ...], factor: float
) -> None:
    """The bound holds in any direction: after it the circles part for ever."""
    assume(motion[4] ** 2 + motion[5] ** 2 > 1e-20)
    assume(any(motion[:4]))
    assert exact_rate(motion, factor * latest_turning_time(*motion)) > 0


@given(state)
def test_turns_of_rate_are_its_extremes(motion: tuple[float, ...]) -> None:
    """At a turn the slope of the rate, u . u + p . a, is 0; the first is the higher one."""
    first, second = turns_of_rate(*motion)
    assert 0 <= first <= second
    for t in (first, second):
        if t > 0:
            px, py, ux, uy = place_and_velocity(*motion, t)
            terms = [ux * ux, uy * uy, px * motion[4], py * motion[5]]
            scale = sum(abs(x) for x in terms) + (1 + t) ** 2 * 50
            assert sum(terms) == pytest.approx(0, abs=FEW_ROUNDINGS * scale)


@pytest.mark.parametrize("height", [1e-20, 1e-10, 1e-3, 1.0, 1e3])
def test_hop_on_a_disc_of_any_height_lasts_two_v_over_g(height: float) -> None:
    """A ball thrown up from the top of a disc at v = sqrt(2 g h) is back after 2 v / g.

    A hop of 1e-20 m is lost in the distance of the centres, 1 m; the change of place knows it.
    """
    v = math.sqrt(20 * height)
    measured = parabola_impact_time(0.0, 1.0, 0.0, v, 0.0, -10.0, 1.0, -1.0)
    assert measured == pytest.approx(v / 5, rel=FEW_ROUNDINGS, abs=0)


@given(state, st.floats(0, 2), st.floats(0.1, 3))
def test_overlap_square_is_exact_but_for_rounding(
    motion: tuple[float, ...], t: float, radius_sum: float
) -> None:
    """Both ways to f agree with fractions, to a rounding of the places times the size."""
    dx, dy, vx, vy, ax, ay, at, r = (Fraction(x) for x in (*motion, t, radius_sum))
    px, py = dx + vx * at + ax * at**2 / 2, dy + vy * at + ay * at**2 / 2
    expected = float(px**2 + py**2 - r**2)
    scale = 4 + radius_sum + 4 * t + 2 * t * t
    measured = overlap_square(*motion, radius_sum, t)
    assert measured == pytest.approx(expected, abs=FEW_ROUNDINGS * scale**2)


def test_approaches_that_began_before_are_left_out() -> None:
    """Up through a disc and down on it again: two approaches, each found; after them none."""
    motion = (0.0, -3.75, 0.0, 10.0, 0.0, -10.0, 1.0)
    first = parabola_impact_time(*motion, -1.0)
    second = parabola_impact_time(*motion, first)
    assert first == pytest.approx(1 - 0.45**0.5, rel=FEW_ROUNDINGS, abs=0)  # 1 m below the centre
    assert second == pytest.approx(1 + 0.05**0.5, rel=FEW_ROUNDINGS, abs=0)  # and 1 m above it
    assert parabola_impact_time(*motion, second) == math.inf


@pytest.mark.parametrize("radius_sum", [0.5, 1e-3, 1e-9])
def test_touching_time_small_target_is_met(radius_sum: float) -> None:
    """Let go 5 m above the centre of a disc of any size: sqrt(2 (5 - r) / g)."""
    measured = touching_time(0.0, 5.0, 0.0, 0.0, 0.0, -10.0, radius_sum, 0.0, 1.0)
    assert measured == pytest.approx(math.sqrt((5 - radius_sum) / 5), rel=FEW_ROUNDINGS, abs=0)


@pytest.mark.parametrize(
    ("slope", "guess"),
    [(6.0, 2.5), (0.5, 1.5), (-6.0, 1.5), (0.0, 1.5)],
    ids=["inside", "before the bracket", "beyond it", "no slope"],
)
def test_next_guess_stays_in_the_bracket(slope: float, guess: float) -> None:
    """Newton's guess from t = 3 in the bracket from 0 to 3, or the middle."""
    assert next_guess(3.0, 3.0, slope, 0.0, 3.0) == guess


def test_rate_hand_worked() -> None:
    """Place (4, 15), velocity (3, 10): 12 + 150."""
    assert rate(1.0, 0.0, 3.0, 20.0, 0.0, -10.0, 1.0) == 162.0

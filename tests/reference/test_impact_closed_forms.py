"""Well-known impacts: the closed forms against conservation, limits, and the same step by step."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.reference.closed_forms import two_body_exact
from lesson_code.reference.impact_closed_forms import (
    break_shot,
    cradle_all_at_once,
    cradle_one_by_one,
    flat_landing,
    off_centre_hit,
    two_ball_drop,
)

ROUNDING = 1e-13
"""Of the largest numbers of a case: some ten roundings, of three equations at most."""

positives = st.floats(0.1, 10)
speeds = st.floats(-10, 10).map(lambda speed: round(speed, 6))
restitutions = st.floats(0, 1)


@given(positives, speeds, positives, positives, st.floats(-2, 2), restitutions)
def test_off_centre_hit_obeys_all_three_laws(
    m: float, v: float, big: float, inertia: float, arm: float, e: float
) -> None:
    """Momentum, angular momentum about the ball's line, and Newton's rule at the place hit."""
    ball, body, w = off_centre_hit(m, v, big, inertia, arm, e)
    scale = ROUNDING * (1 + abs(v)) * 1000
    assert m * ball + big * body == pytest.approx(m * v, abs=scale)
    assert inertia * w - big * body * arm == pytest.approx(0, abs=scale)
    assert body + w * arm - ball == pytest.approx(e * v, abs=scale)


@given(positives, speeds, positives, positives, st.floats(-2, 2), restitutions)
def test_off_centre_hit_loses_the_energy_of_restitution(
    m: float, v: float, big: float, inertia: float, arm: float, e: float
) -> None:
    """1/2 m_eff (1 - e^2) v^2, and the impulse (1 + e) m_eff v: the body yields in two ways."""
    ball, body, w = off_centre_hit(m, v, big, inertia, arm, e)
    m_eff = 1 / (1 / m + 1 / big + arm**2 / inertia)
    lost = m * v**2 / 2 - m * ball**2 / 2 - big * body**2 / 2 - inertia * w**2 / 2
    scale = ROUNDING * (1 + v**2) * 1000
    assert lost == pytest.approx(m_eff * (1 - e**2) * v**2 / 2, abs=scale)
    assert big * body == pytest.approx((1 + e) * m_eff * v, abs=scale)


@pytest.mark.parametrize(
    ("arguments", "after"),
    [
        pytest.param((1, 1, 1, 1 / 3, 1, 1), (0.6, 0.4, 1.2), id="end of a rod"),
        pytest.param((1, 1, 1, 1 / 3, -1, 1), (0.6, 0.4, -1.2), id="its other end"),
        pytest.param((1, 1, 1, 1 / 3, 0, 1), (0, 1, 0), id="its middle: as two balls"),
        pytest.param((1, 5, 1, 1 / 3, 1, 0), (4, 1, 3), id="end of a rod, sticking"),
    ],
)
def test_off_centre_hit_of_a_rod_worked_by_hand(
    arguments: tuple[float, ...], after: tuple[float, float, float]
) -> None:
    """1 kg on 1 kg of 2 m: at an end 1/m_eff = 1 + 1 + 3 = 5, so that J = (1 + e) v/5."""
    assert off_centre_hit(*arguments) == pytest.approx(after, abs=ROUNDING * 10)


def two_corners(
    width: float, height: float, speed: float, e: float, sweeps: int
) -> tuple[float, float]:
    """Return v' and w' of a box of 1 kg after so many visits of its left and right corner."""
    inertia = (width**2 + height**2) / 12
    v, w = -speed, 0.0
    total = [0.0, 0.0]
    for _ in range(sweeps):
        for i, arm in enumerate((-width / 2, width / 2)):
            m_eff = 1 / (1 + arm**2 / inertia)
            given_now = max(total[i] - (v + w * arm - e * speed) * m_eff, 0.0) - total[i]
            total[i] += given_now
            v, w = v + given_now, w + arm * given_now / inertia
    return v, w


@pytest.mark.parametrize(("width", "height"), [(1, 1), (10, 1), (1, 4), (1, 10), (1, 30), (2, 1)])
@pytest.mark.parametrize("sweeps", [1, 2, 5, 10, 100])
def test_flat_landing_after_some_sweeps_is_what_sweeps_give(
    width: float, height: float, sweeps: int
) -> None:
    """Visiting both corners in turn, impulse by impulse, with the totals clamped at 0."""
    found = flat_landing(width, height, 2.0, 0.5, sweeps)
    expected = two_corners(width, height, 2.0, 0.5, sweeps)
    assert found == pytest.approx(expected, abs=10 * ROUNDING)


@given(positives, positives, positives, restitutions)
def test_flat_landing_in_the_end_is_flat_at_e_v(
    width: float, height: float, speed: float, e: float
) -> None:
    """Both corners reach e v, so that nothing turns, whatever the box."""
    assert flat_landing(width, height, speed, e) == pytest.approx(
        (e * speed, 0), abs=ROUNDING * speed
    )


def test_flat_landing_error_shrinks_by_rho_squared_a_sweep() -> None:
    """A tall box of 1 x 10 has (k12/k11)^2 = (98/104)^2: a sweep leaves 89 % of its spin."""
    spins = [flat_landing(1, 10, 1, 0.5, n)[1] for n in range(1, 20)]
    ratios = np.array(spins[1:]) / spins[:-1]
    np.testing.assert_allclose(ratios, (98 / 104) ** 2, rtol=100 * ROUNDING)


masses = st.fractions(Fraction(1, 10), 100, max_denominator=20)


@given(masses, masses, st.fractions(-10, 10, max_denominator=20))
def test_two_ball_drop_is_two_collisions_one_after_the_other(
    lower: Fraction, upper: Fraction, speed: Fraction
) -> None:
    """The lower ball turns at the floor, v; then it meets the upper one, which comes with -v."""
    assert two_ball_drop(lower, upper, speed) == two_body_exact(lower, speed, upper, -speed, 1)


@pytest.mark.parametrize(("ratio", "upper"), [(3, 2), (10, Fraction(29, 11)), (100, 2.9604)])
def test_two_ball_drop_of_a_light_ball_nears_three_times_the_speed(
    ratio: int, upper: float
) -> None:
    """(3M - m)/(M + m): 2, 2.636, 2.960 for M/m = 3, 10, 100."""
    assert float(two_ball_drop(ratio, 1, 1)[1]) == pytest.approx(upper, abs=5e-5)


@pytest.mark.parametrize("count", [2, 3, 5, 10])
def test_cradles_keep_momentum_and_energy_and_differ(count: int) -> None:
    """Both answers obey both laws, which cannot tell them apart; with two balls they agree."""
    one_by_one, all_at_once = cradle_one_by_one(count, 3.0), cradle_all_at_once(count, 3.0)
    for after in (one_by_one, all_at_once):
        assert after.sum() == pytest.approx(3.0, rel=ROUNDING)
        assert np.square(after).sum() == pytest.approx(9.0, rel=ROUNDING)
    assert np.array_equal(one_by_one, all_at_once) == (count == 2)


@pytest.mark.parametrize("count", [2, 3, 5, 10])
def test_cradle_one_by_one_is_a_chain_of_collisions(count: int) -> None:
    """Ball by ball, each collision for itself, in exact fractions."""
    velocities = [Fraction(3)] + [Fraction(0)] * (count - 1)
    for i in range(count - 1):
        velocities[i], velocities[i + 1] = two_body_exact(1, velocities[i], 1, velocities[i + 1], 1)
    np.testing.assert_array_equal(cradle_one_by_one(count, 3.0), [float(v) for v in velocities])


@pytest.mark.parametrize("count", [2, 3, 5, 10])
def test_cradle_all_at_once_turns_every_approach_round(count: int) -> None:
    """Contact by contact, separation after = approach before: v at the first, 0 at the others."""
    before = np.array([3.0] + [0.0] * (count - 1))
    after = cradle_all_at_once(count, 3.0)
    np.testing.assert_allclose(np.diff(after), -np.diff(before), rtol=0, atol=10 * ROUNDING)


@given(speeds, restitutions)
def test_break_shot_keeps_momentum_and_obeys_restitution_at_both_contacts(
    v: float, e: float
) -> None:
    """Along each normal, 30 degrees up or down, what leaves is e times what came."""
    cue, upper, lower = break_shot(v, e)
    np.testing.assert_allclose(cue + upper + lower, (v, 0), rtol=0, atol=100 * ROUNDING)
    for ball, side in ((upper, 1), (lower, -1)):
        normal = np.array([math.sqrt(3) / 2, side / 2])
        assert (ball - cue) @ normal == pytest.approx(e * v * normal[0], abs=100 * ROUNDING)
        assert ball[0] * normal[1] == pytest.approx(ball[1] * normal[0], abs=100 * ROUNDING)


def test_break_shot_elastic_is_the_textbooks() -> None:
    """The cue comes back with 1/5; the balls leave with (3/5, +-.34641), and energy is kept."""
    after = break_shot(1.0, 1.0)
    sixth = math.sqrt(3) / 5
    np.testing.assert_allclose(
        after, [(-0.2, 0), (0.6, sixth), (0.6, -sixth)], atol=ROUNDING, rtol=0
    )
    assert np.square(after).sum() == pytest.approx(1, rel=ROUNDING)


HIT: dict[str, Any] = {
    "ball_mass": 1,
    "ball_velocity": 1,
    "body_mass": 1,
    "body_inertia": 1,
    "arm": 1,
    "restitution": 1,
}
LANDING: dict[str, Any] = {"width": 1, "height": 1, "speed": 1, "restitution": 0.5, "sweeps": 1}


@pytest.mark.parametrize(
    ("function", "arguments", "message"),
    [
        (off_centre_hit, HIT | {"ball_mass": 0}, "ball_mass must be > 0 and finite, got 0"),
        (off_centre_hit, HIT | {"body_mass": math.inf}, "body_mass must be > 0 .* got inf"),
        (off_centre_hit, HIT | {"body_inertia": -1}, "body_inertia must be > 0 .* got -1"),
        (off_centre_hit, HIT | {"arm": math.nan}, "arm must be finite, got nan"),
        (off_centre_hit, HIT | {"restitution": 2}, "restitution must be between 0 and 1, got 2"),
        (flat_landing, LANDING | {"width": 0}, "width must be > 0 and finite, got 0"),
        (flat_landing, LANDING | {"speed": -1}, "speed must be >= 0 and finite, got -1"),
        (flat_landing, LANDING | {"sweeps": 0}, "sweeps must be >= 1, got 0"),
        (two_ball_drop, {"lower_mass": 0, "upper_mass": 1, "speed": 1}, "lower_mass must be > 0"),
        (two_ball_drop, {"lower_mass": 1, "upper_mass": -1, "speed": 1}, "upper_mass must be > 0"),
        (cradle_one_by_one, {"count": 1, "speed": 1}, "count must be >= 2, got 1"),
        (cradle_all_at_once, {"count": 3, "speed": math.inf}, "speed must be finite, got inf"),
        (break_shot, {"speed": 1, "restitution": -1}, "restitution must be between 0 and 1"),
    ],
)
def test_closed_form_bad_input_is_refused_by_name(
    function: Callable[..., Any], arguments: dict[str, Any], message: str
) -> None:
    """The error says argument, rule and value."""
    with pytest.raises(ValueError, match=message):
        function(**arguments)


def test_flat_landing_sweeps_must_be_whole() -> None:
    """Half a sweep is a TypeError, as it is for range."""
    with pytest.raises(TypeError):
        flat_landing(1, 1, 1, 0.5, sweeps=2.5)

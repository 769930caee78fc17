"""Sliding, rolling, tipping and resting: the closed forms against balances and small steps."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.reference.rigid_body_closed_forms import (
    friction_to_roll,
    roll_down,
    rolling_begins,
    slide_down,
    slide_to_roll,
    stack_forces,
    tipping_angle,
    wedge_forces,
)

ROUNDING = 1e-12
"""A few dozen roundings of numbers of size up to 1000."""

STEPS = 20_000
"""Of a simulation by steps that do nothing but add up forces."""

SUM_ERROR = 1e-10
"""In m/s and m: twenty thousand roundings of numbers up to 15; measured: 1.1e-11."""

G = 9.81
"""m/s^2."""

DISC, HOOP, BALL = 0.5, 1.0, 0.4
"""I / (m r^2)."""

speeds = st.floats(-10, 10).map(lambda speed: round(speed, 6))
radii = st.floats(0.1, 2)
ratios = st.floats(0.05, 1)
frictions = st.floats(0.01, 2)
slopes = st.floats(0, 1.5)


def by_steps(
    v: float, w: float, r: float, k: float, mu: float, end: float
) -> tuple[float, float, float]:
    """Return v, w and distance at the end, by small steps of Coulomb's force on the lowest point.

    Mass 1 kg, I = k r^2; friction never turns the sliding round within a step.
    """
    dt, x = end / STEPS, 0.0
    for _ in range(STEPS):
        stopping = -(v + w * r) / (1 + 1 / k)
        push = min(max(stopping, -mu * G * dt), mu * G * dt)
        x += (v + push / 2) * dt
        v, w = v + push, w + push * r / (k * r * r)
    return v, w, x


@pytest.mark.parametrize(
    ("inertia_ratio", "kept"),
    [
        pytest.param(DISC, 2 / 3, id="disc"),
        pytest.param(HOOP, 1 / 2, id="hoop"),
        pytest.param(BALL, 5 / 7, id="ball"),
    ],
)
@pytest.mark.parametrize("friction", [0.05, 0.4, 3.0])
def test_rolling_velocity_without_spin_is_the_part_kept(
    inertia_ratio: float, kept: float, friction: float
) -> None:
    """v/v0 = 1/(1 + k): 2/3, 1/2 and 5/7, whatever the friction and the radius."""
    for radius in (0.1, 1.0):
        rolling = rolling_begins(3.0, 0.0, radius, inertia_ratio, friction, G)
        assert rolling.velocity == pytest.approx(3.0 * kept, rel=ROUNDING)


@pytest.mark.parametrize(
    ("velocity", "angular_velocity"),
    [(3.0, 0.0), (-3.0, 0.0), (0.0, -8.0), (2.0, 30.0), (2.0, -30.0), (1.0, -2.0)],
    ids=["slid", "slid back", "spun", "back-spun", "top-spun", "rolling already"],
)
def test_slide_to_roll_equals_small_steps(velocity: float, angular_velocity: float) -> None:
    """Twenty thousand steps of Coulomb's force, half way, at the change to rolling and beyond."""
    r, k, mu = 0.5, DISC, 0.3
    start = rolling_begins(velocity, angular_velocity, r, k, mu, G)
    for end in (0.5 * start.time, start.time, 1.5 * start.time + 0.1):
        v, w, _ = by_steps(velocity, angular_velocity, r, k, mu, end)
        expected = slide_to_roll(end, velocity, angular_velocity, r, k, mu, G)
        np.testing.assert_allclose(
            (v, w * r), (expected[0], expected[1] * r), rtol=0, atol=SUM_ERROR
        )
    *_, x = by_steps(velocity, angular_velocity, r, k, mu, start.time)
    assert x == pytest.approx(start.distance, abs=SUM_ERROR)


@given(speeds, speeds, radii, ratios, frictions)
def test_rolling_keeps_angular_momentum_about_the_floor(
    v: float, w: float, r: float, k: float, mu: float
) -> None:
    """I w - m r v, for 1 kg: the friction that stops the sliding acts in the floor's line."""
    rolling = rolling_begins(v, w, r, k, mu, G)
    before, after = (
        k * r * r * w - r * v,
        k * r * r * rolling.angular_velocity - r * rolling.velocity,
    )
    assert after == pytest.approx(before, abs=ROUNDING * (abs(r * v) + abs(r * r * w)))
    assert rolling.velocity + rolling.angular_velocity * r == pytest.approx(0, abs=ROUNDING)


@given(speeds, speeds, radii, ratios, frictions)
def test_rolling_has_lost_the_work_of_friction(
    v: float, w: float, r: float, k: float, mu: float
) -> None:
    """Energy lost = mu m g times how far the lowest point has slid, abs(u) t/2."""
    rolling = rolling_begins(v, w, r, k, mu, G)
    spin, rolling_spin = w * r, rolling.angular_velocity * r
    lost = (v * v + k * spin**2 - rolling.velocity**2 - k * rolling_spin**2) / 2
    work = mu * G * abs(v + spin) / 2 * rolling.time
    assert lost == pytest.approx(work, abs=ROUNDING * (v * v + spin**2))


def test_rolling_already_goes_on() -> None:
    """No sliding, no friction, no time."""
    rolling = rolling_begins(1.0, -2.0, 0.5, DISC, 0.3, G)
    assert rolling == (0.0, 0.0, 1.0, -2.0)
    v, w = slide_to_roll([0, 5], 1.0, -2.0, 0.5, DISC, 0.3, G)
    assert (v.tolist(), w.tolist()) == ([1, 1], [-2, -2])


@given(slopes, ratios, st.floats(0, 3))
def test_roll_down_obeys_force_and_torque(angle: float, k: float, mu: float) -> None:
    """For 1 kg, a = g sin - F and k (rim) = F; F is at the edge of Coulomb's cone if it slips.

    The centre is never slower than the rim: friction pushes up the incline.
    """
    a, rim = roll_down(angle, k, mu, G)
    force = k * rim
    assert a == pytest.approx(G * math.sin(angle) - force, abs=ROUNDING * G)
    assert force <= mu * G * math.cos(angle) + ROUNDING
    assert a >= rim - ROUNDING
    if mu < friction_to_roll(angle, k):
        assert force == pytest.approx(mu * G * math.cos(angle), abs=ROUNDING)
    else:
        assert a == rim


@given(slopes, ratios)
def test_roll_down_at_the_limit_of_friction_is_continuous(angle: float, k: float) -> None:
    """Just below and just at the limit it speeds up alike."""
    limit = friction_to_roll(angle, k)
    below, at = roll_down(angle, k, limit * (1 - 1e-14), G), roll_down(angle, k, limit, G)
    np.testing.assert_allclose(below, at, rtol=0, atol=ROUNDING)


@pytest.mark.parametrize(("k", "parts"), [(DISC, 3), (HOOP, 2), (BALL, 3.5)])
def test_friction_to_roll_is_a_part_of_the_slope(k: float, parts: float) -> None:
    """tan/3 for a disc, tan/2 for a hoop, 2 tan/7 for a ball."""
    assert friction_to_roll(0.3, k) == pytest.approx(math.tan(0.3) / parts, rel=ROUNDING)


def test_slide_down_stops_at_the_tangent_of_the_slope() -> None:
    """Below mu = tan it speeds up, from there on it stays, without a jump."""
    angle = math.radians(30)
    assert slide_down(angle, math.tan(angle), G) == 0
    assert slide_down(angle, 0.9, G) == 0
    assert 0 < slide_down(angle, math.tan(angle) - 1e-9, G) < 1e-8
    assert slide_down(angle, 0.0, G) == pytest.approx(G / 2, rel=ROUNDING)
    assert slide_down(angle, 0.2, G) == pytest.approx(
        G / 2 - 0.2 * G * math.sqrt(3) / 2, rel=ROUNDING
    )


@given(slopes, st.floats(0, 3))
def test_slide_down_is_what_a_body_that_cannot_turn_does(angle: float, mu: float) -> None:
    """A body with a huge k hardly turns; on a slope that it slips down it slides like a box."""
    a, rim = roll_down(angle, 1e16, mu, G)
    assert slide_down(angle, mu, G) == pytest.approx(a, abs=1e-12)
    assert rim <= 1e-14


@given(st.floats(0.1, 10), st.floats(0.1, 10))
def test_tipping_angle_puts_the_centre_above_the_corner(width: float, height: float) -> None:
    """Turn the incline by it: from the lower corner to the centre is straight up."""
    angle = tipping_angle(width, height)
    uphill, away = width / 2, height / 2  # from the lower corner, which lies to the left
    x = uphill * math.cos(angle) - away * math.sin(angle)
    assert x == pytest.approx(0, abs=ROUNDING)


def test_tipping_angle_of_a_box_half_as_wide_as_high_is_26_565_degrees() -> None:
    """atan(1/2)."""
    assert round(math.degrees(tipping_angle(0.5, 1.0)), 3) == 26.565


@given(st.floats(0.1, 100), st.floats(0, math.pi / 2), st.floats(0.01, 1.5))
def test_wedge_forces_hold_the_weight(weight: float, left: float, right: float) -> None:
    """Along their normals (sin, cos) and (-sin, cos) the two forces add up to (0, W)."""
    on_left, on_right = wedge_forces(weight, left, right)
    across = on_left * math.sin(left) - on_right * math.sin(right)
    up = on_left * math.cos(left) + on_right * math.cos(right)
    scale = on_left + on_right
    assert (across, up - weight) == pytest.approx((0, 0), abs=ROUNDING * scale)
    assert min(on_left, on_right) >= 0


def test_wedge_forces_of_equal_walls_are_w_over_2_cos() -> None:
    """W/(2 cos 45 deg), and a floor with one wall carries all on the floor."""
    assert wedge_forces(10, math.pi / 4, math.pi / 4) == pytest.approx(
        (math.sqrt(50),) * 2, rel=ROUNDING
    )
    assert wedge_forces(10, 0, math.pi / 2) == (10, 0)
    assert wedge_forces(10, math.pi / 2, 0) == (0, 10)


def test_stack_forces_balance_every_body() -> None:
    """What pushes a body up is its weight and what it pushes up itself; ten equal boxes: N m g."""
    masses = np.array([5.0, 1.0, 4.0, 2.0])
    forces = np.append(stack_forces(masses, G), 0.0)
    np.testing.assert_allclose(forces[:-1] - forces[1:], masses * G, rtol=ROUNDING)
    equal = stack_forces(np.full(10, 2.0), 10.0)
    np.testing.assert_array_equal(equal, np.arange(10, 0, -1) * 20.0)


SET_DOWN: dict[str, Any] = {
    "velocity": 1.0,
    "angular_velocity": 0.0,
    "radius": 1.0,
    "inertia_ratio": 0.5,
    "friction": 0.5,
    "gravity": 10.0,
}
INCLINE: dict[str, Any] = {"angle": 0.3, "inertia_ratio": 0.5, "friction": 0.5, "gravity": 10.0}
BOX: dict[str, Any] = {"angle": 0.3, "friction": 0.5, "gravity": 10.0}
WEDGE: dict[str, Any] = {"weight": 1.0, "left_angle": 0.5, "right_angle": 0.5}


@pytest.mark.parametrize(
    ("function", "arguments", "message"),
    [
        (rolling_begins, SET_DOWN | {"velocity": math.nan}, "velocity must be finite, got nan"),
        (rolling_begins, SET_DOWN | {"radius": 0}, "radius must be > 0 and finite, got 0"),
        (rolling_begins, SET_DOWN | {"inertia_ratio": -1}, "inertia_ratio must be > 0 .* got -1"),
        (rolling_begins, SET_DOWN | {"friction": 0}, "friction must be > 0 and finite, got 0"),
        (rolling_begins, SET_DOWN | {"gravity": -9}, "gravity must be > 0 and finite, got -9"),
        (rolling_begins, SET_DOWN | {"velocity": (1, 2)}, "velocity must be one number"),
        (slide_to_roll, SET_DOWN | {"times": [0, -1]}, "times must be >= 0 .* got -1.0 at index"),
        (
            roll_down,
            INCLINE | {"angle": math.pi / 2},
            "angle must be from 0 to below pi/2 rad, got",
        ),
        (roll_down, INCLINE | {"friction": -0.5}, "friction must be >= 0 and finite, got -0.5"),
        (friction_to_roll, {"angle": -0.1, "inertia_ratio": 1}, "angle must be from 0 .* got -0.1"),
        (slide_down, BOX | {"gravity": math.inf}, "gravity must be > 0 and finite, got inf"),
        (tipping_angle, {"width": 0, "height": 1}, "width must be > 0 and finite, got 0"),
        (wedge_forces, WEDGE | {"weight": 0}, "weight must be > 0 and finite, got 0"),
        (wedge_forces, WEDGE | {"left_angle": 2}, "left_angle must be between 0 and pi/2 .* got 2"),
        (wedge_forces, WEDGE | {"right_angle": -1}, "right_angle must be between .* got -1"),
        (
            wedge_forces,
            WEDGE | {"left_angle": 0, "right_angle": 0},
            "must not both be 0 or both pi/2, got 0 twice",
        ),
        (
            wedge_forces,
            WEDGE | {"left_angle": math.pi / 2, "right_angle": math.pi / 2},
            "must not both be 0 or both pi/2, got 1.57",
        ),
        (stack_forces, {"masses": [1, 0], "gravity": 1}, "masses must be > 0 .* got 0.0 at index"),
    ],
)
def test_closed_form_bad_input_is_refused_by_name(
    function: Callable[..., Any], arguments: dict[str, Any], message: str
) -> None:
    """The error says argument, rule and value."""
    with pytest.raises(ValueError, match=message):
        function(**arguments)

"""The stepped ball: right rules come to rest, wrong ones show, and bad input is named."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.chapters.ch02_restitution.stepped_ball import UP, drop_in_steps
from lesson_code.chapters.ch03_reflection.wrong_answers import doubled_impulse
from lesson_code.formulas import bounce
from lesson_code.reference.closed_forms import bouncing_ball, rest_time
from lesson_code.reference.pymunk_reference import drop_onto_floor

G = 9.81
HERE: dict[str, Any] = {"height": 1.0, "restitution": 0.8, "duration": 2.0, "gravity": G}

ROUNDING = 1e-9
"""m: far above the rounding of a few thousand additions of numbers near 1."""


def peaks(heights: Any) -> Any:
    """Return the start and the highest point of each arc after it."""
    before, here, after = heights[:-2], heights[1:-1], heights[2:]
    return np.append(heights[0], here[(here >= before) & (here > after)])


def test_fall_is_that_of_the_step_rule_worked_by_hand() -> None:
    """Velocity first, then position: at 10 m/s^2 and 0.1 s the ball falls 0.1, 0.2, 0.3 m."""
    times, heights = drop_in_steps(
        bounce, height=5, restitution=0.5, duration=0.3, gravity=10, dt=0.1
    )
    assert times == pytest.approx([0, 0.1, 0.2, 0.3])
    assert heights == pytest.approx([5, 4.9, 4.7, 4.4])


def test_bounce_is_called_with_velocity_normal_and_restitution_below_the_floor_only() -> None:
    """The rule sees the velocity at the step that ended below the floor: 4 steps, -4 m/s."""
    calls: list[Any] = []

    def listening(velocity: Any, normal: Any, restitution: float) -> Any:
        calls.append((velocity.tolist(), normal.tolist(), restitution))
        return bounce(velocity, normal, restitution)

    drop_in_steps(listening, height=0.75, restitution=0.25, duration=0.4, gravity=10, dt=0.1)
    assert calls == [([0.0, -4.0], [0.0, 1.0], 0.25)]


@pytest.mark.parametrize("restitution", [0.0, 0.5, 0.8])
@pytest.mark.parametrize("dt", [1 / 60, 1 / 600])
def test_right_rule_comes_to_rest_on_the_floor(restitution: float, dt: float) -> None:
    """After the time of rest the ball lies there: what is left is the fall of one step, g dt^2."""
    end = rest_time(1.0, restitution, G) + 0.5
    _, heights = drop_in_steps(
        bounce, height=1.0, restitution=restitution, duration=end + 1, gravity=G, dt=dt
    )
    assert np.all(heights >= 0)
    assert heights[round(end / dt) :].max() <= G * dt**2


@given(
    height=st.floats(0.1, 10),
    restitution=st.floats(0, 1),
    gravity=st.floats(1, 25),
    dt=st.sampled_from([1 / 30, 1 / 60, 1 / 240]),
)
def test_energy_never_grows_by_more_than_a_step(
    height: float, restitution: float, gravity: float, dt: float
) -> None:
    """No arc is higher than the one before it by more than the fall of one step, g dt^2."""
    _, heights = drop_in_steps(
        bounce, height=height, restitution=restitution, duration=3, gravity=gravity, dt=dt
    )
    assert np.diff(peaks(heights)).max(initial=0) <= gravity * dt**2 + ROUNDING


def test_error_shrinks_in_proportion_to_the_step() -> None:
    """First order, as pymunk's: a tenth of the step, about a tenth of the error."""
    errors = []
    for dt in (1 / 60, 1 / 600, 1 / 6000):
        times, heights = drop_in_steps(bounce, **(HERE | {"duration": 1.5}), dt=dt)
        errors.append(np.abs(heights - bouncing_ball(times, 1.0, 0.8, G)).mean())
    order = np.log10(errors[0] / errors[2]) / 2
    assert order == pytest.approx(1, abs=0.2)


def test_first_fall_is_pymunk_s_one_step_earlier() -> None:
    """Pymunk moves a body before it changes its velocity: its fall is ours, a step later."""
    times, heights = drop_in_steps(bounce, **HERE)
    times_there, heights_there = drop_onto_floor(
        height=1.0, restitution=0.8, duration=2.0, dt=1 / 60, gravity=G
    )
    assert times == pytest.approx(times_there)
    falling = int(np.argmax(heights <= 0))
    assert falling > 20
    assert heights[:falling] == pytest.approx(heights_there[1 : falling + 1], abs=1e-12)


def test_doubled_impulse_climbs() -> None:
    """With e = 0.8 each bounce multiplies the height by 2.6^2: over 6 m after the first."""
    _, heights = drop_in_steps(doubled_impulse, **(HERE | {"duration": 10.0}), dt=1 / 6000)
    highest = peaks(heights)
    assert len(highest) >= 3
    assert np.all(np.diff(highest) > 0)
    assert highest[1] == pytest.approx(6.76, rel=0.01)


def test_ball_that_is_not_pushed_out_sinks() -> None:
    """Without a correction of positions, gravity draws a ball at rest through the floor."""
    _, pushed = drop_in_steps(bounce, **(HERE | {"restitution": 0.5, "duration": 3.0}))
    _, sunk = drop_in_steps(bounce, **(HERE | {"restitution": 0.5, "duration": 3.0}), separate=None)
    assert pushed[-1] == pytest.approx(0, abs=G / 60**2)
    assert sunk[-1] < -0.05


@pytest.mark.parametrize(
    ("duration", "dt", "steps"),
    [
        (0, 0.1, 0),
        (1, 1, 1),
        (1, 0.3, 3),
        (1, 0.4, 2),
        (1, 0.6, 1),
        (0.5, 1, 0),
        (2, 1 / 600, 1200),
    ],
)
def test_as_many_whole_steps_are_made_as_fit(duration: float, dt: float, steps: int) -> None:
    """Times and heights start at 0 s and end at the last whole step."""
    times, heights = drop_in_steps(
        bounce, height=1, restitution=1, duration=duration, gravity=G, dt=dt
    )
    assert len(times) == len(heights) == steps + 1
    assert (times[0], heights[0]) == (0, 1)
    assert times[-1] == pytest.approx(steps * dt)


@pytest.mark.parametrize("steps", [30, 49, 1000, pytest.param(4321, marks=pytest.mark.full)])
def test_duration_of_so_many_steps_gives_so_many(steps: int) -> None:
    """A product that rounds down just below a whole number does not lose a step."""
    for dt in (0.1, 1 / 60, 1 / 3, 0.007):
        assert (
            len(drop_in_steps(bounce, **(HERE | {"duration": steps * dt}), dt=dt)[0]) == steps + 1
        )


def test_arguments_are_not_changed_between_steps() -> None:
    """A rule that writes into its velocity changes nothing, and the normal refuses it."""
    clean = drop_in_steps(bounce, **HERE)[1]

    def careless(velocity: Any, normal: Any, restitution: float) -> Any:
        after = bounce(velocity, normal, restitution)
        velocity[:] = np.nan
        return after

    assert np.array_equal(drop_in_steps(careless, **HERE)[1], clean)
    with pytest.raises(ValueError, match="read-only"):
        UP[0] = 1.0


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("height", 0),
        ("height", -1),
        ("height", np.inf),
        ("restitution", -0.1),
        ("restitution", 1.1),
        ("duration", -1),
        ("duration", np.inf),
        ("gravity", 0),
        ("gravity", -G),
        ("dt", 0),
        ("dt", -0.1),
        *((name, np.nan) for name in ("height", "restitution", "duration", "gravity", "dt")),
    ],
)
def test_number_out_of_range_is_refused_by_name_and_value(name: str, value: float) -> None:
    """The error says which argument, which rule and what was given."""
    with pytest.raises(ValueError, match=rf"^{name} must be .*, got {value}$"):
        drop_in_steps(bounce, **(HERE | {name: value}))


@pytest.mark.parametrize("name", ["height", "restitution", "duration", "gravity", "dt"])
@pytest.mark.parametrize("value", ["fast", None, [0.5, 0.6], np.array([0.5])])
def test_what_is_no_single_number_is_refused_by_name(name: str, value: Any) -> None:
    """A text, nothing, or several numbers at once: the error names the argument."""
    with pytest.raises((TypeError, ValueError), match=f"^{name} must be"):
        drop_in_steps(bounce, **(HERE | {name: value}))


@pytest.mark.parametrize("wrong", [None, 3.0, (1.0, 2.0, 3.0), (0.0, np.nan), "up"])
def test_rule_that_returns_no_velocity_is_refused(wrong: Any) -> None:
    """A rule that forgot its return, or lost a component, is told so at the first bounce."""
    with pytest.raises((TypeError, ValueError), match=r"^the velocity after a bounce must"):
        drop_in_steps(lambda *_: wrong, **HERE)


def test_separation_can_be_anybodys() -> None:
    """It is given the position, the normal and the depth; the ball lies where it says."""
    asked = []

    def a_metre_up(position: Any, normal: Any, depth: float) -> Any:
        asked.append((position[1], depth))
        return position + (depth + 1.0) * normal

    _, heights = drop_in_steps(bounce, **HERE, separate=a_metre_up)
    assert asked
    assert all(y == -depth < 0 for y, depth in asked)
    assert np.count_nonzero(heights == 1.0) >= len(asked)


def test_separation_that_gives_no_position_is_named() -> None:
    """The error says whose answer it was."""
    with pytest.raises(ValueError, match="the position moved out"):
        drop_in_steps(bounce, **HERE, separate=lambda *_: np.nan)

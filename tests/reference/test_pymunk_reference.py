"""The door in front of pymunk: what it answers, and what it refuses before pymunk is called."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Callable
from dataclasses import FrozenInstanceError
from typing import Any

import numpy as np
import pytest

from lesson_code.reference.closed_forms import bounce_heights, bounce_times, bouncing_ball
from lesson_code.reference.pymunk_reference import (
    bounce_off_segment,
    collide_on_a_line,
    drop_onto_floor,
    rebound_heights,
)

ROUNDING = 1e-13
"""A few roundings of velocities of size 1 to 10."""

PAIR: dict[str, Any] = {"m1": 1, "v1": 2, "m2": 3, "v2": -1, "restitution": 0.7}
WALL: dict[str, Any] = {
    "position": (0, 0.9),
    "velocity": (3, -4),
    "radius": 1.0,
    "start": (-5, 0),
    "end": (5, 0),
    "half_thickness": 0.0,
    "restitution": 0.5,
    "friction": 0.0,
}
DROP: dict[str, Any] = {
    "height": 1.0,
    "restitution": 0.8,
    "duration": 2.0,
    "dt": 1 / 240,
    "gravity": 10.0,
}


def test_collision_hard_case_one_is_known() -> None:
    """Masses 1 and 3, velocities 2 and -1, e = 0.7 give -1.825 and 0.275 (hard case 1)."""
    assert collide_on_a_line(**PAIR) == pytest.approx((-1.825, 0.275), abs=ROUNDING)


@pytest.mark.parametrize(
    ("change", "after"),
    [
        pytest.param({"m1": math.inf, "restitution": 1}, (2, 5), id="heavy from the left"),
        pytest.param({"m2": math.inf, "restitution": 1}, (-4, -1), id="heavy from the right"),
        pytest.param({"m2": math.inf, "v2": 0, "restitution": 0}, (0, 0), id="stuck to a wall"),
    ],
)
def test_collision_infinite_mass_keeps_its_velocity(
    change: dict[str, float], after: tuple[float, float]
) -> None:
    """Seen from the immovable body the other one is turned round: worked by hand."""
    assert collide_on_a_line(**(PAIR | change)) == pytest.approx(after, abs=ROUNDING)


@pytest.mark.parametrize("speed", [5e-324, 1e-300, 1e-9, 1e9, 1e100])
def test_collision_any_speed_is_in_contact(speed: float) -> None:
    """The step is short enough at any speed, and there is no threshold: equal masses swap."""
    assert collide_on_a_line(1, speed, 1, 0, 1) == pytest.approx((0, speed), abs=speed * ROUNDING)


def test_bounce_hand_worked_with_friction() -> None:
    """Velocity (3, -4), e = 0.5: jn = 6, so mu = 0.25 takes 1.5 of the 3 m/s along the wall."""
    result = bounce_off_segment(**(WALL | {"friction": 0.25}))
    np.testing.assert_allclose(result.velocity, (1.5, 2), atol=ROUNDING)
    assert result.normal is not None
    np.testing.assert_allclose(result.normal, (0, 1), atol=ROUNDING)


def test_bounce_moved_position_is_one_step_on() -> None:
    """The contact belongs to the position p + v dt."""
    result = bounce_off_segment(**(WALL | {"dt": 0.125}))
    np.testing.assert_allclose(result.moved_position, (0.375, 0.4), atol=ROUNDING)


def test_bounce_without_contact_has_no_normal() -> None:
    """No contact is None, and the velocity is untouched."""
    result = bounce_off_segment(**(WALL | {"position": (0, 1.5)}))
    assert result.normal is None
    np.testing.assert_array_equal(result.velocity, (3, -4))


def test_bounce_result_is_frozen() -> None:
    """A result is a record of what happened, and stays as it is."""
    result = bounce_off_segment(**WALL)
    with pytest.raises(FrozenInstanceError):
        result.normal = None  # type: ignore[misc]


def test_drop_first_fall_is_euler_position_first() -> None:
    """Before the first impact y_k = h - g dt^2 k (k - 1) / 2: the old velocity moves the ball."""
    times, heights = drop_onto_floor(**(DROP | {"duration": 0.25, "dt": 1 / 64}))
    k = np.arange(17)
    np.testing.assert_array_equal(times, k / 64)
    np.testing.assert_allclose(heights, 1 - 10 / 64**2 * k * (k - 1) / 2, atol=ROUNDING)


def test_drop_error_falls_with_the_step_at_first_order() -> None:
    """16 times shorter steps bring the ball 8 to 32 times closer to the closed form."""
    errors = []
    for dt in (1 / 64, 1 / 1024):
        times, heights = drop_onto_floor(**(DROP | {"dt": dt}))
        errors.append(np.abs(heights - bouncing_ball(times, 1.0, 0.8, 10.0)).mean())
    assert 8 < errors[0] / errors[1] < 32


def test_drop_very_fast_ball_does_not_pass_the_floor() -> None:
    """A ball that moves 70 m in a step, 35 of its diameters, is still stopped."""
    _, heights = drop_onto_floor(height=25_000, restitution=0, duration=120, dt=0.1, gravity=10)
    assert heights.min() > -100
    assert abs(heights[-1]) < 1


def test_drop_counts_whole_steps_in_spite_of_rounding() -> None:
    """A duration of 0.7 s is 7 steps of 0.1 s, though 0.7 / 0.1 is 6.999999999999999."""
    times, heights = drop_onto_floor(**(DROP | {"duration": 0.7, "dt": 0.1}))
    assert times.shape == heights.shape == (8,)


def test_rebounds_short_steps_approach_the_powers_of_restitution() -> None:
    """Peaks tend to e^(2n) h; at 1/2000 s they are within 1 % (pymunk is of first order)."""
    duration = float(bounce_times(1, 0.8, 4, 10)[-1])
    peaks = rebound_heights(**(DROP | {"duration": duration, "dt": 1 / 2000}))
    np.testing.assert_allclose(peaks, bounce_heights(1, 0.8, 3), rtol=0.01)


@pytest.mark.parametrize(
    ("restitution", "at_60", "at_240"),
    [(0.3, 0.069, 0.083), (0.5, 0.235, 0.245), (0.8, 0.634, 0.638), (0.95, 0.901, 0.902)],
)
def test_rebounds_from_two_metres_are_the_measured_ones(
    restitution: float, at_60: float, at_240: float
) -> None:
    """The first rebound from 2 m, as a part of it, at 60 and 240 Hz (hard case 4)."""
    for rate, part in ((60, at_60), (240, at_240)):
        drop = {"height": 2, "restitution": restitution, "duration": 1.5, "dt": 1 / rate}
        peaks = rebound_heights(**drop, gravity=10)
        assert peaks[0] / 2 == pytest.approx(part, abs=6e-4)


@pytest.mark.parametrize(
    ("function", "arguments", "message"),
    [
        (collide_on_a_line, PAIR | {"m1": -1}, "m1 must be > 0 kg, got -1"),
        (collide_on_a_line, PAIR | {"m2": math.nan}, "m2 must be > 0 kg, got nan"),
        (collide_on_a_line, PAIR | {"m1": math.inf, "m2": math.inf}, "not both be infinite"),
        (collide_on_a_line, PAIR | {"v1": math.nan}, "v1 must be finite, got nan"),
        (collide_on_a_line, PAIR | {"restitution": -0.1}, "restitution must be between 0 and 1"),
        (collide_on_a_line, PAIR | {"restitution": 1.1}, "restitution must be between 0 and 1"),
        (collide_on_a_line, PAIR | {"v2": 2}, "v1 must be > v2.* got v1 = 2.0 and v2 = 2"),
        (bounce_off_segment, WALL | {"friction": -1}, "friction must be >= 0 and finite, got -1"),
        (bounce_off_segment, WALL | {"friction": math.nan}, "friction must be .* got nan"),
        (bounce_off_segment, WALL | {"restitution": -1}, "restitution must be between 0 and 1"),
        (bounce_off_segment, WALL | {"radius": -1}, "radius must be > 0 and finite, got -1"),
        (bounce_off_segment, WALL | {"half_thickness": -1}, "half_thickness must be >= 0"),
        (bounce_off_segment, WALL | {"end": (-5, 0)}, "start and end must differ"),
        (bounce_off_segment, WALL | {"position": (0, math.nan)}, "position must be finite"),
        (bounce_off_segment, WALL | {"velocity": (math.inf, 0)}, "velocity must be finite"),
        (bounce_off_segment, WALL | {"velocity": (1, 2, 3)}, "velocity must have shape"),
        (bounce_off_segment, WALL | {"dt": -1e-9}, "dt must be > 0 and finite, got -1e-09"),
        (drop_onto_floor, DROP | {"height": 0}, "height must be > 0 and finite, got 0"),
        (drop_onto_floor, DROP | {"restitution": 2}, "restitution must be between 0 and 1"),
        (drop_onto_floor, DROP | {"duration": -1}, "duration must be >= 0 and finite, got -1"),
        (drop_onto_floor, DROP | {"dt": 0}, "dt must be > 0 and finite, got 0"),
        (drop_onto_floor, DROP | {"gravity": -9.81}, "gravity must be > 0 and finite"),
        (rebound_heights, DROP | {"dt": math.inf}, "dt must be > 0 and finite, got inf"),
    ],
)
def test_reference_bad_input_is_refused_by_name(
    function: Callable[..., Any], arguments: dict[str, Any], message: str
) -> None:
    """What would abort the process or pass as nan is a ValueError with argument, rule, value."""
    with pytest.raises(ValueError, match=message):
        function(**arguments)


def test_reference_package_import_leaves_pymunk_alone() -> None:
    """Importing the closed forms does not need pymunk."""
    code = "import sys, lesson_code.reference.closed_forms; sys.exit('pymunk' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0

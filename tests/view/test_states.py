"""Which state is drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Run, Scene
from lesson_code.view import states

BALL = Body(Circle(1.0), position=(1, 2), angle=0.5, velocity=(3, 4), mass=1.0)


@pytest.fixture
def run(run_of: Any) -> Run:
    """Return three states, 0.1 s apart."""
    made: Run = run_of(
        Scene([BALL, BALL]),
        [0.0, 0.1, 0.2],
        np.zeros((3, 2, 2)),
    )
    return made


def test_scene_has_one_state_the_one_it_starts_with() -> None:
    """Places and angles are those of the bodies."""
    scene = Scene([BALL])
    positions, angles = states.poses(scene)
    assert states.scene_of(scene) is scene
    assert positions.tolist() == [[[1, 2]]]
    assert angles.tolist() == [[0.5]]
    assert (states.frame_at(scene, None), states.frame_at(scene, 0.0)) == (0, 0)


def test_empty_scene_has_a_state_of_no_bodies() -> None:
    """The arrays have their three and two dimensions all the same."""
    positions, angles = states.poses(Scene())
    assert (positions.shape, angles.shape) == ((1, 0, 2), (1, 0))


def test_run_has_the_states_that_were_recorded(run: Run) -> None:
    """They are passed on as they are."""
    assert states.scene_of(run) is run.scene
    assert states.poses(run) == (run.positions, run.angles)


@pytest.mark.parametrize(
    ("time", "frame"), [(0, 0), (0.04, 0), (0.06, 1), (0.2, 2), (0.2 + 1e-12, 2), (None, 2)]
)
def test_frame_is_the_nearest_to_a_time(run: Run, time: float | None, frame: int) -> None:
    """And the last one, when no time is given."""
    assert states.frame_at(run, time) == frame


@pytest.mark.parametrize("time", [-0.01, 0.21, float("nan"), float("inf")])
def test_time_outside_the_run_is_refused(run: Run, time: float) -> None:
    """The message names the run's times."""
    with pytest.raises(ValueError, match=r"time must lie between 0 and 0\.2 s"):
        states.frame_at(run, time)

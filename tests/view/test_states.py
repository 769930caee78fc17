"""Which state is drawn, and which impulses belong to it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Run, Scene
from lesson_code.view import states

BALL = Body(Circle(1.0), position=(1, 2), angle=0.5, velocity=(3, 4), mass=1.0)
UP = (0.0, 1.0)


@pytest.fixture
def run(run_of: Any) -> Run:
    """Return three states, 0.1 s apart, and impulses in the steps between them."""
    made: Run = run_of(
        Scene([BALL, BALL]),
        [0.0, 0.1, 0.2],
        np.zeros((3, 2, 2)),
        contacts=[
            (0.05, 0, 1, (0, 0), UP, 1.0, 0.0),
            (0.1 + 1e-16, 0, 1, (0, 0), UP, 2.0, 0.0),
            (0.1 + 1e-16, 0, 1, (1, 0), UP, 3.0, 0.0),
        ],
    )
    return made


def test_scene_has_one_state_the_one_it_starts_with() -> None:
    """Places, angles and velocities are those of the bodies."""
    scene = Scene([BALL])
    positions, angles = states.poses(scene)
    assert states.scene_of(scene) is scene
    assert positions.tolist() == [[[1, 2]]]
    assert angles.tolist() == [[0.5]]
    assert states.velocities_of(scene).tolist() == [[[3, 4]]]
    assert (states.frame_at(scene, None), states.frame_at(scene, 0.0)) == (0, 0)


def test_empty_scene_has_a_state_of_no_bodies() -> None:
    """The arrays have their three and two dimensions all the same."""
    positions, angles = states.poses(Scene())
    assert (positions.shape, angles.shape) == ((1, 0, 2), (1, 0))
    assert states.velocities_of(Scene()).shape == (1, 0, 2)


def test_run_has_the_states_that_were_recorded(run: Run) -> None:
    """They are passed on as they are."""
    assert states.scene_of(run) is run.scene
    assert states.poses(run) == (run.positions, run.angles)
    assert states.velocities_of(run) is run.velocities


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


def test_impulses_of_a_state_are_those_of_the_step_that_ends_there(run: Run) -> None:
    """Of the two steps before the state at 0.1 s only the last; rounding does not matter."""
    assert states.events_of_step(run, 1).tolist() == [1, 2]


def test_states_without_contact_since_the_one_before_have_no_impulses(run: Run) -> None:
    """Neither the first nor the third."""
    assert states.events_of_step(run, 0).tolist() == []
    assert states.events_of_step(run, 2).tolist() == []

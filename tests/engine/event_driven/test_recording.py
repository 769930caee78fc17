"""Recording an exact run: a state after each collision, or at any times that are wanted."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Scene, Segment, simulate

ELASTIC = Material(1.0)


def bouncing() -> Scene:
    """Return a ball between two walls 10 m apart, at 2 m/s, and a wall that moves away."""
    walls = [Body(Segment((x, -5), (x, 5)), material=ELASTIC) for x in (0, 11)]
    far = Body(Segment((0, 20), (5, 20)), velocity=(0, 3), angle=0.5)
    ball = Body(Circle(0.5), mass=1.0, position=(5.5, 0), velocity=(2, 0), material=ELASTIC)
    return Scene([*walls, far, ball])


def test_run_without_a_sample_has_a_state_for_each_collision() -> None:
    """Start, 2.5 s, 7.5 s, end."""
    run = simulate(bouncing(), 10.0, solver="exact")
    assert run.times.tolist() == [0.0, 2.5, 7.5, 10.0]
    assert run.positions[:, 3, 0].tolist() == [5.5, 10.5, 0.5, 5.5]
    assert run.velocities[:, 3, 0].tolist() == [2.0, -2.0, 2.0, 2.0]


def test_collision_at_the_very_end_is_the_last_state() -> None:
    """There is no second one at the same time."""
    assert simulate(bouncing(), 7.5, solver="exact").times.tolist() == [0.0, 2.5, 7.5]


def test_sample_end_has_two_states_and_all_impulses() -> None:
    """The first and the last."""
    run = simulate(bouncing(), 10.0, solver="exact", sample="end")
    assert run.times.tolist() == [0.0, 10.0]
    assert run.contacts.time.tolist() == [2.5, 7.5]
    assert run.contacts.body_b.tolist() == [3, 3]
    assert run.contacts.penetration.tolist() == [0.0, 0.0]


def test_times_may_be_given_in_any_order() -> None:
    """Frames come in the order in which they were asked for; a time may be asked for twice."""
    times = [9.0, 1.0, 2.5, 1.0]
    run = simulate(bouncing(), 10.0, solver="exact", sample=times)
    assert run.times.tolist() == times
    assert run.positions[:, 3, 0].tolist() == [3.5, 7.5, 10.5, 7.5]
    assert run.contacts.time.tolist() == [2.5, 7.5]


def test_state_at_the_time_of_a_collision_is_the_one_after_it() -> None:
    """The impulse has been given."""
    run = simulate(bouncing(), 10.0, solver="exact", sample=[2.5])
    assert run.velocities[0, 3].tolist() == [-2.0, 0.0]


def test_obstacle_moves_evenly_and_keeps_its_angle() -> None:
    """3 m/s upwards."""
    run = simulate(bouncing(), 10.0, solver="exact", sample=[0.0, 4.0])
    assert run.positions[:, 2, 1].tolist() == [0.0, 12.0]
    assert run.velocities[:, 2].tolist() == [[0.0, 3.0]] * 2
    assert run.angles[:, 2].tolist() == [0.5, 0.5]


@pytest.mark.parametrize("sample", [[], np.array([])])
def test_sample_of_no_times_has_no_states_but_all_impulses(sample: Any) -> None:
    """As for the solvers that go in steps."""
    run = simulate(bouncing(), 10.0, solver="exact", sample=sample)
    assert run.positions.shape == (0, 4, 2)
    assert len(run.contacts) == 2


def test_states_do_not_depend_on_the_times_that_are_asked_for() -> None:
    """A state is a question to the run, not a part of it: the same bits at the end."""
    often = simulate(bouncing(), 100.0, solver="exact", sample=np.linspace(0, 100, 77))
    once = simulate(bouncing(), 100.0, solver="exact", sample="end")
    assert often.positions[-1].tobytes() == once.positions[-1].tobytes()


def test_body_that_leaves_floating_point_is_a_clear_error() -> None:
    """It says which body."""
    scene = Scene([Body(Circle(0.5), mass=1.0, velocity=(1e308, 0))])
    with pytest.raises(FloatingPointError, match="body 0 has left the range of floating point"):
        simulate(scene, 5.0, solver="exact")

"""The step: the order of its stages, walls that move, sub-steps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment, simulate
from lesson_code.engine.core import step as stages
from lesson_code.engine.core.broad_phase import all_pairs
from lesson_code.engine.core.pipeline import Pipeline, SolverStages
from lesson_code.engine.core.step import rigid_part, step
from lesson_code.engine.core.tables import world_of

ROUNDING = 1e-13
"""m and m/s: sixty additions of numbers of about 1."""

FLOOR = Body(Segment((-50, 0), (50, 0)))


# The order

STAGES = (
    "move",
    "find_pairs",
    "find_contacts",
    "has_capacity_for_record",
    "accelerate",
    "record_impulses",
)
"""What a step calls besides its solver and its listener."""


def noting(called: list[str], name: str, answer: bool = True) -> Any:
    """Return a stage that writes down its name, and says that all is well or that it is not."""

    def stage(*_: Any) -> bool:
        called.append(name)
        return answer

    return stage


def noting_solver(called: list[str]) -> SolverStages:
    """Return a solver whose stages write down their names."""
    return SolverStages(*[noting(called, name) for name in SolverStages._fields])


def pipeline(solver: SolverStages, listener: Any = None) -> Pipeline:
    """Return the pipeline of a solver."""
    return Pipeline(rigid_part, all_pairs, solver, listener)


def test_stages_come_in_the_order_of_the_pipeline(monkeypatch: pytest.MonkeyPatch) -> None:
    """Detection, resolution, post-processing; the listener hears before and after the impulses."""
    called: list[str] = []

    class Listener:
        def before_impulses(self, _: Any) -> None:
            called.append("before_impulses")

        def after_impulses(self, _: Any) -> None:
            called.append("after_impulses")

    for name in STAGES:
        monkeypatch.setattr(stages, name, noting(called, name))
    world = world_of(Scene(), dt=0.1, iterations=2, combine=MixingRule())
    assert step(world, pipeline(noting_solver(called), Listener()))
    assert called == [
        *("move", "find_pairs", "find_contacts", "has_capacity_for_record", "before_impulses"),
        *("prepare", "accelerate", "warm_start", "solve", "solve"),
        *("has_overlap_to_undo", "correct", "correct"),
        *("store", "after_impulses", "record_impulses"),
    ]


def test_correction_without_an_overlap_to_undo_is_left_out() -> None:
    """Nobody pays for sweeps that have nothing to do."""
    called: list[str] = []
    solver = noting_solver(called)._replace(has_overlap_to_undo=lambda *_: False)
    world = world_of(Scene([FLOOR]), dt=0.1, iterations=2, combine=MixingRule())
    assert step(world, pipeline(solver))
    assert called == ["prepare", "warm_start", "solve", "solve", "store"]


@pytest.mark.parametrize("stop", ["find_pairs", "find_contacts", "has_capacity_for_record"])
def test_step_that_lacks_room_goes_on_where_it_stopped(
    monkeypatch: pytest.MonkeyPatch, stop: str
) -> None:
    """The bodies move once, whatever is called again; no stage has begun to solve before."""
    called: list[str] = []
    for name in STAGES:
        monkeypatch.setattr(stages, name, noting(called, name, answer=name != stop))
    world = world_of(Scene(), dt=0.1, iterations=1, combine=MixingRule())
    assert not step(world, pipeline(noting_solver(called)))
    assert (called[0], called[-1], world.state.has_moved) == ("move", stop, True)
    assert not {"prepare", "accelerate", "store"} & set(called)
    monkeypatch.setattr(stages, stop, noting(called, stop))
    assert step(world, pipeline(noting_solver(called)))
    assert (called.count("move"), called.count("solve")) == (1, 1)
    assert not world.state.has_moved


@given(st.sampled_from(["x", "y", "vx", "vy", "angle", "w"]), st.sampled_from([math.inf, math.nan]))
def test_body_beyond_floating_point_is_noted_by_number(name: str, value: float) -> None:
    """Before a sine or a grid cell of it is asked for; and the step stops there."""
    world = world_of(Scene([FLOOR, Body(Polygon.box(1, 2), mass=2.0)]), 0.1, 1, MixingRule())
    setattr(world.bodies[1], name, value)
    called: list[str] = []
    assert not step(world, pipeline(noting_solver(called)))
    assert (world.state.lost_body, world.state.has_pairs, called) == (1, False, [])


# Walls that move, sub-steps


def test_ball_hit_by_a_moving_wall_leaves_at_twice_its_speed() -> None:
    """In the wall's frame the ball is turned round: 0 becomes 2 u."""
    bat = Body(Polygon.box(1, 4), velocity=(3, 0))
    ball = Body(Circle(0.5), mass=1, position=(1.5, 0), material=Material(1.0))
    run = simulate(Scene([bat, ball]), 1.0, solver="sequential")
    np.testing.assert_allclose(run.velocities[-1], [(3, 0), (6, 0)], rtol=ROUNDING)


def test_conveyor_belt_that_turns_drives_a_disc_by_friction() -> None:
    """A static roller that spins sets a disc beside it spinning, until both rims move alike."""
    roller = Body(Circle(1), angular_velocity=4, material=Material(friction=0.5))
    disc = Body(Circle(0.5), mass=1, position=(0, 1.499), material=Material(friction=0.5))
    pipe = [Body(Segment((x, 0), (x, 9)), material=Material(friction=0)) for x in (-0.5, 0.5)]
    run = simulate(Scene([roller, disc, *pipe], gravity=(0, -10)), 3.0, solver="sequential")
    assert run.angular_velocities[-1, 1] == pytest.approx(-8, rel=1e-6)


def test_run_in_sub_steps_is_the_run_in_short_steps() -> None:
    """A step in four parts is four steps of a quarter, to the bit; only recorded less often."""
    ball = Body(
        Circle(0.5), mass=1, position=(0, 1.5), velocity=(1, 0), material=Material(0.8, 0.3)
    )
    scene = Scene([FLOOR, ball], gravity=(0, -10))
    parts = simulate(scene, 2.0, dt=1 / 32, substeps=4, solver="sequential")
    short = simulate(scene, 2.0, dt=1 / 128, solver="sequential")
    np.testing.assert_array_equal(parts.positions, short.positions[::4])
    np.testing.assert_array_equal(parts.velocities, short.velocities[::4])
    np.testing.assert_array_equal(parts.contacts.time, short.contacts.time)
    np.testing.assert_array_equal(parts.contacts.normal_impulse, short.contacts.normal_impulse)

"""The step: the order of its stages, motion without contacts, gravity, damping, moving walls."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Combination, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core import step as stages
from lesson_code.engine.core.broad_phase import all_pairs
from lesson_code.engine.core.step import (
    ContactSolver,
    Pipeline,
    accelerate,
    move,
    step,
    turn_with_angle,
)
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.effects.continuous import rigid_part

ROUNDING = 1e-13
"""m and m/s: sixty additions of numbers of about 1."""

FLOOR = Body(Segment((-50, 0), (50, 0)))


def one_body(**motion: Any) -> Scene:
    """Return a scene of one body that meets nobody."""
    return Scene([Body(Polygon.box(1, 2), mass=2.0, **motion)])


# The order

STAGES = (
    "move",
    "find_pairs",
    "find_contacts",
    "has_room_for_record",
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


def noting_solver(called: list[str]) -> ContactSolver:
    """Return a solver whose stages write down their names."""
    return ContactSolver(*[noting(called, name) for name in ContactSolver._fields])


def pipeline(solver: ContactSolver, listener: Any = None) -> Pipeline:
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
    world = world_of(Scene(), dt=0.1, iterations=2, combine=Combination())
    assert step(world, pipeline(noting_solver(called), Listener()))
    assert called == [
        *("move", "find_pairs", "find_contacts", "has_room_for_record", "before_impulses"),
        *("prepare", "accelerate", "warm_start", "solve", "solve"),
        *("has_overlap_to_undo", "correct", "correct"),
        *("store", "after_impulses", "record_impulses"),
    ]


def test_correction_without_an_overlap_to_undo_is_left_out() -> None:
    """Nobody pays for sweeps that have nothing to do."""
    called: list[str] = []
    solver = noting_solver(called)._replace(has_overlap_to_undo=lambda *_: False)
    world = world_of(Scene([FLOOR]), dt=0.1, iterations=2, combine=Combination())
    assert step(world, pipeline(solver))
    assert called == ["prepare", "warm_start", "solve", "solve", "store"]


@pytest.mark.parametrize("stop", ["find_pairs", "find_contacts", "has_room_for_record"])
def test_step_that_lacks_room_goes_on_where_it_stopped(
    monkeypatch: pytest.MonkeyPatch, stop: str
) -> None:
    """The bodies move once, whatever is called again; no stage has begun to solve before."""
    called: list[str] = []
    for name in STAGES:
        monkeypatch.setattr(stages, name, noting(called, name, answer=name != stop))
    world = world_of(Scene(), dt=0.1, iterations=1, combine=Combination())
    assert not step(world, pipeline(noting_solver(called)))
    assert (called[0], called[-1], world.state.has_moved) == ("move", stop, True)
    assert not {"prepare", "accelerate", "store"} & set(called)
    monkeypatch.setattr(stages, stop, noting(called, stop))
    assert step(world, pipeline(noting_solver(called)))
    assert (called.count("move"), called.count("solve")) == (1, 1)
    assert not world.state.has_moved


# Motion


def test_body_without_forces_moves_and_turns_evenly() -> None:
    """Position x0 + v t, angle a0 + w t, and the velocities stay to the bit."""
    scene = one_body(position=(1, 2), velocity=(3, -1), angle=0.5, angular_velocity=-2)
    run = simulate(scene, 1.0, solver="sequential")
    t = run.times[:, np.newaxis]
    np.testing.assert_allclose(run.positions[:, 0], (1, 2) + t * (3, -1), atol=ROUNDING)
    np.testing.assert_allclose(run.angles[:, 0], 0.5 - 2 * run.times, atol=ROUNDING)
    assert (run.velocities == run.velocities[0]).all()
    assert (run.angular_velocities == -2).all()


def test_outline_of_a_body_that_turns_follows_its_angle() -> None:
    """After a quarter turn the corner (0.5, 1) is at (-1, 0.5), and every normal turns too."""
    world = world_of(one_body(angular_velocity=math.pi / 2), 1.0, 1, Combination())
    move(world)
    corners = [(corner.x, corner.y) for corner in world.corners]
    np.testing.assert_allclose(corners[2], (-1, 0.5), atol=ROUNDING)
    turned = [(-corner.local_ny, corner.local_nx) for corner in world.corners]
    np.testing.assert_allclose([(c.nx, c.ny) for c in world.corners], turned, atol=ROUNDING)


def test_outline_of_a_body_that_does_not_turn_is_never_computed_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A floor costs no sine."""
    world = world_of(Scene([FLOOR]), 0.1, 1, Combination())
    monkeypatch.setattr(stages, "turn_with_angle", lambda *_: pytest.fail("placed without a spin"))
    move(world)


def test_outline_at_a_large_angle_keeps_its_size() -> None:
    """After 159,155 turns: corners come from the angle each time, so that no error piles up."""
    world = world_of(one_body(), 0.1, 1, Combination())
    body = world.bodies[0]
    body.angle = 1e6
    turn_with_angle(world, body)
    sizes = [math.hypot(corner.x, corner.y) for corner in world.corners]
    assert sizes == pytest.approx([math.hypot(0.5, 1)] * 4, rel=ROUNDING)


@given(st.sampled_from(["x", "y", "vx", "vy", "angle", "w"]), st.sampled_from([math.inf, math.nan]))
def test_body_beyond_floating_point_is_noted_by_number(name: str, value: float) -> None:
    """Before a sine or a grid cell of it is asked for; and the step stops there."""
    world = world_of(Scene([FLOOR, *one_body().bodies]), 0.1, 1, Combination())
    setattr(world.bodies[1], name, value)
    called: list[str] = []
    assert not step(world, pipeline(noting_solver(called)))
    assert (world.state.lost_body, world.state.has_pairs, called) == (1, False, [])


# Gravity and damping


def test_fall_without_contacts_is_that_of_the_steps() -> None:
    """Velocity g t exactly; the place lags by g t dt / 2, for the step moves first."""
    run = simulate(Scene(one_body().bodies, gravity=(0, -10)), 1.0, solver="sequential")
    t = run.times
    np.testing.assert_allclose(run.velocities[:, 0, 1], -10 * t, atol=10 * ROUNDING)
    np.testing.assert_allclose(run.positions[:, 0, 1], -5 * t * (t - 1 / 60), atol=10 * ROUNDING)


@pytest.mark.parametrize("dt", [0.5, 1 / 60])
def test_speed_with_damping_falls_exponentially_whatever_the_step(dt: float) -> None:
    """The law v0 exp(-c t), for the spin too, is kept exactly by each step."""
    scene = Scene(one_body(velocity=(3, 0), angular_velocity=2).bodies, damping=0.7)
    run = simulate(scene, 2.0, dt=dt, solver="sequential")
    remaining = np.exp(-0.7 * run.times)
    np.testing.assert_allclose(run.velocities[:, 0, 0], 3 * remaining, rtol=ROUNDING)
    np.testing.assert_allclose(run.angular_velocities[:, 0], 2 * remaining, rtol=ROUNDING)


def test_static_bodies_know_no_gravity_and_no_damping() -> None:
    """A floor stays; a moving wall keeps its velocity."""
    wall = Body(Circle(1), position=(9, 9), velocity=(1, 0), angular_velocity=3)
    run = simulate(Scene([FLOOR, wall], gravity=(0, -10), damping=5), 1.0, solver="sequential")
    assert not run.positions[:, 0].any()
    assert (run.velocities[:, 1] == (1, 0)).all()
    assert (run.angular_velocities[:, 1] == 3).all()
    world = world_of(Scene([FLOOR], gravity=(0, -10)), 0.1, 1, Combination())
    accelerate(world)
    assert world.bodies[0].vy == 0


def test_ball_that_bounces_for_ever_keeps_its_energy() -> None:
    """With e = 1 the quantity v^2/2 + g y + v g dt/2 is kept in flight and in every bounce.

    It is the energy that belongs to these steps. It is kept because the bounce turns round the
    velocity that the ball had before this step's gravity.
    """
    ball = Body(Circle(0.5), mass=1, position=(0, 1.5), material=Material(1.0))
    scene = Scene([FLOOR, ball], gravity=(0, -10))
    run = simulate(scene, 60.0, dt=1 / 240, solver="sequential")
    v, y = run.velocities[:, 1, 1], run.positions[:, 1, 1]
    kept = v * v / 2 + 10 * y + v * 10 / 240 / 2
    assert len(run.contacts) > 60
    np.testing.assert_allclose(kept, kept[0], rtol=1e-12)


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

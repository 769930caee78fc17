"""Motion: bodies without contacts, their outlines, gravity and damping."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment, simulate
from lesson_code.engine.core import motion
from lesson_code.engine.core.motion import accelerate, move, turn_with_angle
from lesson_code.engine.core.tables import world_of

ROUNDING = 1e-13
"""m and m/s: sixty additions of numbers of about 1."""

FLOOR = Body(Segment((-50, 0), (50, 0)))


def one_body(**motion: Any) -> Scene:
    """Return a scene of one body that meets nobody."""
    return Scene([Body(Polygon.box(1, 2), mass=2.0, **motion)])


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
    world = world_of(one_body(angular_velocity=math.pi / 2), 1.0, 1, MixingRule())
    move(world)
    corners = [(corner.x, corner.y) for corner in world.corners]
    np.testing.assert_allclose(corners[2], (-1, 0.5), atol=ROUNDING)
    turned = [(-corner.local_ny, corner.local_nx) for corner in world.corners]
    np.testing.assert_allclose([(c.nx, c.ny) for c in world.corners], turned, atol=ROUNDING)


def test_outline_of_a_body_that_does_not_turn_is_never_computed_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A floor costs no sine."""
    world = world_of(Scene([FLOOR]), 0.1, 1, MixingRule())
    monkeypatch.setattr(motion, "turn_with_angle", lambda *_: pytest.fail("placed without a spin"))
    move(world)


def test_outline_at_a_large_angle_keeps_its_size() -> None:
    """After 159,155 turns: corners come from the angle each time, so that no error piles up."""
    world = world_of(one_body(), 0.1, 1, MixingRule())
    body = world.bodies[0]
    body.angle = 1e6
    turn_with_angle(world, body)
    sizes = [math.hypot(corner.x, corner.y) for corner in world.corners]
    assert sizes == pytest.approx([math.hypot(0.5, 1)] * 4, rel=ROUNDING)


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
    world = world_of(Scene([FLOOR], gravity=(0, -10)), 0.1, 1, MixingRule())
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

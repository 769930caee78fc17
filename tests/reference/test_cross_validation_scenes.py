"""Scenes with a known answer: ours against the closed form, and pymunk's figure beside it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from lesson_code import Run, Scene, simulate
from lesson_code.engine.core.constants import LEAST_EXCESS, SLOP
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.reference.impact_closed_forms import flat_landing, off_centre_hit
from lesson_code.reference.rigid_body_closed_forms import (
    friction_to_roll,
    roll_down,
    slide_down,
    slide_to_roll,
    stack_forces,
    tipping_angle,
    wedge_forces,
)

SOLVERS = ["sequential", "substep", "pymunk"]

ROUNDING = 1e-12
"""Hundreds of steps, each with some roundings of 1e-16 of numbers near 1."""

PYMUNKS_SLIDING = 1e-7
"""m/s: what pymunk's 10 sweeps leave of the coupling of two corners and friction; seen 2.3e-8."""

SINKING = 1e-2
"""m/s: while a body sinks into its slop, its contacts do not yet carry all of its weight."""

THIRTY_DEGREES = math.radians(30)


def speed_at_end(scene: Scene, duration: float, **settings: Any) -> float:
    """Return the speed of body 1 at the end."""
    run = simulate(scene, duration, sample="end", **settings)
    return float(np.hypot(*run.velocities[-1, 1]))


def forces(run: Run, body: int) -> Any:
    """Return the normal forces between a body and earlier ones in the last step, N."""
    events = run.contacts
    last = (events.time > run.times[-1] - 1 / 120) & (events.body_b == body)
    return events.normal_impulse[last] * 60


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("inertia_ratio", [1 / 2, 1.0], ids=["disc", "hoop"])
def test_sliding_body_ends_rolling_at_the_closed_forms_speed(
    inertia_ratio: float, solver: str
) -> None:
    """2/3 of the speed for a disc, 1/2 for a hoop, and nothing slips any more."""
    run = simulate(scenes.sliding_disc(6.0, 0.3, inertia_ratio), 4.0, solver=solver)
    velocity, spin = slide_to_roll(
        [1.0, 4.0], 6.0, 0.0, 1.0, inertia_ratio, friction=0.3, gravity=scenes.GRAVITY
    )
    assert velocity[1] == pytest.approx(6.0 / (1 + inertia_ratio))
    assert run.velocities[[60, 240], 1, 0] == pytest.approx(velocity, abs=ROUNDING)
    assert run.angular_velocities[[60, 240], 1] == pytest.approx(spin, abs=ROUNDING)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("friction", [0.0, 0.2, 0.4])
def test_box_slides_down_an_incline_with_the_closed_forms_acceleration(
    friction: float, solver: str
) -> None:
    """A = g (sin - mu cos) below mu = tan.

    With sub-steps and much friction the box rocks as its springs sink, before it has any speed.
    """
    expected = 2 * slide_down(THIRTY_DEGREES, friction, scenes.GRAVITY)
    scene = scenes.box_on_incline(THIRTY_DEGREES, friction)
    rocking = SINKING if friction > 0.3 else ROUNDING
    tolerance = {"pymunk": PYMUNKS_SLIDING, "substep": rocking}.get(solver, ROUNDING)
    assert speed_at_end(scene, 2.0, solver=solver) == pytest.approx(expected, abs=tolerance)


def test_box_stands_on_an_incline_where_friction_exceeds_its_tangent() -> None:
    """Around tan 30 = 0.57735: with 0.578 it stands, with 0.577 it creeps; pymunk's always does."""
    standing = scenes.box_on_incline(THIRTY_DEGREES, 0.578)
    sliding = scenes.box_on_incline(THIRTY_DEGREES, 0.577)
    assert speed_at_end(standing, 2.0) <= ROUNDING
    assert speed_at_end(standing, 2.0, solver="pymunk") > 1e-4
    exact = 2 * slide_down(THIRTY_DEGREES, 0.577, scenes.GRAVITY)
    assert speed_at_end(sliding, 2.0) == pytest.approx(exact, abs=SINKING)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("share", [0.5, 0.9, 1.1, 2.0])
def test_disc_rolls_or_slips_down_an_incline(share: float, solver: str) -> None:
    """It rolls from mu = tan/3 on; below that its rim slips. Both have closed forms."""
    angle = math.radians(20)
    friction = share * friction_to_roll(angle, 0.5)
    run = simulate(scenes.disc_on_incline(angle, friction), 1.0, solver=solver)
    centre, rim = roll_down(angle, 0.5, friction, scenes.GRAVITY)
    assert np.hypot(*run.velocities[-1, 1]) == pytest.approx(centre, abs=1e-11)
    assert abs(run.angular_velocities[-1, 1]) == pytest.approx(rim, abs=1e-11)


@pytest.mark.parametrize(("offset", "falls"), [(-0.02, False), (0.02, True)])
def test_tall_box_tips_at_the_closed_forms_angle(offset: float, falls: bool) -> None:
    """atan(1/2) = 26.565 degrees for a box twice as tall as wide, found within 0.02 degrees."""
    angle = tipping_angle(1.0, 2.0) + math.radians(offset)
    run = simulate(
        scenes.box_on_incline(angle, 2.0, 1.0, 2.0),
        8.0,
        iterations=50,
        sample="end",
        solver="sequential",
    )
    assert bool(run.angles[-1, 1] - angle > 0.5) is falls


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("degrees", [(45, 45), (30, 60), (20, 40)])
def test_walls_of_a_wedge_carry_the_disc_between_them(
    degrees: tuple[int, int], solver: str
) -> None:
    """Both forces are those of three forces in balance."""
    left, right = (math.radians(angle) for angle in degrees)
    run = simulate(scenes.disc_in_wedge(left, right), 5.0, solver=solver)
    expected = wedge_forces(scenes.GRAVITY, left, right)
    assert forces(run, body=2) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("arm", [0.0, 0.5, 1.5])
def test_ball_off_the_middle_of_a_plank_turns_it(arm: float, solver: str) -> None:
    """Momentum, angular momentum and restitution give all three velocities; none is sideways."""
    run = simulate(scenes.ball_on_plank(arm), 0.5, solver=solver, sample="end")
    plank = scenes.ball_on_plank(arm).bodies[0]
    assert plank.mass is not None
    assert plank.inertia is not None
    ball, body, turning = off_centre_hit(1.0, -2.0, plank.mass, plank.inertia, arm, 1.0)
    assert run.velocities[-1, 1] == pytest.approx([0, ball], abs=ROUNDING)
    assert run.velocities[-1, 0] == pytest.approx([0, body], abs=ROUNDING)
    assert run.angular_velocities[-1, 0] == pytest.approx(turning, abs=ROUNDING)


def test_naive_solver_pushes_the_ball_off_the_plank_sideways() -> None:
    """From centre to centre: the ball gains a velocity along the plank, and nothing turns."""
    run = simulate(scenes.ball_on_plank(1.5), 0.5, solver="naive", sample="end")
    assert run.velocities[-1, 1, 0] > 0.3
    assert run.angular_velocities[-1, 0] == 0


@pytest.mark.parametrize(("width", "height"), [(1, 1), (10, 1), (1, 4), (1, 10)])
def test_box_that_lands_flat_leaves_flat(width: float, height: float) -> None:
    """Both corners are solved together: exact after one sweep, where pymunk's 10 leave a turn."""
    scene = scenes.box_landing_flat(width, height, 1.0, 0.5)
    ours = simulate(scene, 1 / 60, iterations=1, sample="end", solver="sequential")
    expected = flat_landing(width, height, 1.0, 0.5)
    assert ours.velocities[-1, 1, 1] == pytest.approx(expected[0], abs=ROUNDING)
    assert ours.angular_velocities[-1, 1] == pytest.approx(expected[1], abs=ROUNDING)


def test_pymunk_leaves_a_tall_box_turning_after_a_flat_landing() -> None:
    """10 sweeps of a 1 x 10 box: the error that the rate of convergence predicts, some percent."""
    scene = scenes.box_landing_flat(1, 10, 1.0, 0.5)
    theirs = simulate(scene, 1 / 60, solver="pymunk", sample="end")
    exact = flat_landing(1, 10, 1.0, 0.5)[0]
    predicted = flat_landing(1, 10, 1.0, 0.5, sweeps=10)[0]
    assert theirs.velocities[-1, 1, 1] == pytest.approx(predicted, rel=1e-6)
    assert abs(theirs.velocities[-1, 1, 1] - exact) > 1e-2


@pytest.mark.full
def test_stack_of_ten_boxes_stands_for_a_minute_without_drift() -> None:
    """Each box sinks by its slop and stays; none moves sideways. pymunk's stack has fallen.

    Sinks into the one below, that is; by a hundredth of the slop more where it began deeper.
    """
    run = simulate(scenes.box_stack(10), 60.0, sample="end", solver="sequential")
    moved = run.positions[-1, 1:] - run.positions[0, 1:]
    assert np.abs(moved[:, 0]).max() <= ROUNDING
    sunk = -np.diff(moved[:, 1], prepend=0.0)
    assert sunk.min() >= SLOP - ROUNDING
    assert sunk.max() <= SLOP * (1 + LEAST_EXCESS) + ROUNDING
    assert np.abs(run.velocities[-1]).max() <= ROUNDING
    theirs = simulate(scenes.box_stack(10), 60.0, solver="pymunk", sample="end")
    assert theirs.positions[-1, 10, 1] < 2.0


def test_contacts_of_a_stack_carry_what_is_above_them() -> None:
    """Under box n of ten: the weight of ten less n boxes."""
    run = simulate(scenes.box_stack(10), 10.0, solver="sequential")
    carried = [forces(run, body).sum() for body in range(1, 11)]
    assert carried == pytest.approx(stack_forces(np.ones(10), scenes.GRAVITY), rel=1e-9)


@pytest.mark.full
def test_pyramid_of_ten_rows_stays_still() -> None:
    """55 boxes settle within 10 s, and then none moves by a nanometre in 5 s more."""
    run = simulate(scenes.box_pyramid(10), 15.0, sample=np.array([10.0, 15.0]), solver="sequential")
    assert np.abs(run.positions[1] - run.positions[0]).max() <= 1e-9
    assert np.abs(run.velocities[1]).max() <= 1e-9


def test_jitter_of_a_disturbed_stack_dies_away() -> None:
    """Five boxes out of line, the top one moving: what is left after 10 s goes on dying."""
    stack = scenes.box_stack(5)
    ground, *boxes = stack.bodies
    shifted = [
        replace(box, position=(0.02 * (-1) ** n, box.position[1]), velocity=(0.1 * (n == 4), 0))
        for n, box in enumerate(boxes)
    ]
    scene = Scene([ground, *shifted], gravity=stack.gravity)
    run = simulate(scene, 20.0, sample=np.arange(0.0, 21.0), solver="sequential")
    speeds = np.abs(run.velocities[:, 1:]).max(axis=(1, 2))
    assert speeds[1] > 1e-3 > 1e-4 > speeds[10]
    assert speeds[20] < speeds[10] / 100

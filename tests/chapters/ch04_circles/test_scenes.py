"""The table full of balls: how it starts, and what the engine makes of it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lesson_code import simulate
from lesson_code.chapters.ch04_circles.scenes import balls_on_table, scattered_balls
from lesson_code.evidence.scenes.discs import CUSHIONS

ROUNDING = 1e-12
"""Of a speed or an energy of 1 to 10, over some hundred impacts of 1e-16 each."""

FINE = {"duration": 3.0, "dt": 1 / 240, "iterations": 30}


def test_scattered_balls_move_at_one_speed_and_the_seed_decides_where_to() -> None:
    """The same seed gives the same scene, another one another."""
    scene = scattered_balls(1.0, speed=3.0)
    assert scene == scattered_balls(1.0, speed=3.0)
    assert scene != scattered_balls(1.0, speed=3.0, seed=5)
    speeds = [math.hypot(*ball.velocity) for ball in scene.bodies[CUSHIONS:]]
    assert speeds == pytest.approx([3.0] * 32)


def test_table_without_loss_keeps_its_energy() -> None:
    """All the hits of three seconds leave it as it was, and all balls on the table."""
    run = simulate(scattered_balls(1.0), **FINE)
    energy = run.kinetic_energy / run.kinetic_energy[0]
    assert np.max(np.abs(energy - 1)) <= ROUNDING
    assert set(balls_on_table(run)) == {32}


def test_table_with_loss_never_gains_energy_and_ends_like_pymunks() -> None:
    """Energy falls with every hit; no order of impulses is left in what remains after 3 s."""
    run, other = (
        simulate(scattered_balls(0.8), solver=solver, **FINE) for solver in ("sequential", "pymunk")
    )
    assert np.all(np.diff(run.kinetic_energy) <= ROUNDING * run.kinetic_energy[0])
    assert set(balls_on_table(run)) == {32}
    assert run.kinetic_energy[-1] == pytest.approx(other.kinetic_energy[-1], rel=0.05)


def test_balls_leave_the_table_of_the_first_attempt() -> None:
    """A cushion's normal is not the line to its middle."""
    run = simulate(scattered_balls(1.0), solver="naive", **FINE)
    assert balls_on_table(run)[0] == 32
    assert balls_on_table(run)[-1] <= 3

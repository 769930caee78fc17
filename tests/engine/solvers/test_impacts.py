"""Impacts before the sub-steps: as much bounce as Newton says, but never a gain of energy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.evidence.hard_cases.collisions import rush
from lesson_code.evidence.hard_cases.parameters import Draw, seeded


@pytest.mark.parametrize("seed", range(share(30)))
def test_rough_impacts_of_a_crowd_never_gain_energy(seed: int) -> None:
    """Not in any step; by Newton's rule alone a crowd of 300 has gained 2.6 times what it had."""
    draw = Draw(seeded("rough", seed))
    run = simulate(rush(draw, draw.integer("count", 6, 60)), 3.0, solver="substep")
    energies = run.kinetic_energy
    assert (np.diff(energies) <= 1e-9 * energies[0]).all()


def test_bounce_that_gains_nothing_is_as_newton_says() -> None:
    """Whole where friction leaves energy enough; a mover's work on a body is no gain of its own."""
    ball = Body(Circle(1), mass=1, position=(0, 1), velocity=(2, -3), material=Material(1.0, 0.3))
    floor = Body(Segment((-9, 0), (9, 0)), velocity=(0, 2), material=Material(1.0, 0.3))
    run = simulate(Scene([ball, floor]), 1 / 30, solver="substep")
    assert run.velocities[-1, 0, 1] == pytest.approx(2 + 5, abs=1e-12)
    assert run.velocities[-1, 0, 0] == pytest.approx(2 - min(0.3 * 10, 2 / 3), abs=1e-12)


def test_rod_that_would_gain_by_newtons_rule_keeps_its_energy() -> None:
    """Of its bounce it gets as much as is paid for, and momentum along the floor is friction's."""
    surface = Material(0.9, 1.0)
    gains = []
    for solver in ("sequential", "substep"):
        worst = 0.0
        for angle in np.linspace(0.1, 1.5, 15):
            rod = Body(
                Polygon.box(2, 0.05), mass=1, angle=angle, velocity=(3, -3), material=surface,
                position=(0, 1.02 * math.sin(angle) + 0.03),
            )  # fmt: skip
            floor = Body(Segment((-9, 0), (9, 0)), material=surface)
            run = simulate(Scene([rod, floor]), 0.3, solver=solver)
            worst = max(worst, float(run.kinetic_energy.max() / run.kinetic_energy[0]) - 1)
        gains.append(worst)
    assert gains[0] > 0.02
    assert gains[1] <= 1e-11

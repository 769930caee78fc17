"""The gas of hard discs presses and collides as is known of gases."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code import simulate
from lesson_code.chapters.ch07_time_of_impact.scenes import in_the_middle
from lesson_code.evidence.scenes import gas as disc_gas
from lesson_code.reference.event_closed_forms import (
    hard_disc_collision_rate,
    hard_disc_compressibility,
)

ROUNDING = 1e-12
"""Of sums of 64 numbers of size 1."""

NOISE = 0.02
"""Of the pressure: ten seeds gave 0.6 % at the most."""

RATE_NOISE = 0.045
"""Some 5,000 collisions are counted, each with chance: one part in seventy. Three times that."""


@pytest.mark.parametrize(("covered", "duration"), [(0.15, 150.0), (0.25, 100.0)])
def test_gas_presses_and_collides_as_henderson_and_enskog_say(
    covered: float, duration: float
) -> None:
    """Measured in the middle of a box with 144 discs."""
    scene = disc_gas.disc_gas(12, covered, seed=1)
    run = simulate(scene, duration, solver="exact", sample=np.arange(0, duration, 0.25))
    measured = in_the_middle(run, since=4.0)
    z = hard_disc_compressibility(measured.covered)
    rate = hard_disc_collision_rate(measured.covered, 1.0, 1.0, 1.0)
    assert measured.compressibility == pytest.approx(z, rel=NOISE)
    assert measured.collision_rate == pytest.approx(rate, rel=RATE_NOISE)
    assert run.kinetic_energy[-1] == pytest.approx(run.kinetic_energy[0], rel=ROUNDING)


def test_in_the_middle_refuses_a_box_without_one() -> None:
    """Nine discs fill a box that is all margin."""
    run = simulate(disc_gas.disc_gas(3, 0.5, seed=1), 0.1, solver="exact")
    with pytest.raises(ValueError, match=r"wider than 7\.0 diameters"):
        in_the_middle(run)

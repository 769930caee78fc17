"""The gas of hard discs: how it starts, and that it presses and collides as is known of gases."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lesson_code import Run, Scene, simulate
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.evidence.scenes import gas as disc_gas

ROUNDING = 1e-12
"""Of sums of 64 numbers of size 1."""

RETURNS = 1e-9
"""m: rounding of 1e-16 in a collision, doubled in each of nine further ones, for 64 discs."""


def test_gas_starts_in_rows_without_momentum_and_with_its_energy() -> None:
    """64 discs that cover 30 % of a square box; none touches another or a wall."""
    scene = disc_gas.disc_gas(8, covered=0.3, seed=3)
    discs = scene.bodies[exact_scenes.WALLS :]
    places = np.array([disc.position for disc in discs])
    v = np.array([disc.velocity for disc in discs])
    length = max(y for _, y in scene.bodies[1].shape.outline)
    assert 64 * math.pi / 4 / length**2 == pytest.approx(0.3, abs=ROUNDING)
    assert v.sum(axis=0) == pytest.approx([0, 0], abs=ROUNDING)
    assert (v * v).sum() / 2 == pytest.approx(64 * disc_gas.ENERGY, abs=64 * ROUNDING)
    assert places.min() > disc_gas.DIAMETER / 2
    assert places.max() < length - disc_gas.DIAMETER / 2
    run = simulate(scene, 0.0, solver="sequential")
    assert run.max_penetration[0] == 0


def test_gas_is_another_one_for_another_seed_only() -> None:
    """The same seed draws the same velocities."""
    one, same, other = (disc_gas.disc_gas(3, 0.3, seed=seed).bodies[-1] for seed in (1, 1, 2))
    assert one.velocity == same.velocity != other.velocity
    assert one.position == other.position


@pytest.mark.parametrize(("side", "covered"), [(1, 0.3), (8, 0.79), (8, math.nan), (8, 0.0)])
def test_gas_refuses_what_does_not_fit(side: int, covered: float) -> None:
    """Rows and columns of touching discs cover pi/4."""
    with pytest.raises(ValueError, match="covered must be"):
        disc_gas.disc_gas(side, covered, seed=1)


def test_hits_a_disc_counts_each_collision_for_both() -> None:
    """Walls do not count."""
    run = simulate(disc_gas.disc_gas(2, 0.3, seed=1), 5.0, solver="exact", sample="end")
    between = [a for a in run.contacts.body_a if a >= exact_scenes.WALLS]
    assert 0 < len(between) < len(run.contacts)
    assert disc_gas.hits_a_disc(run) == 2 * len(between) / 4


def test_gas_that_is_turned_back_returns_to_its_rows() -> None:
    """After less than nine collisions of each disc; after forty nothing is left of them."""
    scene = disc_gas.disc_gas(8, covered=0.5, seed=1)
    out, back = there_and_back(scene, 1.2)
    assert 5 < disc_gas.hits_a_disc(out) < 9
    assert exact_scenes.error_after_return(out, back) < RETURNS
    out, back = there_and_back(scene, 6.0)
    assert disc_gas.hits_a_disc(out) > 40
    assert exact_scenes.error_after_return(out, back) > 1e-3


def there_and_back(scene: Scene, duration: float) -> tuple[Run, Run]:
    """Return a run and its way back."""
    out = simulate(scene, duration, solver="exact", sample="end")
    turned = exact_scenes.turned_back(out)
    return out, simulate(turned, duration, solver="exact", sample="end")

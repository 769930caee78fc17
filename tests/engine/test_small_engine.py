"""The small engine: its hits are those of the workbook's engine, and it says what it cannot do."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.callbacks import Callbacks
from lesson_code.engine.small_engine import geometric_mean, of_pair, random_hits, simulate_small
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.evidence.scenes.spinning_discs import random_impacts, scene_of

ROUNDING = 1e-12
"""A few dozen operations on numbers of order 10."""

OF_THE_SPEED = 1e-12
"""Masses differ a million times, and a light disc is as fast as its heavy partner makes it."""


def test_hits_of_discs_and_boxes_are_those_of_the_engine() -> None:
    """All velocities after the first contact, for shapes, spins and coefficients at random."""
    for scene in random_hits(20, seed=3):
        right = simulate(scene, 0.2, solver="sequential", iterations=1)
        frame = int(np.searchsorted(right.times, right.contacts.time[0]))
        small = simulate_small(scene, 0.2)
        for field in ("velocities", "angular_velocities"):
            found, expected = getattr(small, field)[frame], getattr(right, field)[frame]
            np.testing.assert_allclose(found, expected, atol=ROUNDING)


def test_hits_of_discs_are_those_of_chapter_05() -> None:
    """Discs with spin and friction, masses apart by up to a million."""
    for a, b, e, mu in random_impacts(20, seed=3):
        scene = scene_of(a, b, e, mu)
        right = simulate(scene, 1e-9, solver="pymunk", dt=1e-9, sample="end")
        small = simulate_small(scene, 1e-9, dt=1e-9, sample="end")
        apart = np.abs(small.velocities[-1] - right.velocities[-1]).max()
        assert apart <= OF_THE_SPEED * max(a.fastest, b.fastest)


def test_room_without_friction_keeps_energy_and_momentum_of_a_pair() -> None:
    """Elastic discs: what is kept is kept to rounding over many steps."""
    surface = Material(1.0, 0.0)
    discs = [
        Body(Circle(0.5), mass=1.0 + n, position=(3.0 * n, 0.2 * n), velocity=(1 - n, 0),
             material=surface)
        for n in range(3)
    ]  # fmt: skip
    run = simulate_small(Scene(discs), 3.0)
    assert run.velocities[-1, 0, 0] < 1
    np.testing.assert_allclose(run.momentum - run.momentum[0], 0, atol=ROUNDING)
    np.testing.assert_allclose(run.kinetic_energy, run.kinetic_energy[0], atol=ROUNDING)


def test_box_at_rest_rests() -> None:
    """One box on a floor: the two points of its edge together turn it by nothing one can see."""
    run = simulate_small(scenes.box_stack(1), 2.0)
    assert np.abs(run.positions[-1, 1] - (0, 0.5)).max() < 0.01
    assert abs(run.angles[-1, 1]) < 0.01


def test_separation_shares_by_inverse_mass() -> None:
    """Two that overlap at rest by 0.1 m: 3 kg moves by 0.025 m, 1 kg by 0.075 m."""
    pair = [Body(Circle(0.5), mass=3.0), Body(Circle(0.5), mass=1.0, position=(0.9, 0))]
    run = simulate_small(Scene(pair), 1 / 60, sample="end")
    np.testing.assert_allclose(run.positions[-1, :, 0], [-0.025, 0.975], atol=ROUNDING)


def test_static_bodies_neither_move_nor_fall() -> None:
    """A floor and a wall that overlap stay where they are, with gravity."""
    floor = Body(Segment((-1, 0), (1, 0)))
    wall = Body(Polygon.box(1, 1), position=(0, 0.2))
    run = simulate_small(Scene([floor, wall], gravity=(0, -10)), 0.1, sample="end")
    assert run.positions[-1].tolist() == [[0, 0], [0, 0.2]]


@pytest.mark.parametrize(
    ("one", "other", "value"),
    [(0.4, 0.9, 0.6), (0.4, None, 0.4), (None, 0.9, 0.9), (None, None, 0)],
)
def test_pair_of_bodies_leaves_to_the_other_what_one_does_not_name(
    one: float | None, other: float | None, value: float
) -> None:
    """As in the workbook's engine."""
    assert of_pair(geometric_mean, one, other) == pytest.approx(value, abs=ROUNDING)


def test_damping_and_callbacks_are_refused() -> None:
    """Nothing is left out without a word."""
    disc = Body(Circle(1), mass=1.0)
    for scene in (Scene([disc], damping=0.1), Scene([disc], callbacks=Callbacks(begin=print))):
        with pytest.raises(ValueError, match="no damping and no callbacks"):
            simulate_small(scene, 1.0)
    with pytest.raises(ValueError, match="dt must be > 0"):
        simulate_small(Scene([disc]), 1.0, dt=0.0)

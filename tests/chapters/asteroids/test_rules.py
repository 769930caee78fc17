"""The rules of the asteroid field: laws, limits and answers from elsewhere."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest

from lesson_code.chapters.asteroids.rules import collide_all, fire, split, wrap

ROUNDING = 1e-12
"""Relative: sums of a few dozen numbers of like size."""


def test_split_keeps_momentum_and_flies_apart() -> None:
    """Whatever the masses: the sum is the asteroid's, the differences are as asked for."""
    masses = np.array([1.0, 2.5, 4.0])
    pieces = split((0.3, -0.7), masses, 2.0, 0.4)
    assert masses @ pieces == pytest.approx(masses.sum() * np.array([0.3, -0.7]), rel=ROUNDING)
    sides = [math.dist(pieces[k], pieces[k - 1]) for k in range(3)]
    assert sides == pytest.approx([2 * math.sqrt(3)] * 3, rel=ROUNDING)


def test_fire_keeps_momentum_and_the_muzzle_speed() -> None:
    """Ship and shot together as before; apart at the muzzle speed."""
    ship, shot = fire((1.0, 2.0), 5.0, 0.4, 7.0, 2.0)
    assert 5.0 * ship + 0.4 * shot == pytest.approx([5.4, 10.8], rel=ROUNDING)
    assert shot - ship == pytest.approx([7 * math.cos(2), 7 * math.sin(2)], rel=ROUNDING)


def test_collide_all_keeps_momentum_and_the_energy_of_elastic_bodies() -> None:
    """Nine in a crowd."""
    stream = Random(3)  # noqa: S311 - a test
    places = [(1.4 * (k % 3), 1.4 * (k // 3)) for k in range(9)]
    before = np.array([[stream.uniform(-3, 3) for _ in range(2)] for _ in range(9)])
    masses = np.array([stream.uniform(0.5, 5) for _ in range(9)])
    after = collide_all(places, before, masses, [0.8] * 9, 1.0)
    assert (after != before).any()
    assert masses @ after == pytest.approx(masses @ before, rel=1e-11)
    energies = [masses @ (v**2).sum(axis=1) for v in (before, after)]
    assert energies[1] == pytest.approx(energies[0], rel=ROUNDING)


def test_wrap_joins_the_edges() -> None:
    """Inside nothing changes; outside the other side is meant."""
    assert wrap((3.0, 2.0), (8.0, 6.0), 0.5) == (3.0, 2.0)
    assert wrap((-0.4, 6.4), (8.0, 6.0), 0.5) == (-0.4, 6.4)  # a part of it is still seen
    assert wrap((-0.6, 6.6), (8.0, 6.0), 0.5) == (8.5, -0.5)

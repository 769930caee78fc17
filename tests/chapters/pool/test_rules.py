"""The rules of pool: laws, limits and answers that do not come from their own lines."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lesson_code.chapters.cradle.rules import GRAVITY
from lesson_code.chapters.pool.rules import ROLLING, rack, roll, share_impact, strike

ROUNDING = 1e-12
"""Relative: sums of a few dozen numbers of like size."""


def test_rack_neighbours_are_a_diameter_and_a_gap_apart() -> None:
    """In a triangle of five rows 30 pairs touch, and all others are farther apart."""
    places = rack((1.0, 2.0), 0.5, 0.1)
    distances = sorted(math.dist(p, q) for k, p in enumerate(places) for q in places[:k])
    assert distances[:30] == pytest.approx([1.1] * 30, rel=ROUNDING)
    assert distances[30] > 1.5


def test_strike_keeps_momentum_and_angular_momentum() -> None:
    """M v is the impulse, and I w its moment about the centre."""
    velocity, spin = strike((0.3, 0.4), 0.01, 0.17, 0.03)
    assert np.array(velocity) * 0.17 == pytest.approx([0.3, 0.4], rel=ROUNDING)
    arm = 0.01 * np.array([-0.8, 0.6])  # to the left of (0.6, 0.8)
    moment = arm[0] * 0.4 - arm[1] * 0.3
    assert 0.4 * 0.17 * 0.03**2 * spin == pytest.approx(moment, rel=ROUNDING)


def test_roll_stops_after_the_way_that_friction_leaves() -> None:
    """A ball of 1 m/s rolls v^2 / (2 mu g) far, to within the way of one step, and then lies."""
    velocity, way, dt = (1.0, 0.0), 0.0, 1e-3
    for _ in range(20_000):
        velocity, _ = roll(velocity, 0.0, 0.03, dt)
        way += velocity[0] * dt
    assert velocity == (0.0, 0.0)
    assert way == pytest.approx(1 / (2 * ROLLING * GRAVITY), abs=dt)


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_share_impact_keeps_momentum_and_never_gains_energy(restitution: float) -> None:
    """A ball comes into a rack at an angle."""
    places = [(-0.06, 0.0), *rack((0.0, 0.0), 0.03, 0.0)]
    before = np.zeros((16, 2))
    before[0] = (3.0, 1.0)
    after = share_impact(places, before, 0.03, restitution)
    assert after.sum(axis=0) == pytest.approx([3.0, 1.0], rel=ROUNDING)
    assert (after**2).sum() <= 10.0


def test_share_impact_of_balls_that_do_not_touch_changes_nothing() -> None:
    """A gap of a hundredth of a radius is no contact."""
    before = np.array([[1.0, 0.0], [0.0, 0.0]])
    assert (share_impact([(0, 0), (2.01, 0)], before, 1.0, 1.0) == before).all()

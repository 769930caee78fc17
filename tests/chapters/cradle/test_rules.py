"""The rules of Newton's cradle: laws, limits and answers that do not come from their own lines."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from lesson_code.chapters.cradle.rules import GRAVITY, collide_row, cradle, swing_step

ROUNDING = 1e-12
"""Relative: sums of a few dozen numbers of like size."""


@pytest.mark.parametrize("count", [1, 3, 7])
def test_collide_row_k_balls_in_k_balls_out(count: int) -> None:
    """Equal, elastic balls: as many leave as came in, at their speed."""
    for k in range(1, count + 1):
        speeds = [2.0] * k + [0.0] * (count - k)
        assert collide_row([1.5] * count, speeds, 1.0) == speeds[::-1]


def test_collide_row_keeps_momentum_and_ends_in_order() -> None:
    """Unequal masses with losses: afterwards nothing approaches."""
    masses, before = [1.0, 3.0, 0.5, 2.0], [4.0, 1.0, 0.0, -2.0]
    after = collide_row(masses, before, 0.8)
    assert np.dot(masses, after) == pytest.approx(np.dot(masses, before), rel=ROUNDING)
    assert all(left <= right + 1e-12 for left, right in pairwise(after))


def test_swing_step_small_swings_have_the_period_of_the_pendulum() -> None:
    """After 2 pi sqrt(l/g), in steps of a 10,000th of it, the ball is where it was."""
    length, start = 2.0, 1e-3
    period = 2 * math.pi * math.sqrt(length / GRAVITY)
    state = (start, 0.0)
    for _ in range(10_000):
        state = swing_step(*state, length, period / 10_000)
    assert state[0] == pytest.approx(start, rel=1e-6)


@pytest.mark.parametrize("pulled", [1, 2, 3, 4])
def test_cradle_k_balls_in_k_balls_out(pulled: int) -> None:
    """Half a period later, and half a period after that, just so many are out on that side."""
    out = 0.4
    angles = [-out] * pulled + [0.0] * (5 - pulled)
    half = math.pi * math.sqrt(1.0 / GRAVITY) * (1 + out**2 / 16)  # for swings of this size
    for side, steps in ((1, round(half * 2000)), (-1, round(2 * half * 2000))):
        found, _ = cradle(angles, [0.0] * 5, 1.0, 1 / 2000, steps)
        assert sum(side * angle > 0.9 * out for angle in found) == pulled
        assert sum(abs(angle) < 0.1 * out for angle in found) == 5 - pulled

"""Random polygons are what they are said to be."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code.chapters.ch06_sat_and_manifolds.scenes import random_polygon


@pytest.mark.parametrize("seed", range(30))
def test_random_polygon_is_convex_counter_clockwise_and_within_reach(seed: int) -> None:
    """Every corner turns to the left; none is farther than 1 m from the ellipse's middle."""
    v = random_polygon(np.random.default_rng(seed), reach=2.0)
    edges = np.roll(v, -1, axis=0) - v
    following = np.roll(edges, -1, axis=0)
    turns = edges[:, 0] * following[:, 1] - edges[:, 1] * following[:, 0]
    assert 3 <= len(v) <= 8
    assert turns.min() > 0
    assert np.abs(v).max() <= 3.0


def test_random_polygon_a_seed_gives_the_same_again() -> None:
    """The same stream of numbers makes the same corners."""
    first, again = (random_polygon(np.random.default_rng(seed=5)) for _ in range(2))
    assert first.tolist() == again.tolist()

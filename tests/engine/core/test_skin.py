"""Skins: where the one point is at which two bodies act on each other."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code import simulate
from lesson_code.evidence.scenes.spinning_discs import Disc, difference, hit, scene_of

AT_ONCE = 1e-12
"""s: in it the discs move by a millionth of their overlap."""


@pytest.mark.parametrize("radius", [1e-3, 1.0, 1e3])
def test_overlap_shortens_both_arms_of_two_discs_by_the_same_share(radius: float) -> None:
    """A spinning disc hits one of any other size: their impulses are those of discs that touch."""
    share = 1e-6
    a = Disc(2.0, 1.0, np.zeros(2), np.array([1.0, 0.5]), 1.0)
    b = Disc(3.0, radius, np.array([(1 + radius) * (1 - share), 0.0]), np.zeros(2), 2.0 / radius)
    expected = hit(a, b, np.array([1.0, 0.0]), 0.5, 0.3)
    run = simulate(scene_of(a, b, 0.5, 0.3), AT_ONCE, solver="direct", dt=AT_ONCE)
    assert difference(expected, run) < 2 * share

"""Boxes on their corners: the closed form as the scene has it, and what sweeps leave of it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lesson_code.evidence.scenes import corner_impacts
from lesson_code.evidence.scenes.corner_impacts import corner_impact, random_corners
from lesson_code.geometry import collide

CONVERGED = 1e-12
"""Of the largest velocity: what 1,000 sweeps leave where the coupling is below 0.9, measured
2e-14, for rounding."""

ROUNDING = 1e-12
"""m/s or rad/s: some tens of operations on numbers near 1."""


def test_corner_impact_without_friction_is_worked_by_hand() -> None:
    """A smooth rod-like box: jn = (1 + e) v / (1 + x^2 m/I) at the arm x, and w = x jn / I."""
    impact = corner_impact(2.0, 1.0, 0.3, (0.5, -2.0), 0.0, restitution=0.5, friction=0.0)
    inertia = (2.0**2 + 1.0**2) / 12
    x = -1.0 * math.cos(0.3) + 0.5 * math.sin(0.3)  # turned by +0.3, the left one is the lowest
    jn = 1.5 * 2.0 / (1 + x**2 / inertia)
    assert impact.expected == pytest.approx([0.5, -2.0 + jn, x * jn / inertia], abs=ROUNDING)
    assert impact.coupling == 0.0


def test_corner_impact_meets_the_floor_in_one_point() -> None:
    """After the engine's first move, one corner is in the floor, by the overlap."""
    for impact in random_corners(20, seed=1):
        floor, box = impact.scene.bodies
        x, y = np.add(box.position, np.multiply(box.velocity, corner_impacts.STEP))
        angle = box.angle + box.angular_velocity * corner_impacts.STEP
        manifold = collide(floor.shape, (0, 0, 0), box.shape, (x, y, angle))
        assert manifold is not None
        smaller = np.ptp(np.array(box.shape.outline), axis=0).min()
        assert manifold.penetrations == pytest.approx([corner_impacts.OVERLAP * smaller], rel=1e-6)


def test_random_corners_are_as_many_as_asked_for_and_the_same_again() -> None:
    """A seed gives the same corners, another one others; both kinds of end occur."""
    first, again, other = (list(random_corners(30, seed)) for seed in (1, 1, 2))
    assert [i.expected.tolist() for i in first] == [i.expected.tolist() for i in again]
    assert [i.expected.tolist() for i in first] != [i.expected.tolist() for i in other]
    assert {impact.kind for impact in first} == {"sticks", "slides"}
    assert max(impact.coupling for impact in first) < corner_impacts.STRONGEST


@pytest.mark.parametrize("solver", ["sequential", "pymunk"])
def test_error_after_many_sweeps_is_rounding(solver: str) -> None:
    """Both engines come to the closed form; after ten sweeps pymunk is still percents away."""
    corners = list(random_corners(60, seed=1))
    assert max(corner_impacts.error(i, solver, 1_000) for i in corners) <= CONVERGED
    assert max(corner_impacts.error(i, "pymunk", 10) for i in corners) > 0.01

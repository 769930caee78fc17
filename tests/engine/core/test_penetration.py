"""How deep bodies stand in each other, in states that any solver left behind."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.penetration import deepest_overlaps

ROUNDING = 1e-14
"""m: a difference of numbers of about 1."""

DISCS = Scene([Body(Circle(0.5), mass=1), Body(Circle(1), mass=1)])


def depths(scene: Scene, *frames: list[tuple[float, float, float]]) -> Any:
    """Return the deepest overlap in each frame; a frame is x, y, angle of each body."""
    states = np.array(frames)
    return deepest_overlaps(scene, states[:, :, :2], states[:, :, 2])


def test_depth_of_two_discs_worked_by_hand_is_found() -> None:
    """The radii less the distance, frame by frame: apart, touching, 3-4-5, coincident."""
    ways = [(2, 0), (1.5, 0), (0.6, 0.8), (0, 0)]
    measured = depths(DISCS, *[[(0, 0, 0), (x, y, 0)] for x, y in ways])
    np.testing.assert_allclose(measured, [0, 0, 0.5, 1.5], atol=ROUNDING)


def test_depth_of_a_turned_box_is_that_of_its_corner() -> None:
    """A square of 2 m at a height of 1.2 m clears the floor; on edge it reaches 2**0.5 down."""
    scene = Scene([Body(Segment((-9, 0), (9, 0))), Body(Polygon.box(2, 2), mass=1)])
    measured = depths(
        scene, [(0, 0, 0), (0, 1.2, 0)], [(0, 0, 0), (0, 1.2, np.pi / 4)], [(0, 0, 0), (0, 0.9, 0)]
    )
    np.testing.assert_allclose(measured, [0, 2**0.5 - 1.2, 0.1], atol=ROUNDING)


def test_depth_of_many_bodies_is_the_largest() -> None:
    """Thirty discs, of which two pairs overlap, by 0.1 m and by 0.3 m: found by the grid too."""
    scene = Scene([Body(Circle(0.5), mass=1) for _ in range(30)])
    row = [(2.0 * k, 0.0, 0.0) for k in range(30)]
    row[5], row[20] = (2.0 * 4 + 0.9, 0, 0), (2.0 * 19 + 0.7, 0, 0)
    assert depths(scene, row) == pytest.approx([0.3])


def test_depth_of_two_static_bodies_does_not_count() -> None:
    """Walls may cross; a body in the crossing counts."""
    walls = [Body(Circle(1)), Body(Circle(1))]
    assert depths(Scene(walls), [(0, 0, 0), (0.5, 0, 0)]).tolist() == [0.0]
    trapped = Scene([*walls, Body(Circle(1), mass=1)])
    measured = depths(trapped, [(0, 0, 0), (0.5, 0, 0), (1.75, 0, 0)])
    np.testing.assert_allclose(measured, [0.75], atol=ROUNDING)


def test_depth_does_not_depend_on_the_solver() -> None:
    """Measured on the states: the same places, the same depths."""
    scene = Scene(
        [Body(Circle(0.5), mass=1, velocity=(1, 0)), Body(Circle(0.5), mass=1, position=(3, 0))]
    )
    runs = [simulate(scene, 1.0, solver=solver) for solver in ("sequential", "naive", "pymunk")]
    assert [run.max_penetration.tolist() for run in runs] == [[0.0] * 61] * 3


def test_depth_of_an_empty_scene_is_zero() -> None:
    """For each frame."""
    assert deepest_overlaps(Scene(), np.zeros((3, 0, 2)), np.zeros((3, 0))).tolist() == [0, 0, 0]

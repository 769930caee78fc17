"""Scenes of notebook 09 that no other part of the workbook needs."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes import corner_impacts
from lesson_code.geometry.shapes import Circle, Segment

PITCH = 6.0
"""m: distance between two random impacts."""

SAME = 1e-10
"""Relative: a smaller difference of energies is rounding."""


def many_corners(count: int, seed: int) -> Scene:
    """Return boxes that hit a long rough floor with one corner, far from one another.

    Each has its own restitution and friction: the floor leaves both to the boxes.
    """
    rng = np.random.default_rng(seed)
    boxes = []
    for n in range(count):
        width, height = (10 ** rng.uniform(-1, 0.5, 2)).tolist()
        box, _ = corner_impacts.box_on_corner(
            width,
            height,
            angle=rng.uniform(0.2, 1.3),
            velocity=(rng.uniform(-3, 3), rng.uniform(-4, -1)),
            angular_velocity=rng.uniform(-2, 2),
            surface=Material(rng.uniform(0, 1), rng.uniform(0, 1.5)),
        )
        x, y = box.position
        boxes.append(replace(box, position=(x + (n - count / 2) * PITCH, y)))
    floor = Body(Segment((-count * PITCH, 0), (count * PITCH, 0)))
    return Scene([floor, *boxes])


def gains_in(run: Run) -> int:
    """Return how many bodies of a run end with more energy than they began with."""
    before, after = (
        _energy_of_each(run.scene, run.velocities[n], run.angular_velocities[n]) for n in (0, -1)
    )
    return int(np.count_nonzero(after > before * (1 + SAME)))


def _energy_of_each(scene: Scene, velocities: Any, spins: Any) -> Any:
    """Return the kinetic energy of every body but the floor, J."""
    bodies = scene.bodies[1:]
    mass, inertia = (np.array([getattr(b, n) for b in bodies]) for n in ("mass", "inertia"))
    return (mass * (velocities[1:] ** 2).sum(axis=1) + inertia * spins[1:] ** 2) / 2


def spinning_hit() -> Scene:
    """Return two rough discs that spin, and meet off centre."""
    rough = Material(0.5, 0.8)
    return Scene(
        [
            Body(Circle(0.5), mass=1, angular_velocity=8.0, material=rough),
            Body(
                Circle(0.5),
                mass=2,
                position=(1.5, 0.2),
                velocity=(-1, 0),
                angular_velocity=3.0,
                material=rough,
            ),
        ]
    )

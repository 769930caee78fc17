"""Unusual right answers to pool."""

from __future__ import annotations

import cmath
import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("P.1")
def with_complex_steps(apex: Vector, radius: float, gap: float) -> Any:
    """Two steps at plus and minus 30 degrees lead from a ball to its neighbours behind."""
    down = cmath.rect(2 * radius + gap, -math.pi / 6)
    up = down.conjugate()
    start = complex(*apex)
    return [start + (row - k) * down + k * up for row in range(5) for k in range(row + 1)]


@alternative("P.2")
def through_the_energy_ellipse(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """Spin over speed is -5 offset / (2 r^2), whatever the impulse."""
    velocity = [part / mass for part in impulse]
    speed = math.hypot(*velocity)
    return velocity, -2.5 * offset / radius**2 * speed


@alternative("P.3")
def with_matrices(positions: Vector, velocities: Vector, radius: float, restitution: float) -> Any:
    """All pairs at once: a matrix takes velocities to approaches, its transpose takes them back."""
    offsets = positions[None, :] - positions[:, None]
    distances = np.hypot(offsets[..., 0], offsets[..., 1])
    a, b = np.nonzero(np.triu(distances <= 2.001 * radius, k=1))
    if len(a) == 0:
        return velocities
    normals = offsets[a, b] / distances[a, b][:, None]
    differences = np.eye(len(positions))[a] - np.eye(len(positions))[b]
    for _ in range(20):
        approach = np.sum(differences @ velocities * normals, axis=1)
        meets = approach > 0
        busy = np.abs(differences).T @ meets
        share = np.where(meets, approach, 0) / np.maximum(np.maximum(busy[a], busy[b]), 1)
        velocities = velocities - differences.T @ (
            ((1 + restitution) / 2 * share)[:, None] * normals
        )
    return velocities.tolist()

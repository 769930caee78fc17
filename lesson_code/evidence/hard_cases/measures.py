"""Measures that more than one hard case uses."""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.hard_cases.case import Measure, Trial

STEP = 1e-9
"""s: a step so short that nothing moves, but overlapping bodies collide."""

TOUCH = 1e-9
"""m: overlap that puts bodies of 1 m in contact."""


def free(scene: Scene) -> list[int]:
    """Return the places of the bodies that can be pushed."""
    return [n for n, body in enumerate(scene.bodies) if not body.is_static]


def largest(differences: Any) -> float:
    """Return the largest absolute value; nan if there is one among them."""
    return float(np.max(np.abs(differences)))


def way_of(run: Run) -> float:
    """Return the largest distance of a body from its start, m."""
    moved = run.positions[-1] - run.positions[0]
    return float(np.max(np.hypot(*moved[free(run.scene)].T)))


def drift(seconds: float) -> Measure:
    """Return a measure: the largest displacement of a body after a time, m."""
    return lambda trial: way_of(trial.run(seconds, sample="end"))


def fastest(run: Run) -> float:
    """Return the greatest speed of any body that can be pushed, in any state, m/s."""
    return float(np.max(np.hypot(*np.moveaxis(run.velocities[:, free(run.scene)], -1, 0))))


def pair_forces(run: Run, dt: float) -> dict[tuple[int, int], float]:
    """Return the normal force of each pair of bodies that touch in the last step, N."""
    hits = run.contacts
    last = np.abs(hits.time - run.times[-1]) < dt / 2
    forces: dict[tuple[int, int], float] = {}
    for a, b, impulse in zip(
        hits.body_a[last].tolist(),
        hits.body_b[last].tolist(),
        hits.normal_impulse[last].tolist(),
        strict=True,
    ):
        forces[a, b] = forces.get((a, b), 0.0) + impulse / dt
    return forces


def relative_errors(measured: Any, expected: Any) -> float:
    """Return the largest difference, relative to the expected value."""
    return largest(np.asarray(measured) / np.asarray(expected) - 1)


def end_state(run: Run) -> Any:
    """Return x, y, angle, vx, vy, w of every body at the end, shape (N, 6)."""
    return np.column_stack(
        (run.positions[-1], run.angles[-1], run.velocities[-1], run.angular_velocities[-1])
    )


def last_velocities(trial: Trial, duration: float, scene: Scene | None = None) -> Any:
    """Return the velocities at the end of a run, shape (N, 2), m/s."""
    return trial.run(duration, scene, sample="end").velocities[-1]

"""Which state of a scene or a run a picture shows: a scene has one, a run as many as recorded."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene

Floats: TypeAlias = NDArray[np.float64]

ROUNDING = 1e-9
"""s by which a time may miss the recorded one."""


def scene_of(drawn: Scene | Run) -> Scene:
    """Return the scene that is drawn."""
    return drawn.scene if isinstance(drawn, Run) else drawn


def poses(drawn: Scene | Run) -> tuple[Floats, Floats]:
    """Return positions, shape (F, N, 2), and angles, shape (F, N), of all states."""
    if isinstance(drawn, Run):
        return drawn.positions, drawn.angles
    places = np.array([body.position for body in drawn.bodies], dtype=float)
    angles = np.array([body.angle for body in drawn.bodies], dtype=float)
    return places.reshape(1, -1, 2), angles.reshape(1, -1)


def frame_at(drawn: Scene | Run, time: float | None) -> int:
    """Return the number of the state that is nearest to a time; None is the last.

    Raises
    ------
    ValueError
        The time lies outside the run.

    Examples
    --------
    >>> from lesson_code import Scene, simulate
    >>> frame_at(simulate(Scene(), duration=1.0, dt=0.1), time=0.31)
    3
    """
    times = drawn.times if isinstance(drawn, Run) else np.zeros(1)
    if time is None:
        return len(times) - 1
    low, high = float(times.min()), float(times.max())
    if not low - ROUNDING <= time <= high + ROUNDING:
        raise ValueError(f"time must lie between {low:g} and {high:g} s, got {time}")
    return int(np.argmin(np.abs(times - time)))

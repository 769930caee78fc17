"""Which state of a scene or a run a picture shows: a scene has one, a run as many as recorded."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene

Floats: TypeAlias = NDArray[np.float64]

ROUNDING = 1e-9
"""s by which a time may miss the recorded one, or that of an impulse."""


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


def velocities_of(drawn: Scene | Run) -> Floats:
    """Return the velocities in all states, shape (F, N, 2)."""
    if isinstance(drawn, Run):
        return drawn.velocities
    return np.array([body.velocity for body in drawn.bodies], dtype=float).reshape(1, -1, 2)


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


def events_of_step(run: Run, frame: int) -> NDArray[np.intp]:
    """Return which impulses are those of the last step before a state, but after the state before.

    None are, if nothing touched in that time.
    """
    times, now = run.contacts.time, float(run.times[frame])
    before = float(run.times[run.times < now].max(initial=-math.inf))
    within = (times > before + ROUNDING) & (times <= now + ROUNDING)
    last = float(times[within].max(initial=-math.inf))
    return np.flatnonzero(within & (times >= last))

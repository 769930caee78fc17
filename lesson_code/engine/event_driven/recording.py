"""Recording an exact run: the state after every collision, or at any times that are wanted."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.recording import STATE_NUMBERS, Sample, given_times, run_of
from lesson_code.engine.core.run import Run
from lesson_code.engine.event_driven.solver import ExactSolver


def record_exact(solver: ExactSolver, duration: float, sample: Sample, reason: str) -> Run:
    """Let the exact solver run for a while, and return what it did.

    Without a sample there is a state at the start, one after each collision and one at the end.
    Collisions at the same time have a state each. States at given times are exact too: motion
    between two events has a closed form. The reason is that for the choice of this solver.
    """
    frames: Any
    if sample is None:
        times, frames = _after_collisions(solver, duration)
    else:
        times = given_times(duration, sample)
        frames = _at_times(solver, times)
        solver.advance(duration)
    return run_of(solver.scene, times, frames, solver.events(), solver.plan(reason))


def _after_collisions(
    solver: ExactSolver, duration: float
) -> tuple[list[float], list[NDArray[np.float64]]]:
    """Return the times and states at the start, after every collision and at the end."""
    times, frames = [0.0], [solver.states(0.0)]
    time = solver.next_collision(duration)
    while time is not None:
        times.append(time)
        frames.append(solver.states(time))
        time = solver.next_collision(duration)
    if times[-1] < duration:
        times.append(duration)
        frames.append(solver.states(duration))
    return times, frames


def _at_times(solver: ExactSolver, times: list[float]) -> NDArray[np.float64]:
    """Return the states at given times, in the order in which they are given."""
    frames = np.zeros((len(times), len(solver.scene.bodies), STATE_NUMBERS))
    for frame in sorted(range(len(times)), key=times.__getitem__):
        solver.advance(times[frame])
        frames[frame] = solver.states(times[frame])
    return frames

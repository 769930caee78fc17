"""Recording an exact run: the state after every collision, or at any times that are wanted."""

from __future__ import annotations

import numpy as np

from lesson_code.engine.core.frames import Frames
from lesson_code.engine.core.recording import Sample, given_times, run_of
from lesson_code.engine.core.run import Run
from lesson_code.engine.event_driven.solver import ExactSolver


def record_exact(solver: ExactSolver, duration: float, sample: Sample, reason: str) -> Run:
    """Let the exact solver run for a while, and return what it did.

    Without a sample there is a state at the start, one after each collision and one at the end.
    Collisions at the same time have a state each. States at given times are exact too: motion
    between two events has a closed form. The reason is that for the choice of this solver.
    """
    frames = (
        _after_collisions(solver, duration)
        if sample is None
        else _at_times(solver, duration, given_times(duration, sample))
    )
    return run_of(solver.scene, frames, solver.impulses(), solver.plan(reason))


def _after_collisions(solver: ExactSolver, duration: float) -> Frames:
    """Return the states at the start, after every collision and at the end."""
    times, states = [0.0], [solver.states(0.0)]
    time = solver.next_collision(duration)
    while time is not None:
        times.append(time)
        states.append(solver.states(time))
        time = solver.next_collision(duration)
    if times[-1] < duration:
        times.append(duration)
        states.append(solver.states(duration))
    frames = Frames(times, len(solver.scene.bodies))
    frames.put(slice(None), np.array(states))
    frames.require_numbers(slice(None))
    return frames


def _at_times(solver: ExactSolver, duration: float, times: list[float]) -> Frames:
    """Return the states at given times, in the order in which they are given; go to the end."""
    frames = Frames(sorted(times), len(solver.scene.bodies))
    solver.note_frames(frames)
    solver.advance(duration)
    return frames.in_order(times)

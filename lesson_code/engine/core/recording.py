"""Recording: any solver that advances in equal steps, turned into a Run."""

from __future__ import annotations

import math
from typing import Any, Literal, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.columns import Floats
from lesson_code.engine.core.frames import Frames
from lesson_code.engine.core.impulse_table import ImpulseTable
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.formulas.arithmetic import ROUNDING_OF_PARTS, whole_parts
from lesson_code.formulas.validation import non_negative

Sample: TypeAlias = Literal["end"] | Any
"""None: every step. "end": the first and the last state. Otherwise times, shape (F,), s."""

Event: TypeAlias = tuple[float, int, int, float, float, float, float, float, float, float]
"""time, body a, body b, point x and y, normal x and y, normal and tangent impulse, penetration."""

MOST_STEPS = 1e9
"""More would take a day at 100 microseconds each: somebody has mistaken a unit."""


class Stepper(Protocol):
    """A solver at work on a scene: it advances by equal steps and can be asked for its state."""

    dt: float

    def advance(self, steps: int) -> None:
        """Advance by `steps` steps of dt."""

    def note_steps(self, steps: int, frames: Frames, first: int) -> None:
        """Advance by `steps` steps, and write down the states after each, as frames from one on.

        A solver of which only single states can be had takes them one by one.
        """
        for frame in range(first, first + steps):
            self.advance(1)
            frames.put(frame, self.states_after(0.0))
            frames.require_numbers(slice(frame, frame + 1))

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6), a part of a step later, s.

        The stepper stays where it is.
        """

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10); see :data:`Event`."""

    def impulses(self) -> ImpulseTable:
        """Return the same impulses as they were written down; to make numbers of them takes time.

        A solver that has nothing but numbers gives those.
        """
        table = ImpulseTable()
        table.add(self.events())
        return table

    def plan(self, reason: str) -> Plan:
        """Return how the scene has been run so far; the reason is that for this solver."""


def record(stepper: Stepper, scene: Scene, duration: float, sample: Sample, reason: str) -> Run:
    """Run a solver for a duration, and return the run.

    All steps have the same length. A state between two steps is what a shorter step makes of the
    earlier one.
    """
    _require_few_steps(duration, stepper.dt)
    asked = _times(duration, stepper.dt, sample)
    frames = Frames(sorted(asked), len(scene.bodies))
    steps, rests = _moments(frames.times, stepper.dt)
    ahead = _steps_in_turn(steps, rests)
    at = done = 0
    while at < len(steps):
        if (count := int(ahead[at])) > 1:
            stepper.note_steps(count, frames, at)
            at, done = at + count, done + count
        else:
            stepper.advance(max(int(steps[at]) - done, 0))
            frames.put(at, stepper.states_after(float(rests[at])))
            frames.require_numbers(slice(at, at + 1))
            at, done = at + 1, max(done, int(steps[at]))
    stepper.advance(whole_parts(duration, stepper.dt) - done)
    return run_of(scene, frames.in_order(asked), stepper.impulses(), stepper.plan(reason))


def _moments(times: Floats, dt: float) -> tuple[NDArray[np.int64], Floats]:
    """Return times as whole steps and rests, s; a rest that is only rounding is none."""
    steps = np.floor(times / dt + ROUNDING_OF_PARTS)
    return steps.astype(np.int64), np.maximum(times - steps * dt, 0.0)


def _steps_in_turn(steps: NDArray[np.int64], rests: Floats) -> NDArray[np.int64]:
    """Return how many of the moments from each one on follow each other, a whole step after a step.

    >>> _steps_in_turn(np.array([0, 1, 2, 2, 3]), np.array([0, 0, 0, 0.5, 0])).tolist()
    [0, 2, 1, 0, 1]
    """
    before = np.concatenate(([0], steps[:-1]))
    is_next = (rests == 0.0) & (steps - before == 1)
    places = np.arange(len(steps))
    stops = np.append(np.flatnonzero(~is_next), len(steps))
    return np.asarray(stops[np.searchsorted(stops, places)] - places)


def moved_on(states: NDArray[np.float64], duration: float) -> NDArray[np.float64]:
    """Return states, shape (N, 6), a while later, s, if nothing changes the velocities."""
    later = states.copy()
    later[:, 0:3] += duration * states[:, 3:6]
    return later


def run_of(scene: Scene, frames: Frames, impulses: ImpulseTable, plan: Plan) -> Run:
    """Return a run from the states of all bodies and from their impulses."""
    return Run(
        scene=scene,
        times=_frozen(frames.times),
        positions=_frozen(frames.positions),
        velocities=_frozen(frames.velocities),
        angles=_frozen(frames.angles),
        angular_velocities=_frozen(frames.spins),
        impulses=impulses,
        plan=plan,
    )


def _times(duration: float, dt: float, sample: Sample) -> list[float]:
    """Return the times at which the state is wanted, s."""
    return step_times(duration, dt) if sample is None else given_times(duration, sample)


def step_times(duration: float, dt: float) -> list[float]:
    """Return the times of all steps, from 0 on, and the end of a run, s.

    Raises
    ------
    ValueError
        There are more than anybody can want.

    >>> step_times(0.25, 0.1)
    [0.0, 0.1, 0.2, 0.25]
    """
    _require_few_steps(duration, dt)
    steps = whole_parts(duration, dt)
    times = [min(step * dt, duration) for step in range(steps + 1)]
    if not math.isclose(steps * dt, duration, rel_tol=1e-9, abs_tol=1e-9 * dt):
        times.append(duration)
    return times


def _require_few_steps(duration: float, dt: float) -> None:
    """Refuse a run of more steps than anybody can want."""
    if not duration / dt <= MOST_STEPS:
        raise ValueError(
            f"duration must be at most {MOST_STEPS:g} dt, got {duration} s with dt {dt} s"
        )


def given_times(duration: float, sample: Any) -> list[float]:
    """Return the times that a user asks for, or refuse those the run does not reach."""
    if isinstance(sample, str):
        if sample != "end":
            raise ValueError(f'sample must be None, "end" or an array of times, got {sample!r}')
        return [0.0, duration]
    times = np.asarray(non_negative("sample", sample), dtype=float)
    if times.ndim != 1:
        raise ValueError(f"sample must have shape (F,), got shape {times.shape}")
    if (times > duration).any():
        raise ValueError(f"sample must be <= duration = {duration} s, got {times.max()}")
    given: list[float] = times.tolist()
    return given


def _frozen(array: NDArray[Any]) -> NDArray[Any]:
    """Return a read-only array."""
    copy = np.ascontiguousarray(array)
    copy.setflags(write=False)
    return copy

"""Recording: any solver that advances in equal steps, turned into a Run."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, Literal, NamedTuple, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.frames import Frames
from lesson_code.engine.core.impulse_table import EVENT_NUMBERS
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.run import ImpulseEvents, Run
from lesson_code.engine.core.scene import Scene
from lesson_code.formulas.arithmetic import whole_parts
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

    def states_of_steps(self, steps: int) -> Iterator[NDArray[np.float64]]:
        """Advance by `steps` steps, and yield the states after each, shape (K, N, 6) for K steps.

        A solver of which only single states can be had takes them one by one.
        """
        for _ in range(steps):
            self.advance(1)
            yield self.states_after(0.0)[np.newaxis]

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6), a part of a step later, s.

        The stepper stays where it is.
        """

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10); see :data:`Event`."""

    def plan(self, reason: str) -> Plan:
        """Return how the scene has been run so far; the reason is that for this solver."""


class Moment(NamedTuple):
    """A time at which the state is wanted: a number of whole steps, and a remainder, s."""

    time: float
    steps: int
    rest: float


def record(stepper: Stepper, scene: Scene, duration: float, sample: Sample, reason: str) -> Run:
    """Run a solver for a duration, and return the run.

    All steps have the same length. A state between two steps is what a shorter step makes of the
    earlier one.
    """
    _require_few_steps(duration, stepper.dt)
    moments = _moments(duration, stepper.dt, sample)
    frames = Frames([moment.time for moment in moments], len(scene.bodies))
    order = np.argsort(frames.times, kind="stable")
    moments = [moments[frame] for frame in order]
    done = at = 0
    while at < len(moments):
        if (ahead := _steps_in_turn(moments, at, done)) > 0:
            for states in stepper.states_of_steps(ahead):
                frames.put(order[at : at + len(states)], states)
                at += len(states)
            done += ahead
        else:
            stepper.advance(max(moments[at].steps - done, 0))
            frames.put(order[at], stepper.states_after(moments[at].rest))
            done = max(done, moments[at].steps)
            at += 1
    stepper.advance(whole_parts(duration, stepper.dt) - done)
    return run_of(scene, frames, stepper.events(), stepper.plan(reason))


def _steps_in_turn(moments: Sequence[Moment], at: int, done: int) -> int:
    """Return how many of the moments from one on follow each other, a whole step after a step."""
    count = 0
    while at + count < len(moments) and moments[at + count].rest == 0.0:
        if moments[at + count].steps != done + count + 1:
            break
        count += 1
    return count


def moved_on(states: NDArray[np.float64], duration: float) -> NDArray[np.float64]:
    """Return states, shape (N, 6), a while later, s, if nothing changes the velocities."""
    later = states.copy()
    later[:, 0:3] += duration * states[:, 3:6]
    return later


def run_of(scene: Scene, frames: Frames, events: Any, plan: Plan) -> Run:
    """Return a run from the states of all bodies and from their impulses, shape (K, 10)."""
    return Run(
        scene=scene,
        times=_frozen(frames.times),
        positions=_frozen(frames.positions),
        velocities=_frozen(frames.velocities),
        angles=_frozen(frames.angles),
        angular_velocities=_frozen(frames.angular_velocities),
        contacts=_events(events),
        plan=plan,
    )


def _moments(duration: float, dt: float, sample: Sample) -> list[Moment]:
    """Return the times at which the state is wanted."""
    return [_moment(time, dt) for time in _times(duration, dt, sample)]


def _moment(time: float, dt: float) -> Moment:
    """Return a time as whole steps and a rest; a rest that is only rounding is none."""
    steps = whole_parts(time, dt)
    return Moment(time, steps, max(time - steps * dt, 0.0))


def _times(duration: float, dt: float, sample: Sample) -> Iterator[float]:
    """Yield the times at which the state is wanted, s."""
    yield from step_times(duration, dt) if sample is None else given_times(duration, sample)


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


def _events(events: Any) -> ImpulseEvents:
    """Return the impulses, shape (K, 10), as columns."""
    table = _frozen(np.asarray(events, dtype=float).reshape(-1, EVENT_NUMBERS))
    return ImpulseEvents(
        time=table[:, 0],
        body_a=_frozen(table[:, 1].astype(np.int64)),
        body_b=_frozen(table[:, 2].astype(np.int64)),
        point=table[:, 3:5],
        normal=table[:, 5:7],
        normal_impulse=table[:, 7],
        tangent_impulse=table[:, 8],
        penetration=table[:, 9],
    )


def _frozen(array: NDArray[Any]) -> NDArray[Any]:
    """Return a read-only array."""
    copy = np.ascontiguousarray(array)
    copy.setflags(write=False)
    return copy

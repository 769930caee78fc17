"""Few bodies: how much longer pymunk takes than the exact solver until its error is as small.

Pymunk's error falls with the time step, and its time grows. It is run with finer and finer steps.
Its time with the finest, over the exact solver's, is a lower bound: its error is still larger. What
is said beyond that is extrapolated along the line through its errors.

The exact solver's own error is that of a run forth and back again, which should end where it began.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.scenes.events import (
    ball_in_a_box,
    error_after_return,
    turned_back,
    two_blocks,
)
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.speed import SpeedScene
from lesson_code.evidence.speed.clock import worked_seconds
from lesson_code.evidence.speed.engines import ExactStepper, builder
from lesson_code.evidence.speed.statistics import step_for_error
from lesson_code.simulation import simulate

STEPS_A_SECOND = (60, 600, 6_000, 60_000, 600_000)
"""Of pymunk."""

LONG = 1.0
"""s: a run that takes longer is timed once; what disturbs it is a small part of it."""

LEAST_ERROR = 1e-16
"""m: an error of exactly 0 is luck."""


@dataclass(frozen=True)
class FewBodies:
    """The exact solver and pymunk in a scene of few bodies.

    Attributes
    ----------
    name : str
        Of the scene.
    duration : float
        s, simulated.
    collisions : int
        Within that time.
    exact_seconds, exact_error : float
        Median time, s; how far the farthest body is off, m.
    steps_a_second : tuple of int
        Of pymunk.
    pymunk_seconds, pymunk_errors : tuple of float
        For each of these: median time, s, and error, m.
    """

    name: str
    duration: float
    collisions: int
    exact_seconds: float
    exact_error: float
    steps_a_second: tuple[int, ...]
    pymunk_seconds: tuple[float, ...]
    pymunk_errors: tuple[float, ...]

    @property
    def ratio_measured(self) -> float:
        """Pymunk's time with its finest step over the exact solver's: a lower bound."""
        return self.pymunk_seconds[-1] / self.exact_seconds

    @property
    def ratio_extrapolated(self) -> float | None:
        """The same with a step so fine that the errors would be equal, if they fall evenly."""
        steps = [1 / rate for rate in self.steps_a_second]
        errors = [max(error, LEAST_ERROR) for error in self.pymunk_errors]
        wanted = step_for_error(steps, errors, max(self.exact_error, LEAST_ERROR))
        return self.ratio_measured * steps[-1] / wanted if wanted > 0 else None


SCENES: dict[str, tuple[Callable[[], Scene], float]] = {
    "a ball in a box": (ball_in_a_box, 10.0),
    "two blocks, 1 : 100": (lambda: two_blocks(100.0), 10.0),
    "five discs in a box": (lambda: gas_of(5, 0.1, seed=1), 4.0),
}
"""What is simulated, and how long, s."""


def measure_few_bodies(
    repeats: int,
    rates: tuple[int, ...] = STEPS_A_SECOND,
    told: Callable[[str], None] = lambda _: None,
) -> tuple[FewBodies, ...]:
    """Compare the exact solver with pymunk in each scene.

    Parameters
    ----------
    repeats : int
        How often each is timed, >= 1.
    rates : tuple of int
        Pymunk's steps a second, the fewest first.
    told : callable
        Hears what is being done.
    """
    measured = []
    for name, (scene, duration) in SCENES.items():
        told(f"few bodies: {name}")
        measured.append(_compare(name, scene(), duration, repeats, rates))
    return tuple(measured)


def _compare(
    name: str, scene: Scene, duration: float, repeats: int, rates: tuple[int, ...]
) -> FewBodies:
    """Return the times and errors in one scene."""
    run = simulate(scene, duration, solver="exact")
    back = simulate(turned_back(run), duration, solver="exact", sample="end")
    exact: list[float] = []
    theirs: dict[int, list[float]] = {rate: [] for rate in rates}
    errors = dict.fromkeys(rates, 0.0)
    _time_exact(scene, duration)  # loads or compiles the program
    for _ in range(repeats):
        exact.append(_time_exact(scene, duration))
        for rate in rates:
            if max(theirs[rate], default=0.0) > LONG:
                continue
            seconds, places = _time_pymunk(scene, duration, rate)
            theirs[rate].append(seconds)
            errors[rate] = float(np.hypot(*(places - run.positions[-1]).T).max())
    return FewBodies(
        name=name,
        duration=duration,
        collisions=len(run.contacts),
        exact_seconds=statistics.median(exact),
        exact_error=error_after_return(run, back),
        steps_a_second=rates,
        pymunk_seconds=tuple(statistics.median(theirs[rate]) for rate in rates),
        pymunk_errors=tuple(errors.values()),
    )


def _time_exact(scene: Scene, duration: float) -> float:
    """Return how long the exact solver takes, s; the first events are foretold when it is built."""
    stepper = ExactStepper(scene, duration)
    start = worked_seconds()
    stepper.advance(1)
    return worked_seconds() - start


def _time_pymunk(scene: Scene, duration: float, rate: int) -> tuple[float, np.ndarray]:
    """Return how long pymunk takes, s, and where the bodies are then."""
    speed_scene = SpeedScene("", scene, 1 / rate, 0, "", ())
    engine = builder("pymunk, tree", speed_scene)()
    start = worked_seconds()
    engine.advance(round(duration * rate))
    return worked_seconds() - start, engine.states()[:, :2]

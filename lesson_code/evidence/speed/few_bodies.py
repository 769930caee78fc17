"""Few bodies: how much longer pymunk takes than the exact solver until its error is as small.

Pymunk's error falls with the time step, and its time grows. It is run with finer and finer steps.
Its time with the finest, over the exact solver's, is a lower bound: its error is still larger. Any
larger ratio is extrapolated along the line through its errors.

The exact solver's own error is that of a run forwards and back, which should end where it began.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.engines import ExactStepper
from lesson_code.evidence.orders import fit_order
from lesson_code.evidence.scenes.events import (
    ball_in_a_box,
    error_after_return,
    turned_back,
    two_blocks,
)
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.speed import SpeedScene
from lesson_code.evidence.speed.engines import start
from lesson_code.evidence.timing import in_turns, timed
from lesson_code.simulation import simulate

STEPS_A_SECOND = (60, 600, 6_000, 60_000, 600_000)
"""Of pymunk."""

LONG = 1.0
"""s: a run that takes longer is timed once."""

LEAST_ERROR = 1e-16
"""m: an error of exactly 0 is luck."""

LEAST_ORDER = 0.5
"""Errors that fall more slowly with the time step are not extrapolated: they are chaotic."""


@dataclass(frozen=True)
class FewBodies:
    """The exact solver and pymunk in a scene of few bodies."""

    derived: ClassVar = ("ratio_measured", "ratio_extrapolated")

    name: str
    duration: float  # s, simulated
    collisions: int  # within that time
    exact_seconds: float  # median
    exact_error: float  # m: of the farthest body
    steps_a_second: tuple[int, ...]  # of pymunk
    pymunk_seconds: tuple[float, ...]  # for each of these, median
    pymunk_errors: tuple[float, ...]  # m

    @property
    def ratio_measured(self) -> float:
        """Pymunk's time with its finest step over the exact solver's: a lower bound."""
        return self.pymunk_seconds[-1] / self.exact_seconds

    @property
    def ratio_extrapolated(self) -> float | None:
        """The same with a step so fine that the errors would be equal; None: they hardly fall."""
        steps = [1 / rate for rate in self.steps_a_second]
        fit = fit_order(steps, [max(error, LEAST_ERROR) for error in self.pymunk_errors])
        if fit.order < LEAST_ORDER:
            return None
        step = math.pow(max(self.exact_error, LEAST_ERROR) / fit.factor, 1 / fit.order)
        return self.ratio_measured * steps[-1] / step


SCENES: dict[str, tuple[Callable[[], Scene], float]] = {
    "a ball in a box": (ball_in_a_box, 10.0),
    "two blocks, 1 : 100": (lambda: two_blocks(100.0), 10.0),
    "five discs in a box": (lambda: gas_of(5, 0.1, seed=1), 4.0),
}
"""The scenes, and the duration of each, s."""


def measure_few_bodies(
    repeats: int, rates: tuple[int, ...] = STEPS_A_SECOND
) -> tuple[FewBodies, ...]:
    """Compare the exact solver with pymunk at some steps a second, the fewest first."""
    return tuple(
        _compare(name, scene(), duration, repeats, rates)
        for name, (scene, duration) in SCENES.items()
    )


def _compare(
    name: str, scene: Scene, duration: float, repeats: int, rates: tuple[int, ...]
) -> FewBodies:
    """Return the times and errors in one scene."""
    run = simulate(scene, duration, solver="exact")
    back = simulate(turned_back(run), duration, solver="exact", sample="end")
    errors: dict[int, float] = {}

    def exact() -> float:
        stepper = ExactStepper(scene, duration)  # predicts the first events
        return timed(lambda: stepper.advance(1)).worked

    def pymunk(rate: int) -> float:
        engine = start("pymunk, tree", SpeedScene("", scene, 1 / rate, warm_up=0))
        seconds = timed(lambda: engine.advance(round(duration * rate))).worked
        places = engine.states()[:, :2]
        errors[rate] = float(np.hypot(*(places - run.positions[-1]).T).max())
        return seconds

    exact()  # loads or compiles the program
    jobs: dict[int, Callable[[], float]] = {0: exact}
    jobs |= {rate: lambda rate=rate: pymunk(rate) for rate in rates}  # type: ignore[misc]
    times = in_turns(jobs, repeats, patience=LONG)
    medians = {key: statistics.median(taken) for key, taken in times.items()}
    return FewBodies(
        name=name,
        duration=duration,
        collisions=len(run.contacts),
        exact_seconds=medians[0],
        exact_error=error_after_return(run, back),
        steps_a_second=rates,
        pymunk_seconds=tuple(medians[rate] for rate in rates),
        pymunk_errors=tuple(errors[rate] for rate in rates),
    )

"""A hard case: a scene, a measure of the error, and the bound that a solver has to hold."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.simulation import simulate

Options: TypeAlias = Mapping[str, Any]
"""Arguments of :func:`lesson_code.simulate`, by name."""

OURS = "ours"
"""The name for our solver, whichever of our solvers runs the case."""

PEERS = ("naive", "pymunk", "box2d")
"""The solvers that ours is compared with."""

SOLVERS = (OURS, *PEERS)


@dataclass(frozen=True)
class Trial:
    """A hard case in the hands of one solver.

    Attributes
    ----------
    scene : Scene
        The case's scene.
    options : mapping
        Arguments of :func:`lesson_code.simulate`: the solver and its settings.
    """

    scene: Scene
    options: Options

    @property
    def solver(self) -> str:
        """The solver's name, as :func:`lesson_code.simulate` takes it."""
        return str(self.options["solver"])

    def run(self, duration: float, scene: Scene | None = None, **more: Any) -> Run:
        """Run the case's scene, or another one; the case's options take precedence."""
        return simulate(
            self.scene if scene is None else scene, duration, **{**more, **self.options}
        )


Measure: TypeAlias = Callable[[Trial], float]
"""Runs one or more scenes, and returns how far the result is from what it should be, >= 0."""


@dataclass(frozen=True)
class HardCase:
    """A scene in which solvers go wrong, and a measure that detects it.

    Attributes
    ----------
    name : str
        A short one for the command line.
    theme : str
        The heading under which the case stands.
    title : str
        What is in the scene.
    why : str
        Why it is hard, in a sentence.
    law : str
        The law or reference that says what is right.
    scene : callable
        Returns the scene, or a typical one if the case needs many.
    measure : callable
        Takes a Trial; returns a number >= 0, which is 0 for a perfect result.
    unit : str
        Of that number; "" for a ratio or a count.
    bound : float
        The largest measure that holds.
    reason : str
        Why the bound is what it is.
    ours : mapping
        Our solver and its settings: the solver that the plan chooses, and in a few cases a rule
        for impacts.
    options : mapping
        Arguments for every solver, such as dt.
    failed_by : tuple of str
        Solvers that are known not to hold the bound.
    is_long : bool
        Whether our run takes more than some seconds.
    """

    name: str
    theme: str
    title: str
    why: str
    law: str
    scene: Callable[[], Scene]
    measure: Measure
    unit: str
    bound: float
    reason: str
    ours: Options = field(default_factory=lambda: {"solver": "auto"})
    options: Options = field(default_factory=dict)
    failed_by: tuple[str, ...] = ()
    is_long: bool = False

    def trial(self, solver: str) -> Trial:
        """Return the case in the hands of a solver: "ours" or one of the others by its name.

        Raises
        ------
        ValueError
            The solver is none of those.
        """
        if solver not in SOLVERS:
            raise ValueError(f"solver must be one of {', '.join(SOLVERS)}, got {solver!r}")
        own = self.ours if solver == OURS else {"solver": solver}
        return Trial(self.scene(), {**self.options, **own})


@dataclass(frozen=True)
class Outcome:
    """How a solver did in a case.

    Attributes
    ----------
    case, solver : str
        Their names.
    value : float
        The measured value; nan if the solver did not finish.
    bound : float
        The case's.
    seconds : float
        Wall-clock time.
    error : str
        Why there is no value; "" if there is one.
    """

    case: str
    solver: str
    value: float
    bound: float
    seconds: float = 0.0
    error: str = ""

    @property
    def held(self) -> bool:
        """Whether the bound was held; nan holds nothing."""
        return self.value <= self.bound

    @property
    def excess(self) -> float:
        """How many times the bound the value is; infinite over a bound of 0."""
        if self.bound > 0.0 or math.isnan(self.value):
            return self.value / self.bound if self.bound > 0.0 else math.nan
        return math.inf if self.value > 0.0 else 0.0


def run_case(case: HardCase, solver: str = OURS) -> Outcome:
    """Return how a solver does in a case; an exception of the solver is an outcome, too.

    A solver that kills the whole process (pymunk does on some input) must run in another process:
    :func:`lesson_code.evidence.hard_cases.measure_hard_cases` takes care of that.
    """
    trial = case.trial(solver)
    begin = time.perf_counter()
    value, error = math.nan, ""
    try:
        with np.errstate(all="ignore"):  # an overflow shows in the result
            value = float(case.measure(trial))
    except ModuleNotFoundError:
        raise
    except Exception as fault:  # any failure of a solver is a result
        error = f"{type(fault).__name__}: {fault}"
    if not math.isfinite(value) and not error:
        error = "no finite number"
    seconds = round(time.perf_counter() - begin, 3)
    return Outcome(case.name, solver, value, case.bound, seconds, error)

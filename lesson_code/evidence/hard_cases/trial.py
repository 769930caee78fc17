"""A family of hard cases: a law over drawn parameters, and the bound that a solver has to hold."""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from lesson_code.engine.core.recording import Sample
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.hard_cases.parameters import Draw, Value, seeded
from lesson_code.simulation import simulate

OURS = "ours"
"""The name for ``simulate(scene, duration)``, whichever of our solvers that takes."""

SWEEPS = "sequential"
"""Our solver that sweeps over the contacts: the cheaper one, whatever the scene."""

PEERS = (SWEEPS, "naive", "pymunk", "box2d")
"""The solvers that ours is compared with."""

ENGINES = (OURS, *PEERS)


@dataclass(frozen=True)
class Trial:
    """A family in the hands of one engine.

    Attributes
    ----------
    engine : str
        "ours", or the name of a peer.
    """

    engine: str

    def __post_init__(self) -> None:
        """Refuse an engine that is none of those."""
        if self.engine not in ENGINES:
            raise ValueError(f"engine must be one of {', '.join(ENGINES)}, got {self.engine!r}")

    def run(
        self, scene: Scene, duration: float, *, sample: Sample = "end", dt: float | None = None
    ) -> Run:
        """Run a scene, with no settings but a step where the law is about steps.

        Parameters
        ----------
        scene : Scene
            What is simulated.
        duration : float
            s.
        sample : None, "end" or array_like
            Which states are recorded, as :func:`lesson_code.simulate` takes it.
        dt : float, optional
            s; every engine gets it.
        """
        options: dict[str, Any] = {} if dt is None else {"dt": dt}
        if self.engine != OURS:
            options["solver"] = self.engine
        with warnings.catch_warnings():  # of a law, only whether it holds is of interest
            warnings.filterwarnings("ignore", "in .* steps there were", RuntimeWarning)
            return simulate(scene, duration, sample=sample, **options)


Measure: TypeAlias = Callable[[Draw, Trial], float]
"""Draws parameters, runs what they describe, and returns how far that is from the law, >= 0."""


@dataclass(frozen=True)
class Family:
    """A law over a drawn set of scenes.

    Attributes
    ----------
    name : str
        A short one for the command line.
    theme : str
        The heading under which the family stands.
    title : str
        What is drawn and run.
    why : str
        Why it is hard, in a sentence.
    law : str
        The law or reference that says what is right.
    unit : str
        Of the measure; "" for a ratio or a count.
    bound : float
        The largest measure that holds.
    reason : str
        Why the bound is what it is.
    measure : callable
        Takes a Draw and a Trial; returns a number >= 0, which is 0 for a perfect result.
    is_long : bool
        Whether a draw of ours takes more than some seconds.
    """

    name: str
    theme: str
    title: str
    why: str
    law: str
    unit: str
    bound: float
    reason: str
    measure: Measure
    is_long: bool = False


def family(
    theme: str,
    *,
    why: str,
    law: str,
    unit: str,
    bound: float,
    reason: str,
    is_long: bool = False,
) -> Callable[[Measure], Family]:
    """Make a family of the function below: its name is the function's, its title the docstring.

    The arguments are the attributes of :class:`Family`.
    """

    def made(measure: Measure) -> Family:
        function: Any = measure
        name = function.__name__.replace("_", "-")
        title = " ".join(function.__doc__.split()).removesuffix(".")
        return Family(name, theme, title, why, law, unit, bound, reason, measure, is_long)

    return made


@dataclass(frozen=True)
class Outcome:
    """How an engine did in one draw of a family.

    Attributes
    ----------
    family, engine : str
        Their names.
    seed : int
        Of the draw; -1 where no seed drew it.
    value : float
        The measured value; nan if the engine did not finish.
    bound : float
        The family's.
    parameters : mapping of str to value
        What was drawn.
    seconds : float
        CPU time.
    error : str
        Why there is no value; "" if there is one.
    """

    family: str
    engine: str
    seed: int
    value: float
    bound: float
    parameters: Mapping[str, Value] = field(default_factory=dict)
    seconds: float = math.nan
    error: str = ""

    @property
    def held(self) -> bool:
        """Whether the bound was held; nan holds nothing."""
        return self.value <= self.bound


def run_draw(family: Family, engine: str, seed: int) -> Outcome:
    """Return how an engine does in the draw of a family that belongs to a seed.

    An engine that kills the whole process (pymunk does on some input) must run in another process:
    :func:`lesson_code.evidence.hard_cases.measure_hard_cases` takes care of that.
    """
    return run_drawn(family, engine, Draw(seeded(family.name, seed)), seed)


def run_drawn(family: Family, engine: str, draw: Draw, seed: int = -1) -> Outcome:
    """Return how an engine does in a draw; an exception of the engine is an outcome, too."""
    trial = Trial(engine)
    begin = time.process_time()
    value, error = math.nan, ""
    try:
        with np.errstate(all="ignore"):  # an overflow shows in the result
            value = float(family.measure(draw, trial))
    except ModuleNotFoundError:
        raise
    except Exception as fault:  # any failure of an engine is a result
        error = f"{type(fault).__name__}: {fault}"
    if not math.isfinite(value) and not error:
        error = "no finite number"
    seconds = time.process_time() - begin
    return Outcome(
        family.name, engine, seed, value, family.bound, dict(draw.values), seconds, error
    )

"""What a solver is: one value, `SOLVER`, at the end of one file; nothing else knows its name.

A solver is either a set of stages, which the engine steps like any other's, or a function that
runs a scene by itself: the exact one has no steps, and other engines have steps of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.pipeline import MakePart, SolverStages
from lesson_code.engine.core.recording import Sample
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.sight import NO_SKIN, Sight
from lesson_code.engine.core.step import rigid_part


@dataclass(frozen=True)
class Request:
    """A run that is asked for: the arguments of :func:`lesson_code.simulate`, checked.

    Attributes
    ----------
    scene, duration, dt, combine, effects, compiled, sample
        As they were given.
    iterations, substeps : int, optional
        None: as many as the solver usually makes.
    options : mapping from str to str
        Choices that only some solvers offer, such as "impacts".
    reason : str
        Why it is this solver that runs.
    may_give_up : bool
        Whether another solver takes over where this one has no answer.
    """

    scene: Scene
    duration: float
    dt: float
    iterations: int | None
    substeps: int | None
    combine: MixingRule
    effects: Mapping[str, bool] | None
    compiled: bool | None
    options: Mapping[str, str]
    sample: Sample
    reason: str = "asked for"
    may_give_up: bool = False


RunScene: TypeAlias = Callable[[Request], Run]


@dataclass(frozen=True, kw_only=True)
class Solver:
    """A solver, and all that the rest of the workbook asks about it.

    Attributes
    ----------
    name : str
        As :func:`lesson_code.simulate` takes it.
    stages : SolverStages, optional
        What it does in a step of the engine.
    run_scene : callable, optional
        Runs a scene, where it is not the engine that steps it.
    make_part : callable
        How it makes a step, or the part of one until an impact.
    shares_contacts : bool
        Whether its sub-steps share the contacts of their step; else each finds its own.
    sight : Sight
        From where on it sees contacts, and how far a body may move in a step unwatched.
    iterations, substeps : int
        Sweeps and sub-steps in a step, unless they are given.
    has_matrices : bool
        Whether it solves systems of equations with NumPy.
    has_one_sweep : bool
        Whether it makes one sweep, however many are asked for.
    options : mapping from str to tuple of str
        Choices that it offers, and their values; the first is what it does unless it is told.
    make_stages : callable, optional
        Returns what it does in a step of the engine, given a value for each option by name, for a
        solver that keeps something from stage to stage: each run has stages of its own then.
    never_compiled : str
        Why its stages are not compiled, in words; "" where they are.
    gives_up : str
        What to say where it finds no end and "auto" takes the next one; "" if that cannot be.
    lacks : mapping from str to str
        Effects that it does not have, and why.
    built_in : mapping from str to str
        Effects that it cannot do without, whatever the scene calls for, and why.
    """

    name: str
    stages: SolverStages | None = None
    run_scene: RunScene | None = None
    make_part: MakePart = rigid_part
    shares_contacts: bool = False
    sight: Sight = NO_SKIN
    iterations: int = 10
    substeps: int = 1
    has_matrices: bool = False
    has_one_sweep: bool = False
    options: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    make_stages: Callable[..., SolverStages] | None = None
    never_compiled: str = ""
    gives_up: str = ""
    lacks: Mapping[str, str] = field(default_factory=dict)
    built_in: Mapping[str, str] = field(default_factory=dict)

    def stages_for(self, options: Mapping[str, str]) -> SolverStages:
        """Return its stages for some choices.

        Raises
        ------
        ValueError
            It has none: it is not the engine that steps it.
        """
        if self.make_stages is not None:
            usual = {name: first for name, (first, *_) in self.options.items()}
            return self.make_stages(**{**usual, **options})
        if self.stages is None:
            raise ValueError(f"solver must be one that the engine steps, got {self.name!r}")
        return self.stages

    def counts(self, asked: Request) -> tuple[int, int]:
        """Return how many sweeps and sub-steps it makes in a step."""
        sweeps = 1 if self.has_one_sweep else asked.iterations or self.iterations
        return sweeps, asked.substeps or self.substeps

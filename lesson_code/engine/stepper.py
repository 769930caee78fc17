"""The engine at work on one scene: its tables, its stages, and a record of its impulses."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from operator import attrgetter
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import (
    Choice,
    as_arrays,
    as_numbers,
    choose,
    compiled_function,
    copy_of,
    link,
)
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.plan import EffectChoice, Plan
from lesson_code.engine.core.recording import EVENT_NUMBERS, STATE_NUMBERS, record
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene, scene_at
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.engine.core.step import advance
from lesson_code.engine.core.tables import BROAD_PHASES, world_of
from lesson_code.engine.effects.callbacks import TouchListener
from lesson_code.engine.effects.choice import (
    choose_effects,
    flags_of,
    names_used,
)
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import our_solvers

STATE_FIELDS = ["x", "y", "angle", "vx", "vy", "w"]
"""The fields of a body's row that are its state."""

state_of = attrgetter(*STATE_FIELDS)
"""Returns the state that a row holds."""


def pipeline_for(
    scene: Scene, solver: Solver, choices: tuple[EffectChoice, ...], options: Mapping[str, str]
) -> Pipeline:
    """Return the stages that a scene is run by: those of the effects that are used.

    A step is split at the impacts of fast bodies only once the first one is met.
    """
    effects = flags_of(choices)
    return Pipeline(
        make_part=solver.make_part,
        broad_phase=BROAD_PHASES["uniform_grid" if effects.broad_phase else "all_pairs"],
        solver=solver.stages_for(options),
        listener=TouchListener(scene.callbacks) if effects.callbacks else None,
        effects=effects,
        splits_steps=False,
    )


def source_of(pipeline: Pipeline) -> str:
    """Return the program that the stages of a run make."""
    return link(advance, pipeline=pipeline)


NO_OPTIONS: Mapping[str, str] = MappingProxyType({})

BODY_SECONDS, VISIT_SECONDS = 8e-6, 4e-6
"""s, of plain Python: for a body in a step, and for a visit to a contact."""

CONTACTS_PER_BODY = 2
"""In a pile, about; without gravity there are few."""


def choose_code(
    scene: Scene,
    solver: Solver,
    steps: float,
    iterations: int,
    asked: bool | None,
    program: Callable[[], str],
) -> Choice:
    """Return whether to compile a run, from what has been asked for or from the work there is."""
    visits = CONTACTS_PER_BODY * iterations if any(scene.gravity) else 0
    seconds = steps * len(scene.bodies) * (BODY_SECONDS + visits * VISIT_SECONDS)
    never = "callbacks are Python functions" if scene.callbacks.wanted else ""
    return choose(asked, seconds, program, solver.never_compiled or never)


def run_in_steps(asked: Request, solver: Solver) -> Run:
    """Let the engine step a scene by a solver's stages."""
    iterations, substeps = solver.counts(asked)
    stepper = EngineStepper(
        asked.scene,
        solver=solver.name,
        dt=asked.dt,
        iterations=iterations,
        substeps=substeps,
        combine=asked.combine,
        compiled=asked.compiled,
        effects=asked.effects,
        duration=asked.duration,
        options=asked.options,
    )
    return record(stepper, asked.scene, asked.duration, asked.sample, asked.reason)


class EngineStepper:
    """A scene that the engine advances by steps of `dt`, each in `substeps` equal parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    solver : str
        One of those in :mod:`lesson_code.engine.solvers` that have stages, by name.
    dt : float
        s, > 0.
    iterations : int
        Sweeps over the contacts in each sub-step.
    substeps : int
        Parts of a step; some solvers find contacts once for all of them.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    options : mapping from str to str
        Choices that the solver offers, such as "impacts".
    keep_impulses : bool
        Whether every impulse is written down.
    compiled : bool or None
        Whether the stages run as compiled code. They do the same to the last bit. None: if the run
        is large enough to repay it.
    effects : mapping, optional
        Effects to force on or to leave out, by name; see :mod:`lesson_code.engine.effects.choice`.
    duration : float
        s, how long the run will be; ``math.inf``: not yet known.
    splits_steps : bool
        Whether steps can be split at the impacts of fast bodies from the start; else they are once
        the first such body is met.

    Attributes
    ----------
    world : World
        The tables: lists of rows, or, when compiled, arrays of records.
    pipeline : Pipeline
        The stages.
    effects : tuple of EffectChoice
        What they reckon with, and why.
    choice : Choice
        Whether they are compiled, and why.

    Raises
    ------
    ValueError, TypeError
        An effect does not exist, the solver lacks it, or the scene needs what is to be left out;
        or the run cannot be compiled as was asked.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        solver: str,
        dt: float,
        iterations: int,
        substeps: int,
        combine: MixingRule,
        options: Mapping[str, str] = NO_OPTIONS,
        keep_impulses: bool = True,
        compiled: bool | None = False,
        effects: Mapping[str, bool] | None = None,
        duration: float = math.inf,
        splits_steps: bool = False,
    ) -> None:
        self.dt = dt
        self._solver = our_solvers()[solver]
        self._options = options
        self._steps_a_step = 1 if self._solver.shares_contacts else substeps
        self._question = Question(
            scene, solver, dt / self._steps_a_step, duration, combine, self._solver.skin
        )
        self._asked = effects if keep_impulses else {**(effects or {}), "impulse_record": False}
        self._changes: list[str] = []
        self.effects = choose_effects(self._question, self._asked)
        stages = pipeline_for(scene, self._solver, self.effects, self._options)
        self.pipeline = stages._replace(splits_steps=splits_steps)
        self.world = world_of(
            scene, dt / self._steps_a_step, iterations, combine, self._solver.skin
        )
        self.world.state.substeps = substeps
        self._rows = self.world
        self._steps_planned = duration / dt
        self._steps_made = 0
        self._events: list[NDArray[np.float64]] = []
        steps = 0.0 if math.isinf(duration) else self._steps_a_step * duration / dt
        program = partial(source_of, self.pipeline)
        self.choice = choose_code(scene, self._solver, steps, iterations, compiled, program)
        self._compiled = self.choice.compiled
        if self._compiled:
            self._compile()

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run so far, with the reason for the choice of this solver."""
        pipeline = self.pipeline._replace(listener=None)
        return Plan(
            self._question.solver,
            reason,
            self.choice.code,
            self.choice.reason,
            self.effects,
            tuple(self._changes),
            partial(source_of, pipeline),
        )

    def advance(self, steps: int) -> None:
        """Advance by `steps` steps of dt.

        Raises
        ------
        FloatingPointError
            A body has left the range of floating point.
        ValueError
            The bodies overlap in so many pairs that no memory would hold them; or the run was
            planned to be shorter, and what it leaves out might be called for after its end.
        """
        self._refuse_beyond_the_end(steps)
        listener = self.pipeline.listener
        if not isinstance(listener, TouchListener):
            self._advance(steps)
            return
        for _ in range(steps):
            self._advance(1)
            if (gravity := listener.new_gravity()) is not None:
                self.set_gravity(gravity)

    def _refuse_beyond_the_end(self, steps: int) -> None:
        """Raise a ValueError if so many more steps are not in the run; the last may be a part."""
        made = self._steps_made + steps
        if made >= self._steps_planned + 1:
            raise ValueError(
                f"steps must end within the run, which was planned for {self._steps_planned:g} "
                f"steps, got {made} in all"
            )
        self._steps_made = made

    def set_gravity(self, gravity: tuple[float, float]) -> None:
        """Let another gravity act from now on, m/s^2, and plan anew what the scene calls for."""
        state = self.world.state
        state.gravity_x, state.gravity_y = gravity
        before = names_used(self.effects)
        scene = scene_at(self._question.scene, self.states(), gravity)
        self._question = replace(self._question, scene=scene)
        self.effects = choose_effects(self._question, self._asked)
        stages = pipeline_for(scene, self._solver, self.effects, self._options)
        self.pipeline = stages._replace(
            listener=self.pipeline.listener,
            splits_steps=self.pipeline.splits_steps,
        )
        if self._compiled:
            self._compile()
        after = names_used(self.effects)
        self._changes.append(_change(state.time, gravity, after - before, before - after))

    def _advance(self, steps: int) -> None:
        """Make `steps` steps of dt with the stages as they are."""
        self.world.state.steps_left = steps * self._steps_a_step
        while not self._run():
            self._clear_the_way()

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        if self._compiled:
            columns = [self.column(name) for name in STATE_FIELDS]
            return np.array(columns, dtype=float).T.reshape(-1, STATE_NUMBERS)
        rows = [state_of(row) for row in self.world.bodies]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states that a shorter step leads to, shape (N, 6); nothing else changes."""
        if duration <= 0.0:
            return self.states()
        world, pipeline, events = self.world, self.pipeline, list(self._events)
        self.world, self.pipeline = copy_of(world), pipeline._replace(listener=None)
        self.world.state.whole = duration / self._steps_a_step
        self._advance(1)
        states = self.states()
        self.world, self.pipeline, self._events = world, pipeline, events
        return states

    def row(self, number: int) -> Any:
        """Return a body's row, or its record, which has the same fields and can be changed."""
        bodies: Any = self.world.bodies
        return bodies.view(np.recarray)[number] if self._compiled else bodies[number]

    def column(self, name: str) -> Any:
        """Return a field of all bodies; what a program does not name it has not changed."""
        bodies: Any = self.world.bodies
        if self._compiled and name in bodies.dtype.names:
            return bodies[name]
        return [getattr(body, name) for body in self._rows.bodies]

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10)."""
        self._take_impulses()
        return np.concatenate([np.empty((0, EVENT_NUMBERS)), *self._events])

    def take_events(self) -> NDArray[np.float64]:
        """Return the impulses since they were last taken, shape (K, 10), and forget them."""
        events = self.events()
        self._events.clear()
        return events

    def _run(self) -> bool:
        """Make the steps that are left; return whether all are made."""
        if self._compiled:
            return bool(self._program(self.world))
        return advance(self.world, self.pipeline)

    def _clear_the_way(self) -> None:
        """Remove the obstacle that has stopped a run."""
        state = self.world.state
        if state.lost_body >= 0:
            raise FloatingPointError(f"body {state.lost_body} has left the range of floating point")
        if state.has_fast:
            state.has_fast = False
            self.pipeline = self.pipeline._replace(splits_steps=True)
            if self._compiled:
                self._compile()
        self._take_impulses()
        self.world = add_capacity(self.world)

    def _compile(self) -> None:
        """Compile the stages.

        Those that split a step at an impact are half of all the source, and few scenes need them:
        they are added when the first fast body is met.
        """
        source = source_of(self.pipeline)
        self._program = compiled_function(source, "advance")
        self.world = as_arrays(self.world, source, self._rows)

    def _take_impulses(self) -> None:
        """Take the impulses out of their table."""
        state = self.world.state
        if state.impulse_count > 0:
            self._events.append(as_numbers(self.world.impulses[: state.impulse_count]))
            state.impulse_count = 0


def _change(time: float, gravity: tuple[float, float], more: set[str], fewer: set[str]) -> str:
    """Return what has changed in a run, in words."""
    parts = [f"from {time:g} s on g = ({gravity[0]:g}, {gravity[1]:g}) m/s^2"]
    parts += [f"{name} is used" for name in sorted(more)]
    parts += [f"{name} is left out" for name in sorted(fewer)]
    return "; ".join(parts)

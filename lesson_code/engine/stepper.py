"""The engine at work on one scene: its tables, its stages, and a record of its impulses."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from contextlib import closing, nullcontext
from copy import copy, deepcopy
from dataclasses import replace
from functools import partial
from operator import attrgetter
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.any_scene import SOLVERS, program_for_any_scene
from lesson_code.engine.compiled import (
    Code,
    Program,
    another,
    as_arrays,
    as_rows,
    column,
    copy_of,
    full_rows,
    link,
    program_of,
)
from lesson_code.engine.compiled.loader import Entry
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.frames import (
    STATE_FIELDS,
    STATE_NUMBERS,
    Frames,
    frames_at_once,
    given_back,
)
from lesson_code.engine.core.impulse_table import ImpulseTable
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.one_thread import one_thread
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.plan import EffectChoice, Plan
from lesson_code.engine.core.recording import Stepper, record
from lesson_code.engine.core.rows import State, World
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene, scene_at
from lesson_code.engine.core.sight import Sight
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.engine.core.step import advance
from lesson_code.engine.core.tables import BROAD_PHASES, arrays_of
from lesson_code.engine.effects.callbacks import TouchListener
from lesson_code.engine.effects.choice import (
    choose_effects,
    flags_of,
    names_used,
    suit_any_scene,
)
from lesson_code.engine.effects.continuous import most_impacts
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.solvers.choice import passes_only_blows

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

BODY_SECONDS, CONTACT_SECONDS, VISIT_SECONDS = 3e-6, 8e-6, 2e-6
"""s, of plain Python: for a body in a step, for a contact in it, and for each visit to that; on
the machine whose speed :mod:`lesson_code.engine.compiled.choice` compares with."""

SOFT_VISITS = 8
"""Visits that a soft contact takes as much time for as it does in a sub-step with one sweep."""

CONTACTS_OF_A_DISC, CONTACTS_OF_A_POLYGON = 1.5, 3.0
"""In a pile, about; without gravity there are few."""


def why_never(scene: Scene, solver: Solver) -> str:
    """Return why a run cannot be compiled, in words; "" when it can."""
    callbacks = "callbacks are Python functions" if scene.callbacks.wanted else ""
    return solver.never_compiled or callbacks


def plain_seconds(scene: Scene, steps: float, visits: int) -> float:
    """Return about how long plain Python takes for a run, s; see :mod:`compiled.choice`."""
    contacts = 0.0
    if any(scene.gravity):
        polygons = int(scene.columns.has_corners.sum())
        discs = len(scene.bodies) - polygons
        contacts = CONTACTS_OF_A_DISC * discs + CONTACTS_OF_A_POLYGON * polygons
    in_contact = CONTACT_SECONDS + visits * VISIT_SECONDS
    return steps * (len(scene.bodies) * BODY_SECONDS + contacts * in_contact)


def run_in_steps(asked: Request, solver: Solver) -> Run:
    """Let the engine step a scene by a solver's stages.

    All of the scene is known here. What is stepped by hand, in a program or in a page, has springs:
    something that takes energy may come.
    """
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
    with closing(stepper):
        stepper.world.state.only_blows = stepper.needs_no_springs()
        run = record(stepper, asked.scene, asked.duration, asked.sample, asked.reason)
        warn_of_late_steps(stepper.world.state)
    return run


def warn_of_late_steps(state: State) -> None:
    """Say that bodies have stood still where they should have flown, if any have."""
    if state.late_steps > 0:
        warnings.warn(
            f"in {state.late_steps} of {state.steps_done} steps there were more than "
            f"{most_impacts(state)} impacts: fast bodies stood still for the rest of them, and are "
            "late; a smaller dt loses less time",
            RuntimeWarning,
            stacklevel=5,  # where `simulate` was called
        )


class EngineStepper(Stepper):
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
        Whether the stages run as compiled code. They do the same to the last bit. None: where that
        saves time, perhaps from some step on; then :meth:`close` it when it is no longer needed.
    effects : mapping, optional
        Effects to force on or to leave out, by name; see :mod:`lesson_code.engine.effects.choice`.
    duration : float
        s, how long the run will be; ``math.inf``: not yet known.
    splits_steps : bool
        Whether steps can be split at the impacts of fast bodies from the start; else they are once
        the first such body is met.
    shares_contacts : bool, optional
        Whether sub-steps share the contacts of their step; None: as its solver has it.
    sight : Sight, optional
        From where on contacts are seen, and how far a body may move in a step unwatched; None: as
        its solver has it.

    Attributes
    ----------
    world : World
        The tables: lists of rows, or, when compiled, arrays of records.
    pipeline : Pipeline
        The stages.
    effects : tuple of EffectChoice
        What they reckon with, and why.

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
        shares_contacts: bool | None = None,
        sight: Sight | None = None,
    ) -> None:
        self.dt = dt
        self._solver = our_solvers()[solver]
        self._options = options
        shares = self._solver.shares_contacts if shares_contacts is None else shares_contacts
        self._steps_a_step = 1 if shares else substeps
        sight = sight or self._solver.sight
        self._question = Question(scene, solver, dt / self._steps_a_step, duration, combine, sight)
        self._asked = effects if keep_impulses else {**(effects or {}), "impulse_record": False}
        self._changes: list[str] = []
        self.effects = choose_effects(self._question, self._asked)
        stages = pipeline_for(scene, self._solver, self.effects, self._options)
        self.pipeline = stages._replace(splits_steps=splits_steps)
        self.world = arrays_of(scene, dt / self._steps_a_step, iterations, combine, sight)
        self.world.state.substeps = substeps // self._steps_a_step
        self._rows = self.world
        self._steps_planned = duration / dt
        self._steps_made = 0
        self._impulses = ImpulseTable()
        self._entry: Entry | None = None
        self._code = Code(compiled, why_never(scene, self._solver))
        self._choose_code()

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run so far, with the reason for the choice of this solver."""
        pipeline = self.pipeline._replace(listener=None)
        return Plan(
            self._question.solver,
            reason,
            *self._code.choice,
            self.effects,
            tuple(self._changes),
            partial(source_of, pipeline),
        )

    def program(self) -> Program:
        """Return the program that the stages make: with what the scene calls for, no more."""
        return program_of(source_of(self.pipeline), "advance", World)

    @property
    def solver(self) -> str:
        """The name of its solver."""
        return self._solver.name

    def compile(self) -> None:
        """Go on in machine code; compile it and wait for that where none is kept."""
        self._code.close()
        self._code = Code(True, why_never(self._question.scene, self._solver))
        self._choose_code()

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
        caller = listener if isinstance(listener, TouchListener) else None
        while steps > 0:
            at_once = 1 if caller or self._may_change_code() else steps
            self._advance(at_once)
            self._steps_made += at_once
            steps -= at_once
            if caller and (gravity := caller.new_gravity()) is not None:
                self.set_gravity(gravity)
            self._look_at_code()

    def twin(self) -> EngineStepper:
        """Return a stepper that goes on from here on its own; what is compiled serves both."""
        other = copy(self)
        other.world = copy_of(self.world)
        other._rows = other.world if self._rows is self.world else self._rows
        other._impulses = deepcopy(self._impulses)
        return other

    def close(self) -> None:
        """End the run: a process that still compiles for it ends too, unless it is nearly done."""
        self._code.close()

    def _refuse_beyond_the_end(self, steps: int) -> None:
        """Raise a ValueError if so many more steps are not in the run; the last may be a part."""
        made = self._steps_made + steps
        if made >= self._steps_planned + 1:
            raise ValueError(
                f"steps must end within the run, which was planned for {self._steps_planned:g} "
                f"steps, got {made} in all"
            )

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
        self._choose_code()
        after = names_used(self.effects)
        self._changes.append(_change(state.time, gravity, after - before, before - after))

    def needs_no_springs(self) -> bool:
        """Return whether contacts need none of the springs that its solver has, as the scene is."""
        has_springs = self._solver.shares_contacts and self.pipeline.effects.restitution
        return has_springs and passes_only_blows(self._question)

    def _advance(self, steps: int) -> None:
        """Make `steps` steps of dt with the stages as they are."""
        self.world.state.steps_left = steps * self._steps_a_step
        with one_thread() if self._solver.has_matrices else nullcontext():
            while not self._run():
                self._clear_the_way()

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        if self._compiled:
            columns = [self.column(name) for name in STATE_FIELDS]
            return np.array(columns, dtype=float).T.reshape(-1, STATE_NUMBERS)
        rows = [state_of(row) for row in self.world.bodies]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def note_steps(self, steps: int, frames: Frames, first: int) -> None:
        """Advance by `steps` steps; the program notes the states after each, as frames."""
        if self.pipeline.listener is not None:  # callbacks may change what the scene calls for
            super().note_steps(steps, frames, first)
            return
        last, bodies = first + steps, len(self.world.bodies)
        rotation = self.pipeline.effects.rotation
        while first < last:
            at_once = frames_at_once(bodies, is_plain=not self._compiled)
            block = slice(first, min(first + at_once, last))
            if not rotation:
                frames.stay_turned(block, self.column("angle"), self.column("w"))
            self.world = frames.lend(block, self.world)
            self.world.state.steps_a_frame = self._steps_a_step
            self.advance(block.stop - first)
            self.world.state.steps_a_frame = self.world.state.frame_rows = 0
            frames.take(block, self.world, rotation=rotation)
            frames.require_numbers(block, rotation=rotation)
            self.world = given_back(self.world)
            first = block.stop

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states that a shorter step leads to, shape (N, 6); nothing else changes."""
        if duration <= 0.0:
            return self.states()
        before, impulses = (self.world, self._rows, self.pipeline, self._entry), len(self._impulses)
        self.world, self.pipeline = copy_of(self.world), self.pipeline._replace(listener=None)
        self.world.state.whole = duration / self._steps_a_step
        self._advance(1)
        states = self.states()
        self.world, self._rows, self.pipeline, self._entry = before
        self._impulses.forget_from(impulses)
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
        return column(self._rows.bodies, name)

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10)."""
        return self.impulses().rows()

    def impulses(self) -> ImpulseTable:
        """Return the impulses of all steps so far, as they were written down."""
        self._take_impulses()
        return self._impulses

    def take_events(self) -> NDArray[np.float64]:
        """Return the impulses since they were last taken, shape (K, 10), and forget them."""
        state, taken = self.world.state, self._impulses
        taken.add(self.world.impulses[: state.impulse_count])
        self._impulses, state.impulse_count = ImpulseTable(), 0
        return taken.rows()

    def _run(self) -> bool:
        """Make the steps that are left; return whether all are made."""
        if self._entry is not None:
            return bool(self._entry(self.world))
        return advance(self.world, self.pipeline)

    def _clear_the_way(self) -> None:
        """Remove the obstacle that has stopped a run."""
        state = self.world.state
        if state.lost_body >= 0:
            raise FloatingPointError(f"body {state.lost_body} has left the range of floating point")
        if state.has_fast:
            state.has_fast = False
            self.pipeline = self.pipeline._replace(splits_steps=True)
            self._choose_code()
        self._take_impulses()
        self.world = add_capacity(self.world)

    @property
    def _compiled(self) -> bool:
        """Whether the tables are arrays of records, for machine code."""
        return self._entry is not None

    def _choose_code(self) -> None:
        """Choose what the stages, as they are now, are run in.

        Those that split a step at an impact are half of all the source, and few scenes need them:
        they are added when the first fast body is met, and make another program.
        """
        steps = self._steps_planned - self._steps_made
        steps = 0.0 if math.isinf(steps) else self._steps_a_step * steps
        state, scene = self.world.state, self._question.scene
        soft = SOFT_VISITS * state.substeps if self._solver.shares_contacts else 1
        seconds = plain_seconds(scene, steps, soft * state.iterations)
        entry = self._code.begin(self.program, seconds, self._now(), self.program_for_any)
        self._change_to(entry)

    def program_for_any(self) -> Program | None:
        """Return a program for any scene that does what this run asks for; None: none does."""
        if self.solver not in SOLVERS or not suit_any_scene(self.effects):
            return None
        return program_for_any_scene(self.solver, sleeping=self.pipeline.effects.sleeping)

    def _now(self) -> str:
        """Return which step comes next, in words; "" before the first."""
        return f"step {self._steps_made + 1}" if self._steps_made else ""

    def _may_change_code(self) -> bool:
        """Whether plain Python runs, and machine code may take over on the way."""
        return self._entry is None and self._code.may_change

    def _look_at_code(self) -> None:
        """Go on in machine code if that is there now."""
        if self._may_change_code():
            ahead = (self._steps_planned - self._steps_made) / self._steps_made
            entry = self._code.look(self.program, ahead, self._now(), self.program_for_any)
            if entry is not None:
                self._change_to(entry)

    def _change_to(self, entry: Entry | None) -> None:
        """Go on with machine code for the stages as they are, or without."""
        if entry is not None:
            if self._entry is None:
                self._rows = self.world
            self.world = as_arrays(self.world, entry.program.source, self._rows)
        else:
            if self._entry is not None:
                self.world = as_rows(self.world, full_rows(self._rows))
            self.world = self._rows = full_rows(self.world)
        self._entry = entry

    def _take_impulses(self) -> None:
        """Take the impulses out of their table, and give the program another one."""
        state, full = self.world.state, self.world.impulses
        if state.impulse_count > 0:
            self._impulses.add(full[: state.impulse_count])
            self.world = self.world._replace(impulses=another(full))
            state.impulse_count = 0


def _change(time: float, gravity: tuple[float, float], more: set[str], fewer: set[str]) -> str:
    """Return what has changed in a run, in words."""
    parts = [f"from {time:g} s on g = ({gravity[0]:g}, {gravity[1]:g}) m/s^2"]
    parts += [f"{name} is used" for name in sorted(more)]
    parts += [f"{name} is left out" for name in sorted(fewer)]
    return "; ".join(parts)

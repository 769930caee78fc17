"""The engine at work on one scene: its tables, its stages, and a record of its impulses."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine import contact_solver, naive_solver, substep_solver
from lesson_code.engine.combination import Combination
from lesson_code.engine.compiled import (
    Choice,
    as_arrays,
    as_numbers,
    choose,
    compiled_function,
    link,
)
from lesson_code.engine.continuous import advance, rigid_part
from lesson_code.engine.direct_solver import direct_solver
from lesson_code.engine.effects import effects_of
from lesson_code.engine.recording import EVENT_NUMBERS, STATE_NUMBERS
from lesson_code.engine.room import make_room
from lesson_code.engine.scene import Scene
from lesson_code.engine.soft_step import soft_part
from lesson_code.engine.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.touches import TouchListener
from lesson_code.engine.world import ContactSolver, Pipeline

SOLVERS = {
    "sequential": ContactSolver(
        contact_solver.prepare,
        contact_solver.warm_start,
        contact_solver.solve,
        contact_solver.has_overlap_to_undo,
        contact_solver.correct,
        contact_solver.store,
    ),
    "substep": ContactSolver(
        substep_solver.prepare,
        substep_solver.warm_start,
        substep_solver.solve,
        contact_solver.has_overlap_to_undo,
        substep_solver.correct,
        substep_solver.store,
    ),
    "naive": ContactSolver(
        naive_solver.prepare,
        naive_solver.warm_start,
        naive_solver.solve,
        naive_solver.has_overlap_to_undo,
        naive_solver.correct,
        naive_solver.store,
    ),
    "direct": direct_solver("simultaneous", "newton"),
}
"""The engine's contact solvers, by name."""


STATE_FIELDS = ["x", "y", "angle", "vx", "vy", "w"]
"""The fields of a body's row that are its state."""


def pipeline_for(scene: Scene, solver: str, keep_impulses: bool) -> Pipeline:
    """Return the stages that a scene is run by."""
    return Pipeline(
        make_part=soft_part if solver == "substep" else rigid_part,
        broad_phase=BROAD_PHASES[broad_phase_for(scene)],
        solver=SOLVERS[solver],
        listener=TouchListener(scene.callbacks) if scene.callbacks.wanted else None,
        effects=effects_of(scene),
        is_continuous=solver != "naive",
        keeps_impulses=keep_impulses,
    )


BODY_SECONDS, VISIT_SECONDS = 8e-6, 4e-6
"""s, of plain Python: for a body in a step, and for a visit to a contact."""

CONTACTS_PER_BODY = 2
"""In a pile, about; without gravity there are few."""


def choose_code(
    scene: Scene, solver: str, steps: float, iterations: int, asked: bool | None
) -> Choice:
    """Return whether to compile a run, from what has been asked for or from the work there is."""
    visits = CONTACTS_PER_BODY * iterations if any(scene.gravity) else 0
    seconds = steps * len(scene.bodies) * (BODY_SECONDS + visits * VISIT_SECONDS)
    never = "callbacks are Python functions" if scene.callbacks.wanted else ""
    if solver == "direct":
        never = "the direct solver works on arrays of its own"
    pipeline = pipeline_for(scene, solver, keep_impulses=True)
    program = partial(link, advance, pipeline=pipeline._replace(splits_steps=False))
    return choose(asked, seconds, program, never)


class EngineStepper:
    """A scene that the engine advances by steps of `dt`, each in `substeps` equal parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    solver : str
        "sequential", "substep", "direct" or "naive".
    dt : float
        s, > 0.
    iterations : int
        Sweeps over the contacts in each sub-step.
    substeps : int
        Parts of a step; for "substep" with one finding of contacts for all of them.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    impacts, restitution_law : str
        How the direct solver treats impacts; the others know only the rules that are the default.
    keep_impulses : bool
        Whether every impulse is written down.
    compiled : bool
        Whether the stages run as compiled code. They do the same to the last bit.

    Attributes
    ----------
    world : World
        The tables: lists of rows, or, when compiled, arrays of records.
    pipeline : Pipeline
        The stages.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        solver: str,
        dt: float,
        iterations: int,
        substeps: int,
        combine: Combination,
        impacts: str = "simultaneous",
        restitution_law: str = "newton",
        keep_impulses: bool = True,
        compiled: bool = False,
    ) -> None:
        self.dt = dt
        self._steps_a_step = 1 if solver == "substep" else substeps
        self.pipeline = pipeline_for(scene, solver, keep_impulses)
        if solver == "direct":
            rules = direct_solver(impacts, restitution_law)
            self.pipeline = self.pipeline._replace(solver=rules)
        self.world = world_of(scene, dt / self._steps_a_step, iterations, combine)
        self.world.state.substeps = substeps
        self._compiled = compiled
        self._events: list[NDArray[np.float64]] = []
        if compiled:
            self._compile(splits_steps=False)

    def advance(self, steps: int) -> None:
        """Advance by so many steps of dt.

        Raises
        ------
        FloatingPointError
            A body has left the range of floating point.
        ValueError
            The bodies overlap in so many pairs that no memory would hold them.
        """
        self.world.state.steps_left = steps * self._steps_a_step
        while not self._run():
            self._clear_the_way()

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        if self._compiled:
            bodies: Any = self.world.bodies
            return np.column_stack([bodies[name] for name in STATE_FIELDS])
        rows = [[getattr(body, name) for name in STATE_FIELDS] for body in self.world.bodies]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10)."""
        self._take_impulses()
        return np.concatenate([np.empty((0, EVENT_NUMBERS)), *self._events])

    def _run(self) -> bool:
        """Make the steps that are left; return whether all are made."""
        if self._compiled:
            return bool(self._program(self.world))
        return advance(self.world, self.pipeline)

    def _clear_the_way(self) -> None:
        """Do away with what has stopped a run."""
        state = self.world.state
        if state.lost_body >= 0:
            raise FloatingPointError(f"body {state.lost_body} has left the range of floating point")
        if state.has_fast:
            state.has_fast = False
            self._compile(splits_steps=True)
        self._take_impulses()
        self.world = make_room(self.world)

    def _compile(self, *, splits_steps: bool) -> None:
        """Compile the stages, with or without those that split a step at an impact.

        These are half of all the source, and few scenes need them: they are added when the first
        fast body is met.
        """
        self.pipeline = self.pipeline._replace(splits_steps=splits_steps)
        source = link(advance, pipeline=self.pipeline)
        self._program = compiled_function(source, "advance")
        self.world = as_arrays(self.world, source)

    def _take_impulses(self) -> None:
        """Take the impulses out of their table."""
        state = self.world.state
        if state.impulse_count > 0:
            self._events.append(as_numbers(self.world.impulses[: state.impulse_count]))
            state.impulse_count = 0

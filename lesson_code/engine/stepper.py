"""The engine at work on one scene: its tables, its stages, and a record of its impulses."""

from __future__ import annotations

from dataclasses import astuple

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine import contact_solver, naive_solver
from lesson_code.engine.combination import Combination
from lesson_code.engine.continuous import advance
from lesson_code.engine.recording import EVENT_NUMBERS, STATE_NUMBERS
from lesson_code.engine.room import make_room
from lesson_code.engine.scene import Scene
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
    "naive": ContactSolver(
        naive_solver.prepare,
        naive_solver.warm_start,
        naive_solver.solve,
        naive_solver.has_overlap_to_undo,
        naive_solver.correct,
        naive_solver.store,
    ),
}
"""The engine's contact solvers, by name."""


class EngineStepper:
    """A scene that the engine advances by steps of `dt`, each in `substeps` equal parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    solver : str
        "sequential" or "naive".
    dt : float
        s, > 0.
    iterations : int
        Sweeps over the contacts in each sub-step.
    substeps : int
        Parts of a step.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    keep_impulses : bool
        Whether every impulse is written down.
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
        keep_impulses: bool = True,
    ) -> None:
        self.dt = dt
        self.world = world_of(scene, dt / substeps, iterations, combine)
        self.pipeline = Pipeline(
            broad_phase=BROAD_PHASES[broad_phase_for(scene)],
            solver=SOLVERS[solver],
            listener=TouchListener(scene.callbacks) if scene.callbacks.wanted else None,
            is_continuous=solver != "naive",
            keeps_impulses=keep_impulses,
        )
        self._substeps = substeps
        self._events: list[NDArray[np.float64]] = []

    def advance(self, steps: int) -> None:
        """Advance by so many steps of dt.

        Raises
        ------
        FloatingPointError
            A body has left the range of floating point.
        ValueError
            The bodies overlap in so many pairs that no memory would hold them.
        """
        state = self.world.state
        state.steps_left = steps * self._substeps
        while not advance(self.world, self.pipeline):
            if state.lost_body >= 0:
                raise FloatingPointError(
                    f"body {state.lost_body} has left the range of floating point"
                )
            self._take_impulses()
            make_room(self.world)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        rows = [(b.x, b.y, b.angle, b.vx, b.vy, b.w) for b in self.world.bodies]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10)."""
        self._take_impulses()
        return np.concatenate([np.empty((0, EVENT_NUMBERS)), *self._events])

    def _take_impulses(self) -> None:
        """Take the impulses out of their table."""
        state, table = self.world.state, self.world.impulses
        if state.impulse_count > 0:
            rows = [astuple(row) for row in table[: state.impulse_count]]
            self._events.append(np.array(rows))
            state.impulse_count = 0

"""The engine at work on one scene: its tables, its stages, and a record of its impulses."""

from __future__ import annotations

from lesson_code.engine import contact_solver, naive_solver
from lesson_code.engine.combination import Combination
from lesson_code.engine.contact_motion import contact_point
from lesson_code.engine.continuous import begin_step, step_to_impacts
from lesson_code.engine.direct_solver import direct_solver
from lesson_code.engine.recording import Event
from lesson_code.engine.scene import Scene
from lesson_code.engine.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.touches import TouchListener
from lesson_code.engine.world import ContactSolver, step

SOLVERS = {
    "sequential": ContactSolver(
        contact_solver.prepare,
        contact_solver.warm_start,
        contact_solver.solve,
        contact_solver.correct,
        contact_solver.store,
    ),
    "naive": ContactSolver(
        naive_solver.prepare,
        naive_solver.warm_start,
        naive_solver.solve,
        naive_solver.correct,
        naive_solver.store,
    ),
    "direct": direct_solver("simultaneous", "newton"),
}
"""The engine's contact solvers, by name."""


class EngineStepper:
    """A scene that the engine advances by steps of `dt`, each in `substeps` equal parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    solver : str
        "sequential", "naive" or "direct".
    dt : float
        s, > 0.
    iterations : int
        Sweeps over the contacts in each sub-step.
    substeps : int
        Parts of a step.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    impacts, restitution_law : str
        How the direct solver treats impacts; the others know only the rules that are the default.
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
    ) -> None:
        self.dt = dt
        self.broad_phase = BROAD_PHASES[broad_phase_for(scene)]
        self._continuous = solver != "naive"
        self.world = world_of(scene, dt / substeps, iterations, combine)
        self._substeps = substeps
        self._solver = (
            direct_solver(impacts, restitution_law) if solver == "direct" else SOLVERS[solver]
        )
        self._listener = TouchListener(scene.callbacks) if scene.callbacks.wanted else None
        self._events: list[Event] = []
        self._substeps_done = 0

    def step(self) -> None:
        """Advance by dt."""
        state = self.world.state
        for _ in range(self._substeps):
            self._substeps_done += 1
            end = self._substeps_done * state.dt
            if self._continuous:
                self._step_to_impacts(end)
            else:
                state.time = end
                step(self.world, self.broad_phase, self._solver, self._listener)
                self._note_events()

    def _step_to_impacts(self, end: float) -> None:
        """Make one sub-step, split at the impacts of fast bodies."""
        begin_step(self.world, end)
        ended = False
        while not ended:
            ended = step_to_impacts(self.world, self.broad_phase, self._solver, self._listener)
            self._note_events()

    def states(self) -> list[tuple[float, float, float, float, float, float]]:
        """Return x, y, angle, vx, vy, w of every body."""
        return [(b.x, b.y, b.angle, b.vx, b.vy, b.w) for b in self.world.bodies]

    def events(self) -> list[Event]:
        """Return the impulses of all steps so far."""
        return self._events

    def _note_events(self) -> None:
        """Write down the contacts that have received an impulse."""
        time = self.world.state.time
        for c in self.world.contacts[: self.world.state.contact_count]:
            if c.normal_impulse != 0.0:
                x, y = contact_point(c, self.world.bodies[c.a], self.world.bodies[c.b])
                self._events.append(
                    (
                        *(time, c.a, c.b, x, y, c.nx, c.ny),
                        *(c.normal_impulse, c.tangent_impulse, c.penetration),
                    )
                )

"""Which solver moves a live world: one that breaks no law, where its steps fit into a frame.

1. Sweeps are asked for: the sequential solver makes them.
2. Few bodies: the direct solver. No law depends on its step.
3. Discs that fly, or fall and are perfectly elastic, so that none comes to rest: the exact solver,
   in which a frame of 600 discs takes less time than one of 20 in the direct solver.
4. Up to 64 bodies that nothing presses together: the direct solver.
5. Others: the solver with sub-steps, which gains no energy in a pile.

Its springs give way, but bodies hardly enter one another: here each sub-step searches for contacts
anew, and sees them before the bodies touch. Dominoes of 0.1 m by 0.6 m are 0.0002 m deep in one
another at the most; with one search a step it was 0.03 to 0.07 m. Of 500 discs with radii of 0.06
to 0.12 m that fall into a pit of 8 m none enters another one by more than 0.006 of the smaller
radius; sweeps would take a seventh of the time, and leave 0.12 m. It begins in plain Python, and
goes on in machine code as soon as that is there.
"""

from __future__ import annotations

from copy import copy
from weakref import finalize

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.columns import Floats
from lesson_code.engine.core.constants import MOST_DRIFTING, MOST_PRESSED
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.sight import Sight
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.engine.effects.question import Question
from lesson_code.engine.event_driven import ExactSolver, why_not
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.solvers.choice import SolverChoice, is_apart
from lesson_code.engine.stepper import EngineStepper

WORTH_COMPILING = 100
"""Discs that fly: plain Python moves fewer of them in half a frame."""

SWEEPS = 10
"""Of the sequential solver, unless others are asked for."""

ON_DEMAND = {"broad_phase", "callbacks"}
"""Effects that a world has not always: many bodies call for a grid, and callbacks hear of a step
after it."""

ANY_SCENE = {n: used for n, used in EVERY_EFFECT._asdict().items() if n not in ON_DEMAND}
"""The effects that a world reckons with: whatever joins it, its machine code stays the same."""

LIVE_SKIN = 0.25
"""Of a body's width: how far from its surface the solver with sub-steps sees contacts, and how far
one may move in a sub-step unwatched.

At 0.125 dominoes enter each other twice as deep, at 0.5 no less deep.
"""

SUBSTEPS, SOFT_SWEEPS = 12, 3
"""Of the solver with sub-steps: springs 27 times as stiff as with its usual 4 of one sweep. A crowd
of 17 to 59 discs and boxes of 0.1 to 0.2 m, thrown at up to 30 m/s, is then 0.005 m deep in one
another at the most, and not 0.010 m. A step takes 4 times as long."""

SWEEPS_ASKED = SolverChoice("sequential", "sweeps are asked for")


def flies(question: Question) -> bool:
    """Return whether discs fly from collision to collision, and never come to rest on anything."""
    scene = question.scene
    if why_not(scene) or scene.columns.has_mover or not scene.columns.is_free.any():
        return False
    least = question.facts.least_restitution
    return least >= 1.0 if any(scene.gravity) else least > 0.0


def solver_for(question: Question) -> SolverChoice:
    """Return the solver that moves a live world, and why.

    Examples
    --------
    >>> from lesson_code import Body, Circle
    >>> solver_for(Question(Scene([Body(Circle(1), mass=1.0)]))).solver
    'direct'
    """
    free = int(question.scene.columns.is_free.sum())
    if free <= MOST_PRESSED:
        return SolverChoice("direct", "few bodies: all contacts are solved at once")
    if flies(question):
        return SolverChoice("exact", "discs that fly: each collision comes at its own time")
    return stepped_solver_for(question.scene)


def stepped_solver_for(scene: Scene) -> SolverChoice:
    """Return the solver for a world that the exact one cannot take."""
    free = int(scene.columns.is_free.sum())
    if free <= (MOST_PRESSED if any(scene.gravity) else MOST_DRIFTING):
        return SolverChoice("direct", "so few bodies that all contacts are solved at once")
    return SolverChoice("substep", "many bodies: soft contacts gain no energy")


def has_program(solver: str) -> bool:
    """Return whether a solver's steps can be made in machine code."""
    return not our_solvers()[solver].never_compiled


def stepper_for(
    scene: Scene,
    solver: str,
    *,
    dt: float,
    iterations: int | None,
    combine: MixingRule,
    compiled: bool,
) -> EngineStepper:
    """Return the engine at the start of a scene.

    What can be compiled always has the grid, so that its program is the same for any number of
    bodies, and machine code can take over after any step.
    """
    made_by = our_solvers()[solver]
    sweeps, substeps = made_by.iterations, made_by.substeps
    if solver == "sequential":
        sweeps = iterations or SWEEPS
    elif solver == "substep":
        sweeps, substeps = SOFT_SWEEPS, SUBSTEPS
    return EngineStepper(
        scene,
        solver=solver,
        dt=dt,
        iterations=sweeps,
        substeps=substeps,
        combine=combine,
        compiled=compiled,
        effects=ANY_SCENE | ({"broad_phase": True} if has_program(solver) else {}),
        splits_steps=True,
        shares_contacts=False,
        sight=Sight(LIVE_SKIN, LIVE_SKIN) if solver == "substep" else None,
    )


class Flight:
    """A live world's discs while the exact solver moves them.

    Parameters
    ----------
    scene : Scene
        The bodies as they are.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    compiled : bool or None
        As for :class:`ExactSolver`.

    Attributes
    ----------
    time : float
        s since its start.

    Raises
    ------
    RuntimeError
        Bodies touch or overlap already.
    """

    def __init__(self, scene: Scene, combine: MixingRule, compiled: bool | None) -> None:
        if not is_apart(scene):
            raise RuntimeError("discs touch or overlap")
        self.solver = ExactSolver(scene, combine=combine, compiled=compiled)
        finalize(self, self.solver.close)  # a world may be dropped while something compiles for it
        self.time = 0.0

    def twin(self) -> Flight:
        """Return a flight that goes on from here on its own."""
        other = copy(self)
        other.solver = self.solver.twin()
        return other

    def advance(self, dt: float) -> tuple[NDArray[np.float64], Floats]:
        """Go on by a time, s; return the states, (N, 6), and the impulses on the way, (K, 10).

        The times of the impulses count from the start of the flight.

        Raises
        ------
        RuntimeError
            The collisions at one instant have no end.
        """
        self.time += dt
        self.solver.advance(self.time)
        return self.solver.states(self.time), self.solver.take_events()

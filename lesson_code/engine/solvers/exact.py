"""The exact solver: from collision to collision, with no time step (:mod:`event_driven`)."""

from __future__ import annotations

from contextlib import closing

from lesson_code.engine.core.constants import MOST_FOR_DIRECT
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.engine.effects.flags import NAMES
from lesson_code.engine.event_driven import ExactSolver, record_exact

_EXACT = "collisions are computed at their times, not seen after a step"

_HAS = {
    *("broad_phase", "collisions", "friction", "gravity"),
    *("impulse_record", "outlines", "restitution", "rotation"),
}


def run_scene(asked: Request) -> Run:
    """Run a scene from event to event."""
    solver = ExactSolver(
        asked.scene,
        combine=asked.combine,
        compiled=asked.compiled,
        duration=asked.duration,
        effects=asked.effects,
        stops_at_tie=asked.may_give_up and len(asked.scene.bodies) <= MOST_FOR_DIRECT,
    )
    with closing(solver):
        return record_exact(solver, asked.duration, asked.sample, asked.reason)


SOLVER = Solver(
    name="exact",
    run_scene=run_scene,
    gives_up="the exact solver finds no end, or no order, of the collisions",
    lacks=dict.fromkeys(sorted(set(NAMES) - _HAS), "it makes no steps, of which this is a stage")
    | {
        "manifolds": "discs touch at one point",
        "internal_edges": "at the end of a face a disc hops, onto the next one if there is one",
        "damping": "damped motion has no closed form here",
        "callbacks": "it calls none",
        "continuous": _EXACT,
        "warm_starting": "no contact lasts for a step: there are none",
        "position_correction": _EXACT,
        "sleeping": "a disc at rest has no events",
    },
)

"""pymunk as a solver."""

from __future__ import annotations

from lesson_code.engine.core.recording import record
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.reference.solvers import settings_of


def run_scene(asked: Request) -> Run:
    """Let pymunk step a scene."""
    settings = settings_of(asked, SOLVER)
    from lesson_code.reference.pymunk_reference import PymunkStepper

    stepper = PymunkStepper(asked.scene, **settings)
    return record(stepper, asked.scene, asked.duration, asked.sample, asked.reason)


SOLVER = Solver(name="pymunk", run_scene=run_scene)

"""Box2D as a solver."""

from __future__ import annotations

from lesson_code.engine.core.recording import record
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.reference.solvers import settings_of


def run_scene(asked: Request) -> Run:
    """Let Box2D step a scene."""
    settings = settings_of(asked, SOLVER)
    del settings["iterations"]  # there is nothing to set
    from lesson_code.reference.box2d_reference import Box2DStepper

    stepper = Box2DStepper(asked.scene, **settings)
    return record(stepper, asked.scene, asked.duration, asked.sample, asked.reason)


SOLVER = Solver(name="box2d", run_scene=run_scene, substeps=4, has_one_sweep=True)

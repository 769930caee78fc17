"""Work that does not depend on the machine: visits to contacts, and tests of pairs.

=============  =================================================================================
method         how it is counted
=============  =================================================================================
ours           after each step, from the engine's own tables: contacts times the sweeps over them,
               and candidate pairs. The sweeps that push overlaps apart are left out
exact          collisions; its forecasts are not counted
pymunk         contact points that it reports, times its iterations; it does not tell its pairs
box2d          not known: its binding tells neither its contacts nor its pairs
=============  =================================================================================

A visit of the direct solver is a row in a system of equations, and costs more the more there are.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.work_precision.methods import (
    Method,
    Setting,
    exact_solver,
    stepper,
)
from lesson_code.evidence.work_precision.scenes import PrecisionScene
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.reference.box2d_reference import Box2DStepper
from lesson_code.reference.pymunk_reference import PymunkStepper


class Work(NamedTuple):
    """Work of a whole run; nan: not known."""

    contact_solves: float = math.nan
    pair_tests: float = math.nan


def work_of(scene: PrecisionScene, method: Method, setting: Setting, *, compiled: bool) -> Work:
    """Return the work of a method in a scene; what is not known where it loses a body."""
    if method.name == "exact":
        solver = exact_solver(scene)
        solver.advance(scene.duration)
        return Work(contact_solves=solver.collisions)
    if method.name != "substep":  # its sub-steps share their contacts; those of the others do not
        setting = Setting(setting.dt / setting.substeps, setting.iterations, 1)
    steps = whole_parts(scene.duration, setting.dt)
    made = stepper(scene, method, setting, compiled=compiled)
    if isinstance(made, Box2DStepper):
        return Work()
    if isinstance(made, PymunkStepper):
        return _of_pymunk(made, steps, setting.iterations)
    try:
        return _of_ours(made, steps, setting.sweeps * method.sweeps_an_iteration)
    except FloatingPointError:
        return Work()


def _of_ours(made: EngineStepper, steps: int, sweeps: int) -> Work:
    """Return the sums of the tables' counts over all steps."""
    solves = tests = 0
    for _ in range(steps):
        made.advance(1)
        state: Any = made.world.state
        solves += int(state.contact_count) * sweeps
        tests += int(state.pair_count)
    return Work(solves, tests)


def _of_pymunk(made: PymunkStepper, steps: int, iterations: int) -> Work:
    """Return what pymunk reports after each of its steps: contact points, not the pairs tested."""
    points = 0

    def count(arbiter: Any, _space: Any, _data: Any) -> None:
        nonlocal points
        points += len(arbiter.contact_point_set.points)

    made.space.on_collision(None, None, post_solve=count)
    made.advance(steps)
    return Work(points * iterations)

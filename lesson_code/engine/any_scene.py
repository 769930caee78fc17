"""The programs that run any scene: with every effect, whatever a scene calls for.

A program with what a scene calls for, and nothing else, is up to a third faster, and takes half a
minute to be compiled. These come ready-made (:mod:`lesson_code.engine.compiled.ready_made`), and
give the same bits. Only sleep may change the last ones: what lets bodies sleep has its own program.
"""

from __future__ import annotations

from functools import cache

from lesson_code.engine.compiled import Program, link, program_of
from lesson_code.engine.core.broad_phase import uniform_grid
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.rows import World
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.core.step import advance
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.engine.event_driven.solver import program_for_any_scene as program_for_discs
from lesson_code.engine.solvers import our_solvers

SOLVERS = ("sequential", "substep")
"""Those that make steps and have such a program."""


def stages_for_any_scene(solver: Solver, *, sleeping: bool = False) -> Pipeline:
    """Return the stages of a solver for any scene: every effect but callbacks."""
    effects = EVERY_EFFECT._replace(sleeping=sleeping)
    return Pipeline(solver.make_part, uniform_grid, solver.stages_for({}), effects=effects)


@cache
def program_for_any_scene(solver: str, *, sleeping: bool = False) -> Program:
    """Return the program of a solver, by name: of one that makes steps, or of the exact one.

    >>> program_for_any_scene("substep").entry
    'advance'
    """
    if solver == "exact":
        return program_for_discs()
    stages = stages_for_any_scene(our_solvers()[solver], sleeping=sleeping)
    return program_of(link(advance, pipeline=stages), "advance", World)

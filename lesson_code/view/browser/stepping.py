"""The stepped engine as a program for pages: it steps any scene, with every effect of a step.

Where a table is too small the program stops and says how many rows it wants. ``program.js`` adds
them by the rules of :mod:`lesson_code.engine.core.capacity`, which the program tells it.
"""

from __future__ import annotations

from typing import Any

from lesson_code.engine.any_scene import stages_for_any_scene
from lesson_code.engine.compiled.webassembly import WebProgram, table_program
from lesson_code.engine.core import capacity
from lesson_code.engine.core.constants import MOST_COLOURS, PAIRS_ANYWAY, PAIRS_PER_BODY
from lesson_code.engine.core.mixing import RULES, MixingRule
from lesson_code.engine.core.rows import State, World
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.core.step import advance
from lesson_code.engine.core.tables import world_of
from lesson_code.view.browser.set_up import FAULTS, set_up


def stepped_program(solver: Solver) -> WebProgram:
    """Return the program of a solver."""
    program = table_program(World, set_up, advance, pipeline=stages_for_any_scene(solver))
    return program.telling(capacity=capacity_rules(), scene=scene_rules(solver))


def scene_rules(solver: Solver) -> dict[str, Any]:
    """Return what a page has to know to write down a scene for a solver.

    >>> from lesson_code.engine.solvers.substep import SOLVER
    >>> scene_rules(SOLVER)["usual"]["substeps"]
    4
    """
    usual = {
        "dt": 1 / 60,
        "iterations": solver.iterations,
        "substeps": solver.substeps,
        "skin": solver.sight.skin,
        "restitution": MixingRule().restitution,
        "friction": MixingRule().friction,
    }
    return {"usual": usual, "mixing": RULES, "faults": FAULTS, "colours": 2 * MOST_COLOURS}


def capacity_rules() -> dict[str, Any]:
    """Return which tables grow when a field of the state wants rows, and by how much.

    >>> capacity_rules()["wanted"]["contacts_wanted"]
    ['contacts', 'visits', 'static_contacts', 'memory', 'resting']
    """
    wanted = [name for name in State.__slots__ if name.endswith("_wanted")]
    return {
        "wanted": {name: _tables_that_grow(name) for name in wanted},
        "spare": capacity.SPARE,
        "large": capacity.LARGE,
        "large_spare": capacity.LARGE_SPARE,
        "fewest_rows": capacity.FEWEST_ROWS,
        "pairs_per_body": PAIRS_PER_BODY,
        "pairs_anyway": PAIRS_ANYWAY,
    }


def _tables_that_grow(wanted: str) -> list[str]:
    """Return the names of the tables that get rows when a field of the state wants some."""
    world = world_of(Scene(), dt=1.0, iterations=1, combine=MixingRule())
    before = {name: len(table) for name, table in _lists(world)}
    setattr(world.state, wanted, 1)
    grown = capacity.add_capacity(world)
    return [name for name, table in _lists(grown) if len(table) > before[name]]


def _lists(world: World) -> list[tuple[str, list[Any]]]:
    """Return the tables of a world that can grow, with their names."""
    return [(name, table) for name, table in world._asdict().items() if isinstance(table, list)]

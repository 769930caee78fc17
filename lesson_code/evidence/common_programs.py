"""The programs of most large runs, compiled in the background before anybody wants them.

`workbook open` has all of them compiled, and the menu of `workbook play` those of live worlds.

A program holds what a scene calls for, and nothing else. So one scene stands for all of its kind:
a gas, discs and boxes that fall or stand, and the world of `workbook play`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator

from lesson_code.engine.compiled import Program
from lesson_code.engine.compiled.compiler import Compiling
from lesson_code.engine.compiled.library import is_kept, why_no_compiler
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.live_solver import program_for
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, box_pyramid
from lesson_code.evidence.scenes.speed import DT, bin_of_shapes
from lesson_code.geometry.shapes import Circle, Segment

MANY = 200
"""Bodies: so many that a scene calls for a grid, and for the solver that sweeps."""

DURATION = 10.0
"""s, of such a run: long enough for bodies to fall asleep."""

ROWS = 20
"""Of a pyramid, for as many."""


def programs_to_compile() -> list[Program]:
    """Return the common programs that are not kept; none where nothing can be compiled."""
    return _not_kept(common_programs)


def live_programs_to_compile() -> list[Program]:
    """Return those of them by which the worlds of `workbook play` go on."""
    return _not_kept(live_programs)


def _not_kept(programs: Callable[[], Iterable[Program]]) -> list[Program]:
    """Return the programs that are not kept; none where nothing can be compiled."""
    if why_no_compiler():
        return []
    return [program for program in programs() if not is_kept(program)]


def compile_in_background(programs: list[Program]) -> None:
    """Let another process compile programs, one after the other, and wait for it."""
    for program in programs:
        Compiling(program, in_background=True).wait()


def common_programs() -> Iterator[Program]:
    """Yield the programs of most large runs, the quickest to compile first."""
    live = list(live_programs())
    yield live[0]
    for scene in (falling_discs(MANY), box_pyramid(ROWS), bin_of_shapes(MANY).scene):
        yield stepped(scene)
    yield stepped(falling_discs(MANY), splits_steps=True)  # from the first fast disc on
    yield from live[1:]


def live_programs() -> Iterator[Program]:
    """Yield the programs of live worlds with many bodies: discs that fly, and what is stepped."""
    yield ExactSolver(gas_of(MANY, 0.3, seed=1), combine=MixingRule()).program()
    yield program_for("substep")


def stepped(scene: Scene, *, splits_steps: bool = False) -> Program:
    """Return the program by which the default call steps a scene of many bodies."""
    return EngineStepper(
        scene,
        solver="sequential",
        dt=DT,
        iterations=10,
        substeps=1,
        combine=MixingRule(),
        duration=DURATION,
        splits_steps=splits_steps,
    ).program()


def falling_discs(count: int) -> Scene:
    """Return rough discs that fall into a box of segments and bounce."""
    rough, width = Material(0.2, 0.4), math.isqrt(count)
    walls = [Segment((0, 0), (width, 0)), Segment((0, 0), (0, 9)), Segment((width, 0), (width, 9))]
    discs = [
        Body(Circle(0.45), mass=1.0, position=(k % width + 0.5, k // width + 1.0), material=rough)
        for k in range(count)
    ]
    floor_and_walls = [Body(wall, material=rough) for wall in walls]
    return Scene([*floor_and_walls, *discs], gravity=(0.0, -GRAVITY))

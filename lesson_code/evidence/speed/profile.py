"""The profile: what each stage of the engine takes in a scene, for a body and for a contact.

The stages and their order are read from the program that a run is made of: what ``step`` calls with
nothing but the world (with sub-steps: ``soft_part``), through the functions that only group them,
and, indented, what these call in the same way. Each is compiled with an entry of its own, and
called several times from the same tables; the shortest time counts. A call from Python costs some
microseconds, so that small scenes show nothing.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from rich.table import Table

from lesson_code.engine.compiled import link, program_of
from lesson_code.engine.compiled.compiler import compiled_here
from lesson_code.engine.core.rows import World
from lesson_code.engine.core.step import advance
from lesson_code.evidence.measurement import Measurement, digits, micro, table
from lesson_code.evidence.scenes.speed import scene_named
from lesson_code.evidence.speed.engines import refuse_without_compiler, start
from lesson_code.evidence.speed.race import warm_up_of
from lesson_code.evidence.timing import timed

CALLS = 7
"""Of each stage; the shortest counts."""

STEPS = {"sequential": "step", "substep": "soft_part"}
"""The function that makes a step, by solver."""

GROUPS = ("prepare_part", "detect", "resolve", "sub_step", "post_process")
"""Functions that call stages and do nothing else."""


@dataclass(frozen=True)
class Stage:
    """One stage, or a function within one."""

    name: str  # of the function
    depth: int  # 0 for a stage, 1 for what a stage calls
    calls: int  # in a step
    seconds: float  # for one call


@dataclass(frozen=True)
class Profile(Measurement):
    """What the stages take in a scene, in the order in which they run."""

    command = "measure speed --profile"

    scene: str
    solver: str
    bodies: int
    contacts: int
    step_seconds: float  # a whole step, many in one call
    stages: tuple[Stage, ...]

    def tables(self) -> Iterator[Table]:
        """Yield the one table."""
        columns: dict[str, Callable[[Stage], str]] = {
            "stage": lambda stage: "  " * stage.depth + stage.name,
            "calls a step": lambda stage: "" if stage.depth else str(stage.calls),
            "ns a body": lambda stage: digits(1e9 * stage.seconds / self.bodies),
            "ns a contact": lambda stage: (
                digits(1e9 * stage.seconds / self.contacts) if self.contacts else ""
            ),
            "us a step": lambda stage: "" if stage.depth else micro(stage.calls * stage.seconds),
        }
        counts = f"bodies {self.bodies:,}, contacts {self.contacts:,}"
        caption = f"A whole step, many in one call: {micro(self.step_seconds)} us."
        title = f"{self.scene}, {self.solver}: {counts}"
        yield table(title, columns, self.stages, caption=caption)


def profile_scene(name: str, solver: str = "sequential") -> Profile:
    """Measure what each stage of "sequential" or "substep" takes in a scene such as "gas-1000".

    Raises
    ------
    ValueError
        There is no such scene.
    RuntimeError
        Nothing can be compiled here.
    """
    refuse_without_compiler()
    speed_scene = scene_named(name)
    steps = warm_up_of(speed_scene)
    engine: Any = start(solver, speed_scene)
    engine.advance(steps)
    step_seconds = timed(lambda: engine.advance(steps)).worked / steps
    source = link(advance, pipeline=engine.pipeline)
    world = engine.world
    world.state.dt = world.state.whole
    stages = tuple(_measured(source, solver, world))
    bodies, contacts = len(world.bodies), int(world.state.contact_count)
    return Profile(name, solver, bodies, contacts, step_seconds, stages)


def stage_calls(source: str, function: str) -> list[tuple[str, str]]:
    """Return the calls in a function that take only the world, and the loop around each.

    Examples
    --------
    >>> stage_calls('''
    ... def step(world):
    ...     move(world)
    ...     for _ in range(state.iterations):
    ...         solve(world)
    ... ''', "step")
    [('move', ''), ('solve', 'iterations')]
    """
    trees = {t.name: t for t in ast.parse(source).body if isinstance(t, ast.FunctionDef)}
    return list(_calls_in(trees[function], "")) if function in trees else []


def _calls_in(tree: ast.AST, repeated: str) -> Iterator[tuple[str, str]]:
    for part in ast.iter_child_nodes(tree):
        times = repeated
        match part:
            case ast.For(iter=ast.Call(args=[ast.Attribute(attr=count)])):
                times = f"{repeated} {count}".strip()
            case ast.Call(func=ast.Name(id=name), args=[ast.Name(id="world")]):
                yield name, repeated
        yield from _calls_in(part, times)


def _measured(source: str, solver: str, world: Any) -> Iterator[Stage]:
    """Yield the stages of a step with their times; each does its work on the world."""
    for name, repeated in _stages_of(source, STEPS[solver], ""):
        calls = int(np.prod([getattr(world.state, count) for count in repeated.split()]))
        within = [(inner, 1) for inner, _ in stage_calls(source, name)]
        for inner, depth in [(name, 0), *within]:
            yield Stage(inner, depth, calls, _shortest(source, inner, world))
        compiled_here(program_of(source, name, World))(world)


def _stages_of(source: str, function: str, repeated: str) -> Iterator[tuple[str, str]]:
    """Yield the stages that a function of the step calls, and what repeats them."""
    for name, times in stage_calls(source, function):
        all_times = f"{repeated} {times}".strip()
        if name in GROUPS:
            yield from _stages_of(source, name, all_times)
        else:
            yield name, all_times


def _shortest(source: str, name: str, world: Any) -> float:
    """Return the shortest time of some calls, each from the same tables, s."""
    function = compiled_here(program_of(source, name, World))
    before = [np.copy(table) for table in world]
    times = []
    for _ in range(1 + CALLS):  # the first finds its memory cold
        times.append(timed(lambda: function(world)).worked)
        _restore(world, before)
    return min(times)


def _restore(world: Any, before: list[Any]) -> None:
    for rows, copy in zip(world, before, strict=True):
        if rows.shape:
            rows[...] = copy
        else:
            for field in copy.dtype.names:
                setattr(rows, field, copy[field].item())

"""The profile: what each stage of the engine takes in a scene, for a body and for a contact.

The stages and their order are read from the program that a run is made of: what ``step`` calls with
nothing but the world (with sub-steps: ``soft_part``), through the functions that only group them,
and, indented, what these call in the same way. Each is compiled with an entrance of its own, and
called several times from the same tables; the shortest time counts. Entering costs some
microseconds, so that small scenes tell nothing.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from rich.table import Table

from lesson_code.engine.compiled import compiled_function, link
from lesson_code.engine.core.step import advance
from lesson_code.evidence.scenes.speed import SIZES
from lesson_code.evidence.speed.clock import worked_seconds
from lesson_code.evidence.speed.engines import builder, refuse_without_compiler
from lesson_code.evidence.speed.race import with_head_start

VERSION = 1
"""Version of the form that :meth:`Profile.as_dict` writes; it grows when a key changes."""

CALLS = 7
"""Of each stage; the shortest counts."""

STEPS = {"sequential": "step", "substep": "soft_part"}
"""The function that makes a step, by solver."""

GROUPS = ("prepare_part", "detect", "resolve", "sub_step", "post_process")
"""Functions that call stages and do nothing else."""


@dataclass(frozen=True)
class Stage:
    """One stage, or a function within one.

    Attributes
    ----------
    name : str
        Of the function.
    depth : int
        0 for a stage, 1 for what a stage calls.
    calls : int
        In a step.
    seconds : float
        For one call.
    """

    name: str
    depth: int
    calls: int
    seconds: float


@dataclass(frozen=True)
class Profile:
    """What the stages take in a scene.

    Attributes
    ----------
    scene, solver : str
        Which.
    bodies, contacts : int
        How many there are.
    step_seconds : float
        A whole step, many in one call.
    stages : tuple of Stage
        In the order in which they run.
    """

    scene: str
    solver: str
    bodies: int
    contacts: int
    step_seconds: float
    stages: tuple[Stage, ...]

    def as_dict(self) -> dict[str, Any]:
        """Return all of it as one JSON object."""
        return {"version": VERSION, "command": "measure speed --profile", **asdict(self)}

    def as_table(self) -> Table:
        """Return all of it as a table."""
        counts = f"bodies {self.bodies:,}, contacts {self.contacts:,}"
        table = Table(
            *("stage", "calls a step", "ns a body", "ns a contact", "us a step"),
            title=f"{self.scene}, {self.solver}: {counts}",
            caption=f"A whole step, many in one call: {self.step_seconds * 1e6:,.1f} us.",
        )
        for stage in self.stages:
            table.add_row(
                "  " * stage.depth + stage.name,
                str(stage.calls) if stage.depth == 0 else "",
                f"{stage.seconds / self.bodies * 1e9:,.1f}",
                f"{stage.seconds / self.contacts * 1e9:,.1f}" if self.contacts else "",
                f"{stage.calls * stage.seconds * 1e6:,.1f}" if stage.depth == 0 else "",
            )
        return table


def profile_scene(name: str, solver: str = "sequential") -> Profile:
    """Measure what each stage takes in a scene.

    Parameters
    ----------
    name : str
        Of a scene with its size, such as "gas-1000", or any size of it.
    solver : str
        "sequential" or "substep".

    Raises
    ------
    ValueError
        There is no such scene.
    RuntimeError
        Nothing can be compiled here.
    """
    refuse_without_compiler()
    speed_scene, own_steps = with_head_start(_scene_named(name))
    engine: Any = builder(solver, speed_scene)()
    engine.advance(own_steps)
    start = worked_seconds()
    engine.advance(own_steps)
    step_seconds = (worked_seconds() - start) / own_steps
    source = link(advance, pipeline=engine.pipeline)
    world = engine.world
    world.state.dt = world.state.whole
    stages = tuple(_measured(source, solver, world))
    bodies, contacts = len(world.bodies), int(world.state.contact_count)
    return Profile(name, solver, bodies, contacts, step_seconds, stages)


def stage_calls(source: str, function: str) -> list[tuple[str, str]]:
    """Return what a function calls with nothing but the world, and what repeats the call.

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
    """Yield the calls within a part of a function."""
    for part in ast.iter_child_nodes(tree):
        times = repeated
        match part:
            case ast.For(iter=ast.Call(args=[ast.Attribute(attr=count)])):
                times = f"{repeated} {count}".strip()
            case ast.Call(func=ast.Name(id=name), args=[ast.Name(id="world")]):
                yield name, repeated
        yield from _calls_in(part, times)


def _measured(source: str, solver: str, world: Any) -> Iterator[Stage]:
    """Yield the stages of a step with their times, and let each do its work on the world."""
    for name, repeated in _stages_of(source, STEPS[solver], ""):
        calls = int(np.prod([getattr(world.state, count) for count in repeated.split()]))
        within = [(inner, 1) for inner, _ in stage_calls(source, name)]
        for inner, depth in [(name, 0), *within]:
            yield Stage(inner, depth, calls, _shortest(source, inner, world))
        compiled_function(source, name)(world)


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
    function = compiled_function(source, name)
    before = [np.copy(table) for table in world]
    function(world)
    times = []
    for _ in range(CALLS):
        _restore(world, before)
        start = worked_seconds()
        function(world)
        times.append(worked_seconds() - start)
    _restore(world, before)
    return min(times)


def _restore(world: Any, before: list[Any]) -> None:
    """Put the tables back to what they were."""
    for table, copy in zip(world, before, strict=True):
        if table.shape:
            table[...] = copy
        else:
            for field in copy.dtype.names:
                setattr(table, field, copy[field].item())


def _scene_named(name: str) -> Any:
    """Return a scene by its name and size."""
    from lesson_code.evidence.speed.measure import KEYS

    builds = {key: build for build, key in KEYS.items() if build in SIZES}
    kind, _, size = name.partition("-")
    if kind not in builds or not size.isdigit() or int(size) < 1:
        raise ValueError(f"profile must be one of {', '.join(builds)} with a size, got {name!r}")
    return builds[kind](int(size))

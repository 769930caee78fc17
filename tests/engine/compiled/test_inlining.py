"""A program's small functions are compiled in place of their calls, and its large ones are not."""

from __future__ import annotations

import ast
from typing import Any

import pytest

from lesson_code import MixingRule
from lesson_code.engine.compiled.inlining import MOST_NODES, inlined, merged
from lesson_code.engine.effects.choice import EFFECTS
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.stepper import EngineStepper, source_of
from lesson_code.evidence.scenes.speed import SpeedScene, bin_of_shapes, gas

SHORT = "def short(x):\n    return x\n"
LONG = "def long(x):\n" + "    x = x + x\n" * (MOST_NODES // 12) + "    return x\n"


def loop(*calls: str) -> str:
    """Return a program that calls functions in a loop."""
    lines = [f"        x = {name}(x)\n" for name in calls]
    return "def run(x):\n    for k in range(9):\n" + "".join(lines) + "    return x\n"


def nodes_of(source: str) -> int:
    """Return the nodes of the first function's syntax tree."""
    return sum(1 for _ in ast.walk(ast.parse(source).body[0]))


def test_inlined_short_function_stands_in_place_of_its_calls() -> None:
    """A function of few nodes is chosen."""
    assert inlined(SHORT + loop("short", "short")) == {"short"}


def test_inlined_long_function_stands_in_one_place_but_not_in_two() -> None:
    """A function that would make the program longer by too much stays a call."""
    assert MOST_NODES / 2 < nodes_of(LONG) <= MOST_NODES
    assert inlined(LONG + loop("long")) == {"long"}
    assert inlined(LONG + loop("long", "long")) == frozenset()


def test_inlined_what_is_put_in_counts_with_the_function_that_calls_it() -> None:
    """A short function with a long one in it is a long one."""
    program = LONG + "def middle(x):\n    return long(x)\n"
    assert inlined(program + loop("middle")) == {"long", "middle"}
    assert inlined(program + loop("middle", "middle")) == {"long"}


def test_inlined_function_outside_of_loops_stays_a_call() -> None:
    """A stage is called once; and the function that Python calls has no place to stand in."""
    assert inlined(SHORT + "def run(x):\n    return short(x)\n") == frozenset()


def test_merged_function_without_loops_that_is_called_once() -> None:
    """What puts stages in order; with a loop, or called twice, it stays a function."""
    once = "def run(x):\n    return short(x)\n"
    assert merged(SHORT + once) == {"short"}
    assert merged(SHORT + once + "def again(x):\n    return short(x)\n") == frozenset()
    looped = "def short(x):\n    for _ in x:\n        pass\n"
    assert merged(looped + once) == frozenset()


def test_merged_nothing_that_is_compiled_in_place() -> None:
    """A function is put into its caller in one way."""
    assert merged(SHORT + loop("short")) == frozenset()


WHOLE_WORLD = "world"
RARE = {("drop_internal_edges", "is_covered")}
"""Calls that may copy the world: for each contact with a static body, and long in themselves."""


def calls_with_the_world(source: str) -> set[tuple[str, str]]:
    """Return caller and callee of all calls in loops over rows that hand on the world."""
    functions = {f.name: f for f in ast.parse(source).body if isinstance(f, ast.FunctionDef)}
    return {
        (name, call.func.id)
        for name, function in functions.items()
        for loop in ast.walk(function)
        if isinstance(loop, ast.For)
        if not (isinstance(loop.target, ast.Name) and loop.target.id == "_")  # of sweeps
        for call in ast.walk(loop)
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name)
        if call.func.id in functions.keys() - inlined(source)
        if any(isinstance(a, ast.Name) and a.id == WHOLE_WORLD for a in call.args)
    }


@pytest.mark.parametrize("every", [True, False], ids=["every effect", "as called for"])
@pytest.mark.parametrize("solver", ["sequential", "substep", "naive"])
@pytest.mark.parametrize("scene", [gas(100), bin_of_shapes(20)], ids=lambda scene: scene.name)
def test_inlined_no_loop_over_rows_hands_on_the_world(
    scene: SpeedScene, solver: str, every: bool
) -> None:
    """What the engine does for every body, box and pair is put into the loop."""
    spared = {*our_solvers()[solver].lacks, "callbacks"}
    wishes = {name: True for name in EFFECTS if name not in spared} if every else None
    settings: dict[str, Any] = {"dt": 1 / 60, "iterations": 10, "substeps": 1}
    stepper = EngineStepper(
        scene.scene, solver=solver, combine=MixingRule(), effects=wishes, **settings
    )
    for splits in (False, True):
        source = source_of(stepper.pipeline._replace(splits_steps=splits))
        assert calls_with_the_world(source) <= RARE

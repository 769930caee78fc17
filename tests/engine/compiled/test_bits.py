"""Compiled or plain: the same bits, in every scene there is, with every solver.

All scenes of a solver share one program, which can do everything. The plain run uses the stages
that suit its scene: so it is shown too that these leave out nothing that matters. A zero may have
another sign there: 0 v has that of v.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from every_scene import DT, SCENES, fast_mix, many_boxes, mixed_heap, moving_walls
from tiers import share

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, simulate
from lesson_code.engine import stepper
from lesson_code.engine.compiled import Code, Program, link
from lesson_code.engine.compiled.compiler import compiled
from lesson_code.engine.compiled.library import FOLDER_VARIABLE, folder
from lesson_code.engine.compiled.loader import Entry
from lesson_code.engine.core.broad_phase import uniform_grid
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.engine.solvers.naive import SOLVER as NAIVE
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.gas import gas_of

pytest.importorskip("numba")

SOLVERS = [
    "sequential",
    pytest.param("substep", marks=pytest.mark.full),
    pytest.param("naive", marks=pytest.mark.full),
]
"""Each is a program of its own to compile: the quick tier takes one."""


def share_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every compiled run of a solver use one program: it takes 10 to 30 s to compile one."""

    def link_all(function: Any, pipeline: Any) -> str:
        every = pipeline._replace(
            effects=EVERY_EFFECT._replace(
                sleeping=pipeline.effects.sleeping,
                continuous=pipeline.solver is not NAIVE.stages,
            ),
            broad_phase=uniform_grid,
            splits_steps=True,
        )
        return link(function, pipeline=every)

    monkeypatch.setattr(stepper, "link", link_all)


@pytest.fixture(autouse=True)
def one_program_for_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Share them in every test here."""
    share_programs(monkeypatch)


def at_work(scene: Scene, solver: str, compiled: bool | None, **settings: Any) -> EngineStepper:
    """Return a solver at work on a scene."""
    usual = {"dt": DT, "iterations": 4, "substeps": 2, "combine": MixingRule()}
    return EngineStepper(scene, solver=solver, compiled=compiled, **(usual | settings))


def both(scene: Scene, solver: str, steps: int, **settings: Any) -> list[EngineStepper]:
    """Return a compiled and a plain run, so many steps later."""
    runs = [at_work(scene, solver, compiled, **settings) for compiled in (True, False)]
    for run in runs:
        run.advance(steps)
    return runs


def assert_same_bits(compiled: EngineStepper, plain: EngineStepper) -> None:
    """States, impulses and how far the run has come."""
    assert (compiled.states() + 0.0).tobytes() == (plain.states() + 0.0).tobytes()
    assert (compiled.events() + 0.0).tobytes() == (plain.events() + 0.0).tobytes()
    counts = ["steps_done", "time", "contact_count", "memory_count"]
    for name in counts + ["dt_before"] * plain.pipeline.effects.collisions:
        assert getattr(compiled.world.state, name) == getattr(plain.world.state, name), name


STEPS = 40


@pytest.mark.one_in(12)
@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("build", SCENES.values(), ids=SCENES)
def test_compiled_run_has_the_bits_of_the_plain_one(
    build: Callable[[], Scene], solver: str
) -> None:
    """Every state and every impulse."""
    assert_same_bits(*both(build(), solver, STEPS))


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize(
    "settings",
    [
        {"dt": 1 / 240},
        {"dt": 0.05, "iterations": 1},
        {"iterations": 10, "substeps": 1},
        {"iterations": 3, "substeps": 5},
        {"combine": MixingRule("max", "product")},
    ],
    ids=str,
)
def test_compiled_run_has_the_bits_of_the_plain_one_whatever_the_settings(
    settings: dict[str, Any], solver: str
) -> None:
    """Steps, sweeps, parts of steps and rules of combination are numbers in the tables."""
    assert_same_bits(*both(mixed_heap(), solver, 25, **settings))


# In lanes


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("seed", range(2, 2 + share(12)))
def test_boxes_visited_in_lanes_have_the_bits_of_visits_one_by_one(seed: int, solver: str) -> None:
    """Manifolds and single points, some on a body that nothing can push, some of which open."""
    compiled, plain = both(many_boxes(seed), solver, STEPS)
    assert_same_bits(compiled, plain)
    if solver != "naive":
        assert 0 < plain.world.state.lanes_of_two < plain.world.state.lanes_of_one


# Begun plain


def changes_at(steps: tuple[int, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    """Let machine code come, or be given up again, at steps of a run."""

    def look(
        self: Code, program: Callable[[], Program], ahead: float, now: str, other: object
    ) -> Entry | None:
        return compiled(program()) if now in {f"step {step + 1}" for step in steps} else None

    monkeypatch.setattr(Code, "begin", lambda *_, **__: None)
    monkeypatch.setattr(Code, "look", look)


@pytest.mark.one_in(12)
@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("build", SCENES.values(), ids=SCENES)
def test_run_that_goes_on_compiled_has_the_bits_of_the_plain_one(
    build: Callable[[], Scene], solver: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From the 8th step on, in all that it carries over."""
    changes_at((8,), monkeypatch)
    run, plain = (at_work(build(), solver, compiled) for compiled in (None, False))
    for each in (run, plain):
        each.advance(STEPS)
    assert isinstance(run.world.bodies, np.ndarray)
    assert_same_bits(run, plain)


@pytest.mark.full
def test_run_that_changes_its_program_goes_on_plain_with_the_same_bits(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where the first fast body calls for a program that is not there yet; then it comes."""
    monkeypatch.setattr(stepper, "link", link)
    changes_at((4, 36), monkeypatch)
    run, plain = (at_work(falls_sideways(), "sequential", compiled) for compiled in (None, False))
    seen = [True]
    for _ in range(50):
        for each in (run, plain):
            each.advance(1)
        if (is_list := isinstance(run.world.bodies, list)) != seen[-1]:
            seen.append(is_list)
        assert_same_bits(run, plain)
    assert seen == [True, False, True, False]


def falls_sideways() -> Scene:
    """Return discs that fall into a wall, where they are fast: a step takes them through it."""
    wall = Body(Polygon.box(0.2, 9.0), position=(6.0, 0.0))
    discs = [Body(Circle(0.1), mass=1, position=(0, y), velocity=(0, y)) for y in (0.0, 2.0)]
    return Scene([wall, *discs], gravity=(40.0, 0.0))


# Calls and tables


@pytest.mark.parametrize("solver", SOLVERS)
def test_compiled_run_in_many_calls_has_the_bits_of_one_call(solver: str) -> None:
    """Though every call hands all tables over again."""
    at_once, one_by_one = (at_work(mixed_heap(), solver, compiled=True) for _ in range(2))
    at_once.advance(90)
    for _ in range(90):
        one_by_one.advance(1)
    assert_same_bits(at_once, one_by_one)
    assert len(at_once.events()) > 100


def test_compiled_run_stops_for_room_and_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """The tables begin empty; those for pairs, contacts and impulses grow, and more than once."""
    wanted: list[tuple[int, int, int]] = []
    add_capacity = stepper.add_capacity

    def watched(world: Any) -> Any:
        state = world.state
        rows = state.pairs_wanted, state.contacts_wanted, state.impulses_wanted
        wanted.append(rows)
        return add_capacity(world)

    monkeypatch.setattr(stepper, "add_capacity", watched)
    compiled, plain = both(mixed_heap(), "sequential", 90, splits_steps=True)
    assert_same_bits(compiled, plain)
    assert wanted[: len(wanted) // 2] == wanted[len(wanted) // 2 :]
    assert all(sum(step[n] > 0 for step in wanted) > 1 for n in range(3))


def test_run_without_steps_changes_nothing() -> None:
    """No step, no bit."""
    compiled, plain = both(mixed_heap(), "sequential", 0)
    assert_same_bits(compiled, plain)
    assert compiled.events().shape == (0, 10)


# What is refused


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("compiled", [True, False])
def test_body_that_is_lost_is_refused_in_the_same_words(solver: str, compiled: bool) -> None:
    """It falls at 1e308 m/s^2 and is beyond all numbers in the second step."""
    wall, ball = Body(Circle(1), position=(9, 9)), Body(Circle(1), mass=1)
    scene = Scene([wall, ball], gravity=(0, -1e308))
    run = at_work(scene, solver, compiled, dt=1.0, substeps=1)
    with pytest.raises(FloatingPointError, match=r"^body 1 has left the range of floating point$"):
        run.advance(9)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("compiled", [True, False])
def test_bodies_that_are_heaped_are_refused_in_the_same_words(solver: str, compiled: bool) -> None:
    """400 in one place: 30,000 pairs would be allowed, and they stop counting soon after."""
    heap = Scene([Body(Circle(0.5), mass=1) for _ in range(400)])
    words = "bodies must not be heaped into one another: 400 of them overlap in .* pairs or more"
    with pytest.raises(ValueError, match=words):
        at_work(heap, solver, compiled).advance(1)


@pytest.mark.parametrize("cells", [0.0, 1e9, -(2.0**31), 2.0**63])
def test_pairs_around_the_last_cell_are_the_same(cells: float) -> None:
    """Compiled, a cell has a number of 32 bits; each of 30 discs in a row is beside another."""
    cell = at_work(gas_of(30, 0.3, seed=4), "sequential", compiled=False).world.state.cell_size
    start = cells * cell - 15 * 0.9
    row = [Body(Circle(0.5), mass=1, position=(start + 0.9 * k, 0)) for k in range(30)]
    compiled, plain = both(Scene(row), "sequential", 1)
    assert_same_bits(compiled, plain)
    assert compiled.world.state.pair_count == plain.world.state.pair_count >= 29


# Through the door


def thrown_discs(speed: float) -> Scene:
    """Return discs alone, without corners: so the scene asks for the smallest program."""
    wall = Body(Circle(1), position=(3, 0))
    discs = [
        Body(Circle(0.1), mass=1, position=(0, 0.15 * k), velocity=(speed, 0), material=Material(1))
        for k in range(-3, 3)
    ]
    return Scene([wall, *discs])


@pytest.mark.full
@pytest.mark.parametrize("speed", [5.0, 400.0], ids=["slow", "fast"])
def test_simulate_gives_the_same_run_compiled_or_plain(
    monkeypatch: pytest.MonkeyPatch, speed: float
) -> None:
    """Linked as the scene asks for it; where a fast body is met, with the splitting of steps."""
    linked: list[bool] = []

    def watched(function: Any, pipeline: Any) -> str:
        linked.append(pipeline.splits_steps)
        return link(function, pipeline=pipeline)

    monkeypatch.setattr(stepper, "link", watched)
    scene = thrown_discs(speed)
    compiled, plain = (
        simulate(scene, 1.0, solver="sequential", compiled=choice) for choice in (True, False)
    )
    assert linked == ([False, True] if speed > 100 else [False])
    for name in ("positions", "velocities", "angles", "angular_velocities", "times"):
        assert (getattr(compiled, name) + 0.0).tobytes() == getattr(plain, name).tobytes(), name
    for mine, its in zip(
        vars(compiled.contacts).values(), vars(plain.contacts).values(), strict=True
    ):
        assert mine.tobytes() == its.tobytes()
    assert len(plain.contacts) > 0
    assert compiled.plan.headline.endswith("compiled (asked for)")
    assert plain.plan.headline.endswith("plain Python (asked for)")


# Indices


@pytest.mark.full
def test_no_index_is_out_of_range() -> None:
    """Compiled with Numba's checks, in a process of their own; unchecked, a wrong one may crash."""
    env = os.environ | {
        "NUMBA_BOUNDSCHECK": "1",
        "NUMBA_OPT": "0",  # the checks are the same, and sooner there
        FOLDER_VARIABLE: str(folder() / "checked"),
        "PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path]),
    }
    code = "import test_bits; test_bits.run_checked()"
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, "same bits"), done.stderr


def run_checked() -> None:
    """Run some scenes in a program with checks, and compare; see the test above."""
    with pytest.MonkeyPatch.context() as patch:
        share_programs(patch)
        for build in (mixed_heap, many_boxes, fast_mix, moving_walls, SCENES["speed: gas"]):
            assert_same_bits(*both(build(), "sequential", 30))
    sys.stdout.write("same bits")

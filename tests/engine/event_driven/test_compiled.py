"""The exact solver as machine code: the same bits, the same record, the same errors."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.compiled import Code, Program, library
from lesson_code.engine.compiled.compiler import compiled
from lesson_code.engine.compiled.loader import Entry
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.event_driven import solver as solver_module
from lesson_code.evidence.scenes.discs import rack_break
from lesson_code.evidence.scenes.events import (
    ball_in_a_box,
    bouncing_to_rest,
    box,
    two_blocks,
)
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.rigid_bodies import disc_in_wedge


def crowd(
    seed: int, material: Material, gravity: tuple[float, float] = (0.0, 0.0), *extra: Body
) -> Scene:
    """Return 25 spinning discs of all sizes and masses in a box; some cannot be turned."""
    rng = np.random.default_rng(seed)
    discs = [
        Body(
            Circle(rng.uniform(0.1, 0.3)),
            mass=rng.uniform(0.5, 2),
            inertia=math.inf if k % 5 == 0 else None,
            position=(k % 5 + 0.5 + rng.uniform(-0.1, 0.1), k // 5 + 0.5),
            velocity=rng.uniform(-3, 3, 2),
            angular_velocity=rng.uniform(-3, 3),
            material=material,
        )
        for k in range(25)
    ]
    return Scene([*box(5.0, 5.0, material), *extra, *discs], gravity=gravity)


def heap(gravity: float) -> Scene:
    """Return discs that fall into a bin, where they can only hop."""
    rough = Material(0.4, 0.3)
    discs = [
        Body(
            Circle(0.3 + 0.02 * (k % 5)),
            mass=1.0,
            position=(k % 6 + 0.01 * k, k // 6 + 0.5),
            material=rough,
        )
        for k in range(18)
    ]
    walls = [Segment((-1, 0), (6, 0)), Segment((-1, 0), (-1, 4)), Segment((6, 0), (6, 4))]
    return Scene([*(Body(wall, material=rough) for wall in walls), *discs], gravity=(0, -gravity))


def slope() -> Scene:
    """Return discs that fall on a wedge, roll down, slide and leave its end."""
    surface = Material(0.4, 0.3)
    wedge = Body(Polygon([(-5, 0), (5, 0), (-5, 3)]), material=surface)
    discs = [
        Body(Circle(0.2), mass=1.0, position=(k - 4, 4), angular_velocity=k, material=surface)
        for k in range(5)
    ]
    return Scene([wedge, *discs], gravity=(0, -10))


SMOOTH, ROUGH = Material(1.0), Material(0.7, 0.4)
MOVING = (
    Body(Segment((1, -6), (4, -6)), velocity=(0, 4), material=ROUGH),
    Body(Circle(0.4), position=(-9, 3), velocity=(5, 0.1), material=ROUGH),
)
BLOCK = Body(Polygon.box(0.3, 0.2), position=(1.0, 1.0), angle=0.4, material=ROUGH)

SCENES: dict[str, tuple[Scene, float]] = {
    "empty": (Scene(), 1.0),
    "gas": (gas_of(100, 0.3, seed=1), 10.0),
    "dense gas": (gas_of(30, 0.6, seed=2), 10.0),
    "few discs": (gas_of(7, 0.3, seed=3), 100.0),
    "friction": (crowd(1, ROUGH), 3.0),
    "gravity": (crowd(2, SMOOTH, (1.0, -9.81)), 3.0),
    "friction, gravity, polygon": (crowd(3, ROUGH, (0.0, -3.0), BLOCK), 1.5),
    "moving obstacles": (crowd(4, ROUGH, (0.0, 0.0), *MOVING), 3.0),
    "heap that hops": (heap(10.0), 1.5),
    "slope": (slope(), 3.0),
    "wedge": (disc_in_wedge(0.3, 1.0), 5.0),
    "two blocks": (two_blocks(10_000), 1e9),
    "ball that comes to rest": (bouncing_to_rest(0.8), 100.0),
    "ball in a box": (ball_in_a_box(), 100.0),
    "break shot": (rack_break(0.95), 2.0),
}

EFFECTS = ("collisions", "outlines", "restitution", "friction", "rotation", "gravity")
"""What the solver may leave out of its loop."""

FORCED = dict.fromkeys((*EFFECTS, "impulse_record"), True)
"""All of that, and the record: so one program serves every scene."""

COLLISIONS = 250
"""Of each scene at the most: enough that every kind of event occurs."""


def bits_of(
    scene: Scene,
    until: float,
    *,
    compiled: bool = False,
    effects: dict[str, bool] | None = None,
) -> tuple[int, bytes, bytes, bytes]:
    """Return the collisions, and the bits of the states half-way and at the end, and impulses.

    Zero has one sign here.
    """
    solver = ExactSolver(
        scene, combine=mixing_rule("workbook"), compiled=compiled, effects=effects, duration=until
    )
    time, halfway = 0.0, b""
    while solver.collisions < COLLISIONS:
        found = solver.next_collision(until)
        if found is None:
            time = until
            break
        time = found
        if solver.collisions == COLLISIONS // 2:
            halfway = bits(solver.states(time))
    return solver.collisions, halfway, bits(solver.states(time)), bits(solver.events())


def bits(numbers: NDArray[np.float64]) -> bytes:
    """Return the bits of numbers, those of 0 for -0."""
    return (numbers + 0.0).tobytes()


@pytest.fixture(autouse=True)
def needs_numba() -> None:
    """Leave these tests out where nothing can be compiled."""
    pytest.importorskip("numba")


LEAN = ("empty", "gas", "dense gas", "few discs", "friction", "ball that comes to rest")
"""Scenes that are compiled for what they call for, too: in four programs."""


@pytest.mark.full
@pytest.mark.parametrize(("scene", "until"), SCENES.values(), ids=SCENES)
def test_scene_has_the_same_bits_with_every_effect_forced_on_and_compiled(
    scene: Scene, until: float
) -> None:
    """States and impulses, to the last bit. With every effect one program serves all scenes."""
    plain = bits_of(scene, until)
    assert bits_of(scene, until, effects=FORCED) == plain
    assert bits_of(scene, until, effects=FORCED, compiled=True) == plain


@pytest.mark.one_in(9)
@pytest.mark.parametrize("name", LEAN)
def test_compiled_run_of_what_a_scene_calls_for_has_the_same_bits(name: str) -> None:
    """The program from which effects are left out, too."""
    scene, until = SCENES[name]
    assert bits_of(scene, until, compiled=True) == bits_of(scene, until)


@pytest.mark.full
def test_record_of_a_long_compiled_run_is_whole() -> None:
    """The table of impulses is emptied many times; nothing is lost, and the order is kept."""
    scene = gas_of(20, 0.3, seed=1)
    solver = ExactSolver(scene, combine=mixing_rule("workbook"), compiled=True)
    solver.advance(500.0)
    assert solver.collisions > 3 * solver_module.RECORD_ROWS
    events = solver.events()
    assert len(events) == solver.collisions
    assert (np.diff(events[:, 0]) >= 0).all()


@pytest.mark.full
def test_run_that_is_compiled_on_the_way_has_the_same_bits(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It begins as plain Python, turns out to be long, and goes on as machine code."""
    scene, ahead = gas_of(100, 0.3, seed=1), []
    plain = simulate(scene, 40.0, solver="exact", compiled=False, sample="end")

    def look(
        self: Code, program: Callable[[], Program], more: float, now: str, other: object
    ) -> Entry:
        ahead.append(more)
        return compiled(program())

    monkeypatch.setattr(Code, "begin", lambda *_, **__: None)
    monkeypatch.setattr(Code, "look", look)
    changed = simulate(scene, 40.0, solver="exact", sample="end")
    assert len(ahead) == 1
    assert 0 < ahead[0] < 10
    assert changed.positions.tobytes() == plain.positions.tobytes()
    assert changed.contacts.time.tobytes() == plain.contacts.time.tobytes()


def test_small_run_stays_plain_python_and_says_so() -> None:
    """Nobody waits for a compiler."""
    plan = simulate(ball_in_a_box(), 10.0, solver="exact").plan
    assert (plan.code, plan.code_reason) == ("plain Python", "a small run")


@pytest.mark.full
def test_compiled_run_that_was_asked_for_says_so() -> None:
    """However small it is."""
    plan = simulate(ball_in_a_box(), 10.0, solver="exact", compiled=True).plan
    assert (plan.code, plan.code_reason) == ("compiled", "asked for")


def test_compiling_without_a_compiler_is_refused(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """It says why, where no program is kept either."""
    monkeypatch.setenv(library.FOLDER_VARIABLE, str(tmp_path))
    monkeypatch.setattr(library.importlib.util, "find_spec", lambda _: None)
    library.forget_loaded()
    with pytest.raises(ValueError, match="compiled must be False or None here: Numba is not"):
        simulate(ball_in_a_box(), 1.0, solver="exact", compiled=True)


@pytest.mark.full
def test_compiled_pile_without_end_is_refused_as_in_plain_python() -> None:
    """The same error at the same time."""
    heavy = [
        Body(Circle(0.5), mass=10.0 ** (4 * k), position=(0, 0.5 + k), material=Material(0.5))
        for k in range(3)
    ]
    scene = Scene([Body(Segment((-4, 0), (4, 0))), *heavy], gravity=(0, -10))
    errors = []
    for choice in (True, False):
        with pytest.raises(RuntimeError, match="finds no end") as caught:
            simulate(scene, 10.0, solver="exact", compiled=choice, sample="end")
        errors.append(str(caught.value))
    assert errors[0] == errors[1]

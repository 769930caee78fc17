"""Programs that come ready-made: at once, without Numba, and with the bits of plain Python."""

from __future__ import annotations

import json
import math
import shutil
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from every_scene import DT, SCENES, many_boxes, mixed_heap
from hypothesis import given, settings
from hypothesis import strategies as st
from processes import printed, started
from small_program import small_program
from tiers import share

from lesson_code import Material, MixingRule, Run, Scene, simulate
from lesson_code.engine.compiled import choice, library, ready_made
from lesson_code.engine.compiled.loader import Entry
from lesson_code.engine.event_driven import why_not
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence import common_programs
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.speed import falling_discs

pytest.importorskip("llvmlite")

READY_MADE = ("compiled", "a program for any scene came ready-made")
KEPT = ("compiled", "machine code for any scene was kept")

GRID = {"broad_phase": True}
"""What few bodies do not call for, and a program for any scene has."""


@pytest.fixture
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let machine code pay for a run of any length."""
    for name in ("LOAD_SECONDS", "READY_MADE_SECONDS"):
        monkeypatch.setattr(choice, name, 0.0)


@pytest.fixture
def nothing_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Return an empty folder, in which machine code is kept from now on."""
    library.forget_loaded()
    monkeypatch.setenv(library.FOLDER_VARIABLE, str(tmp_path))
    return tmp_path


def at_work(scene: Scene, **settings: Any) -> EngineStepper:
    """Return a solver at work on a scene, for some seconds."""
    usual = {"dt": DT, "iterations": 10, "substeps": 2, "combine": MixingRule(), "duration": 9.0}
    return EngineStepper(scene, **usual, **settings)


def require_same(run: Run, plain: Run) -> None:
    """Compare all that two runs hold, to the last bit."""
    for name in ("positions", "velocities", "angles", "angular_velocities"):
        np.testing.assert_array_equal(getattr(run, name), getattr(plain, name), err_msg=name)
    np.testing.assert_array_equal(run.impulses.rows(), plain.impulses.rows())


# The same bits


@pytest.mark.one_in(3)
@pytest.mark.usefixtures("at_once")
@pytest.mark.parametrize(
    ("name", "solver"),
    [
        (name, solver)
        for name, build in SCENES.items()
        for solver in ("sequential", "substep", "exact")
        if solver != "exact" or not why_not(build())
    ],
)
def test_scene_has_the_bits_of_plain_python(name: str, solver: str) -> None:
    """Every kind of scene, longer than it takes to fall asleep: all states and impulses."""
    scene = SCENES[name]()
    try:
        plain = simulate(scene, 1.5, solver=solver, compiled=False, effects=GRID)
    except RuntimeError as error:  # a pile, in which collisions have no end
        pytest.skip(str(error))
    if not plain.plan.effect("collisions").used:
        pytest.skip("nobody meets anybody, which takes no program")
    run = simulate(scene, 1.5, solver=solver, effects=GRID)
    assert run.plan.code == "compiled"
    require_same(run, plain)


def thrown(seed: int, count: int) -> Scene:
    """Return discs over a floor between walls, thrown at up to 60 m/s, and at each other."""
    rng, scene = np.random.default_rng(seed), falling_discs(count)
    speed = 10 ** rng.uniform(-1, 1.78)
    bodies = [
        body if body.is_static else replace(body, velocity=rng.uniform(-speed, speed, 2))
        for body in scene.bodies
    ]
    return Scene(bodies, gravity=scene.gravity)


@pytest.mark.usefixtures("at_once")
@settings(max_examples=share(30))
@given(seed=st.integers(0, 10**6), count=st.integers(30, 90), are_boxes=st.booleans())
def test_drawn_crowd_has_the_bits_of_plain_python(seed: int, count: int, are_boxes: bool) -> None:
    """So many bodies call for a grid, and the default call sweeps over their contacts."""
    scene = many_boxes(seed) if are_boxes else thrown(seed, count)
    plain = simulate(scene, 0.7, solver="sequential", compiled=False)
    run = simulate(scene, 0.7, solver="sequential")
    assert run.plan.code == "compiled"
    require_same(run, plain)


@pytest.mark.parametrize("solver", ["sequential", "substep"])
@pytest.mark.parametrize("steps", [1, 7, 40])
def test_run_goes_over_to_it_after_any_step(
    monkeypatch: pytest.MonkeyPatch, solver: str, steps: int
) -> None:
    """Where a run turns out to be long: the bits are those of plain Python all the way."""
    monkeypatch.setattr(choice, "LOOK_SECONDS", math.inf)
    monkeypatch.setattr(choice, "LOAD_SECONDS", math.inf)
    plain, changed = (
        at_work(mixed_heap(), solver=solver, effects=GRID, compiled=compiled)
        for compiled in (False, None)
    )
    for stepper in (plain, changed):
        stepper.advance(steps)
    assert changed.plan("").code == "plain Python"
    for name in ("LOAD_SECONDS", "READY_MADE_SECONDS"):
        monkeypatch.setattr(choice, name, 0.0)
    changed._code._pause = 0.0
    for stepper in (plain, changed):
        stepper.advance(60)
    assert changed.plan("").code == f"plain Python, compiled from step {steps + 2} on"
    np.testing.assert_array_equal(changed.states(), plain.states())
    np.testing.assert_array_equal(changed.events(), plain.events())


@pytest.mark.parametrize("solver", ["sequential", "substep"])
@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_recorded_run_goes_over_to_it_between_two_states(
    monkeypatch: pytest.MonkeyPatch, solver: str, friction: float
) -> None:
    """Smooth discs do not turn, and plain Python notes no angles of theirs; the program does."""
    bodies = [replace(b, material=Material(0.2, friction)) for b in falling_discs(60).bodies]
    scene = Scene(bodies, gravity=(0.0, -10.0))
    plain = simulate(scene, 1.0, solver=solver, compiled=False)
    for name, value in {"LOAD": math.inf, "LOOK": 0.0, "READY_MADE": 0.0}.items():
        monkeypatch.setattr(choice, f"{name}_SECONDS", value)
    look, looks = choice.Code.look, count(1)

    def look_later(code: choice.Code, *asked: Any) -> Entry | None:
        if next(looks) < 20:
            return None
        monkeypatch.setattr(choice, "LOAD_SECONDS", 0.0)
        return look(code, *asked)

    monkeypatch.setattr(choice.Code, "look", look_later)
    run = simulate(scene, 1.0, solver=solver)
    assert run.plan.code == "plain Python, compiled from step 21 on"
    require_same(run, plain)


# When it is used


def test_first_run_is_compiled_and_the_next_one_finds_it_kept(nothing_kept: Path) -> None:
    """A pile of 300, by the default call: no compiler is started for it."""
    runs = [simulate(falling_discs(300), 3.0, sample="end") for _ in range(2)]
    assert [(run.plan.code, run.plan.code_reason) for run in runs] == [READY_MADE, KEPT]
    kept = [path.name for path in nothing_kept.glob("program_*")]
    assert len(kept) == 1


@pytest.mark.parametrize(
    ("effects", "is_suited"),
    [
        ({"impulse_record": False}, False),
        ({"sleeping": False}, False),
        ({"broad_phase": False}, False),
        ({"sleeping": True}, True),
        ({"friction": True}, True),
        ({}, True),
    ],
)
def test_run_without_what_its_scene_calls_for_is_not_made_by_a_program_for_any(
    effects: dict[str, bool], is_suited: bool
) -> None:
    """It would do what was not to be done, and write down what nobody wants."""
    stepper = at_work(falling_discs(60), solver="sequential", effects=effects, compiled=False)
    expected = common_programs.common_programs()["sequential_with_sleep"] if is_suited else None
    assert stepper.program_for_any() == expected


@pytest.mark.full
@pytest.mark.usefixtures("nothing_kept")
def test_program_of_its_own_comes_first_once_it_is_kept() -> None:
    """It has only what the scene calls for."""
    pytest.importorskip("numba")
    scene = gas_of(60, 0.3, seed=1)
    simulate(scene, 0.1, compiled=True)
    plan = simulate(scene, 200.0, sample="end").plan
    assert (plan.code, plan.code_reason) == ("compiled", "its machine code was kept")


def test_numba_is_not_needed(nothing_kept: Path) -> None:
    """In a process in which it cannot be imported."""
    code = """
    import sys
    sys.modules["numba"] = None
    from lesson_code import simulate
    from lesson_code.evidence.scenes.speed import falling_discs
    plan = simulate(falling_discs(300), 3.0, sample="end").plan
    print(plan.code, plan.code_reason, sep="\\n")
    """
    assert tuple(printed(started(code))) == READY_MADE


# Files


def test_every_file_is_that_of_its_program() -> None:
    """And there is no other. What is not: make it with `workbook regenerate`."""
    assert common_programs.drifted(Path(__file__).parents[2]) == []


@pytest.fixture
def copied(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Return a copy of the folder of files, which stands in for it."""
    place = tmp_path / "bitcode"
    shutil.copytree(ready_made.FOLDER, place)
    monkeypatch.setattr(ready_made, "FOLDER", place)
    return place


def test_file_that_is_missing_old_broken_or_too_many_is_named(copied: Path) -> None:
    """Each in a line."""
    exact, substep, _, sequential, _ = map(ready_made.file_of, common_programs.common_programs())
    exact.unlink()
    first, _, content = substep.read_bytes().partition(b"\n")
    told = json.loads(first) | {"program": "another"}
    substep.write_bytes(json.dumps(told).encode() + b"\n" + content)
    sequential.write_bytes(b"no line of ours\n")
    shutil.copy(substep, copied / "stray.bitcode")
    lines = common_programs.drifted(copied.parent)
    assert [line.partition(" (")[0] for line in lines] == [
        "bitcode/exact.bitcode: is missing; make it with workbook regenerate",
        "bitcode/sequential.bitcode: cannot be read",
        "bitcode/stray.bitcode: has no source",
        "bitcode/substep.bitcode: differs from the functions it holds",
    ]


@pytest.mark.usefixtures("nothing_kept")
@pytest.mark.parametrize("damage", ["cut", "another version", "no file"])
def test_file_that_cannot_be_used_is_as_good_as_none(copied: Path, damage: str) -> None:
    """Runs then begin in plain Python, as those of other programs do."""
    program = common_programs.common_programs()["exact"]
    path = ready_made.file_of("exact")
    first, _, content = path.read_bytes().partition(b"\n")
    if damage == "no file":
        path.unlink()
    else:
        content = content[:-99] if damage == "cut" else _compressed(b"no bitcode of this LLVM")
        path.write_bytes(first + b"\n" + content)
    assert ready_made.finished(program) is None
    assert ready_made.finished(small_program()) is None


def _compressed(content: bytes) -> bytes:
    """Return what a file holds after its first line."""
    compressed: bytes = ready_made.lzma.compress(content)
    return compressed

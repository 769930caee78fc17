"""States that a program notes are those found by stopping after each step, to the last bit."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from lesson_code import Body, Callbacks, Circle, Material, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core import frames
from lesson_code.engine.core.frames import STATE_NUMBERS, Frames, frames_at_once
from lesson_code.engine.event_driven.solver import ExactSolver
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.gas import gas_of

ROUGH = Material(restitution=0.4, friction=0.5)

FRAMES = 25
"""Not a multiple of the frames that are noted at once."""


def rough(**scene: Any) -> Scene:
    """Return a box and a disc that fall on a floor."""
    floor = Body(Segment((-9, 0), (9, 0)), material=ROUGH)
    box = Body(Polygon.box(1, 1), mass=1, position=(0, 0.8), angle=0.3, material=ROUGH)
    disc = Body(Circle(0.5), mass=2, position=(0.4, 2), velocity=(1, 0), material=ROUGH)
    return Scene([floor, box, disc], gravity=(0, -10), **scene)


def smooth() -> Scene:
    """Return discs of which none ever turns, though one is drawn at an angle."""
    discs = [Body(Circle(0.5), mass=1, position=(2 * n, 0), angle=n) for n in range(3)]
    return Scene([*discs, Body(Circle(0.5), mass=1, position=(-3, 0.1), velocity=(4, 0))])


def listened() -> Scene:
    """Return a scene with a callback, after which the program cannot go on by itself."""
    return rough(callbacks=Callbacks(begin=lambda *_: True))


def bits(states: NDArray[np.float64]) -> bytes:
    """Return the bits of some states, those of 0 for -0."""
    return (states + 0.0).tobytes()


def states_in(found: Frames) -> NDArray[np.float64]:
    """Return the states in some frames, shape (F, N, 6)."""
    turning = [found.angles[..., np.newaxis], found.spins[..., np.newaxis]]
    return np.concatenate([found.positions, turning[0], found.velocities, turning[1]], axis=-1)


def few_at_once(monkeypatch: pytest.MonkeyPatch, bodies: int) -> None:
    """Have four frames noted at once, whether in plain Python or not."""
    monkeypatch.setattr(frames, "ROWS_AT_ONCE", 4 * bodies)
    monkeypatch.setattr(frames, "PLAIN_ROWS_AT_ONCE", 4 * bodies)


@pytest.mark.parametrize("make", [rough, smooth, listened])
@pytest.mark.parametrize(
    "settings",
    [
        {"solver": "sequential", "substeps": 1, "compiled": False},
        {"solver": "sequential", "substeps": 3, "compiled": False},
        {"solver": "substep", "substeps": 4, "compiled": False},
        {"solver": "direct", "substeps": 1, "compiled": False},
        pytest.param(
            {"solver": "sequential", "substeps": 1, "compiled": True}, marks=pytest.mark.full
        ),
    ],
    ids=lambda settings: "-".join(map(str, settings.values())),
)
def test_states_of_steps_are_those_found_by_stopping(
    monkeypatch: pytest.MonkeyPatch, make: Callable[[], Scene], settings: dict[str, Any]
) -> None:
    """In blocks of any number of steps, whatever solves the contacts."""
    scene = make()
    if settings["compiled"]:
        pytest.importorskip("numba")
        if scene.callbacks.wanted:
            pytest.skip("callbacks are Python functions")
    few_at_once(monkeypatch, len(scene.bodies))
    usual = {"dt": 0.02, "iterations": 10, "combine": MixingRule()}
    together, singly = (EngineStepper(scene, **usual, **settings) for _ in range(2))
    found = Frames(np.arange(FRAMES).tolist(), len(scene.bodies))
    together.note_steps(FRAMES, found, 0)
    expected = []
    for _ in range(FRAMES):
        singly.advance(1)
        expected.append(singly.states())
    assert bits(states_in(found)) == bits(np.array(expected))
    assert bits(together.events()) == bits(singly.events())


@pytest.mark.parametrize(
    ("compiled", "gravity"),
    [
        (False, (0.0, 0.0)),
        (False, (0.0, -10.0)),
        pytest.param(True, (0.0, 0.0), marks=pytest.mark.full),
    ],
)
def test_states_at_times_are_those_found_by_stopping(
    monkeypatch: pytest.MonkeyPatch, compiled: bool, gravity: tuple[float, float]
) -> None:
    """From event to event, also where several times lie between two events, and at one time."""
    if compiled:
        pytest.importorskip("numba")
    gas = gas_of(9, 0.3, seed=1)
    scene = Scene(gas.bodies, gravity=gravity)
    few_at_once(monkeypatch, 9)
    times = np.sort(np.append(np.random.default_rng(1).uniform(0, 2, FRAMES), [0.0, 1.0, 1.0]))
    together, singly = (
        ExactSolver(scene, combine=MixingRule(), compiled=compiled, duration=2.0) for _ in range(2)
    )
    found = Frames(times.tolist(), len(scene.bodies))
    together.note_frames(found)
    expected = []
    for time in times:
        singly.advance(time)
        expected.append(singly.states(time))
    assert together.collisions == singly.collisions > 5
    assert bits(states_in(found)) == bits(np.array(expected))


@pytest.mark.parametrize(
    ("bodies", "plain", "compiled"),
    [(0, 1024, 32768), (1, 1024, 32768), (100, 10, 327), (10**6, 1, 1)],
)
def test_frames_are_noted_in_blocks_of_bounded_size(bodies: int, plain: int, compiled: int) -> None:
    """Unless a single frame is larger."""
    assert frames_at_once(bodies, is_plain=True) == plain
    assert frames_at_once(bodies, is_plain=False) == compiled


@pytest.mark.parametrize("column", range(STATE_NUMBERS))
def test_frame_that_is_not_finite_is_told_with_its_body_and_time(column: int) -> None:
    """The first one of a block, whichever number is lost."""
    made = Frames([0.0, 0.5, 1.0], bodies=2)
    states = np.zeros((2, 2, STATE_NUMBERS))
    states[1, 1, column] = np.nan
    made.put(slice(1, 3), states)
    made.require_numbers(slice(1, 2))
    with pytest.raises(FloatingPointError, match=r"body 1 has left the range .* at 1\.0 s"):
        made.require_numbers(slice(1, 3))


def test_frames_come_back_in_the_order_that_was_asked_for() -> None:
    """Times that come twice keep their order, too."""
    asked = [0.5, 0.0, 1.0, 0.5]
    made = Frames(sorted(asked), bodies=1)
    made.put(slice(None), np.arange(4.0 * STATE_NUMBERS).reshape(4, 1, STATE_NUMBERS))
    found = made.in_order(asked)
    assert found.times.tolist() == asked
    assert (found.positions[:, 0, 0] / STATE_NUMBERS).tolist() == [1.0, 0.0, 3.0, 2.0]
    assert made.in_order(sorted(asked)) is made

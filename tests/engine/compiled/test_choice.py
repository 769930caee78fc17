"""Whether a run is compiled: by its work, by what is asked for, and by what is possible."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import pytest

from lesson_code import Body, Callbacks, Circle, Scene, Segment, simulate
from lesson_code.engine.compiled import choice
from lesson_code.engine.compiled.choice import WORTH_COMPILING, WORTH_LOADING, Choice, choose
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.stepper import choose_code


def unlooked() -> str:
    """Stand for the source of a program that nobody may ask for."""
    pytest.fail("linked for nothing")


@pytest.fixture
def kept(monkeypatch: pytest.MonkeyPatch) -> Callable[[bool], None]:
    """Return a way to say whether programs have been compiled before; Numba is there."""
    monkeypatch.setattr(choice, "why_no_compiler", lambda: "")
    return lambda answer: monkeypatch.setattr(choice, "is_kept", lambda _: answer)


@pytest.mark.parametrize(
    ("seconds", "is_kept", "expected"),
    [
        (0.0, True, (False, "a small run")),
        (0.99 * WORTH_LOADING, True, (False, "a small run")),
        (WORTH_LOADING, True, (True, "a large run")),
        (WORTH_LOADING, False, (False, "a run too small to wait for a compiler")),
        (0.99 * WORTH_COMPILING, False, (False, "a run too small to wait for a compiler")),
        (WORTH_COMPILING, False, (True, "a large run")),
        (1e6, False, (True, "a large run")),
    ],
)
def test_run_is_compiled_when_its_work_repays_it(
    kept: Callable[[bool], None], seconds: float, is_kept: bool, expected: tuple[bool, str]
) -> None:
    """From 2 s of plain Python a kept program is loaded, from 30 s on one is made."""
    kept(is_kept)
    assert choose(None, seconds, lambda: "") == expected


def test_program_of_a_small_run_is_not_even_linked() -> None:
    """Small scenes never wait."""
    assert choose(None, 0.0, unlooked).code == "plain Python"
    assert choose(False, 1e6, unlooked) == Choice(False, "asked for")


def test_run_that_is_asked_to_be_compiled_is(kept: Callable[[bool], None]) -> None:
    """However small."""
    kept(False)
    assert choose(True, 0.0, unlooked) == Choice(True, "asked for")
    assert Choice(True, "asked for").code == "compiled"


@pytest.mark.parametrize("seconds", [WORTH_LOADING, 1e6])
def test_large_run_that_cannot_be_compiled_says_why(
    kept: Callable[[bool], None], seconds: float
) -> None:
    """It runs, only more slowly."""
    kept(True)
    assert choose(None, seconds, unlooked, "of the moon") == Choice(False, "of the moon")


def test_run_that_cannot_be_compiled_but_is_asked_to_be_is_refused() -> None:
    """The error says why it cannot."""
    with pytest.raises(ValueError, match="compiled must be False or None here: of the moon"):
        choose(True, 0.0, unlooked, "of the moon")
    assert choose(False, 0.0, unlooked, "of the moon") == Choice(False, "asked for")


def falling(**scene: Any) -> Scene:
    """Return a disc over a floor."""
    return Scene(
        [Body(Segment((-1, 0), (1, 0))), Body(Circle(1), mass=1, position=(0, 2))], **scene
    )


def large_run(scene: Scene, solver: str) -> Choice:
    """Return what is chosen for a run that would take hours in plain Python."""
    return choose_code(scene, our_solvers()[solver], 1e9, 10, None, unlooked)


def test_scene_with_callbacks_runs_plain() -> None:
    """They are Python functions, which a compiled program cannot call."""
    scene = falling(callbacks=Callbacks(begin=lambda *_: True))
    words = "callbacks are Python functions"
    assert large_run(scene, "sequential") == Choice(False, words)
    with pytest.raises(ValueError, match=f"compiled must be False or None here: {words}"):
        simulate(scene, 0.0, compiled=True)


def test_direct_solver_runs_plain() -> None:
    """It works on arrays of its own."""
    assert not large_run(falling(), "direct").compiled
    with pytest.raises(ValueError, match="compiled must be False or None here: the direct solver"):
        simulate(falling(), 0.0, solver="direct", compiled=True)


def test_run_without_numba_is_plain_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever asks for compiled code is told what is missing."""
    monkeypatch.setitem(sys.modules, "numba", None)  # as if it were not installed
    assert simulate(falling(), 0.1).plan.code_reason == "a small run"
    large = large_run(falling(), "sequential")
    assert large == Choice(False, "Numba is not installed")
    with pytest.raises(ValueError, match="compiled must be False or None here: Numba is not inst"):
        simulate(falling(), 0.1, compiled=True)


@pytest.mark.parametrize("solver", ["pymunk", "box2d"])
def test_engine_that_is_not_ours_has_code_of_its_own(solver: str) -> None:
    """There is nothing to choose; before it is even loaded."""
    with pytest.raises(ValueError, match=f"compiled must be None for {solver}, got True"):
        simulate(falling(), 0.1, solver=solver, compiled=True)

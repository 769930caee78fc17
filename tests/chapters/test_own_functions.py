"""A program with a student's functions: whose run, and what is wrong with them."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters import programs
from lesson_code.chapters.own_functions import Watched, alike, load_own
from lesson_code.chapters.programs import load, program_summaries
from lesson_code.chapters.time_limit import call
from lesson_code.view.pygame.frame import play
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.picture import FIELD_SIZE, Picture
from lesson_code.view.pygame.program import Input
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import Window, pygame

EXERCISES = [name for name in program_summaries() if name not in ("simulator", "demo")]

ANGLED_RACK = "from lesson_code.chapters.pool.rules import rack\n"
WRONG_STRIKE = """
def strike(impulse, offset, mass, radius):
    return (2 * impulse[0] / mass, 2 * impulse[1] / mass), 0.0
"""


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder of exercises of a student's own."""
    (tmp_path / "exercises").mkdir()
    monkeypatch.setattr(programs, "find_root", lambda: tmp_path)
    return tmp_path / "exercises"


def test_panel_says_whose_functions_run_and_which_differ(write: Path) -> None:
    """Before a call, after a right answer, after a wrong one; the first wrong one is named."""
    (write / "pool.py").write_text(ANGLED_RACK + WRONG_STRIKE)
    own = load_own("pool")
    game = own.program.game(0, **own.settings)
    assert own.program.readings(game)[:2] == [
        ("rack", "yours, as the lesson's"),
        ("strike", "yours, not called yet"),
    ]
    game.take(Input("down", place=(0.2, 0.6)))
    game.take(Input("up", place=(0.2, 0.6)))
    assert own.program.readings(game)[1] == ("strike", "yours, and not the lesson's")
    strike = own.settings["rules"].strike
    assert strike.difference.startswith("strike((")
    assert "the lesson's is ((" in strike.difference


def test_ghost_is_the_lesson_s_answer_beside_the_student_s(
    write: Path, program_window: Window
) -> None:
    """A ball struck twice too hard runs ahead of its ghost, and both are seen."""
    (write / "pool.py").write_text(ANGLED_RACK + WRONG_STRIKE)
    own = load_own("pool")
    assert own.is_compared
    game, ghost = own.program.game(0, **own.settings), own.program.game(0)
    session = Session(own.program, game, Recording("pool", 0), ghost)
    session.give(Input("down", place=(0.55, 0.635)))
    session.give(Input("up", place=(0.55, 0.635)))
    for _ in range(20):
        session.step()
    mine, lesson = (np.array(one.world.position(0)) for one in (game, ghost))
    start = np.array((0.635, 0.635))
    assert np.linalg.norm(mine - start) > 1.5 * np.linalg.norm(lesson - start) > 0.02
    picture = Picture(program_window, own.program.camera)
    painter = Painter(session, picture)
    painter.draw()
    x, y = picture.camera.world_to_screen((float(lesson[0]), float(lesson[1])))
    with_ghost = program_window.surface.get_at((round(x), round(y)))
    session.ghost = None
    painter.draw()
    assert program_window.surface.get_at((round(x), round(y))) != with_ghost


@pytest.mark.parametrize("name", EXERCISES)
def test_exercise_that_is_not_written_says_so(name: str) -> None:
    """Each of the seven runs with the fresh exercise; no function is called the lesson's."""
    own = load_own(name)
    outcome = play(
        own.program, frames=3, headless=True, settings=own.settings, beside=own.is_compared
    )
    rows = own.program.readings(outcome.game)[: len(own.program.own)]
    assert {words for _, words in rows} <= {"not written yet", "yours, not called yet"}


@pytest.mark.parametrize("name", EXERCISES)
def test_lesson_s_own_functions_differ_nowhere(name: str) -> None:
    """Watched in place of a student's, they leave the picture of the lesson alone, bit for bit."""
    program = load_own(name).program
    assert program.with_own is not None
    watched = [Watched(one, one) for one in program.own]
    settings = program.with_own(*watched)
    plain = play(program, frames=40, headless=True, tour=True).game
    shown = play(program, frames=40, headless=True, tour=True, settings=settings).game
    assert (plain.snapshot() == shown.snapshot()).all()
    assert [one.difference for one in watched] == [""] * len(watched)


def raises(*arguments: Any) -> Any:
    """Divide by zero."""
    return 1 / 0


def gives_nothing(*arguments: Any) -> Any:
    """Forget to return."""


def gives_words(*arguments: Any) -> Any:
    """Return what is no number."""
    return "forward"


def gives_too_many(*arguments: Any) -> Any:
    """Return more than was asked for."""
    return [[1.0, 2.0, 3.0]] * 7


def gives_nan(*arguments: Any) -> Any:
    """Return a number that is none, where numbers are asked for."""
    return float("nan")


@pytest.mark.parametrize("bad", [raises, gives_nothing, gives_words, gives_too_many, gives_nan])
@pytest.mark.parametrize("name", EXERCISES)
def test_program_goes_on_whatever_a_function_does_and_says_what(
    name: str, bad: Callable[..., Any]
) -> None:
    """Each of the seven plays its tour with functions that fail or give what is of no use."""
    program = load_own(name).program
    assert program.with_own is not None
    watched = []
    for one in program.own:
        bad.__name__ = one.__name__
        watched.append(Watched(bad, one))
    game = play(
        program, frames=60, headless=True, tour=True, settings=program.with_own(*watched)
    ).game
    assert np.isfinite(game.snapshot()).all()
    assert game.missing
    for one in watched:
        if one in game.missing:
            assert game.missing[one].startswith(f"{one.__name__} failed: ")
            assert one.difference.startswith(f"{one.__name__}(")
            assert one.reading()[1] == "yours, and not the lesson's"


@pytest.mark.parametrize("name", EXERCISES)
def test_program_goes_on_where_a_function_never_ends(
    name: str, write: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is interrupted once, named, and not called again, in each of the seven."""
    monkeypatch.setattr(programs, "MOST_SECONDS", 0.1)
    path = write / f"{name}.py"
    path.write_text("CALLED = []\n" + "".join(map(endless, load_own(name).program.own)))
    own = load_own(name)
    game = play(own.program, frames=60, headless=True, tour=True, settings=own.settings).game
    assert game.missing
    for rule, why in game.missing.items():
        assert why == f"{rule.__name__} failed: TimeoutError: has not ended within 0.1 s"
    called = programs._module(path).CALLED
    assert {rule.__name__ for rule in game.missing} <= {*called}
    assert len(called) == len({*called})


def endless(function: Callable[..., Any]) -> str:
    """Return the source of a function that never ends, and catches what it can."""
    return (
        f"def {function.__name__}(*given):\n"
        f"    CALLED.append({function.__name__!r})\n"
        "    while True:\n"
        "        try: 1 / 0\n"
        "        except Exception: pass\n"
    )


def test_calls_that_are_in_time_return_their_answers() -> None:
    """Thousands in a row, though all together take longer than one may."""
    assert [call(0.01, abs, -n) for n in range(10_000)] == [*range(10_000)]


def test_time_that_is_up_does_not_reach_what_comes_after_the_call() -> None:
    """Of calls that end just when their time does each returns or raises, and nothing follows."""
    ended = 0
    for _ in range(20):
        try:
            call(0.01, count_for, 0.05)
        except TimeoutError:
            ended += 1
    assert ended > 0
    assert sum(range(200_000)) == 199_999 * 100_000


def test_profiler_still_works_after_calls_that_were_in_time_and_late() -> None:
    """CPython 3.11 hangs in a profiled function while it believes that an exception is to come."""
    with pytest.raises(TimeoutError, match=r"not ended within 0\.01 s"):
        call(0.01, count_for, 10.0)
    call(0.01, abs, -1)
    seen = []
    sys.setprofile(lambda *told: seen.append(told[1]))
    try:
        count_for(0.0)
    finally:
        sys.setprofile(None)
    assert "call" in seen


def count_for(seconds: float) -> None:
    """Keep the processor busy for a time, s."""
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def test_notice_that_is_long_is_written_in_lines(program_window: Window) -> None:
    """All of it is seen: a box as wide as the field at most."""
    picture = Picture(program_window, load("pool").camera)
    picture.notice(
        "split failed: ValueError: answer must be 3 x 2 finite numbers, got " + "0, " * 40
    )
    drawn = np.argwhere(pygame.surfarray.array2d(program_window.surface))
    assert drawn[:, 0].min() > 0
    assert np.ptp(drawn[:, 0]) < FIELD_SIZE[0]


def test_program_that_is_no_exercise_is_refused() -> None:
    """The simulator has nothing to write."""
    with pytest.raises(ValueError, match=r"--with exercises needs .* got 'simulator'"):
        load_own("simulator")


@pytest.mark.parametrize(
    ("answer", "expected", "same"),
    [
        (1.0, 1.0 + 1e-12, True),
        (1.0, 1.001, False),
        ([1.0, 2.0], np.array([1.0, 2.0]), True),
        ([1.0], [1.0, 2.0], False),
        (None, 1.0, False),
        (((0.0, 1.0), ["top"]), ((0.0, 1.0), ["left"]), False),
        ("top", ["t", "o", "p"], False),
    ],
)
def test_answers_are_alike_up_to_rounding(answer: object, expected: object, same: bool) -> None:
    """Lists and arrays are one; lengths, names and kinds are not."""
    assert alike(answer, expected) is same


def test_program_is_still_the_lesson_s_without_the_option() -> None:
    """`load` knows nothing of exercises."""
    assert "yours" not in str(load("pool").readings(load("pool").game(0)))

"""A program with a student's functions: whose run, and what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from lesson_code.chapters import programs
from lesson_code.chapters.own_functions import Watched, alike, load_own
from lesson_code.chapters.programs import load, program_summaries
from lesson_code.cli import app
from lesson_code.view.pygame.frame import play
from lesson_code.view.pygame.game import Input
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.picture import FIELD_SIZE, Picture
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
    """Each of the seven plays its tour with the fresh exercise as the lesson's, bit for bit.

    No function is called the player's: each that is asked for is lent and named.
    """
    own = load_own(name)
    assert own.program.with_own is not None
    game = play(own.program, frames=60, headless=True, tour=True, settings=own.settings).game
    settings = own.program.with_own(*own.program.own)
    lesson = play(own.program, frames=60, headless=True, tour=True, settings=settings).game
    assert (game.snapshot() == lesson.snapshot()).all()
    rows = own.program.readings(game)[: len(own.program.own)]
    assert {words for _, words in rows} <= {"lent, not written yet", "yours, not called yet"}
    assert game.missing
    for said in game.missing.values():
        assert said.startswith("not written yet: Task ")
        assert said.endswith(f", in exercises/{name}.py; the lesson's runs now")


THREE = {
    "pool": ("strike", "impulse_for_velocity", "strike"),
    "billiards": ("resolve", "scales_the_tangent", "advance"),
    "breakout": ("paddle_bounce", "gains_speed", "paddle_bounce"),
}
"""Three programs; in each a function, a wrong model of it, and the function that shows it."""


@pytest.mark.one_in(5)
@pytest.mark.parametrize("is_wrong", [False, True])
@pytest.mark.parametrize("name", THREE)
def test_program_runs_on_solved_exercises_and_names_the_one_that_is_wrong(
    name: str, is_wrong: bool, solved: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As it is played in a terminal, which says at the end whose functions ran and what differs."""
    monkeypatch.setattr(programs, "find_root", lambda: solved)
    function, model, shows = THREE[name]
    if is_wrong:
        chapter = f"lesson_code.chapters.{name}.wrong_answers"
        with (solved / "exercises" / f"{name}.py").open("a", encoding="utf-8") as file:
            file.write(f"\nfrom {chapter} import {model}\n{function} = {model}.function\n")
    options = ("--with", "exercises", "--headless", "--tour", "--frames", "240")
    result = CliRunner().invoke(app, ["play", name, *options])
    assert result.exit_code == 0
    _, *said = result.stdout.splitlines()
    others = [one.__name__ for one in load(name).own if not is_wrong or one.__name__ != shows]
    assert [f"{one}: yours, as the lesson's" for one in others] == [
        line for line in said if line.endswith("as the lesson's")
    ]
    assert (f"{shows}: yours, and not the lesson's" in said) is is_wrong
    differs = [line for line in said if line.startswith(f"{shows}(")]
    assert len(differs) == is_wrong
    assert len(said) == len(others) + 2 * is_wrong


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


@pytest.mark.one_in(3)
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


def never_ends(*arguments: Any) -> Any:
    """Forget to leave a loop."""
    while True:
        pass


@pytest.mark.parametrize(
    ("bad", "said", "whose"),
    [
        (never_ends, "no answer within 0.1 s", "the lesson's"),
        (raises, "ZeroDivisionError: division by zero", "yours, and not the lesson's"),
    ],
)
@pytest.mark.parametrize("name", EXERCISES)
def test_program_goes_on_by_the_lesson_where_a_function_gives_no_answer(
    name: str, bad: Callable[..., Any], said: str, whose: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each of the seven plays its tour on as the lesson's, bit for bit; the call is named.

    The picture says what it was, and so does the panel. What never ends is called once.
    """
    monkeypatch.setattr(programs.LIMIT, "seconds", 0.1)
    program = load_own(name).program
    assert program.with_own is not None
    watched = []
    for one in program.own:
        bad.__name__ = one.__name__
        watched.append(Watched(bad, one))
    settings = program.with_own(*watched)
    game = play(program, frames=60, headless=True, tour=True, settings=settings).game
    lesson = program.with_own(*program.own)
    plain = play(program, frames=60, headless=True, tour=True, settings=lesson).game
    assert (game.snapshot() == plain.snapshot()).all()
    assert game.missing
    for one in watched:
        if one in game.missing:
            assert game.missing[one].startswith(f"{one.__name__} failed: ")
            assert game.missing[one].endswith(f"{said}; the lesson's runs now")
            assert one.difference.startswith(f"{one.__name__}(")
            assert one.difference.endswith(said)
            assert one.reading()[1] == whose


@pytest.mark.parametrize("is_bare", [False, True])
@pytest.mark.parametrize("name", EXERCISES)
def test_students_copy_goes_on_when_a_function_never_ends(
    name: str, is_bare: bool, write: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where the lesson's answers are not there, it goes on as for any function that fails.

    With `--with exercises`, and bare: in a student's copy they stand where the lesson's would.
    """
    monkeypatch.setattr(programs.LIMIT, "seconds", 0.1)
    program = load_own(name).program
    lines = [f"def {one.__name__}(*given):\n    while True:\n        pass\n" for one in program.own]
    (write / f"{name}.py").write_text("\n".join(lines))
    assert program.with_own is not None
    answers = [programs.own_answer(name, one.__name__) for one in program.own]
    rules = answers if is_bare else [Watched(one, one) for one in answers]
    settings = program.with_own(*rules)
    game = play(program, frames=60, headless=True, tour=True, settings=settings).game
    assert np.isfinite(game.snapshot()).all()
    assert game.missing
    assert all(said.endswith("no answer within 0.1 s") for said in game.missing.values())


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

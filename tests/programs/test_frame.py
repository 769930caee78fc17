"""The frame that programs share: time, keys, recordings, pictures, errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from lesson_code.programs.catalogue import SUMMARIES, load
from lesson_code.programs.frame import SLOW_MOTION, Session, play
from lesson_code.programs.game import Input
from lesson_code.programs.live_world import TIME_STEP
from lesson_code.programs.recording import Recording
from lesson_code.view.pygame_view import Window, pygame

DEMO = load("demo")


@pytest.fixture
def session(program_window: Window) -> Session:
    """Return a session of the demo."""
    return Session(DEMO, DEMO.game(1), Recording("demo", 1))


def press(one: Session, name: int) -> None:
    """Press a key."""
    one.handle(pygame.event.Event(pygame.KEYDOWN, key=name))


def test_steps_do_not_depend_on_the_frames(session: Session) -> None:
    """A tenth of a second is six steps, in one frame or in many."""
    whole = session.tick(0.1)
    parts = sum(session.tick(0.1 / 7) for _ in range(7))
    assert (whole, parts) == (6, 6)


def test_rest_of_a_frame_is_kept(session: Session) -> None:
    """Frames of 1.5 steps make one step and two in turn."""
    assert [session.tick(1.5 * TIME_STEP) for _ in range(4)] == [1, 2, 1, 2]


def test_long_frame_counts_as_a_tenth_of_a_second(session: Session) -> None:
    """After a minute's sleep the world does not have to catch up."""
    assert session.tick(60.0) == 6


def test_pause_stops_time_and_one_step_is_one(session: Session) -> None:
    """P stops, O makes one step, P goes on."""
    press(session, pygame.K_p)
    assert session.tick(0.1) == 0
    press(session, pygame.K_o)
    assert [session.tick(0.1), session.tick(0.1)] == [1, 0]
    press(session, pygame.K_p)
    assert session.tick(0.1) == 6


def test_slow_motion_is_slow(session: Session) -> None:
    """A second takes a fifth of its steps."""
    press(session, pygame.K_l)
    steps = sum(session.tick(TIME_STEP) for _ in range(60))
    assert steps == round(60 * SLOW_MOTION)


def test_shared_keys_never_reach_the_game(session: Session) -> None:
    """Pause, step, slow motion, mute and quit are written down nowhere."""
    for name in (pygame.K_p, pygame.K_o, pygame.K_l, pygame.K_m, pygame.K_ESCAPE):
        press(session, name)
    assert session.recording.as_dict(0)["inputs"] == []
    assert not session.running


@pytest.mark.parametrize("kind", ["QUIT", "K_ESCAPE"])
def test_window_is_closed_by_its_button_and_by_escape(session: Session, kind: str) -> None:
    """Both end the session."""
    if kind == "QUIT":
        session.handle(pygame.event.Event(pygame.QUIT))
    else:
        press(session, pygame.K_ESCAPE)
    assert not session.handle_all([])


def test_click_in_the_panel_is_no_click_in_the_world(session: Session) -> None:
    """The demo adds a circle in the field, and none beside it."""
    bodies = len(session.game.world)
    for x, expected in ((900, bodies), (400, bodies + 1)):
        session.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=(x, 40), button=1))
        assert len(session.game.world) == expected


@pytest.mark.parametrize("name", SUMMARIES)
def test_recording_played_again_gives_the_same_world(name: str, tmp_path: Path) -> None:
    """Bit for bit: inputs come before the very steps they came before."""
    file = tmp_path / "played.json"
    first = play(load(name), seed=4, frames=100, headless=True, tour=True, record=file)
    again = play(load(name), headless=True, replay=file)
    assert again.steps == first.steps == 100
    assert (again.game.world.states() == first.game.world.states()).all()


def test_recording_says_what_it_is(tmp_path: Path) -> None:
    """One JSON object with version, program, seed, steps and inputs."""
    file = tmp_path / "played.json"
    play(DEMO, seed=5, frames=70, headless=True, tour=True, record=file)
    stored = json.loads(file.read_text())
    assert (stored["version"], stored["program"], stored["seed"], stored["steps"]) == (
        1,
        "demo",
        5,
        70,
    )
    assert [60, "press", "space", 0.0, 0.0] in stored["inputs"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{}",
        '{"program": "demo", "seed": 0, "steps": 1, "inputs": [[0, "fly", "", 0, 0]]}',
        '{"program": "demo", "seed": 0, "steps": 1, "inputs": [[0]]}',
        '{"program": "pool", "seed": 0, "steps": 1, "inputs": []}',
        '{"program": "demo", "seed": "x", "steps": 1, "inputs": []}',
    ],
)
def test_replay_of_no_recording_is_refused(text: str, tmp_path: Path) -> None:
    """What is no recording of this program is an error that names the argument."""
    file = tmp_path / "no.json"
    file.write_text(text)
    with pytest.raises(ValueError, match="replay must be a recording"):
        play(DEMO, headless=True, replay=file)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"headless": True}, "frames must be given when headless"),
        ({"frames": -1}, "frames must be a whole number >= 0, got -1"),
        ({"frames": 1, "screenshot": "x.jpg"}, r"screenshot must end in \.png"),
        ({"frames": 1, "record": "x.txt"}, r"record must end in \.json"),
    ],
)
def test_run_that_cannot_end_or_be_saved_is_refused(options: dict[str, Any], words: str) -> None:
    """Before anything is drawn."""
    with pytest.raises(ValueError, match=words):
        play(DEMO, **options)


def test_unknown_program_is_refused() -> None:
    """The error lists those that there are."""
    with pytest.raises(ValueError, match=r"program must be one of simulator, demo, .* got 'chess'"):
        load("chess")


def test_played_recording_takes_no_other_input(program_window: Window) -> None:
    """Nobody disturbs a replay."""
    recording = Recording("demo", 1)
    recording.is_played = True
    one = Session(DEMO, DEMO.game(1), recording)
    one.give(Input("press", "c"))
    assert len(one.game.world) == 11

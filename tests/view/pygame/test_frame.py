"""The frame that programs share: time, keys, recordings, pictures, errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageChops

from lesson_code.chapters.programs import load, program_summaries
from lesson_code.engine.any_scene import program_for_any_scene
from lesson_code.engine.compiled.compiler import compiled
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.frame import FILM_HEIGHT, play
from lesson_code.view.pygame.game import Input
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import SLOW_MOTION, Session
from lesson_code.view.pygame.window import Window, pygame

DEMO = load("demo")

NEARLY_ALIKE = 0.5
"""Levels of 255, on average: a film has 255 colours, and nearly all of a picture few."""


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


def test_pause_holds_the_sounds_and_going_on_lets_them_go(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    """P holds what is heard, O keeps it held, and P again lets it go on."""
    sounds = session.effects.sounds
    assert sounds is not None
    held: list[bool] = []
    monkeypatch.setattr(sounds, "hold", held.append)
    for key in (pygame.K_p, pygame.K_o, pygame.K_p):
        press(session, key)
    assert held == [True, True, False]


def test_what_shared_keys_have_changed_is_shown(
    session: Session, program_window: Window, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Pause, slow motion and mute stand in the panel until the same key is pressed again."""
    painter = Painter(session, Picture(program_window, DEMO.camera))
    written: list[str] = []
    real_text = Window.text

    def noted(self: Window, words: str, *args: Any, **kwargs: Any) -> pygame.Rect:
        written.append(words)
        return real_text(self, words, *args, **kwargs)

    monkeypatch.setattr(Window, "text", noted)
    for key, words in ((pygame.K_p, "PAUSED"), (pygame.K_l, "0.2 x"), (pygame.K_m, "muted")):
        for is_shown in (True, False):
            press(session, key)
            written.clear()
            painter.draw()
            assert (words in written) is is_shown


@pytest.mark.parametrize(
    ("lives", "level", "words"),
    [(3, 1, ""), (0, 1, "Game over: R plays again"), (1, 6, "All levels done: R plays again")],
)
def test_end_of_a_game_is_told_in_the_field(
    program_window: Window,
    monkeypatch: pytest.MonkeyPatch,
    lives: int,
    level: int,
    words: str,
) -> None:
    """In the one box that there is; a pause stands in the panel, where it hides nothing."""
    breakout = load("breakout")
    game: Any = breakout.game(0)
    game.lives, game.level = lives, level
    one = Session(breakout, game, Recording("breakout", 0))
    painter = Painter(one, Picture(program_window, breakout.camera))
    told: list[str] = []
    monkeypatch.setattr(Picture, "notice", lambda _, words: told.append(words))
    painter.draw()
    press(one, pygame.K_p)
    painter.draw()
    assert told == [words, words]
    assert one.switched() == [("PAUSED", "P goes on")]


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
    for x, expected in ((1100, bodies), (400, bodies + 1)):
        session.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=(x, 40), button=1))
        assert len(session.game.world) == expected


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", program_summaries())
def test_recording_played_again_gives_the_same_world(name: str, tmp_path: Path) -> None:
    """Bit for bit: inputs come before the very steps they came before."""
    file = tmp_path / "played.json"
    first = play(load(name), seed=4, frames=100, headless=True, tour=True, record=file)
    again = play(load(name), headless=True, replay=file)
    assert again.steps == first.steps == 100
    assert (again.game.snapshot() == first.game.snapshot()).all()


def test_recording_of_another_number_of_balls_is_played_with_as_many(tmp_path: Path) -> None:
    """A setting belongs to the world as the seed does."""
    file = tmp_path / "played.json"
    simulator = load("simulator")
    first = play(simulator, frames=20, headless=True, record=file, settings={"balls": 30})
    again = play(simulator, headless=True, replay=file, settings={"balls": 12})
    assert (again.game.snapshot() == first.game.snapshot()).all()


@pytest.mark.parametrize(
    ("program", "settings", "words"),
    [
        ("demo", {"balls": 3}, "settings must be those of demo: .*'balls'"),
        ("simulator", {"balls": -1}, "balls must be a whole number from 0 to 600, got -1"),
        ("simulator", {"balls": 10**9}, "balls must be a whole number from 0 to 600"),
    ],
)
def test_settings_that_are_none_are_refused(
    program: str, settings: dict[str, Any], words: str
) -> None:
    """Whether they come from a caller or out of a file."""
    with pytest.raises(ValueError, match=words):
        play(load(program), frames=1, headless=True, settings=settings)


def test_world_that_has_become_large_goes_on_in_machine_code(tmp_path: Path) -> None:
    """Twelve balls and a hundred more, which fly: the result is that of plain steps, to the bit."""
    compiled(program_for_any_scene("exact"))
    inputs = tmp_path / "more.json"
    recording = Recording("simulator", 0)
    for _ in range(2):
        recording.note(5, Input("press", "b"))
    recording.write(inputs, 30)
    shown = play(load("simulator"), headless=True, replay=inputs).game
    alone = load("simulator").game(0)
    for k in range(30):
        for _ in range(2 if k == 5 else 0):
            alone.press("b")
        alone.step()
    assert shown.world.compiled
    assert (shown.snapshot() == alone.snapshot()).all()


@pytest.mark.full
def test_dominoes_go_on_in_machine_code() -> None:
    """Their tour, plain at first, ends where that in plain Python ends, bit for bit.

    They are stood up anew after 330 steps: that world goes on in machine code, too.
    """
    compiled(program_for_any_scene("substep"))
    program = load("dominoes")
    shown = play(program, frames=360, headless=True, tour=True).game
    alone = Session(program, program.game(0), Recording("dominoes", 0))
    alone.tour = program.tour
    for _ in range(360):
        alone.step()
    assert (shown.world.compiled, alone.game.world.compiled) == (True, False)
    assert (shown.snapshot() == alone.game.snapshot()).all()


def test_world_that_is_never_stepped_is_not_compiled() -> None:
    """Soft bodies move by themselves, and the world only shows them."""
    game = play(load("soft_body"), frames=5, headless=True, tour=True).game
    assert not game.world.wants_code


def test_film_is_the_same_for_the_same_seed_and_inputs(tmp_path: Path) -> None:
    """Filmed while it plays itself, or from a recording of that: the same bytes."""
    names = ("tour.gif", "again.gif", "inputs.json", "replay.gif", "other.gif")
    tour, again, inputs, replay, other = (tmp_path / name for name in names)
    for seed, file in ((4, tour), (4, again), (4, inputs), (5, other)):
        play(load("simulator"), seed=seed, frames=30, headless=True, tour=True, record=file)
    outcome = play(load("simulator"), headless=True, replay=inputs, record=replay)
    assert tour.read_bytes() == again.read_bytes() == replay.read_bytes()
    assert tour.read_bytes() != other.read_bytes()
    assert outcome.film is not None
    assert outcome.film.pictures == 11


def test_film_ends_with_what_the_screenshot_shows(tmp_path: Path) -> None:
    """Both show the last frame; the film in fewer colours, and smaller."""
    picture, film = tmp_path / "last.png", tmp_path / "film.gif"
    options: Any = {"frames": 30, "headless": True, "tour": True}
    play(DEMO, screenshot=picture, record=film, **options)
    with Image.open(picture) as image, Image.open(film) as last:
        last.seek(10)
        assert last.height == FILM_HEIGHT
        small = image.convert("RGB").resize(last.size, Image.Resampling.HAMMING)
        off = ImageChops.difference(small, last.convert("RGB"))
    assert np.asarray(off).mean() < NEARLY_ALIKE


def test_replay_that_is_too_long_for_a_film_is_refused(tmp_path: Path) -> None:
    """The length stands in the recording; nothing is written."""
    inputs, film = tmp_path / "long.json", tmp_path / "film.gif"
    Recording("demo", 0).write(inputs, 1801)
    with pytest.raises(ValueError, match="frames must be <= 1800 for a film"):
        play(DEMO, headless=True, replay=inputs, record=film)
    assert not film.exists()


def test_recording_says_what_it_is(tmp_path: Path) -> None:
    """One JSON object with version, program, seed, steps and inputs."""
    file = tmp_path / "played.json"
    play(DEMO, seed=5, frames=310, headless=True, tour=True, record=file)
    stored = json.loads(file.read_text())
    assert (stored["version"], stored["program"], stored["seed"], stored["steps"]) == (
        1,
        "demo",
        5,
        310,
    )
    assert [300, "press", "space", 0.0, 0.0] in stored["inputs"]


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
        '{"program": "demo", "seed": 1, "settings": [], "steps": 1, "inputs": []}',
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
        ({"frames": 1.5}, "frames must be a whole number >= 0, got 1.5"),
        ({"frames": 1, "screenshot": "x.jpg"}, r"screenshot must end in \.png"),
        ({"frames": 1, "record": "x.txt"}, r"record must end in \.json or \.gif, got 'x\.txt'"),
        ({"frames": 1, "record": "no/x.json"}, "record must lie in a folder that there is, got"),
        ({"frames": 1801, "record": "x.gif"}, r"frames must be <= 1800 for a film \(30 s\), got"),
    ],
)
def test_run_that_cannot_end_or_be_saved_is_refused(options: dict[str, Any], words: str) -> None:
    """Before anything is drawn."""
    with pytest.raises(ValueError, match=words):
        play(DEMO, **options)


def test_outcome_tells_the_time_of_each_frame() -> None:
    """Two numbers a frame; a part of the frames keeps within their sum."""
    outcome = play(DEMO, frames=5, headless=True)
    assert outcome.seconds.shape == (5, 2)
    assert (outcome.seconds >= 0).all()
    assert outcome.within(1.0) == outcome.seconds.sum(axis=1).max()
    none = play(DEMO, frames=0, headless=True)
    assert (none.frames, none.within(0.95)) == (0, 0.0)


def test_unknown_program_is_refused() -> None:
    """The error lists those that there are."""
    with pytest.raises(
        ValueError, match=r"program must be one of asteroids, billiards, .* got 'chess'"
    ):
        load("chess")


def test_played_recording_takes_no_other_input(program_window: Window) -> None:
    """Nobody disturbs a replay."""
    recording = Recording("demo", 1)
    recording.is_played = True
    one = Session(DEMO, DEMO.game(1), recording)
    one.give(Input("press", "c"))
    assert len(one.game.world) == 11

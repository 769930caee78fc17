"""What the frame does to any game: keys, mouse, sliders, set-ups, the way back, the ledger."""

from __future__ import annotations

import csv
import threading
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle
from lesson_code.chapters.programs import load, program_summaries
from lesson_code.engine.compiled import ready_made
from lesson_code.engine.live_world import LiveWorld
from lesson_code.view.pygame import frame
from lesson_code.view.pygame.frame import MachineCode, _do_wanted, free_name, play
from lesson_code.view.pygame.game import Input
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import ACTIONS, SLIDERS, STEPS_A_SAVE, Session
from lesson_code.view.pygame.window import Window, pygame

ROUNDING = 1e-9
"""J, of energies of some 100 J that are summed up over some hundred steps."""


@pytest.fixture
def begin(program_window: Window) -> Callable[[str], Session]:
    """Return a function that begins a session of a program, by its name."""

    def made(name: str) -> Session:
        program = load(name)
        return Session(program, program.game(2), Recording(name, 2))

    return made


def click(session: Session, kind: int, place: tuple[float, float], button: int = 1) -> None:
    """Press or release a button, or move, at a place of the world."""
    x, y = session.camera.world_to_screen(place)
    pixel = round(x), round(y)
    session.handle(pygame.event.Event(kind, pos=pixel, button=button))


@pytest.mark.one_in(2)
@pytest.mark.parametrize("name", program_summaries())
def test_step_back_is_the_state_that_was_there(begin: Callable[[str], Session], name: str) -> None:
    """Bit for bit, across inputs and saved states; and on again by the same way."""
    session = begin(name)
    session.tour = session.program.tour
    states = []
    for _ in range(STEPS_A_SAVE + 5):
        states.append(session.game.snapshot())
        session.step()
    for k in range(1, 11):
        session.step_back()
        assert (session.game.snapshot() == states[-k]).all()
    assert session.steps == len(states) - 10
    assert session.ledger.last.time == pytest.approx(session.steps / 60)
    session.step()
    assert (session.game.snapshot() == states[-9]).all()


def test_step_back_from_the_start_stays_there(begin: Callable[[str], Session]) -> None:
    """There is nothing before the first step."""
    session = begin("demo")
    first = session.game.snapshot()
    session.press("u")
    assert (session.game.snapshot() == first).all()
    assert session.paused


def test_restart_comes_back_to_what_the_user_has_kept(begin: Callable[[str], Session]) -> None:
    """S keeps a moment, R returns to it as often as one likes, BACKSPACE to the program's own."""
    session = begin("demo")
    first = session.game.snapshot()
    for _ in range(20):
        session.step()
    session.press("s")
    kept = session.game.snapshot()
    for _ in range(2):
        for _ in range(10):
            session.step()
        assert (session.game.snapshot() != kept).any()
        session.press("r")
        assert (session.game.snapshot() == kept).all()
    session.press("backspace")
    assert (session.game.snapshot() == first).all()
    session.press("r")
    assert (session.game.snapshot() == first).all()


def test_slider_stays_after_a_restart(begin: Callable[[str], Session]) -> None:
    """R begins anew with my gravity and my friction; the program's own come with BACKSPACE."""
    session = begin("demo")
    session.slide("gravity", 5.0)
    session.slide("friction", 0.7)
    session.press("r")
    values = {name: value for name, (*_, value) in session.slider_values().items()}
    assert (values["gravity"], values["friction"]) == (5.0, 0.7)
    session.press("backspace")
    values = {name: value for name, (*_, value) in session.slider_values().items()}
    assert (values["gravity"], values["friction"]) == (0.0, 0.2)


def test_gravity_by_slider_is_the_fall_of_a_body(begin: Callable[[str], Session]) -> None:
    """After half a second at 4 m/s^2 from rest a free body moves at 2 m/s."""
    session = begin("simulator")
    session.press("c")
    session.press("2")
    session.give(Input("down", place=(4.0, 5.0)))
    session.give(Input("up", place=(4.0, 5.0)))
    session.slide("gravity", 4.0)
    for _ in range(30):
        session.step()
    assert session.game.matter().states[0, 3:5] == pytest.approx((0.0, -2.0))


def test_mass_by_slider_is_that_of_the_body_last_grabbed(begin: Callable[[str], Session]) -> None:
    """Its velocity stays, so its momentum grows as its mass; the others are as they were."""
    session = begin("demo")
    number = session.game.world.numbers[4]
    before = session.game.matter().mass.copy()
    click(session, pygame.MOUSEBUTTONDOWN, session.game.world.position(number), 3)
    session.slide("mass", 8.0)
    after = session.game.matter().mass
    assert after[0] == pytest.approx(8.0)
    assert (after[1:] == before[1:]).all()


def test_rail_of_a_slider_is_dragged(
    begin: Callable[[str], Session], program_window: Window
) -> None:
    """TAB shows the rails; a press at the right end and a drag to the middle set what is there."""
    session = begin("demo")
    session.press("tab")
    Painter(session, Picture(program_window, session.program.camera)).draw()
    assert list(session.rails) == list(SLIDERS)
    rail = session.rails["restitution"]
    for kind, x, expected in (
        (pygame.MOUSEBUTTONDOWN, rail.right - 1, 1.0),
        (pygame.MOUSEMOTION, rail.centerx, 0.5),
        (pygame.MOUSEMOTION, rail.left - 300, 0.0),
    ):
        session.handle(pygame.event.Event(kind, pos=(x, rail.centery), button=1))
        assert session.slider_values()["restitution"][3] == pytest.approx(expected, abs=0.01)


def test_body_that_is_grabbed_comes_to_the_mouse(begin: Callable[[str], Session]) -> None:
    """Within a second its middle is where the mouse is; let go, it is free again."""
    session = begin("demo")
    number = session.game.world.numbers[4]
    click(session, pygame.MOUSEBUTTONDOWN, session.game.world.position(number), 3)
    click(session, pygame.MOUSEMOTION, (4.0, 3.5))
    for _ in range(60):
        session.step()
    assert session.game.world.position(number) == pytest.approx((4.0, 3.5), abs=0.05)
    click(session, pygame.MOUSEBUTTONUP, (4.0, 3.5), 3)
    assert session.game.hand is None


def test_body_that_is_grabbed_in_a_pause_is_put(begin: Callable[[str], Session]) -> None:
    """It is at the mouse at once, and no time has passed."""
    session = begin("demo")
    session.press("p")
    number = session.game.world.numbers[4]
    click(session, pygame.MOUSEBUTTONDOWN, session.game.world.position(number), 3)
    click(session, pygame.MOUSEMOTION, (4.0, 3.5))
    assert session.game.world.position(number) == pytest.approx((4.0, 3.5), abs=0.01)
    assert session.steps == 0


def test_program_that_forbids_grabbing_says_why(begin: Callable[[str], Session]) -> None:
    """In pool nothing is held, and the reason is shown."""
    session = begin("pool")
    click(session, pygame.MOUSEBUTTONDOWN, session.game.world.position(0), 3)
    assert session.game.hand is None
    assert (session.program.forbids["grab"], "") in session.switched()


def test_sliders_and_hands_are_part_of_a_recording(tmp_path: Path) -> None:
    """What was set and pulled is played again, bit for bit."""
    program, file = load("demo"), tmp_path / "hands.json"
    session = Session(program, program.game(2), Recording("demo", 2))
    session.slide("gravity", 9.0)
    session.press("s")
    number = session.game.world.numbers[4]
    for k in range(40):
        if k == 5:
            session.give(Input("grab", place=session.game.world.position(number)))
            session.give(Input("pull", place=(4.0, 4.0)))
        if k == 25:
            session.press("r")
        session.step()
    session.recording.write(file, session.steps)
    again = play(program, headless=True, replay=file)
    assert (again.game.snapshot() == session.game.snapshot()).all()


@pytest.mark.parametrize("name", ["demo", "simulator", "dominoes"])
def test_ledger_accounts_for_all_energy(begin: Callable[[str], Session], name: str) -> None:
    """What there is now is what there was, and was given, without what was lost."""
    session = begin(name)
    first = session.ledger.last.energy
    for k in range(120):
        if k in (5, 40):
            session.press("space")
        if k == 60:
            session.slide("gravity", 3.0)
        session.step()
    row = session.ledger.last
    assert row.energy == pytest.approx(first + row.given - row.lost, abs=ROUNDING)
    matter = session.game.matter()
    states, mass = matter.states, matter.mass
    moving = float(
        sum(m * (vx**2 + vy**2) / 2 for m, (vx, vy) in zip(mass, states[:, 3:5], strict=True))
    )
    assert row.moving == pytest.approx(moving)


def test_scene_file_is_written_opened_stepped_back_and_replayed(
    begin: Callable[[str], Session], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """F5 and F6 of the simulator; R comes back to what was opened, and a recording holds it."""
    monkeypatch.chdir(tmp_path)
    session = begin("simulator")
    for _ in range(5):
        session.step()
    _do_wanted_of(session, "f5")
    written = session.game.snapshot()
    for _ in range(5):
        session.step()
    _do_wanted_of(session, "f6")
    opened = session.game.snapshot()
    assert opened == pytest.approx(written, abs=ROUNDING)
    session.step()
    session.step()
    after = session.game.snapshot()
    session.step_back()
    session.step()
    assert (session.game.snapshot() == after).all()
    session.press("r")
    assert (session.game.snapshot() == opened).all()
    session.recording.write(tmp_path / "run.json", session.steps)
    again = Recording.read(tmp_path / "run.json", "simulator")
    replayed = Session(session.program, session.program.game(2), again)
    for _ in range(13):
        replayed.step()
    replayed.step_back()
    assert (replayed.game.snapshot() == after).all()


def test_scene_file_that_cannot_be_opened_changes_nothing(
    begin: Callable[[str], Session], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A broken one, one whose room is too large, none at all, and a program with other rules."""
    monkeypatch.chdir(tmp_path)
    session = begin("simulator")
    before = session.game.snapshot()
    for text, words in (
        ("", "no scene*.json in this folder"),
        (
            '{"bodies": 3}',
            "scene.json holds no scene: bodies must be a list of at most 1000, got 3",
        ),
        ('{"bodies": [], "room": [9, 6]}', "room must fit into [8, 6], got [9, 6]"),
    ):
        if text:
            (tmp_path / "scene.json").write_text(text, encoding="utf-8")
        _do_wanted_of(session, "f6")
        assert session.message == words
        assert (session.game.snapshot() == before).all()
        assert not session.recording.as_dict(0)["inputs"]
    other = begin("pool")
    _do_wanted_of(other, "f5")
    assert other.message.startswith("scene files are for the simulator")


def _do_wanted_of(session: Session, key: str) -> None:
    """Press a key that asks something of the window, and let the window do it."""
    session.press(key)
    nobody: Any = None  # neither window nor camera is asked for a scene
    _do_wanted(session, nobody, nobody)


def test_ledger_becomes_a_table_with_units(begin: Callable[[str], Session], tmp_path: Path) -> None:
    """A line of names and units, and a line a step and one for the start."""
    session = begin("demo")
    for _ in range(7):
        session.step()
    session.ledger.write(tmp_path / "ledger.csv")
    with (tmp_path / "ledger.csv").open(newline="") as file:
        head, *rows = list(csv.reader(file))
    assert head[:2] == ["time, s", "px, kg m/s"]
    assert len(rows) == 8
    assert np.array(rows, dtype=float)[:, 0] == pytest.approx(np.arange(8) / 60)


def test_keys_of_the_frame_are_no_program_s_own() -> None:
    """A key means the same in all programs, so that none of them has another use for it."""
    labels = {action.label for action in ACTIONS}
    assert len(labels) == len(ACTIONS)
    for name in program_summaries():
        for keys, meaning in load(name).keys:
            assert not labels & set(keys.split()), (name, meaning)


def test_page_of_help_names_every_key(
    begin: Callable[[str], Session],
    program_window: Window,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It is made from the table that binds them."""
    session = begin("pool")
    painter = Painter(session, Picture(program_window, session.program.camera))
    words: list[str] = []
    real = Window.text

    def noted(self: Window, line: str, *args: Any, **kwargs: Any) -> pygame.Rect:
        words.append(line)
        return real(self, line, *args, **kwargs)

    monkeypatch.setattr(Window, "text", noted)
    session.press("h")
    painter.draw()
    assert {action.label for action in ACTIONS} <= set(words)
    assert {action.meaning for action in ACTIONS} <= set(words)
    assert any(line.startswith("no grab: ") for line in words)


def test_frame_ends_after_its_time_and_the_next_hears_the_keys(
    begin: Callable[[str], Session],
) -> None:
    """Steps that take too long are not caught up: at most one is made after the time is over."""
    session = begin("demo")
    assert session.tick(0.1, seconds=0.0) == 1
    assert session.tick(0.1) == 6


@pytest.fixture
def large_world() -> LiveWorld:
    """Return a world of so many balls that plain Python takes long for them, after one step."""
    world = LiveWorld([Body(Circle(0.1), position=(k, 0), mass=1.0) for k in range(150)])
    world.step()
    return world


def test_large_world_waits_until_its_code_is_loaded(
    monkeypatch: pytest.MonkeyPatch, large_world: LiveWorld
) -> None:
    """In a thread of its own, so that keys are heard; one that has its code waits no more."""
    may_end = threading.Event()
    load = ready_made.load
    monkeypatch.setattr(ready_made, "load", lambda program: may_end.wait() and load(program))
    with closing(MachineCode()) as code:
        assert code.is_awaited_by(large_world)
        assert code.is_awaited_by(large_world)
        may_end.set()
        while code.is_awaited_by(large_world):
            assert not large_world.compiled
        assert large_world.compiled
        assert not code.is_awaited_by(large_world)


def test_large_world_does_not_wait_for_long(
    monkeypatch: pytest.MonkeyPatch, large_world: LiveWorld
) -> None:
    """After :data:`LONGEST_WAIT` it goes on in plain Python."""
    may_end = threading.Event()
    monkeypatch.setattr(ready_made, "load", lambda _: may_end.wait())
    monkeypatch.setattr(frame, "LONGEST_WAIT", 0.0)
    with closing(MachineCode()) as code:
        assert not code.is_awaited_by(large_world)
        assert not large_world.compiled
    may_end.set()


def test_game_beside_goes_on_in_machine_code_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both are drawn in each frame, so that the slower one would hold up the other."""
    asked: set[LiveWorld] = set()
    is_awaited_by = MachineCode.is_awaited_by

    def noted(code: MachineCode, world: LiveWorld) -> bool:
        asked.add(world)
        return is_awaited_by(code, world)

    monkeypatch.setattr(MachineCode, "is_awaited_by", noted)
    play(load("dominoes"), frames=2, headless=True, beside=True)
    assert [world.compiled for world in asked] == [True, True]


def test_time_stands_still_while_code_is_awaited(monkeypatch: pytest.MonkeyPatch) -> None:
    """A frame in which a world waits is none: so many steps are made as were asked for."""
    answers = iter([True, True, False, True, False])
    monkeypatch.setattr(MachineCode, "is_awaited_by", lambda *_: next(answers))
    outcome = play(load("dominoes"), frames=2, headless=True)
    assert (outcome.steps, outcome.frames) == (2, 2)
    assert next(answers, None) is None


def test_trail_has_a_place_for_every_step(begin: Callable[[str], Session]) -> None:
    """A frame that makes six steps adds six places, as six frames do."""
    session = begin("breakout")
    session.press("space")
    session.tick(0.1)
    trails = session.effects.trails
    assert trails is not None
    (places,) = trails.places.values()
    assert len(places) == 6


def test_files_get_names_that_are_free(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is written over."""
    monkeypatch.chdir(tmp_path)
    assert free_name("pool", ".png") == Path("pool-1.png")
    Path("pool-1.png").touch()
    assert free_name("pool", ".png") == Path("pool-2.png")

"""What holds for every program: repeatable, sturdy, readable."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from dataclasses import replace
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.cradle.own_world import CRADLE
from lesson_code.chapters.dominoes.own_world import DOMINOES
from lesson_code.chapters.programs import load, program_summaries
from lesson_code.chapters.soft_body.own_world import SOFT_BODY
from lesson_code.view.pygame.frame import play
from lesson_code.view.pygame.painter import HELP, Painter
from lesson_code.view.pygame.panel import (
    KEY_COLUMN,
    KEY_LINE,
    KEY_SIZE,
    MARGIN,
    PROGRAM_SIZE,
    READING_SIZE,
)
from lesson_code.view.pygame.picture import PANEL_WIDTH, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import Window, pygame

from .conftest import go_on_in_code

PROGRAMS = [load(name) for name in program_summaries()]
OWN_WORLDS = [CRADLE, DOMINOES, SOFT_BODY]

EVERY = pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.name)
AND_OWN = pytest.mark.parametrize(
    "program", [*PROGRAMS, *OWN_WORLDS], ids=lambda program: program.name
)

EVENTS, MANY_EVENTS = 600, 4_000


@pytest.mark.one_in(9)
@EVERY
def test_program_same_seed_gives_the_same_world_with_and_without_a_window(
    program: Program,
) -> None:
    """Drawing changes nothing: the world of a window is that of plain steps, bit for bit."""
    shown = play(program, seed=7, frames=60).game
    alone = program.game(7)
    for _ in range(60):
        alone.step()
    assert (shown.snapshot() == alone.snapshot()).all()


@pytest.mark.one_in(9)
@EVERY
def test_program_without_effects_has_the_same_world(program: Program) -> None:
    """Flashes, sparks, trails and sound may be left out."""
    bare = replace(program, effects=ImpactEffects)
    games = [play(p, frames=80, headless=True, tour=True).game for p in (program, bare)]
    assert (games[0].snapshot() == games[1].snapshot()).all()


@pytest.mark.parametrize("name", ["simulator", "billiards", "breakout", "asteroids"])
def test_program_another_seed_gives_another_world(name: str) -> None:
    """What is drawn by lot depends on the seed."""
    program = load(name)
    games = [program.game(seed) for seed in (1, 2)]
    for game in games:
        game.press("space")
        for _ in range(40):
            game.step()
    assert (games[0].snapshot() != games[1].snapshot()).any()


@AND_OWN
def test_program_survives_random_events(program: Program, program_window: Window) -> None:
    """Keys, mouse and window events in any order crash nothing, and every number stays finite."""
    mash(program, program_window, EVENTS, every=4)


@pytest.mark.full
@AND_OWN
def test_program_survives_thousands_of_random_events(
    program: Program, program_window: Window
) -> None:
    """The same, longer."""
    mash(program, program_window, MANY_EVENTS, every=3)


def mash(program: Program, window: Window, count: int, every: int) -> None:
    """Give a program random events, a step and a picture now and then."""
    session = Session(program, program.game(3), Recording(program.name, 3))
    painter = Painter(session, Picture(window, program.camera))
    for k, event in enumerate(random_events(count, count)):
        session.handle(event)
        session.running = True
        if k % every == 0:
            session.step()
            go_on_in_code(session.game)
        if k % (10 * every) == 0:
            painter.draw()
    assert np.isfinite(session.game.snapshot()).all()


@EVERY
def test_program_reset_is_the_beginning(program: Program) -> None:
    """R gives the bodies that there were at first, and no more of them."""
    game = program.game(2)
    first = game.snapshot()
    for key in ("space", "b", "up"):
        game.press(key)
    for _ in range(30):
        game.step()
    if program.name in ("cradle", "dominoes"):
        game.press("down")  # the number of balls, and the spacing, outlive a reset
    game.press("r")
    assert game.snapshot().shape == first.shape


@AND_OWN
def test_panel_texts_fit_side_by_side(program: Program, program_window: Window) -> None:
    """No read-out runs into its name, and no key's meaning out of the panel."""
    game = program.game(0)
    for _ in range(30):
        game.step()
    px, width = program_window.px, program_window.width
    room = px(PANEL_WIDTH) - 2 * px(MARGIN)
    for name, value in program.readings(game):
        assert width(name, READING_SIZE) + width(value, READING_SIZE) + 8 <= room, (name, value)
    for key, meaning in program.keys + HELP:
        assert width(key, KEY_SIZE) + 4 <= px(KEY_COLUMN), key
        assert px(KEY_COLUMN) + width(meaning, KEY_SIZE) <= room + px(MARGIN), meaning


@AND_OWN
@pytest.mark.parametrize("steps", [0, 150])
def test_texts_stand_in_the_window_and_apart(
    program: Program, program_window: Window, text_boxes: list[pygame.Rect], steps: int
) -> None:
    """In field and panel, at the start and in the midst of the tour, with all that keys add.

    The number of an asteroid that is leaving the field is cut as the asteroid is.
    """
    session = Session(program, program.game(0), Recording(program.name, 0))
    session.tour = program.tour
    painter = Painter(session, Picture(program_window, program.camera))
    for _ in range(steps):
        session.step()
    for key in (pygame.K_p, pygame.K_l, pygame.K_m):
        session.handle(pygame.event.Event(pygame.KEYDOWN, key=key))
    painter.draw()
    assert len(text_boxes) > len(program.keys)
    whole = program_window.surface.get_rect()
    assert all(whole.contains(box) for box in text_boxes) or program.name == "asteroids"
    for k, box in enumerate(text_boxes):
        assert box.inflate(4, -4).collidelist(text_boxes[:k]) == -1
    keys = MARGIN + KEY_LINE * len(program.keys + HELP)
    assert painter.panel._y <= whole.height - program_window.px(keys)


@EVERY
def test_picture_is_drawn_in_the_field_and_in_the_panel(
    program: Program, program_window: Window
) -> None:
    """Both hold many colours: something is seen."""
    session = Session(program, program.game(0), Recording(program.name, 0))
    Painter(session, Picture(program_window, program.camera)).draw()
    pixels = pygame.surfarray.array2d(program_window.surface)
    assert pixels.shape == PROGRAM_SIZE
    panel = program_window.px(PANEL_WIDTH)
    assert len(np.unique(pixels[:-panel])) > 4
    assert len(np.unique(pixels[-panel:])) > 4


@EVERY
def test_file_of_a_program_opens_with_its_idea(program: Program) -> None:
    """Each says in its first line what it is."""
    module = inspect.getmodule(program.draw)
    assert module is not None
    assert module.__name__ == f"lesson_code.chapters.{program.name}.game"
    assert module.__doc__


# Random events

KEYS = (
    *(getattr(pygame, f"K_{letter}") for letter in "abcdefghijklmnopqrstuvwxyz0123456789"),
    pygame.K_SPACE,
    pygame.K_LEFT,
    pygame.K_RIGHT,
    pygame.K_UP,
    pygame.K_DOWN,
    pygame.K_ESCAPE,
    pygame.K_RETURN,
    pygame.K_F1,
    pygame.K_LSHIFT,
    0,
)


def random_events(seed: int, count: int) -> Iterator[Any]:
    """Yield so many events; places lie in the window and around it."""
    stream = Random(seed)  # noqa: S311 - a test
    kinds = (_key, _key, _button, _button, _motion, _window)
    for _ in range(count):
        yield stream.choice(kinds)(stream)


def _key(stream: Random) -> Any:
    """Return a key that goes down or up."""
    kind = stream.choice((pygame.KEYDOWN, pygame.KEYUP))
    return pygame.event.Event(kind, key=stream.choice(KEYS), mod=0, unicode="")


def _place(stream: Random) -> tuple[int, int]:
    """Return a place in the window, or up to 200 px beside it."""
    width, height = PROGRAM_SIZE
    return stream.randint(-200, width + 200), stream.randint(-200, height + 200)


def _button(stream: Random) -> Any:
    """Return a mouse button that goes down or up."""
    kind = stream.choice((pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP))
    return pygame.event.Event(kind, pos=_place(stream), button=stream.choice((1, 1, 1, 2, 3, 4)))


def _motion(stream: Random) -> Any:
    """Return a movement of the mouse."""
    return pygame.event.Event(pygame.MOUSEMOTION, pos=_place(stream), rel=(0, 0), buttons=(0, 0, 0))


def _window(stream: Random) -> Any:
    """Return something that happens to a window."""
    kinds = (
        pygame.VIDEORESIZE,
        pygame.VIDEOEXPOSE,
        pygame.WINDOWFOCUSLOST,
        pygame.WINDOWMINIMIZED,
        pygame.WINDOWRESTORED,
        pygame.ACTIVEEVENT,
        pygame.TEXTINPUT,
        pygame.MOUSEWHEEL,
        pygame.QUIT,
    )
    return pygame.event.Event(stream.choice(kinds), size=_place(stream), w=1, h=1)

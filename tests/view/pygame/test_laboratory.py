"""What keys add to the picture of any program, in windows of several sizes."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.programs import load, program_summaries
from lesson_code.view.pygame.game import Game
from lesson_code.view.pygame.laboratory import LARGEST_ARROW, MOST_VALUES
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import Window, open_window, pygame

SIZES = [(1280, 720), (1920, 1080), (900, 900), (640, 300)]
PIXEL = 1.5
"""px: places are rounded to whole ones, lengths too."""


def session_of(name: str, **settings: Any) -> Session:
    """Return a session of a program."""
    program = load(name)
    game: Game = program.game(1, **settings)
    return Session(program, game, Recording(name, 1))


@pytest.mark.parametrize("balls", [1, 12, 13, 60, 140])
def test_every_body_has_its_arrow(
    program_window: Window, monkeypatch: pytest.MonkeyPatch, balls: int
) -> None:
    """A ball more takes no arrow away; all are as long as their speeds, in one scale."""
    session = session_of("simulator", balls=balls)
    session.press("v")
    picture = Picture(program_window, session.program.camera)
    painter = Painter(session, picture)
    drawn: list[tuple[float, float, float]] = []

    def arrow(_: Window, tail: Any, along: Any, *__: Any, **___: Any) -> None:
        drawn.append((tail[0], tail[1], math.hypot(*along)))

    def line(_: Any, __: Any, tail: Any, tip: Any, *___: Any) -> None:
        drawn.append((tail[0], tail[1], math.dist(tail, tip)))

    monkeypatch.setattr(Window, "arrow", arrow)
    monkeypatch.setattr("lesson_code.view.pygame.laboratory.pygame.draw.line", line)
    painter._laboratory.draw()
    states = session.game.matter().states
    places = picture.camera.places_of(states[:, :2])
    lengths = np.hypot(*states[:, 3:5].T)
    assert len(states) == balls
    found = np.array(drawn[:balls])
    assert found[:, :2] == pytest.approx(places)
    assert found[:, 2] / lengths == pytest.approx(np.full(balls, found[0, 2] / lengths[0]))
    assert found[:, 2].max() <= LARGEST_ARROW * program_window.unit + PIXEL


def test_values_are_written_for_few_bodies_and_lie_apart(
    program_window: Window, text_boxes: list[pygame.Rect]
) -> None:
    """Velocities, momenta and impulses of twelve balls: in the field, and none over another."""
    session = session_of("simulator", balls=MOST_VALUES)
    for key in "vkixj":
        session.press(key)
    for _ in range(60):
        session.step()
    painter = Painter(session, Picture(program_window, session.program.camera))
    painter.draw()
    for k, box in enumerate(text_boxes):
        assert program_window.surface.get_rect().contains(box)
        assert box.inflate(-2, -6).collidelist(text_boxes[:k]) == -1


def test_values_keep_off_the_question(
    program_window: Window, text_boxes: list[pygame.Rect]
) -> None:
    """The demo writes its question, and later the answer, over a wall from which bodies bounce."""
    session = session_of("demo")
    session.press("v")
    painter = Painter(session, Picture(program_window, session.program.camera))
    for _ in range(60):
        for _ in range(10):
            session.step()
        text_boxes.clear()
        painter.draw()
        for k, box in enumerate(text_boxes):
            assert box.inflate(-2, -6).collidelist(text_boxes[:k]) == -1


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", ["pool", "demo"])
def test_picture_fills_a_window_of_any_size(name: str, size: tuple[int, int]) -> None:
    """Field beside panel; the same part of the world is seen whole, and the mouse finds it."""
    session = session_of(name)
    with open_window(size, "test", headless=True) as window:
        picture = Picture(window, session.program.camera)
        Painter(session, picture).draw()
        seen = picture.seen
        assert pygame.Rect((0, 0), picture.size).contains(seen)
        assert seen.width / seen.height == pytest.approx(4 / 3, abs=2 / seen.height)
        assert min(picture.size[0] - seen.width, picture.size[1] - seen.height) < PIXEL
        middle = session.place_of(seen.center)
        for corner in (seen.topleft, seen.bottomright):
            away = math.dist(session.place_of(corner), middle) * session.camera.scale
            assert away == pytest.approx(math.dist(corner, seen.center), abs=PIXEL)


@pytest.mark.parametrize("size", SIZES[:2])
def test_disc_is_drawn_in_the_window_s_own_pixels(size: tuple[int, int]) -> None:
    """No pixel is a copy of its neighbours: edges are as thin in a large window."""
    with open_window(size, "test", headless=True) as window:
        picture = Picture(window, load("demo").camera)
        picture.clear()
        picture.disc((4.0, 3.0), 0.5, (255, 255, 255))
        x, y = picture.camera.world_to_screen((4.0, 3.0))
        row = [window.surface.get_at((k, round(y)))[0] for k in range(round(x), picture.seen.right)]
        edge = [level for level in row if 40 < level < 250]
        assert len(edge) <= 3
        assert row.index(min(row)) == pytest.approx(0.5 * picture.camera.scale, abs=2 * PIXEL)


@pytest.mark.parametrize("size", [(1080, 600), (1280, 720), (1920, 1080)])
def test_letter_i_has_its_dot(size: tuple[int, int]) -> None:
    """In every size of text that the programs use, a row without ink parts dot and stroke."""
    with open_window(size, "test", headless=True) as window:
        for points in (15, 18, 20, 22, 28):
            window.surface.fill((0, 0, 0))
            box = window.text("i", (20, 20), colour=(255, 255, 255), size=points)
            ink = pygame.surfarray.array3d(window.surface.subsurface(box)).max(axis=(0, 2))
            inked = np.flatnonzero(ink > 128)
            gaps = ink[inked[0] : inked[-1]] < 100
            assert gaps.any(), points


def test_window_is_drawn_anew_in_a_new_size(program_window: Window) -> None:
    """After the user has dragged its corner, the next picture fills it."""
    session = session_of("demo")
    picture = Picture(program_window, session.program.camera)
    painter = Painter(session, picture)
    painter.draw()
    pygame.display.set_mode((1600, 900), pygame.RESIZABLE)
    painter.draw()
    painter.draw()
    assert picture.size[1] == 900
    assert session.camera.scale == pytest.approx(picture.size[0] / 8)  # 8 m side by side
    assert program_window.surface.get_at((1590, 890))[:3] != (0, 0, 0)


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", program_summaries())
def test_keys_that_show_change_no_world(
    program_window: Window, name: str, begin_shown: Callable[[Session], None]
) -> None:
    """All of them on or none: the same states, bit for bit."""
    plain, shown = session_of(name), session_of(name)
    begin_shown(shown)
    painter = Painter(shown, Picture(program_window, shown.program.camera))
    for session in (plain, shown):
        session.tour = session.program.tour
        for k in range(90):
            session.step()
            if session is shown and k % 20 == 0:
                painter.draw()
    assert (plain.game.snapshot() == shown.game.snapshot()).all()


@pytest.fixture
def begin_shown() -> Callable[[Session], None]:
    """Return a function that presses all keys that show something."""

    def press(session: Session) -> None:
        for key in ("v", "k", "i", "x", "j", "tab", "h"):
            session.press(key)

    return press

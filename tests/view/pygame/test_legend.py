"""The key of colours and arrows: in every program, in the panel, over nothing else."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from lesson_code.chapters.programs import load, program_summaries
from lesson_code.view.pygame.legend import SHARED, Mark
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.panel import PANEL
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import Window, open_window, pygame


@pytest.fixture(params=[(1280, 720), (1920, 1080)])
def window(request: pytest.FixtureRequest) -> Iterator[Window]:
    """Return a window of a usual size."""
    with open_window(request.param, "test", headless=True) as opened:
        yield opened


@pytest.mark.parametrize("name", program_summaries())
def test_t_shows_what_colours_and_arrows_mean(
    name: str, window: Window, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every mark of the program and of all, in its colour, inside the panel; none is cut off."""
    written: dict[str, pygame.Rect] = {}
    write = Window.text

    def text(self: Window, words: str, *place: Any, **look: Any) -> pygame.Rect:
        written[words] = write(self, words, *place, **look)
        return written[words]

    monkeypatch.setattr(Window, "text", text)
    program = load(name)
    session = Session(program, program.game(1), Recording(name, 1))
    session.press("t")
    picture = Picture(window, program.camera)
    Painter(session, picture).draw()
    panel = window.surface.get_rect()
    panel.left, panel.width = picture.size[0], panel.width - picture.size[0]
    assert program.legend
    for mark in program.legend + SHARED:
        line = written[mark.meaning]
        assert panel.contains(line)
        beside = pygame.Rect(panel.left, line.top, line.left - panel.left, line.height)
        assert mark.colour in colours_in(window.surface.subsurface(beside))
    session.press("t")
    written.clear()
    Painter(session, picture).draw()
    assert program.legend[0].meaning not in written


def colours_in(surface: pygame.Surface) -> set[tuple[int, int, int]]:
    """Return the colours of all pixels."""
    width, height = surface.get_size()
    pixels = [surface.get_at((x, y)) for x in range(width) for y in range(height)]
    return {(p.r, p.g, p.b) for p in pixels}


@pytest.mark.parametrize("shape", ["disc", "ring", "arrow", "line", "area"])
def test_mark_is_drawn_inside_its_box(shape: str, window: Window) -> None:
    """In its own colour, and nothing of it outside."""
    window.surface.fill(PANEL)
    box = pygame.Rect(100, 100, window.px(26), window.px(20))
    Mark(shape, (255, 0, 0), "red").draw(window, box)
    assert (255, 0, 0) in colours_in(window.surface.subsurface(box))
    window.surface.fill(PANEL, box.inflate(4, 4))  # an arrow has a rim
    assert colours_in(window.surface.subsurface(box.inflate(60, 60))) == {PANEL}


@pytest.mark.parametrize("name", program_summaries())
def test_every_mark_of_a_program_has_words_of_its_own(name: str) -> None:
    """No two lines of a key say the same."""
    marks = load(name).legend + SHARED
    assert len({mark.meaning for mark in marks}) == len(marks)

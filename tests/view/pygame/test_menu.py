"""The menu: pictures of all programs, chosen by key or mouse."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from lesson_code.chapters.programs import load, program_summaries
from lesson_code.view.pygame import menu as menus
from lesson_code.view.pygame.menu import Entry, Menu, choose
from lesson_code.view.pygame.window import Window, pygame


@pytest.fixture
def menu(program_window: Window) -> Menu:
    """Return a menu that has been drawn with all its pictures."""
    one = Menu([Entry(n, words, partial(load, n)) for n, words in program_summaries().items()])
    for _ in one.tiles:
        one.step()
    one.draw(program_window)
    return one


def press(menu: Menu, name: int) -> None:
    """Press a key."""
    menu.handle(pygame.event.Event(pygame.KEYDOWN, key=name))


def test_menu_shows_a_picture_of_every_program(
    menu: Menu, program_window: Window, text_boxes: list[pygame.Rect]
) -> None:
    """Each tile holds many colours; names and sentences lie in the window and apart."""
    menu.draw(program_window)
    whole = program_window.surface.get_rect()
    for tile, box in zip(menu.tiles, menu.boxes, strict=True):
        assert tile.surface is not None
        assert len(np.unique(pygame.surfarray.array2d(tile.surface))) > 4
        assert whole.contains(box)
        assert sum(box.contains(text) for text in text_boxes) >= 2
    for k, text in enumerate(text_boxes):
        assert whole.contains(text)
        assert text.inflate(-2, -6).collidelist(text_boxes[:k]) == -1


@pytest.mark.parametrize(
    ("keys", "chosen"),
    [
        ((pygame.K_RETURN,), 0),
        ((pygame.K_RIGHT, pygame.K_DOWN, pygame.K_SPACE), 4),
        ((pygame.K_LEFT, pygame.K_UP, pygame.K_RETURN), 0),
        ((pygame.K_7,), 6),
    ],
)
def test_program_is_chosen_by_keys(menu: Menu, keys: tuple[int, ...], chosen: int) -> None:
    """Arrows move the mark within the menu, ENTER and SPACE choose, a number does at once."""
    for key in keys:
        press(menu, key)
    assert menu.chosen == list(program_summaries())[chosen]
    assert not menu.running


def test_program_is_chosen_by_a_click(menu: Menu) -> None:
    """The mouse marks the tile that it is over; the left button opens it."""
    place = menu.boxes[5].center
    menu.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=place, rel=(0, 0), buttons=(0, 0, 0)))
    assert (menu.marked, menu.chosen) == (5, None)
    menu.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=place, button=1))
    assert menu.chosen == list(program_summaries())[5]


def test_escape_closes_the_menu_without_a_choice(menu: Menu) -> None:
    """None of the programs is opened."""
    press(menu, pygame.K_ESCAPE)
    assert (menu.chosen, menu.running) == (None, False)


def test_marked_program_plays_itself(menu: Menu) -> None:
    """Its picture moves; the others stand still."""
    menu.marked = 5
    before = [pygame.surfarray.array2d(tile.surface) for tile in menu.tiles if tile.surface]
    for _ in range(30):
        menu.step()
    after = [pygame.surfarray.array2d(tile.surface) for tile in menu.tiles if tile.surface]
    moved = [(a != b).any() for a, b in zip(after, before, strict=True)]
    assert moved == [k == 5 for k in range(len(menu.tiles))]


def test_programs_are_prepared_only_where_the_menu_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once, when it has a window; where there is no screen, nothing is begun."""
    entries = [Entry("demo", "", partial(load, "demo"))]
    shown: list[str] = []
    with pytest.raises(RuntimeError, match="no screen"):
        choose(entries, when_shown=partial(shown.append, "begun"))
    assert shown == []

    def close() -> None:
        shown.append("begun")
        pygame.event.post(pygame.event.Event(pygame.QUIT))

    monkeypatch.setattr(menus, "UNSEEN", ())
    assert choose(entries, when_shown=close) is None
    assert shown == ["begun"]

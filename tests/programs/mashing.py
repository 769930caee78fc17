"""Random events of mouse, keyboard and window, all from a seed."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.view.panel import PROGRAM_SIZE
from lesson_code.view.pygame_view import pygame

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
    return pygame.event.Event(
        pygame.MOUSEMOTION, pos=_place(stream), rel=(0, 0), buttons=(0, 0, 0)
    )


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

"""Programs are tested without screen and loudspeaker; machine code is kept from run to run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from lesson_code.engine.compiled.library import FOLDER_VARIABLE
from lesson_code.view.panel import PROGRAM_SIZE
from lesson_code.view.pygame_view import Window, open_window, pygame


@pytest.fixture(autouse=True)
def _no_screen(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> None:
    """Run on SDL's dummy drivers."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    kept = tmp_path_factory.getbasetemp().parent / "collision-workbook-programs"
    monkeypatch.setenv(FOLDER_VARIABLE, str(kept))


@pytest.fixture
def program_window() -> Iterator[Window]:
    """Return an open headless window of the size that programs have."""
    with open_window(PROGRAM_SIZE, "test", headless=True) as opened:
        yield opened


@pytest.fixture
def text_boxes(monkeypatch: pytest.MonkeyPatch) -> list[pygame.Rect]:
    """Return where each text stands that is drawn in a window from now on, px."""
    boxes: list[pygame.Rect] = []
    real_text = Window.text

    def noted(self: Window, words: str, *args: Any, **kwargs: Any) -> pygame.Rect:
        boxes.append(real_text(self, words, *args, **kwargs))
        return boxes[-1]

    monkeypatch.setattr(Window, "text", noted)
    return boxes

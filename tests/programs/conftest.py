"""Programs are tested without screen and loudspeaker; machine code is kept from run to run."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from lesson_code.engine.compiled.library import FOLDER_VARIABLE
from lesson_code.view.panel import PROGRAM_SIZE
from lesson_code.view.pygame_view import Window, open_window


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

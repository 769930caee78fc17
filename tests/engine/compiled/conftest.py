"""A folder for compiled programs that is empty, for the tests of keeping them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from lesson_code.engine.compiled import library
from lesson_code.engine.compiled.library import FOLDER_VARIABLE


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return an empty folder for programs, and forget what this process has loaded."""
    chosen = tmp_path / "programs"
    monkeypatch.setenv(FOLDER_VARIABLE, str(chosen))
    library.forget_loaded()
    library.own_folder.cache_clear()
    yield chosen
    library.forget_loaded()
    library.own_folder.cache_clear()

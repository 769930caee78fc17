"""Compiled programs of the tests are kept from run to run: compiling them takes a minute."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from lesson_code.engine.compiled.library import FOLDER_VARIABLE, compiled_function


@pytest.fixture(scope="session")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder for programs that later test runs find again."""
    return tmp_path_factory.getbasetemp().parent / "collision-workbook-programs"


@pytest.fixture(scope="session", autouse=True)
def keep_programs(programs: Path) -> Iterator[None]:
    """Keep them there, and not among the user's."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(FOLDER_VARIABLE, str(programs))
        yield


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return an empty folder for programs, and forget what this process has loaded."""
    chosen = tmp_path / "programs"
    monkeypatch.setenv(FOLDER_VARIABLE, str(chosen))
    compiled_function.cache_clear()
    yield chosen
    compiled_function.cache_clear()

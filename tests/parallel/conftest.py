from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture
def chores(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Return the functions that workers are given, imported so that workers can import them."""
    monkeypatch.syspath_prepend(Path(__file__).parent)
    import chores

    return chores

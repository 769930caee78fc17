"""Functions within a program: no machine code of their own, and all the same in their caller's."""

from __future__ import annotations

import pytest

from lesson_code.engine.compiled.library import compiled_function

pytest.importorskip("numba")

from lesson_code.engine.compiled import inner

pytestmark = pytest.mark.usefixtures("place")

PROGRAM = """from __future__ import annotations


def third(x: float) -> float:
    return x / 3.0


def twice_third(x: float) -> float:
    return third(x) + third(x)


def entry(x: float) -> float:
    return twice_third(x) + 0.1
"""


def library_of(function: object) -> object:
    """Return Numba's library of the code of a compiled function."""
    (compiled,) = function.overloads.values()  # type: ignore[attr-defined]
    return compiled.library


def test_only_the_entry_has_machine_code() -> None:
    """The others are linked into it."""
    entry = compiled_function(PROGRAM, "entry")
    assert entry(0.7) == 0.7 / 3.0 + 0.7 / 3.0 + 0.1
    inside = entry.py_func.__globals__["twice_third"]
    assert isinstance(library_of(inside), inner.InnerLibrary)
    assert not isinstance(library_of(entry), inner.InnerLibrary)


def test_without_a_needed_method_numba_does_it_its_own_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """A Numba to come may have renamed one."""
    monkeypatch.setattr(inner, "NEEDED", (*inner.NEEDED, "_method_of_old"))
    entry = compiled_function(PROGRAM, "entry")
    assert entry(0.7) == 0.7 / 3.0 + 0.7 / 3.0 + 0.1
    assert not isinstance(library_of(entry.py_func.__globals__["third"]), inner.InnerLibrary)

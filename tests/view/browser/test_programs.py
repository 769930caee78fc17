"""Programs for pages: what is committed is what the functions say, small, and the same each time.

What they compute is compared with Python in a browser: ``tests/browser/test_programs.py``.
"""

from __future__ import annotations

import gzip
from dataclasses import replace
from pathlib import Path

import pytest

from lesson_code.engine.compiled.webassembly import built, makers, told_by
from lesson_code.view.browser import programs
from lesson_code.view.browser.programs import formulas

MOST_BYTES = 60_000
"""Of a program, gzipped: what a page may load for one."""

PROGRAMS = programs.names()


needs_makers = pytest.mark.skipif(
    any(told_by(programs.file_of(name).read_bytes())["makers"] != makers() for name in PROGRAMS),
    reason="needs what has built them: pip install -c requirements.lock -e '.[wasm]'",
)


def test_every_program_is_what_its_functions_say_and_none_is_left_over() -> None:
    """A formula that is edited and not built again fails here, without a linker."""
    assert PROGRAMS
    assert programs.drifted(Path(__file__).parents[3]) == []


def test_formula_that_is_edited_and_not_built_again_is_found(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One factor in one formula is another."""
    made = programs.program("formulas")
    mirror = made.entries["reflect"]
    edited = replace(mirror, source=mirror.source.replace("- 2 * dot", "- 3 * dot"))
    assert edited != mirror
    changed = replace(made, entries={**made.entries, "reflect": edited})
    monkeypatch.setattr(formulas, "PROGRAM", changed)
    assert programs.fault("formulas") == "differs from the functions it holds"


@pytest.mark.parametrize("name", PROGRAMS)
def test_program_is_small(name: str) -> None:
    """In bytes that a server sends."""
    assert len(gzip.compress(programs.file_of(name).read_bytes(), 9)) <= MOST_BYTES


@needs_makers
@pytest.mark.parametrize(
    "name",
    [
        name if name == "formulas" else pytest.param(name, marks=pytest.mark.full)
        for name in PROGRAMS
    ],
)
def test_program_built_again_has_the_same_bytes(name: str) -> None:
    """Those that are committed; nothing of the folder, the machine or the day is in them."""
    assert built(programs.program(name)) == programs.file_of(name).read_bytes()

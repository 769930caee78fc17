"""Kept sources: found in another process while all that they were made of is as it was."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from processes import printed, started

from lesson_code.engine.compiled import library, link, linker
from lesson_code.engine.compiled.sources import WordlessError, find, in_words
from lesson_code.engine.event_driven.motion import place_at, velocity_at
from lesson_code.formulas import arithmetic

MADE = """
import sys
sys.path.insert(0, {folder!r})
sys.modules["lesson_code.made_for_this"] = made = __import__("made_for_this")
made.__name__ = made.__spec__.name = "lesson_code.made_for_this"
for function in (made.share, made.share_of_less, made.entry):
    function.__module__ = made.__name__
from lesson_code.engine.compiled import linker, link
found = []
link_anew = linker._Program
linker._Program = lambda: found.append("anew") or link_anew()
{change}
text = link(made.entry)
print(*(found or ["kept"]), "SHARE = " + text.partition("SHARE = ")[2].splitlines()[0])
"""

SOURCE = """SHARE = 0.5


def share(x):
    return SHARE * x


def share_of_less(x):
    return SHARE * (x - 1.0)


def entry(x):
    return share(x) + 1.0
"""


def linked(folder: Path, change: str = "") -> str:
    """Return whether a fresh process has linked the functions anew, and the constant in it."""
    return printed(started(MADE.format(folder=str(folder), change=change)))[-1]


@pytest.fixture
def made(tmp_path: Path, place: Path) -> Path:
    """Return the folder of a module from which a program was linked and kept."""
    (tmp_path / "made_for_this.py").write_text(SOURCE)
    assert linked(tmp_path) == "anew SHARE = 0.5"
    return tmp_path


def test_source_is_linked_once_for_all_processes(made: Path, place: Path) -> None:
    """The second process finds it."""
    assert linked(made) == "kept SHARE = 0.5"
    assert len(list(place.glob("source_*"))) == 1


def test_source_whose_file_has_changed_is_linked_anew(made: Path) -> None:
    """Though it is as long as before."""
    path = made / "made_for_this.py"
    path.write_text(SOURCE.replace("0.5", "0.7"))
    os.utime(path, (2e9, 2e9))
    assert linked(made) == "anew SHARE = 0.7"
    assert linked(made) == "kept SHARE = 0.7"


def test_source_of_which_a_constant_has_changed_is_linked_anew(made: Path) -> None:
    """As an experiment of a reader changes one, in memory alone."""
    assert linked(made, "made.SHARE = 0.25") == "anew SHARE = 0.25"
    assert linked(made) == "anew SHARE = 0.5"


def test_source_of_which_a_function_has_changed_is_linked_anew(made: Path) -> None:
    """Another one stands under its name."""
    assert linked(made, "made.share = made.share_of_less") == "anew SHARE = 0.5"
    assert linked(made) == "anew SHARE = 0.5"
    assert linked(made) == "kept SHARE = 0.5"


DAMAGE: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda text: text[:0],
    "cut off": lambda text: text[:-5],
    "one letter": lambda text: text.replace(b"+ 1.0", b"- 1.0"),
    "another file": lambda text: b"{}\n" + text,
    "no text": lambda text: text[:40] + b"\xff" + text[41:],
}


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_file_that_is_damaged_is_linked_anew(
    made: Path, place: Path, damage: Callable[[bytes], bytes]
) -> None:
    """After a full disk, say."""
    (path,) = place.glob("source_*")
    path.write_bytes(damage(path.read_bytes()))
    assert linked(made) == "anew SHARE = 0.5"


def test_source_that_was_kept_is_the_one_that_is_linked(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Read back by the very names."""
    for function in (place_at, velocity_at):
        linker._linked.cache_clear()
        first = link(function)
        linker._linked.cache_clear()
        kept = find(function, linker._stages_by_default(function, set()))
        assert kept is not None
        assert kept.text == first
        assert kept.is_current()
    linker._linked.cache_clear()


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (None, "None"),
        (0.1 + 0.2, "0.30000000000000004"),
        (("a", True), "('a', True)"),
        (arithmetic.dot, "lesson_code.formulas.arithmetic.dot"),
        (arithmetic, "lesson_code.formulas.arithmetic"),
        (Path, "pathlib.Path"),
        (max, "builtins.max"),
    ],
)
def test_value_is_told_in_words_that_mean_the_same_elsewhere(value: Any, words: str) -> None:
    """All digits of a number; where a function is to be found."""
    assert in_words(value) == words


@pytest.mark.parametrize("value", [lambda: 0, [1], object()], ids=["lambda", "list", "object"])
def test_value_without_such_words_is_refused(value: Any) -> None:
    """A list that the stages share, or a function that only this process has."""
    with pytest.raises(WordlessError):
        in_words(value)


def test_source_that_cannot_be_told_is_linked_and_not_kept(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing else fails."""
    monkeypatch.setattr(library, "write", lambda *_: pytest.fail("kept"))
    monkeypatch.setattr("lesson_code.engine.compiled.sources.in_words", refuse)
    linker._linked.cache_clear()
    assert "def place_at" in link(place_at)
    linker._linked.cache_clear()


def refuse(value: Any) -> str:
    """Find no words."""
    raise WordlessError(f"none for {value!r}")

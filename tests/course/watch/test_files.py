"""Files that were saved: found by looking, when they no longer change."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from lesson_code.course.watch.files import Files


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """Return a file that is there."""
    path = tmp_path / "exercise.py"
    path.write_text("before")
    return path


def test_saved_file_is_told_once_when_it_has_settled(path: Path) -> None:
    """A change is seen at one look and told at the next, and then no more."""
    files = Files([path])
    assert files.saved() == []
    path.write_text("after it")
    assert [files.saved(), files.saved(), files.saved()] == [[], [path], []]


def test_file_that_is_still_being_written_is_waited_for(path: Path) -> None:
    """As long as it looks different each time, nothing is told."""
    files = Files([path])
    for length in range(1, 4):
        path.write_text("x" * 10 * length)
        assert files.saved() == []
    assert files.saved() == [path]


def test_file_that_an_editor_replaces_is_told_once(path: Path) -> None:
    """Gone for a moment, then another file under the same name."""
    files = Files([path])
    path.unlink()
    assert [files.saved(), files.saved()] == [[], []]
    other = path.with_name("other")
    other.write_text("replaced")
    other.replace(path)
    assert [files.saved(), files.saved()] == [[], [path]]


def test_change_that_keeps_the_size_is_seen(path: Path) -> None:
    """By the time of the change alone."""
    files = Files([path])
    os.utime(path, ns=(1, 1))
    assert [files.saved(), files.saved()] == [[], [path]]

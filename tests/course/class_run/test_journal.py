"""The journal: nothing that was written is lost, and nothing half written is believed."""

from __future__ import annotations

import sys
from datetime import UTC, datetime
from pathlib import Path

import pytest

from lesson_code.course.class_run.collect import Paper
from lesson_code.course.class_run.journal import Journal, key_of

HEAD = {"version": 1, "seed": None, "grader": "a"}
DRAWN = {"seed": 42}


def paper(name: str, digest: str = "d") -> Paper:
    """Return a file that was handed in."""
    return Paper(name, Path(name), digest, datetime(2026, 1, 1, tzinfo=UTC))


def test_journal_gives_back_what_was_written(tmp_path: Path) -> None:
    """Opened again, it holds the marks and the seed that was drawn."""
    with Journal(tmp_path / "j", HEAD, DRAWN) as journal:
        journal.write(paper("a"), {"points": 3})
    with Journal(tmp_path / "j", HEAD, {"seed": 7}) as again:
        assert again.done == {key_of(paper("a")): {"points": 3}}
        assert again.head["seed"] == 42


def test_journal_cut_off_in_a_line_goes_on_from_the_last_whole_one(tmp_path: Path) -> None:
    """Wherever a run was killed, the marks before stay, and what comes after is readable."""
    path = tmp_path / "j"
    with Journal(path, HEAD, DRAWN) as journal:
        for name in "ab":
            journal.write(paper(name), {"points": 1})
    whole = path.read_bytes()
    last_line = len(whole.splitlines(keepends=True)[-1])
    for cut in (1, last_line // 2, last_line - 1):
        path.write_bytes(whole[:-cut])
        with Journal(path, HEAD, DRAWN) as again:
            assert list(again.done) == [key_of(paper("a"))]
            again.write(paper("b"), {"points": 1})
        assert path.read_bytes() == whole


def test_journal_does_not_know_a_file_that_has_changed(tmp_path: Path) -> None:
    """The marks belong to what stood in the file."""
    with Journal(tmp_path / "j", HEAD, DRAWN) as journal:
        journal.write(paper("a", "before"), {"points": 3})
        assert key_of(paper("a", "after")) not in journal.done


@pytest.mark.parametrize("other", [{"seed": 7}, {"grader": "b"}, {"version": 2}])
def test_journal_of_another_run_is_refused(tmp_path: Path, other: dict[str, object]) -> None:
    """What differs is named, with a way out; the journal is left as it was."""
    path = tmp_path / "j"
    with Journal(path, HEAD, DRAWN):
        pass
    before = path.read_bytes()
    (name,) = other
    with pytest.raises(ValueError, match=rf"another run \({name} was .* --fresh begins again"):
        Journal(path, HEAD | other, DRAWN)
    assert path.read_bytes() == before


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such locks")
def test_journal_is_written_by_one_run_at_a_time(tmp_path: Path) -> None:
    """A second run is refused as long as the first has it open, and not afterwards."""
    with Journal(tmp_path / "j", HEAD, DRAWN), pytest.raises(ValueError, match="another run is"):
        Journal(tmp_path / "j", HEAD, DRAWN)
    with Journal(tmp_path / "j", HEAD, DRAWN) as free:
        assert free.done == {}

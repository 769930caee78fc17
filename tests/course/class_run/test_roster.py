"""The roster: what it may say, and a clear line for what it may not."""

from __future__ import annotations

from datetime import datetime, timedelta, timezone
from pathlib import Path

import pytest

from lesson_code.course.class_run.roster import Enrolled, RosterError, read_roster, read_time


def roster(tmp_path: Path, text: str | bytes) -> Path:
    """Write a roster."""
    path = tmp_path / "roster.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def test_roster_lists_students_in_order(tmp_path: Path) -> None:
    """Columns are found by name, in any order; others and empty lines are left alone."""
    path = roster(tmp_path, "\ufeffName,ID,group\nAda L,ada,1\n\n,bob,2\n")
    assert read_roster(path) == (Enrolled("ada", "Ada L"), Enrolled("bob"))


def test_roster_of_a_spreadsheet_with_semicolons_is_read(tmp_path: Path) -> None:
    """Where the comma is a decimal sign, spreadsheets write semicolons."""
    assert read_roster(roster(tmp_path, "id;name\nada;Ada, Lady\n"))[0].name == "Ada, Lady"


def test_roster_gives_a_student_more_time(tmp_path: Path) -> None:
    """A time of its own is kept with its zone."""
    (student,) = read_roster(roster(tmp_path, "id,due\nada,2026-11-20T23:59+01:00\n"))
    assert student.due == datetime(2026, 11, 20, 23, 59, tzinfo=timezone(timedelta(hours=1)))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty"),
        (b"id\n\xff\xfe", "is not text in UTF-8"),
        ("name,email\nAda,a@b\n", "needs one column named id, and has 'name', 'email'"),
        ("id,id\na,b\n", "needs one column named id"),
        ("id,name\n,Ada\n", "line 2 has no id"),
        ("id\nada\nADA \n", "line 3 has the id ADA, as line 2 has"),
        ("id\n../etc\n", "line 2: an id names a file, and cannot hold / or"),
        ("id,name\nada,Ada,more\n", "line 2 has another number of cells"),
        ('id,name\nada,"Ada\n', "is no CSV"),
        ("id,due\nada,soon\n", "line 2: a time must be like 2026-11-20T23:59, got 'soon'"),
    ],
)
def test_bad_roster_is_refused_with_a_clear_line(
    tmp_path: Path, text: str | bytes, said: str
) -> None:
    """The message names the file, the line and what is wrong."""
    path = roster(tmp_path, text)
    with pytest.raises(RosterError, match=r"roster\.csv") as refused:
        read_roster(path)
    assert said in str(refused.value)


def test_bad_roster_names_every_bad_line(tmp_path: Path) -> None:
    """All faults are told at once, up to ten of them."""
    path = roster(tmp_path, "id\n" + "a/b\n" * 12)
    with pytest.raises(RosterError, match=r"line 2: .*line 11: .*and 13 more"):
        read_roster(path)


def test_missing_roster_is_named(tmp_path: Path) -> None:
    """A name that leads nowhere is an error of its own."""
    with pytest.raises(RosterError, match="there is no such roster"):
        read_roster(tmp_path / "none.csv")


def test_time_without_zone_is_that_of_this_machine() -> None:
    """Whoever writes a time means the clock on the wall."""
    assert read_time("2026-11-20T23:59").utcoffset() is not None
    with pytest.raises(ValueError, match="a time must be like"):
        read_time("20.11.2026")

"""The roster: what it may say, and a clear line for what it may not."""

from __future__ import annotations

from datetime import datetime, timedelta, timezone
from pathlib import Path

import pytest

from lesson_code.course.class_run.roster import Enrolled, read_roster
from lesson_code.course.class_run.sheets import SheetError, read_time


def roster(tmp_path: Path, text: str | bytes) -> Path:
    """Write a roster."""
    path = tmp_path / "roster.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def test_roster_lists_students_in_order(tmp_path: Path) -> None:
    """Columns are found by name, in any order; others and empty lines are left alone."""
    path = roster(tmp_path, "\ufeffName,ID,group\nAda L,ada,1\n\n,bob,2\n")
    assert read_roster(path).students == (Enrolled("ada", "Ada L"), Enrolled("bob"))


def test_roster_of_a_spreadsheet_with_semicolons_is_read(tmp_path: Path) -> None:
    """Where the comma is a decimal sign, spreadsheets write semicolons."""
    assert read_roster(roster(tmp_path, "id;name\nada;Ada, Lady\n")).students[0].name == "Ada, Lady"


def test_roster_gives_a_student_more_time(tmp_path: Path) -> None:
    """A time of its own is kept with its zone."""
    (student,) = read_roster(roster(tmp_path, "id,due\nada,2026-11-20T23:59+01:00\n")).students
    assert student.due == datetime(2026, 11, 20, 23, 59, tzinfo=timezone(timedelta(hours=1)))


CANVAS = """\
Student,ID,SIS User ID,SIS Login ID,Section,01 One dimension (77),Final Score
    Points Possible,,,,,20,(read only)
,,,,,Manual Posting,
"Byron, Ada",123,s9,ada@x.org,A,,88
"""
MOODLE = """\
Identifier,Full name,Email address,Status,Grade,Maximum Grade,Last modified (grade)
Participant 123,Ada Byron,ada@x.org,Submitted,,100.00,-
"""


@pytest.mark.parametrize(
    ("text", "student"),
    [
        ("Student ID;Last Name;First name;E-Mail\n7;Byron;Ada;a@b\n",
         Enrolled("7", "Ada Byron", "a@b", also=("a@b",))),
        ("Name,Email,Role\nAda,a@b,Student\n", Enrolled("a@b", "Ada", "a@b")),
        ("username,Team\nada,red\n", Enrolled("ada", team="red")),
        (CANVAS, Enrolled("123", "Byron, Ada", "ada@x.org", also=("s9", "ada@x.org"),
                          canvas="123")),
        (MOODLE, Enrolled("Participant 123", "Ada Byron", "ada@x.org", also=("ada@x.org",),
                          moodle="123")),
    ],
    ids=["own words", "Gradescope", "login", "Canvas", "Moodle"],
)  # fmt: skip
def test_roster_is_read_under_the_headings_that_people_and_systems_write(
    tmp_path: Path, text: str, student: Enrolled
) -> None:
    """Rows of Canvas that are no students are left out."""
    assert read_roster(roster(tmp_path, text)).students == (student,)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty"),
        (b"id\nada\n\xeb\n", "line 3 is not text in UTF-8 (byte 0xeb)"),
        ("name,group\nAda,1\n", "needs one column named id, and has 'name', 'group'"),
        ("id,id\na,b\n", "needs one column named id"),
        ("id,name\n,Ada\n", "line 2 has no id"),
        ("id\nada\nADA \n", "line 3 has the id ADA, as line 2 has"),
        ("id\n../etc\n", "line 2: an id names a file, and cannot hold / or"),
        ("id,name\nada,Ada,more\n", "line 2 has 3 cells, and the first line 2"),
        ('id,name\nada,"Ada\n', "is no CSV"),
        ("id,due\nada,soon\n", "line 2: a time must be like 2026-11-20T23:59, got 'soon'"),
    ],
)
def test_bad_roster_is_refused_with_a_clear_line(
    tmp_path: Path, text: str | bytes, said: str
) -> None:
    """The message names the file, the line and what is wrong."""
    path = roster(tmp_path, text)
    with pytest.raises(SheetError, match=r"roster\.csv") as refused:
        read_roster(path)
    assert said in str(refused.value)


def test_bad_roster_names_every_bad_line(tmp_path: Path) -> None:
    """All faults are told at once, up to ten of them."""
    path = roster(tmp_path, "id\n" + "a/b\n" * 12)
    with pytest.raises(SheetError, match=r"line 2: .*line 11: .*and 13 more"):
        read_roster(path)


def test_missing_roster_is_named(tmp_path: Path) -> None:
    """A name that leads nowhere is an error of its own."""
    with pytest.raises(SheetError, match="there is no such file"):
        read_roster(tmp_path / "none.csv")


def test_time_without_zone_is_that_of_this_machine() -> None:
    """Whoever writes a time means the clock on the wall."""
    assert read_time("2026-11-20T23:59").utcoffset() is not None
    with pytest.raises(ValueError, match="a time must be like"):
        read_time("20.11.2026")

"""What course systems import: each file is read as that system's own importer reads it."""

from __future__ import annotations

import csv
import html
import io
import json
import re
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

from lesson_code.course.class_run.changes import Changes, read_changes
from lesson_code.course.class_run.gradebook import Gradebook, gradebook
from lesson_code.course.class_run.imports import canvas, moodle, write_imports
from lesson_code.course.class_run.journal import key_of
from lesson_code.course.class_run.roster import Enrolled, Roster, read_roster
from lesson_code.course.grading.exercises import exercise_by_name

from .test_gradebook import NOON, hand_in, marks, paper
from .test_roster import CANVAS, MOODLE

ONE = exercise_by_name("01")
UGLY = ("=cmd()", "-7", "Zoë\u202e", 'a,b;"c"', "<b>x</b>", "ada\nlovelace", "@x", "文")


def book_with(roster: Roster | None, *students: Enrolled, points: tuple[int, ...]) -> Gradebook:
    """Return the marks of some students in exercise 01; -1 for who handed in nothing."""
    hand_ins, given = [], {}
    for number, (student, earned) in enumerate(zip(students, points, strict=True)):
        file = paper(f"{number}.py", NOON)
        files = [file] if earned >= 0 else []
        hand_ins.append(type(hand_in("x"))(student, tuple(files), entries=tuple("x" * len(files))))
        given[key_of(file)] = marks(min(earned, 4), max(0, min(earned - 4, 3)), max(0, earned - 7))
    return gradebook(hand_ins, given, exercises=[ONE.name], seed=7, roster=roster)


def rows_of(text: str) -> list[list[str]]:
    """Return the rows of a sheet, each as long as the first."""
    rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    assert {len(row) for row in rows} == {len(rows[0])}
    return rows


def canvas_reads(text: str) -> tuple[dict[str, str], dict[tuple[str, str], str]]:
    """Return full marks and grades as Canvas's importer (gradebook_importer.rb) finds them.

    Its rules: the first cell has "Student", the second "ID"; with "SIS User ID" and "SIS Login ID"
    next, the fifth has "Section"; a first cell with "Points Possible" describes columns; what has
    "Final Score" or the like in its heading is no assignment; a student is found by ID, then by the
    SIS ids, then by name.
    """
    head, *rows = rows_of(text)
    assert "Student" in head[0]
    assert "ID" in head[1]
    assert "SIS User ID" in head[2]
    assert "SIS Login ID" in head[3]
    assert "Section" in head[4]
    assert not any("Score" in heading for heading in head[5:])
    full: dict[str, str] = {}
    grades: dict[tuple[str, str], str] = {}
    for row in rows:
        if "Points Possible" in row[0]:
            full = dict(zip(head[5:], row[5:], strict=True))
            continue
        who = next(cell for cell in (row[1], row[2], row[3], row[0]) if cell)
        grades |= {(who, heading): cell for heading, cell in zip(head[5:], row[5:], strict=True)}
    return full, grades


def moodle_reads(text: str) -> dict[str, tuple[str, str]]:
    """Return grades and feedback as Moodle's worksheet importer finds them, by the number.

    Its rules (importgradeslib.php): commas, UTF-8; the columns Identifier, Grade and Last modified
    (grade) must be there under these names, Feedback comments may; of the identifier, what follows
    "Participant " is the number.
    """
    head, *rows = rows_of(text)
    place = {name: head.index(name) for name in ("Identifier", "Grade", "Last modified (grade)")}
    return {
        row[place["Identifier"]][len("Participant ") :]: (
            row[place["Grade"]],
            row[head.index("Feedback comments")],
        )
        for row in rows
    }


def roster_of(folder: Path, text: str) -> Roster:
    """Return the roster that a text is."""
    path = folder / "roster.csv"
    path.write_text(text, encoding="utf-8")
    return read_roster(path)


def test_canvas_finds_the_columns_of_its_own_gradebook(tmp_path: Path) -> None:
    """Its heading with the number is kept, and its full mark: 7 of 10 are 14 of 20."""
    roster = roster_of(tmp_path, CANVAS)
    full, grades = canvas_reads(canvas(book_with(roster, *roster.students, points=(7,))))
    assert full == {"01 One dimension (77)": "20"}
    assert grades == {("123", "01 One dimension (77)"): "14"}


def test_canvas_finds_students_by_the_numbers_of_the_download(tmp_path: Path) -> None:
    """Without a roster; who handed in nothing has an empty cell, which Canvas leaves alone."""
    students = [Enrolled("byronada_5", "byronada", canvas="5"), Enrolled("eve")]
    full, grades = canvas_reads(canvas(book_with(None, *students, points=(7, -1))))
    assert full == {ONE.name: "10"}
    assert grades == {("5", ONE.name): "7", ("eve", ONE.name): ""}


def test_moodle_finds_the_students_of_its_own_worksheet(tmp_path: Path) -> None:
    """All its columns are kept; 7 of 10 are 70 of its 100."""
    roster = roster_of(tmp_path, MOODLE)
    text = moodle(book_with(roster, *roster.students, points=(7,)))
    assert rows_of(text)[0] == [*roster.headings, "Feedback comments"]
    (number, (grade, feedback)) = next(iter(moodle_reads(text).items()))
    assert (number, grade) == ("123", "70")
    assert "1.3 elastic_impulse_1d: 0 of 3 points" in html.unescape(feedback)


def test_moodle_scales_to_its_full_mark_however_the_release_writes_it(tmp_path: Path) -> None:
    """Newer worksheets have "Maximum grade": 7 of 10 are still 70 of 100."""
    roster = roster_of(tmp_path, MOODLE.replace("Maximum Grade", "Maximum grade"))
    text = moodle(book_with(roster, *roster.students, points=(7,)))
    assert [grade for grade, _ in moodle_reads(text).values()] == ["70"]


def test_canvas_is_told_numbers_and_logins_of_a_roster_apart(tmp_path: Path) -> None:
    """Canvas finds nobody by a number in its column of logins, and falls back on names."""
    roster = roster_of(tmp_path, "Student number,Name,Username\ns7,Ada,ada\n")
    text = canvas(book_with(roster, *roster.students, points=(7,)))
    assert rows_of(text)[2][:5] == ["Ada", "", "s7", "ada", ""]


def test_moodle_finds_students_by_the_numbers_of_the_download() -> None:
    """Without a roster, and with no grade for who handed in nothing."""
    students = [Enrolled("Ada_5", "Ada", moodle="5"), Enrolled("Eve_6", "Eve", moodle="6")]
    read = moodle_reads(moodle(book_with(None, *students, points=(10, -1))))
    assert {number: grade for number, (grade, _) in read.items()} == {"5": "10", "6": ""}


def test_ugly_names_are_one_row_each_no_formula_and_no_markup() -> None:
    """Whatever students are called, each file has one row for each, and Moodle shows text."""
    students = [Enrolled(name, name, name) for name in UGLY]
    book = book_with(None, *students, points=(5,) * len(UGLY))
    for text in (canvas(book), moodle(book)):
        head, *rows = rows_of(text)
        assert len([row for row in rows if "Points Possible" not in row[0]]) == len(UGLY)
        for row in rows:
            for heading, cell in zip(head, row, strict=True):
                is_time = heading == "Last modified (grade)"
                assert is_time or not cell.startswith(("=", "+", "-", "@", "\t"))
                assert cell.isprintable()
    for _, feedback in moodle_reads(moodle(book)).values():
        assert set(re.findall("<[^>]*>?", feedback)) <= {"<br>"}


def gradescope_runs(folder: Path, archive: Path, users: list[dict[str, Any]]) -> dict[str, Any]:
    """Return results.json as Gradescope makes it: unpacked into source, run_autograder above it.

    The specification names these places; /autograder is moved into a folder of the test's.
    """
    source = folder / "source"
    with zipfile.ZipFile(archive) as opened:
        assert {"setup.sh", "run_autograder"} <= set(opened.namelist())
        assert opened.getinfo("run_autograder").external_attr >> 16 & 0o111
        opened.extractall(source)
    program = (source / "run_autograder").read_text("utf-8").replace("/autograder", str(folder))
    assert program.startswith("#!")
    (folder / "submission_metadata.json").write_text(json.dumps({"users": users}), "utf-8")
    subprocess.run([sys.executable, "-c", program], cwd=folder, check=True)
    results: dict[str, Any] = json.loads((folder / "results" / "results.json").read_text("utf-8"))
    return results


@pytest.mark.parametrize(
    ("user", "score"),
    [
        ({"email": "ADA@x.org", "id": 1, "name": "A"}, 7),
        ({"email": "eve@x.org"}, 0),
        ({"email": "shared@x.org"}, 0),
        ({"name": "ada"}, 0),
    ],
    ids=["by email", "not in the class", "shared by two", "not by name"],
)
def test_gradescope_writes_the_marks_of_who_hands_in(
    tmp_path: Path, user: dict[str, Any], score: int
) -> None:
    """A mark is found by what Gradescope knows of a user and no student writes."""
    students = [
        Enrolled("ada", email="ada@x.org"),
        Enrolled("k1", email="shared@x.org"),
        Enrolled("k2", email="shared@x.org"),
    ]
    write_imports(book_with(None, *students, points=(7, 5, 5)), tmp_path)
    results = gradescope_runs(tmp_path, tmp_path / "gradescope.zip", [user])
    assert results["score"] == score
    if score:
        assert sum(test["score"] for test in results["tests"]) == score
        assert {test["max_score"] for test in results["tests"]} == {3, 4}
    else:
        assert "no marks for you yet" in results["output"]


def test_changes_reach_every_import(tmp_path: Path) -> None:
    """A mark given by hand is the mark that each system gets."""
    read_changes(tmp_path, [])
    with (tmp_path / "changes.csv").open("a") as file:
        file.write("ada,1.1,2.5,,,,good\n")
    hand_ins = [hand_in("ada", paper("a.py"))]
    changes: Changes = read_changes(tmp_path, hand_ins)
    given = {key_of(paper("a.py")): marks(0, 3, 3)}
    book = gradebook(hand_ins, given, exercises=[ONE.name], seed=7, changes=changes)
    assert canvas_reads(canvas(book))[1] == {("ada", ONE.name): "8.5"}
    ((grade, feedback),) = moodle_reads(moodle(book)).values()
    assert grade == "8.5"
    assert "good" in feedback

"""The instructor's changes: what a row may say, what it does to marks, and that it is kept."""

from __future__ import annotations

import json
from datetime import timedelta
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.class_run import Gradebook, Hands, SheetError, grade_class
from lesson_code.course.class_run.changes import COLUMNS, Changes, read_changes
from lesson_code.course.class_run.collect import HandIn
from lesson_code.course.class_run.exports import as_csv, as_dict, remarks_of
from lesson_code.course.class_run.gradebook import gradebook
from lesson_code.course.class_run.journal import key_of
from lesson_code.course.class_run.pages import class_page, student_page
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.grading.exercises import exercise_by_name

from .conftest import RIGHT, SWAPS, MakeClass, contents_of
from .test_gradebook import NOON, hand_in, marks, paper

ONE = exercise_by_name("01")
CLASS = [
    HandIn(Enrolled("ada", email="a@x.org"), entries=("ada.py",)),
    HandIn(Enrolled("=bob", also=("b9",)), entries=("=bob.py",)),
]


def changes(folder: Path, *rows: str) -> Changes:
    """Return what rows of changes.csv say to the class."""
    text = "\r\n".join([",".join(COLUMNS), *rows])
    (folder / "changes.csv").write_text(text, encoding="utf-8-sig", newline="")
    return read_changes(folder, CLASS)


def book_of(
    changed: Changes, *points: tuple[int, int, int], late: timedelta = timedelta(0)
) -> Gradebook:
    """Return the marks of ada, and of bob if there are any, in exercise 01, due at noon."""
    names = ["ada", "=bob"][: len(points)]
    files = [paper(name, NOON + late) for name in names]
    hand_ins = [hand_in(name, file) for name, file in zip(names, files, strict=True)]
    given = {key_of(file): marks(*its) for file, its in zip(files, points, strict=True)}
    return gradebook(hand_ins, given, exercises=[ONE.name], seed=7, due=NOON, changes=changed)


def test_first_run_writes_an_empty_file_that_says_its_columns(tmp_path: Path) -> None:
    """It is there to be opened in a spreadsheet; nothing in it changes anything."""
    assert read_changes(tmp_path, CLASS) == Changes()
    assert (tmp_path / "changes.csv").read_bytes() == b"\xef\xbb\xbf" + (
        b"student,task,points,weight,due,late,comment\r\n"
    )
    assert read_changes(tmp_path, CLASS).said == {name: {} for name in COLUMNS[2:]}


@pytest.mark.parametrize("student", ["ada", " ADA", "a@x.org"])
@pytest.mark.parametrize("task", ["1.1", "1.1 elastic_1d"])
def test_points_by_hand_replace_the_graders(tmp_path: Path, student: str, task: str) -> None:
    """The mark counts, the student is told, and others keep theirs."""
    changed = changes(tmp_path, f"{student},{task},2.5,,,,Half right")
    ada, bob = book_of(changed, (1, 3, 0), (1, 3, 0)).students
    assert (ada.points, bob.points) == (5.5, 4)
    assert remarks_of(ada) == ["1.1 elastic_1d: 2.5 of 4 points, given by hand"]
    page = student_page(ada, book_of(changed, (1, 3, 0)))
    assert "Half right" in page
    assert "2.5 of 4 points" in page


def test_points_by_hand_need_no_file(tmp_path: Path) -> None:
    """Who showed a task at the board, or an exercise on paper, has marks for it."""
    rows = ("ada,1.2,3,,,,", "b9,01,7,,,,on paper")
    hand_ins = [hand_in("ada"), hand_in("=bob")]
    book = gradebook(hand_ins, {}, exercises=[ONE.name], seed=7, changes=changes(tmp_path, *rows))
    assert [(student.points, student.status) for student in book.students] == [
        (3, "graded"),
        (7, "graded"),
    ]
    assert "the points are given by hand" in student_page(book.students[0], book)
    assert "on paper" in student_page(book.students[1], book)
    assert [summary.handed_in for summary in book.summary] == [0, 0, 0]
    assert class_page(book)


def test_task_taken_out_or_weighed_anew_changes_the_full_mark(tmp_path: Path) -> None:
    """The full mark is that of what is left, and a full answer has all of it."""
    changed = changes(tmp_path, ",1.1,,0,,,unclear text", ",1.2,,1.5,,,")
    book = book_of(changed, (4, 3, 3), (4, 2, 0))
    full = ONE.tasks[1].points * 1.5 + ONE.tasks[2].points
    assert book.full_points == full == book.students[0].points
    assert book.students[1].points == 3
    assert "does not count" in student_page(book.students[1], book)
    assert "taken out" in class_page(book)
    halved = book_of(changes(tmp_path, ",01,,0.5,,,"), (4, 3, 3))
    assert (halved.full_points, halved.students[0].points) == (5, 5)
    gone = book_of(changes(tmp_path, ",01,,0,,,"), (4, 3, 3))
    assert (gone.full_points, gone.exercises, gone.students[0].problems) == (0, (), ())


@pytest.mark.parametrize(
    ("rows", "points"),
    [
        ((), 10),
        ((",,,,,10,",), 8),
        ((",,,,,10%,", "ada,,,,,0,"), 10),
        ((",,,,,10,", "ada,01,,,2026-11-23T12:00+00:00,,"), 10),
        ((",,,,,10,", "ada,,,,2026-11-20T13:00+00:00,,"), 8),
        ((",,,,2026-11-21T12:00+00:00,10,",), 9),
        ((",1,,,,70,",), 0),
        ((",,,,,10,", "ada,01,9,,,,"), 9),
    ],
    ids=[
        *("no rule", "a day begun", "forgiven", "more time", "an hour more", "for all"),
        *("not below 0", "by hand"),
    ],
)
def test_lateness_takes_off_what_the_rule_says(
    tmp_path: Path, rows: tuple[str, ...], points: int
) -> None:
    """26 hours after noon are two days begun; percent of the full mark, never below 0."""
    changed = changes(tmp_path, *rows)
    (ada,) = book_of(changed, (4, 3, 3), late=timedelta(hours=26)).students
    assert ada.points == points


@given(
    percent=st.integers(0, 100),
    hours=st.integers(-48, 240),
    earned=st.tuples(st.integers(0, 4), st.integers(0, 3), st.integers(0, 3)),
)
def test_lateness_never_adds_and_grows_with_time(
    percent: int, hours: int, earned: tuple[int, int, int]
) -> None:
    """Between 0 and what was earned; an hour later it is no more."""
    changed = Changes({"late": {("", ""): Decimal(percent)}})
    (now,) = book_of(changed, earned, late=timedelta(hours=hours)).students
    (later,) = book_of(changed, earned, late=timedelta(hours=hours + 1)).students
    assert 0 <= later.points <= now.points <= sum(earned)
    if hours <= 0:
        assert now.points == sum(earned)


def test_canvas_mark_late_takes_nothing_off_and_says_so(tmp_path: Path) -> None:
    """Its name says that a file is late, not by how much."""
    file = paper("lee_LATE_9_2_b.py")
    late = type(file)(file.name, file.path, file.digest, None, is_late=True, number=2)
    book = gradebook(
        [hand_in("ada", late)],
        {key_of(late): marks(4, 3, 3)},
        exercises=[ONE.name],
        seed=7,
        due=NOON,
        changes=changes(tmp_path, ",,,,,10,"),
    )
    (ada,) = book.students
    assert (ada.points, ada.status) == (10, "late")
    assert ada.late == (
        "lee_LATE_9_2_b.py: late, as its name says; nothing is taken off, since the name does not "
        "say how late",
    )


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("ada,1.1,5,,,,", "points must be a number from 0 to 4, got 5"),
        ("ada,1.1,nan,,,,", "points must be a number from 0 to 4, got nan"),
        ("ada,1.1,1.234,,,,", "points must have at most two decimals, got 1.234"),
        (",1.1,2,,,,", "points need a student, and a task or an exercise"),
        ("ada,,2,,,,", "points need a student, and a task or an exercise"),
        ("ada,1.1,,2,,,", "a weight needs a task or an exercise, and is everybody's"),
        (",1.1,,-1,,,", "weight must be a number from 0 to 100, got -1"),
        ("ada,1.1,,,2026-11-20,,", "due and late are of an exercise or of all, not of a task"),
        ("ada,,,,20.11.2026,,", "a time must be like 2026-11-20T23:59, got '20.11.2026'"),
        (",,,,,101,", "late must be a number from 0 to 100, got 101"),
        ("adam,1.1,2,,,,", "student must be an id of grades.csv, got adam"),
        ("ada,1.9,2,,,,", "task must be a task such as 1.1 or an exercise such as 01"),
        ("ada,1.1,,,,,", "changes nothing"),
    ],
)
def test_row_that_cannot_be_is_refused_with_its_line(tmp_path: Path, row: str, said: str) -> None:
    """The message names file, line, rule and value."""
    with pytest.raises(SheetError, match=r"changes\.csv: line 3: ") as refused:
        changes(tmp_path, "ada,1.2,1,,,,", row)
    assert said in str(refused.value)


def test_two_rows_about_one_thing_are_refused(tmp_path: Path) -> None:
    """Whichever would win, one of them would be forgotten."""
    with pytest.raises(SheetError, match=r"line 3: says points again, as line 2 does"):
        changes(tmp_path, "ada,1.1,1,,,,", "a@x.org,1.1,2,,,,")
    (tmp_path / "changes.csv").write_text("student,task,points,weight,due,late\n")
    with pytest.raises(SheetError, match=r"needs the columns student, .*; lacks comment"):
        read_changes(tmp_path, CLASS)


def test_sheet_with_semicolons_and_decimal_commas_is_read(tmp_path: Path) -> None:
    """As Excel saves it again where a comma is the decimal sign."""
    text = ";".join(COLUMNS) + "\r\nada;1.1;2,5;;;;\r\n"
    (tmp_path / "changes.csv").write_text(text, "utf-16")
    assert read_changes(tmp_path, CLASS).points("ada", ONE.tasks[0]) == Decimal("2.5")
    (tmp_path / "changes.csv").write_text(",".join(COLUMNS) + "\n'=bob,1.1,1,,,,\n", "utf-8")
    assert read_changes(tmp_path, CLASS).points("=bob", ONE.tasks[0]) == 1


def test_changes_are_kept_by_every_later_run(make_class: MakeClass, tmp_path: Path) -> None:
    """Run again, and run afresh: the file stands as it was written, and so do the marks."""
    folder, out = make_class({"ada.py": SWAPS, "bob.py": RIGHT}), tmp_path / "out"

    def run(**options: Any) -> Gradebook:
        return grade_class(folder, out, seed=7, isolation="none", hands=Hands(1), **options)

    assert [student.points for student in run().students] == [1, 10]
    row = b'ada,1.1,4,,,,"seen, and right"\r\n'
    with (out / "changes.csv").open("ab") as file:
        file.write(row)
    assert [student.points for student in run().students] == [4, 10]
    first = contents_of(out)
    assert [student.points for student in run(fresh=True).students] == [4, 10]
    assert contents_of(out) == first
    assert (out / "changes.csv").read_bytes().endswith(row)
    with (out / "changes.csv").open("ab") as file:
        file.write(b"carl,1.1,4,,,,\r\n")
    with pytest.raises(SheetError, match=r"line 3: student must be an id of grades.csv, got carl"):
        run()


def test_everything_that_is_written_holds_changed_marks(tmp_path: Path) -> None:
    """Sheet and JSON say the same points, with as many decimals as they need."""
    book = book_of(changes(tmp_path, "ada,1.1,2.5,,,,", ",1.3,,2,,,"), (4, 3, 3), (4, 3, 0))
    value = json.loads(json.dumps(as_dict(book)))
    assert [student["points"] for student in value["students"]] == [11.5, 7]
    assert value["full_points"] == 13
    assert "2.5,3,6,11.5,13,88.5," in as_csv(book)

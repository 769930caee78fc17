"""The class run: the same bytes however it is done, and nobody lost whatever is handed in."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from lesson_code.cli import app
from lesson_code.course import class_run
from lesson_code.course.class_run import Gradebook, Hands, grade_class, marking
from lesson_code.course.class_run import run as running
from lesson_code.course.class_run.changes import CHANGES
from lesson_code.course.class_run.journal import JOURNAL, Journal
from lesson_code.course.isolation import IsolationError

from .conftest import RIGHT, STUB, SWAPS, MakeClass, contents_of

GOLDEN = Path(__file__).parents[1] / "golden"
WORKBOOK = Path(sysconfig.get_path("scripts")) / "workbook"
SECONDS_TO_GRADE_SOME = 60

STUDENTS = {f"s{n:02d}.py": (RIGHT, SWAPS, f"def elastic_1d(*_): {STUB}")[n % 3] for n in range(12)}
EXPECTED = {f"s{n:02d}": (10, 1, 0)[n % 3] for n in range(12)}


def workbook(*arguments: object) -> Result:
    """Run the command, here."""
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def workbook_anywhere(*arguments: object) -> Result:
    """Run the command with whatever isolation this system has."""
    return workbook(*arguments, "--isolation", "none")


def points_of(book: Gradebook) -> dict[str, int]:
    """Return each student's points."""
    return {student.id: student.points for student in book.students}


def test_one_worker_and_two_write_the_same_bytes(make_class: MakeClass, tmp_path: Path) -> None:
    """Every file but the journal, whose lines stand in the order in which they were done."""
    folder = make_class(STUDENTS)
    for workers in (1, 2):
        book = grade_class(folder, tmp_path / f"{workers}", seed=7, hands=Hands(workers))
        assert points_of(book) == EXPECTED
    assert contents_of(tmp_path / "1") == contents_of(tmp_path / "2")
    assert "grades.csv" in contents_of(tmp_path / "1")


def test_variant_draws_for_each_student_and_the_same_again(
    make_class: MakeClass, tmp_path: Path
) -> None:
    """Two students have two seeds, whoever does the work; each repeats a file's calls."""
    folder = make_class({"ada.py": RIGHT, "bob.py": RIGHT})
    for workers in (1, 2):
        out = tmp_path / f"out{workers}"
        book = grade_class(folder, out, seed=7, hands=Hands(workers), variant=True)
        assert [student.points for student in book.students] == [10, 10]
    seeds = {report["seed"] for student in book.students for report in student.reports.values()}
    assert len(seeds) == 2
    assert 7 not in seeds
    assert contents_of(tmp_path / "out1") == contents_of(tmp_path / "out2")
    with pytest.raises(ValueError, match=r"variant was True and is False now"):
        grade_class(folder, out, seed=7, hands=Hands(1))


def test_interrupted_run_goes_on_and_writes_the_same_bytes(
    make_class: MakeClass, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Stopped after half of the class, it grades only the other half when it is called again."""
    folder = make_class(STUDENTS)
    grade_class(folder, tmp_path / "whole", seed=7, hands=Hands(1))
    written: list[str] = []
    write = Journal.write

    def stopped_at_half(journal: Journal, paper: object, marks: object) -> None:
        if len(written) == 6:
            raise KeyboardInterrupt
        written.append(str(paper))
        write(journal, paper, marks)  # type: ignore[arg-type]

    with monkeypatch.context() as patch:
        patch.setattr(Journal, "write", stopped_at_half)
        with pytest.raises(KeyboardInterrupt):
            grade_class(folder, tmp_path / "parts", seed=7, hands=Hands(1))
    told: list[str] = []
    book = grade_class(folder, tmp_path / "parts", hands=Hands(1), told=told.append)
    assert "6 of 12 files are graded already" in told
    assert points_of(book) == EXPECTED
    assert contents_of(tmp_path / "parts") == contents_of(tmp_path / "whole")


@pytest.mark.full
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")
def test_run_killed_at_any_time_goes_on(make_class: MakeClass, tmp_path: Path) -> None:
    """As a command of its own, killed outright while it grades: the same bytes in the end."""
    folder = make_class({f"s{n:03d}.py": RIGHT for n in range(60)})
    out, journal = tmp_path / "killed", tmp_path / "killed" / "journal.jsonl"
    command = [WORKBOOK, "grade", folder, "--out", out, "--seed", "7", "--isolation", "none"]
    running = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
    )
    try:
        until = time.monotonic() + SECONDS_TO_GRADE_SOME
        while not (journal.exists() and journal.read_bytes().count(b"\n") > 5):
            assert time.monotonic() < until
            time.sleep(0.01)
    finally:
        os.killpg(running.pid, signal.SIGKILL)
        running.wait()
    done = journal.read_bytes().count(b"\n") - 1
    again = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert again.returncode == 0, again.stderr
    assert f"{done} of 60 files are graded already" in again.stderr or done == 60
    grade_class(folder, tmp_path / "whole", seed=7)
    assert contents_of(out) == contents_of(tmp_path / "whole")


def test_what_wanted_more_time_is_graded_again_alone(
    make_class: MakeClass, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After all others, and that counts; an interruption before it forgets nothing."""
    folder = make_class({"ada.py": RIGHT, "bob.py": RIGHT, "eve.py": RIGHT})
    asked: list[str] = []

    def busy(job: marking.Job, terms: marking.Terms) -> dict[str, object]:
        asked.append(job.name)
        marks = marking.mark(job, terms)
        if job.name == "ada.py" and asked.count("ada.py") < 3:
            return {"problem": "too slow", "was_cut_off": True}
        return marks

    def interrupted(job: marking.Job, terms: marking.Terms) -> dict[str, object]:
        if "ada.py" in asked and job.name == "ada.py":
            raise KeyboardInterrupt
        return busy(job, terms)

    monkeypatch.setattr(running, "mark", interrupted)
    with pytest.raises(KeyboardInterrupt):
        grade_class(folder, tmp_path / "out", seed=7, hands=Hands(1))
    assert asked == ["ada.py", "bob.py", "eve.py"]
    monkeypatch.setattr(running, "mark", busy)
    book = grade_class(folder, tmp_path / "out", hands=Hands(1))
    assert asked == ["ada.py", "bob.py", "eve.py", "ada.py", "ada.py"]
    assert set(points_of(book).values()) == {10}
    assert b"was_cut_off" not in b"".join(contents_of(tmp_path / "out").values())


HANGS = "def elastic_1d(*_):\n    while True:\n        pass\n"
SLOW = RIGHT.replace("    return c, c", "    sum(range(5_000_000))\n    return c, c")
"""A right answer that takes its time."""


@pytest.mark.full
def test_busy_machine_changes_no_byte(make_class: MakeClass, tmp_path: Path) -> None:
    """One worker alone, and two beside two busy processes: endless, slow and quick answers.

    Of a student with 200 files each has 3 s, so that all of them together have 600.
    """
    many = {f"many/{n:03d}.py": "x = 1\n" for n in range(199)}
    folder = make_class({**STUDENTS, **many, "many/hangs.py": HANGS, "slow.py": SLOW})
    told: list[str] = []
    grade_class(folder, tmp_path / "idle", seed=7, hands=Hands(1), told=told.append)
    assert "1 files wanted more time than they may use: tried again, each alone" in told
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(2)]
    try:
        book = grade_class(folder, tmp_path / "busy", seed=7, hands=Hands(2))
    finally:
        for process in busy:
            process.kill()
            process.wait()
    assert points_of(book) == EXPECTED | {"many": 0, "slow": 10}
    assert contents_of(tmp_path / "idle") == contents_of(tmp_path / "busy")
    assert b"used up its 3 s" in contents_of(tmp_path / "busy")["grades.json"]


def test_file_that_has_changed_is_graded_again(make_class: MakeClass, tmp_path: Path) -> None:
    """The others are not."""
    folder = make_class(STUDENTS)
    grade_class(folder, tmp_path / "out", seed=7, hands=Hands(1))
    make_class({"s01.py": RIGHT})
    told: list[str] = []
    book = grade_class(folder, tmp_path / "out", hands=Hands(1), told=told.append)
    assert "11 of 12 files are graded already" in told
    assert points_of(book) == EXPECTED | {"s01": 10}


def test_other_seed_asks_for_a_fresh_run(make_class: MakeClass, tmp_path: Path) -> None:
    """Marks of two runs are not mixed; --fresh begins again."""
    folder = make_class({"ada.py": RIGHT})
    assert workbook_anywhere("grade", folder, "--out", tmp_path / "out", "--seed", 7).exit_code == 0
    refused = workbook_anywhere("grade", folder, "--out", tmp_path / "out", "--seed", 8)
    assert refused.exit_code == 2
    assert "seed was 7 and is 8 now" in refused.stderr
    fresh = workbook_anywhere(
        "grade", folder, "--out", tmp_path / "out", "--seed", 8, "--fresh", "--json"
    )
    assert json.loads(fresh.stdout)["seed"] == 8


@pytest.mark.parametrize("name", [JOURNAL, *running.WRITTEN])
@pytest.mark.parametrize("fresh", [False, True])
def test_files_that_no_run_wrote_are_kept(
    make_class: MakeClass, tmp_path: Path, name: str, fresh: bool
) -> None:
    """A folder of the instructor's own is refused by the name of the file that would be lost."""
    own = tmp_path / "own"
    own.mkdir()
    (own / name).write_text("precious")
    folder = make_class({"ada.py": RIGHT})
    with pytest.raises(ValueError, match=rf"{name}: is there already, and no earlier run wrote it"):
        grade_class(folder, own, hands=Hands(1), fresh=fresh)
    assert {path.name: path.read_text() for path in own.iterdir()} == {name: "precious"}


def test_run_writes_what_it_says_over_its_own_alone(make_class: MakeClass, tmp_path: Path) -> None:
    """Files of other names may stand beside the marks; there is nothing else that a run writes."""
    out = tmp_path / "out"
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    for _ in range(2):
        grade_class(make_class({"ada.py": RIGHT}), out, hands=Hands(1))
    names = {JOURNAL, CHANGES, "mine.txt", *running.WRITTEN}
    assert {path.name for path in out.iterdir()} == names


def test_hostile_neighbours_change_nobodys_marks(tmp_path: Path) -> None:
    """Among those who kill, forge and patch, an honest student has full marks."""
    folder = tmp_path / "class"
    folder.mkdir()
    hostile = ("os_exit.py", "kills_its_group.py", "monkeypatches.py", "deletes_its_folder.py")
    for name in (*hostile, "forges_while_it_is_loaded.py", "writes_to_every_descriptor.py"):
        shutil.copy(GOLDEN / "hostile" / name, folder / name)
        shutil.copy(GOLDEN / "right_notebook.ipynb", folder / f"honest_{name}.ipynb")
    book = grade_class(folder, tmp_path / "out", exercises=["01"], seed=7)
    honest = {name: points for name, points in points_of(book).items() if "honest" in name}
    assert set(honest.values()) == {10}
    assert len(honest) == 6
    assert max(student.points for student in book.students if student.id not in honest) < 10


def test_what_cannot_be_graded_has_a_line_each(make_class: MakeClass, tmp_path: Path) -> None:
    """Empty, broken, oversized, of another kind or another exercise: named, and nobody is lost."""
    folder = make_class(
        {
            "big.ipynb": b" " * 50_000_001,
            "broken.ipynb": "{",
            "cells.ipynb": json.dumps({"cells": [{}] * 2001}),
            "empty.py": "",
            "other.py": "def bounce_heights(*_): pass\n",
            "right.py": RIGHT,
            "syntax.py": "def elastic_1d(:\n",
            "unknown.py": "x = 1\n",
            "zip.zip": "PK",
        }
    )
    ran = workbook_anywhere(
        "grade", folder, "--out", tmp_path / "out", "--exercise", "01", "--json"
    )
    assert ran.exit_code == 1
    remarks = {s["id"]: s["remarks"] for s in json.loads(ran.stdout)["students"]}
    assert remarks == {
        "big": ["big.ipynb: larger than 50 MB; clear the outputs of its cells and save it"],
        "broken": ["broken.ipynb: is not a notebook (its text is not JSON)"],
        "cells": ["cells.ipynb: has more than 2000 cells"],
        "empty": ["empty.py: is empty"],
        "other": ["other.py: answers 02_restitution, which is not graded here"],
        "right": [],
        "syntax": [],
        "unknown": [],
        "zip": ["zip.zip: a submission ends in .ipynb or .py; unpack it first"],
    }
    shown = workbook_anywhere("grade", folder, "--out", tmp_path / "out", "--exercise", "01")
    assert "zip: zip.zip: a submission ends in .ipynb or .py; unpack it first\n" in shown.stderr
    assert "9 students: 3 graded, 0 late, 0 missing, 6 not gradable" in shown.stdout


def test_file_that_tells_no_exercise_is_told_what_is_broken(
    make_class: MakeClass, tmp_path: Path
) -> None:
    """Where nothing says which exercise it is, the reason is the line that cannot be read."""
    book = grade_class(make_class({"a.py": "def f(:"}), tmp_path / "out", hands=Hands(1))
    (problem,) = book.students[0].problems
    assert problem.startswith("a.py: your a.py, line 1: invalid syntax")


def test_grader_that_fails_loses_nobody(
    make_class: MakeClass, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The file has a line that says so, and is graded when the run is repeated."""
    folder = make_class({"ada.py": RIGHT, "bob.py": RIGHT})

    def failing(job: marking.Job, terms: marking.Terms) -> object:
        if job.name == "ada.py":
            raise MemoryError("no memory left")
        return marking.mark(job, terms)

    with monkeypatch.context() as patch:
        patch.setattr(running, "mark", failing)
        book = grade_class(folder, tmp_path / "out", seed=7, hands=Hands(1))
    assert points_of(book) == {"ada": 0, "bob": 10}
    assert "the grader failed (MemoryError: no memory left)" in book.students[0].problems[0]
    assert points_of(grade_class(folder, tmp_path / "out", hands=Hands(1)))["ada"] == 10


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--roster", "none.csv"], "there is no such file"),
        (["--exercise", "77"], "exercise must be one of"),
        (["--due", "tomorrow"], "a time must be like"),
        (["--isolation", "much"], "isolation must be"),
        (["--cluster", "nowhere"], "cluster must be"),
    ],
)
def test_class_run_with_a_bad_option_grades_nothing(
    make_class: MakeClass, tmp_path: Path, options: list[str], said: str
) -> None:
    """Exit code 2 and a line on standard error; no marks are written."""
    folder = make_class({"ada.py": RIGHT})
    ran = workbook("grade", folder, "--out", tmp_path / "out", *options)
    assert ran.exit_code == 2
    assert said in ran.stderr
    assert not (tmp_path / "out" / "grades.csv").exists()


def test_class_run_asks_for_full_isolation_unless_told_otherwise(
    make_class: MakeClass, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where there is less to be had, nothing of a student runs."""
    asked: list[object] = []

    def refusing(*_: object, isolation: str | None, **__: object) -> None:
        asked.append(isolation)
        raise IsolationError("too little")

    monkeypatch.setattr(class_run, "grade_class", refusing)
    folder = make_class({"ada.py": RIGHT})
    for options, least in (([], "full"), (["--isolation", "limits"], "limits")):
        ran = workbook("grade", folder, "--out", tmp_path / "out", *options)
        assert (ran.exit_code, asked.pop()) == (2, least)
        assert "too little" in ran.stderr


def test_options_of_a_class_are_refused_for_a_file(make_class: MakeClass) -> None:
    """So that nobody believes that a roster was looked at."""
    ran = workbook("grade", make_class({"ada.py": RIGHT}) / "ada.py", "--workers", 2)
    assert ran.exit_code == 2
    assert "--workers is for a class" in ran.stderr


def test_archive_of_a_class_is_to_be_unpacked(make_class: MakeClass) -> None:
    """Whatever options stand beside it."""
    archive = make_class({"moodle.zip": "PK"}) / "moodle.zip"
    for options in ([], ["--workers", 2]):
        ran = workbook("grade", archive, *options)
        assert ran.exit_code == 2
        assert "unpack it first" in " ".join(ran.stderr.split())

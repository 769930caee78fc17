"""A class with ugly names and stray files: nobody is lost or taken for another, all is named."""

from __future__ import annotations

import csv
import hashlib
import io
import itertools
import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from lesson_code.cli import app

from .conftest import RIGHT, SWAPS, MakeClass

BOUNCES = "def bounce_heights(height, restitution, count):\n    return []\n"
"""An answer to exercise 02."""

NOT_UTF_8 = os.fsdecode(b"\xff\xfe")

BROKEN = {
    "syntax": b"def elastic_1d(:\n",
    "bracket": b"{",
    "empty": b"",
    "null byte": b"\x00",
    "no text": b"\xff\xfe\x00",
    "no answer": b"x = 1",
    "raises": b"raise ValueError('\\udcff\\ud800')",
    "right": RIGHT.encode(),
}

unix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such links and names")


def grade(folder: Path, *options: object) -> Result:
    """Run the command on a class with whatever isolation this system has."""
    arguments = ("grade", folder, "--seed", 7, "--workers", 1, "--isolation", "none", *options)
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def graded(folder: Path, *options: object) -> dict[str, Any]:
    """Return what the command prints as JSON."""
    ran = grade(folder, "--json", *options)
    assert ran.exit_code in (0, 1), ran.stderr or ran.exception
    found: dict[str, Any] = json.loads(ran.stdout)
    return found


def points_of(value: dict[str, Any]) -> dict[str, int]:
    """Return the points of each student."""
    return {student["id"]: student["points"] for student in value["students"]}


def remarks_of(value: dict[str, Any], student: str) -> str:
    """Return all that is said about a student."""
    (found,) = [one for one in value["students"] if one["id"] == student]
    return "\n".join(found["remarks"])


def roster_in(folder: Path, text: str) -> Path:
    """Write a roster beside a class."""
    path = folder.with_name("roster.csv")
    path.write_text(text, encoding="utf-8")
    return path


@unix
@pytest.mark.parametrize("suffix", ["py", "ipynb"])
@pytest.mark.parametrize("options", [[], ["--exercise", "01"]], ids=["all", "one exercise"])
def test_name_that_is_no_utf_8_ends_no_run_whatever_stands_in_the_file(
    make_class: MakeClass, tmp_path: Path, suffix: str, options: list[str]
) -> None:
    """As a file, a folder and a file in it: the neighbour has full marks, every file is UTF-8."""
    folder = make_class({"zed.py": RIGHT})
    for name, content in BROKEN.items():
        (folder / f"{name}{NOT_UTF_8}.{suffix}").write_bytes(content)
        inner = folder / f"folder {name}{NOT_UTF_8}"
        inner.mkdir()
        (inner / f"a{NOT_UTF_8}.{suffix}").write_bytes(content)
    value = graded(folder, *options)
    assert len(value["students"]) == 2 * len(BROKEN) + 1
    assert points_of(value)["zed"] == 10
    marks = folder.with_name("class-marks")
    for path in (path for path in marks.rglob("*.*") if path.suffix != ".zip"):
        text = path.read_text(encoding="utf-8")
        assert path.suffix == ".jsonl" or "\\udc" not in text, path
    assert "is not UTF-8" in remarks_of(value, "empty<U+DCFF><U+DCFE>")
    shown = grade(folder, *options)
    assert "empty<U+DCFF><U+DCFE>" in shown.stderr


@unix
def test_class_folder_whose_name_is_no_utf_8_is_graded(tmp_path: Path) -> None:
    """The last line, which says where the marks are, can be printed too."""
    folder = tmp_path / NOT_UTF_8
    folder.mkdir()
    (folder / "ada.py").write_text(RIGHT)
    ran = grade(folder)
    assert (ran.exit_code, ran.exception) == (0, None)
    assert "<U+DCFF><U+DCFE>-marks" in ran.stdout


@unix
@pytest.mark.parametrize("encoding", ["utf-8", "ascii"])
def test_one_file_whose_name_is_no_utf_8_is_reported(tmp_path: Path, encoding: str) -> None:
    """On a terminal of any encoding, which takes neither the name nor what it cannot write."""
    (tmp_path / f"\u00eb{NOT_UTF_8}.py").write_text("def elastic_1d(:\n")
    command = "from lesson_code.cli import main; main()"
    options = (
        "grade",
        tmp_path / f"\u00eb{NOT_UTF_8}.py",
        "--exercise",
        "01",
        "--isolation",
        "none",
    )
    ran = subprocess.run(
        [sys.executable, "-c", command, *options],
        env=os.environ | {"PYTHONIOENCODING": encoding},
        capture_output=True,
        check=False,
    )
    assert ran.returncode == 1, ran.stderr
    assert b"invalid syntax" in ran.stdout


@unix
def test_link_that_leads_to_itself_ends_no_run(make_class: MakeClass) -> None:
    """It is an entry with a problem, as any other link."""
    folder = make_class({"ada.py": RIGHT})
    (folder / "loop.py").symlink_to("loop.py")
    value = graded(folder)
    assert points_of(value) == {"ada": 10, "loop": 0}
    assert "a link" in remarks_of(value, "loop")


@pytest.mark.parametrize("end", ["", "_"])
def test_moodle_folder_is_credited_by_the_whole_name(make_class: MakeClass, end: str) -> None:
    """Not to `ada`, as whose id it begins; where no line fits, it has a row of its own."""
    folder = make_class({f"Ada Byron_123_assignsubmission_file{end}/01.py": RIGHT})
    fitting = roster_in(folder, "id,name\nada,Ada Lovelace\nb7,Ada Byron\n")
    assert points_of(graded(folder, "--roster", fitting)) == {"ada": 0, "b7": 10}
    other = roster_in(folder, "id,name\nada,Ada Lovelace\n")
    value = graded(folder, "--roster", other, "--fresh")
    name = f"Ada Byron_123_assignsubmission_file{end}"
    assert points_of(value) == {name: 10, "ada": 0}
    assert "unmatched: fits no line of the roster" in remarks_of(value, name)


def test_two_students_with_a_colliding_digest_have_a_page_each(make_class: MakeClass) -> None:
    """The first 8 digits of their digests are the same, and so is the rest of the page's name."""
    seen: dict[str, str] = {}
    for number in itertools.count():
        name = f"{'A' * 50}{number}"
        digest = hashlib.sha256(name.encode()).hexdigest()[:8]
        if digest in seen:
            break
        seen[digest] = name
    folder = make_class({f"{name}.py": RIGHT, f"{seen[digest]}.py": SWAPS})
    value = graded(folder)
    pages = {student["feedback"] for student in value["students"]}
    assert len(pages) == 2
    out = folder.with_name("class-marks")
    totals = {page: (out / page).read_text("utf-8").partition(" of 10 points")[0] for page in pages}
    assert {total[-2:] for total in totals.values()} == {">1", "10"}
    with zipfile.ZipFile(out / "gradescope.zip") as archive:
        marks = json.loads(archive.read("marks.json"))
    assert {marks["results"][stem]["score"] for stem in marks["who"].values()} == {1, 10}


@unix
def test_two_students_whose_names_are_shown_alike_have_a_row_each(make_class: MakeClass) -> None:
    """A name that spells out what another one's is shown as; and long names with one beginning."""
    long = "x" * 90
    folder = make_class({f"{long}{end}.py": RIGHT for end in "ab"} | {"<U+202E>.py": RIGHT})
    (folder / "\u202e.py").write_text(RIGHT)
    graded(folder)
    text = (folder.with_name("class-marks") / "grades.csv").read_text("utf-8-sig")
    rows = [row["id"] for row in csv.DictReader(io.StringIO(text, newline=""))]
    assert len(set(rows)) == len(rows) == 4


def test_entry_that_begins_with_a_dot_is_named_as_left_out(make_class: MakeClass) -> None:
    """In JSON and on the terminal; and one that the roster lists is graded."""
    folder = make_class({".eve/01.py": RIGHT, "ada.py": RIGHT, "solutions/01.py": RIGHT})
    value = graded(folder)
    assert points_of(value) == {"ada": 10}
    assert value["left_out"] == [
        "left out, the name begins with a dot: .eve",
        "left out, a folder of tools or of the workbook: solutions",
    ]
    assert "begins with a dot: .eve\n" in grade(folder).stderr
    listed = roster_in(folder, "id\n.eve\nada\nsolutions\n")
    everybody = graded(folder, "--roster", listed)
    assert points_of(everybody) == {".eve": 10, "ada": 10, "solutions": 10}


def test_what_is_left_out_of_a_folder_is_named(make_class: MakeClass) -> None:
    """Folders of tools by their own names, files of other kinds each."""
    folder = make_class(
        {"ada/01.py": RIGHT, "ada/.git/a": "", "ada/notes.txt": "", "ada/deep/venv/b.py": ""}
    )
    value = graded(folder)
    assert remarks_of(value, "ada").splitlines() == [
        "left out, the name begins with a dot: ada/.git",
        "left out, no .ipynb or .py file: ada/notes.txt",
        "left out, a folder of tools or of the workbook: ada/deep/venv",
    ]


@unix
def test_link_to_a_folder_is_named_as_left_out(make_class: MakeClass) -> None:
    """It is not followed, since it may lead to another student's answers."""
    folder = make_class({"ada/01.py": RIGHT, "bob.py": SWAPS})
    (folder / "ada" / "more").symlink_to("..")
    value = graded(folder)
    assert points_of(value) == {"ada": 10, "bob": 1}
    assert remarks_of(value, "ada") == "left out, a link to a folder: ada/more"


@unix
def test_names_that_look_the_same_are_two_students_and_named(make_class: MakeClass) -> None:
    """An umlaut written in two ways; the instructor knows whether they are one."""
    names = ["Zo\u00eb", "Zoe\u0308"]
    folder = make_class({f"{name}.py": RIGHT for name in names})
    if len(list(folder.iterdir())) == 1:
        pytest.skip("this file system takes the two names for one")
    value = graded(folder)
    assert points_of(value) == dict.fromkeys(names, 10)
    assert all("another's name differs only" in remarks_of(value, name) for name in names)


def test_stray_file_raises_nobodys_full_mark(make_class: MakeClass) -> None:
    """An exercise that one student handed in does not count, and is named."""
    folder = make_class({"ada.py": RIGHT, "bob.py": SWAPS, "eve/01.py": RIGHT, "eve/x.py": BOUNCES})
    value = graded(folder)
    assert value["full_points"] == 10
    assert "eve/x.py: answers 02_restitution, which does not count" in remarks_of(value, "eve")
    assert "eve/x.py: answers 02_restitution" in grade(folder).stderr


def test_forty_guesses_do_not_earn_the_best_of_them(make_class: MakeClass) -> None:
    """The newest counts and the others are named; changed in one second, none counts."""
    folder = make_class({f"ada/{n:02d}.py": f"# {n}\n{SWAPS}" for n in range(40)})
    (folder / "ada" / "17.py").write_text(RIGHT)
    for n in range(40):
        os.utime(folder / "ada" / f"{n:02d}.py", (1_700_000_000 + 60 * n,) * 2)
    value = graded(folder)
    assert points_of(value) == {"ada": 1}
    said = remarks_of(value, "ada")
    assert "ada/39.py counts" in said
    assert all(f"ada/{n:02d}.py" in said for n in range(39))
    for n in range(40):
        os.utime(folder / "ada" / f"{n:02d}.py", (1_700_000_000,) * 2)
    tied = graded(folder)
    assert points_of(tied) == {"ada": 0}
    assert all(f"ada/{n:02d}.py" in remarks_of(tied, "ada") for n in range(40))


def test_file_of_helpers_does_not_take_an_answers_place(make_class: MakeClass) -> None:
    """Newer, and graded as the only exercise for want of a better guess: the answer counts."""
    folder = make_class({"ada/answer.py": RIGHT, "ada/helpers.py": "x = 1\n"})
    os.utime(folder / "ada" / "answer.py", (1_700_000_000,) * 2)
    value = graded(folder, "--exercise", "01")
    assert points_of(value) == {"ada": 10}
    assert "ada/helpers.py: left out, it answers no exercise" in remarks_of(value, "ada")


def test_what_is_put_together_is_named(make_class: MakeClass) -> None:
    """Two files under one student, in JSON, on the terminal and on the class's page."""
    folder = make_class({"ada_01_one_dimension.py": RIGHT, "ADA.py": SWAPS, "bob.py": RIGHT})
    roster = roster_in(folder, "id\nada\nbob\n")
    value = graded(folder, "--roster", roster)
    handed_in = {student["id"]: student["handed_in_as"] for student in value["students"]}
    assert handed_in == {"ada": ["ADA.py", "ada_01_one_dimension.py"], "bob": ["bob.py"]}
    shown = grade(folder, "--roster", roster).stderr
    assert "ADA.py, ada_01_one_dimension.py: credited to ada\n" in shown
    assert "credited to bob" not in shown
    page = (folder.with_name("class-marks") / "class.html").read_text("utf-8")
    assert "ADA.py, ada_01_one_dimension.py" in page


def test_every_remark_is_on_the_terminal(make_class: MakeClass) -> None:
    """However many students something is said about."""
    folder = make_class({f"s{n:02d}.py": "" for n in range(30)})
    shown = grade(folder).stderr
    assert all(f"s{n:02d}: s{n:02d}.py: is empty\n" in shown for n in range(30))

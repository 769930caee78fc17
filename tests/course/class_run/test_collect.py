"""What was handed in: found, named, and nobody overlooked."""

from __future__ import annotations

import csv
import io
import json
import os
import sys
import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code.course.class_run import collect as collecting
from lesson_code.course.class_run.collect import collect
from lesson_code.course.class_run.exports import as_csv, as_dict, credits_of
from lesson_code.course.class_run.gradebook import gradebook
from lesson_code.course.class_run.journal import JOURNAL, Journal
from lesson_code.course.class_run.names import visible
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.isolation.inside import disk

from .conftest import MakeClass

unix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such links and names")


def papers(folder: Path, *ids: str) -> dict[str, list[str]]:
    """Return the names of each student's files."""
    roster = [Enrolled(name) for name in ids] or None
    return {
        h.student.id: [paper.name for paper in h.papers] for h in collect(folder, roster).hand_ins
    }


def test_folder_or_file_is_a_student(make_class: MakeClass) -> None:
    """Either stands for a student; in a folder, tools and the workbook itself are left alone."""
    folder = make_class(
        {
            "ada/deep/01.ipynb": "",
            "ada/notes.txt": "",
            "ada/.ipynb_checkpoints/01.ipynb": "",
            "ada/lesson_code/grading/task.py": "",
            "ada/exercises/backups/01.ipynb": "",
            "bob.py": "",
            ".DS_Store": "",
        }
    )
    assert papers(folder) == {"ada": ["ada/deep/01.ipynb"], "bob": ["bob.py"]}


@pytest.mark.parametrize("ids", [[], ["ada"]])
def test_marks_and_files_of_the_system_are_no_students(
    make_class: MakeClass, ids: list[str]
) -> None:
    """An earlier run's folder is known by its journal; another kind of file is a student's."""
    folder = make_class(
        {"ada/01.py": "", "ada/Thumbs.db": "", "notes.txt": "", "Thumbs.db": "", "Desktop.ini": ""}
    )
    (folder / "marks").mkdir()
    with Journal(folder / "marks" / JOURNAL, {"version": 1}, {}):
        pass
    hand_ins, left_out = collect(folder, [Enrolled(name) for name in ids] or None)
    assert [h.student.id for h in hand_ins] == ["ada", "notes"]
    assert left_out == (
        "left out, a file of the system: Desktop.ini, Thumbs.db",
        "left out, the marks of an earlier run: marks",
    )
    assert hand_ins[0].notes == ("left out, a file of the system: ada/Thumbs.db",)


@unix
def test_journal_that_is_none_makes_no_folder_ours(make_class: MakeClass) -> None:
    """Whatever a student calls so, a pipe even, is handed in."""
    folder = make_class({"ada/01.py": "", "ada/journal.jsonl": "{}", "bob/01.py": ""})
    os.mkfifo(folder / "bob" / JOURNAL)
    assert list(papers(folder)) == ["ada", "bob"]


def test_files_named_after_exercises_belong_to_one_student(make_class: MakeClass) -> None:
    """ada_01_one_dimension and ada-02_restitution are both ada's."""
    folder = make_class({"ada_01_one_dimension.ipynb": "", "ada-02_restitution.py": ""})
    assert list(papers(folder)) == ["ada"]


def test_roster_id_may_be_the_beginning_of_a_name(make_class: MakeClass) -> None:
    """Up to a separator, and followed by no other name; ann is neither anna nor ann_lee."""
    folder = make_class({"ann_1.py": "", "Anna.py": "", "ann_lee-2.py": "", "annabel.py": ""})
    assert papers(folder, "ann", "anna", "ann_lee") == {
        "ann": ["ann_1.py"],
        "ann_lee": ["ann_lee-2.py"],
        "anna": ["Anna.py"],
        "annabel": ["annabel.py"],
    }


def test_student_without_a_file_is_missing_and_a_stranger_is_kept(make_class: MakeClass) -> None:
    """Whoever is on the roster has an entry; whoever is not, too, and is marked so."""
    folder = make_class({"eve.py": "", "ada.py": ""})
    hand_ins = {
        h.student.id: h for h in collect(folder, [Enrolled("ada"), Enrolled("bob")]).hand_ins
    }
    assert [name for name, h in hand_ins.items() if h.is_missing] == ["bob"]
    assert [name for name, h in hand_ins.items() if h.unmatched] == ["eve"]


def test_what_cannot_be_graded_is_named(make_class: MakeClass) -> None:
    """An empty folder has a problem; a file of another kind is kept for its reader to refuse."""
    folder = make_class({"bob.zip": "", "carl/readme.txt": ""})
    (bob, carl) = collect(folder).hand_ins
    assert [paper.name for paper in bob.papers] == ["bob.zip"]
    assert carl.problems == ("carl: holds no .ipynb or .py file",)


def test_archive_in_a_folder_is_to_be_unpacked(make_class: MakeClass) -> None:
    """Where nothing else was handed in, what may hold it is named."""
    folder = make_class({"ada/all.ZIP": "", "ada/a.txt": "", "bob/01.py": "", "bob/b.zip": ""})
    ada, bob = collect(folder).hand_ins
    assert ada.problems == ("ada: holds no .ipynb or .py file; unpack ada/all.ZIP first",)
    assert bob.problems == ()


@unix
def test_links_and_odd_names_are_neither_followed_nor_lost(make_class: MakeClass) -> None:
    """A link out of the folder is an entry, not what it leads to; any bytes may be a name."""
    folder = make_class({"=cmd().py": "", "a\u202eb.py": ""})
    (folder / "outside").symlink_to("/etc")
    (folder / "link.py").symlink_to("/etc/passwd")
    (folder / os.fsdecode(b"\xff.py")).write_text("")
    found = papers(folder)
    assert found["outside"] == ["outside"]
    assert len(found) == 5
    (link,) = [p for h in collect(folder).hand_ins for p in h.papers if p.name == "link.py"]
    assert link.digest == "no file"


@unix
def test_folders_nested_by_the_thousand_end_no_run(make_class: MakeClass) -> None:
    """What lies at their bottom is found; beyond what the system takes for a path, it is named."""
    folder = make_class({"ada/a.py": "", "bob/b.py": ""})
    here = Path.cwd()
    for student, name, depth in (("ada", "d", 1200), ("bob", "x" * 240, 17)):
        os.chdir(folder / student)
        for _ in range(depth):
            Path(name).mkdir()
            os.chdir(name)
        Path("deep.py").touch()
    os.chdir(here)
    try:
        ada, bob = collect(folder).hand_ins
    finally:
        disk.remove(str(folder))  # pytest could not
    assert [paper.path.name for paper in ada.papers] == ["a.py", "deep.py"]
    assert [paper.path.name for paper in bob.papers] == ["b.py"]
    assert [problem.partition(": ")[2] for problem in bob.problems] == [
        "cannot be read (File name too long)"
    ]


@unix
@pytest.mark.skipif(os.name == "posix" and os.geteuid() == 0, reason="root looks everywhere")
def test_what_this_user_may_not_look_into_ends_no_run(make_class: MakeClass) -> None:
    """A closed folder, and a link into one, are named; the others are graded."""
    folder = make_class({"ada/a.py": "", "bob/closed/b.py": "", "carl/c.py": ""})
    (folder / "carl" / "link").symlink_to(folder / "bob" / "closed" / "deeper")
    (folder / "eve").symlink_to(folder / "bob" / "closed" / "deeper")
    (folder / "bob" / "closed").chmod(0)
    ada, bob, carl, eve = collect(folder).hand_ins
    (folder / "bob" / "closed").chmod(0o700)
    assert [len(student.papers) for student in (ada, bob, carl, eve)] == [1, 0, 1, 1]
    assert bob.problems == ("bob/closed: cannot be read (Permission denied)",)


def test_a_student_with_too_many_files_is_told(
    make_class: MakeClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first ones are graded, and the problem says so."""
    monkeypatch.setattr(collecting, "MOST_FILES", 2)
    (ada,), _ = collect(make_class({f"ada/{n}.py": "" for n in range(3)}))
    assert [paper.name for paper in ada.papers] == ["ada/0.py", "ada/1.py"]
    assert ada.problems == (
        "ada: holds more than 2 files; only the first 2 are graded, and not ada/2.py",
    )


def test_folder_that_is_none_or_empty_is_refused(tmp_path: Path) -> None:
    """The message names it."""
    with pytest.raises(ValueError, match="none: there is no such folder"):
        collect(tmp_path / "none")
    with pytest.raises(ValueError, match="nothing has been handed in"):
        collect(tmp_path)


ROSTER = [Enrolled("ada", "Ada Byron"), Enrolled("Zo\u00eb"), Enrolled(".eve"), Enrolled("=1")]
PIECES = st.sampled_from(
    [
        *(
            "ada",
            "ADA",
            "Ada Byron",
            "bob",
            "Zo\u00eb",
            "Zoe\u0308",
            "=1",
            ".",
            ".eve",
            "venv",
            "pool",
        ),
        *("_", "-", " ", "_123", "_01_one_dimension", "_9_assignsubmission_file", "_", "x" * 90),
        *(
            "\n",
            "\t",
            "\x1b",
            "\u202e",
            "\u200f",
            "\u2215",
            "\\",
            "\udcff",
            "<U+202E>",
            "\U0001f600",
        ),
    ]
)
UGLY = st.lists(PIECES, min_size=1, max_size=5).map("".join)
MOST_BYTES = 240
"""A file system takes 255 of them in a name, and a suffix is still to come."""


def is_a_name(name: str) -> bool:
    """Return whether a file can be called so."""
    return name not in (".", "..") and len(os.fsencode(name)) <= MOST_BYTES


@unix
@given(
    names=st.dictionaries(UGLY.filter(is_a_name), st.booleans(), min_size=1, max_size=12),
    roster=st.sampled_from([None, ROSTER]),
)
@settings(max_examples=share(60), deadline=None)
def test_entry_of_any_name_is_credited_once_or_named_as_left_out(
    names: dict[str, bool], roster: list[Enrolled] | None
) -> None:
    """Files and folders, some written alike: none is lost, doubled or shown as another is."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, is_folder in names.items():
            path = folder / name / "a.py" if is_folder else folder / f"{name}.py"
            path.parent.mkdir(exist_ok=True)
            path.write_text(name.encode("unicode_escape").decode())
        (folder / "somebody.py").touch()
        entries = {entry.name for entry in folder.iterdir()}
        hand_ins, left_out = collect(folder, roster)
    credited = [name for hand_in in hand_ins for name in hand_in.entries]
    assert len(credited) == len(set(credited))
    assert set(credited) <= entries
    assert all(visible(name) in "\n".join(left_out) for name in entries - set(credited))
    papers = [paper.name for hand_in in hand_ins for paper in hand_in.papers]
    assert sorted({name.partition("/")[0] for name in papers}) == sorted(credited)
    book = gradebook(hand_ins, {}, exercises=(), seed=7, left_out=left_out)
    value = as_dict(book)
    json.dumps(value, ensure_ascii=False).encode("utf-8")
    rows = [row["id"] for row in csv.DictReader(io.StringIO(as_csv(book), newline=""))]
    for each in (rows, [s["id"] for s in value["students"]], [s.stem for s in book.students]):
        assert len(set(each)) == len(hand_ins)
    said = " ".join((*credits_of(book), *(r for s in value["students"] for r in s["remarks"])))
    assert all(visible(name) in said for h in hand_ins if h.is_renamed for name in h.entries)

"""What was handed in: found, named, and nobody overlooked."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from lesson_code.course.class_run import collect as collecting
from lesson_code.course.class_run.collect import collect
from lesson_code.course.class_run.roster import Enrolled

from .conftest import MakeClass


def papers(folder: Path, *ids: str) -> dict[str, list[str]]:
    """Return the names of each student's files."""
    roster = [Enrolled(name) for name in ids] or None
    return {h.student.id: [paper.name for paper in h.papers] for h in collect(folder, roster)}


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


def test_files_named_after_exercises_belong_to_one_student(make_class: MakeClass) -> None:
    """ada_01_one_dimension and ada-02_restitution are both ada's."""
    folder = make_class({"ada_01_one_dimension.ipynb": "", "ada-02_restitution.py": ""})
    assert list(papers(folder)) == ["ada"]


def test_roster_id_may_be_the_beginning_of_a_name(make_class: MakeClass) -> None:
    """The longest id that fits counts, up to a separator; ann is not anna."""
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
    hand_ins = {h.student.id: h for h in collect(folder, [Enrolled("ada"), Enrolled("bob")])}
    assert [name for name, h in hand_ins.items() if h.is_missing] == ["bob"]
    assert [name for name, h in hand_ins.items() if not h.on_roster] == ["eve"]


def test_what_cannot_be_graded_is_named(make_class: MakeClass) -> None:
    """An empty folder has a problem; a file of another kind is kept for its reader to refuse."""
    folder = make_class({"bob.zip": "", "carl/readme.txt": ""})
    (bob, carl) = collect(folder)
    assert [paper.name for paper in bob.papers] == ["bob.zip"]
    assert carl.problems == ("carl: holds no .ipynb or .py file",)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such links and names")
def test_links_and_odd_names_are_neither_followed_nor_lost(make_class: MakeClass) -> None:
    """A link out of the folder is an entry, not what it leads to; any bytes may be a name."""
    folder = make_class({"=cmd().py": "", "a\u202eb.py": ""})
    (folder / "outside").symlink_to("/etc")
    (folder / "link.py").symlink_to("/etc/passwd")
    (folder / os.fsdecode(b"\xff.py")).write_text("")
    found = papers(folder)
    assert found["outside"] == ["outside"]
    assert len(found) == 5
    (link,) = [p for h in collect(folder) for p in h.papers if p.name == "link.py"]
    assert link.digest == "no file"


def test_a_student_with_too_many_files_is_told(
    make_class: MakeClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first ones are graded, and the problem says so."""
    monkeypatch.setattr(collecting, "MOST_FILES", 2)
    (ada,) = collect(make_class({f"ada/{n}.py": "" for n in range(3)}))
    assert [paper.name for paper in ada.papers] == ["ada/0.py", "ada/1.py"]
    assert ada.problems == ("ada: holds more than 2 files; only the first 2 are graded",)


def test_folder_that_is_none_or_empty_is_refused(tmp_path: Path) -> None:
    """The message names it."""
    with pytest.raises(ValueError, match="none: there is no such folder"):
        collect(tmp_path / "none")
    with pytest.raises(ValueError, match="nothing has been handed in"):
        collect(tmp_path)

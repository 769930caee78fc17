"""Downloads of Canvas, Moodle and Gradescope: whose each file is, and when it was handed in."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.class_run.collect import HandIn, collect
from lesson_code.course.class_run.downloads import Named, canvas_forms, named
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.class_run.sheets import SheetError

from .conftest import RIGHT, SWAPS, MakeClass

GRADESCOPE = """\
---
submission_11:
  :submitters:
  - :name: Ada Byron
    :sid: '0071'
    :email: ada@x.org
  - :name: Bob
    :sid:
    :email: bob@x.org
  :created_at: 2026-11-20 22:59:00.123456000 Z
  :score: 0.0
submission_12:
  :submitters:
  - :name: Eve
    :sid: '0073'
    :email: eve@x.org
  :created_at: !ruby/object:Time 2026-11-21 08:00:00 UTC
"""
"""As Gradescope writes it, with a student without a number and a class of Ruby's."""


def by_id(hand_ins: list[HandIn]) -> dict[str, HandIn]:
    """Return hand-ins by their students."""
    return {hand_in.student.id: hand_in for hand_in in hand_ins}


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("byronada_123_4567_01_one", Named("canvas", "byronada", "123", file=4567)),
        ("byronada_LATE_123_4567_x", Named("canvas", "byronada", "123", True, 4567)),
        ("b_c_123_4567_8_9_x", Named("canvas", "b_c", "123", file=4567)),
        ("Ada_9_assignsubmission_file_1_2_x", Named("moodle", "Ada", "9")),
        ("ada_01_one_dimension", None),
        ("_1_2_x", None),
        ("byronada_123_text", Named("canvas", "byronada", "123")),
    ],
)
def test_named_reads_what_a_course_system_made_of_a_name(name: str, says: Named | None) -> None:
    """Numbers that a student writes into the file's name come after Canvas's own."""
    assert named(name) == says


WORDS = st.text(st.sampled_from("aZéßñŁ文'-."), min_size=1, max_size=6)


@given(first=WORDS, last=WORDS)
def test_canvas_form_is_that_of_the_sortable_name(first: str, last: str) -> None:
    """Canvas takes all but letters out of ``Last, First``, whichever order the roster has."""
    canvas = "".join(letter for letter in f"{last}, {first}".lower() if letter.isalpha())
    if canvas:
        assert canvas in canvas_forms(f"{first} {last}")
        assert canvas in canvas_forms(f"{last}, {first}")


def test_canvas_file_is_credited_by_number_and_else_by_name(make_class: MakeClass) -> None:
    """With Canvas's gradebook as roster by number; with another by name, if one line fits."""
    folder = make_class({"byronada_123_1_a.py": RIGHT, "lee_LATE_9_2_b.py": RIGHT})
    own = [Enrolled("123", "Byron, Ada", canvas="123"), Enrolled("9", "Li", canvas="9")]
    found = by_id(collect(folder, own).hand_ins)
    assert {name: hand_in.entries for name, hand_in in found.items()} == {
        "123": ("byronada_123_1_a.py",),
        "9": ("lee_LATE_9_2_b.py",),
    }
    assert (found["9"].papers[0].is_late, found["9"].papers[0].handed_in) == (True, None)
    other = [Enrolled("ab", "Ada Byron"), Enrolled("le", "Lee"), Enrolled("l2", "Lee")]
    found = by_id(collect(folder, other).hand_ins)
    assert found["ab"].entries == ("byronada_123_1_a.py",)
    assert "fits 2 lines of the roster (le, l2)" in found["lee_LATE_9_2_b"].unmatched
    alone = by_id(collect(folder).hand_ins)
    assert alone["byronada_123"].student.canvas == "123"


def test_moodle_folder_is_credited_by_the_number_of_the_worksheet(make_class: MakeClass) -> None:
    """Two students of one name are told apart, and a group's name before it does no harm."""
    folder = make_class(
        {
            "Kim Lee_1_assignsubmission_file/a.py": RIGHT,
            "Red-Kim Lee_2_assignsubmission_file/a.py": SWAPS,
            "Kim Lee_3_assignsubmission_file/a.py": SWAPS,
        }
    )
    lines = [Enrolled(f"Participant {n}", "Kim Lee", moodle=str(n)) for n in (1, 2)]
    found = by_id(collect(folder, lines).hand_ins)
    assert found["Participant 1"].papers[0].name.startswith("Kim Lee_1_")
    assert found["Participant 2"].papers[0].name.startswith("Red-Kim Lee_2_")
    assert found["Kim Lee_3_assignsubmission_file"].unmatched == "fits no line of the roster"


def test_gradescope_folder_is_its_submitters_at_the_time_of_its_list(
    make_class: MakeClass,
) -> None:
    """A group's folder is everybody's in it; the list is left out, and named."""
    files = {f"submission_{n}/a.py": RIGHT for n in (11, 12)}
    folder = make_class({"submission_metadata.yml": GRADESCOPE, **files})
    hand_ins, left_out = collect(folder)
    assert left_out == ("left out, Gradescope's list of submissions: submission_metadata.yml",)
    assert [hand_in.student.id for hand_in in hand_ins] == ["0071", "0073", "bob@x.org"]
    times = [hand_in.papers[0].handed_in for hand_in in hand_ins]
    assert times[1] == datetime(2026, 11, 21, 8, tzinfo=UTC)
    assert times[0] == times[2] == datetime(2026, 11, 20, 22, 59, 0, 123456, tzinfo=UTC)
    roster = [Enrolled("71", also=("ada@x.org",)), Enrolled("eve", "Eve")]
    found = by_id(collect(folder, roster).hand_ins)
    assert found["71"].entries == ("submission_11",)
    assert found["eve"].entries == ("submission_12",)
    assert found["submission_11, Bob"].unmatched == "fits no line of the roster"


def test_folder_around_a_gradescope_download_is_refused(make_class: MakeClass) -> None:
    """Otherwise the whole class would be one student."""
    folder = make_class({"assignment_1_export/submission_metadata.yml": GRADESCOPE})
    with pytest.raises(ValueError, match=r"grade .*assignment_1_export"):
        collect(folder)
    make_class({"eve.py": RIGHT})  # a student's own file of this name stops nobody's grading
    assert len(collect(folder).hand_ins) == 2


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[", "is not Gradescope's list of submissions"),
        ("a", "is not Gradescope's list of submissions"),
        ("submission_11: {}", "submission_11 has no :submitters:"),
        ("submission_11:\n  :submitters: []\n", "submission_11 has no time :created_at:"),
        ("[" * 5000, "is not Gradescope's list of submissions"),
    ],
)
def test_bad_gradescope_list_is_refused(make_class: MakeClass, text: str, said: str) -> None:
    """With the file and what is wrong."""
    folder = make_class({"submission_metadata.yml": text, "submission_11/a.py": RIGHT})
    with pytest.raises(SheetError, match=r"submission_metadata\.yml: ") as refused:
        collect(folder)
    assert said in str(refused.value)


def test_team_shares_what_one_of_it_handed_in(tmp_path: Path, make_class: MakeClass) -> None:
    """It is said from whom; nobody else has it."""
    folder = make_class({"ada.py": RIGHT, "bob.py": SWAPS})
    roster = [
        Enrolled("ada", team="Red"),
        Enrolled("eve", team="red "),
        Enrolled("bob"),
        Enrolled("zoe"),
    ]
    found = by_id(collect(folder, roster).hand_ins)
    assert {name: hand_in.entries for name, hand_in in found.items()} == {
        "ada": ("ada.py",), "eve": ("ada.py",), "bob": ("bob.py",), "zoe": (),
    }  # fmt: skip
    assert found["eve"].notes == ("ada.py: handed in by ada",)


def test_download_gives_its_numbers_to_a_roster_that_has_none(make_class: MakeClass) -> None:
    """Only where all that is graded is named by the system: a student may write such a name."""
    roster = [Enrolled("s1", "Ada"), Enrolled("s2", "Bob")]
    files = {f"{who}_{n}_assignsubmission_file/a.py": RIGHT for who, n in (("Ada", 5), ("Bob", 6))}
    found = by_id(collect(make_class(files), roster).hand_ins)
    assert [found[name].student.moodle for name in ("s1", "s2")] == ["5", "6"]
    found = by_id(collect(make_class({"other.py": RIGHT}), roster).hand_ins)
    assert [found[name].student.moodle for name in ("s1", "s2")] == ["", ""]

"""Whose an entry is: one line of the roster fits its whole name, or it is nobody's."""

from __future__ import annotations

import pytest

from lesson_code.course.class_run.matching import Owner, owners
from lesson_code.course.class_run.roster import Enrolled

ROSTER = [
    Enrolled("ada", "Ada Lovelace"),
    Enrolled("b7", "Ada Byron"),
    Enrolled("c1", "Kim Lee"),
    Enrolled("c2", "kim lee"),
    Enrolled("ann"),
    Enrolled("ann_1"),
    Enrolled("grace hopper"),
]


def owner(name: str) -> Owner:
    """Return the owner of one name."""
    ((found,),) = owners([name], ROSTER)
    return found


@pytest.mark.parametrize(
    ("name", "student"),
    [
        ("ada", "ada"),
        ("ADA", "ada"),
        ("ada_01_one_dimension", "ada"),
        ("ada-pool", "ada"),
        ("ada (1)", "ada"),
        ("ada_LATE_123_456_my answers", "ada"),
        ("ada_", "ada"),
        ("Ada Byron", "b7"),
        ("Byron, Ada", "b7"),
        ("LOVELACE, ada", "ada"),
        ("ann_1", "ann_1"),
        ("Ada Byron_123_assignsubmission_file", "b7"),
        ("Ada Byron_123_assignsubmission_file_", "b7"),
        ("Ada Byron_123_assignsubmission_onlinetext", "b7"),
        ("Ada Byron_123_assignsubmission_file_01_one_dimension", "b7"),
        ("Grace Hopper_9_assignsubmission_file", "grace hopper"),
    ],
)
def test_name_that_one_line_fits_whole_is_credited_to_it(name: str, student: str) -> None:
    """An id, a name, an id before an exercise or a number, and what Moodle makes of a name."""
    assert owner(name) == Owner(student)


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("ada_byron", "fits no line"),
        ("Ada B", "fits no line"),
        ("ada_pooley", "fits no line"),
        ("Ada_123_assignsubmission_file_", ""),
        ("Ada Byrons_123_assignsubmission_file", "fits no line"),
        ("Kim Lee", "fits 2 lines of the roster (c1, c2)"),
        ("Lee, Kim", "fits 2 lines of the roster (c1, c2)"),
        ("Byron Ada", "fits no line"),
        ("Byron, Ada, Jr.", "fits no line"),
        ("Ada, Byron", "fits no line"),
        ("Kim Lee_5_assignsubmission_file", "fits 2 lines of the roster (c1, c2)"),
        ("ann_1_02_restitution", "fits 2 lines of the roster (ann, ann_1)"),
        ("Ada Byron_1_assignsubmission_file_2_assignsubmission_file", "fits no line"),
    ],
)
def test_name_that_no_line_fits_or_several_is_nobodys(name: str, why: str) -> None:
    """It keeps all of its name, and the reason is said; a full name Ada is the id ada's."""
    assert owner(name).id == (name if why else "ada")
    assert why in owner(name).unmatched


def test_two_moodle_numbers_of_one_name_are_two_students() -> None:
    """One line of the roster cannot be both, so neither folder is credited to it."""
    names = [f"Ada Byron_{n}_assignsubmission_file" for n in (1, 2)]
    for name, (found,) in zip(names, owners(names, ROSTER), strict=True):
        assert found.id == name
        assert "as another student's does (numbers 1, 2)" in found.unmatched
    assert [found.id for (found,) in owners(names, None)] == ["Ada Byron_1", "Ada Byron_2"]


def test_files_of_one_moodle_number_are_one_students() -> None:
    """The folder of files and that of the text typed in belong together, with a roster or not."""
    names = [f"Ada Byron_1_assignsubmission_{kind}" for kind in ("file", "onlinetext")]
    assert [found.id for (found,) in owners(names, ROSTER)] == ["b7", "b7"]
    assert [found.id for (found,) in owners(names, None)] == ["Ada Byron_1", "Ada Byron_1"]


@pytest.mark.parametrize(
    ("called", "enrolled"),
    [
        ("Conan OBrien_5_assignsubmission_file", Enrolled("s", "Conan O'Brien")),
        ("Ali 1 2 ibn Sina_5_assignsubmission_file", Enrolled("s", "Ali_1_2 ibn_Sina")),
        ("S Slash_5_assignsubmission_file", Enrolled("s", "S Sla/sh")),
        ("Ada Byron_5_assignsubmission_file", Enrolled("s", "Byron, Ada")),
        ("Red-Ada Byron_5_assignsubmission_file", Enrolled("s", "Ada Byron", team="Red")),
        ("ibn_sinaali12_5_9_x", Enrolled("s", "ibn_Sina, Ali_1_2")),
    ],
)
def test_letters_that_a_course_system_takes_out_lead_to_the_same_line(
    called: str, enrolled: Enrolled
) -> None:
    """Moodle's PARAM_FILE takes out apostrophes and slashes; Canvas low lines round a number."""
    assert owners([called], [enrolled, Enrolled("t", "Ada Bryon")]) == [[Owner("s")]]


def test_name_as_it_stands_in_one_line_goes_before_the_same_name_turned() -> None:
    """A comma tells two students apart whom the roster writes in two ways."""
    roster = [Enrolled("a", "Lee, Kim"), Enrolled("b", "Kim Lee")]
    assert owners(["Lee, Kim"], roster) == [[Owner("a")]]
    assert owners(["Kim Lee"], roster)[0][0].unmatched.startswith("fits 2 lines")


@pytest.mark.parametrize("written", ["Sam Comma, Jr.", "Comma, Jr., Sam"])
def test_name_with_two_commas_is_found_with_its_first_name_first(written: str) -> None:
    """Canvas lists Sam Comma, Jr. as "Comma, Jr., Sam"; a folder has either."""
    roster = [Enrolled("sam", "Comma, Jr., Sam"), Enrolled("ada", "Byron, Ada")]
    assert owners([written], roster) == [[Owner("sam")]]

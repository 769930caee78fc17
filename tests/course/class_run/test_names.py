"""Names that students choose."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.class_run.names import (
    encodable,
    file_stem,
    same_name,
    sheet_text,
    shown,
    told_apart,
    visible,
)

NAMES = [
    "ada",
    "Ada",
    "a/b",
    "a\\b",
    "..",
    "",
    "=cmd()",
    "a\u202eb",
    "Zo\u00eb",
    "CON",
    "a\nb",
    "\udcff",
]


@pytest.mark.parametrize("name", NAMES)
def test_shown_name_is_one_visible_line(name: str) -> None:
    """Nothing that is shown breaks a line, turns the direction of writing or cannot be encoded."""
    assert shown(name).isprintable()
    assert shown(name).encode("utf-8").decode("utf-8") == shown(name)


def test_shown_right_to_left_mark_is_written_out() -> None:
    """A mark that would turn a name round stands there as its number."""
    assert shown("a\u202egpj.exe") == "a<U+202E>gpj.exe"


@given(st.text(max_size=60), st.text(max_size=60))
def test_file_stem_is_safe_and_tells_students_apart(one: str, other: str) -> None:
    """Letters, digits and hyphens only, so that no path is left and no system objects."""
    stem = file_stem(one)
    assert stem
    assert set(stem) <= set("abcdefghijklmnopqrstuvwxyz0123456789-")
    assert len(stem) <= 50
    assert (file_stem(other) == stem) == (one == other)


@pytest.mark.parametrize("form", [file_stem, visible, encodable, lambda _: "one"])
@given(names=st.lists(st.text(max_size=8), unique=True, max_size=8))
def test_told_apart_no_two_names_have_one_form(
    form: Callable[[str], str], names: list[str]
) -> None:
    """Not even where all forms are the same; a name that is its own form keeps it."""
    apart = told_apart(names, form)
    assert len(set(apart.values())) == len(names)
    assert all(apart[name] == name for name in names if form(name) == name)


def test_told_apart_a_made_up_number_is_nobody_elses() -> None:
    """Who calls a folder as the second of two is called does not get that file."""
    apart = told_apart(["A", "a", "a-2", "\u00e1"], str.casefold)
    assert apart == {"A": "a-3", "a": "a", "a-2": "a-2", "\u00e1": "\u00e1"}


@given(st.text(alphabet=st.characters(), max_size=20))
def test_encodable_can_be_written_and_keeps_all_else(text: str) -> None:
    """UTF-8 takes it; a text that is one already stays as it is."""
    encodable(text).encode("utf-8")
    with suppress(UnicodeEncodeError):
        text.encode("utf-8")
        assert encodable(text) == text


def test_file_stem_that_a_student_makes_up_is_nobody_elses() -> None:
    """Who calls a folder as another's file is called does not get that file."""
    assert len({file_stem(name) for name in ("ADA", file_stem("ADA"), "", file_stem(""))}) == 4
    assert file_stem("nul") != "nul"


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\t=", " =", "\uff1d"])
def test_sheet_text_never_begins_as_a_formula(start: str) -> None:
    """What a spreadsheet would compute begins with an apostrophe, also after white space."""
    assert sheet_text(f"{start}cmd|'/c calc'!A1").startswith("'")
    assert sheet_text("Ada = Eva") == "Ada = Eva"


@given(st.text(max_size=40))
def test_sheet_text_survives_a_csv_file(text: str) -> None:
    """What is shown of any name comes back out of a CSV file as it went in."""
    cell = sheet_text(shown(text))
    written = io.StringIO(newline="")
    csv.writer(written).writerow([cell, "x"])
    assert next(csv.reader(io.StringIO(written.getvalue(), newline=""))) == [cell, "x"]


def test_same_name_is_the_same_however_it_is_written() -> None:
    """Case, outer spaces and two ways to write an umlaut make no difference."""
    assert same_name(" Zoe\u0308 ") == same_name("ZO\u00cb")

"""The exports: every program can read them, no spreadsheet runs them, nothing hidden is in them."""

from __future__ import annotations

import csv
import io
import json
import re
from html.parser import HTMLParser
from pathlib import Path
from random import Random

import pytest

from lesson_code.course.class_run import Gradebook, Hands, grade_class
from lesson_code.course.class_run.exports import as_csv, as_dict, feedback_name
from lesson_code.course.class_run.imports import gradescope
from lesson_code.course.class_run.pages import class_page, student_page
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.verdict import stream_of

from .conftest import RIGHT, SWAPS, MakeClass

SEED = 7
TELLS_ITS_INPUTS = "def elastic_1d(*a):\n    raise ValueError(repr(a))\n"
ODD = "=cmd()"
ROSTER = f"id,name,email\nada,<b>Ada</b> & Co,a@b.org\neve,,\nbob,Bob\u202e,\n{ODD},+1,\n"


@pytest.fixture
def book(make_class: MakeClass, tmp_path: Path) -> Gradebook:
    """Return the marks of a small class with odd names and every kind of answer."""
    folder = make_class(
        {"ada.py": SWAPS, "eve.py": RIGHT, f"{ODD}.py": TELLS_ITS_INPUTS, "zip.zip": "PK"}
    )
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    roster = tmp_path / "roster.csv"
    return grade_class(folder, tmp_path / "out", roster=roster, seed=SEED, hands=Hands(1))


def test_csv_has_a_line_for_everybody_and_no_formula(book: Gradebook) -> None:
    """Points add up to the total; a cell never begins with what a spreadsheet computes."""
    rows = list(csv.DictReader(io.StringIO(as_csv(book), newline="")))
    assert [row["id"] for row in rows] == ["'=cmd()", "ada", "bob", "eve", "zip"]
    assert [row["total"] for row in rows] == ["0", "1", "0", "10", "0"]
    assert [row["status"] for row in rows] == [
        "graded", "graded", "missing", "graded", "not gradable",
    ]  # fmt: skip
    for row in rows:
        parts = [int(row[f"{t.id} {t.function}"]) for t in book.exercises[0].tasks]
        assert sum(parts) == int(row["01_one_dimension"]) == int(row["total"])
        assert not any(cell.startswith(("=", "+", "-", "@", "\t")) for cell in row.values())
        assert all(cell.isprintable() for cell in row.values())


def test_json_holds_everybody_under_the_name_that_was_given(book: Gradebook) -> None:
    """One object with a version; names as they are, so that they can be matched."""
    value = json.loads(json.dumps(as_dict(book)))
    assert (value["version"], value["command"], value["seed"]) == (3, "grade", SEED)
    assert [student["id"] for student in value["students"]] == [
        "=cmd()",
        "ada",
        "bob",
        "eve",
        "zip",
    ]
    assert value["students"][2]["name"] == "Bob\u202e"
    assert value["tasks"][0]["misconceptions"][0]["name"] == "always_swaps"
    assert value["isolation"]


def test_gradescope_results_have_scores_that_it_can_read(book: Gradebook) -> None:
    """The keys are those of its format; a test never scores more than its most."""
    for student in book.students:
        results = gradescope(student, book)
        assert results["score"] == student.points == sum(test["score"] for test in results["tests"])
        for test in results["tests"]:
            assert 0 <= test["score"] <= test["max_score"]
            assert test["visibility"] == "visible"
            assert isinstance(test["output"], str)


def test_files_are_written_for_everybody_and_for_nobody_else(
    book: Gradebook, tmp_path: Path
) -> None:
    """A page and a results.json each, under a name that is safe on every system."""
    out = tmp_path / "out"
    pages = {path.relative_to(out).as_posix() for path in (out / "feedback").iterdir()}
    assert pages == {feedback_name(student) for student in book.students}
    assert (out / "grades.csv").read_bytes().startswith(b"\xef\xbb\xbf")  # so that sheets see UTF-8


def hidden_numbers() -> set[str]:
    """Return inputs and expected values of task 1.1 with the seed of the class."""
    task = task_by_id("1.1")
    numbers: set[float] = set()
    for criterion in task.criteria:
        stream: Random = stream_of(task, criterion, SEED)
        for arguments in criterion.cases(stream):
            numbers |= {*arguments, *task.expected(*arguments)}
    return {f"{abs(number):.6g}" for number in numbers if number != round(number, 1)}


def test_what_students_get_holds_no_hidden_input_or_value(book: Gradebook) -> None:
    """Not in a page, not in results.json, and not through an error that quotes its inputs."""
    hidden = hidden_numbers()
    assert len(hidden) > 20
    for student in book.students:
        for text in (student_page(student, book), json.dumps(gradescope(student, book))):
            shown = set(re.findall(r"\d+\.\d+", text.partition("</head>")[2] or text))
            assert not shown & hidden, student.id
            assert f"seed {SEED}" not in text.lower()


class Outline(HTMLParser):
    """Reads a page's headings and tables, and whether its elements are closed in order."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.headings: list[int] = []
        self.open: list[str] = []
        self.seen: set[str] = set()
        self.outside: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        """Note an element."""
        self.seen.add(tag)
        if tag not in ("meta", "br"):
            self.open.append(tag)
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        self.outside += [v for k, v in attributes if k in ("src", "href") and v and ":" in v]
        if tag == "th":
            assert dict(attributes).get("scope") in ("row", "col")
        if tag == "html":
            assert dict(attributes)["lang"] == "en"

    def handle_endtag(self, tag: str) -> None:
        """Close the element that was opened last."""
        assert self.open.pop() == tag


def test_pages_are_sound_and_can_be_read_by_ear(book: Gradebook) -> None:
    """One main heading, none skipped; tables with captions and scopes; nothing is loaded or run."""
    pages = [class_page(book), *(student_page(student, book) for student in book.students)]
    for page in pages:
        outline = Outline(page)
        assert outline.open == []
        assert outline.headings.count(1) == 1
        assert all(b - a <= 1 for a, b in zip(outline.headings, outline.headings[1:], strict=False))
        assert not outline.seen & {"script", "img", "iframe", "link", "form"}
        assert not outline.outside
        assert page.count("<table") == page.count("<caption")
        assert "@media print" in page


def test_page_shows_names_as_text(book: Gradebook) -> None:
    """A name is no markup and turns no writing round; right and wrong are said in words."""
    pages = {student.id: student_page(student, book) for student in book.students}
    assert "&lt;b&gt;Ada&lt;/b&gt; &amp; Co" in pages["ada"]
    assert "Bob&lt;U+202E&gt;" in pages["bob"]
    assert "✗ not right" in pages["ada"]
    assert "Only equal masses exchange velocities." in pages["ada"]
    assert "nothing was handed in" in pages["bob"]
    assert "10 of 10 points" in pages["eve"]
    assert "What to teach next" in class_page(book)

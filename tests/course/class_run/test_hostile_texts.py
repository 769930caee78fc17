"""Names and texts send nothing to a terminal, a sheet or a page, wherever students put them."""

from __future__ import annotations

import csv
import io
import json
import os
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console
from typer.testing import CliRunner, Result

from lesson_code.cli import app
from lesson_code.course.class_run.imports import NO_GRADE_YET
from lesson_code.course.class_run.names import FORMULA_STARTS, encodable, visible
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.report import print_report

from .conftest import MakeClass

TEXTS = (
    "\x1b[2J\x1b]0;owned\x07",
    "\x1b]8;;http://evil.example\x1b\\click\x1b]8;;\x1b\\",
    "\x9b31mred",
    "\u202egpj.exe\u2066",
    "\r1.1 elastic_1d: 4/4 points\n",
    '=HYPERLINK("http://evil.example","ok")',
    "+cmd|' /C calc'!A0",
    "-1+1",
    "@SUM(1)",
    "\t=1+1",
    "\u200b=1+1",
    "\uff1d1+1",
    ' ", =1+1, "',
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "\"><svg onload=alert(1)>'",
    "</code></bdi></main><h1>forged</h1>",
    "[bold red]forged[/]",
    "[link=http://evil.example]x[/link]",
    "{{ 7 * 7 }}{% for x in y %}",
    "\ud800\udfff",
)
"""What a terminal, a spreadsheet, a browser, rich or jinja2 might obey."""

ANSWER = """\
TEXT = {text!r}
class Odd(Exception): pass
Odd.__name__ = Odd.__qualname__ = TEXT
def elastic_1d(m1, v1, m2, v2): raise Odd(TEXT)
def inelastic_1d(m1, v1, m2, v2): return TEXT, [TEXT]
def elastic_impulse_1d(m1, v1, m2, v2): return Odd()
# {comment}
raise Odd(TEXT)
"""

BROKEN = "def elastic_1d(m1, v1, m2, v2):\n    return {comment} (\n"

TAGS_OF_STUDENTS = {"script", "img", "svg", "h1"}
"""Tags that stand in TEXTS; of these, the pages have one h1."""


class Tags(HTMLParser):
    """Lists the tags of a page, and the attributes that would run something."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.run: list[tuple[str, str | None]] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        """Note a tag."""
        self.found.append(tag)
        self.run += [each for each in attributes if each[0].startswith("on")]


def file_name(text: str, number: int) -> str:
    """Return a text as part of a file's name, which no folder and no system cuts short."""
    kept = encodable(text).replace("/", "").replace("\\", "").replace("\0", "")[:60]
    return f"{kept}{number}"


def sources() -> dict[str, str]:
    """Return two submissions for each text: one that runs, and one that cannot be read."""
    made = {}
    for number, text in enumerate(TEXTS):
        comment = encodable(text).replace("\n", " ").replace("\r", " ")
        answers = {
            "": ANSWER.format(text=text, comment=comment),
            "b": BROKEN.format(comment=comment),
        }
        for kind, source in answers.items():
            cell = {"cell_type": "code", "metadata": {}, "outputs": [], "source": source}
            notebook: dict[str, Any] = {"cells": [cell], "metadata": {}, "nbformat": 4}
            made[f"{file_name(text, number)}{kind}.ipynb"] = json.dumps(notebook)
    return made


def run(*arguments: object) -> Result:
    """Run the command, here."""
    given = ["grade", *map(str, arguments), "--exercise", "01", "--isolation", "none"]
    return CliRunner().invoke(app, given)


def is_obeyed(text: str) -> bool:
    """Return whether a text for a terminal holds anything but what is seen."""
    return not all(character.isprintable() or character == "\n" for character in text)


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Result, Path]:
    """Return what the command says of a class of hostile texts, and where its files are."""
    if os.name != "posix":
        pytest.skip("other systems refuse such names")
    folder = tmp_path_factory.mktemp("hostile")
    handed_in, out = folder / "class", folder / "out"
    handed_in.mkdir()
    names = sources()
    for name, content in names.items():
        (handed_in / name).write_text(content)
    rows = [
        [name.removesuffix(".ipynb"), TEXTS[n % len(TEXTS)], ""] for n, name in enumerate(names)
    ]
    roster = io.StringIO(newline="")
    csv.writer(roster).writerows([["id", "name", "email"], *rows])
    (folder / "roster.csv").write_text(encodable(roster.getvalue()), encoding="utf-8", newline="")
    return run(handed_in, "--out", out, "--roster", folder / "roster.csv", "--seed", 3), out


def test_class_run_sends_nothing_to_a_terminal(graded: tuple[Result, Path]) -> None:
    """What is printed can be seen, and forges no line."""
    ran, _ = graded
    assert ran.exit_code in (0, 1), ran.output
    assert not is_obeyed(ran.stdout)
    assert not is_obeyed(ran.stderr)
    assert "1.1 elastic_1d: 4/4 points" not in ran.output.splitlines()


def test_class_run_writes_no_formula_into_a_sheet(graded: tuple[Result, Path]) -> None:
    """No cell of any sheet begins as a formula does, or holds what is not seen."""
    _, out = graded
    sheets = list(out.rglob("*.csv"))
    assert {"grades.csv", "canvas.csv", "moodle.csv"} & {sheet.name for sheet in sheets}
    for sheet in sheets:
        rows = list(csv.reader(io.StringIO(sheet.read_text("utf-8-sig"), newline="")))
        for cell in (cell for row in rows for cell in row if cell != NO_GRADE_YET):
            assert not cell.lstrip().startswith(FORMULA_STARTS), (sheet.name, cell)
            assert all(c.isprintable() or c in "\n" for c in cell), (sheet.name, cell)


def test_class_run_puts_no_markup_into_a_page(graded: tuple[Result, Path]) -> None:
    """Neither a student's page nor the class's holds a tag, a script or a turn of a student's."""
    _, out = graded
    pages = list(out.rglob("*.html"))
    assert len(pages) == 2 * len(TEXTS) + 1
    for page in pages:
        text = page.read_text("utf-8")
        tags = Tags(text)
        assert [tag for tag in tags.found if tag in TAGS_OF_STUDENTS] == ["h1"], page.name
        assert tags.run == []
        assert not is_obeyed(text), page.name
        assert page.name.isascii()


@pytest.mark.skipif(os.name != "posix", reason="other systems refuse such names")
@pytest.mark.one_in(4)
@pytest.mark.parametrize("number", range(len(TEXTS)), ids=lambda n: visible(TEXTS[n])[:20])
def test_report_of_one_file_sends_nothing_to_a_terminal(number: int, make_class: MakeClass) -> None:
    """The report of one submission shows what it says, and obeys none of it."""
    made = dict(list(sources().items())[2 * number : 2 * number + 2])
    folder = make_class(made)
    console = Console(width=200, file=io.StringIO(), force_terminal=False)
    with Grader() as grader:
        for name in made:
            print_report(grader.grade(folder / name, exercise="01", seed=1), console)
    shown = console.file.getvalue()  # type: ignore[attr-defined]
    shown.encode()
    assert not is_obeyed(shown)

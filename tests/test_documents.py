"""README, CONTRIBUTING and the handbook: what they name is there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from lesson_code.cli import app
from lesson_code.course.site.front_pages import PAGES

ROOT = Path(__file__).parents[1]
HANDBOOK = ROOT / "lesson_code" / "course" / "site" / "pages"
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(HANDBOOK.glob("*.md"))]
A_SCREEN = 25
"""Lines."""

PLACES = (ROOT, ROOT / "lesson_code", ROOT / "tests")
"""What paths are written from."""

PATH = re.compile(r"`([\w.]+(?:/[\w.]+)+)`")
PLACEHOLDER = re.compile(r"NAME|TOPIC|FOLDER|FILE")
COMMAND = re.compile(r"`(?:\.venv/bin/)?workbook ([a-z]+)")
LINK = re.compile(r"\]\(([^)#]+)\)")

IN_A_STUDENTS_COPY_ALONE = {"lesson_code/workbook"}
WORDS = [
    "broad phase",
    "narrow phase",
    "candidate pair",
    "separating axis",
    "minimum translation vector",
    "manifold",
    "contact",
    "normal",
    "penetration",
    "reference edge",
    "incident edge",
    "effective mass",
    "impulse",
    "restitution",
    "friction",
    "warm starting",
    "slop",
    "Baumgarte factor",
    "time of impact",
    "island",
    "sleeping",
    "Delassus matrix",
    "split impulse",
    "pseudo-velocity",
    "block solver",
    "internal edge",
    "ghost collision",
    "event prediction",
    "mixing rule",
    "capacity",
    "minimum width",
    "sub-step",
]


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_paths_and_links_of_a_document_lead_somewhere(document: Path) -> None:
    """Every file that it names in code, and every local link, is there."""
    text = document.read_text(encoding="utf-8")
    for path in set(PATH.findall(text)) - IN_A_STUDENTS_COPY_ALONE:
        if not PLACEHOLDER.search(path):
            assert any((place / path).exists() for place in PLACES), path
    for target in LINK.findall(text):
        if not target.startswith("http"):
            assert (document.parent / target).exists(), target


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_commands_of_a_document_exist(document: Path) -> None:
    """What stands there can be typed."""
    from typer.main import get_command

    known = set(get_command(app).commands)  # type: ignore[attr-defined]
    assert set(COMMAND.findall(document.read_text(encoding="utf-8"))) <= known


@pytest.mark.parametrize("part", ["For students", "For instructors", "For maintainers"])
def test_part_of_the_readme_fits_on_a_screen(part: str) -> None:
    """A reader sees all that is meant for them at once; the handbook has the rest."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    lines = readme.split(f"\n## {part}\n")[1].split("\n## ")[0].strip().splitlines()
    assert len(lines) <= A_SCREEN + 3 * (part == "For students")  # a row for each notebook


def test_handbook_is_complete_and_the_glossary_has_the_words() -> None:
    """Each page has its place in the site, and each word its line."""
    assert {path.stem for path in HANDBOOK.glob("*.md")} == set(PAGES)
    table = (HANDBOOK / "glossary.md").read_text(encoding="utf-8")
    listed = [
        word for row in re.findall(r"^\| ([^|]+) \|", table, re.M) for word in row.split(", ")
    ]
    assert set(WORDS) <= set(listed)
    assert len(listed) == len(set(listed))


def test_readme_shows_the_film_and_says_how_it_is_made() -> None:
    """The one file of the folder, and small: a clone of the workbook should stay small."""
    [film] = (ROOT / "notebooks" / "pictures").iterdir()
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert f"](notebooks/pictures/{film.name})" in readme
    assert re.search(rf"workbook play .* --record notebooks/pictures/{film.name}", readme)
    assert film.stat().st_size < 250_000

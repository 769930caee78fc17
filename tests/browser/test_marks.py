"""The pages of a class's marks in Chromium: read on a desk and on a phone, by day and by night."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from course.class_run.conftest import RIGHT, SWAPS
from course.class_run.test_alike import CONTACT
from course.recognition.newcomers import FIRST, SECOND, THIRD
from course.recognition.students import WRONG

from lesson_code.course.class_run import Hands, grade_class

from .test_pages import PHONE, violations_in

if TYPE_CHECKING:
    from playwright.sync_api import Page

DESK: Any = {"width": 1280, "height": 900}
NAMES = ("Ada Lovelace", "Zoë", "李 雷", "O'Neil & <b>Sons</b>", "Ab\u202edcba", "x" * 60, "=cmd()")
UNKNOWN = "def elastic_1d(m1, v1, m2, v2):\n    return m1 + v2 / 3, m2 * v1 + 0.7\n"
MOST_WRONG = 24
"""Students with a known wrong answer: one each."""


@pytest.fixture(scope="module")
def marks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of the pages of a class with every kind of answer."""
    folder = tmp_path_factory.mktemp("class")
    for name, text in _handed_in().items():
        (folder / name).write_text(text, encoding="utf-8")
    roster, out = folder.with_name("roster.csv"), folder.with_name("marks")
    ids = [path.stem for path in sorted(folder.iterdir())]
    rows = [f'{each},"{NAMES[n % len(NAMES)]}"' for n, each in enumerate(ids)]
    roster.write_text("\n".join(["id,name", *rows, "absent,Nobody"]), encoding="utf-8")
    grade_class(folder, out, exercises=["01", "02", "04"], roster=roster, seed=7, hands=Hands(1))
    return out


def _handed_in() -> dict[str, str]:
    """Return what a class hands in: right, wrong, unknown, copied and unreadable answers."""
    files = {"right.py": RIGHT, "swaps.py": SWAPS, "unknown.py": UNKNOWN}
    files |= {"copy-1.py": CONTACT, "copy-2.py": CONTACT, "broken.py": "def elastic_1d(:"}
    wrong = [w for w in (*FIRST, *SECOND, *THIRD, *WRONG) if w.task[:2] in ("1.", "2.", "4.")]
    return files | {f"student-{n}.py": w.source for n, w in enumerate(wrong[:MOST_WRONG])}


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [DESK, PHONE], ids=["desk", "phone"])
def test_class_page_passes_axe_and_fits(
    marks: Path, page: Page, faults: list[str], scheme: Any, size: Any
) -> None:
    """With all parts open axe-core finds nothing, no script is in it, and only tables scroll."""
    page.emulate_media(color_scheme=scheme)
    page.set_viewport_size(size)
    page.goto((marks / "class.html").as_uri())
    page.evaluate("for (const part of document.querySelectorAll('details')) part.open = true")
    assert violations_in(page) == []
    ground = page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert (ground == "rgb(255, 255, 255)") == (scheme == "light")
    assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]
    assert page.locator("script").count() == 0
    assert faults == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_every_students_page_is_reached_from_the_class_page_and_passes_axe(
    marks: Path, page: Page, faults: list[str], scheme: Any
) -> None:
    """Each link leads to a student's page; axe-core finds nothing in a few of them."""
    page.emulate_media(color_scheme=scheme)
    page.set_viewport_size(PHONE)
    page.goto((marks / "class.html").as_uri())
    links = page.locator("th a").all()
    targets = [link.get_attribute("href") or "" for link in links]
    assert len(targets) == len(_handed_in()) + 1
    assert all((marks / target).is_file() for target in targets)
    for target in targets[:: len(targets) // 4]:
        page.goto((marks / target).as_uri())
        assert violations_in(page) == []
        assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
    assert faults == []


def test_what_to_teach_next_opens_by_the_keyboard(marks: Path, page: Page) -> None:
    """Tab and Enter open who made a mistake, and lead to a student's page."""
    page.goto((marks / "class.html").as_uri())
    closed = page.locator("details:not([open]) > summary").first
    closed.focus()
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.tagName") == "A"
    page.keyboard.press("Enter")
    page.wait_for_url("**/feedback/**")
    assert page.locator("h1").count() == 1

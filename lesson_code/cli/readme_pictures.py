"""The pictures of the README: what each is called, what it shows, and how it is made.

To add one, write a function that takes it and put it into PICTURES.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PIL import Image

from lesson_code.chapters.programs import load
from lesson_code.course.notebooks.root import find_root
from lesson_code.course.site.build import build
from lesson_code.course.site.in_browser import chromium, jupyterlab
from lesson_code.view.pygame.frame import play

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

COLOURS = 128
"""Enough for a picture of a screen."""

MOVING = "02_restitution"
"""The notebook whose page is shown."""

POOL_FRAMES, DOMINOES_FRAMES = 62, 150
"""Frames: 1 s, just after the break; and 2.5 s, when both rows are falling."""

DESKTOP: Any = {"width": 1100, "height": 720}
PHONE: Any = {"width": 390, "height": 720}

DRAWN = 1_500
"""ms: until a page that has come to rest has been painted."""


@dataclass(frozen=True)
class Studio:
    """What pictures are taken with: a browser, a copy of the workbook, and its pages."""

    browser: Browser
    root: Path
    site: Path


@dataclass(frozen=True)
class Picture:
    """A picture: its file's name without suffix, what it shows, and what writes it as a PNG."""

    name: str
    shows: str
    take: Callable[[Studio, Path], None]


def write_pictures(folder: Path, names: Sequence[str] = ()) -> Iterator[Path]:
    """Take the pictures of the README, and yield each file when it is there.

    Parameters
    ----------
    folder : Path
        Where they go.
    names : sequence of str
        Only these; none for all.

    Raises
    ------
    ValueError
        There is no picture of such a name.
    NoBrowserError, SiteError, ServerError
        What takes them is not installed.
    """
    known = {picture.name: picture for picture in PICTURES}
    for name in names:
        if name not in known:
            raise ValueError(f"picture must be one of {', '.join(known)}, got {name!r}")
    folder.mkdir(parents=True, exist_ok=True)
    with _studio() as studio:
        for name in names or known:
            file = folder / f"{name}.png"
            known[name].take(studio, file)
            _keep_few_colours(file)
            yield file


@contextmanager
def _studio() -> Iterator[Studio]:
    """Set up what pictures are taken with, and clear it away."""
    with tempfile.TemporaryDirectory(prefix="workbook-pictures-") as place, chromium() as browser:
        root = Path(place)
        for folder in ("notebooks", "exercises"):
            shutil.copytree(find_root() / folder, root / folder)
        build(root, root / "site", moving=[MOVING])
        yield Studio(browser, root, root / "site")


def _notebook(studio: Studio, file: Path) -> None:
    """Run a notebook in JupyterLab, and take its figure with sliders."""
    with jupyterlab(studio.root) as lab:
        page = studio.browser.new_page(viewport=DESKTOP)
        lab.open(page, "notebooks/01_one_dimension.ipynb").run_all()
        page.keyboard.press("Control+B")  # the list of files takes room
        _take(page, ".jp-OutputArea-output:has(.widget-slider)", file)


def _page(studio: Studio, file: Path) -> None:
    """Move the slider of a page, and take its figure."""
    page = studio.browser.new_page(viewport=DESKTOP)
    page.goto((studio.site / f"notebooks/{MOVING}.html").as_uri())
    slider = page.get_by_role("slider").first
    slider.focus()
    page.keyboard.press("ArrowRight")
    page.locator("figure.moving img[data-state]").wait_for()
    _take(page, "figure.moving", file)


def _phone(studio: Studio, file: Path) -> None:
    """Answer a question on a phone in the dark, and take the feedback."""
    page = studio.browser.new_page(viewport=PHONE, color_scheme="dark")
    page.goto((studio.site / f"notebooks/{MOVING}.html").as_uri())
    page.locator(".quiz input[type=radio]").first.check()
    page.get_by_role("button", name="Check question 1").click()
    _take(page, ".quiz form", file)


def _program(name: str, frames: int) -> Callable[[Studio, Path], None]:
    """Return what lets a program play itself without a window, and takes its last frame."""

    def take(_: Studio, file: Path) -> None:
        play(load(name), tour=True, frames=frames, headless=True, screenshot=file)

    return take


def _take(page: Page, element: str, file: Path) -> None:
    """Take a picture of what is in sight when an element is in the middle."""
    middle = "element => element.scrollIntoView({block: 'center', behavior: 'instant'})"
    page.locator(element).first.evaluate(middle)
    page.wait_for_timeout(DRAWN)
    page.screenshot(path=file)


def _keep_few_colours(file: Path) -> None:
    """Write a picture again with few colours, which takes a third of the room."""
    with Image.open(file) as picture:
        small = picture.convert("RGB").quantize(COLOURS)
    small.save(file, optimize=True)


PICTURES = (
    Picture("notebook", "notebook 01 in JupyterLab, at its sliders", _notebook),
    Picture("page", "the page of notebook 02, at its slider", _page),
    Picture("phone", "the quiz of notebook 02 on a phone, in the dark", _phone),
    Picture("pool", "pool, just after the break", _program("pool", POOL_FRAMES)),
    Picture("dominoes", "dominoes that fall in two rows", _program("dominoes", DOMINOES_FRAMES)),
)
"""All pictures of the README."""

"""The still picture of the collision lab, as it stands when it is opened.

The lab draws itself, in Chromium, and what it has drawn is kept with a sum over its script, as for
the live figures of the chapters (:mod:`lesson_code.view.browser.stills`).
"""

from __future__ import annotations

import re
from pathlib import Path

from lesson_code.view.browser.chromium import chromium
from lesson_code.view.browser.lab import STILL, lab_html, script_sum, title
from lesson_code.view.browser.live import CHAPTERS
from lesson_code.view.browser.stills import SUM, old_in_notebooks

NAME = "lab"

IN_NOTEBOOK = re.compile(r'<div data-lab=\\"([\w-]+)\\"')
"""The lab in a notebook's file, and its title."""

WIDTH = 720
"""Pixels that the opened lab is wide."""

CANVAS = "[data-lab][data-ready] canvas"
DRAWN = "canvas => [canvas.toDataURL(), canvas.width, canvas.height]"


def names_in(root: Path) -> list[str]:
    """Return the lab's name, if the workbook is this package's own."""
    return [NAME] if CHAPTERS.parents[1] == root else []


def fault(_name: str = NAME) -> str:
    """Return what is wrong with the lab's picture, or "" if nothing is."""
    if not STILL.exists():
        return "is missing; make it with workbook regenerate"
    found = SUM.search(STILL.read_text("utf-8"))
    return "" if found and found[1] == script_sum() else "is not what the lab draws"


def drifted(root: Path) -> list[str]:
    """Return in a line each what is wrong with the picture, and which notebook's lab is old."""
    lines = [f"{STILL.relative_to(root)}: {fault()}" for _ in names_in(root) if fault()]
    titles = {title() for _ in names_in(root)}
    return lines + old_in_notebooks(root, IN_NOTEBOOK, titles)


def write(_name: str = NAME) -> Path:
    """Let the lab draw itself, keep its picture, and return where that is.

    Raises
    ------
    NoBrowserError
        Playwright or Chromium is not installed.
    """
    with chromium() as browser:
        page = browser.new_page(viewport={"width": WIDTH, "height": WIDTH}, color_scheme="light")
        page.set_content(f"<!doctype html><body>{lab_html()}</body>")
        canvas = page.locator(CANVAS).first
        canvas.wait_for()
        picture, width, height = canvas.evaluate(DRAWN)
    STILL.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" data-sum="{script_sum()}" '
        f'width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
        f'<image width="{width}" height="{height}" href="{picture}"/></svg>\n',
        encoding="utf-8",
        newline="\n",
    )
    return STILL

"""The still pictures of live figures, as they stand when they are opened.

A figure draws itself, in Chromium, and what it has drawn is kept beside its description with a sum
over its script. ``workbook regenerate`` does that for figures whose sum has changed.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import TYPE_CHECKING

from lesson_code.view.browser.chromium import chromium
from lesson_code.view.browser.live import (
    CHAPTERS,
    PROGRAMS,
    colors,
    file_of,
    html_of,
    script_of,
    title_of,
)

if TYPE_CHECKING:
    from playwright.sync_api import Page

SUM = re.compile(r'data-sum="(\w+)"')
"""Stands in a picture: a sum over the script that drew it."""

IN_NOTEBOOK = re.compile(r'<figure data-live=\\"([\w-]+)\\"')
"""A figure in a notebook's file, and its title."""

DRAWN = """() => ["style", "svg > g", "svg"].map((found) => {
    const element = document.querySelector(`figure[data-ready] ${found}`);
    return found === "svg" ? element.getAttribute("viewBox") : element.innerHTML;
})"""
"""In the page: the figure's style, what it has drawn, and what part of the plane that is."""


def names() -> list[str]:
    """Return all live figures, each as its chapter's folder and its own name."""
    found = (file for file in CHAPTERS.glob("*/*.js") if PROGRAMS.search(file.read_text("utf-8")))
    return sorted(file.relative_to(CHAPTERS).with_suffix("").as_posix() for file in found)


def names_in(root: Path) -> list[str]:
    """Return those that belong to a workbook: all if it is this package's own."""
    return names() if CHAPTERS.parents[1] == root else []


def sum_of(figure: str) -> str:
    """Return a sum over a figure's script, in which any change of it shows."""
    return hashlib.sha256(script_of(figure).encode()).hexdigest()[:16]


def fault(figure: str) -> str:
    """Return what is wrong with a figure's still picture, or "" if nothing is."""
    file = file_of(figure).with_suffix(".svg")
    if not file.exists():
        return "is missing; make it with workbook regenerate"
    found = SUM.search(file.read_text("utf-8"))
    return "" if found and found[1] == sum_of(figure) else "is not what its figure draws"


def drifted(root: Path) -> list[str]:
    """Return in a line each what is wrong with a workbook's still pictures, and which are old.

    A notebook holds its figures whole.
    """
    faults = ((file_of(name).with_suffix(".svg"), fault(name)) for name in names_in(root))
    lines = [f"{file.relative_to(root)}: {line}" for file, line in faults if line]
    return lines + old_in_notebooks(root, IN_NOTEBOOK, {title_of(name) for name in names_in(root)})


def old_in_notebooks(root: Path, pattern: re.Pattern[str], titles: set[str]) -> list[str]:
    """Return in a line each which notebook holds what has none of the titles of today."""
    return [
        f"{notebook.relative_to(root)}: holds {title} as it was; workbook regenerate makes it anew"
        for notebook in sorted((root / "notebooks").glob("*.ipynb") if titles else ())
        for title in pattern.findall(notebook.read_text("utf-8"))
        if title not in titles
    ]


def write(figure: str) -> Path:
    """Let a figure draw itself, keep its picture, and return where that is.

    Raises
    ------
    NoBrowserError
        Playwright or Chromium is not installed.
    """
    file = file_of(figure).with_suffix(".svg")
    with chromium() as browser:
        picture = drawn(browser.new_page(), figure)
    file.write_text(picture, encoding="utf-8", newline="\n")
    return file


def drawn(page: Page, figure: str) -> str:
    """Return the picture that a figure draws when it is opened, as an SVG."""
    page.set_content(f"<!doctype html><body>{html_of(figure, figure, '')}</body>")
    page.wait_for_selector("figure[data-ready]")
    style, picture, view = page.evaluate(DRAWN)
    width, height = view.split()[2:]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" data-live="" data-sum="{sum_of(figure)}" '
        f'width="{width}" height="{height}" viewBox="{view}" style="color:#222;{colors()}">'
        f"<style>{style.strip()}</style>\n"
        f'<g font-family="sans-serif">{picture}</g></svg>\n'
    )

"""The workbook in Chromium: the browser, a JupyterLab of its own, and the pages.

Where Playwright, Chromium, JupyterLab or what builds the pages is missing, what needs it is
skipped, and says so.
"""

from __future__ import annotations

import fcntl
import math
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from lesson_code.course.notebooks.server import ServerError
from lesson_code.course.site.build import MissingToolsError, build
from lesson_code.view.browser.chromium import NoBrowserError, chromium
from lesson_code.view.browser.lab import lab_html

from .in_browser import JupyterLab, jupyterlab

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Page, Request

ROOT = Path(__file__).parents[2]
DESKTOP: Any = {"width": 1280, "height": 900}


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Yield Chromium."""
    try:
        with chromium() as started:
            yield started
    except NoBrowserError as error:
        pytest.skip(str(error))


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """Yield an empty page, as wide as a desktop's."""
    context = browser.new_context(viewport=DESKTOP, reduced_motion="reduce")
    yield context.new_page()
    context.close()


LEND = """
(lent) => Object.entries(lent).forEach(([name, [arguments_, results]]) => {
    const own = Math[name];
    const values = new Map(arguments_.map((x, k) => [x, results[k]]));
    Math[name] = (x) => (x !== 0 && values.has(x) ? values.get(x) : own(x));
})
"""
"""In the page: its functions give what Python's gave, where Python has asked; -0 stays its own."""


@pytest.fixture
def lend_functions(page: Page, monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Return what lends a page Python's sine, cosine and exponential of all that was asked before.

    They are the C library's, and a browser has its own: the last bit may differ, and then so does
    all that turns. What is compared is the rest, bit by bit.
    """
    noted: dict[str, dict[float, float]] = {"sin": {}, "cos": {}, "exp": {}}
    for name, values in noted.items():
        monkeypatch.setattr(math, name, _noting(getattr(math, name), values))
    return lambda: page.evaluate(
        LEND, {name: [list(values), list(values.values())] for name, values in noted.items()}
    )


def _noting(
    function: Callable[[float], float], values: dict[float, float]
) -> Callable[[float], float]:
    """Return a function that notes what it gives."""

    def noting(x: float) -> float:
        values[x] = function(x)
        return values[x]

    return noting


@pytest.fixture
def faults(page: Page) -> list[str]:
    """Return what goes wrong in the page: errors and warnings, missing files, use of a network."""
    found: list[str] = []

    def heard(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning"):
            found.append(message.text)

    def asked(request: Request) -> None:
        if not request.url.startswith(("file:", "data:", "blob:")):
            found.append(f"asked for {request.url}")

    page.on("pageerror", lambda error: found.append(str(error)))
    page.on("console", heard)
    page.on("requestfailed", lambda request: found.append(f"did not get {request.url}"))
    page.on("request", asked)
    return found


@pytest.fixture(scope="session")
def site(browser: Browser, tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """Return the pages of the workbook: of several workers, the first one builds them for all."""
    own = tmp_path_factory.mktemp("pages")
    folder = own.parents[0 if worker_id == "master" else 1] / "site"
    try:
        with folder.with_suffix(".lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not folder.exists():
                build(ROOT, own, lab=lab_html())
                own.rename(folder)
    except MissingToolsError as error:
        pytest.skip(str(error))
    return folder


@pytest.fixture(scope="session")
def lab(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[JupyterLab]:
    """Yield JupyterLab with a copy of the workbook, which may be changed."""
    root = tmp_path_factory.mktemp("workbook")
    for folder in ("notebooks", "exercises"):
        shutil.copytree(ROOT / folder, root / folder)
    try:
        with jupyterlab(root) as running:
            yield running
    except ServerError as error:
        pytest.skip(str(error))

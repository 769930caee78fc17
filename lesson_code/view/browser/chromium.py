"""Chromium without a window, driven by Playwright: for maintainers and for tests."""

from __future__ import annotations

import importlib.util
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from playwright.sync_api import Browser

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
"""What the browser may be called on this machine."""


class NoBrowserError(RuntimeError):
    """Playwright or Chromium is not installed; the message says what to do."""


def browser_path() -> str:
    """Return where Chromium is.

    Raises
    ------
    NoBrowserError
        It is not there, or Playwright is not installed.
    """
    if importlib.util.find_spec("playwright") is None:
        raise NoBrowserError("Playwright is not installed: pip install -e '.[browser]'")
    for name in NAMES:
        if found := shutil.which(name):
            return found
    raise NoBrowserError("Chromium is not installed: apt-get install chromium, for example")


@contextmanager
def chromium(*switches: str) -> Iterator[Browser]:
    """Start Chromium without a window, with these switches, and close it afterwards."""
    path = browser_path()
    from playwright.sync_api import sync_playwright

    as_root = hasattr(os, "geteuid") and os.geteuid() == 0
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path, args=[*switches, *(["--no-sandbox"] if as_root else [])]
        )
        try:
            yield browser
        finally:
            browser.close()

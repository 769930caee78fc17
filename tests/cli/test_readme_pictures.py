"""The pictures of the README: which there are, and that they stand where it shows them."""

from __future__ import annotations

import re
import struct
from pathlib import Path

import pytest

from lesson_code.cli import readme_pictures
from lesson_code.cli.readme_pictures import PICTURES, write_pictures
from lesson_code.course.site.in_browser import NoBrowserError

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "notebooks" / "pictures"
LARGEST = 400_000
"""Bytes of all pictures: a clone of the workbook should stay small."""


def test_readme_shows_the_pictures_that_are_taken() -> None:
    """Each picture has its place in the README, and no other stands in the folder."""
    shown = re.findall(r"notebooks/pictures/(\w+)\.png", (ROOT / "README.md").read_text("utf-8"))
    names = sorted(picture.name for picture in PICTURES)
    assert sorted(shown) == names == sorted(path.stem for path in FOLDER.glob("*"))


def test_pictures_are_small() -> None:
    """All of them together are a few hundred kB."""
    assert sum(path.stat().st_size for path in FOLDER.glob("*.png")) < LARGEST


def test_picture_without_that_name_is_refused_before_anything_starts(tmp_path: Path) -> None:
    """The error lists the names there are."""
    with pytest.raises(ValueError, match=r"picture must be one of notebook, .*, got 'sunset'"):
        next(write_pictures(tmp_path / "new", ["sunset"]))
    assert not (tmp_path / "new").exists()


def test_picture_of_a_program_needs_no_browser_of_its_own(tmp_path: Path) -> None:
    """Pool is drawn without a window, at the size of its own window."""
    [pool] = [picture for picture in PICTURES if picture.name == "pool"]
    pool.take(None, tmp_path / "b.png")
    width, height = struct.unpack(">II", (tmp_path / "b.png").read_bytes()[16:24])
    assert (width, height) >= (600, 400)


def test_missing_browser_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Whoever has no Chromium learns what to install."""
    monkeypatch.setattr("lesson_code.course.site.in_browser.NAMES", ("no-such-browser",))
    monkeypatch.setattr("importlib.util.find_spec", lambda _: True)
    with pytest.raises(NoBrowserError, match="Chromium is not installed"):
        next(readme_pictures.write_pictures(tmp_path, ["pool"]))

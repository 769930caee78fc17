"""A copy of Pyodide beside the pages: the right files, or an error that names what is wrong."""

from __future__ import annotations

import base64
import hashlib
from pathlib import Path

import pytest

from lesson_code.course.site import pyodide
from lesson_code.course.site.pyodide import FILES, NoPyodideError, copy_pyodide, sum_of


def test_sum_is_written_as_browsers_compare_it(tmp_path: Path) -> None:
    """SHA-384 of an empty file, from its definition."""
    (tmp_path / "empty").write_bytes(b"")
    digest = base64.b64encode(hashlib.new("sha384", b"").digest()).decode()
    assert sum_of(tmp_path / "empty") == f"sha384-{digest}"
    assert all(len(each) == len(f"sha384-{digest}") for each in FILES.values())


@pytest.mark.parametrize("inside", [".", "package"])
def test_files_are_copied_from_a_package_or_around_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, inside: str
) -> None:
    """As npm unpacks it, with the folder "package" or without."""
    source = tmp_path / "npm" / inside
    source.mkdir(parents=True)
    for name in FILES:
        (source / name).write_text(name, encoding="utf-8")
    monkeypatch.setattr(pyodide, "FILES", {name: sum_of(source / name) for name in FILES})
    copy_pyodide(tmp_path / "npm", tmp_path / "site")
    assert {path.name: path.read_text("utf-8") for path in (tmp_path / "site").iterdir()} == {
        name: name for name in FILES
    }


def test_missing_and_other_files_are_named(tmp_path: Path) -> None:
    """What lacks, then what is of another version."""
    with pytest.raises(NoPyodideError, match=r"a folder with pyodide\.mjs"):
        copy_pyodide(tmp_path, tmp_path / "site")
    for name in FILES:
        (tmp_path / name).write_text("other", encoding="utf-8")
    with pytest.raises(NoPyodideError, match=r"pyodide.mjs must be that of Pyodide .* differs"):
        copy_pyodide(tmp_path, tmp_path / "site")

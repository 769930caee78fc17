"""What the tests of the release share: one student's copy of this workbook."""

from __future__ import annotations

from pathlib import Path

import pytest

from lesson_code.course.fresh_copies import Files
from lesson_code.course.release.bundle import bundle_files


@pytest.fixture(scope="session")
def files(root: Path) -> Files:
    """Return the files of the student's copy; they are not changed."""
    return bundle_files(root)

"""Files as they are handed out, and which of a workbook's are so still."""

from __future__ import annotations

from pathlib import Path

from lesson_code.course.fresh_copies import start, unchanged_notebooks


def test_only_notebooks_that_nobody_has_changed_are_unchanged(tmp_path: Path) -> None:
    """One byte more, or a notebook that the course does not have, and it is somebody else's."""
    start(tmp_path / "mine")
    notebooks = sorted((tmp_path / "mine" / "notebooks").glob("*.ipynb"))
    assert unchanged_notebooks(tmp_path / "mine") == notebooks
    changed, gone, *others = notebooks
    changed.write_bytes(changed.read_bytes() + b"\n")
    (changed.parent / "99_of_a_friend.ipynb").write_bytes(gone.read_bytes())
    gone.unlink()
    assert unchanged_notebooks(tmp_path / "mine") == others

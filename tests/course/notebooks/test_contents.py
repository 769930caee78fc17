"""The README's table of notebooks: what the chapters say of themselves, or somebody is told."""

from __future__ import annotations

import shutil
from pathlib import Path

from lesson_code.course.notebooks import contents

ROOT = Path(__file__).parents[3]


def test_table_of_this_workbook_is_what_the_chapters_say() -> None:
    """Nothing is to be done."""
    assert contents.drifted(ROOT) == []
    assert contents.TABLE.search((ROOT / "README.md").read_text(encoding="utf-8"))


def test_row_that_was_changed_is_found_and_made_again(tmp_path: Path) -> None:
    """A row left out and a row reworded; what stands around the table stays."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    shutil.copytree(ROOT / "notebooks", tmp_path / "notebooks")
    first, second, *_ = contents.rows(ROOT).splitlines(keepends=True)
    changed = text.replace(first, "").replace(second, "| [01 Carts](carts) | | push |\n")
    (tmp_path / "README.md").write_text(changed, encoding="utf-8")
    assert contents.drifted(tmp_path) == [
        "README.md: its table of notebooks is not what the chapters say"
    ]
    assert contents.write(tmp_path) == [tmp_path / "README.md"]
    assert (tmp_path / "README.md").read_text(encoding="utf-8") == text


def test_folder_without_such_a_table_is_left_alone(tmp_path: Path) -> None:
    """A student's copy may have no README, or one of its own."""
    assert contents.write(tmp_path) == []
    (tmp_path / "README.md").write_text("mine\n", encoding="utf-8")
    assert contents.drifted(tmp_path) == contents.write(tmp_path) == []

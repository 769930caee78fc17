"""A chapter's notebook in parts: their order, their titles, and the sections in them."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from lesson_code.course.notebooks.parts import Part, parts


@pytest.fixture
def workbook(tmp_path: Path) -> Path:
    """Return a workbook in which chapter 07 comes in two parts."""
    (tmp_path / "notebooks").mkdir()
    for name, texts in {
        "07_zeno": ["# 07 Zeno\n\nWhy.", "## 1 One\n\nText.", "## 2 Two"],
        "07b_and_after": ["# 07b And after", "## 3 Three"],
        "08_price": ["# 08 Price", "## 1 One"],
    }.items():
        cells = [new_code_cell("## 9 no text"), *map(new_markdown_cell, texts)]
        nbformat.write(new_notebook(cells=cells), tmp_path / "notebooks" / f"{name}.ipynb")
    return tmp_path


def test_parts_of_a_chapter_are_in_the_order_of_reading(workbook: Path) -> None:
    """The first has no letter; the next chapter's notebook is none of them."""
    found = parts(workbook, "07")
    assert [(part.name, part.title) for part in found] == [
        ("07_zeno", "07 Zeno"),
        ("07b_and_after", "07b And after"),
    ]
    assert [[n for n in range(10) if part.has_section(n)] for part in found] == [[1, 2], [3]]
    assert parts(workbook, "11") == []


@pytest.mark.parametrize("text", ["no notebook", "[]", "{}", '{"cells": [1]}'])
def test_part_that_its_reader_has_spoilt_has_no_text(workbook: Path, text: str) -> None:
    """Nobody's help breaks because of it."""
    (workbook / "notebooks" / "07_zeno.ipynb").write_text(text, encoding="utf-8")
    assert parts(workbook, "07")[0] == Part("07_zeno", "")

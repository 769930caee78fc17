"""The README's table of notebooks, made of what each chapter says of itself."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from lesson_code.course.chapters import Chapter, chapters

NAME = "README.md"
TABLE = re.compile(r"(?<=\|---\|---\|---\|\n)(\| \[\d\d .*\n)+")
"""The rows below the table's head."""


def rows() -> str:
    """Return the table's rows: notebook, exercise, and what one can do afterwards."""
    return "".join(_row(chapter) for chapter in chapters() if chapter.number)


def _row(chapter: Chapter) -> str:
    file, aim = f"{chapter.name}.ipynb", chapter.summary.removesuffix(".")
    exercise = f" [exercise](exercises/{file})" if chapter.has("tasks.py") else ""
    title = f"[{chapter.number} {chapter.title}](notebooks/{file})"
    return f"| {title} |{exercise} | {aim[:1].lower()}{aim[1:]} |\n"


def names_in(root: Path) -> Iterator[str]:
    """Yield the file's name, if the folder has one with such a table."""
    if (root / NAME).is_file() and TABLE.search((root / NAME).read_text(encoding="utf-8")):
        yield NAME


def drifted(root: Path) -> list[str]:
    """Return in a line what is wrong with the table, if anything is."""
    fault = "its table of notebooks is not what the chapters say"
    return [f"{name}: {fault}" for name in names_in(root) if _as_it_should_be(root) is not None]


def write(root: Path) -> list[Path]:
    """Make the table anew where it is not as it should be; return what was written."""
    text = _as_it_should_be(root) if [*names_in(root)] else None
    if text is None:
        return []
    (root / NAME).write_text(text, encoding="utf-8", newline="\n")
    return [root / NAME]


def _as_it_should_be(root: Path) -> str | None:
    """Return what the file should hold; None if it holds that."""
    text = (root / NAME).read_text(encoding="utf-8")
    made = TABLE.sub(rows(), text)
    return None if made == text else made

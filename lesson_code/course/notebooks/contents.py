"""The README's table of notebooks, made of what each chapter says of itself."""

from __future__ import annotations

import re
from pathlib import Path

from lesson_code.course.chapters import Chapter, chapters
from lesson_code.course.notebooks.parts import parts

NAME = "README.md"
TABLE = re.compile(r"(?<=\|---\|---\|---\|\n)(\| \[\d\d .*\n)+")
"""The rows below the table's head."""


def rows(root: Path) -> str:
    """Return the table's rows: notebook, exercise, and what one can do afterwards."""
    return "".join(_row(chapter, root) for chapter in chapters() if chapter.number)


def _row(chapter: Chapter, root: Path) -> str:
    file, aim = f"{chapter.name}.ipynb", chapter.summary.removesuffix(".")
    exercise = f" [exercise](exercises/{file})" if chapter.has("tasks.py") else ""
    titles = {chapter.name: f"{chapter.number} {chapter.title}"}
    titles |= {part.name: part.title for part in parts(root, chapter.number)[1:]}
    links = ", ".join(f"[{title}](notebooks/{name}.ipynb)" for name, title in titles.items())
    return f"| {links} |{exercise} | {aim[:1].lower()}{aim[1:]} |\n"


def drifted(root: Path) -> list[str]:
    """Return in a line what is wrong with the table, if anything is."""
    fault = f"{NAME}: its table of notebooks is not what the chapters say"
    return [] if _made_anew(root) is None else [fault]


def write(root: Path) -> list[Path]:
    """Make the table anew where it is not as it should be; return what was written."""
    text = _made_anew(root)
    if text is None:
        return []
    (root / NAME).write_text(text, encoding="utf-8", newline="\n")
    return [root / NAME]


def _made_anew(root: Path) -> str | None:
    """Return what the file should hold; None if it holds that, or there is no such table."""
    if not (root / NAME).is_file():
        return None
    text = (root / NAME).read_text(encoding="utf-8")
    made = TABLE.sub(rows(root), text)
    return None if made == text else made

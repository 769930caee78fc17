"""Notebooks and exercises as they are handed out, before anybody has written in them.

An installed package keeps them in ``lesson_code/workbook``, and a student's copy its exercises. In
a checkout the notebooks stand beside ``lesson_code``, and an exercise is made from its solution.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import TypeAlias

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.notebooks.regenerate import fresh_student_copy
from lesson_code.course.notebooks.root import home

KEPT = Path("lesson_code", "workbook")
"""Where they are kept, from the folder that holds ``lesson_code``."""

KEPT_EXERCISES = KEPT / "exercises"

Files: TypeAlias = dict[str, bytes]
"""What stands in some files, by their paths with slashes."""

EARLIEST = (1980, 1, 1, 0, 0, 0)
"""The time of every file in a zip, so that the same files are the same bytes."""


def start(folder: Path) -> int:
    """Begin a workbook: write every notebook and every exercise into a folder.

    Parameters
    ----------
    folder : Path
        New or empty.

    Returns
    -------
    int
        How many files were written.

    Raises
    ------
    ValueError
        There is something in the folder; nothing is written.
    """
    files = dict(_notebooks()) | dict(_exercises())
    write_folder(files, folder)
    return len(files)


def fresh_exercise(exercise: Exercise, root: Path) -> str:
    """Return the text of an exercise as it is handed out.

    Raises
    ------
    FileNotFoundError
        Neither workbook nor package holds a fresh copy, and there is no solution to make one from.
    """
    for place in (root, home()):
        kept = place / KEPT_EXERCISES / exercise.file_name
        if kept.is_file():
            return kept.read_text(encoding="utf-8")
    return fresh_student_copy(root, exercise.name, exercise.task_ids)


def unchanged_notebooks(root: Path) -> list[Path]:
    """Return a workbook's notebooks that are as they were handed out, byte for byte."""
    files = ((root / name, content) for name, content in _notebooks())
    return [path for path, content in files if path.is_file() and path.read_bytes() == content]


def write_folder(files: Files, folder: Path) -> None:
    """Write files into a folder that is new or empty.

    Raises
    ------
    ValueError
        There is something in the folder.
    """
    if folder.exists() and not folder.is_dir():
        raise ValueError(f"folder must be new or empty, got {folder}, which is a file")
    if folder.is_dir() and (found := sorted(path.name for path in folder.iterdir())):
        raise ValueError(f"folder must be new or empty, got {folder}, which holds {found[0]}")
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def zipped(files: Files) -> bytes:
    """Return a zip of some files; what begins as a program may be run."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, inside in files.items():
            entry = zipfile.ZipInfo(name, EARLIEST)
            entry.create_system = 3  # Unix, also where this runs on Windows
            entry.external_attr = (0o100755 if inside.startswith(b"#!") else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, inside)
    return content.getvalue()


def _notebooks() -> Iterator[tuple[str, bytes]]:
    """Yield name and content of every notebook."""
    kept = home() / KEPT / "notebooks"
    folder = kept if kept.is_dir() else home() / "notebooks"
    for path in sorted(folder.glob("*.ipynb")):
        yield f"notebooks/{path.name}", path.read_bytes()


def _exercises() -> Iterator[tuple[str, bytes]]:
    """Yield name and content of every exercise."""
    for exercise in exercises():
        yield f"exercises/{exercise.file_name}", fresh_exercise(exercise, home()).encode()

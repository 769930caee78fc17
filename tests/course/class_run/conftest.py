"""What the tests of the class run share: classes made on the spot."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeAlias

import pytest

MakeClass: TypeAlias = Callable[[Mapping[str, str | bytes]], Path]

STUB = 'raise NotImplementedError("Task")'

RIGHT = """
def elastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * c - v1, 2 * c - v2


def inelastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return c, c


def elastic_impulse_1d(m1, v1, m2, v2):
    return 2 * m1 * m2 / (m1 + m2) * (v1 - v2)
"""
"""Full marks in exercise 01."""

SWAPS = "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n"
"""The best known mistake in task 1.1, and nothing else."""


@pytest.fixture
def make_class(tmp_path: Path) -> MakeClass:
    """Return a function that writes what a class handed in: contents by path."""

    def write(contents: Mapping[str, str | bytes]) -> Path:
        folder = tmp_path / "class"
        folder.mkdir(exist_ok=True)
        for name, content in contents.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content.encode() if isinstance(content, str) else content)
        return folder

    return write


def contents_of(folder: Path) -> dict[str, bytes]:
    """Return what stands in every file of a folder but the journal, whose order is that of work."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != "journal.jsonl"
    }

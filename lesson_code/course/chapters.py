"""The chapters of the course, found by being there: each is a folder in ``lesson_code/chapters``.

A numbered chapter (``ch03_reflection``) goes with a notebook of the same name; any other is a
program (``pool``). What a chapter does not hold, it does not have: without ``tasks.py`` there is
no exercise, without ``quiz.toml`` no quiz.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass
from functools import cache
from importlib import import_module, resources
from importlib.resources.abc import Traversable
from types import ModuleType

PACKAGE = "lesson_code.chapters"


@dataclass(frozen=True)
class Chapter:
    """A folder of the course.

    Attributes
    ----------
    folder : str
        Its name in ``lesson_code/chapters``.
    """

    folder: str

    @property
    def number(self) -> str:
        """Two digits, as in the notebook's name; empty for a program."""
        return self.folder[2:4] if _is_numbered(self.folder) else ""

    @property
    def name(self) -> str:
        """What its notebook, exercise or program is called: ``03_reflection`` or ``pool``."""
        return self.folder[2:] if self.number else self.folder

    @property
    def title(self) -> str:
        """What it is about, in a few words."""
        return self._docstring.partition("\n")[0].removesuffix(".")

    @property
    def summary(self) -> str:
        """What one can do after a notebook, or what a program shows, in a sentence."""
        return " ".join(self._docstring.partition("\n")[2].split())

    @property
    def _docstring(self) -> str:
        source = self.file("__init__.py").read_text(encoding="utf-8")
        return ast.get_docstring(ast.parse(source)) or ""

    def file(self, name: str) -> Traversable:
        """Return where a file of the chapter is, or would be."""
        return resources.files(PACKAGE).joinpath(self.folder, name)

    def has(self, name: str) -> bool:
        """Return whether the chapter holds a file."""
        return self.file(name).is_file()

    def module(self, name: str) -> ModuleType:
        """Return one of the chapter's modules, imported."""
        return import_module(f"{PACKAGE}.{self.folder}.{name}")

    def modules(self, start: str) -> tuple[ModuleType, ...]:
        """Return a module, and after it those by whose names they are further parts of it.

        ``wrong_answers`` may have a part ``wrong_answers_at_contacts``.
        """
        files = (file.name for file in resources.files(PACKAGE).joinpath(self.folder).iterdir())
        names = sorted(name.removesuffix(".py") for name in files if name.endswith(".py"))
        return tuple(self.module(name) for name in names if is_part(name, start))


@cache
def chapters() -> tuple[Chapter, ...]:
    """Return the numbered chapters in order, then the programs by name.

    >>> [chapter.name for chapter in chapters()][:2]
    ['00_start_here', '01_one_dimension']
    """
    found = [
        Chapter(folder.name)
        for folder in resources.files(PACKAGE).iterdir()
        if folder.joinpath("__init__.py").is_file()
    ]
    return tuple(sorted(found, key=lambda chapter: (not chapter.number, chapter.name)))


def chapters_with(file: str) -> tuple[Chapter, ...]:
    """Return the chapters that hold a file of this name.

    >>> chapters_with("quiz.toml")[0].name
    '00_start_here'
    """
    return tuple(chapter for chapter in chapters() if chapter.has(file))


def is_part(name: str, start: str) -> bool:
    """Return whether a module is another one, or a part of it: by its name.

    >>> is_part("wrong_answers", "wrong_answers"), is_part("wrong_answers_at_contacts", "tasks")
    (True, False)
    """
    return name == start or name.startswith(f"{start}_")


def _is_numbered(folder: str) -> bool:
    """Return whether a folder's name begins like that of a numbered chapter."""
    return folder.startswith("ch") and folder[2:4].isdecimal() and folder[4:5] == "_"

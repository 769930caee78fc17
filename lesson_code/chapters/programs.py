"""The programs: the chapters that hold a game. None is loaded before it is played."""

from __future__ import annotations

from typing import TYPE_CHECKING

from lesson_code.course.chapters import chapters_with

if TYPE_CHECKING:
    from lesson_code.view.pygame.program import Program


def program_summaries() -> dict[str, str]:
    """Return name and a sentence, of every program."""
    return {chapter.name: chapter.summary for chapter in chapters_with("game.py")}


def load(name: str) -> Program:
    """Return a program.

    Raises
    ------
    ValueError
        There is none of that name.
    """
    programs = {chapter.name: chapter for chapter in chapters_with("game.py")}
    if name not in programs:
        raise ValueError(f"program must be one of {', '.join(programs)}, got {name!r}")
    program: Program = programs[name].module("game").PROGRAM
    return program

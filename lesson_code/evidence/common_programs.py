"""The programs of large runs and of live worlds, which come ready-made.

`workbook open` has machine code made of all of them, and the menu of `workbook play` of those of
live worlds; `workbook regenerate` makes their files anew. Each module that makes runs says which
program suits any scene; here they have names.
"""

from __future__ import annotations

from pathlib import Path

from lesson_code.engine.any_scene import program_for_any_scene
from lesson_code.engine.compiled import Program, made_files, ready_made
from lesson_code.engine.compiled.compiler import Compiling
from lesson_code.engine.compiled.library import is_kept, why_no_compiler

LIVE = ("exact", "substep")
"""The programs of live worlds: discs that fly, and what is stepped."""


def common_programs() -> dict[str, Program]:
    """Return all of them by name."""
    return {
        "exact": program_for_any_scene("exact"),
        "substep": program_for_any_scene("substep"),
        "substep_with_sleep": program_for_any_scene("substep", sleeping=True),
        "sequential": program_for_any_scene("sequential"),
        "sequential_with_sleep": program_for_any_scene("sequential", sleeping=True),
    }


def programs_to_compile(*names: str) -> list[Program]:
    """Return those that are not kept: of these names, or of all; none where nothing can be made."""
    if why_no_compiler():
        return []
    programs = common_programs()
    chosen = [programs[name] for name in names or programs]
    return [program for program in chosen if not is_kept(program)]


def compile_in_background(programs: list[Program]) -> None:
    """Let another process compile programs, one after the other, and wait for it."""
    for program in programs:
        Compiling(program, in_background=True).wait()


# Their files


def names_in(root: Path) -> list[str]:
    """Return the names of those that belong to a workbook: all if it is this package's own."""
    return list(common_programs()) if ready_made.FOLDER.is_relative_to(root) else []


def fault(name: str) -> str:
    """Return what is wrong with a program's file, or "" if nothing is; it is not made for that."""
    return ready_made.fault(name, common_programs()[name])


def drifted(root: Path) -> list[str]:
    """Return in a line each what is wrong with the files of a workbook; a student's has none."""
    return made_files.drifted({ready_made.file_of(n): fault(n) for n in names_in(root)}, root)


def write(name: str) -> Path:
    """Make a program's file, and return where that is."""
    return ready_made.write(name, common_programs()[name])

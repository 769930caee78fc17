"""The library: machine code that is kept in a folder of the user, and found again there.

A program's file is named after all that its machine code depends on: the source, constants too,
the tables, how it is compiled, and the processor. So a change of any function or constant makes
another file, and the old one is never used again. The first line of a file says what made it,
with a sum over the rest: what is broken, cut off or from another version is made anew, never run.
Sources that are linked are kept in the same folder; see :mod:`lesson_code.engine.compiled.sources`.
"""

from __future__ import annotations

import atexit
import hashlib
import importlib.util
import json
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from lesson_code.engine.compiled.loader import Entry, MachineCode, ObjectFile
from lesson_code.engine.compiled.program import Program

PROGRAMS_KEPT = 64
"""Programs in the folder, and sources. The oldest are deleted, so that it does not grow."""

FOLDER_VARIABLE = "WORKBOOK_CACHE"
"""Environment variable that names another folder for compiled programs."""

COMPILER = ("inlining.py", "lane_types.py", "loader.py", "machine_code.py")
"""The files beside this one that say how a program is compiled and called."""


PAGE = 4096
"""Bytes, in which Linux describes a processor; each takes it time."""

PROCESSOR = ("vendor", "cpu family", "model", "stepping", "flags", "CPU", "Features")
"""How the lines of Linux begin that say what a processor can do."""

_loaded: dict[str, MachineCode] = {}
"""What this process has loaded, by its file's name: every run of a scene shares it."""


def why_no_compiler() -> str:
    """Return why nothing can be compiled here, in words; "" when it can."""
    return "" if _is_there("numba") else "Numba is not installed"


def folder() -> Path:
    """Return the folder that compiled programs are kept in."""
    if named := os.environ.get(FOLDER_VARIABLE):
        return Path(named)
    import platformdirs

    return platformdirs.user_cache_path("collision-workbook")


def is_kept(program: Program) -> bool:
    """Return whether a program's machine code only needs to be loaded."""
    return name_of(program) in _loaded or _kept(program) is not None


def load(program: Program) -> Entry | None:
    """Return a program that is kept, ready to be called; None: it has to be compiled first."""
    name = name_of(program)
    if name not in _loaded:
        kept = _kept(program)
        if kept is None:
            return None
        try:
            _loaded[name] = MachineCode(kept)
        except LookupError:  # it comes from another system
            return None
    return Entry(_loaded[name], program)


def forget_loaded() -> None:
    """Forget what this process has loaded."""
    _loaded.clear()


def keep(place: Path, program: Program, made: ObjectFile) -> None:
    """Write a program's machine code into a folder, whole or not at all."""
    about = {"made by": _makers(), "needs": made.needs, "is a library": made.is_library}
    write(place, name_of(program), about, made.code)


def write(place: Path, name: str, about: Mapping[str, Any], content: bytes) -> None:
    """Write a file into a folder, with a first line about it, whole or not at all.

    The oldest files whose names begin with the same word are deleted.
    """
    import tempfile  # which takes some milliseconds, and few runs write

    _forget_oldest(place, name.partition("_")[0])
    first = json.dumps({**about, "sum": _sum(content)}).encode()
    with tempfile.NamedTemporaryFile(dir=place, prefix=name, suffix=".tmp", delete=False) as file:
        file.write(first + b"\n" + content)
    Path(file.name).replace(place / name)


def read(name: str) -> Iterator[tuple[dict[str, Any], bytes]]:
    """Yield what is kept under a name, if it is whole: what its first line says, and the rest."""
    has_own = own_folder.cache_info().currsize
    for place in (folder(), own_folder()) if has_own else (folder(),):
        with suppress(OSError, ValueError, KeyError, TypeError):  # nothing like our first line
            first, _, content = (place / name).read_bytes().partition(b"\n")
            about = json.loads(first)
            if about["sum"] == _sum(content):
                yield about, content


def place_to_write() -> Path:
    """Return a folder for programs that can be written to: that of this process, if need be."""
    import tempfile

    place = folder()
    try:
        place.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=place):
            return place
    except OSError:  # the home folder is read-only
        return own_folder()


@cache
def own_folder() -> Path:
    """Return a folder that lasts as long as this process."""
    import shutil
    import tempfile

    place = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, place, ignore_errors=True)
    return Path(place)


@contextmanager
def claimed(place: Path, program: Program) -> Iterator[None]:
    """Wait until no other process compiles a program, and let none begin meanwhile.

    The system takes the claim back if this process is killed. Where it has no such locks, two may
    compile the same, and the later one replaces the file of the other.
    """
    try:
        import fcntl
    except ImportError:  # pragma: no cover - Windows
        yield
        return
    path = place / f"{name_of(program)}.lock"
    with path.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield
        path.unlink(missing_ok=True)


@cache
def name_of(program: Program) -> str:
    """Return the name of a program's file: what makes other machine code has another name."""
    told = sum_over(program), _processor()
    return "program_" + hashlib.sha256(repr(told).encode()).hexdigest()[:20]


@cache
def sum_over(program: Program) -> str:
    """Return a sum over all that the machine code depends on, but for the processor."""
    layout = [table.in_words() for table in program.layout]
    told = (program.source, program.entry, layout, _compiler())
    return hashlib.sha256(repr(told).encode()).hexdigest()


@cache
def _processor() -> str:
    """Return what this processor can do, in words: Linux's, else LLVM's, which take longer."""
    with suppress(OSError), Path("/proc/cpuinfo").open("rb", buffering=0) as file:
        first, _, _ = file.read(PAGE).decode(errors="replace").partition("\n\n")
        if lines := [line for line in first.splitlines() if line.startswith(PROCESSOR)]:
            return "\n".join(lines)
    if not _is_there("llvmlite"):
        return ""
    import llvmlite.binding as llvm

    return f"{llvm.get_host_cpu_name()} {llvm.get_host_cpu_features().flatten()}"


@cache
def _compiler() -> bytes:
    """Return the lines that say how a program is compiled."""
    return b"".join((Path(__file__).parent / name).read_bytes() for name in COMPILER)


def _makers() -> dict[str, str | None]:
    """Return the versions of all that makes machine code; None for what is not installed."""
    names = {"numba": _version("numba"), "llvmlite": _version("llvmlite")}
    return {"Python": sys.version.split()[0], "numpy": np.__version__, **names}


@cache
def _version(package: str) -> str | None:
    """Return the version of a package; None if it is not installed.

    It stands in the name of a folder beside the package. (To import what the standard library has
    for this takes longer than to load machine code.)
    """
    found = importlib.util.find_spec(package)
    if found is None or not found.origin:
        return None
    beside = Path(found.origin).parents[1]
    return " ".join(sorted(path.name for path in beside.glob(f"{package}-*.dist-info")))


def _is_there(package: str) -> bool:
    """Return whether a package can be imported."""
    return importlib.util.find_spec(package) is not None


def _kept(program: Program) -> ObjectFile | None:
    """Return the machine code of a program if it is kept, whole, and was made by what is here.

    Numba need not be there, nor LLVM for a shared library; but another version makes its own.
    """
    for about, code in read(name_of(program)):
        with suppress(KeyError, TypeError):  # it says something else
            makers = about["made by"]
            if all(makers[name] == here for name, here in _makers().items() if here is not None):
                file = ObjectFile(code, tuple(about["needs"]), about["is a library"])
                return file if file.is_library or _is_there("llvmlite") else None
    return None


def _sum(code: bytes) -> str:
    """Return a sum over machine code, in which any change shows."""
    return hashlib.sha256(code).hexdigest()


def _forget_oldest(place: Path, kind: str) -> None:
    """Delete the files of a kind that were made longest ago, and what a killed process has left."""
    programs = sorted(place.glob(f"{kind}_*"), key=_made_at)
    for path in programs[: max(len(programs) - PROGRAMS_KEPT + 1, 0)]:
        path.unlink(missing_ok=True)


def _made_at(path: Path) -> float:
    """Return when a file was made, s; long ago if another process has just deleted it."""
    with suppress(FileNotFoundError):
        return path.stat().st_mtime
    return 0.0

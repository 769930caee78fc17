"""Which of this machine's files Python and its libraries need, and which no child may have."""

from __future__ import annotations

import sys
import sysconfig
from collections.abc import Iterable
from functools import cache
from pathlib import Path

SYSTEM_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/nix/store")

FOLDER = Path(__file__).parent
"""Holds the package ``inside``, and nothing else that a server loads."""

PACKAGE = FOLDER.parents[1]
"""lesson_code, with its tasks and what they expect."""


@cache
def readable() -> tuple[str, ...]:
    """Return the folders that Python, its installed packages and their libraries lie in."""
    names = ("stdlib", "platstdlib", "purelib", "platlib")
    folders = [Path(sysconfig.get_path(name)) for name in names]
    folders += [Path(sys.base_prefix) / "lib", Path(sys.base_prefix) / "lib64"]
    folders += map(Path, SYSTEM_LIBRARIES)
    return _outermost(folder for folder in folders if folder.is_dir())


def hidden() -> tuple[str, ...]:
    """Return the folders that are never readable, wherever they lie."""
    return (str(PACKAGE),)


def to_start_python() -> tuple[str, ...]:
    """Return what a program has to see, beside all that, to start this Python."""
    executable = Path(sys.executable)
    paths = {executable, executable.resolve(), Path(sys.prefix) / "pyvenv.cfg"}
    paths |= {Path("/etc/ld.so.cache"), *(executable.parent / link for link in _links(executable))}
    return tuple(sorted(str(path) for path in paths if path.exists()))


def _links(path: Path) -> Iterable[Path]:
    """Yield one after another where a link leads."""
    while path.is_symlink():
        path = path.parent / path.readlink()
        yield path


def is_readable_by_others() -> bool:
    """Return whether a user of no group can reach all of that."""
    return all(
        folder.stat().st_mode & 0o005 == 0o005
        for path in map(Path, readable())
        for folder in (path, *path.parents)
        if folder == path or not folder.stat().st_mode & 0o001
    )


def _outermost(folders: Iterable[Path]) -> tuple[str, ...]:
    """Return folders without those that lie within another one."""
    kept: list[Path] = []
    for folder in sorted(set(folders), key=lambda path: len(path.parts)):
        if not any(folder.is_relative_to(outer) for outer in kept):
            kept.append(folder)
    return tuple(map(str, kept))

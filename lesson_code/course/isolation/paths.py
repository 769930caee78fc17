"""Which of this machine's files Python and its libraries need, and which no child may have."""

from __future__ import annotations

import importlib.util
import os
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

from lesson_code.course.isolation.inside.imports import PACKAGES, may_be_imported

SYSTEM_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/nix/store")

INSTALLED = ("site-packages", "dist-packages")
"""Folders of packages: in them a child finds those on the list of imports alone."""

FOLDER = Path(__file__).parent
"""Holds the package ``inside``, and nothing else that a server loads."""

PACKAGE = FOLDER.parents[1]
"""lesson_code, with its tasks and what they expect."""

WINGS = frozenset(path.name for path in PACKAGE.iterdir() if (path / "__init__.py").is_file())
"""The folders of lesson_code, by which a copy of it is known whatever its name."""

MOST_TRIED = 500
"""Installed packages that a child tries to find before its wall is called full."""

DISTRIBUTION = "collision_workbook"
"""How the name of an archive of the workbook begins, or of a folder that one was unpacked to."""


@cache
def readable() -> tuple[str, ...]:
    """Return the folders of Python, its libraries, and the packages that answers may import."""
    folders = [Path(sysconfig.get_path(name)) for name in ("stdlib", "platstdlib")]
    folders += _shared_libraries()
    return (*_outermost(folder for folder in folders if folder.is_dir()), *_packages())


def _shared_libraries() -> Iterator[Path]:
    """Yield the folders of shared libraries; where there are such, those of this machine's kind."""
    kind = sysconfig.get_config_var("MULTIARCH") or ""
    pythons = (f"{sys.base_prefix}/lib", f"{sys.base_prefix}/lib64")
    for folder in map(Path, (*SYSTEM_LIBRARIES, *pythons)):
        yield folder / kind if kind and (folder / kind).is_dir() else folder


@cache
def _packages() -> tuple[str, ...]:
    """Return the folders of the packages on the list, and of the libraries they come with."""
    found: list[Path] = []
    for name in PACKAGES:
        spec = importlib.util.find_spec(name)
        for place in (spec and spec.submodule_search_locations) or ():
            found += [Path(place), *Path(place).parent.glob(f"{name}*.libs")]
    return tuple(map(str, found))


@cache
def hidden() -> tuple[str, ...]:
    """Return what is never readable, wherever it lies: other packages, copies of the workbook."""
    found = {str(PACKAGE)}
    for folder in readable():
        found.update(_hidden_below(folder))
    return tuple(sorted(found))


def _hidden_below(folder: str) -> Iterator[str]:
    """Yield what is to be hidden in a folder, and look into nothing that is."""
    try:
        with os.scandir(folder) as entries:
            inside = [(e.path, e.name, e.is_dir(follow_symlinks=False)) for e in entries]
    except OSError:  # what this user cannot read, no child can
        return
    if {name for _, name, is_folder in inside if is_folder} >= WINGS:
        yield folder
        return
    for path, name, is_folder in inside:
        if (is_folder and name in (*INSTALLED, PACKAGE.name)) or name.startswith(DISTRIBUTION):
            yield path
        elif is_folder:
            yield from _hidden_below(path)


def copies() -> tuple[str, ...]:
    """Return the workbook itself, and every copy of it that is hidden."""
    return tuple(path for path in hidden() if Path(path).name not in INSTALLED)


@cache
def other_packages() -> tuple[str, ...]:
    """Return the names of some installed packages that answers may not import."""
    names = {
        entry.name
        for folder in hidden()
        if Path(folder).name in INSTALLED
        for entry in Path(folder).iterdir()
        if (entry / "__init__.py").is_file() and not may_be_imported(entry.name)
    }
    return tuple(sorted(names))[:MOST_TRIED]


def mounts() -> list[tuple[str, bool]]:
    """Return what is readable and what is hidden in it, outer folders first, and which is which.

    A package on the list is readable again within a folder of packages that is hidden.
    """
    paths = [(path, False) for path in readable()]
    paths += [(path, True) for path in hidden() if _within(path, readable())]
    return sorted(paths, key=lambda entry: (len(Path(entry[0]).parts), entry))


def _within(path: str, folders: Iterable[str]) -> bool:
    """Return whether a path lies in one of some folders."""
    return any(Path(path).is_relative_to(folder) for folder in folders)


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

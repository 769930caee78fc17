"""Compiling a program, and keeping its machine code.

A program is one module that holds all it needs, constants too. It is written into a folder of the
user, with lists of the inlined and merged functions, under a name made from its text, and Numba
stores the machine code beside it. So a change of any function or constant makes another program,
and the machine code of the old one is never used again. (Numba alone would look only at the file
of the called function, and would miss a change in another file or a constant.)

Compiled programs cannot allocate memory and do not count references: they work on the tables that
they are given.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
import tempfile
import types
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from lesson_code.engine.compiled.inlining import inlined, merged

PROGRAMS_KEPT = 64
"""Programs in the folder. The oldest are deleted, so that it does not grow."""

FOLDER_VARIABLE = "WORKBOOK_CACHE"
"""Environment variable that names another folder for compiled programs."""


def why_no_compiler() -> str:
    """Return why nothing can be compiled here, in words; "" when it can."""
    if importlib.util.find_spec("numba") is None:
        return "Numba is not installed"
    return ""


def folder() -> Path:
    """Return the folder that compiled programs are kept in."""
    import platformdirs

    named = os.environ.get(FOLDER_VARIABLE)
    return Path(named) if named else platformdirs.user_cache_path("collision-workbook")


def is_kept(source: str) -> bool:
    """Return whether a program has been compiled before and only needs to be loaded."""
    return any((folder() / "__pycache__").glob(f"{_name_of(_program_of(source))}.*.nbc"))


@cache
def compiled_function(source: str, entry: str) -> Callable[..., Any]:
    """Return the entry function of a program, compiled on its first call or loaded if it is kept.

    Parameters
    ----------
    source : str
        A module, from :func:`lesson_code.engine.compiled.linker.link`.
    entry : str
        The name of the function in it that is called.

    Raises
    ------
    ModuleNotFoundError
        Numba is not installed.
    """
    from numba import njit

    module, keeps = _load(source)
    functions = {n: f for n, f in vars(module).items() if isinstance(f, types.FunctionType)}
    options: dict[str, Any] = {"error_model": "numpy", "_nrt": False}
    inner = {**options, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    for name, function in functions.items():
        if name != entry:
            inner["forceinline"] = name in module.IN_PLACE
            inner["inline"] = "always" if name in module.MERGED else "never"
            setattr(module, name, njit(**inner)(function))
    start: Callable[..., Any] = njit(**options, cache=keeps)(functions[entry])
    return start


def _load(source: str) -> tuple[types.ModuleType, bool]:
    """Return a program as a module, and whether its machine code can be kept."""
    program = _program_of(source)
    name = _name_of(program)
    try:
        path = _written(folder(), name, program)
        keeps = os.access(path.parent, os.W_OK)  # else Numba cannot store the machine code
    except OSError:  # the home folder is read-only
        path, keeps = _written(Path(tempfile.mkdtemp()), name, program), False
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:  # pragma: no cover - the name ends in .py
        raise ImportError(f"{path} must be a module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module, keeps


def _name_of(program: str) -> str:
    """Return a name for a program: different texts have different names."""
    return "program_" + hashlib.sha256(program.encode()).hexdigest()[:20]


def _program_of(source: str) -> str:
    """Return all that machine code depends on: the source, and which functions are inlined."""
    in_place, merge = sorted(inlined(source)), sorted(merged(source))
    return f"{source}\n\nIN_PLACE = {in_place}\nMERGED = {merge}\n"


def _written(place: Path, name: str, source: str) -> Path:
    """Return the path of a program's file; several processes may write it at once."""
    path = place / f"{name}.py"
    if path.exists() and path.read_text() == source:
        return path
    place.mkdir(parents=True, exist_ok=True)
    _forget_oldest(place)
    with tempfile.NamedTemporaryFile("w", dir=place, suffix=".tmp", delete=False) as file:
        file.write(source)
    Path(file.name).replace(path)
    return path


def _forget_oldest(place: Path) -> None:
    """Delete the programs that were made longest ago."""
    programs = sorted(place.glob("program_*.py"), key=lambda path: path.stat().st_mtime)
    for path in programs[: max(len(programs) - PROGRAMS_KEPT + 1, 0)]:
        for kept in (path, *(place / "__pycache__").glob(f"{path.stem}.*")):
            kept.unlink(missing_ok=True)

"""The lesson's functions as WebAssembly: a page calls the very lines that the lesson shows.

Each module of this folder says what goes into one program, as ``PROGRAM``; the program lies beside
it, ``formulas.wasm`` beside ``formulas.py``, with a sum over the sources that it was made of. There
is no other list. ``workbook regenerate`` builds what has changed, for which it needs a linker
(``pip install -e '.[wasm]'``); nothing else does. ``program.js``, one folder up, loads and calls
them.
"""

from __future__ import annotations

import base64
import pkgutil
from importlib import import_module
from pathlib import Path

from lesson_code.engine.compiled import made_files
from lesson_code.engine.compiled.webassembly import WebProgram, built, told_by

FOLDER = Path(__file__).parent

LOADER = FOLDER.with_name("program.js")
"""What loads a program in a page."""


def names() -> list[str]:
    """Return the names of all programs.

    >>> "formulas" in names()
    True
    """
    return sorted(module.name for module in pkgutil.iter_modules([str(FOLDER)]))


def names_in(root: Path) -> list[str]:
    """Return the names of those that belong to a workbook: all if it is this package's own."""
    return names() if FOLDER.parents[3] == root else []


def program(name: str) -> WebProgram:
    """Return what goes into a program, as the sources are now."""
    made: WebProgram = import_module(f"{__name__}.{name}").PROGRAM
    return made


def file_of(name: str) -> Path:
    """Return where a program lies."""
    return FOLDER / f"{name}.wasm"


def script_with(name: str, lines: str) -> str:
    """Return an ES module in which lines of JavaScript can use a program.

    All of it is in the text, as a page needs it that is opened from a folder, and a widget that
    stays alive without a kernel: such a page may read no other file.

    Parameters
    ----------
    name : str
        The program.
    lines : str
        What uses it: ``open_program()`` there is the promise of a program of its own.

    Examples
    --------
    >>> lines = "const lesson = await open_program(); lesson.disc_inertia(4, 0.5);"
    >>> script_with("formulas", lines).splitlines()[-1] == lines
    True
    """
    return f"""{LOADER.read_text("utf-8")}
const open_program = () => {opened(name)};
{lines}"""


def opened(name: str) -> str:
    """Return an expression of such a module: the promise of a program, which is in its text."""
    code = base64.b64encode(file_of(name).read_bytes()).decode()
    return f'load(Uint8Array.from(atob("{code}"), (byte) => byte.charCodeAt(0)))'


def fault(name: str) -> str:
    """Return what is wrong with a program's file, or "" if nothing is; it is not built for that."""
    return made_files.fault(file_of(name), _sources_in, program(name).fingerprint)


def _sources_in(content: bytes) -> str:
    """Return the sum over its sources that a program tells."""
    told: str = told_by(content)["sources"]
    return told


def drifted(root: Path) -> list[str]:
    """Return in a line each what is wrong with the programs of a workbook; a student's has none."""
    return made_files.drifted({file_of(name): fault(name) for name in names_in(root)}, root)


def write(name: str) -> Path:
    """Build a program, write its file, and return where that is.

    Raises
    ------
    RuntimeError
        What builds it is not installed, or it cannot be compiled.
    """
    file_of(name).write_bytes(built(program(name)))
    return file_of(name)

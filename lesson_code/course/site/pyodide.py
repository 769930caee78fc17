"""Python for the pages: which files of Pyodide a page loads, from where, and their sums.

A page asks the public network for them only when somebody runs an answer. For a classroom without
one, :func:`copy_pyodide` puts a copy beside the pages; ``npm pack pyodide`` brings the files. In
both cases each file must have the sum that is written here.
"""

from __future__ import annotations

import base64
import hashlib
import shutil
from pathlib import Path

VERSION = "314.0.7"
PUBLIC = f"https://cdn.jsdelivr.net/npm/pyodide@{VERSION}/"

FILES = {
    "pyodide.mjs": "sha384-Lp79fMwxa4n2BLtugpUAoQMlbxIdg8iCUiP1r3h7nJLkQjwlXT1JzZTeHVL+f4Dg",
    "pyodide.asm.mjs": "sha384-/2281iaC0Iimw0B3Kagy1DBfZcJG3W4KYW+EmOqhsdY3fR9BJ88FE2Zt6y0KQKpa",
    "pyodide.asm.wasm": "sha384-y++qrQ72KPA1fTjLIuGMP+jppgGxjbLCgfdb0zMrnNnQVhxRUXTOTF6rTxNzllSu",
    "python_stdlib.zip": "sha384-xW3A5jmenkrPXbsgrIaB1FCJh9OuLT7FRMagsJMgtlhVc19k/mSy3+7nMaF/d767",
}
"""Each file's SHA-384, in the form that browsers compare."""

LOCK = {
    "abi_version": "2026_0",
    "arch": "wasm32",
    "platform": "emscripten_5_0_3",
    "python": "3.14.2",
}
"""What it says of itself in place of its own list of packages, of which no page loads one."""

MEGABYTES = 13
"""The files together, before a server packs them."""

BESIDE = "pyodide"
"""The folder of a copy, in that of the pages' scripts."""


class NoPyodideError(ValueError):
    """A folder does not hold this version of Pyodide; the message says what it lacks."""


def copy_pyodide(source: Path, target: Path) -> None:
    """Copy what pages need of Pyodide.

    Parameters
    ----------
    source : Path
        A folder that holds the npm package ``pyodide``.
    target : Path
        The folder that gets the files; it is made.

    Raises
    ------
    NoPyodideError
        A file is missing, or is of another version.
    """
    found = {path.name: path for path in (*source.glob("*"), *source.glob("package/*"))}
    target.mkdir(parents=True, exist_ok=True)
    for name, expected in FILES.items():
        if name not in found:
            raise NoPyodideError(f"pyodide must be a folder with {name}, got {source} without it")
        if sum_of(found[name]) != expected:
            raise NoPyodideError(
                f"{found[name]} must be that of Pyodide {VERSION}: its sum differs"
            )
        shutil.copyfile(found[name], target / name)


def sum_of(file: Path) -> str:
    """Return a file's SHA-384 as browsers write it."""
    return f"sha384-{base64.b64encode(hashlib.sha384(file.read_bytes()).digest()).decode()}"

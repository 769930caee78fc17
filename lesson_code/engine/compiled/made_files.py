"""Files that are made of programs and lie in the package: what is wrong with them, in words.

A file says in itself, by a sum, what it was made of. None is made to be compared with it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path


def fault(file: Path, sum_in: Callable[[bytes], str], current: str) -> str:
    """Return what is wrong with a file, or "" if nothing is.

    Parameters
    ----------
    file : Path
        It may be missing.
    sum_in : callable
        Returns the sum that the content of a file tells; or raises a ValueError, LookupError or
        TypeError.
    current : str
        The sum over the functions as they are now.
    """
    if not file.exists():
        return "is missing; make it with workbook regenerate"
    try:
        told = sum_in(file.read_bytes())
    except (ValueError, LookupError, TypeError) as error:
        return f"cannot be read ({error})"
    return "" if told == current else "differs from the functions it holds"


def drifted(faults: Mapping[Path, str], root: Path) -> list[str]:
    """Return in a line each what is wrong with some files, and which like them have no source."""
    kinds = {(file.parent, file.suffix) for file in faults}
    found = {file for folder, suffix in kinds for file in folder.glob(f"*{suffix}")}
    lines = dict.fromkeys(found - set(faults), "has no source") | dict(faults)
    return [f"{file.relative_to(root)}: {line}" for file, line in sorted(lines.items()) if line]

"""Reading code in a process of its own: the parent parses nothing that a student has written.

Python's parser may take minutes, or end its process, over a few kilobytes.
"""

from __future__ import annotations

from typing import Any

from lesson_code.course.isolation.clerk import Clerk, one_a_process
from lesson_code.course.isolation.inside.reading import SECONDS
from lesson_code.course.isolation.warm_server import environment, python

TOO_SLOW = "takes too much time or memory to read"

MOST_SLOW = 3
"""Cells that cannot be read in time, after which the rest of a file is not tried."""


@one_a_process
def reader() -> Clerk:
    """Return this process's reader."""
    return Clerk(python("reading"), environment(), SECONDS)


def read_file(path: str) -> dict[str, Any]:
    """Return the ``units`` in a file, and the ``exercise`` that a notebook says it is.

    Of what is no notebook or program, or takes too much to read, why (``problem``): 50 MB, in any
    encoding and any form of JSON.
    """
    found: dict[str, Any] | None = reader().ask("file", path)
    if found is None:  # once more, so that one slow cell costs its own answers alone
        found = reader().ask("sources", path) or {"problem": TOO_SLOW}
        if "problem" not in found:
            found["units"] = read_units(found.pop("sources"))
    return found


def read_units(sources: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return sources as units; those that cannot be read in time say so, and the others are read.

    The arguments and what is returned are those of :func:`inside.reading.read`.
    """
    units: list[dict[str, Any]] | None = reader().ask("read", sources)
    if units is not None:
        return units
    slow: dict[int, dict[str, Any]] = {}
    for place, source in enumerate(sources):
        is_alone = len(sources) == 1
        if is_alone or len(slow) == MOST_SLOW or reader().ask("read", [source]) is None:
            text = f"{source['name']}: {TOO_SLOW}"
            lost = reader().ask("lost", source["source"]) or []
            slow[place] = {"unreadable": text, "lost": lost}
    rest = [source for place, source in enumerate(sources) if place not in slow]
    others = iter(reader().ask("read", rest) or [])
    return [slow[place] if place in slow else next(others) for place in range(len(sources))]

"""Which files have been saved: found by looking, a few times a second.

No file events are used: they do not come from network drives, containers and shared folders. To
look at twenty files costs some microseconds.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

Sign: TypeAlias = tuple[int, int] | None
"""When a file was changed, in ns, and its size; None where there is no file."""


class Files:
    """Some files, and what they looked like when they were last seen.

    Examples
    --------
    >>> Files([Path("nowhere.py")]).saved()
    []
    """

    def __init__(self, paths: Iterable[Path]) -> None:
        self._settled = {path: _sign(path) for path in paths}
        self._seen = dict(self._settled)

    def saved(self) -> list[Path]:
        """Return the files that have changed since the last call and are no longer changing.

        A file that is being written looks different at each call, and one that an editor replaces
        is not there for a moment. Both are waited for.
        """
        done = []
        for path, before in self._seen.items():
            now = _sign(path)
            if now == before and now is not None and now != self._settled[path]:
                self._settled[path] = now
                done.append(path)
            self._seen[path] = now
        return done


def _sign(path: Path) -> Sign:
    """Return what a file looks like from outside."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size

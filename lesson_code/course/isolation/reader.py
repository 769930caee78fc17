"""Reading code in a process of its own: the parent parses nothing that a student has written.

Python's parser may take minutes, or end its process, over a few kilobytes. The reader runs none of
the code, so that one serves for many submissions.
"""

from __future__ import annotations

import atexit
import contextlib
import json
import os
import subprocess
import threading
from typing import Any

from lesson_code.course.isolation.channel import PipeChannel
from lesson_code.course.isolation.inside.reading import SECONDS
from lesson_code.course.isolation.limits import PATIENCE
from lesson_code.course.isolation.warm_server import environment, python

LARGEST_REPLY = 200_000_000
"""Bytes; a reply holds the code that it was asked about."""

MOST_SLOW = 3
"""Cells that cannot be read in time, after which the rest of a file is not tried."""


class Reader:
    """A process that reads code; it is started when first asked, and again after it has ended."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: PipeChannel | None = None
        self._one_at_a_time = threading.Lock()

    def ask(self, deed: str, given: Any) -> Any:
        """Return what the reader makes of some code; None if it needs too much time or memory."""
        with self._one_at_a_time:
            if self._channel is None:
                self._channel = self._started()
            line = json.dumps([deed, given]).encode() + b"\n"
            reply = self._channel.ask(line, PATIENCE * SECONDS)
            if not reply:
                self.close()
            return json.loads(reply) if reply else None

    def _started(self) -> PipeChannel:
        """Return the way to a new process."""
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter, our own module
            python("reading"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=environment(),
            start_new_session=True,
        )
        assert self._process.stdin is not None  # noqa: S101 - asked for as pipes
        assert self._process.stdout is not None  # noqa: S101
        return PipeChannel(self._process.stdin, self._process.stdout, LARGEST_REPLY)

    def close(self) -> None:
        """End the process."""
        if self._process is not None and self._channel is not None:
            with contextlib.suppress(OSError):
                self._process.kill()
            self._process.wait()
            self._channel.close()
        self._process = self._channel = None


_readers: dict[int, Reader] = {}
"""The reader of each process: one that is forked does not use its parent's."""


def reader() -> Reader:
    """Return this process's reader."""
    if os.getpid() not in _readers:
        _readers.clear()
        _readers[os.getpid()] = Reader()
        atexit.register(_readers[os.getpid()].close)
    return _readers[os.getpid()]


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
            text = f"{source['name']}: takes too much time or memory to read"
            lost = reader().ask("lost", source["source"]) or []
            slow[place] = {"unreadable": text, "lost": lost}
    rest = [source for place, source in enumerate(sources) if place not in slow]
    others = iter(reader().ask("read", rest) or [])
    return [slow[place] if place in slow else next(others) for place in range(len(sources))]

"""A line to a child and a line back: in time, of a bounded length, and never believed."""

from __future__ import annotations

import contextlib
import socket
import threading
import time
from queue import Empty, Queue
from typing import IO, Protocol

CHUNK = 65_536
"""Bytes that are read at once."""


class Channel(Protocol):
    """The way to a child and back."""

    def ask(self, line: bytes, seconds: float) -> bytes | None:
        """Return the next line after this one; b"" if there will be none, None if it is late.

        An empty line says nothing to the child: it waits on for what was asked before.
        """

    def close(self) -> None:
        """Close our end."""


class SocketChannel:
    """A channel over one end of a pair of sockets.

    What a child sends beyond a line is kept, up to `most` bytes in all, and comes first when the
    next line is asked for.
    """

    def __init__(self, end: socket.socket, most: int) -> None:
        self._end = end
        self._most = most
        self._kept = bytearray()
        self._unsent = b""

    def ask(self, line: bytes, seconds: float) -> bytes | None:
        """Return the next line after this one; b"" if there will be none, None if it is late."""
        deadline = time.monotonic() + seconds
        self._unsent += line
        try:
            while self._unsent:
                self._end.settimeout(max(deadline - time.monotonic(), 1e-6))
                self._unsent = self._unsent[self._end.send(self._unsent) :]
        except TimeoutError:
            return None
        except OSError:  # a child that is gone is found out by its silence
            self._unsent = b""
        return self._line(deadline)

    def _line(self, deadline: float) -> bytes | None:
        """Return the next line, or the beginning of one that is too long."""
        searched = 0
        while (end := self._kept.find(b"\n", searched) + 1) == 0:
            searched = len(self._kept)
            if searched > self._most:
                return bytes(self._kept)
            self._end.settimeout(max(deadline - time.monotonic(), 1e-6))
            try:
                piece = self._end.recv(CHUNK)
            except TimeoutError:
                return None
            except OSError:
                piece = b""
            if not piece:
                return b""
            self._kept += piece
        line = bytes(self._kept[: min(end, self._most)])
        del self._kept[:end]
        return line

    def close(self) -> None:
        """Close our end."""
        self._end.close()


class PipeChannel:
    """A channel over two pipes, on systems whose sockets cannot be handed on.

    One line is read for each that is asked for, so that the rest of what a child may write stays
    on its own side of the pipe.
    """

    def __init__(self, requests: IO[bytes], answers: IO[bytes], most: int) -> None:
        self._requests = requests
        self._answers = answers
        self._most = most
        self._lines: Queue[bytes] = Queue()
        self._reader: threading.Thread | None = None

    def ask(self, line: bytes, seconds: float) -> bytes | None:
        """Return the next line after this one; b"" if there will be none, None if it is late."""
        if line:
            self._reader = threading.Thread(target=self._exchange, args=(line,), daemon=True)
            self._reader.start()
        try:
            return self._lines.get(timeout=seconds)
        except Empty:
            return None

    def _exchange(self, line: bytes) -> None:
        """Write one line to the child and read one, of at most `most` bytes."""
        with contextlib.suppress(OSError, ValueError):
            self._requests.write(line)
            self._requests.flush()
        try:
            self._lines.put(self._answers.readline(self._most))
        except (OSError, ValueError):
            self._lines.put(b"")

    def close(self) -> None:
        """Close our ends, once the child has ended.

        A process that has left the child's group may outlive it and keep its pipe open. A reader
        that waits for its next line would wait on, and closing would wait as well.
        """
        if self._reader is not None:
            self._reader.join(timeout=1.0)
            if self._reader.is_alive():
                return
        with contextlib.suppress(OSError):
            self._requests.close()
        self._answers.close()

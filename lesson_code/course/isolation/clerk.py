"""A process of the course's own that does for the parent what may take any time or memory.

It runs no code of a student's, so that one serves for many submissions.
"""

from __future__ import annotations

import atexit
import contextlib
import json
import os
import socket
import subprocess
import threading
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from lesson_code.course.isolation.channel import Channel, PipeChannel, SocketChannel
from lesson_code.course.isolation.limits import PATIENCE

LARGEST_REPLY = 200_000_000
"""Bytes; a reply may hold the code that it was asked about."""


class Clerk:
    """A process that answers requests; it is started when first asked, and again after it ended.

    Parameters
    ----------
    command : sequence of str
        Starts it. It reads JSON, a line each, and answers each with a line.
    environment : mapping of str to str
        Its whole environment.
    seconds : float
        Of the processor, which it allows itself for one request.
    """

    def __init__(
        self, command: Sequence[str], environment: Mapping[str, str], seconds: float
    ) -> None:
        self._command = list(command)
        self._environment = dict(environment)
        self._seconds = seconds
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: Channel | None = None
        self._one_at_a_time = threading.Lock()

    def ask(self, *request: Any) -> Any:
        """Return the answer to a request; None if it needs too much time or memory."""
        with self._one_at_a_time:
            if self._channel is None:
                self._channel = self._started()
            line = json.dumps(request).encode() + b"\n"
            reply = self._channel.ask(line, PATIENCE * self._seconds)
            if not reply:
                self.close()
            return json.loads(reply) if reply else None

    def _started(self) -> Channel:
        """Return the way to a new process: a socket, which needs no thread of its own, or pipes."""
        if os.name != "posix":
            process = self._run(subprocess.PIPE, subprocess.PIPE)
            assert process.stdin is not None  # noqa: S101 - asked for as pipes
            assert process.stdout is not None  # noqa: S101
            return PipeChannel(process.stdin, process.stdout, LARGEST_REPLY)
        ours, theirs = socket.socketpair()
        with theirs:
            self._run(theirs.fileno(), theirs.fileno())
        return SocketChannel(ours, LARGEST_REPLY)

    def _run(self, requests: int, replies: int) -> subprocess.Popen[bytes]:
        """Start the process, and return it."""
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter, our own module
            self._command,
            stdin=requests,
            stdout=replies,
            stderr=subprocess.DEVNULL,
            env=self._environment,
            start_new_session=True,
        )
        return self._process

    def close(self) -> None:
        """End the process."""
        if self._process is not None and self._channel is not None:
            with contextlib.suppress(OSError):
                self._process.kill()
            self._process.wait()
            self._channel.close()
        self._process = self._channel = None


def one_a_process(make: Callable[[], Clerk]) -> Callable[[], Clerk]:
    """Return a function that returns this process's clerk: a fork does not use its parent's."""
    made: dict[int, Clerk] = {}

    def clerk() -> Clerk:
        if os.getpid() not in made:
            made.clear()
            made[os.getpid()] = make()
            atexit.register(made[os.getpid()].close)
        return made[os.getpid()]

    return clerk

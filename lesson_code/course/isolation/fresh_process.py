"""A Python of its own for each submission, where no warm one can be forked."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import tempfile

from lesson_code.course.isolation import paths
from lesson_code.course.isolation.channel import Channel, PipeChannel
from lesson_code.course.isolation.inside.system import processor_time
from lesson_code.course.isolation.limits import Limits
from lesson_code.course.isolation.warm_server import environment, python


class FreshProcess:
    """Starts a Python a submission, with what limits the system knows."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: PipeChannel | None = None
        self._folder = ""
        self._is_new = False

    def open(self) -> None:
        """Do nothing: each submission starts from nothing."""

    def prepare(self) -> None:
        """Start a child in a new folder; the one before it is ended."""
        self.end()
        limits = self._limits
        self._folder = tempfile.mkdtemp(prefix="grading-")
        numbers = (str(limits.seconds_a_child), str(limits.bytes_of_memory))
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter, our own module
            python("alone", *numbers, *paths.readable()),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            cwd=self._folder,
            env=environment() | {"HOME": self._folder},
            start_new_session=True,
        )
        assert self._process.stdin is not None  # noqa: S101 - asked for as pipes
        assert self._process.stdout is not None  # noqa: S101
        most = limits.bytes_an_answer
        self._channel = PipeChannel(self._process.stdin, self._process.stdout, most)
        self._is_new = True

    def start(self) -> Channel:
        """Return the way to a child that nothing has been asked yet."""
        if not self._is_new:
            self.prepare()
        assert self._channel is not None  # noqa: S101 - prepare has made it
        self._is_new = False
        return self._channel

    def end(self) -> None:
        """End the current child and its group, and remove its folder."""
        if self._process is None or self._channel is None:
            return
        with contextlib.suppress(OSError):
            if os.name == "posix":
                os.killpg(self._process.pid, signal.SIGKILL)
            else:
                self._process.kill()
        self._process.wait()
        self._channel.close()
        with contextlib.suppress(RecursionError):  # from folders nested by the thousand
            shutil.rmtree(self._folder, ignore_errors=True)
        self._process = self._channel = None
        self._is_new = False

    def spent(self) -> float | None:
        """Return the processor time of the current child, s; None where the system has no clock."""
        return None if self._process is None else processor_time(self._process.pid)

    def close(self) -> None:
        """End the current child."""
        self.end()

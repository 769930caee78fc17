"""The parent's side of the wall: asks a child process, believes nothing but plain values.

Student code runs in a process of its own, with limits on time, memory, file size and open
files, an empty environment and an empty working folder. What is expected never crosses to it.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass
from itertools import count
from types import TracebackType
from typing import Any

from lesson_code.grading import child
from lesson_code.grading.outcome import Outcome, one_line, outcome_of
from lesson_code.grading.submission import Unit
from lesson_code.grading.task import Arguments


@dataclass(frozen=True)
class Limits:
    """What a submission may use; each bound is far above what any task needs."""

    seconds_to_load: float = 10.0
    seconds_a_call: float = 3.0
    cpu_seconds: int = 20
    bytes_of_memory: int = 1_500_000_000
    bytes_an_answer: int = 2_000_000


def isolation_in_force() -> str:
    """Return in a line what stands between student code and this machine.

    The child shares files and network with the parent: grade what strangers hand in on a
    machine that holds nothing of value.
    """
    if os.name != "posix":
        return "process (own process, wall clock limit; no other limits on this system)"
    return "limits (own process; time, memory, file size and open files limited)"


class StudentProcess:
    """A child process that holds one submission and answers calls to its functions.

    After a call that hangs or kills the child, the next call gets a new child.
    """

    def __init__(self, units: tuple[Unit, ...], limits: Limits | None = None) -> None:
        self._units = units
        self._limits = limits or Limits()
        self._process: subprocess.Popen[bytes] | None = None
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._reader: threading.Thread | None = None
        self._numbers = count(1)
        self._load_failed: Outcome | None = None
        self.load_errors: list[str] = []

    def __enter__(self) -> StudentProcess:
        self._start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._kill()

    def call(self, function: str, arguments: Arguments) -> Outcome:
        """Return what came of calling a function of the submission."""
        if self._process is None and self._load_failed is None:
            self._start()
        if self._load_failed is not None:
            return self._load_failed
        request = {"call": function, "arguments": arguments}
        reply = self._ask(request, self._limits.seconds_a_call)
        return reply if isinstance(reply, Outcome) else outcome_of(reply)

    def _start(self) -> None:
        """Start a child in a new folder and load the submission into it."""
        self._folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter, our own script
            [
                sys.executable,
                "-I",
                child.__file__,
                str(self._limits.cpu_seconds),
                str(self._limits.bytes_of_memory),
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            cwd=self._folder.name,
            env=_environment(self._folder.name),
            start_new_session=True,
        )
        reply = self._ask(
            {"load": [unit.as_request() for unit in self._units]}, self._limits.seconds_to_load
        )
        if isinstance(reply, Outcome):
            self._load_failed = Outcome(reply.kind, text=f"{reply.text}, while it was loaded")
        else:
            errors = reply.get("loaded")
            lines = errors if isinstance(errors, list) else []
            self.load_errors = [one_line(line) for line in lines if isinstance(line, str)]

    def _ask(self, request: dict[str, Any], seconds: float) -> dict[str, Any] | Outcome:
        """Return the child's reply, or what kept it from replying."""
        assert self._process is not None  # noqa: S101 - _start has made it
        assert self._process.stdin is not None  # noqa: S101 - asked for as a pipe
        number = next(self._numbers)
        with contextlib.suppress(OSError):  # a child that is gone is found out by its silence
            self._process.stdin.write(json.dumps(request | {"number": number}).encode() + b"\n")
            self._process.stdin.flush()
        line = self._line(seconds)
        if line is None:
            self._kill()
            return Outcome("timeout", text=f"it did not finish within {seconds:g} s")
        reply = _object_in(line)
        if reply is not None and reply.get("number") == number:
            return reply
        self._kill()
        if reply is not None:
            return Outcome("crashed", text="it wrote where only the grader's own lines may stand")
        return Outcome("crashed", text="it ended the process, or used more than it may")

    def _line(self, seconds: float) -> bytes | None:
        """Return the child's next line, b"" if there will be none, or None if it is late.

        One line is read for each that is asked for, so that the rest of what a child may write
        stays on its own side of the pipe.
        """
        assert self._process is not None  # noqa: S101 - _start has made it
        pipe, most = self._process.stdout, self._limits.bytes_an_answer
        lines: queue.Queue[bytes] = queue.Queue()
        self._reader = threading.Thread(target=_read_line, args=(pipe, most, lines), daemon=True)
        self._reader.start()
        try:
            return lines.get(timeout=seconds)
        except queue.Empty:
            return None

    def _kill(self) -> None:
        """End the child and everything it has started, and remove its folder."""
        if self._process is None or self._folder is None:
            return
        with contextlib.suppress(OSError):
            if os.name == "posix":
                os.killpg(self._process.pid, signal.SIGKILL)
            else:
                self._process.kill()
        self._process.wait()
        self._close_pipes(self._process)
        with contextlib.suppress(RecursionError):  # from folders nested by the thousand
            self._folder.cleanup()
        self._process = self._folder = None

    def _close_pipes(self, process: subprocess.Popen[bytes]) -> None:
        """Close the pipes to a child that has ended.

        A process that has left the child's group may outlive it and keep its pipe open. Who
        waits for a line of it then goes on waiting, and closing would wait as well.
        """
        with contextlib.suppress(OSError):
            if process.stdin is not None:
                process.stdin.close()
        if self._reader is not None:
            self._reader.join(timeout=1.0)
        if process.stdout is not None and not (self._reader and self._reader.is_alive()):
            process.stdout.close()


def _environment(folder: str) -> dict[str, str]:
    """Return the whole environment of a child: nothing of the parent's but what it must have."""
    needed = {name: os.environ[name] for name in ("SYSTEMROOT",) if name in os.environ}
    return needed | {
        "HOME": folder,
        "MPLBACKEND": "agg",
        "OPENBLAS_NUM_THREADS": "1",
        "PYGAME_HIDE_SUPPORT_PROMPT": "1",
        "SDL_AUDIODRIVER": "dummy",
        "SDL_VIDEODRIVER": "dummy",
    }


def _read_line(pipe: Any, most: int, lines: queue.Queue[bytes]) -> None:
    """Read one line from a child, at most so many bytes; an empty one is the end."""
    try:
        lines.put(pipe.readline(most))
    except (OSError, ValueError):
        lines.put(b"")


def _object_in(line: bytes) -> dict[str, Any] | None:
    """Return the JSON object in a line, which may hold anything, or None."""
    try:
        value = json.loads(line)
    except (ValueError, RecursionError, MemoryError):
        return None
    return value if isinstance(value, dict) else None

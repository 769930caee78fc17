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
from collections.abc import Iterator
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Literal, TypeAlias

from lesson_code.grading import child
from lesson_code.grading.submission import Unit
from lesson_code.grading.task import Arguments

Kind: TypeAlias = Literal["returned", "raised", "missing", "not written", "timeout", "crashed"]
KINDS_FROM_CHILD = ("returned", "raised", "missing", "not written")


@dataclass(frozen=True)
class Outcome:
    """What came of a call: a plain value, or the reason why there is none."""

    kind: Kind
    value: Any = None
    text: str = ""


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

    def __init__(self, units: tuple[Unit, ...], limits: Limits = Limits()) -> None:
        self._units = units
        self._limits = limits
        self._process: subprocess.Popen[bytes] | None = None
        self._answers: queue.Queue[bytes] = queue.Queue()
        self._load_failed: Outcome | None = None
        self._folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
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
        self._folder.cleanup()

    def call(self, function: str, arguments: Arguments) -> Outcome:
        """Return what came of calling a function of the submission."""
        if self._process is None and self._load_failed is None:
            self._start()
        if self._load_failed is not None:
            return self._load_failed
        request = {"call": function, "arguments": arguments}
        reply = self._ask(request, self._limits.seconds_a_call)
        if isinstance(reply, Outcome):
            return reply
        if reply.get("kind") not in KINDS_FROM_CHILD:
            return Outcome("crashed", text="the answer could not be read")
        return Outcome(reply["kind"], reply.get("value"), str(reply.get("text", ""))[:500])

    def _start(self) -> None:
        """Start a child and load the submission into it."""
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
        self._answers = queue.Queue()
        threading.Thread(
            target=_read_answers,
            args=(self._process.stdout, self._answers, self._limits.bytes_an_answer),
            daemon=True,
        ).start()
        reply = self._ask(
            {"load": [unit.as_request() for unit in self._units]}, self._limits.seconds_to_load
        )
        if isinstance(reply, Outcome):
            self._load_failed = Outcome(reply.kind, text=f"{reply.text}, while it was loaded")
        else:
            self.load_errors = [str(error) for error in reply.get("loaded", []) if error]

    def _ask(self, request: dict[str, Any], seconds: float) -> dict[str, Any] | Outcome:
        """Return the child's reply, or what kept it from replying."""
        assert self._process is not None  # noqa: S101 - _start has made it
        assert self._process.stdin is not None  # noqa: S101 - asked for as a pipe
        with contextlib.suppress(OSError):  # a child that is gone is found out by its silence
            self._process.stdin.write(json.dumps(request).encode() + b"\n")
            self._process.stdin.flush()
        try:
            line = self._answers.get(timeout=seconds)
        except queue.Empty:
            self._kill()
            return Outcome("timeout", text=f"it did not finish within {seconds:g} s")
        try:
            reply = json.loads(line)
        except ValueError:
            reply = None
        if isinstance(reply, dict):
            return reply
        self._kill()
        return Outcome("crashed", text="it ended the process, or used more than it may")

    def _kill(self) -> None:
        """End the child and everything it has started."""
        if self._process is None:
            return
        with contextlib.suppress(OSError):
            if os.name == "posix":
                os.killpg(self._process.pid, signal.SIGKILL)
            else:
                self._process.kill()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            with contextlib.suppress(OSError):
                if pipe is not None:
                    pipe.close()
        self._process = None


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


def _read_answers(pipe: Any, answers: queue.Queue[bytes], most: int) -> None:
    """Pass on each line from the child; an empty one says that no more will come."""
    with contextlib.suppress(OSError, ValueError):
        while line := pipe.readline(most):
            answers.put(line)
    answers.put(b"")


def call_here(
    functions: dict[str, Any], function: str, arguments: Arguments, seconds: float = 3.0
) -> Outcome:
    """Call a function in this process, as a notebook does with its reader's own code."""
    try:
        with time_limit(seconds):
            reply = child.call(function, list(arguments), functions)
    except TimeLimitError:
        return Outcome("timeout", text=f"it did not finish within {seconds:g} s")
    return Outcome(reply["kind"], reply.get("value"), reply.get("text", ""))


class TimeLimitError(BaseException):
    """Raised inside a call that has taken too long; not an Exception, which it might catch."""


@contextlib.contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise TimeLimitError in the code below, once it has run for so long.

    Only the main thread of a process on a system with timers can be interrupted so; elsewhere
    there is no limit.
    """
    if (
        not hasattr(signal, "setitimer")
        or threading.current_thread() is not threading.main_thread()
    ):
        yield
        return

    def stop(*_: Any) -> None:
        raise TimeLimitError

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)

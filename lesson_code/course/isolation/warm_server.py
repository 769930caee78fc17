"""The parent's handle of a warm server: starts it, has children forked, ends it."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path
from typing import IO, Any

from lesson_code.course.isolation import paths
from lesson_code.course.isolation.channel import Channel, SocketChannel
from lesson_code.course.isolation.in_force import IsolationError
from lesson_code.course.isolation.inside.limits import BYTES_A_FILE
from lesson_code.course.isolation.inside.wall import Orders
from lesson_code.course.isolation.limits import Limits
from lesson_code.course.isolation.unprivileged import UnprivilegedUser

SECONDS_TO_END = 10.0
SECONDS_TO_START = 30.0
SECONDS_TO_FORK = 30.0
LARGEST_REPLY = 60_000

BOOT = (
    "import sys; sys.path.insert(0, sys.argv[1]); "
    "from inside.{module} import main; sys.path.remove(sys.argv[1]); main()"
)
"""Runs a module of ``inside`` under that name: lesson_code is not even imported for its parent."""


class WarmServer:
    """A Python with NumPy that forks a child for each submission, behind a wall of one kind.

    Parameters
    ----------
    kind : str
        The kind of wall, as in ``inside.wall``.
    limits : Limits
        What a submission may use.
    drop_user : bool
        Whether children become a user that no other process has; only root can do that.
    wrapper : tuple of str
        A command that starts the server's own.
    folder : str, optional
        Where the server may write, if the wrapper gives it other folders.
    """

    def __init__(
        self,
        kind: str,
        limits: Limits,
        *,
        drop_user: bool = False,
        wrapper: tuple[str, ...] = (),
        folder: str | None = None,
    ) -> None:
        self._kind = kind
        self._limits = limits
        self._wrapper = wrapper
        self._has_own_root = kind == "namespaces" or folder is not None
        self._folder = ""
        self._folder_inside = folder
        self._user = UnprivilegedUser() if drop_user else None
        self._process: subprocess.Popen[bytes] | None = None
        self._control: socket.socket | None = None
        self._next: Channel | None = None

    def open(self) -> None:
        """Start the server, and wait until its wall stands.

        Raises
        ------
        IsolationError
            This machine does not allow such a wall.
        """
        self._folder = tempfile.mkdtemp(prefix="grading-")
        Path(self._folder).chmod(0o711)
        self._control, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._control.settimeout(SECONDS_TO_START)
        with theirs, tempfile.TemporaryFile() as errors:
            self._process = self._started(theirs.fileno(), errors)
            try:
                self._control.send(json.dumps(asdict(self._orders())).encode())
                reply = json.loads(self._control.recv(LARGEST_REPLY))
            except (OSError, ValueError):
                self._end_server()
                errors.seek(0)
                reply = {"error": _last_line(errors.read()) or "its server did not start"}
        if "error" in reply:
            self._end_server()
            raise IsolationError(reply["error"])
        if self._has_own_root:  # then it needs no folder of this machine any more
            shutil.rmtree(self._folder, ignore_errors=True)

    def _started(self, control: int, errors: IO[bytes]) -> subprocess.Popen[bytes]:
        """Return a server, started."""
        return subprocess.Popen(  # noqa: S603 - our own interpreter, our own module
            [*self._wrapper, *python("server", str(control))],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=errors,
            cwd="/",
            env=environment(),
            pass_fds=[control],
            start_new_session=True,
        )

    def _orders(self) -> Orders:
        """Return what the server is to do."""
        return Orders(
            kind=self._kind,
            mounts=tuple(paths.mounts()),
            folder=self._folder_inside or self._folder,
            user=None if self._user is None else self._user.id,
            cpu_seconds=self._limits.seconds_a_child,
            bytes_of_memory=self._limits.bytes_of_memory,
            bytes_a_file=BYTES_A_FILE if self._has_own_root else 0,
        )

    def prepare(self) -> None:
        """Have the server make the next child; one that waits already is kept."""
        self._next = self._next or self._forked({"fork": "answers"})

    def start(self) -> Channel:
        """Return the way to a new child, whose wall is closed; the one before it is ended.

        Raises
        ------
        IsolationError
            The server cannot make one, not even after it was started again.
        """
        for attempt in range(2):
            if attempt:  # where a submission could end the server, it ended nothing but that
                self._end_server()
                self.open()
            self.prepare()
            channel, self._next = self._next, None
            assert channel is not None  # noqa: S101 - prepare() has made it
            if channel.ask(b"", SECONDS_TO_FORK) == b'{"wall": "closed"}\n':
                return channel
            channel.close()
        raise IsolationError(f"the wall ({self._kind}) could not be closed round a submission")

    def possible(self, target: dict[str, Any]) -> dict[str, bool]:
        """Return which deeds a child of this server is able to do to a target."""
        channel = self._forked({"fork": "probe", "target": target})
        line = channel.ask(b"", SECONDS_TO_FORK)
        channel.close()
        if not line:
            raise IsolationError(f"the wall ({self._kind}) could not be tried out")
        possible: dict[str, bool] = json.loads(line)["possible"]
        return possible

    def _forked(self, request: dict[str, Any]) -> SocketChannel:
        """Return the way to a child that the server is told to fork."""
        assert self._control is not None  # noqa: S101 - open() has made it
        ours, theirs = socket.socketpair()
        with theirs, contextlib.suppress(OSError):  # a server that is gone: the child is silent
            socket.send_fds(self._control, [json.dumps(request).encode()], [theirs.fileno()])
        return SocketChannel(ours, self._limits.bytes_an_answer)

    def end(self) -> None:
        """End the current child, and whatever it has started."""
        assert self._control is not None  # noqa: S101 - open() has made it
        with contextlib.suppress(OSError):
            self._control.send(b'{"end": true}')

    def spent(self) -> float | None:
        """Return the processor time of the current child, s; None if the server cannot tell."""
        assert self._control is not None  # noqa: S101 - open() has made it
        try:
            self._control.send(b'{"spent": true}')
            spent: float | None = json.loads(self._control.recv(LARGEST_REPLY))["spent"]
        except (OSError, ValueError):  # a server that is gone
            return None
        return spent

    def close(self) -> None:
        """End the server and its child, and remove its folder."""
        self._end_server()
        if self._user is not None:
            self._user.close()

    def _end_server(self) -> None:
        """End the server, if it runs; it ends its child and cleans up first."""
        if self._next is not None:
            self._next.close()
            self._next = None
        if self._control is not None:
            self._control.close()
            self._control = None
        if self._process is not None:
            _wait_for(self._process)
            self._process = None
        shutil.rmtree(self._folder, ignore_errors=True)


def python(module: str, *arguments: str) -> list[str]:
    """Return the command that runs a module of ``inside`` in a Python of its own."""
    boot = BOOT.format(module=module)
    return [sys.executable, "-I", "-c", boot, str(paths.FOLDER), *arguments, mark_of_children()]


def mark_of_children() -> str:
    """Return what stands in the command line of all that is forked for this process."""
    return f"for-grader-{os.getpid()}"


def environment() -> dict[str, str]:
    """Return the whole environment of a server: nothing of the parent's but what it must have."""
    needed = {name: os.environ[name] for name in ("SYSTEMROOT",) if name in os.environ}
    return needed | {
        "OPENBLAS_NUM_THREADS": "1",
        "PYGAME_HIDE_SUPPORT_PROMPT": "1",
        "SDL_AUDIODRIVER": "dummy",
        "SDL_VIDEODRIVER": "dummy",
    }


def _wait_for(process: subprocess.Popen[bytes]) -> None:
    """Wait for a server to end, and end it if it does not."""
    try:
        process.wait(SECONDS_TO_END)
    except subprocess.TimeoutExpired:
        with contextlib.suppress(OSError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def _last_line(text: bytes) -> str:
    """Return the last line of what a program has said of itself."""
    lines = text.decode(errors="replace").strip().splitlines()
    return lines[-1] if lines else ""

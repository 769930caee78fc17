"""The ladder of isolation: what a system may allow, the best first, and which it does allow.

What a rung is worth is not taken from its name. Before anything of a student runs, a child tries
behind the wall to reach a file, the network and a process of the parent's: the level is "full" only
if all of that fails.
"""

from __future__ import annotations

import os
import shutil
import socket
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from lesson_code.course.isolation import paths
from lesson_code.course.isolation.channel import Channel
from lesson_code.course.isolation.fresh_process import FreshProcess
from lesson_code.course.isolation.in_force import (
    LEVELS,
    InForce,
    IsolationError,
    Level,
    require_level,
)
from lesson_code.course.isolation.inside import disk, landlock, namespaces, seccomp
from lesson_code.course.isolation.limits import Limits
from lesson_code.course.isolation.warm_server import WarmServer


class Children(Protocol):
    """Makes the processes that submissions run in, one at a time."""

    def open(self) -> None:
        """Make ready."""

    def start(self) -> Channel:
        """Return the way to a new child; the one before it is ended."""

    def spent(self) -> float | None:
        """Return the processor time of the current child, s; None where nobody can tell."""

    def end(self) -> None:
        """End the current child, and whatever it has started."""

    def close(self) -> None:
        """End everything."""


@dataclass(frozen=True)
class Rung:
    """A way to keep a submission apart: what it consists of, what it needs, how it is made."""

    name: str
    parts: tuple[str, ...]
    make: Callable[[Limits], Children]
    missing: Callable[[], str | None] = lambda: None


def _is_root() -> bool:
    """Return whether this process may become any user."""
    return os.name == "posix" and os.geteuid() == 0


def _needs_linux() -> str | None:
    """Return why there is no warm server here."""
    return None if sys.platform == "linux" else "needs Linux"


def _needs_seccomp() -> str | None:
    """Return why system calls cannot be restricted here."""
    if sys.platform == "linux" and not seccomp.is_known_machine():
        return f"the system calls of a {os.uname().machine} are not known"
    return _needs_linux()


def _needs_bubblewrap() -> str | None:
    """Return why a server cannot be started by bubblewrap here."""
    found = shutil.which("bwrap")
    return _needs_landlock() or (None if found else "bubblewrap (bwrap) is not installed")


def _needs_landlock() -> str | None:
    """Return why files cannot be kept away by the kernel alone."""
    if missing := _needs_seccomp():
        return missing
    newest = landlock.version()
    if newest < landlock.OLDEST_VERSION:
        return f"needs Landlock {landlock.OLDEST_VERSION} (Linux 6.2), this kernel has {newest}"
    return None


def _needs_a_readable_python() -> str | None:
    """Return why another user could not run this Python."""
    if missing := _needs_linux():
        return missing
    if _is_root() and not paths.is_readable_by_others():
        return f"another user than root cannot read this Python ({sys.base_prefix})"
    return None


def _needs_a_readable_python_and_seccomp() -> str | None:
    """Return why another user could not run this Python with its system calls restricted."""
    return _needs_seccomp() or _needs_a_readable_python()


def _namespaces(limits: Limits) -> Children:
    """Return a server in namespaces of its own."""
    return WarmServer("namespaces", limits, drop_user=_is_root())


def _bubblewrap(limits: Limits) -> Children:
    """Return a server that bubblewrap has put into namespaces."""
    return WarmServer(
        "landlock", limits, wrapper=_bubblewrap_command(), folder=namespaces.WORKING_FOLDER
    )


def _bubblewrap_command() -> tuple[str, ...]:
    """Return the command that starts a program with nothing but Python in sight."""
    seen = [*paths.readable(), *paths.to_start_python()]
    inside = str(paths.FOLDER / "inside")
    return (
        shutil.which("bwrap") or "bwrap",
        "--unshare-all",
        "--unshare-user",
        "--die-with-parent",
        "--new-session",
        *(word for path in seen for word in ("--ro-bind", path, path)),
        *(word for path in _hidden_within(seen) for word in ("--tmpfs", path)),
        *("--ro-bind", inside, inside),
        *("--dev-bind", os.devnull, os.devnull, "--dev-bind", "/dev/urandom", "/dev/urandom"),
        *("--size", str(disk.MOST_BYTES), "--tmpfs", namespaces.WORKING_FOLDER),
        "--",
    )


def _hidden_within(seen: list[str]) -> Iterator[str]:
    """Yield what is hidden and would be seen."""
    for path in paths.hidden():
        if any(Path(path).is_relative_to(outer) for outer in seen):
            yield path


_PROCESS_PARTS = ("a process of its own, wall clock limited",) + (
    ("time, memory, file size and open files limited",) if os.name == "posix" else ()
)


def _warm(kind: str) -> Callable[[Limits], Children]:
    """Return a function that makes a server of this kind; for root, children of another user."""

    def make(limits: Limits) -> Children:
        return WarmServer(kind, limits, drop_user=_is_root() and paths.is_readable_by_others())

    return make


CALLS = "system calls restricted to computing"
LIMITS = "time, memory, files and processes limited"
NO_PRIVILEGES = "no privileges"
OWN_MACHINE = "files, network and processes of its own"

RUNGS = (
    Rung("namespaces", (OWN_MACHINE, CALLS, NO_PRIVILEGES, LIMITS), _namespaces, _needs_seccomp),
    Rung(
        "bubblewrap",
        (f"{OWN_MACHINE}, by bubblewrap", CALLS, NO_PRIVILEGES, LIMITS),
        _bubblewrap,
        _needs_bubblewrap,
    ),
    Rung(
        "landlock",
        ("files kept away by Landlock", CALLS, NO_PRIVILEGES, LIMITS),
        _warm("landlock"),
        _needs_landlock,
    ),
    Rung(
        "seccomp",
        (CALLS, NO_PRIVILEGES, LIMITS, "files can be read"),
        _warm("seccomp"),
        _needs_a_readable_python_and_seccomp,
    ),
    Rung(
        "limits",
        (NO_PRIVILEGES, LIMITS, "files can be read, the network can be used"),
        _warm("limits"),
        _needs_a_readable_python,
    ),
    Rung("process", _PROCESS_PARTS, FreshProcess),
)
"""From the best to the least."""


@contextmanager
def isolated(
    limits: Limits, least: str | None = None, only: str | None = None
) -> Iterator[tuple[Children, InForce]]:
    """Yield the maker of children on the highest rung that works here, and its level.

    Parameters
    ----------
    limits : Limits
        What a submission may use.
    least : str, optional
        The least level that will do: "full", "limits" or "none", which is as good as any.
    only : str, optional
        The only rung to try, by name.

    Raises
    ------
    IsolationError
        There is less to be had; nothing of a submission has run.
    ValueError
        There is no such level.
    """
    wanted = require_level(least or "none")
    reasons = []
    for rung in (rung for rung in RUNGS if only in (None, rung.name)):
        try:
            children, in_force = opened(rung, limits)
        except IsolationError as error:
            reasons.append(f"{rung.name}: {error}")
            continue
        if LEVELS.index(in_force.level) >= LEVELS.index(wanted):
            try:
                yield children, in_force
            finally:
                children.close()
            return
        children.close()
        reasons.append(f"{rung.name}: gives {in_force.level}")
    raise IsolationError(f"isolation {wanted} is not to be had here ({'; '.join(reasons)})")


def opened(rung: Rung, limits: Limits) -> tuple[Children, InForce]:
    """Return the started maker of children on a rung, and its measured level.

    Raises
    ------
    IsolationError
        This machine does not allow it.
    """
    if missing := rung.missing():
        raise IsolationError(missing)
    children = rung.make(limits)
    try:
        children.open()
        level = _level_of(children)
    except BaseException:
        children.close()
        raise
    return children, InForce(level, rung.name, rung.parts)


def _level_of(children: Children) -> Level:
    """Return the level that a rung gives: full if a child can do none of the forbidden deeds."""
    if not isinstance(children, WarmServer):
        return "limits" if os.name == "posix" and not _is_root() else "none"
    with _target() as target:
        return "limits" if any(children.possible(target).values()) else "full"


@contextmanager
def _target() -> Iterator[dict[str, Any]]:
    """Yield a file, a port and a process of ours for a child to reach, if it can."""
    with tempfile.TemporaryDirectory() as folder, socket.create_server(("127.0.0.1", 0)) as server:
        Path(folder).chmod(0o777)
        canary = Path(folder) / "canary"
        canary.write_text("canary")
        canary.chmod(0o666)
        yield {"folder": folder, "port": server.getsockname()[1], "process": os.getpid()}

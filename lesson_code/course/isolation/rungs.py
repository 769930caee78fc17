"""The ladder of isolation: what a system may allow, the best first, and which it does allow.

What a rung is worth is not taken from its name. Before anything of a student runs, a child tries
behind the wall to reach files, copies of the workbook, the network, descriptors, and a process of
the parent's: the level is "full" only if all of that fails. No submission ever runs as root.
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

    def prepare(self) -> None:
        """Have the next child made while this process does something else."""

    def start(self) -> Channel:
        """Return the way to a new child, the prepared one if there is one.

        The child before it is ended.
        """

    def spent(self) -> float | None:
        """Return the processor time of the current child, s; None where nobody can tell."""

    def end(self) -> None:
        """End the current child, and whatever it has started."""

    def close(self) -> None:
        """End everything."""


@dataclass(frozen=True)
class Rung:
    """A way to keep a submission apart: what it consists of, what it needs, how it is made.

    Its level is the most that it can give, however little a child is able to do.
    """

    name: str
    level: Level
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
    return _needs_seccomp() or (None if found else "bubblewrap (bwrap) is not installed")


def _needs_a_readable_python() -> str | None:
    """Return why another user could not run this Python."""
    if missing := _needs_linux():
        return missing
    if _is_root() and not paths.is_readable_by_others():
        return f"another user than root cannot read this Python ({sys.base_prefix})"
    return None


def _needs_another_user() -> str | None:
    """Return why a Python of this user's own would be too much."""
    return "root's rights are never given to a submission" if _is_root() else None


def _namespaces(limits: Limits) -> Children:
    """Return a server in namespaces of its own."""
    return WarmServer("namespaces", limits, drop_user=_is_root())


def _bubblewrap(limits: Limits) -> Children:
    """Return a server that bubblewrap has put into namespaces."""
    return WarmServer(
        "layers",
        limits,
        drop_user=_is_root(),
        wrapper=_bubblewrap_command(),
        folder=namespaces.WORKING_FOLDER,
    )


def _bubblewrap_command() -> tuple[str, ...]:
    """Return the command that starts a program with nothing but Python in sight.

    For root, children become another user, which none could in a user namespace of bubblewrap's.
    """
    start = [(path, False) for path in paths.to_start_python()]
    mounts = sorted([*paths.mounts(), *start], key=lambda entry: len(Path(entry[0]).parts))
    inside = str(paths.FOLDER / "inside")
    emptied = [path for path, is_hidden in mounts if is_hidden and Path(path).is_dir()]
    rights = ("CAP_SETUID", "CAP_SETGID", "CAP_CHOWN", "CAP_KILL", "CAP_DAC_OVERRIDE")
    above = {str(p) for path in (inside, *(m[0] for m in mounts)) for p in Path(path).parents}
    apart = ("--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts")
    return (
        shutil.which("bwrap") or "bwrap",
        *(apart if _is_root() else ("--unshare-all", "--unshare-user")),
        "--die-with-parent",
        "--new-session",
        *("--cap-drop", "ALL"),
        *(word for right in rights if _is_root() for word in ("--cap-add", right)),
        *(word for path in sorted(above) for word in ("--perms", "0755", "--dir", path)),
        *(word for path, is_hidden in mounts for word in _mounting(path, is_hidden)),
        *("--ro-bind", inside, inside),
        *(word for path in emptied for word in ("--remount-ro", path)),
        *("--dev-bind", os.devnull, os.devnull, "--dev-bind", "/dev/urandom", "/dev/urandom"),
        *("--size", str(disk.MOST_BYTES), "--tmpfs", namespaces.WORKING_FOLDER),
        "--",
    )


def _mounting(path: str, is_hidden: bool) -> tuple[str, ...]:
    """Return bubblewrap's words for what can be read, or is hidden."""
    if not is_hidden:
        return ("--ro-bind", path, path)
    return ("--tmpfs", path) if Path(path).is_dir() else ("--ro-bind", os.devnull, path)


def _limits(limits: Limits) -> Children:
    """Return a server with what limits and layers there are; for root, children of another user."""
    return WarmServer("layers", limits, drop_user=_is_root())


_PROCESS_PARTS = ("a process of its own, wall clock limited",) + (
    ("time, memory, file size and open files limited",) if os.name == "posix" else ()
)

LAYERS = tuple(
    name
    for name, is_there in (
        ("system calls restricted to computing (seccomp)", _needs_seccomp() is None),
        ("files kept away by Landlock", sys.platform == "linux" and landlock.is_strong()),
    )
    if is_there
)
"""What this kernel adds within each rung."""

INNER = (*LAYERS, "no privileges", "time, memory, files and processes limited")
OWN_MACHINE = "files, network and processes of its own"

RUNGS = (
    Rung("namespaces", "full", (OWN_MACHINE, *INNER), _namespaces, _needs_seccomp),
    Rung(
        "bubblewrap",
        "full",
        (f"{OWN_MACHINE}, by bubblewrap", *INNER),
        _bubblewrap,
        _needs_bubblewrap,
    ),
    Rung("limits", "limits", INNER, _limits, _needs_a_readable_python),
    Rung("process", "limits", _PROCESS_PARTS, FreshProcess, _needs_another_user),
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
        level = _level_of(children, rung)
    except BaseException:
        children.close()
        raise
    return children, InForce(level, rung.name, rung.parts)


def _level_of(children: Children, rung: Rung) -> Level:
    """Return the level that a rung gives: full if a child can do none of the forbidden deeds."""
    if not isinstance(children, WarmServer):
        return "limits" if os.name == "posix" else "none"
    with _target() as target:
        possible = children.possible(target)
    if possible["be root"]:
        raise IsolationError("a child would have root's rights")
    return "limits" if any(possible.values()) else rung.level


@contextmanager
def _target() -> Iterator[dict[str, Any]]:
    """Yield what a child is to try to reach: files, a port, a process and packages of ours."""
    with tempfile.TemporaryDirectory() as folder, socket.create_server(("127.0.0.1", 0)) as server:
        Path(folder).chmod(0o777)
        canary = Path(folder) / "canary"
        canary.write_text("canary")
        canary.chmod(0o666)
        yield {
            "folder": folder,
            "port": server.getsockname()[1],
            "process": os.getpid(),
            "shared": os.__file__,
            "copies": paths.copies(),
            "packages": paths.other_packages(),
        }

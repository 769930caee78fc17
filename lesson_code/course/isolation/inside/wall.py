"""The wall round a submission: what is put up once for the server, and what for each child.

There is a class for each kind of wall. A server calls, in this order: ``build`` once, and for each
child ``before_fork``, in the child ``close``, and ``after_end`` when the child has ended.
"""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import disk, landlock, limits, namespaces, seccomp, system


@dataclass(frozen=True)
class Orders:
    """What the parent has decided about the wall.

    `mounts` has what is readable and, where True stands, what is hidden in it, from the outside in.
    `bytes_a_file` is 0 where the folder is on a disk, which nobody may fill.
    """

    kind: str
    mounts: tuple[tuple[str, bool], ...]
    folder: str
    user: int | None
    cpu_seconds: int
    bytes_of_memory: int
    bytes_a_file: int

    @classmethod
    def from_dict(cls, sent: dict[str, Any]) -> Orders:
        """Return orders as they have come over a pipe."""
        return cls(**{**sent, "mounts": tuple((path, hides) for path, hides in sent["mounts"])})

    @property
    def readable(self) -> tuple[str, ...]:
        """What can be read, but for what is hidden in it."""
        return tuple(path for path, is_hidden in self.mounts if not is_hidden)

    @property
    def hidden(self) -> tuple[str, ...]:
        """What lies in a readable folder, and cannot be read."""
        return tuple(path for path, is_hidden in self.mounts if is_hidden)


class Wall:
    """Limits, for root another user, and the layers of the kernel: Landlock and seccomp.

    Landlock keeps files away, seccomp all system calls but those of computing. Where the kernel
    lacks one of them, the wall stands without it.
    """

    def __init__(self, orders: Orders) -> None:
        self.orders = orders
        running = 0 if orders.user else limits.processes_of(os.getuid())
        self._processes = running + limits.MORE_PROCESSES
        self._count = 0
        self._rules: int | None = None

    @property
    def folder(self) -> str:
        """The working folder of the current child."""
        return f"{self.orders.folder}/{self._count}"

    def build(self) -> None:
        """Put up what stands for as long as the server runs."""
        system.prctl(system.PR_SET_DUMPABLE, 0)  # no process of this user can look into it
        system.prctl(system.PR_SET_CHILD_SUBREAPER, 1)
        seccomp.prepare()
        if landlock.is_strong():
            landlock.restrict(landlock.ruleset(_rules_of_the_server(self.orders)))

    def before_fork(self) -> None:
        """Make the next child's folder, and the rules for its files.

        A child would have to copy each page of memory that it writes to in doing so.
        """
        self._make_folder()
        os.environ["HOME"] = os.environ["TMPDIR"] = self.folder
        if landlock.is_strong():
            writable = (self.folder, os.devnull) if self.orders.bytes_a_file else (os.devnull,)
            rules = [(path, landlock.ALL_WRITES) for path in writable]
            self._rules = landlock.ruleset([("/", landlock.READ), *rules])

    def _make_folder(self) -> None:
        """Make a folder for the next child."""
        self._count += 1
        os.mkdir(self.folder, 0o700)  # noqa: PTH102 - paths are texts on this side
        if self.orders.user is not None:
            os.chown(self.folder, self.orders.user, self.orders.user)

    def close(self) -> None:
        """Close the wall round this process: in a child, once, for good."""
        os.chdir(self.folder)
        os.setsid()
        os.umask(0o077)
        orders = self.orders
        limits.lower(
            orders.cpu_seconds, orders.bytes_of_memory, self._processes, orders.bytes_a_file
        )
        self._become_nobody()
        system.prctl(system.PR_SET_PDEATHSIG, signal.SIGKILL)
        if self._rules is not None:
            landlock.restrict(self._rules)
        seccomp.restrict()

    def _become_nobody(self) -> None:
        """Become another user, if this one is root, and give up every privilege."""
        if (user := self.orders.user) is not None:
            os.setgroups([])
            os.setgid(user)
            os.setuid(user)
        system.drop_capabilities()

    def is_overfull(self) -> bool:
        """Return whether the child has written more than it may."""
        return disk.is_overfull(self.folder)

    def after_end(self) -> None:
        """End what the last child has left running, and remove its folder and rules."""
        self._remove_folder()
        if self._rules is not None:
            os.close(self._rules)
            self._rules = None

    def _remove_folder(self) -> None:
        """Remove the folder of a child, and end first whoever could write in it."""
        _end_orphans()
        disk.remove(self.folder)


def _rules_of_the_server(orders: Orders) -> list[tuple[str, int]]:
    """Return what a server and its children need of the machine's files."""
    everything = landlock.READ | landlock.ALL_WRITES
    rules = [(path, landlock.READ) for path in _around(orders)]
    rules += [(path, landlock.READ_FOLDER) for path in orders.readable]
    rules += [(path, everything) for path in (orders.folder, os.devnull)]
    return rules + [(path, landlock.READ) for path in namespaces.DEVICES]


def _around(orders: Orders) -> list[str]:
    """Return what can be read, without what is hidden in it: rules can only allow."""
    paths = list(orders.readable)
    for hidden in map(Path, orders.hidden):
        for path in [path for path in paths if hidden.is_relative_to(path)]:
            paths.remove(path)
            paths += [str(p) for p in _siblings(Path(path), hidden)]
    return paths


def _siblings(top: Path, hidden: Path) -> list[Path]:
    """Return all that lies in `top` beside the way that leads to `hidden`."""
    found = []
    for folder in (hidden.parent, *hidden.parent.parents):
        found += [entry for entry in folder.iterdir() if not hidden.is_relative_to(entry)]
        if folder == top:
            break
    return found


class NamespaceWall(Wall):
    """The same layers in a machine of its own: own files, network and processes."""

    def build(self) -> None:
        """Move the server into namespaces of its own."""
        seccomp.prepare()
        self._apart = namespaces.enter(self.orders.mounts, self.orders.folder)
        system.prctl(system.PR_SET_DUMPABLE, 0)

    @property
    def folder(self) -> str:
        """The working folder of the current child."""
        return namespaces.WORKING_FOLDER

    def before_fork(self) -> None:
        """Put the next child into a process namespace of its own, too."""
        super().before_fork()
        self._apart.prepare()

    def _make_folder(self) -> None:
        """Mount a folder for the next child."""
        user = os.getuid() if self.orders.user is None else self.orders.user
        group = os.getgid() if self.orders.user is None else self.orders.user
        namespaces.mount_folder(self.folder, user, group)

    def is_overfull(self) -> bool:
        """Return False: the folder itself has a size."""
        return False

    def _remove_folder(self) -> None:
        """Take the folder off; the kernel has ended all processes with the first one."""
        namespaces.unmount_folder(self.folder)


KINDS: dict[str, Callable[[Orders], Wall]] = {"namespaces": NamespaceWall, "layers": Wall}


def _end_orphans() -> None:
    """End every process that has become a child of this one, as orphans do, until none is left."""
    children = Path(f"/proc/self/task/{os.getpid()}/children")
    with contextlib.suppress(OSError):  # among them: there are no more children
        while True:
            for process in map(int, children.read_text().split()):
                os.kill(process, signal.SIGKILL)
            os.waitpid(-1, 0)

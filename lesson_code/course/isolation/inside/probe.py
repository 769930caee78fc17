"""What a child can do behind the wall, found out by trying it there."""

from __future__ import annotations

import contextlib
import fcntl
import importlib.machinery
import os
import resource
import socket
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

NETWORK_CARDS = 0x8912
"""The ioctl SIOCGIFCONF, which any socket answers, and an inherited one too."""

SET_SIGNAL = 10
"""The fcntl F_SETSIG: which signal the owner of a descriptor is sent."""

THE_CHILDS_OWN = (0, 1, 2, 3)
"""Descriptors of a child: nothing, thrice, and the socket to the parent."""

MOST_DESCRIPTORS = 4_096
"""How far descriptors are looked for; a server has some ten."""

MOST_THREADS = 1_000
"""A wall that lets somebody start more does not bound threads."""


def attempts(target: dict[str, Any]) -> dict[str, bool]:
    """Return for each deed whether it was possible.

    Parameters
    ----------
    target : dict
        A ``folder`` of the parent's that holds a file ``canary`` and is open to everybody, the
        ``port`` on which the parent listens, the parent's ``process``, a file ``shared`` by all
        children, the ``copies`` of the workbook, and names of installed ``packages`` that are not
        on the list of imports.
    """
    deeds: dict[str, Callable[[dict[str, Any]], object]] = {
        "read files": lambda at: (Path(at["folder"]) / "canary").read_bytes(),
        "list files": lambda at: os.listdir(at["folder"]),  # noqa: PTH208
        "write files": lambda at: (Path(at["folder"]) / f"left by {os.getpid()}").write_bytes(b""),
        "change modes": lambda at: (Path(at["folder"]) / "canary").chmod(0o666),
        "change times": lambda at: os.utime(Path(at["folder"]) / "canary"),
        "read the workbook": _reads_the_workbook,
        "import other packages": _imports,
        "use the network": lambda at: socket.create_connection(("127.0.0.1", at["port"]), 0.2),
        "ask for network cards": lambda _: fcntl.ioctl(3, NETWORK_CARDS, struct.pack("iP", 0, 0)),
        "start processes": _fork,
        "signal the grader": lambda at: os.kill(at["process"], 0),
        "have signals sent": lambda _: fcntl.fcntl(3, SET_SIGNAL, 9),
        "own a descriptor for another": lambda at: fcntl.fcntl(3, fcntl.F_SETOWN, at["process"]),
        "lock what others read": _locks,
        "reach other descriptors": _reaches_descriptors,
        "be root": _is_root,
        "start threads without end": _starts_threads,
    }
    return {name: _succeeds(deed, target) for name, deed in deeds.items()}


def _reads_the_workbook(target: dict[str, Any]) -> None:
    """Read a copy of the workbook: a folder with something in it, or a file that is not empty."""
    for copy in map(Path, target["copies"]):
        with contextlib.suppress(OSError):
            if any(copy.iterdir()) if copy.is_dir() else copy.read_bytes():
                return
    raise FileNotFoundError


def _imports(target: dict[str, Any]) -> None:
    """Find a package that is not on the list, without asking the finder that refuses it."""
    found = map(importlib.machinery.PathFinder.find_spec, target["packages"])
    if not any(spec is not None and spec.origin for spec in found):
        raise ModuleNotFoundError


def _fork(_: dict[str, Any]) -> None:
    """Start a process that ends at once."""
    if os.fork() == 0:
        os._exit(0)


def _locks(target: dict[str, Any]) -> None:
    """Lock a file that every child can read, in one way or the other."""
    with open(target["shared"], "rb") as file:  # noqa: PTH123
        for lock in (fcntl.flock, fcntl.lockf):
            with contextlib.suppress(OSError):
                lock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
                return
    raise PermissionError


def _reaches_descriptors(_: dict[str, Any]) -> None:
    """Find a descriptor that was open before."""
    for descriptor in range(len(THE_CHILDS_OWN), MOST_DESCRIPTORS):
        with contextlib.suppress(OSError):
            os.fstat(descriptor)
            return
    raise FileNotFoundError


def _is_root(_: dict[str, Any]) -> None:
    """Have the rights of root, now or later."""
    if 0 not in (*os.getresuid(), *os.getresgid()):
        raise PermissionError


def _starts_threads(_: dict[str, Any]) -> None:
    """Start threads until there are too many, all of which wait."""
    import threading  # where it stands in the server, a fork spends .4 ms on it in each child

    end = threading.Event()
    most = resource.getrlimit(resource.RLIMIT_NPROC)[1]
    started = 0
    try:
        while started <= MOST_THREADS and most != resource.RLIM_INFINITY:
            threading.Thread(target=end.wait, daemon=True).start()
            started += 1
    except RuntimeError as error:
        raise PermissionError from error
    finally:
        end.set()


def _succeeds(deed: Callable[[dict[str, Any]], object], target: dict[str, Any]) -> bool:
    """Return whether a deed is possible."""
    try:
        deed(target)
    except (OSError, ImportError):
        return False
    return True

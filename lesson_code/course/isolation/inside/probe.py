"""What a child can do behind the wall, found out by trying it there."""

from __future__ import annotations

import os
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any


def attempts(target: dict[str, Any]) -> dict[str, bool]:
    """Return for each deed whether it was possible.

    Parameters
    ----------
    target : dict
        A ``folder`` of the parent's that holds a file ``canary`` and is open to everybody, the
        ``port`` on which the parent listens, and the parent's ``process``.
    """
    deeds: dict[str, Callable[[dict[str, Any]], object]] = {
        "read files": lambda at: (Path(at["folder"]) / "canary").read_bytes(),
        "write files": lambda at: (Path(at["folder"]) / f"left by {os.getpid()}").write_bytes(b""),
        "change modes": lambda at: (Path(at["folder"]) / "canary").chmod(0o666),
        "use the network": lambda at: socket.create_connection(("127.0.0.1", at["port"]), 0.2),
        "start processes": _fork,
        "signal the grader": lambda at: os.kill(at["process"], 0),
    }
    return {name: _succeeds(deed, target) for name, deed in deeds.items()}


def _fork(_: dict[str, Any]) -> None:
    """Start a process that ends at once."""
    if os.fork() == 0:
        os._exit(0)


def _succeeds(deed: Callable[[dict[str, Any]], object], target: dict[str, Any]) -> bool:
    """Return whether a deed is possible."""
    try:
        deed(target)
    except OSError:
        return False
    return True

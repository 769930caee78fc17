"""The cores of this machine: how many there are to use, and one of its own for each worker."""

from __future__ import annotations

import os
import socket

_claims: list[socket.socket] = []
"""What says that this process has a core; the system takes it back when the process ends."""


def usable_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):  # Linux: a container or taskset may leave it only some
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def keep_a_core(workers: int, team: str = "") -> bool:
    """Keep this process, one of a team of so many workers, and what it starts on its own core.

    Processes that wait for one another in turn hand over sooner on one core than from core to core.
    That pays where there are as many workers as cores, so that no core would have been free.

    Returns
    -------
    bool
        Whether it is so. It is not where there are fewer workers, all cores are taken, or the
        system cannot do it.
    """
    if not hasattr(os, "sched_setaffinity") or workers < usable_cores():
        return False
    for core in sorted(os.sched_getaffinity(0)):
        claim = socket.socket(socket.AF_UNIX)
        try:
            claim.bind(f"\0core {core} for {team} of {os.getppid()}")
            os.sched_setaffinity(0, {core})
        except OSError:
            claim.close()
        else:
            _claims.append(claim)
            return True
    return False

"""How much of the machine a child may use: time, memory, file size, files, processes."""

from __future__ import annotations

import os
import time
from pathlib import Path
from types import ModuleType

resource: ModuleType | None
try:
    import resource
except ImportError:  # Windows has none; the report says so
    resource = None

BYTES_A_FILE = 1_000_000
"""Where a folder is in memory and has a size of its own. On a disk nothing can be written at all:
the size of one file bounds no number of files."""

OPEN_FILES = 64
MORE_PROCESSES = 32
"""Threads count as processes. Those that the same user already runs come on top."""


def lower(
    cpu_seconds: int, bytes_of_memory: int, processes: int | None = None, bytes_a_file: int = 0
) -> None:
    """Lower this process's limits; a process without privileges cannot raise them again."""
    if resource is None:
        return
    limits = [
        (resource.RLIMIT_CPU, cpu_seconds),
        (resource.RLIMIT_AS, bytes_of_memory),
        (resource.RLIMIT_FSIZE, bytes_a_file),
        (resource.RLIMIT_NOFILE, OPEN_FILES),
        (resource.RLIMIT_CORE, 0),
    ]
    if processes is not None:
        limits.append((resource.RLIMIT_NPROC, processes))
    for what, most in limits:
        _, hard = resource.getrlimit(what)
        allowed = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(what, (allowed, allowed))


def lower_memory(most: int) -> None:
    """Lower the memory of this process alone, in bytes."""
    if resource is not None:
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def bound_time_from_now(seconds: int) -> None:
    """Have the system end this process after some more seconds of the processor's time."""
    if resource is not None:
        _, hard = resource.getrlimit(resource.RLIMIT_CPU)
        last = int(time.process_time()) + 1 + seconds
        resource.setrlimit(resource.RLIMIT_CPU, (last, hard))


def processes_of(user: int) -> int:
    """Return how many threads of all its processes a user runs, as the system shows them."""
    return sum(_threads(folder, user) for folder in Path("/proc").glob("[0-9]*"))


def _threads(folder: Path, user: int) -> int:
    """Return the number of threads of a process, 0 if it is another user's or gone."""
    try:
        if folder.stat().st_uid != user:
            return 0
        return sum(1 for _ in os.scandir(folder / "task"))
    except OSError:
        return 0

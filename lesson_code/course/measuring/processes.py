"""The processes of the grader, as the system shows them: which there are, and their time."""

from __future__ import annotations

import contextlib
import os
import signal
from pathlib import Path

from lesson_code.course.isolation.warm_server import mark_of_children


def processes_of_children() -> set[int]:
    """Return all processes that were forked for this one, or for a child of it."""
    mark, found = mark_of_children().encode(), set()
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if mark in (folder / "cmdline").read_bytes().split(b"\0"):
                found.add(int(folder.name))
    return found


def processes_below(process: int) -> set[int]:
    """Return the processes that descend from one."""
    found: set[int] = set()
    for path in Path(f"/proc/{process}/task").glob("*/children"):
        with contextlib.suppress(OSError):
            for child in map(int, path.read_text().split()):
                found |= {child} | processes_below(child)
    return found


def end(processes: set[int]) -> None:
    """End what a submission has left running."""
    for process in processes - processes_below(os.getpid()) - {os.getpid()}:
        with contextlib.suppress(OSError):
            os.kill(process, signal.SIGKILL)


def cpu_seconds() -> float:
    """Return the processor's time of this process and of all below it, ended ones too, s."""
    ticks = sum(_ticks(process) for process in processes_below(os.getpid()))
    own = os.times()
    return ticks / os.sysconf("SC_CLK_TCK") + sum(own[:4])


def _ticks(process: int) -> int:
    """Return the time of a process and of its ended children, in ticks of the clock."""
    with contextlib.suppress(OSError):
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(") ")[2].split()
        return sum(map(int, fields[11:15]))
    return 0

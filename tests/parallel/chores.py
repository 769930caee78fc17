"""What the tests let workers do. It is a module that they can import."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from pathlib import Path
from typing import Any

from lesson_code.parallel import keep_a_core, map_tasks, workers_here


class TwoPartError(Exception):
    """An error that pickle cannot build again: it is made of two parts and kept as one."""

    def __init__(self, number: int, word: str) -> None:
        super().__init__(f"{number} {word}")


def square(number: float) -> float:
    """Return a number times itself."""
    return number * number


def process_of(_: object) -> int:
    """Return which process this is."""
    return os.getpid()


def naps(seconds: float) -> int:
    """Sleep, and return which process this is."""
    time.sleep(seconds)
    return os.getpid()


def core_of(seconds: float) -> tuple[int, ...]:
    """Keep a core, if this worker may, sleep, and return the cores it has."""
    keep_a_core(workers_here())
    time.sleep(seconds)
    return tuple(sorted(os.sched_getaffinity(0)))


def environment(name: str) -> str | None:
    """Return a variable of the environment."""
    return os.environ.get(name)


def goes_wrong(task: str) -> Any:
    """Go wrong in the way that the task says, or return it."""
    if task == "raise":
        raise ValueError("no such thing")
    if task == "two parts":
        raise TwoPartError(3, "apples")
    if task == "exit":
        sys.exit(3)
    if task == "lock":
        return threading.Lock()
    return task


def dies(task: tuple[str, int]) -> int:
    """Return the number of a task, or let its worker die in the way that the task says."""
    way, number = task
    if way == "exit":
        os._exit(0)
    if way == "kill":
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def dies_once(task: tuple[Path | None, int]) -> int:
    """Return the number of a task; let its worker die if the file is not there yet."""
    mark, number = task
    if mark is not None and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def writes_itself_down(folder: Path) -> None:
    """Write down which process this is, and sleep far longer than a test may take."""
    (folder / str(os.getpid())).touch()
    time.sleep(600)


def asks_others(count: int) -> list[tuple[int, bool]]:
    """Return which process does each of some tasks of a task, and whether it is this one."""
    return [(pid, pid == os.getpid()) for pid in map_tasks(process_of, range(count))]

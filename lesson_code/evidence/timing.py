"""Times, taken in turns, so that other load on the machine affects all engines alike."""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Callable, Mapping
from typing import NamedTuple, Protocol, TypeVar

CPU_CLOCK_IS_FINE = time.get_clock_info("process_time").resolution <= 1e-6
"""Whether the processor's time can be told within a batch of steps; not so on Windows."""

Key = TypeVar("Key")


class Advances(Protocol):
    """An object that can make steps."""

    def advance(self, steps: int, /) -> None:
        """Make some steps."""


class Seconds(NamedTuple):
    """How long something took, s: by the clock on the wall, and of the processor."""

    wall: float
    cpu: float

    @property
    def worked(self) -> float:
        """CPU time, which excludes other programs, or wall-clock time where CPU time is too coarse.

        No engine here uses more than one core: on an idle machine both are the same.
        """
        return self.cpu if CPU_CLOCK_IS_FINE else self.wall


def timed(work: Callable[[], object]) -> Seconds:
    """Return how long a call takes, with garbage collection off."""
    gc.disable()
    try:
        cpu, wall = time.process_time(), time.perf_counter()
        work()
        return Seconds(wall=time.perf_counter() - wall, cpu=time.process_time() - cpu)
    finally:
        gc.enable()


def in_turns(
    jobs: Mapping[Key, Callable[[], float]], repeats: int, *, patience: float = math.inf
) -> dict[Key, list[float]]:
    """Return what each job has returned, call by call: its times, s.

    Parameters
    ----------
    jobs : mapping to callable
        Each does its work once and returns a time, s.
    repeats : int
        Rounds in which each is called once, >= 1.
    patience : float
        s: a job that takes longer is called once. Disturbances are a small part of so long a time.
    """
    times: dict[Key, list[float]] = {key: [] for key in jobs}
    gc.collect()
    for _ in range(repeats):
        for key, job in jobs.items():
            if max(times[key], default=0.0) <= patience:
                times[key].append(job())
    return times


def steps_of_a_batch(engine: Advances, seconds: float, most: int, least: int = 1) -> int:
    """Return how many steps an engine makes in about some time, s; it makes as many."""
    steps = 1
    while steps < most:
        taken = timed(lambda n=steps: engine.advance(n)).worked  # type: ignore[misc]
        if taken >= seconds / 2:
            break
        steps = min(most, 2 * steps)
    return min(most, max(least, steps))

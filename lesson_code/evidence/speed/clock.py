"""The clock that engines are compared by: other programs on the machine do not enter it."""

from __future__ import annotations

import time

CPU_CLOCK_IS_FINE = time.get_clock_info("process_time").resolution <= 1e-6
"""Whether the processor's time can be told within a batch of steps; not so on Windows."""


def worked_seconds() -> float:
    """Return how long the processor has worked for this process, s, or the time if that is coarse.

    No engine here uses more than one core, so that on an idle machine both are the same.
    """
    return time.process_time() if CPU_CLOCK_IS_FINE else time.perf_counter()

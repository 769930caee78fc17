"""What the programs that notebook 08 compares cost on this machine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from lesson_code.evidence.timing import in_turns, timed

TURNS = 3
"""Times that each program runs: the first run of a program pays for what the others keep."""

PATIENCE = 0.5
"""s: a program that takes longer runs once."""


def milliseconds(programs: Mapping[str, Callable[[], object]]) -> dict[str, float]:
    """Return how long each program takes, ms of the processor: its shortest run of three.

    Examples
    --------
    >>> list(milliseconds({"a sum": lambda: sum(range(10))}))
    ['a sum']
    """
    jobs = {name: partial(_seconds, program) for name, program in programs.items()}
    times = in_turns(jobs, TURNS, patience=PATIENCE)
    return {name: 1e3 * min(taken) for name, taken in times.items()}


def _seconds(program: Callable[[], object]) -> float:
    return timed(program).worked

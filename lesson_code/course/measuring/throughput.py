"""How many submissions a second are graded, by rung of isolation, and beside nbgrader.

The rungs take turns, batch by batch, so that other work on the machine slows all of them. The
processor's time for a submission is measured too, with that of all children: it is what a busy
machine changes least.
"""

from __future__ import annotations

import os
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from multiprocessing.util import Finalize
from pathlib import Path
from typing import Any

from rich.table import Table

from lesson_code.course.grading.exercises import exercise_by_name, exercises
from lesson_code.course.grading.grader import Grader
from lesson_code.course.isolation import InForce, IsolationError, Limits, opened
from lesson_code.course.measuring import nbgrader_run
from lesson_code.course.measuring.hostile_set import chosen_rungs
from lesson_code.course.measuring.processes import cpu_seconds
from lesson_code.parallel import keep_a_core, usable_cores

VERSION = 1
EXERCISE, MIX = "01", "mix"
"""What is graded if nothing is said, and the name of all exercises one after another."""

SEED = 7
"""A class is graded with one seed."""

BATCHES = 5
BATCH, SMALL_BATCH = 100, 4
"""Submissions a worker grades in one batch; fewer where a submission takes a second."""

SLOW = ("process", "nbgrader")


@dataclass
class Rate:
    """Submissions a second of one way of grading, batch by batch, and their processor's time."""

    name: str
    in_force: InForce | None
    workers: int
    each: list[float] = field(default_factory=list)
    cpu: list[float] = field(default_factory=list)

    @property
    def a_second(self) -> float:
        """The median of the batches."""
        return statistics.median(self.each)

    @property
    def cpu_ms(self) -> float:
        """The processor's time for a submission, ms: the median of the batches."""
        return 1e3 * statistics.median(self.cpu)

    def as_dict(self) -> dict[str, Any]:
        """Return the rate as a JSON object."""
        return {
            "name": self.name,
            "isolation": None if self.in_force is None else self.in_force.as_dict(),
            "workers": self.workers,
            "batches": len(self.each),
            "submissions_a_second": self.a_second,
            "slowest": min(self.each),
            "fastest": max(self.each),
            "cpu_ms_a_submission": self.cpu_ms,
        }


@dataclass(frozen=True)
class Throughput:
    """The rates of all ways of grading that were measured, and why others were not."""

    exercise: str
    rates: tuple[Rate, ...]
    missing: dict[str, str]

    def as_dict(self) -> dict[str, Any]:
        """Return the measurement as one JSON object."""
        return {
            "version": VERSION,
            "command": "measure grading",
            "exercise": self.exercise,
            "cores": os.cpu_count(),
            "python": sys.version.split()[0],
            "rates": [rate.as_dict() for rate in self.rates],
            "missing": self.missing,
        }

    def as_table(self) -> Table:
        """Return a table, a row for each way of grading."""
        table = Table(
            "grader", "isolation", "workers", "submissions a second", "processor, ms each",
            title=f"Grading {self.exercise}, {os.cpu_count()} cores",
        )  # fmt: skip
        for rate in self.rates:
            level = "none" if rate.in_force is None else rate.in_force.level
            shown = f"{rate.a_second:.4g} ({min(rate.each):.4g} - {max(rate.each):.4g})"
            table.add_row(rate.name, level, str(rate.workers), shown, f"{rate.cpu_ms:.3g}")
        if self.missing:
            table.caption = "; ".join(f"{name}: {why}" for name, why in self.missing.items())
        return table


def measure_grading(
    root: Path,
    wanted: Sequence[str] | None = None,
    *,
    exercise: str = EXERCISE,
    workers: int | None = None,
    batches: int = BATCHES,
    told: Callable[[str, float], None] = lambda *_: None,
) -> Throughput:
    """Measure how many submissions a second are graded, on each rung, and by nbgrader.

    Parameters
    ----------
    root : Path
        The workbook's folder; its solution is what is graded.
    wanted : sequence of str, optional
        Names of rungs; by default all, and nbgrader where it is installed.
    exercise : str
        Name or number of what is graded; with `MIX` all exercises, one after another. nbgrader,
        which has no programs, does without the mix.
    workers : int, optional
        Processes that grade side by side; one for each core by default.
    batches : int
        How often each takes its turn.
    told : callable
        Receives progress messages, and the share of the work that is done.
    """
    chosen = exercises() if exercise == MIX else (exercise_by_name(exercise),)
    paths = [each.solution(root) for each in chosen]
    count = workers or usable_cores()
    missing: dict[str, str] = {}
    with ExitStack() as stack:
        turns: list[tuple[Rate, Callable[[], tuple[int, float, float]]]] = []
        for rung in chosen_rungs(wanted or ()):
            try:
                children, in_force = opened(rung, Limits())
            except IsolationError as error:
                missing[rung.name] = str(error)
                continue
            children.close()
            team = ProcessPoolExecutor(count, initializer=keep_a_core, initargs=(count, rung.name))
            pool = stack.enter_context(team)
            turns.append((Rate(rung.name, in_force, count), _turn(pool, rung.name, paths, count)))
        if wanted is None and len(paths) == 1 and paths[0].suffix == ".ipynb":
            if missing_nbgrader := nbgrader_run.missing():
                missing["nbgrader"] = missing_nbgrader
            else:
                folder = stack.enter_context(tempfile.TemporaryDirectory())
                course = nbgrader_run.Course(Path(folder), paths[0], chosen[0], SEED)
                turns.append((Rate("nbgrader", None, 1), partial(course.grade, SMALL_BATCH)))
        _take_turns(turns, batches, told)
    name = chosen[0].name if len(chosen) == 1 else exercise
    return Throughput(name, tuple(rate for rate, _ in turns), missing)


def _take_turns(
    turns: list[tuple[Rate, Callable[[], tuple[int, float, float]]]],
    batches: int,
    told: Callable[[str, float], None],
) -> None:
    """Have each way of grading do its batches in turn; a first batch only warms up."""
    for batch in range(batches + 1):
        for at, (rate, turn) in enumerate(turns):
            told(rate.name, (batch + at / len(turns)) / (batches + 1))
            graded, seconds, cpu = turn()
            if batch:
                rate.each.append(graded / seconds)
                rate.cpu.append(cpu / graded)


def _turn(
    pool: ProcessPoolExecutor, rung: str, paths: Sequence[Path], workers: int
) -> Callable[[], tuple[int, float, float]]:
    """Return what grades one batch on all workers: how many, in what time, for what CPU time."""
    rounds = max(1, (SMALL_BATCH if rung in SLOW else BATCH) // len(paths))
    each = [*paths] * rounds

    def turn() -> tuple[int, float, float]:
        began = time.perf_counter()
        used = sum(pool.map(_grade_batch, [rung] * workers, [each] * workers))
        return len(each) * workers, time.perf_counter() - began, used

    return turn


_kept: dict[str, Grader] = {}
"""The graders of a worker process, kept from batch to batch as in a class run."""


def _grade_batch(rung: str, paths: Sequence[Path]) -> float:
    """Return the processor's time, s, for grading some submissions; run by a worker."""
    if rung not in _kept:
        _kept[rung] = Grader(rung=rung).__enter__()
        Finalize(None, _kept[rung].__exit__, (None, None, None), exitpriority=1)
    before = cpu_seconds()
    for path in paths:
        if not _kept[rung].grade(path, seed=SEED).is_full:
            raise RuntimeError(f"{path} has lost marks on rung {rung}")
    return cpu_seconds() - before

"""All families run in every engine, over processes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import closing
from typing import Any

from lesson_code.evidence.engines import has_box2d
from lesson_code.evidence.hard_cases.catalogue import FAMILIES, family_by_name
from lesson_code.evidence.hard_cases.comparison import Comparison, Replay, summed_up
from lesson_code.evidence.hard_cases.trial import ENGINES, OURS, Family, Outcome, Trial, run_draw
from lesson_code.parallel import WorkerDiedError, iter_tasks, usable_cores

DRAWS = 3
"""How many draws of each family are made unless said otherwise."""


def installed_engines() -> tuple[str, ...]:
    """Return ours and those of the others that can be run here."""
    return tuple(engine for engine in ENGINES if engine != "box2d" or has_box2d())


Task = tuple[str, str, int]
"""The names of a family and of an engine, and a seed."""


def run_task(task: Task) -> Outcome:
    """Return how an engine does in a draw; a task can be sent to another process."""
    name, engine, seed = task
    return run_draw(family_by_name(name), engine, seed)


def measure_hard_cases(
    names: Sequence[str] | None = None,
    *,
    draws: int = DRAWS,
    peer_draws: int | None = None,
    seed: int = 0,
    engines: Sequence[str] | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
) -> Comparison:
    """Run draws of families in every engine, over processes, and return how they did.

    An engine that kills its process has no result in that draw; the others go on.

    Parameters
    ----------
    names : sequence of str, optional
        The families; all by default.
    draws : int
        Of each family, >= 1.
    peer_draws : int, optional
        So many of them are made with the others, >= 1; all by default.
    seed : int
        Of the first draw, >= 0; the others follow it.
    engines : sequence of str, optional
        "ours" and others; all that are installed by default.
    workers, cluster, progress
        As :func:`lesson_code.parallel.map_tasks` takes them; but the default is at least two
        workers. A single worker would be this process, and would die with an engine.

    Raises
    ------
    ValueError
        There is no family or engine of such a name, or a number is out of range.
    """
    families = FAMILIES if not names else tuple(map(family_by_name, names))
    chosen = _engines(engines)
    for name, count in (("draws", draws), ("peer_draws", peer_draws)):
        if count is not None and count < 1:
            raise ValueError(f"{name} must be >= 1, got {count}")
    seeds = _seeds(seed, draws)
    own = {e: seeds if e == OURS or peer_draws is None else seeds[:peer_draws] for e in chosen}
    tasks = [(f.name, e, n) for f in families for e in chosen for n in own[e]]
    found = _outcomes(tasks, workers=workers, cluster=cluster, progress=progress)
    return Comparison(
        tuple(summed_up([found[f.name, e, n] for n in own[e]]) for f in families for e in chosen)
    )


def replay(name: str, seed: int, *, engines: Sequence[str] | None = None) -> Replay:
    """Run one draw of a family in every engine, each in a process of its own.

    The arguments and errors are those of :func:`measure_hard_cases`.
    """
    family: Family = family_by_name(name)
    tasks = [(family.name, engine, n) for engine in _engines(engines) for n in _seeds(seed, 1)]
    found = _outcomes(tasks, workers=None, cluster=None, progress=None)
    return Replay(tuple(found[task] for task in tasks))


def _engines(wanted: Sequence[str] | None) -> tuple[str, ...]:
    return tuple(Trial(engine).engine for engine in wanted or installed_engines())


def _seeds(first: int, count: int) -> range:
    if first < 0:
        raise ValueError(f"seed must be >= 0, got {first}")
    return range(first, first + count)


def _outcomes(tasks: list[Task], *, workers: int | None, **options: Any) -> dict[Task, Outcome]:
    """Return the outcome of each task."""
    called = [f"{name}, {engine}, seed {seed}" for name, engine, seed in tasks]
    count = max(2, usable_cores()) if workers is None else workers
    found: dict[Task, Outcome] = {}
    with closing(iter_tasks(run_task, tasks, names=called, workers=count, **options)) as done:
        for number, future in done:
            task, error = tasks[number], future.exception()
            if isinstance(error, WorkerDiedError):
                bound = family_by_name(task[0]).bound
                found[task] = Outcome(*task, math.nan, bound, error=f"the process died: {error}")
            else:
                found[task] = future.result()
    return found

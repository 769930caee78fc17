"""map_tasks and iter_tasks: one door to this process, to several, and to a cluster."""

from __future__ import annotations

import multiprocessing
import numbers
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, TypeVar

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from lesson_code.parallel.outcome import Outcome, TasksFailedError
from lesson_code.parallel.processes import in_processes
from lesson_code.parallel.travel import pack, perform

T = TypeVar("T")
R = TypeVar("R")


def map_tasks(
    function: Callable[[T], R],
    tasks: Iterable[T],
    *,
    workers: int | None = None,
    cluster: str | None = None,
    names: Sequence[str] | None = None,
    progress: str | None = None,
) -> list[R]:
    """Call a function with each of some tasks, on several cores, and return the results.

    [function(tasks[0]), function(tasks[1]), ...]

    All tasks are done even if some fail. The calls must not depend on one another: a task that
    draws at random carries its own seed.

    Parameters
    ----------
    function : callable
        Takes a task. Other processes import it by its name, so it stands in a module, not in a
        notebook's cell; arguments that all tasks share go in with :func:`functools.partial`.
    tasks : iterable
        Anything that can be pickled.
    workers : int, optional
        Processes, >= 1; 1 does everything in this process. By default one for each core that this
        process may use. In a task's own call it is 1 unless said otherwise: the cores are taken.
    cluster : str, optional
        The address of a dask scheduler, such as "tcp://10.0.0.1:8786", or "local" for a cluster
        of its own on this machine, with so many `workers`. Needs the extra "cluster".
    names : sequence of str, optional
        What each task is called in errors; by default "task 0", "task 1" and so on.
    progress : str, optional
        What is written beside a progress bar on standard error, if that is a terminal. By default
        there is no bar.

    Returns
    -------
    list
        The results in the order of the tasks, whoever has done them.

    Raises
    ------
    TasksFailedError
        Some tasks failed. It is a group of their errors and holds the results of the others.
    TypeError
        The function cannot be called, or another process could not import it.
    ValueError
        `workers`, `cluster` or `names` are out of range.
    RuntimeError
        A cluster is asked for, and dask is not installed.
    OSError
        No cluster answers at the address.

    Examples
    --------
    >>> import math
    >>> map_tasks(math.sqrt, [4, 9, 16], workers=1)
    [2.0, 3.0, 4.0]
    """
    outcomes = list(
        iter_tasks(
            function, tasks, workers=workers, cluster=cluster, names=names, progress=progress
        )
    )
    outcomes.sort(key=lambda outcome: outcome.index)
    if any(outcome.error is not None for outcome in outcomes):
        raise TasksFailedError(outcomes)
    return [outcome.result for outcome in outcomes]


def iter_tasks(
    function: Callable[[T], Any],
    tasks: Iterable[T],
    *,
    workers: int | None = None,
    cluster: str | None = None,
    names: Sequence[str] | None = None,
    progress: str | None = None,
) -> Iterator[Outcome]:
    """Yield what becomes of each task, as soon as it is done.

    For whoever writes down each result at once, to go on from there after an interruption. Each
    task has exactly one outcome, also where it raises, or kills its worker twice. The arguments are
    those of :func:`map_tasks`; they are checked before the first outcome is asked for.

    Yields
    ------
    Outcome
        With `index`, `name` and either `result` or `error`, in the order in which tasks are done.

    Examples
    --------
    >>> import math
    >>> [outcome.error or outcome.result for outcome in iter_tasks(math.sqrt, [4, -4], workers=1)]
    [2.0, ValueError('math domain error')]
    """
    if not callable(function):
        raise TypeError(f"function must be callable, got {function!r}")
    listed = list(tasks)
    called = _names(names, len(listed))
    count = _worker_count(workers)
    if cluster is not None:
        from lesson_code.parallel.cluster import on_cluster

        outcomes = on_cluster(function, listed, called, cluster, workers and count)
    else:
        outcomes = _on_this_machine(function, listed, called, count)
    return _shown(outcomes, len(listed), progress)


def usable_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):  # Linux: a container or taskset may leave it only some
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _on_this_machine(
    function: Callable[[Any], Any], tasks: Sequence[Any], names: Sequence[str], workers: int
) -> Iterator[Outcome]:
    """Return the outcomes, from processes if more than one has something to do."""
    if workers > 1:
        pack("function", function)  # refused for one task and for many alike
    if min(workers, len(tasks)) > 1:
        return in_processes(function, tasks, names, min(workers, len(tasks)))
    return _in_this_process(function, tasks, names)


def _in_this_process(
    function: Callable[[Any], Any], tasks: Sequence[Any], names: Sequence[str]
) -> Iterator[Outcome]:
    """Yield the outcomes, one after the other."""
    for index, (task, name) in enumerate(zip(tasks, names, strict=True)):
        result, error = perform(function, task)
        if error is None:
            yield Outcome(index, name, result)
        else:
            yield Outcome.failed(index, name, error)


def _shown(outcomes: Iterator[Outcome], total: int, label: str | None) -> Iterator[Outcome]:
    """Yield the outcomes, with a bar on standard error that moves on with each."""
    console = Console(stderr=True)
    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(elapsed_when_finished=True))
    hidden = label is None or not console.is_terminal
    with Progress(
        TextColumn("{task.description}"), *columns, console=console, disable=hidden
    ) as bar:
        task = bar.add_task(label or "", total=total)
        for outcome in outcomes:
            bar.advance(task)
            yield outcome


def _worker_count(workers: Any) -> int:
    """Return the number of workers, or refuse what is none."""
    if workers is None:
        return 1 if multiprocessing.current_process().daemon else usable_cores()
    if isinstance(workers, bool) or not isinstance(workers, numbers.Integral):
        raise TypeError(f"workers must be a whole number or None, got {workers!r}")
    if workers < 1:
        raise ValueError(f"workers must be >= 1, got {workers}")
    return int(workers)


def _names(names: Sequence[str] | None, count: int) -> list[str]:
    """Return a name for each task."""
    if names is None:
        return [f"task {index}" for index in range(count)]
    if len(names) != count:
        raise ValueError(f"names must be one for each of {count} tasks, got {len(names)}")
    return [str(name) for name in names]

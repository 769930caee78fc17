"""Independent tasks over the cores of this machine, or over a dask cluster.

:func:`map_tasks` returns all results; :func:`iter_tasks` yields each task as soon as it is done,
for callers that write every result down at once. A result depends on the function and the task
alone, so it is the same wherever the task is done.
"""

from __future__ import annotations

import multiprocessing
import numbers
import os
import re
from collections.abc import Callable, Collection, Generator, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future
from contextlib import AbstractContextManager, closing
from functools import partial
from typing import Any, TypeVar

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from lesson_code.parallel.cores import keep_a_core, usable_cores
from lesson_code.parallel.executors import (
    IN_A_WORKER,
    LOCAL,
    WorkerDiedError,
    finished,
    in_processes,
    in_this_process,
    on_cluster,
)

__all__ = [
    "TasksFailedError",
    "WorkerDiedError",
    "iter_tasks",
    "keep_a_core",
    "map_tasks",
    "usable_cores",
    "workers_here",
]

T = TypeVar("T")
R = TypeVar("R")

ADDRESS = re.compile(rf"{LOCAL}|\w+://\S+:\d+")
"""What a cluster is given by: "local", or a scheduler's address, as tcp://10.0.0.1:8786."""

MOST_LISTED = 3
"""Errors that a message lists; the group holds all of them."""


class TasksFailedError(ExceptionGroup[Exception], RuntimeError):
    """Some tasks failed: a group of their errors; `results` holds what the others returned."""

    results: list[Any]

    def __str__(self) -> str:
        """Return the message alone: it counts the errors itself."""
        return self.message


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
        Takes a task. It travels to the other processes with all that it refers to; what it writes
        into a list or an object there stays there.
    tasks : iterable
        Anything that can be pickled.
    workers : int, optional
        Processes, >= 1; 1 does everything in this process. By default one for each core that this
        process may use. In a task's own call it is 1 unless said otherwise: the cores are taken.
    cluster : str, optional
        The address of a dask scheduler, such as "tcp://10.0.0.1:8786", or "local" for a cluster
        of its own on this machine, with this number of `workers`. Needs the extra "cluster".
    names : sequence of str, optional
        What each task is called in errors; by default "task 0", "task 1" and so on.
    progress : str, optional
        What is written beside a progress bar on standard error, if that is a terminal. By default
        there is no bar.

    Returns
    -------
    list
        The results in the order of the tasks.

    Raises
    ------
    TasksFailedError
        Some tasks failed. It is a group of their errors and holds the results of the others.
    TypeError
        The function cannot be called.
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
    listed = list(tasks)
    called = _names(names, len(listed))
    with closing(
        iter_tasks(
            function, listed, workers=workers, cluster=cluster, names=called, progress=progress
        )
    ) as done:
        futures = dict(sorted(done))
    if any(future.exception() for future in futures.values()):
        raise _failure(called, futures.values())
    return [future.result() for future in futures.values()]


def iter_tasks(
    function: Callable[[T], R],
    tasks: Iterable[T],
    *,
    workers: int | None = None,
    cluster: str | None = None,
    names: Sequence[str] | None = None,
    progress: str | None = None,
) -> Generator[tuple[int, Future[R]], None, None]:
    """Yield each task's number and future as soon as it is done.

    A future has a `result()` or an `exception()`, in whose notes the task is named; an exception
    also where the task has killed its worker twice. The arguments are those of :func:`map_tasks`;
    they are checked before the first task is begun. Closing the generator stops the workers.

    Examples
    --------
    >>> import math
    >>> [done.exception() or done.result() for _, done in iter_tasks(math.sqrt, [4, -4], workers=1)]
    [2.0, ValueError('math domain error')]
    """
    if not callable(function):
        raise TypeError(f"function must be callable, got {function!r}")
    listed = list(tasks)
    called = _names(names, len(listed))
    count = _worker_count(workers)
    if cluster is not None and not (isinstance(cluster, str) and ADDRESS.fullmatch(cluster)):
        raise ValueError(
            f'cluster must be "{LOCAL}" or an address such as tcp://10.0.0.1:8786, got {cluster!r}'
        )
    opened: Callable[[int], AbstractContextManager[Executor]] = in_this_process
    at_most = min(count, len(listed))
    if cluster is not None:
        at_most = count if cluster == LOCAL else len(listed)  # its scheduler knows its workers
        opened = partial(on_cluster, cluster)
    elif at_most > 1:
        opened = in_processes
    return _shown(finished(opened, function, listed, at_most), called, progress)


def workers_here() -> int:
    """Return how many processes of this machine share some tasks, this one among them, or 1."""
    return int(os.environ.get(IN_A_WORKER, "1"))


def _shown(
    futures: Iterator[tuple[int, Future[Any]]], names: Sequence[str], label: str | None
) -> Generator[tuple[int, Future[Any]], None, None]:
    """Yield the futures, errors named, and move a bar on standard error on with each."""
    console = Console(stderr=True)
    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(elapsed_when_finished=True))
    hidden = label is None or not console.is_terminal
    with Progress(
        TextColumn("{task.description}"), *columns, console=console, disable=hidden
    ) as bar:
        for number, future in bar.track(futures, total=len(names), description=label or ""):
            error = future.exception()
            if error is not None:
                error.add_note(f"in {names[number]}")
            yield number, future


def _failure(names: Sequence[str], futures: Collection[Future[Any]]) -> TasksFailedError:
    """Return the error of a call in which some tasks have failed."""
    errors = [future.exception() for future in futures]
    lines = [f"{n}: {type(e).__name__}: {e}" for n, e in zip(names, errors, strict=True) if e]
    more = f"; and {len(lines) - MOST_LISTED} more" if len(lines) > MOST_LISTED else ""
    message = f"{len(lines)} of {len(errors)} tasks failed: {'; '.join(lines[:MOST_LISTED])}{more}"
    failure = TasksFailedError(message, [error for error in errors if isinstance(error, Exception)])
    failure.results = [None if future.exception() else future.result() for future in futures]
    return failure


def _worker_count(workers: Any) -> int:
    """Return the number of workers, or refuse what is none."""
    if workers is None:
        taken = IN_A_WORKER in os.environ or multiprocessing.current_process().daemon
        return 1 if taken else usable_cores()
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

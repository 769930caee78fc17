"""Who does the tasks: this process, several of this machine, or a dask cluster.

Each is an executor of :mod:`concurrent.futures`, and :func:`finished` knows no more about it. What
goes to another process is pickled by cloudpickle: functions of a notebook or a script, too.
"""

from __future__ import annotations

import logging
import os
import pickle
import re
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from contextlib import AbstractContextManager, contextmanager, nullcontext
from importlib import import_module
from typing import Any

import loky

LOCAL = "local"
"""Asks for a cluster on this machine, for as long as the tasks last."""

SECONDS_TO_ANSWER = 10
"""s: a scheduler that has not answered by then is not there."""

IN_A_WORKER = "COLLISION_WORKBOOK_WORKER"
"""Is in the environment of our own processes, and says how many they are: the cores are taken."""


class WorkerDiedError(RuntimeError):
    """A task whose worker died, and died again when nothing else was at work."""


def in_this_process(_workers: int) -> Executor:
    """Return an executor that does each task at once."""
    return _Here()


class _Here(Executor):
    def submit(self, function: Callable[..., Any], /, *args: Any, **options: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(function(*args, **options))
        except Exception as error:
            future.set_exception(error)
        return future


@contextmanager
def in_processes(workers: int) -> Iterator[Executor]:
    """Yield the executor of some processes; an error that leaves it kills them."""
    executor = loky.ProcessPoolExecutor(
        workers, initializer=_start, env={IN_A_WORKER: f"{workers}"}
    )
    try:
        yield executor
    except BaseException:
        executor.shutdown(kill_workers=True)
        raise
    executor.shutdown()


def _start() -> None:
    """Leave Ctrl-C, which reaches all processes, to the parent; end when the parent does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_after, args=(os.getppid(),), daemon=True).start()


def _end_after(parent: int) -> None:
    """End this process when its parent has ended, in whatever way."""
    while os.getppid() == parent:
        time.sleep(1)
    os._exit(1)


@contextmanager
def on_cluster(address: str, workers: int) -> Iterator[Executor]:
    """Yield the executor of a dask cluster; one that is started here ends with it."""
    dask = _dask()
    with local_cluster(workers) if address == LOCAL else nullcontext(address) as cluster:
        try:
            client = dask.Client(cluster, timeout=SECONDS_TO_ANSWER, set_as_default=False)
        except OSError as error:
            raise ConnectionError(f"no dask scheduler answers at {address}: {error}") from None
        with client:
            try:
                client.wait_for_workers(1, timeout=SECONDS_TO_ANSWER)
            except TimeoutError:
                raise ConnectionError(f"the dask scheduler at {address} has no workers") from None
            yield client.get_executor(pure=False)


def local_cluster(workers: int) -> Any:
    """Return a dask cluster on this machine, to which no other machine can give work."""
    return _dask().LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
        scheduler_kwargs={"allowed_failures": 0},  # a task is repeated by us
        silence_logs=logging.CRITICAL,  # what a worker's death leads to is in the future
    )


def _dask() -> Any:
    """Return dask's scheduler package, or say how to install it."""
    try:
        return import_module("distributed")
    except ModuleNotFoundError:
        raise RuntimeError(
            "a cluster needs dask, which is not installed: pip install -e '.[cluster]'"
        ) from None


def finished(
    opened: Callable[[int], AbstractContextManager[Executor]],
    function: Callable[[Any], Any],
    tasks: list[Any],
    at_most: int,
) -> Iterator[tuple[int, Future[Any]]]:
    """Yield the number and the future of each task when it is done, `at_most` at a time.

    When a worker dies, all tasks that were at work may be to blame. They are repeated at the end,
    one by one, with nothing else at work: a task whose worker dies again has failed.
    """
    waiting, suspects = deque(range(len(tasks))), list[int]()
    while waiting:
        with opened(at_most) as executor:  # a new one if a death has broken the last
            yield from _until_a_death(executor, function, tasks, waiting, suspects, at_most)
    for number in suspects:
        with opened(1) as executor:
            future = executor.submit(perform, function, tasks[number])
            yield number, _died(future) if _is_death(future.exception()) else future


def _until_a_death(
    executor: Executor,
    function: Callable[[Any], Any],
    tasks: list[Any],
    waiting: deque[int],
    suspects: list[int],
    at_most: int,
) -> Iterator[tuple[int, Future[Any]]]:
    """Yield what one executor finishes of the tasks that are waiting."""
    at_work: dict[Future[Any], int] = {}
    is_broken = False
    while at_work or (waiting and not is_broken):
        try:
            while waiting and len(at_work) < at_most and not is_broken:
                at_work[executor.submit(perform, function, tasks[waiting[0]])] = waiting[0]
                waiting.popleft()
        except BrokenExecutor:  # a worker has died that was not at a task
            is_broken = True
        for future in wait(at_work, return_when=FIRST_COMPLETED).done:
            number, error = at_work.pop(future), future.exception()
            if _is_death(error):
                is_broken |= isinstance(error, BrokenExecutor)  # a cluster goes on
                suspects.append(number)
            else:
                yield number, future


def perform(function: Callable[[Any], Any], task: Any) -> Any:
    """Return what a function makes of a task; raise only what can travel from a worker."""
    try:
        return function(task)
    except SystemExit as left:
        raise RuntimeError(f"it called sys.exit({left.code!r})") from None
    except Exception as error:
        try:
            pickle.loads(pickle.dumps(error))  # noqa: S301 - our own bytes
        except Exception:  # an error may be built in any way
            raise RuntimeError(f"{type(error).__name__}: {error}") from error
        raise


def _is_death(error: BaseException | None) -> bool:
    """Return whether an error says that a worker has died, here or on a cluster."""
    killed = getattr(sys.modules.get("distributed"), "KilledWorker", BrokenExecutor)
    return isinstance(error, BrokenExecutor | killed)


def _died(future: Future[Any]) -> Future[Any]:
    """Return the future of a task that has killed its worker, with the exit code if it is known."""
    code = re.search(r"{(.+)}", str(future.exception()))  # loky's error ends so: {SIGKILL(-9)}
    died: Future[Any] = Future()
    how = f", at last by {code[1]}" if code else ""
    died.set_exception(WorkerDiedError(f"its worker died 2 times{how}"))
    return died

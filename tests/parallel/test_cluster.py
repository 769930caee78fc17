"""The same tasks on a dask cluster, of which workers may die."""

from __future__ import annotations

import importlib.util
import os
import signal
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

from lesson_code.parallel import (
    TasksFailedError,
    WorkerDiedError,
    executors,
    iter_tasks,
    map_tasks,
)

needs_dask = pytest.mark.skipif(
    importlib.util.find_spec("distributed") is None,
    reason="needs dask: pip install -e '.[cluster]'",
)
needs_signals = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """Return the address of a cluster of two workers on this machine."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(Path(__file__).parent)
        with executors.local_cluster(2) as cluster:
            yield cluster.scheduler_address


@needs_dask
def test_results_of_a_cluster_are_those_of_one_process(chores: ModuleType, address: str) -> None:
    """To the last bit, each in the place of its task, and done by two processes not this one."""
    numbers = [0.1 * n for n in range(100)]
    results = map_tasks(chores.square, numbers, cluster=address)
    assert [x.hex() for x in results] == [(n * n).hex() for n in numbers]
    others = set(map_tasks(chores.process_of, range(40), cluster=address))
    assert len(others) == 2
    assert os.getpid() not in others


@needs_dask
def test_task_that_raises_on_a_cluster_is_named(chores: ModuleType, address: str) -> None:
    """As in a process of this machine."""
    tasks = ["a", "raise", "two parts", "exit", "b"]
    with pytest.raises(
        TasksFailedError, match=r"^3 of 5 tasks failed: task 1: ValueError: no such"
    ):
        map_tasks(chores.goes_wrong, tasks, cluster=address)


@needs_dask
def test_results_of_a_cluster_come_as_they_are_done(chores: ModuleType, address: str) -> None:
    """A task that takes long does not keep back the others' results."""
    done = iter_tasks(chores.naps, [5.0, *[0.0] * 20], cluster=address)
    assert {next(done)[0] for _ in range(10)} <= set(range(1, 21))
    done.close()


@pytest.mark.full
@needs_dask
@needs_signals
def test_worker_killed_half_way_loses_nothing(chores: ModuleType, address: str) -> None:
    """Its tasks are done again by another, and each task is done once."""
    done: list[tuple[int, int]] = []
    for number, future in iter_tasks(chores.naps, [0.02] * 60, cluster=address):
        if not done:
            os.kill(future.result(), signal.SIGKILL)
        done.append((number, future.result()))
    assert sorted(number for number, _ in done) == list(range(60))
    assert len({process for _, process in done}) > 1


@needs_dask
@needs_signals
def test_task_that_kills_its_workers_is_named_and_no_other_is_lost(chores: ModuleType) -> None:
    """On a cluster that is started for the call, and ends with it."""
    before = threading.active_count()
    tasks = [("kill" if n == 4 else "live", n) for n in range(30)]
    done = list(iter_tasks(chores.dies, tasks, cluster="local", workers=2))
    assert sorted(number for number, _ in done) == list(range(30))
    [(number, error)] = [(n, error) for n, future in done if (error := future.exception())]
    assert (number, type(error)) == (4, WorkerDiedError)
    assert threading.active_count() <= before + 2  # dask keeps a loop and a pool for the next call


@needs_dask
def test_address_where_nobody_answers_is_an_error_that_names_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """After some seconds, and not never."""
    monkeypatch.setattr(executors, "SECONDS_TO_ANSWER", 0.5)
    with pytest.raises(ConnectionError, match=r"no dask scheduler answers at tcp://127.0.0.1:1"):
        map_tasks(len, ["a"], cluster="tcp://127.0.0.1:1")


def test_without_dask_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    """The extra is optional."""
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(RuntimeError, match=r"pip install -e '\.\[cluster\]'"):
        map_tasks(len, ["a"], cluster="local")

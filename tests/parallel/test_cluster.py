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
from typing import Any

import pytest

from lesson_code.parallel import (
    TasksFailedError,
    WorkerDiedError,
    cluster,
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
        with cluster._local(2) as address:
            yield address


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
    """As in a process of this machine; what cannot travel, too."""
    tasks = ["a", "raise", "two parts", lambda: 0, "b"]
    with pytest.raises(
        TasksFailedError, match=r"^3 of 5 tasks failed: task 1: ValueError: no such"
    ):
        map_tasks(chores.goes_wrong, tasks, cluster=address)


@needs_dask
def test_results_of_a_cluster_come_as_they_are_done(chores: ModuleType, address: str) -> None:
    """A task that takes long does not keep back the others' results."""
    outcomes = iter_tasks(chores.naps, [5.0, *[0.0] * 20], cluster=address)
    assert {next(outcomes).index for _ in range(10)} <= set(range(1, 21))
    outcomes.close()  # type: ignore[attr-defined]


@needs_dask
@needs_signals
def test_worker_killed_half_way_loses_nothing(chores: ModuleType, address: str) -> None:
    """Its batches are done again by another, and each task has one outcome."""
    tasks = [0.02] * 60
    outcomes, killed = [], 0
    for outcome in iter_tasks(chores.naps, tasks, cluster=address):
        outcomes.append(outcome)
        if not killed:
            killed = outcome.result
            os.kill(killed, signal.SIGKILL)
    assert sorted(outcome.index for outcome in outcomes) == list(range(60))
    assert not any(outcome.error for outcome in outcomes)
    assert len({outcome.result for outcome in outcomes}) > 1


@needs_dask
@needs_signals
def test_task_that_kills_its_workers_is_named_and_no_other_is_lost(chores: ModuleType) -> None:
    """On a cluster that is started for the call, and ends with it."""
    before = threading.active_count()
    tasks = [("kill" if n == 4 else "live", n) for n in range(30)]
    outcomes = list(iter_tasks(chores.dies, tasks, cluster="local", workers=2))
    assert sorted(outcome.index for outcome in outcomes) == list(range(30))
    [failed] = [outcome for outcome in outcomes if outcome.error]
    assert (failed.index, type(failed.error)) == (4, WorkerDiedError)
    assert threading.active_count() <= before + 2  # dask keeps a loop and a pool for the next call


@needs_dask
def test_address_where_nobody_answers_is_an_error_that_names_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """After some seconds, and not never."""
    monkeypatch.setattr(cluster, "SECONDS_TO_ANSWER", 0.5)
    with pytest.raises(ConnectionError, match=r"no dask scheduler answers at tcp://127.0.0.1:1"):
        map_tasks(len, ["a"], cluster="tcp://127.0.0.1:1")


def test_without_dask_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    """The extra is optional."""
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(RuntimeError, match=r"pip install -e '\.\[cluster\]'"):
        map_tasks(len, ["a"], cluster="local")


def test_batches_keep_every_worker_busy_to_the_end() -> None:
    """Four for each of two workers, none of more than a hundred tasks, and every task in one."""

    class Client:
        def nthreads(self) -> dict[str, int]:
            return {"a": 1, "b": 1}

    client: Any = Client()
    for count in (1, 7, 80, 5000):
        batches = cluster._batches(client, dict.fromkeys(range(count), b""))
        assert [index for batch in batches for index in batch] == list(range(count))
        assert len(batches) >= min(count, 8)
        assert max(map(len, batches)) <= 100

"""Tasks over a dask cluster: several machines, or one that is to look like several.

Tasks go out in batches, for a scheduler spends about a millisecond on whatever it is handed. When
a worker dies, the scheduler gives its batches to others. A batch that goes on killing workers is
taken apart, and its tasks are tried one by one, with nothing else at work beside them: so the one
to blame is known.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from typing import Any

from lesson_code.parallel import local_cluster
from lesson_code.parallel.outcome import Outcome, WorkerDiedError
from lesson_code.parallel.processes import MOST_DEATHS
from lesson_code.parallel.travel import outcome_of, pack, perform_packed

LOCAL = "local"
"""Asks for a cluster on this machine, for as long as the tasks last."""

ADDRESS = re.compile(r"\w+://\S+:\d+")
"""What a scheduler's address looks like: tcp://10.0.0.1:8786."""

SECONDS_TO_ANSWER = 10
"""s: a scheduler that has not answered by then is not there."""

LARGEST_BATCH, BATCHES_A_WORKER = 100, 4
"""Few batches waste the scheduler's time least, many spread the work best. 100 tasks share its
millisecond well enough; with four batches each, no worker waits long for the last one."""


def on_cluster(
    function: Callable[[Any], Any],
    tasks: Sequence[Any],
    names: Sequence[str],
    address: str,
    workers: int | None,
) -> Iterator[Outcome]:
    """Return what becomes of each task, as batches are done by the workers of a cluster."""
    if not (isinstance(address, str) and (address == LOCAL or ADDRESS.fullmatch(address))):
        raise ValueError(
            f'cluster must be "{LOCAL}" or an address such as tcp://10.0.0.1:8786, got {address!r}'
        )
    return _streamed(_dask(), pack("function", function), tasks, names, address, workers)


def _streamed(
    dask: Any,
    function: bytes,
    tasks: Sequence[Any],
    names: Sequence[str],
    address: str,
    workers: int | None,
) -> Iterator[Outcome]:
    """Yield the outcomes."""
    packed: dict[int, bytes] = {}
    for index, task in enumerate(tasks):
        try:
            packed[index] = pack(names[index], task)
        except TypeError as error:
            yield Outcome.failed(index, names[index], error)
    with _client(dask, address, workers) as client:
        suspects: list[int] = []
        for batch, replies in _done(dask, client, function, packed, _batches(client, packed)):
            if replies is None:
                suspects += batch
            else:
                yield from map(outcome_of, batch, (names[i] for i in batch), replies)
        for suspect in sorted(suspects):
            for _, replies in _done(dask, client, function, packed, [[suspect]]):
                name = names[suspect]
                yield outcome_of(suspect, name, replies[0]) if replies else _killer(suspect, name)


def _done(
    dask: Any,
    client: Any,
    function: bytes,
    packed: dict[int, bytes],
    batches: Sequence[Sequence[int]],
) -> Iterator[tuple[Sequence[int], list[bytes] | None]]:
    """Yield each batch as it is done, with the replies to its tasks; None if it kills workers."""
    futures = {
        client.submit(_perform_all, function, [packed[i] for i in batch], pure=False): batch
        for batch in batches
    }
    for future in dask.as_completed(list(futures), loop=client.loop):
        error = future.exception()
        if error is None:
            yield futures.pop(future), future.result()
        elif isinstance(error, dask.KilledWorker):
            yield futures.pop(future), None
        else:
            raise RuntimeError(f"a worker of the cluster cannot run this program: {error}")


def _perform_all(function: bytes, tasks: list[bytes]) -> list[bytes]:
    """Return the packed outcomes of a batch: what a worker of the cluster runs."""
    return [perform_packed(function, task) for task in tasks]


def _killer(index: int, name: str) -> Outcome:
    """Return the outcome of a task that kills whoever does it."""
    error = WorkerDiedError("its workers died, each time that the cluster tried it")
    return Outcome.failed(index, name, error)


def _batches(client: Any, packed: dict[int, bytes]) -> list[list[int]]:
    """Return the tasks in batches that keep every worker of the cluster busy to the end."""
    indices, hands = list(packed), max(sum(client.nthreads().values()), 1)
    size = min(max(len(indices) // (hands * BATCHES_A_WORKER), 1), LARGEST_BATCH)
    return [indices[start : start + size] for start in range(0, len(indices), size)]


@contextmanager
def _client(dask: Any, address: str, workers: int | None) -> Iterator[Any]:
    """Yield a client of a cluster; one of our own ends with it."""
    with _local(workers) if address == LOCAL else nullcontext(address) as answering:
        try:
            client = dask.Client(answering, timeout=SECONDS_TO_ANSWER, set_as_default=False)
        except OSError as error:
            raise ConnectionError(f"no dask scheduler answers at {address}: {error}") from None
        with client:
            _require_workers(client, address)
            yield client


@contextmanager
def _local(workers: int | None) -> Iterator[str]:
    """Yield the address of a cluster on this machine that lasts as long as it is used."""
    process = subprocess.Popen(  # noqa: S603 - our own interpreter, our own module
        [sys.executable, "-m", local_cluster.__name__, str(workers or 0), str(MOST_DEATHS)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=os.environ | _surroundings(),
        start_new_session=True,  # Ctrl-C is for this process
    )
    with process:  # at the end its input is closed, and it is waited for
        try:
            assert process.stdout is not None  # noqa: S101 - asked for as a pipe
            address = process.stdout.readline().strip()
            if not address:
                raise RuntimeError("no dask cluster could be started on this machine")
            yield address
        except BaseException:
            process.kill()  # its workers notice, and end
            raise


def _surroundings() -> dict[str, str]:
    """Return what a cluster of our own is told: modules are found where this process finds them.

    A worker's death is no news for the reader of a terminal; what it leads to is in an outcome.
    """
    paths = os.pathsep.join(filter(None, sys.path))
    return {"PYTHONPATH": paths, "DASK_LOGGING__DISTRIBUTED": "critical"}


def _require_workers(client: Any, address: str) -> None:
    """Refuse a scheduler that has nobody to give work to."""
    try:
        client.wait_for_workers(1, timeout=SECONDS_TO_ANSWER)
    except TimeoutError:
        raise ConnectionError(f"the dask scheduler at {address} has no workers") from None


def _dask() -> Any:
    """Return dask's scheduler package, or say how to install it."""
    try:
        import distributed
    except ModuleNotFoundError:
        raise RuntimeError(
            "a cluster needs dask, which is not installed: pip install -e '.[cluster]'"
        ) from None
    return distributed

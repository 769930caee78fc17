"""Tasks over the processes of this machine, of which none may be lost.

Each worker has a pipe of its own and one task at a time. So when a worker dies it is known which
task it was at, and no lock or queue that others use dies with it. That is why this is no
:class:`concurrent.futures.ProcessPoolExecutor`: there, one dead worker ends the whole pool, and
nothing tells which task was to blame.

Workers are forked from a server process that has loaded NumPy and nothing else. A fork of this
process itself would start faster, but would copy locks that other threads hold at that moment (a
Jupyter kernel has several threads, and so have numba and BLAS). Where there is no fork, each worker
is a fresh interpreter.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import time
from collections import Counter, deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.context import BaseContext
from types import ModuleType
from typing import Any

from lesson_code.parallel.outcome import Outcome, WorkerDiedError
from lesson_code.parallel.travel import outcome_of, pack, perform_packed, unpack

MOST_DEATHS = 2
"""A task that has cost so many workers is not tried again. One death may be chance: somebody
killed the process, or memory was short."""

GRACE = 1.0
"""s: so long may workers take to end by themselves; those that are left are killed."""


def in_processes(
    function: Callable[[Any], Any], tasks: Sequence[Any], names: Sequence[str], workers: int
) -> Iterator[Outcome]:
    """Yield what becomes of each task, as it is done, by so many processes.

    A task whose worker dies is done again by a new one; after :data:`MOST_DEATHS` deaths it has
    failed with a WorkerDiedError. However this generator ends, no process is left behind.
    """
    packed = pack("function", function)
    waiting, deaths = deque(range(len(tasks))), Counter[int]()
    crew: list[_Worker] = []
    try:
        crew.extend(_Worker(packed) for _ in range(workers))  # one by one: Ctrl-C may come between
        while waiting or any(worker.is_busy for worker in crew):
            for worker in crew:
                yield from _hand_next(worker, waiting, tasks, names)
            for worker in _heard_of(crew):
                index, reply = worker.take_reply()
                if reply is not None:
                    yield outcome_of(index, names[index], reply)
                    continue
                code = worker.end()
                crew[crew.index(worker)] = _Worker(packed)
                deaths[index] += 1
                if deaths[index] < MOST_DEATHS:
                    waiting.appendleft(index)
                else:
                    yield Outcome.failed(index, names[index], _died(code))
    finally:
        _dismiss(crew)


def _hand_next(
    worker: _Worker, waiting: deque[int], tasks: Sequence[Any], names: Sequence[str]
) -> Iterator[Outcome]:
    """Give an idle worker the next task; yield those before it that cannot travel."""
    while waiting and not worker.is_busy:
        index = waiting.popleft()
        try:
            worker.hand(index, pack(names[index], tasks[index]))
        except TypeError as error:
            yield Outcome.failed(index, names[index], error)


def _died(code: int | None) -> WorkerDiedError:
    """Return the error of a task that has cost too many workers."""
    how = f"signal {-code}" if code is not None and code < 0 else f"exit code {code}"
    return WorkerDiedError(f"its worker died {MOST_DEATHS} times, at last by {how}")


class _Worker:
    """A process that does one task at a time, and this side of the pipe to it."""

    def __init__(self, function: bytes) -> None:
        context = _context()
        self._pipe, theirs = context.Pipe()
        # A worker that is a daemon cannot outlive this process.
        self._process = context.Process(target=_work, args=(theirs,), daemon=True)  # type: ignore[attr-defined]
        with _main_hidden():
            self._process.start()
        theirs.close()
        self._at: int | None = None
        self._send(pack("environment", dict(os.environ)))
        self._send(function)

    @property
    def is_busy(self) -> bool:
        """Whether it has a task."""
        return self._at is not None

    @property
    def signs(self) -> tuple[Connection, int]:
        """What can be waited for: a reply in the pipe, or the end of the process."""
        return self._pipe, self._process.sentinel

    def hand(self, index: int, task: bytes) -> None:
        """Give it a task."""
        self._at = index
        self._send(task)

    def take_reply(self) -> tuple[int, bytes | None]:
        """Return the task it was at, and its reply; None if it died without one."""
        assert self._at is not None  # noqa: S101 - only busy workers are waited for
        index, self._at = self._at, None
        try:
            return index, self._pipe.recv_bytes() if self._pipe.poll() else None
        except (EOFError, OSError):
            return index, None

    def end(self, within: float = GRACE) -> int | None:
        """End the process, by force if it takes longer than `within`, s; return its exit code."""
        self.part()
        self._process.join(max(within, 0.0))
        if self._process.exitcode is None:
            self._process.kill()
            self._process.join()
        code: int | None = self._process.exitcode
        self._process.close()
        return code

    def part(self) -> None:
        """Let it end, without waiting for it.

        It is told once: a second signal could meet it when it has left all that catches the first.
        """
        if self._pipe.closed:
            return
        if self.is_busy:
            self._process.terminate()
        self._pipe.close()

    def _send(self, message: bytes) -> None:
        """Write to the pipe; that a worker is gone is found out by its silence."""
        with suppress(OSError):
            self._pipe.send_bytes(message)


def _heard_of(crew: Sequence[_Worker]) -> list[_Worker]:
    """Wait until a busy worker replies or dies; return all that have."""
    whose = {sign: worker for worker in crew if worker.is_busy for sign in worker.signs}
    if not whose:
        return []
    ready = wait(list(whose))
    heard = {id(whose[sign]) for sign in ready}  # type: ignore[index]
    return [worker for worker in crew if id(worker) in heard]


def _dismiss(crew: Sequence[_Worker]) -> None:
    """End all workers: the idle ones are let go, the busy ones stopped."""
    until = time.monotonic() + GRACE
    for worker in crew:
        worker.part()
    for worker in crew:
        worker.end(until - time.monotonic())


def _work(pipe: Connection) -> None:
    """Do tasks until there are no more: what a worker process runs."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all; the parent answers it
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # so that tasks can clean up
    with suppress(EOFError, OSError, KeyboardInterrupt):
        # The server that it was forked from has the environment of when the server started.
        environment: dict[str, str] = unpack(pipe.recv_bytes())
        os.environ.clear()
        os.environ.update(environment)
        function = pipe.recv_bytes()
        while True:
            pipe.send_bytes(perform_packed(function, pipe.recv_bytes()))


def _context() -> BaseContext:
    """Return how processes are started here."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["numpy"])
    return context


@contextmanager
def _main_hidden() -> Iterator[None]:
    """Hide the running script while a process starts.

    Otherwise each worker would run the script again to import it, and a script whose call is not
    under ``if __name__ == "__main__"`` would start workers without end. Nothing of it is needed:
    what stands in ``__main__`` does not travel.
    """
    shown = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = shown

"""Workers that die, calls that are interrupted: nothing is lost, and nobody is left behind."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest
from processes import is_gone

from lesson_code.parallel import WorkerDiedError, iter_tasks, map_tasks

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")

HANG = 60.0
"""s: whatever takes longer would have waited for ever."""

AT_ONCE = 5.0
"""s: the end of a call that is interrupted, on a machine with much else to do; the tasks that it
interrupts would take 600 s."""


# Death


def test_task_whose_worker_was_killed_is_done_again(chores: ModuleType, tmp_path: Path) -> None:
    """One death may be chance: all results are there, in their places."""
    tasks = [(tmp_path / "mark" if n == 3 else None, n) for n in range(10)]
    assert map_tasks(chores.dies_once, tasks, workers=2) == list(range(10))
    assert (tmp_path / "mark").exists()


@pytest.mark.parametrize(
    ("way", "words"), [("exit", "at last by EXIT(0)"), ("kill", "at last by SIGKILL(-9)")]
)
def test_task_that_kills_its_worker_twice_is_named_and_no_other_is_lost(
    chores: ModuleType, way: str, words: str
) -> None:
    """Also where the worker ends with code 0, as if all were well."""
    tasks = [(way if n == 4 else "live", n) for n in range(12)]
    futures = dict(iter_tasks(chores.dies, tasks, workers=2))
    error = futures.pop(4).exception()
    assert isinstance(error, WorkerDiedError)
    assert f"its worker died 2 times, {words}" in str(error)
    assert error.__notes__ == ["in task 4"]
    assert {n: future.result() for n, future in futures.items()} == {
        n: n for n in range(12) if n != 4
    }


def test_tasks_that_all_kill_their_workers_come_to_an_end(chores: ModuleType) -> None:
    """Each is named; nothing hangs."""
    done = list(iter_tasks(chores.dies, [("kill", n) for n in range(4)], workers=2))
    assert sorted(number for number, _ in done) == [0, 1, 2, 3]
    assert all(isinstance(future.exception(), WorkerDiedError) for _, future in done)


# Interruption


SLEEPERS = """
from collections.abc import Callable
from pathlib import Path
import chores
from lesson_code.parallel import map_tasks
map_tasks(chores.writes_itself_down, [Path("pids")] * 4, workers=2)
"""


def hear_of_ctrl_c() -> None:
    """Take Ctrl-C as a terminal's process does: what a shell starts behind it is deaf to it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def end_group(pid: int) -> None:
    """End whoever is left of a process and its workers, so that a failure waits for no one."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)


@pytest.mark.one_in(2)
@pytest.mark.parametrize(
    ("stop", "send"),
    [
        (signal.SIGINT, os.killpg),
        (signal.SIGTERM, os.killpg),
        (signal.SIGKILL, os.killpg),
        (signal.SIGKILL, os.kill),
    ],
)
def test_workers_end_with_the_process_that_started_them(
    tmp_path: Path, stop: int, send: Callable[[int, int], None]
) -> None:
    """A signal to the whole group, as Ctrl-C in a terminal is, or to that process alone.

    Ctrl-C is told in one traceback, and not in one from each worker.
    """
    pids = tmp_path / "pids"
    pids.mkdir()
    command = [sys.executable, "-c", SLEEPERS]
    paths = os.pathsep.join([str(Path(__file__).parent), *filter(None, sys.path)])
    with (
        subprocess.Popen(
            command,
            cwd=tmp_path,
            env=os.environ | {"PYTHONPATH": paths},
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            preexec_fn=hear_of_ctrl_c,
        ) as process,
        contextlib.ExitStack() as at_last,
    ):
        at_last.callback(end_group, process.pid)
        until = time.monotonic() + HANG
        while len(list(pids.iterdir())) < 2 and time.monotonic() < until:
            time.sleep(0.02)
        workers = [int(path.name) for path in pids.iterdir()]
        assert len(workers) == 2
        send(process.pid, stop)
        assert process.wait(AT_ONCE) != 0
        assert all(is_gone(pid, within=AT_ONCE) for pid in workers)
        told = process.stderr.read() if process.stderr else ""
    if stop == signal.SIGINT:
        assert told.count("Traceback") == 1
        assert told.rstrip().endswith("KeyboardInterrupt")


def test_workers_end_when_the_results_are_no_longer_wanted() -> None:
    """Leaving iter_tasks early stops those that are at a long task."""
    done = iter_tasks(time.sleep, [0, 600], workers=2)
    assert next(done)[0] == 0
    started = time.monotonic()
    done.close()
    assert time.monotonic() - started < AT_ONCE

"""map_tasks and iter_tasks: results, errors and refusals, in this process and in others."""

from __future__ import annotations

import functools
import math
import operator
import os
import subprocess
import sys
import threading
import traceback
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from rich.console import Console

from lesson_code import parallel
from lesson_code.parallel import TasksFailedError, iter_tasks, keep_a_core, map_tasks, usable_cores

WORKERS = pytest.mark.parametrize("workers", [1, 2])


# Results


@pytest.mark.parametrize("workers", [1, 2, 3, None])
def test_results_are_those_of_a_loop_to_the_last_bit(
    chores: ModuleType, workers: int | None
) -> None:
    """However many workers there are, each result stands in the place of its task."""
    numbers = [0.1 * n for n in range(100)]
    results = map_tasks(chores.square, numbers, workers=workers)
    assert [x.hex() for x in results] == [(n * n).hex() for n in numbers]


def test_two_workers_are_two_other_processes(chores: ModuleType) -> None:
    """One worker is this process; of two each gets a task, as none can do both at once."""
    assert set(map_tasks(chores.process_of, range(5), workers=1)) == {os.getpid()}
    others = set(map_tasks(chores.naps, [1.0, 1.0], workers=2))
    assert len(others) == 2
    assert os.getpid() not in others


def test_tasks_may_be_any_iterable_and_none_at_all() -> None:
    """What is not a list is made one; no tasks have no results."""
    assert map_tasks(math.sqrt, (n * n for n in range(3)), workers=2) == [0.0, 1.0, 2.0]
    assert map_tasks(math.sqrt, []) == []


def test_what_all_tasks_share_goes_in_with_partial() -> None:
    """An argument of the function travels with it."""
    assert map_tasks(functools.partial(operator.add, 10), [1, 2], workers=2) == [11, 12]


def test_workers_have_the_environment_of_now(
    chores: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A variable that is set after workers have been started before is seen by new ones."""
    map_tasks(chores.process_of, range(2), workers=2)
    monkeypatch.setenv("COLLISION_WORKBOOK", "42")
    assert map_tasks(chores.environment, ["COLLISION_WORKBOOK"] * 2, workers=2) == ["42", "42"]


def test_tasks_of_a_task_stay_in_its_worker(chores: ModuleType) -> None:
    """The cores are taken: workers do not start workers of their own."""
    for told in map_tasks(chores.asks_others, [3, 3], workers=2):
        assert [same for _, same in told] == [True] * 3


def test_usable_cores_are_those_this_process_may_use() -> None:
    """At least one, and no more than the machine has."""
    assert 1 <= usable_cores() <= (os.cpu_count() or 1)


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="Linux alone keeps cores")
def test_each_of_as_many_workers_as_cores_keeps_its_own(chores: ModuleType) -> None:
    """No two have the same; of fewer workers, and a process alone, each may use all of them."""
    count, all_of_them = usable_cores(), tuple(sorted(os.sched_getaffinity(0)))
    kept = map_tasks(chores.core_of, [1.0] * count, workers=count)
    assert sorted(kept) == [(core,) for core in all_of_them]
    if count > 1:
        assert map_tasks(chores.core_of, [0.0], workers=1) == [all_of_them]
        assert not keep_a_core(count - 1)
    assert tuple(sorted(os.sched_getaffinity(0))) == all_of_them


# Errors


@WORKERS
def test_task_that_raises_is_named_and_the_others_are_not_lost(
    chores: ModuleType, workers: int
) -> None:
    """The group holds each error, with the task's name in its notes, and all results."""
    wanted, names = ["a", "raise", "b", "exit"], ["ann", "bob", "cid", "dan"]
    with pytest.raises(TasksFailedError) as caught:
        map_tasks(chores.goes_wrong, wanted, names=names, workers=workers)
    assert str(caught.value) == (
        "2 of 4 tasks failed: bob: ValueError: no such thing; "
        "dan: RuntimeError: it called sys.exit(3)"
    )
    raised, left = caught.value.exceptions
    assert "in bob" in raised.__notes__
    assert "in dan" in left.__notes__
    assert caught.value.results == ["a", None, "b", None]


def test_error_from_a_worker_tells_where_it_was_raised(chores: ModuleType) -> None:
    """Its cause holds the worker's traceback, with the line of the function."""
    futures = dict(iter_tasks(chores.goes_wrong, ["raise", "a"], workers=2))
    error = futures[0].exception()
    assert "in goes_wrong" in "".join(traceback.format_exception(error))


def test_many_errors_are_counted_and_three_are_listed() -> None:
    """A message stays readable when everything fails."""
    with pytest.raises(TasksFailedError, match=r"; and 7 more$") as caught:
        map_tasks(math.sqrt, [-1.0] * 10, workers=1)
    assert len(caught.value.exceptions) == 10
    assert str(caught.value).count("math domain error") == 3


@pytest.mark.parametrize(
    ("task", "kind", "words"),
    [
        ("two parts", RuntimeError, "TwoPartError: 3 apples"),
        ("lock", TypeError, "cannot pickle '_thread.lock' object"),
    ],
)
def test_what_cannot_travel_back_is_an_error_in_words(
    chores: ModuleType, task: str, kind: type[Exception], words: str
) -> None:
    """The worker stays alive, and its other tasks are done."""
    futures = dict(iter_tasks(chores.goes_wrong, [task, "a"], workers=2))
    error = futures[0].exception()
    assert type(error) is kind
    assert words in str(error)
    assert futures[1].result() == "a"


def test_task_that_cannot_travel_fails_and_the_others_are_done(chores: ModuleType) -> None:
    """Its error names it, and the thing that no other process can have."""
    tasks = ["a", threading.Lock(), "b"]
    with pytest.raises(TasksFailedError, match=r"1 of 3 tasks failed: task 1: .* pickle") as caught:
        map_tasks(chores.goes_wrong, tasks, workers=2)
    assert caught.value.results == ["a", None, "b"]
    assert "lock" in "".join(traceback.format_exception(caught.value))


# Streaming


@WORKERS
def test_iter_tasks_yields_each_task_once(chores: ModuleType, workers: int) -> None:
    """Whatever became of it, and with its place and its name."""
    wanted = ["a", "raise", "b", "exit", "c"]
    done = list(iter_tasks(chores.goes_wrong, wanted, names="vwxyz", workers=workers))
    assert sorted(number for number, _ in done) == [0, 1, 2, 3, 4]
    notes = {n: error.__notes__ for n, future in done if (error := future.exception())}
    assert notes == {1: ["in w"], 3: ["in y"]}


@WORKERS
def test_iter_tasks_may_be_left_early(chores: ModuleType, workers: int) -> None:
    """Whoever has seen enough goes on, and the rest is not done."""
    done = iter_tasks(chores.square, range(10**5), workers=workers)
    number, future = next(done)
    assert future.result() == number**2
    done.close()


# Progress


@pytest.mark.parametrize(("terminal", "label"), [(True, "squares"), (True, None), (False, "x")])
def test_progress_is_shown_on_a_terminal_where_it_is_wanted(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    terminal: bool,
    label: str | None,
) -> None:
    """On standard error, with the label and the count; else nothing is written at all."""
    monkeypatch.setattr(
        parallel, "Console", lambda **stream: Console(**stream, force_terminal=terminal, width=80)
    )
    assert map_tasks(math.sqrt, [1, 4], workers=1, progress=label) == [1.0, 2.0]
    written = capsys.readouterr()
    assert written.out == ""
    if terminal and label:
        assert "squares" in written.err
        assert "2/2" in written.err
    else:
        assert written.err == ""


# Refusals


@pytest.mark.parametrize(
    ("options", "kind", "words"),
    [
        ({"workers": 0}, ValueError, "workers must be >= 1, got 0"),
        ({"workers": -2}, ValueError, "workers must be >= 1, got -2"),
        ({"workers": 1.5}, TypeError, "workers must be a whole number or None, got 1.5"),
        ({"workers": True}, TypeError, "workers must be a whole number or None, got True"),
        ({"names": ["a"]}, ValueError, "names must be one for each of 2 tasks, got 1"),
        ({"cluster": "here"}, ValueError, 'cluster must be "local" or an address such as'),
        ({"cluster": ""}, ValueError, 'cluster must be "local" or an address such as'),
    ],
)
def test_arguments_out_of_range_are_refused_by_name(
    options: dict[str, Any], kind: type[Exception], words: str
) -> None:
    """Before anything is done, also by iter_tasks, of which nothing has been asked yet."""
    with pytest.raises(kind, match="^" + words):
        map_tasks(math.sqrt, [1, 4], **options)
    with pytest.raises(kind, match="^" + words):
        iter_tasks(math.sqrt, [1, 4], **options)


def test_function_that_is_none_is_refused() -> None:
    """The error shows what was given."""
    with pytest.raises(TypeError, match="function must be callable, got 3"):
        map_tasks(3, [1])  # type: ignore[arg-type]


@WORKERS
def test_function_may_be_one_that_no_other_process_can_import(workers: int) -> None:
    """It travels with what it refers to."""
    summand = 10
    assert map_tasks(lambda x: x + summand, [1, 2], workers=workers) == [11, 12]


def test_function_that_cannot_travel_is_an_error_that_says_why() -> None:
    """Nobody else can have a lock of this process."""
    lock = threading.Lock()
    with pytest.raises(TasksFailedError, match="Could not pickle the task") as caught:
        map_tasks(lambda _: lock.locked(), [1, 2], workers=2)
    assert "cannot pickle '_thread.lock' object" in "".join(
        traceback.format_exception(caught.value)
    )


SCRIPT = """
from lesson_code.parallel import map_tasks
import math
print(map_tasks(math.sqrt, [1, 4], workers=2))
def here(x):
    return x
print(map_tasks(here, [1, 4], workers=2))
"""


def test_script_is_not_run_again_by_its_workers(tmp_path: Path) -> None:
    """Even if nothing guards its calls, and though a function that stands in it is called."""
    (tmp_path / "script.py").write_text(SCRIPT, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "script.py"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    assert (run.stdout.splitlines(), run.stderr) == (["[1.0, 2.0]", "[1, 4]"], "")

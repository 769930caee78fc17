"""map_tasks and iter_tasks: results, errors and refusals, in this process and in others."""

from __future__ import annotations

import functools
import math
import operator
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from rich.console import Console

from lesson_code.parallel import TasksFailedError, iter_tasks, map_tasks, tasks, usable_cores

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
    """One worker is this process."""
    assert set(map_tasks(chores.process_of, range(5), workers=1)) == {os.getpid()}
    others = set(map_tasks(chores.process_of, range(50), workers=2))
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


# Errors


@WORKERS
def test_task_that_raises_is_named_and_the_others_are_not_lost(
    chores: ModuleType, workers: int
) -> None:
    """The group holds each error, with the task's name in its notes, and all outcomes."""
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
    assert [outcome.result for outcome in caught.value.outcomes] == ["a", None, "b", None]


def test_error_from_a_worker_tells_where_it_was_raised(chores: ModuleType) -> None:
    """A note holds the worker's traceback, with the line of the function."""
    outcomes = list(iter_tasks(chores.goes_wrong, ["raise", "a"], workers=2))
    [error] = [outcome.error for outcome in outcomes if outcome.error]
    assert any("in goes_wrong" in note for note in error.__notes__)


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
        ("lambda", TypeError, "the result cannot travel to another process"),
    ],
)
def test_what_cannot_travel_back_is_an_error_in_words(
    chores: ModuleType, task: str, kind: type[Exception], words: str
) -> None:
    """The worker stays alive, and its other tasks are done."""
    first, second = sorted(
        iter_tasks(chores.goes_wrong, [task, "a"], workers=2), key=operator.attrgetter("index")
    )
    assert type(first.error) is kind
    assert words in str(first.error)
    assert second.result == "a"


def test_task_that_cannot_travel_fails_and_the_others_are_done(chores: ModuleType) -> None:
    """Its error names it."""
    outcomes = {o.index: o for o in iter_tasks(chores.goes_wrong, ["a", lambda: 0, "b"], workers=2)}
    assert str(outcomes[1].error).startswith("task 1 cannot travel to another process")
    assert (outcomes[0].result, outcomes[2].result) == ("a", "b")


# Streaming


@WORKERS
def test_iter_tasks_yields_each_task_once(chores: ModuleType, workers: int) -> None:
    """Whatever became of it, and with its place and its name."""
    wanted = ["a", "raise", "b", "exit", "c"]
    outcomes = list(iter_tasks(chores.goes_wrong, wanted, names="vwxyz", workers=workers))
    assert sorted((o.index, o.name) for o in outcomes) == list(enumerate("vwxyz"))
    assert {o.index for o in outcomes if o.error} == {1, 3}


@WORKERS
def test_iter_tasks_may_be_left_early(chores: ModuleType, workers: int) -> None:
    """Whoever has seen enough goes on, and the rest is not done."""
    outcomes = iter_tasks(chores.square, range(10**5), workers=workers)
    assert next(outcomes).error is None
    outcomes.close()  # type: ignore[attr-defined]


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
        tasks, "Console", lambda **stream: Console(**stream, force_terminal=terminal, width=80)
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


@pytest.mark.parametrize("count", [1, 2])
def test_function_that_no_worker_can_import_is_refused(count: int) -> None:
    """Alike for one task and for many; in this process it may be any."""
    here = [1] * count
    with pytest.raises(TypeError, match=r"function cannot travel to another process.*workers=1"):
        map_tasks(lambda x: x, here, workers=2)
    assert map_tasks(lambda x: x, here, workers=1) == here


SCRIPT = """
from lesson_code.parallel import map_tasks
import math
print(map_tasks(math.sqrt, [1, 4], workers=2))
def here(x):
    return x
try:
    map_tasks(here, [1], workers=2)
except TypeError as error:
    print(error)
"""


def test_script_is_not_run_again_by_its_workers(tmp_path: Path) -> None:
    """Even if nothing guards its calls; a function that stands in it is refused in words."""
    (tmp_path / "script.py").write_text(SCRIPT, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "script.py"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    first, second = run.stdout.splitlines()
    assert (first, run.stderr) == ("[1.0, 2.0]", "")
    assert "here stands in __main__, which no worker imports" in second

"""The process that compiles: waited for, left to itself, interrupted, killed; it leaves nothing."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from typing import Any

import pytest
from processes import PATIENCE, is_gone, printed, started
from small_program import numbers, small_program

from lesson_code.engine.compiled import compiler
from lesson_code.engine.compiled.compiler import Compiling, compiled, compiled_here
from lesson_code.engine.compiled.library import claimed, is_kept, name_of

pytest.importorskip("numba")
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals are those of POSIX")

BEGIN = """
import signal, sys, time
from small_program import small_program
from lesson_code.engine.compiled.compiler import Compiling
signal.signal(signal.SIGINT, signal.default_int_handler)  # which a run in the background ignores
compiling = Compiling(small_program(), in_background=True)
print(compiling._process.pid, flush=True)
"""
"""Begins to compile, and prints the number of the process."""


def number_from(process: subprocess.Popen[str]) -> int:
    """Return the number that a process has printed first."""
    assert process.stdout is not None
    return int(process.stdout.readline())


def is_kept_soon() -> bool:
    """Return whether the program is kept, now or within our patience."""
    until = time.monotonic() + PATIENCE
    while not (kept := is_kept(small_program())) and time.monotonic() < until:
        time.sleep(0.05)
    return kept


def files(place: Path) -> set[str]:
    """Return the names of all that lies in a folder but for locks, which hold nothing."""
    return {path.name for path in place.iterdir() if path.suffix != ".lock"}


def test_two_processes_that_want_a_program_compile_it_once(place: Path) -> None:
    """The second waits for the first, and finds what that has made."""
    both = [Compiling(small_program(), in_background=True) for _ in range(2)]
    assert [each.wait() for each in both] == ["", ""]
    [path] = place.iterdir()
    whole = path.read_bytes()
    path.unlink()
    with claimed(place, small_program()):  # as if this process were the first
        second = Compiling(small_program(), in_background=False)
        path.write_bytes(whole)
        made = path.stat()
    assert second.wait() == ""
    assert (path.stat().st_ino, path.stat().st_mtime_ns) == (made.st_ino, made.st_mtime_ns)


def test_claim_of_a_killed_process_is_free(place: Path) -> None:
    """The system takes it back."""
    first = Compiling(small_program(), in_background=True)
    while not list(place.glob("*.lock")):
        time.sleep(0.01)
    first._process.kill()
    first._process.wait()
    assert compiled(small_program())(numbers(4.0)) == 2.0
    first.leave(to_finish=False)
    assert [path.name for path in place.iterdir()] == [name_of(small_program())]


def test_program_that_is_compiled_in_this_process_is_kept_as_any_other(place: Path) -> None:
    """It is compiled once."""
    assert compiled_here(small_program())(numbers(4.0)) == 2.0
    assert files(place) == {name_of(small_program())}
    written = (place / name_of(small_program())).stat().st_mtime_ns
    assert compiled_here(small_program())(numbers(9.0)) == 4.5
    assert (place / name_of(small_program())).stat().st_mtime_ns == written


def test_process_that_is_left_ends_and_keeps_nothing(place: Path) -> None:
    """At once, and it does not stay a zombie."""
    left = Compiling(small_program(), in_background=True)
    left.leave(to_finish=False)
    assert is_gone(left._process.pid)
    assert files(place) == set()


def test_process_that_is_nearly_done_finishes(place: Path) -> None:
    """Though whoever has begun it has ended."""
    parent = started(BEGIN + "compiling.leave(to_finish=True)")
    child = number_from(parent)
    parent.communicate()
    assert is_kept_soon()
    assert is_gone(child)
    assert files(place) == {name_of(small_program())}


@pytest.mark.one_in(3)
@pytest.mark.parametrize("way", ["", "sys.exit(3)", "compiling._process = None; raise ValueError"])
def test_process_ends_with_the_one_that_has_begun_it(place: Path, way: str) -> None:
    """However that ends, if it says nothing."""
    parent = started(BEGIN + way)
    child = number_from(parent)
    parent.communicate()
    assert is_gone(child)
    assert files(place) == set()


@pytest.mark.one_in(3)
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_killed_process_leaves_no_other_behind(place: Path, how: signal.Signals) -> None:
    """The thread that the other hangs on is cut."""
    parent = started(BEGIN + "time.sleep(1e3)")
    child = number_from(parent)
    parent.send_signal(how)
    parent.communicate()
    assert is_gone(child)
    assert files(place) == set()


def test_interrupted_wait_ends_the_process(place: Path) -> None:
    """Ctrl-C while a program is compiled that was asked for."""
    inside = textwrap.indent(BEGIN + "compiling.wait()", "    ")
    code = f"try:\n{inside}\nexcept KeyboardInterrupt:\n    print('interrupted')\n"
    parent = started(code)
    child = number_from(parent)
    parent.send_signal(signal.SIGINT)
    assert printed(parent) == ["interrupted"]
    assert is_gone(child)
    assert files(place) == set()


@pytest.mark.parametrize(("in_background", "more"), [(True, compiler.NICENESS), (False, 0)])
def test_process_in_the_background_gives_way_to_others(
    place: Path, in_background: bool, more: int
) -> None:
    """From before it claims its program."""
    compiling = Compiling(small_program(), in_background=in_background)
    while not list(place.glob("*.lock")):
        time.sleep(0.01)
    ours, its = (os.getpriority(os.PRIO_PROCESS, n) for n in (0, compiling._process.pid))
    compiling.leave(to_finish=False)
    assert its - ours == more


def test_wait_for_a_process_that_is_killed_is_an_error_and_not_a_program(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Such as one that has run out of memory."""
    begin = Compiling.__init__

    def begin_and_kill(self: Compiling, *told: Any, **more: Any) -> None:
        begin(self, *told, **more)
        os.kill(self._process.pid, signal.SIGKILL)

    monkeypatch.setattr(Compiling, "__init__", begin_and_kill)
    with pytest.raises(RuntimeError, match="the program cannot be compiled here"):
        compiled(small_program())

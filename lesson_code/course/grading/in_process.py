"""A student's code in this very process: how a notebook calls what its reader has written.

There is no wall here, only some order: the call is silent, ends in time, and cannot import
the answer from lesson_code.
"""

from __future__ import annotations

import builtins
import contextlib
import json
import math
import os
import signal
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any, cast

from lesson_code.course.grading.task import Arguments
from lesson_code.course.isolation.call_outcome import CallOutcome, call_outcome
from lesson_code.course.isolation.inside import answers
from lesson_code.course.isolation.inside.vectors import used_modules
from lesson_code.course.isolation.limits import PATIENCE

AGAIN_SECONDS = 0.1


def call_here(
    functions: dict[str, Any],
    function: str,
    arguments: Arguments,
    seconds: float = 3.0,
    *,
    returned: dict[str, Any] | None = None,
) -> CallOutcome:
    """Call a function in this process, as a notebook does with its reader's own code.

    What it returns is kept in `returned` as it came, by the function's name.
    """
    try:
        with kept_apart(), silence(), time_limit(seconds):
            reply = answers.call(function, list(arguments), functions, returned)
    except TimeLimitError:
        return CallOutcome("timeout", text=f"it did not finish within {seconds:g} s")
    return call_outcome(reply)


@contextlib.contextmanager
def kept_apart() -> Iterator[None]:
    """Keep the code below apart from the checks, as far as that goes within one process.

    Imports of lesson_code fail there, since an answer has to stand on its own. What it changes
    in the modules that the checks are made of is put back.
    """
    own = {name: m for name, m in sys.modules.items() if name.partition(".")[0] == "lesson_code"}
    used = (builtins, json, math, *used_modules())
    kept = [(vars(module), dict(vars(module))) for module in used]
    sys.modules.update(dict.fromkeys(own, cast("ModuleType", None)))
    try:
        yield
    finally:
        for names, before in kept:
            names.update(before)
        sys.modules.update(own)


@contextlib.contextmanager
def silence() -> Iterator[None]:
    """Drop what is printed below, so that a check cell shows the marks and nothing else."""
    with (
        Path(os.devnull).open("w", encoding="utf-8") as sink,
        contextlib.redirect_stdout(sink),
        contextlib.redirect_stderr(sink),
    ):
        yield


class TimeLimitError(BaseException):
    """Raised inside a call that has taken too long; not an Exception, which it might catch."""


@contextlib.contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise TimeLimitError in the code below, once it has run for some seconds.

    Seconds are of the processor; the clock ends what sleeps, after `PATIENCE` times as long.
    Only the main thread of a process on a system with timers can be interrupted in this way;
    elsewhere there is no limit. Where Python drops the error (in a destructor, in a callback of the
    garbage collector) or the code catches it, it is raised again, `AGAIN_SECONDS` later.
    """
    if (
        not hasattr(signal, "setitimer")
        or threading.current_thread() is not threading.main_thread()
    ):
        yield
        return

    runs = True

    def stop(*_: Any) -> None:
        if runs:
            raise TimeLimitError

    timers = (
        (signal.ITIMER_PROF, signal.SIGPROF, seconds),
        (signal.ITIMER_REAL, signal.SIGALRM, PATIENCE * seconds),
    )
    before = [signal.signal(number, stop) for _, number, _ in timers]
    report = sys.unraisablehook
    sys.unraisablehook = lambda dropped: (
        None if dropped.exc_type is TimeLimitError else report(dropped)
    )
    for timer, _, most in timers:
        signal.setitimer(timer, most, AGAIN_SECONDS)
    try:
        yield
    finally:
        runs = False
        sys.unraisablehook = report
        for (timer, number, _), handler in zip(timers, before, strict=True):
            signal.setitimer(timer, 0)
            signal.signal(number, handler)

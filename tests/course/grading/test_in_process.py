"""A student's code in this process: silent, ended in time, and on its own."""

from __future__ import annotations

import builtins
import contextlib
import importlib
import json
import math
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from lesson_code.course.grading.in_process import call_here, kept_apart
from lesson_code.course.isolation.call_outcome import CallOutcome


def here(function: Any, *arguments: Any, seconds: float = 3.0) -> CallOutcome:
    """Return what comes of calling a function in this process."""
    return call_here({"f": function}, "f", arguments, seconds)


def test_call_here_returns_what_a_child_returns() -> None:
    """In a notebook an answer is made as plain as across the wall."""
    assert here(lambda n, v: (n, v), 2, (3.0, 4.0)) == CallOutcome("returned", [2, [3.0, 4.0]])
    assert here(dict).kind == "unusable"
    assert here(lambda: 1 / 0).text == "ZeroDivisionError: division by zero"
    assert here(None) == CallOutcome("missing", text="there is no function named f")


def test_call_here_cuts_off_an_endless_loop() -> None:
    """A loop without an end is interrupted after the limit, and so is one in an answer."""

    def loops() -> None:
        while True:
            try:
                math.sqrt(2.0)
            except Exception:  # noqa: S112 - as students do
                continue

    def yields_for_ever() -> Iterator[float]:
        while True:
            pass
        yield 1.0

    class SlowToGo:
        def __del__(self) -> None:  # Python drops what is raised in here
            end = time.process_time() + 0.2
            while time.process_time() < end:
                pass

    def loops_after_a_dropped_limit() -> None:
        SlowToGo()
        loops()

    def loops_and_catches_everything() -> None:
        with contextlib.suppress(BaseException):
            loops()
        loops()

    late = CallOutcome("timeout", text="it did not finish within 0.1 s")
    assert here(loops, seconds=0.1) == late
    assert here(loops_after_a_dropped_limit, seconds=0.1) == late
    assert here(loops_and_catches_everything, seconds=0.1) == late
    assert here(yields_for_ever, seconds=0.1) == late
    assert here(lambda: time.sleep(60), seconds=0.1) == late


def test_call_here_that_sleeps_less_than_patience_is_not_cut_off() -> None:
    """Time is the processor's, so that a busy machine changes no mark."""

    def sleeps() -> float:
        time.sleep(0.3)
        return 1.0

    assert here(sleeps, seconds=0.1) == CallOutcome("returned", 1.0)


def test_call_here_works_outside_of_the_main_thread() -> None:
    """Where no timer can interrupt, the call is made all the same."""
    outcomes: list[CallOutcome] = []
    thread = threading.Thread(target=lambda: outcomes.append(here(lambda: 1.0)))
    thread.start()
    thread.join()
    assert outcomes == [CallOutcome("returned", 1.0)]


def test_call_here_is_silent(capfd: pytest.CaptureFixture[str]) -> None:
    """What an answer prints does not stand between the marks."""

    def talks() -> float:
        print("hello")  # noqa: T201
        print("hello", file=sys.stderr)  # noqa: T201
        return 1.0

    assert here(talks).value == 1.0
    print("after")  # noqa: T201
    assert capfd.readouterr() == ("after\n", "")


def test_call_here_hides_lesson_code_from_the_answer_alone() -> None:
    """An answer cannot import lesson_code in any way; afterwards everybody can again."""

    def imports() -> float:
        from lesson_code.formulas import elastic_1d

        return float(elastic_1d(1, 1, 1, 1)[0])

    def imports_what_is_not_loaded() -> float:
        return float(importlib.import_module("lesson_code.course.quiz.terminal") is None)

    for function in (imports, imports_what_is_not_loaded):
        outcome = here(function)
        assert outcome.kind == "raised"
        assert outcome.text.startswith("ModuleNotFoundError")
    assert imports() == 1.0


def test_kept_apart_puts_back_what_checks_are_made_of() -> None:
    """Builtins, json, math and numpy are as they were, whatever was done to them."""
    originals = (builtins.abs, json.dumps, math.hypot, np.array)
    with kept_apart():
        setattr(builtins, "abs", lambda _: 0)  # noqa: B010
        setattr(json, "dumps", None)  # noqa: B010
        del math.hypot
        setattr(np, "array", None)  # noqa: B010
    assert (builtins.abs, json.dumps, math.hypot, np.array) == originals


def test_kept_apart_puts_back_after_an_error() -> None:
    """An error on the way does not leave lesson_code hidden."""
    with pytest.raises(ZeroDivisionError), kept_apart():
        1 / 0  # noqa: B018
    assert sys.modules["lesson_code"] is not None

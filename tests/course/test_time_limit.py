"""Calls that never end are ended; all others are left alone."""

from __future__ import annotations

import itertools
import sys
import time
from typing import Any

import pytest

from lesson_code.course.time_limit import NoAnswerError, TimeLimit


def spins() -> None:
    """Never end."""
    while True:
        pass


def spins_and_catches_all() -> None:
    """Never end, and catch whatever is raised inside."""
    while True:
        try:
            sum(range(10))
        except:  # noqa: E722, S112 - what a beginner writes
            continue


def spins_in_itself() -> None:
    """Never end, in a loop without a while."""
    for _ in itertools.count():
        try:
            list(range(100))
        except ValueError:
            continue


@pytest.mark.parametrize("endless", [spins, spins_and_catches_all, spins_in_itself])
def test_call_that_never_ends_is_ended(endless: Any) -> None:
    """With an error that says how long it had; the next call is answered."""
    limit = TimeLimit(0.1)
    with pytest.raises(NoAnswerError, match=r"no answer within 0\.1 s"):
        limit.call(endless)
    assert limit.call(divmod, 7, 2) == (3, 1)


def test_error_of_a_call_stays_what_it_is() -> None:
    """Neither caught nor renamed, a TimeoutError of its own included."""

    def fails() -> None:
        raise TimeoutError("mine")

    with pytest.raises(TimeoutError, match="mine") as caught:
        TimeLimit(1.0).call(fails)
    assert not isinstance(caught.value, NoAnswerError)


def test_calls_that_end_about_when_they_are_told_leave_nothing_behind() -> None:
    """Forty calls as long as the limit: each answers or is ended, and nothing is raised later."""
    limit = TimeLimit(0.05)

    def takes(seconds: float) -> str:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            pass
        return "done"

    for k in range(40):
        try:
            assert limit.call(takes, 0.05 + 0.002 * k) == "done"
        except NoAnswerError:
            continue
        sum(range(100_000))


def test_profiler_still_works_after_calls_that_were_in_time_and_late() -> None:
    """CPython 3.11 hangs in a profiled function while it believes that an exception is to come."""
    limit = TimeLimit(0.05)
    with pytest.raises(NoAnswerError):
        limit.call(spins)
    limit.call(divmod, 7, 2)
    seen = []
    sys.setprofile(lambda *told: seen.append(told[1]))
    try:
        "".join(map(str, (n for n in range(3))))
    finally:
        sys.setprofile(None)
    assert "call" in seen


def test_call_inside_a_call_is_a_part_of_it() -> None:
    """It ends no earlier, and the outer one is ended all the same."""
    limit = TimeLimit(0.1)
    assert limit.call(lambda: limit.call(divmod, 7, 2)) == (3, 1)

    def outer() -> None:
        limit.call(divmod, 7, 2)
        while True:
            pass

    with pytest.raises(NoAnswerError):
        limit.call(outer)

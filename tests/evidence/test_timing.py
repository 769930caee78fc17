"""Times in turns: who is called how often, and how long a batch is; no time is asserted."""

from __future__ import annotations

import gc
from collections.abc import Callable

import pytest

from lesson_code.evidence import timing
from lesson_code.evidence.timing import Seconds, in_turns, steps_of_a_batch, timed


def job(called: list[str], name: str, seconds: float) -> Callable[[], float]:
    """Return a job that writes down its name and says how long it took."""

    def work() -> float:
        called.append(name)
        return seconds

    return work


def test_jobs_take_turns() -> None:
    """Round by round, so that what disturbs the machine meets all alike."""
    called: list[str] = []
    times = in_turns({name: job(called, name, 1.0) for name in "ab"}, 2)
    assert called == ["a", "b", "a", "b"]
    assert times == {"a": [1.0, 1.0], "b": [1.0, 1.0]}


def test_long_job_is_called_once() -> None:
    """Longer than is asked for; a short one is called in each round."""
    called: list[str] = []
    jobs = {"long": job(called, "long", 3.0), "short": job(called, "short", 2.0)}
    assert in_turns(jobs, 3, patience=2.0) == {"long": [3.0], "short": [2.0, 2.0, 2.0]}


def test_nothing_is_thrown_away_while_time_is_taken() -> None:
    """And the collector works again afterwards, also where the work fails."""
    seen: list[bool] = []
    taken = timed(lambda: seen.append(gc.isenabled()))
    assert (seen, gc.isenabled()) == ([False], True)
    assert min(taken) >= 0.0
    with pytest.raises(ZeroDivisionError):
        timed(lambda: 1 / 0)
    assert gc.isenabled()


class Counting:
    """An engine that only counts its steps."""

    steps = 0

    def advance(self, steps: int) -> None:
        """Count."""
        self.steps += steps


@pytest.mark.parametrize(("most", "least", "expected"), [(1_000, 1, 64), (40, 1, 40), (99, 80, 80)])
def test_batch_is_as_long_as_is_asked_for(
    monkeypatch: pytest.MonkeyPatch, most: int, least: int, expected: int
) -> None:
    """At 1 ms a step 64 are the first power of two beyond half of 0.1 s; or as many as allowed."""
    engine = Counting()

    def by_steps(work: Callable[[], object]) -> Seconds:
        before = engine.steps
        work()
        return Seconds(*[1e-3 * (engine.steps - before)] * 2)

    monkeypatch.setattr(timing, "timed", by_steps)
    assert steps_of_a_batch(engine, 0.1, most, least) == expected

"""The queue of events: the earliest wins, whatever has changed."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.event_driven.queue import enter_event, queue_for
from lesson_code.engine.event_driven.rows import EventRow

times = st.floats(0, 10) | st.sampled_from([1.0, 2.0, math.inf])


def empty_queue(discs: int) -> list[EventRow]:
    """Return a queue as rows."""
    return [EventRow(*values) for values in queue_for(discs).tolist()]


def queue_of(event_times: list[float]) -> list[EventRow]:
    """Return a queue of discs with these events."""
    queue = empty_queue(len(event_times))
    for i, time in enumerate(event_times):
        enter_event(queue, i, time)
    return queue


def drained(queue: list[EventRow]) -> list[int]:
    """Return the discs in the order in which their events come first; none has an event after."""
    order = []
    while queue[1].time < math.inf:
        order.append(queue[1].disc)
        enter_event(queue, order[-1], math.inf)
    return order


@given(st.lists(times, min_size=1, max_size=40))
def test_events_leave_the_queue_in_order(event_times: list[float]) -> None:
    """By time; at the same time by the discs' numbers: a rule, so that the bits are the same."""
    expected = [n for n in range(len(event_times)) if event_times[n] < math.inf]
    expected.sort(key=lambda n: (event_times[n], n))
    assert drained(queue_of(event_times)) == expected


@given(
    st.lists(times, min_size=1, max_size=20),
    st.lists(st.tuples(st.integers(0, 19), times), max_size=60),
)
def test_winner_of_the_queue_is_the_earliest_after_any_change(
    event_times: list[float], changes: list[tuple[int, float]]
) -> None:
    """Events may become earlier or later; every match is won by the earlier of its two."""
    queue, known = queue_of(event_times), list(event_times)
    for n, time in changes:
        known[n % len(known)] = time
        enter_event(queue, n % len(known), time)
        earliest = min(range(len(known)), key=lambda i: (known[i], i))
        assert (queue[1].disc, queue[1].time) == (earliest, known[earliest])
        for k in range(1, len(queue) // 2):
            pair = queue[2 * k], queue[2 * k + 1]
            first = min(pair, key=lambda row: row.time)
            assert (queue[k].disc, queue[k].time) == (first.disc, first.time)


def test_matches_of_four_events_worked_by_hand() -> None:
    """Discs 0 to 3 at 4, 2, 3 and 3 s: 1 beats 0, 2 beats 3 as the earlier disc, 1 wins."""
    queue = queue_of([4.0, 2.0, 3.0, 3.0])
    assert [row.disc for row in queue[1:]] == [1, 1, 2, 0, 1, 2, 3]
    assert [row.time for row in queue[1:]] == [2.0, 2.0, 3.0, 4.0, 2.0, 3.0, 3.0]


@pytest.mark.parametrize(("discs", "rows"), [(0, 2), (1, 2), (2, 4), (3, 8), (8, 16), (9, 32)])
def test_queue_has_an_entry_for_each_disc_and_nothing_happens_yet(discs: int, rows: int) -> None:
    """Twice the next power of two; a queue of no disc has a final that nobody wins."""
    queue = empty_queue(discs)
    assert len(queue) == rows
    assert {row.time for row in queue} == {math.inf}

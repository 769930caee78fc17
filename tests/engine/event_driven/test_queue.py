"""The queue of events: the earliest on top, whatever has changed."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.event_driven.queue import build, is_earlier, update
from lesson_code.engine.event_driven.rows import DiscRow
from lesson_code.engine.rows import IndexRow

times = st.floats(0, 10) | st.sampled_from([1.0, 2.0, math.inf])


def queue_of(event_times: list[float]) -> tuple[list[DiscRow], list[IndexRow]]:
    """Return discs with these events, and a queue of them."""
    discs = [DiscRow(event_time=time) for time in event_times]
    queue = [IndexRow(i) for i in range(len(discs))]
    build(discs, queue)
    return discs, queue


def drained(discs: list[DiscRow], queue: list[IndexRow]) -> list[int]:
    """Return the discs in the order in which they leave the queue; none has an event after."""
    order = []
    while discs[queue[0].index].event_time < math.inf:
        order.append(queue[0].index)
        discs[order[-1]].event_time = math.inf
        update(discs, queue, order[-1])
    return order


@given(st.lists(times, min_size=1, max_size=40))
def test_events_leave_the_queue_in_order(event_times: list[float]) -> None:
    """By time; at the same time by the discs' numbers."""
    expected = [n for n in range(len(event_times)) if event_times[n] < math.inf]
    expected.sort(key=lambda n: (event_times[n], n))
    assert drained(*queue_of(event_times)) == expected


@given(
    st.lists(times, min_size=1, max_size=20),
    st.lists(st.tuples(st.integers(0, 19), times), max_size=60),
)
def test_top_of_the_queue_is_the_earliest_after_any_change(
    event_times: list[float], changes: list[tuple[int, float]]
) -> None:
    """Events may become earlier or later; every disc knows its own place."""
    discs, queue = queue_of(event_times)
    for n, time in changes:
        disc = discs[n % len(discs)]
        disc.event_time = time
        update(discs, queue, n % len(discs))
        earliest = min(range(len(discs)), key=lambda i: (discs[i].event_time, i))
        assert queue[0].index == earliest
        assert [queue[disc.heap_place].index for disc in discs] == list(range(len(discs)))


def test_events_at_the_same_time_are_in_the_order_of_the_discs() -> None:
    """A rule, so that the same scene gives the same bits."""
    discs = [DiscRow(event_time=1.0), DiscRow(event_time=1.0), DiscRow(event_time=math.inf)]
    assert is_earlier(discs, 0, 1)
    assert not is_earlier(discs, 1, 0)
    assert is_earlier(discs, 1, 2)


def test_queue_of_one_disc_is_a_queue() -> None:
    """The smallest; that of no disc is empty and is never asked."""
    discs, queue = queue_of([3.0])
    update(discs, queue, 0)
    assert drained(discs, queue) == [0]
    build([], [])

"""The queue of events: a binary heap of discs, the one with the earliest event on top.

Each disc stands in it once, with the earliest of all its events, so that the queue never grows.
Events at the same time are served in the order of the discs' numbers.
"""

from __future__ import annotations

from lesson_code.engine.event_driven.rows import DiscRow
from lesson_code.engine.rows import IndexRow


def is_earlier(discs: list[DiscRow], i: int, j: int) -> bool:
    """Return whether disc i comes before disc j."""
    if discs[i].event_time != discs[j].event_time:
        return discs[i].event_time < discs[j].event_time
    return i < j


def build(discs: list[DiscRow], queue: list[IndexRow]) -> None:
    """Bring a queue in any order into the order of a heap."""
    for place in range(len(queue)):
        discs[queue[place].index].heap_place = place
    for place in range(len(queue) // 2 - 1, -1, -1):
        sift_down(discs, queue, place)


def update(discs: list[DiscRow], queue: list[IndexRow], i: int) -> None:
    """Bring a disc whose event has changed to its place."""
    sift_up(discs, queue, discs[i].heap_place)
    sift_down(discs, queue, discs[i].heap_place)


def sift_up(discs: list[DiscRow], queue: list[IndexRow], place: int) -> None:
    """Let the disc at a place rise until the one above it is earlier."""
    while place > 0:
        above = (place - 1) // 2
        if not is_earlier(discs, queue[place].index, queue[above].index):
            return
        swap(discs, queue, place, above)
        place = above


def sift_down(discs: list[DiscRow], queue: list[IndexRow], place: int) -> None:
    """Let the disc at a place sink until those below it are later."""
    while True:
        first = 2 * place + 1
        if first >= len(queue):
            return
        second = first + 1
        if second < len(queue) and is_earlier(discs, queue[second].index, queue[first].index):
            first = second
        if not is_earlier(discs, queue[first].index, queue[place].index):
            return
        swap(discs, queue, place, first)
        place = first


def swap(discs: list[DiscRow], queue: list[IndexRow], k: int, n: int) -> None:
    """Exchange two places of the queue."""
    queue[k].index, queue[n].index = queue[n].index, queue[k].index
    discs[queue[k].index].heap_place = k
    discs[queue[n].index].heap_place = n

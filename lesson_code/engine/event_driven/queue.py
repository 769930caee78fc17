"""The queue of events: a knock-out tournament, which the disc with the earliest event wins.

Row 1 is the final. The match in row k is between the winners of rows 2 k and 2 k + 1. The last half
of the rows are the entries, one for each disc in the order of their numbers: of two events at the
same time the left one, that of the earlier disc, wins.

When an event changes, only the matches between its entry and the final are played anew: for a
million discs these are 20.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.engine.compiled import new_table
from lesson_code.engine.event_driven.rows import EventRow


def queue_for(discs: int) -> Any:
    """Return a queue for `discs` discs, without any event yet, as an array of records."""
    entries = 1 << max(discs - 1, 0).bit_length()
    winners = np.zeros(2 * entries, dtype=np.int64)
    winners[entries : entries + discs] = np.arange(discs)
    round_of = entries
    while round_of > 1:
        winners[round_of // 2 : round_of] = winners[round_of : 2 * round_of : 2]
        round_of //= 2
    return new_table(EventRow, 2 * entries, disc=winners)


def enter_event(queue: list[EventRow], i: int, time: float) -> None:
    """Give a disc's event a time, s, and play its matches anew, as far as that changes a winner."""
    k = len(queue) // 2 + i
    queue[k].time = time
    while k > 1:
        k = k // 2
        left, right, winner = queue[2 * k], queue[2 * k + 1], queue[k]
        first = right if right.time < left.time else left
        if winner.disc == first.disc and winner.time == first.time:
            return
        winner.disc, winner.time = first.disc, first.time

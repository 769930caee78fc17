"""The impulses of a run so far, in one table that grows where it stands."""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.engine.compiled import write_numbers
from lesson_code.engine.core.columns import Floats

EVENT_NUMBERS = 10
"""Numbers of an impulse: those of :class:`lesson_code.engine.core.rows.ImpulseRow`."""


SPARE = 1.25
"""Times the rows that are wanted: the new length of a table that grows."""


class ImpulseTable:
    """A table of impulses, shape (K, 10).

    A pile of 3,000 discs has two million impulses in 5 s, which are 160 MB. To write them into new
    memory, or to copy them once more in the end, takes as long as to reckon them: so the system
    moves the table where it has to grow, without a copy.
    """

    def __init__(self) -> None:
        self._rows = np.empty((0, EVENT_NUMBERS))
        self._is_seen = False
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def add(self, table: Any) -> None:
        """Write down some rows: a list of ImpulseRow, or an array of such records."""
        count = self._count + len(table)
        if self._is_seen:
            self._rows, self._is_seen = self._rows[: self._count].copy(), False
        if count > len(self._rows):
            rows = int(SPARE * count)
            self._rows.resize((rows, EVENT_NUMBERS), refcheck=False)  # nobody has seen it
        write_numbers(table, self._rows[self._count : count])
        self._count = count

    def rows(self) -> Floats:
        """Return the impulses so far, shape (K, 10). What is added later is not in them."""
        self._is_seen = True
        return self._rows[: self._count]

    def forget_from(self, count: int) -> None:
        """Forget all but so many of the first impulses, none of which anybody has seen since."""
        self._count = count

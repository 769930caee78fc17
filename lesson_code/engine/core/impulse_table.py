"""The impulses of a run so far, written down as they come and made numbers when somebody looks."""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.engine.compiled import write_numbers
from lesson_code.engine.core.columns import Floats

EVENT_NUMBERS = 10
"""Numbers of an impulse: those of :class:`lesson_code.engine.core.rows.ImpulseRow`."""

NO_IMPULSES: Floats = np.empty((0, EVENT_NUMBERS))


class ImpulseTable:
    """A table of impulses, shape (K, 10).

    A pile of 3,000 discs has two million impulses in 5 s, which are 160 MB. To copy them takes as
    long as to reckon them, and few runs are asked for them. So the arrays that a program has
    filled are kept as they are.
    """

    def __init__(self) -> None:
        self._parts: list[Any] = []
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def add(self, table: Any) -> None:
        """Write down some rows: a list of ImpulseRow, or an array of such records or numbers.

        An array is kept, and must not be written to any more.
        """
        self._parts.append(table if isinstance(table, np.ndarray) else _numbers(table))
        self._count += len(table)

    def rows(self) -> Floats:
        """Return the impulses so far, shape (K, 10). What is added later is not in them."""
        if len(self._parts) != 1 or self._parts[0].dtype.names:
            numbers = np.empty((self._count, EVENT_NUMBERS))
            first = 0
            for part in self._parts:
                _write(part, numbers[first : first + len(part)])
                first += len(part)
            self._parts = [numbers]
        (whole,) = self._parts
        return np.asarray(whole)

    def forget_from(self, count: int) -> None:
        """Forget all but so many of the first impulses."""
        while self._count > count:
            last = self._parts.pop()
            self._count -= len(last)
            if self._count < count:
                self.add(last[: count - self._count])


def _numbers(rows: list[Any]) -> Floats:
    """Return rows as numbers."""
    numbers = np.empty((len(rows), EVENT_NUMBERS))
    write_numbers(rows, numbers)
    return numbers


def _write(part: Any, numbers: Floats) -> None:
    """Write a part of the table as numbers."""
    if part.dtype.names:
        write_numbers(part, numbers)
    else:
        numbers[:] = part

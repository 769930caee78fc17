"""Capacity of the tables: spare rows, so that no row is made while a step runs.

A stage that finds a table too small notes how many rows it wants, and the step is interrupted. The
table is lengthened, and the step resumes where it stopped.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lesson_code.engine.compiled.arrays import lengthened
from lesson_code.engine.core.broad_phase import most_pairs
from lesson_code.engine.core.rows import (
    ContactRow,
    ImpulseRow,
    IndexRow,
    MemoryRow,
    PairRow,
    RestingRow,
    World,
)

SPARE, LARGE_SPARE = 1.5, 1.1
"""Times the rows that are wanted: the new length, with room so that a table seldom grows. The
second is for large tables, whose rows vary less in proportion and cost more memory."""

LARGE = 10_000
"""Rows at which a table counts as large."""

FEWEST_ROWS = 16
"""Rows that a table grows to at least."""


def add_capacity(world: World) -> World:
    """Return the tables, each that was too small with the rows it needs and some to grow into.

    Raises
    ------
    ValueError
        The bodies overlap in so many pairs that no memory would hold them.
    """
    state = world.state
    refuse_heap(len(world.bodies), state.pairs_wanted)
    world = world._replace(
        pairs=longer(world.pairs, state.pairs_wanted, PairRow),
        sorted_pairs=longer(world.sorted_pairs, state.pairs_wanted, PairRow),
        contacts=longer(world.contacts, state.contacts_wanted, ContactRow),
        visits=longer(world.visits, state.contacts_wanted, IndexRow),
        static_contacts=longer(world.static_contacts, state.contacts_wanted, IndexRow),
        memory=longer(world.memory, state.contacts_wanted, MemoryRow),
        resting=longer(world.resting, state.contacts_wanted, RestingRow),
        impulses=longer(world.impulses, state.impulses_wanted, ImpulseRow, is_read=True),
    )
    state.pairs_wanted = state.contacts_wanted = state.impulses_wanted = 0
    return world


def refuse_heap(bodies: int, pairs: int) -> None:
    """Raise a ValueError if there are too many candidate pairs for the number of bodies."""
    if pairs > most_pairs(bodies):
        raise ValueError(
            "bodies must not be heaped into one another: "
            f"{bodies} of them overlap in {pairs} pairs or more"
        )


def rows_for(wanted: int) -> int:
    """Return the new length of a table in which `wanted` rows are needed."""
    if wanted == 0:
        return 0
    return max(FEWEST_ROWS, int((SPARE if wanted < LARGE else LARGE_SPARE) * wanted))


def longer(table: Any, wanted: int, row: type, *, is_read: bool = False) -> Any:
    """Return a table with the rows that are wanted: the same list, or another array.

    Of one that has been read nothing is copied.
    """
    missing = rows_for(wanted) - len(table)
    if missing <= 0:
        return table
    if isinstance(table, np.ndarray):
        return lengthened(table[:0] if is_read else table, len(table) + missing)
    table += [row() for _ in range(missing)]
    return table

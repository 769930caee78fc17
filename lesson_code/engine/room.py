"""Room in the tables: spare rows, so that no row is made while a step runs.

A stage that finds a table too small says how many rows it wants, and the step is interrupted. Then
room is made, and the step goes on where it was.
"""

from __future__ import annotations

from typing import Any

from lesson_code.engine.broad_phase import most_pairs
from lesson_code.engine.rows import ContactRow, ImpulseRow, MemoryRow, PairRow, World

SPARE = 1.5
"""Times the rows that are wanted: how many there are then, so that a table seldom grows."""

FEWEST_ROWS = 16
"""Rows that a table grows to at least."""


def make_room(world: World) -> None:
    """Let each table that was too small hold what it is to hold, with room to grow into.

    Raises
    ------
    ValueError
        The bodies overlap in so many pairs that no memory would hold them.
    """
    state = world.state
    refuse_heap(len(world.bodies), state.pairs_wanted)
    lengthen(world.pairs, state.pairs_wanted, PairRow)
    lengthen(world.sorted_pairs, state.pairs_wanted, PairRow)
    lengthen(world.contacts, state.contacts_wanted, ContactRow)
    lengthen(world.memory, state.contacts_wanted, MemoryRow)
    lengthen(world.impulses, state.impulses_wanted, ImpulseRow)
    state.pairs_wanted = state.contacts_wanted = state.impulses_wanted = 0


def refuse_heap(bodies: int, pairs: int) -> None:
    """Raise a ValueError if so many bodies have too many candidate pairs."""
    if pairs > most_pairs(bodies):
        raise ValueError(
            "bodies must not be heaped into one another: "
            f"{bodies} of them overlap in {pairs} pairs or more"
        )


def rows_for(wanted: int) -> int:
    """Return how many rows a table gets when so many are wanted."""
    return max(FEWEST_ROWS, int(SPARE * wanted)) if wanted > 0 else 0


def lengthen(table: list[Any], wanted: int, row: type) -> None:
    """Let a table hold the rows that are wanted."""
    table.extend(row() for _ in range(rows_for(wanted) - len(table)))

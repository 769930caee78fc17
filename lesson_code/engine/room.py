"""Room in the tables: lists of spare rows, so that no row is made while a step runs."""

from __future__ import annotations

from lesson_code.engine.rows import ContactRow, MemoryRow, PairRow, World

POINTS_PER_PAIR = 2
"""Contact points that two convex shapes have at most."""


def make_room(world: World, pairs: int) -> None:
    """Let the tables hold at least so many pairs and their contacts, with room to grow into."""
    missing = 2 * pairs - len(world.pairs)
    world.pairs.extend(PairRow() for _ in range(missing))
    world.sorted_pairs.extend(PairRow() for _ in range(missing))
    world.contacts.extend(ContactRow() for _ in range(POINTS_PER_PAIR * missing))
    world.memory.extend(MemoryRow() for _ in range(POINTS_PER_PAIR * missing))

"""The grid: which discs and obstacles are near a disc.

A cell is as wide as the largest disc, so that a disc can only touch those in its own cell and the
eight around it. To leave the cell is an event; then the neighbours are others. Obstacles are
noted in every cell from which a disc could touch them. Beyond everything that was there at the
start the outermost cells go on for ever, so that a disc that flies away crosses no more borders.
"""

from __future__ import annotations

from lesson_code.engine.core.broad_phase import slot_of
from lesson_code.engine.event_driven.rows import DiscRow, ExactState, SlotRow, Tables


def slot_under(tables: Tables, disc: DiscRow) -> SlotRow:
    """Return the slot of a disc's cell."""
    return tables.slots[slot_of(tables.state, disc.cell_x, disc.cell_y)]


def put_into_slot(tables: Tables, i: int) -> None:
    """Put a disc before the others in the slot of its cell."""
    disc = tables.discs[i]
    slot = slot_under(tables, disc)
    disc.next_in_slot = slot.first_disc
    slot.first_disc = i


def leave_cell(tables: Tables, i: int) -> None:
    """Take a disc out of its cell."""
    disc = tables.discs[i]
    slot = slot_under(tables, disc)
    if slot.first_disc == i:
        slot.first_disc = disc.next_in_slot
        return
    before = tables.discs[slot.first_disc]
    while before.next_in_slot != i:
        before = tables.discs[before.next_in_slot]
    before.next_in_slot = disc.next_in_slot


def cross_border(tables: Tables, i: int, side: int) -> None:
    """Move a disc that has reached a border of its cell to the next one.

    The sides are 0 right, 1 left, 2 up, 3 down. The cell is told by the side and not by the
    place, which lies on the border and may be rounded to either cell.
    """
    disc = tables.discs[i]
    leave_cell(tables, i)
    if side == 0:
        disc.cell_x += 1
    elif side == 1:
        disc.cell_x -= 1
    elif side == 2:
        disc.cell_y += 1
    else:
        disc.cell_y -= 1
    put_into_slot(tables, i)


def is_endless(state: ExactState, disc: DiscRow, side: int) -> bool:
    """Return whether a disc's cell has no border on a side."""
    if side == 0:
        return disc.cell_x == state.last_x
    if side == 1:
        return disc.cell_x == state.first_x
    if side == 2:
        return disc.cell_y == state.last_y
    return disc.cell_y == state.first_y


def border_gap(state: ExactState, disc: DiscRow, side: int, x: float, y: float) -> float:
    """Return how far a disc's centre, which is at (x, y), is inside a border of its cell, m."""
    size = state.cell_size
    if side == 0:
        return (disc.cell_x + 1) * size - x
    if side == 1:
        return x - disc.cell_x * size
    if side == 2:
        return (disc.cell_y + 1) * size - y
    return y - disc.cell_y * size

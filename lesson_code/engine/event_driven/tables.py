"""From a scene to the tables of the event-driven solver."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np

from lesson_code.engine.compiled import full_rows, new_table
from lesson_code.engine.core.broad_phase import row_stride_for, slot_of, slots_for
from lesson_code.engine.core.columns import Floats
from lesson_code.engine.core.constants import LAST_CELL
from lesson_code.engine.core.mixing import RULES, MixingRule
from lesson_code.engine.core.neighbours import HIGH, LEFT, LOW, RIGHT, sides_of
from lesson_code.engine.core.rows import ContactRow, IndexRow
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.tables import outlined_bodies
from lesson_code.engine.event_driven.constants import (
    CELL_MARGIN,
    GRIPS,
    HOP,
    MOST_CELLS,
    PILE_HOPS,
    REST,
    SLOW,
    STILL,
)
from lesson_code.engine.event_driven.queue import queue_for
from lesson_code.engine.event_driven.rows import DiscRow, ExactState, NearRow, SlotRow, Tables

OF_A_BODY = (
    *("inv_m", "inv_i", "radius", "restitution", "friction"),
    *("x", "y", "angle", "vx", "vy", "w"),
)
"""The fields that the row of a disc has in common with that of a body."""


def tables_of(scene: Scene, combine: MixingRule, has_grid: bool = False) -> Tables:
    """Return the tables of a scene as lists of rows, its discs where they begin.

    Without a grid they are all in one cell.
    """
    return full_rows(exact_arrays_of(scene, combine, has_grid))


def exact_arrays_of(scene: Scene, combine: MixingRule, has_grid: bool = False) -> Tables:
    """Return the same tables, the long ones as arrays with all fields."""
    bodies, corners = outlined_bodies(scene)
    is_free = scene.columns.is_free
    free, fixed = np.flatnonzero(is_free), np.flatnonzero(~is_free)
    state = _state(scene, combine, has_grid)
    discs, obstacles = bodies[free], bodies[fixed]
    slots = new_table(SlotRow, state.slot_count)
    near: list[NearRow] = []
    everywhere = [IndexRow(k) for k in range(len(fixed))]
    if has_grid:
        boxes = sides_of(bodies, corners)[:, fixed]
        _bound_grid(state, np.array([discs["x"], discs["y"]] * 2), boxes)
        near, everywhere = _obstacles_near(state, boxes, scene.columns.is_moving[fixed], slots)
    return Tables(
        state=state,
        discs=_discs(state, discs, free, slots),
        obstacles=obstacles,
        obstacle_bodies=new_table(IndexRow, len(fixed), index=fixed),
        corners=corners,
        queue=queue_for(len(free)),
        slots=slots,
        near=near,
        everywhere=everywhere,
        contact=ContactRow(),
        impulses=[],
        moments=[],
        positions=[],
        velocities=[],
        angles=[],
        spins=[],
    )


def _discs(state: ExactState, bodies: Any, numbers: Any, slots: Any) -> Any:
    """Return the table of the discs, which fall freely, each noted in the slot of its cell.

    In a slot each comes before those with a smaller number.
    """
    size = state.cell_size
    cell_x = np.clip(np.floor(bodies["x"] / size), state.first_x, state.last_x).astype(np.int64)
    cell_y = np.clip(np.floor(bodies["y"] / size), state.first_y, state.last_y).astype(np.int64)
    slot: Any = slot_of(state, cell_x, cell_y)
    order = np.argsort(slot, kind="stable")
    is_same = slot[order[1:]] == slot[order[:-1]]
    behind = np.full(len(slot), -1)
    behind[order[1:][is_same]] = order[:-1][is_same]
    is_last = np.append(~is_same, True)[: len(slot)]
    slots["first_disc"][slot[order[is_last]]] = order[is_last]
    return new_table(
        DiscRow,
        len(numbers),
        body=numbers,
        ax=state.gravity_x,
        ay=state.gravity_y,
        cell_x=cell_x,
        cell_y=cell_y,
        next_in_slot=behind,
        **{name: bodies[name] for name in OF_A_BODY},
    )


def _state(scene: Scene, combine: MixingRule, has_grid: bool) -> ExactState:
    """Return the settings, the small speeds in proportion to those of the scene."""
    c = scene.columns
    radii = c.bounding_radius[c.is_free]
    largest = float(radii.max()) if radii.size else 1.0
    slots = slots_for(len(radii))
    gravity = math.hypot(*scene.gravity)
    falling = math.sqrt(gravity * largest)
    hop_time = 2 * HOP * falling / (gravity or 1.0)
    speed = max([falling, *map(math.hypot, c.vx.tolist(), c.vy.tolist())])
    return ExactState(
        gravity_x=scene.gravity[0],
        gravity_y=scene.gravity[1],
        slot_count=slots,
        row_stride=row_stride_for(slots),
        restitution_rule=RULES[combine.restitution],
        friction_rule=RULES[combine.friction],
        cell_size=2 * largest * (1 + CELL_MARGIN) if has_grid else math.inf,
        still=STILL * speed,
        rest=REST * speed,
        grips=GRIPS * speed,
        slow=SLOW * speed,
        hop=HOP * falling,
        window=hop_time,
        pile_time=PILE_HOPS * hop_time,
    )


def _bound_grid(state: ExactState, places: Floats, boxes: Floats) -> None:
    """Let the grid end one cell beyond all that is there at the start: places, boxes (4, N), m.

    Of what is as large as the walls of a room it has the near side only: nothing gets beyond.
    """
    with np.errstate(over="ignore"):
        wide, high = (boxes[[RIGHT, HIGH]] - boxes[[LEFT, LOW]]) / state.cell_size
        is_large = (wide + 1) * (high + 1) > MOST_CELLS
    sides = np.hstack([boxes[:, ~is_large], places])
    if sides.size == 0:
        return
    near = boxes[:, is_large][[RIGHT, HIGH, LEFT, LOW]]
    left, low, right, high = np.hstack([sides, near])[[LEFT, LOW, RIGHT, HIGH]]
    state.first_x, state.last_x = _cell(state, left.min()) - 1, _cell(state, right.max()) + 1
    state.first_y, state.last_y = _cell(state, low.min()) - 1, _cell(state, high.max()) + 1


def _cell(state: ExactState, place: float) -> int:
    """Return the number of the cell of a coordinate, m; the last one goes on for ever."""
    return math.floor(min(max(place / state.cell_size, -LAST_CELL), LAST_CELL))


def _cells(state: ExactState, low: float, high: float, first: int, last: int) -> range:
    """Return the cells from which a disc could touch what reaches from `low` to `high`, m."""
    ends = _cell(state, low) - 1, _cell(state, high) + 1
    begin, end = (min(max(cell, first), last) for cell in ends)
    return range(begin, end + 1)


def _obstacles_near(
    state: ExactState, sides: Floats, is_moving: Any, slots: Any
) -> tuple[list[NearRow], list[IndexRow]]:
    """Return the obstacles noted in each cell from which a disc could touch them, and the others.

    Those are near everywhere: they move, or would be noted in too many cells.
    """
    near: list[NearRow] = []
    everywhere: list[IndexRow] = []
    first: dict[int, int] = {}
    for k, (left, low, right, high) in enumerate(sides.T.tolist()):
        if is_moving[k]:
            everywhere.append(IndexRow(k))
            continue
        columns = _cells(state, left, right, state.first_x, state.last_x)
        lines = _cells(state, low, high, state.first_y, state.last_y)
        if len(columns) * len(lines) > MOST_CELLS:
            everywhere.append(IndexRow(k))
            continue
        for cell_x, cell_y in product(columns, lines):
            slot = slot_of(state, cell_x, cell_y)
            near.append(NearRow(k, cell_x, cell_y, first.get(slot, -1)))
            first[slot] = len(near) - 1
    slots["first_near"][list(first)] = list(first.values())
    return near, everywhere

"""Foretelling: the next event of one disc, out of everything that could happen to it."""

from __future__ import annotations

import math

from lesson_code.engine.broad_phase import slot_of
from lesson_code.engine.event_driven.cells import border_gap, is_endless
from lesson_code.engine.event_driven.motion import place_at, seen_from, velocity_at
from lesson_code.engine.event_driven.queue import enter_event
from lesson_code.engine.event_driven.rows import (
    CELL,
    DISC,
    END,
    GRIP,
    NOTHING,
    OBSTACLE,
    DiscRow,
    ExactState,
    SlotRow,
    Tables,
)
from lesson_code.engine.event_driven.support import grip_time, time_to_end
from lesson_code.geometry.impact_times import (
    circle_impact_time,
    circle_outline_impact_time,
    line_impact_time,
)


def foretell(tables: Tables, i: int) -> None:
    """Find the next event of a disc that lives in the present, and queue it."""
    state, disc = tables.state, tables.discs[i]
    disc.event_time, disc.event_kind, disc.partner = math.inf, NOTHING, -1
    if not disc.held:
        if disc.support >= 0:
            note(state, disc, grip_time(tables, disc), GRIP, disc.support, 0)
            note(state, disc, time_to_end(tables, disc), END, disc.support, disc.face)
        foretell_border(state, disc)
        first_near = tables.slots[slot_of(state, disc.cell_x, disc.cell_y)].first_near
        if first_near >= 0 or len(tables.everywhere) > 0:
            foretell_obstacles(tables, disc, first_near)
    foretell_discs(state, tables.discs, tables.slots, i)
    enter_event(tables.queue, i, disc.event_time)


def note(
    state: ExactState, disc: DiscRow, after: float, kind: int, partner: int, feature: int
) -> None:
    """Take an event for the next one if it comes before the one known so far; `after` in s."""
    time = state.now + after
    if time < disc.event_time:
        disc.event_time, disc.event_kind = time, kind
        disc.partner, disc.feature = partner, feature


def foretell_border(state: ExactState, disc: DiscRow) -> None:
    """Find when the disc's centre leaves its cell, and on which side."""
    for side in range(4):
        if not is_endless(state, disc, side):
            gap = border_gap(state, disc, side)
            if side == 0:
                after = line_impact_time(gap, -disc.vx, -disc.ax)
            elif side == 1:
                after = line_impact_time(gap, disc.vx, disc.ax)
            elif side == 2:
                after = line_impact_time(gap, -disc.vy, -disc.ay)
            else:
                after = line_impact_time(gap, disc.vy, disc.ay)
            note(state, disc, after, CELL, -1, side)


def foretell_discs(state: ExactState, discs: list[DiscRow], slots: list[SlotRow], i: int) -> None:
    """Find the first hit with a disc in the cells around."""
    disc = discs[i]
    around = 0 if math.isinf(state.cell_size) else 1
    for cell_x in range(disc.cell_x - around, disc.cell_x + around + 1):
        for cell_y in range(disc.cell_y - around, disc.cell_y + around + 1):
            j = slots[slot_of(state, cell_x, cell_y)].first_disc
            while j >= 0:
                other = discs[j]
                if j != i and other.cell_x == cell_x and other.cell_y == cell_y:
                    note_disc(state, disc, other, j)
                j = other.next_in_slot


def note_disc(state: ExactState, disc: DiscRow, other: DiscRow, j: int) -> None:
    """Take the hit with disc j for the next event, if it comes before; of several the first disc's.

    So the order does not depend on the order in which the grid happens to hold the discs.
    """
    time = state.now + time_to_hit(state, disc, other)
    is_tie = time == disc.event_time and disc.event_kind == DISC and j < disc.partner
    if time < disc.event_time or is_tie:
        disc.event_time, disc.event_kind = time, DISC
        disc.partner, disc.feature = j, 0
        disc.partner_changes = other.changes


def time_to_hit(state: ExactState, disc: DiscRow, other: DiscRow) -> float:
    """Return when two discs hit, s from now; ``math.inf``: never as they move."""
    x, y = place_at(other, state.now)
    vx, vy = velocity_at(other, state.now)
    return impact_after(
        state,
        (
            x - disc.x,
            y - disc.y,
            vx - disc.vx,
            vy - disc.vy,
            other.ax - disc.ax,
            other.ay - disc.ay,
        ),
        disc.radius + other.radius,
    )


def impact_after(
    state: ExactState, relative: tuple[float, float, float, float, float, float], reach: float
) -> float:
    """Return when two circles hit; those that touch and approach no faster than rounding do not."""
    dx, dy, vx, vy, ax, ay = relative
    after = circle_impact_time(dx, dy, vx, vy, ax, ay, reach)
    if after == 0.0:
        distance = math.sqrt(dx * dx + dy * dy)
        approaches = dx * vx + dy * vy < -state.still * distance
        is_pressed = dx * ax + dy * ay + vx * vx + vy * vy < 0.0
        if not (approaches or is_pressed):
            return math.inf
    return after


def foretell_obstacles(tables: Tables, disc: DiscRow, first_near: int) -> None:
    """Find the first hit with an obstacle near the disc; the one it rests on is none."""
    n = first_near
    while n >= 0:
        near = tables.near[n]
        if near.cell_x == disc.cell_x and near.cell_y == disc.cell_y:
            foretell_obstacle(tables, disc, near.obstacle)
        n = near.next_in_slot
    for row in tables.everywhere:
        foretell_obstacle(tables, disc, row.index)


def foretell_obstacle(tables: Tables, disc: DiscRow, k: int) -> None:
    """Find when the disc hits one obstacle."""
    if k == disc.support:
        return
    state, obstacle = tables.state, tables.obstacles[k]
    dx, dy = seen_from(obstacle, disc, state.now)
    vx, vy = disc.vx - obstacle.vx, disc.vy - obstacle.vy
    if obstacle.corner_count == 0:
        reach = disc.radius + obstacle.radius
        after = impact_after(state, (dx, dy, vx, vy, disc.ax, disc.ay), reach)
        note(state, disc, after, OBSTACLE, k, 0)
        return
    after, feature = circle_outline_impact_time(
        tables.corners, obstacle, dx, dy, vx, vy, disc.ax, disc.ay, disc.radius
    )
    note(state, disc, after, OBSTACLE, k, feature)

"""Event prediction: the next event of one disc, out of everything that could happen to it.

What will happen is worked out from the moment since which the disc, or the later of two, has
moved as it does now. So it is the same to the last bit whenever it is worked out, and for
whichever of the two. The grid therefore leaves no trace in a run; nor do events that turn out to
be stale. The next border of the grid is kept apart from the rest: a disc that crosses it only has
to look into the cells that have come near.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.broad_phase import slot_of
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.event_driven.cells import border_gap, is_endless
from lesson_code.engine.event_driven.motion import place_at, seen_from, velocity_at
from lesson_code.engine.event_driven.queue import enter_event
from lesson_code.engine.event_driven.rows import (
    DISC,
    END,
    GRIP,
    NOTHING,
    OBSTACLE,
    DiscRow,
    ExactState,
    Tables,
)
from lesson_code.engine.event_driven.support import grip_time, time_to_end
from lesson_code.geometry.impact_times import (
    circle_impact_time,
    circle_outline_impact_time,
    line_impact_time,
)
from lesson_code.geometry.straight_impact_times import (
    straight_face_time,
    straight_impact_time,
    straight_outline_impact_time,
)


def predict(tables: Tables, i: int, effects: Effects = EVERY_EFFECT) -> None:
    """Find the next event of a disc, and queue it."""
    state, disc = tables.state, tables.discs[i]
    disc.event_time, disc.event_kind, disc.partner = math.inf, NOTHING, -1
    disc.border_time = math.inf
    if effects.gravity and disc.support >= 0 and not disc.held:
        predict_end_of_rest(tables, disc, effects)
    if not (effects.gravity and disc.held):
        predict_border(state, disc, effects)
        predict_obstacles(tables, disc, effects)
    around = 0 if math.isinf(state.cell_size) else 1
    for cell_y in range(disc.cell_y - around, disc.cell_y + around + 1):
        for cell_x in range(disc.cell_x - around, disc.cell_x + around + 1):
            predict_discs(tables, i, cell_x, cell_y, effects)
    enter_event(tables.queue, i, min(disc.event_time, disc.border_time))


def predict_beyond(tables: Tables, i: int, side: int, effects: Effects = EVERY_EFFECT) -> None:
    """Add what has come near to a disc that has just left its cell by a side."""
    disc = tables.discs[i]
    disc.border_time = math.inf
    predict_border(tables.state, disc, effects)
    predict_obstacles(tables, disc, effects)
    ahead = 1 if side in (0, 2) else -1
    for beside in range(-1, 2):
        cell_x = disc.cell_x + (ahead if side < 2 else beside)
        cell_y = disc.cell_y + (beside if side < 2 else ahead)
        predict_discs(tables, i, cell_x, cell_y, effects)
    enter_event(tables.queue, i, min(disc.event_time, disc.border_time))


def note(disc: DiscRow, time: float, kind: int, partner: int, feature: int) -> bool:
    """Take an event for the next one if it comes before the one known so far; say whether.

    Of several at the same time the order of the kinds decides, then that of the partners: not the
    order in which they are found.
    """
    known = disc.event_time
    if time > known or math.isinf(time):
        return False
    if time == known and not comes_before(kind, partner, disc):
        return False
    disc.event_time, disc.event_kind = time, kind
    disc.partner, disc.feature = partner, feature
    return True


def comes_before(kind: int, partner: int, disc: DiscRow) -> bool:
    """Return whether an event comes before a disc's own one at the same time."""
    return kind < disc.event_kind or (kind == disc.event_kind and partner < disc.partner)


def predict_end_of_rest(tables: Tables, disc: DiscRow, effects: Effects) -> None:
    """Find when a disc on a face stops sliding, and when the face ends."""
    if effects.friction:
        note(disc, disc.time + grip_time(tables, disc, effects), GRIP, disc.support, 0)
    note(disc, disc.time + time_to_end(tables, disc), END, disc.support, disc.face)


def predict_border(state: ExactState, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> None:
    """Find when the disc's centre leaves its cell, and on which side."""
    x, y = place_at(disc, state.now, effects)
    vx, vy = velocity_at(disc, state.now, effects)
    for side in range(4):
        if not is_endless(state, disc, side):
            gap = border_gap(state, disc, side, x, y)
            outward = -1.0 if side in (0, 2) else 1.0
            speed = outward * (vx if side < 2 else vy)
            if effects.gravity:
                pull = outward * (disc.ax if side < 2 else disc.ay)
                time = state.now + line_impact_time(gap, speed, pull)
            else:
                time = state.now + straight_face_time(gap, speed)
            if time < disc.border_time:
                disc.border_time, disc.border_side = time, side


def predict_discs(tables: Tables, i: int, cell_x: int, cell_y: int, effects: Effects) -> None:
    """Find the first hit with a disc in a cell."""
    disc = tables.discs[i]
    j = tables.slots[slot_of(tables.state, cell_x, cell_y)].first_disc
    while j >= 0:
        other = tables.discs[j]
        if j != i and other.cell_x == cell_x and other.cell_y == cell_y:
            time = hit_time(tables.state, disc, other, effects)
            if note(disc, time, DISC, j, 0):
                disc.partner_changes = other.changes
        j = other.next_in_slot


def hit_time(
    state: ExactState, disc: DiscRow, other: DiscRow, effects: Effects = EVERY_EFFECT
) -> float:
    """Return when two discs hit, s; ``math.inf``: never as they move."""
    start = max(disc.time, other.time)
    x, y = place_at(disc, start, effects)
    other_x, other_y = place_at(other, start, effects)
    vx, vy = velocity_at(disc, start, effects)
    other_vx, other_vy = velocity_at(other, start, effects)
    relative = other_x - x, other_y - y, other_vx - vx, other_vy - vy
    radius_sum = disc.radius + other.radius
    if effects.gravity:
        pull = other.ax - disc.ax, other.ay - disc.ay
        return start + impact_after(state, relative, pull, radius_sum)
    return start + straight_impact_after(state, relative, radius_sum)


def impact_after(
    state: ExactState,
    relative: tuple[float, float, float, float],
    pull: tuple[float, float],
    radius_sum: float,
) -> float:
    """Return when two circles hit; those that touch and approach no faster than rounding do not."""
    (dx, dy, vx, vy), (ax, ay) = relative, pull
    after = circle_impact_time(dx, dy, vx, vy, ax, ay, radius_sum)
    if after == 0.0 and not approaches(state, relative):
        is_pressed = dx * ax + dy * ay + vx * vx + vy * vy < 0.0
        return 0.0 if is_pressed else math.inf
    return after


def straight_impact_after(
    state: ExactState, relative: tuple[float, float, float, float], radius_sum: float
) -> float:
    """Return the same for circles without acceleration: nothing presses them together."""
    dx, dy, vx, vy = relative
    after = straight_impact_time(dx, dy, vx, vy, radius_sum)
    return math.inf if after == 0.0 and not approaches(state, relative) else after


def approaches(state: ExactState, relative: tuple[float, float, float, float]) -> bool:
    """Return whether two circles approach faster than rounding."""
    dx, dy, vx, vy = relative
    return dx * vx + dy * vy < -state.still * math.sqrt(dx * dx + dy * dy)


def predict_obstacles(tables: Tables, disc: DiscRow, effects: Effects) -> None:
    """Find the first hit with an obstacle near the disc."""
    n = tables.slots[slot_of(tables.state, disc.cell_x, disc.cell_y)].first_near
    while n >= 0:
        near = tables.near[n]
        if near.cell_x == disc.cell_x and near.cell_y == disc.cell_y:
            predict_obstacle(tables, disc, near.obstacle, effects)
        n = near.next_in_slot
    for row in tables.everywhere:
        predict_obstacle(tables, disc, row.index, effects)


def predict_obstacle(tables: Tables, disc: DiscRow, k: int, effects: Effects) -> None:
    """Find when the disc hits one obstacle; the one that it rests on is none."""
    if effects.gravity and k == disc.support:
        return
    if effects.outlines and tables.obstacles[k].corner_count > 0:
        after, feature = outline_time(tables, disc, k, effects)
        note(disc, disc.time + after, OBSTACLE, k, feature)
    else:
        note(disc, disc.time + post_time(tables, disc, k, effects), OBSTACLE, k, 0)


def post_time(tables: Tables, disc: DiscRow, k: int, effects: Effects) -> float:
    """Return when the disc hits a circle that nothing can push, s from its own time."""
    obstacle = tables.obstacles[k]
    dx, dy = seen_from(obstacle, disc)
    relative = dx, dy, disc.vx - obstacle.vx, disc.vy - obstacle.vy
    radius_sum = disc.radius + obstacle.radius
    if effects.gravity:
        return impact_after(tables.state, relative, (disc.ax, disc.ay), radius_sum)
    return straight_impact_after(tables.state, relative, radius_sum)


def outline_time(tables: Tables, disc: DiscRow, k: int, effects: Effects) -> tuple[float, int]:
    """Return when the disc hits an obstacle with corners, s from its own time, and where."""
    obstacle, corners = tables.obstacles[k], tables.corners
    dx, dy = seen_from(obstacle, disc)
    vx, vy = disc.vx - obstacle.vx, disc.vy - obstacle.vy
    if effects.gravity:
        return circle_outline_impact_time(
            corners, obstacle, dx, dy, vx, vy, disc.ax, disc.ay, disc.radius
        )
    return straight_outline_impact_time(corners, obstacle, dx, dy, vx, vy, disc.radius)

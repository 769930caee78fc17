"""From a scene to the tables of the event-driven solver."""

from __future__ import annotations

import math

from lesson_code.engine.core.broad_phase import row_stride_for, slot_of, slots_for
from lesson_code.engine.core.mixing import RULES, MixingRule
from lesson_code.engine.core.rows import BodyRow, ContactRow, IndexRow
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.event_driven.cells import enter_cell
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
from lesson_code.engine.event_driven.support import let_go


def tables_of(scene: Scene, combine: MixingRule, has_grid: bool = False) -> Tables:
    """Return the tables of a scene, its discs where they begin; without a grid in one cell."""
    free = [n for n, body in enumerate(scene.bodies) if not body.is_static]
    fixed = [n for n, body in enumerate(scene.bodies) if body.is_static]
    world = world_of(scene, dt=1.0, iterations=0, combine=combine)  # its bodies, as rows
    discs = [_disc(n, world.bodies[n]) for n in free]
    slots = slots_for(len(discs))
    tables = Tables(
        state=_state(scene, combine, slots, has_grid),
        discs=discs,
        obstacles=[world.bodies[n] for n in fixed],
        obstacle_bodies=[IndexRow(n) for n in fixed],
        corners=world.corners,
        queue=queue_for(len(discs)),
        slots=[SlotRow() for _ in range(slots)],
        near=[],
        everywhere=[],
        contact=ContactRow(),
        impulses=[],
    )
    _bound_grid(tables)
    for i in range(len(discs)):
        let_go(tables.state, discs[i])
        enter_cell(tables, i)
    for k in range(len(fixed)):
        _note_obstacle(tables, k)
    return tables


def _disc(number: int, row: BodyRow) -> DiscRow:
    """Return the row of a disc from its row as a body."""
    return DiscRow(
        body=number,
        inv_m=row.inv_m,
        inv_i=row.inv_i,
        radius=row.radius,
        restitution=row.restitution,
        friction=row.friction,
        x=row.x,
        y=row.y,
        angle=row.angle,
        vx=row.vx,
        vy=row.vy,
        w=row.w,
    )


def _state(scene: Scene, combine: MixingRule, slots: int, has_grid: bool) -> ExactState:
    """Return the settings, the small speeds in proportion to those of the scene."""
    radii = [body.shape.bounding_radius for body in scene.bodies if not body.is_static]
    largest = max(radii, default=1.0)
    gravity = math.hypot(*scene.gravity)
    falling = math.sqrt(gravity * largest)
    hop_time = 2 * HOP * falling / (gravity or 1.0)
    speed = max([falling, *(math.hypot(*body.velocity) for body in scene.bodies)])
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


def _bound_grid(tables: Tables) -> None:
    """Let the grid end one cell beyond all that is there at the start."""
    state, size = tables.state, tables.state.cell_size
    boxes = [_box(tables, obstacle) for obstacle in tables.obstacles]
    boxes += [(disc.x, disc.x, disc.y, disc.y) for disc in tables.discs]
    if math.isinf(size) or not boxes:
        return
    left, right, low, high = zip(*boxes, strict=True)
    state.first_x, state.last_x = (
        math.floor(min(left) / size) - 1,
        math.floor(max(right) / size) + 1,
    )
    state.first_y, state.last_y = math.floor(min(low) / size) - 1, math.floor(max(high) / size) + 1


def _note_obstacle(tables: Tables, k: int) -> None:
    """Note an obstacle in all cells from which a disc could touch it, or as near everywhere."""
    obstacle, size = tables.obstacles[k], tables.state.cell_size
    if math.isinf(size):
        tables.everywhere.append(IndexRow(k))
        return
    left, right, low, high = _box(tables, obstacle)
    columns = range(math.floor(left / size) - 1, math.floor(right / size) + 2)
    lines = range(math.floor(low / size) - 1, math.floor(high / size) + 2)
    moves = obstacle.vx != 0.0 or obstacle.vy != 0.0
    if moves or len(columns) * len(lines) > MOST_CELLS:
        tables.everywhere.append(IndexRow(k))
        return
    for cell_x in columns:
        for cell_y in lines:
            slot = tables.slots[slot_of(tables.state, cell_x, cell_y)]
            tables.near.append(NearRow(k, cell_x, cell_y, slot.first_near))
            slot.first_near = len(tables.near) - 1


def _box(tables: Tables, obstacle: BodyRow) -> tuple[float, float, float, float]:
    """Return the sides of the box around an obstacle: left, right, low, high, m."""
    first = obstacle.first_corner
    corners = tables.corners[first : first + obstacle.corner_count]
    xs, ys = [c.x for c in corners] or [0.0], [c.y for c in corners] or [0.0]
    return (
        obstacle.x + min(xs) - obstacle.radius,
        obstacle.x + max(xs) + obstacle.radius,
        obstacle.y + min(ys) - obstacle.radius,
        obstacle.y + max(ys) + obstacle.radius,
    )

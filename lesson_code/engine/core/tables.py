"""From a scene to the tables of the engine."""

from __future__ import annotations

import math
import statistics

from lesson_code.engine.core.broad_phase import (
    all_pairs,
    row_stride_for,
    slots_for,
    sweep_and_prune,
    uniform_grid,
)
from lesson_code.engine.core.constants import (
    CELL_MARGIN,
    FEWEST_FOR_GRID,
    LARGEST_IN_GRID,
    MOST_MARGIN,
)
from lesson_code.engine.core.mixing import RULES, UNSPECIFIED, MixingRule
from lesson_code.engine.core.motion import turn_with_angle
from lesson_code.engine.core.pipeline import BroadPhase
from lesson_code.engine.core.rows import BodyRow, BoxRow, IndexRow, PlaceRow, State, World
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.effects.sleeping import is_static_and_moves
from lesson_code.geometry.rows import Corner, ManifoldRow, corner_rows
from lesson_code.geometry.shapes import Segment

BROAD_PHASES: dict[str, BroadPhase] = {
    "all_pairs": all_pairs,
    "sweep_and_prune": sweep_and_prune,
    "uniform_grid": uniform_grid,
}
"""The ways to find candidate pairs, by name."""


def world_of(
    scene: Scene, dt: float, iterations: int, combine: MixingRule, skin: float = 0.0
) -> World:
    """Return the tables of a scene, its bodies where they begin.

    Each body that can be pushed gets a skin of so many of its widths: contacts are seen before the
    bodies touch.

    Raises
    ------
    FloatingPointError
        A mass is so small that its inverse is no number.
    """
    corners: list[Corner] = []
    bodies = [_row(body, corners, skin) for body in scene.bodies]
    for number, row in enumerate(bodies):
        if not math.isfinite(row.inv_m + row.inv_i):
            raise FloatingPointError(f"body {number} has left the range of floating point")
    slots = slots_for(len(bodies))
    thinnest = min((_thickness(b) for b in scene.bodies if not b.is_static), default=math.inf)
    narrowest = min((row.min_width for row in bodies), default=math.inf)
    state = State(
        whole=dt,
        dt=dt,
        gravity_x=scene.gravity[0],
        gravity_y=scene.gravity[1],
        damping=scene.damping,
        iterations=iterations,
        restitution_rule=RULES[combine.restitution],
        friction_rule=RULES[combine.friction],
        cell_size=_cell_size(scene),
        slot_count=slots,
        row_stride=row_stride_for(slots),
        thinnest=thinnest,
        reach=skin * narrowest if skin > 0.0 else 0.5 * thinnest,
        skin=skin,
        free_count=sum(row.inv_m > 0.0 for row in bodies),
        has_moving_static=any(is_static_and_moves(row) for row in bodies),
    )
    world = World(
        state=state,
        bodies=bodies,
        corners=corners,
        pairs=[],
        sorted_pairs=[],
        places=[PlaceRow() for _ in bodies],
        order=[IndexRow(index) for index in range(len(bodies))],
        boxes=[BoxRow() for _ in bodies],
        slots=[IndexRow() for _ in range(slots + 1)],  # one more, for where the last one ends
        fixed_slots=[IndexRow() for _ in range(slots)],
        contacts=[],
        static_contacts=[],
        memory=[],
        resting=[],
        impulses=[],
        manifold=ManifoldRow(),
    )
    for body in bodies:
        turn_with_angle(world, body)
    return world


def broad_phase_for(scene: Scene) -> str:
    """Return the name of the broad phase that suits a scene: the grid, unless it is small."""
    return "all_pairs" if len(scene.bodies) < FEWEST_FOR_GRID else "uniform_grid"


def _row(body: Body, corners: list[Corner], skin: float) -> BodyRow:
    """Return a body's row, and add its outline to the corners."""
    thickness = 0.0 if body.is_static else skin * body.shape.min_width
    first = len(corners)
    corners += corner_rows(body.shape.outline)
    material = body.material
    return BodyRow(
        x=body.position[0],
        y=body.position[1],
        radius=body.shape.rounding + thickness,
        first_corner=first,
        corner_count=len(body.shape.outline),
        angle=body.angle,
        vx=body.velocity[0],
        vy=body.velocity[1],
        w=body.angular_velocity,
        inv_m=0.0 if body.mass is None else 1 / body.mass,
        inv_i=0.0 if body.inertia is None else 1 / body.inertia,
        restitution=UNSPECIFIED if material.restitution is None else material.restitution,
        friction=UNSPECIFIED if material.friction is None else material.friction,
        min_width=math.inf if body.is_static else body.shape.min_width,
        bounding_radius=body.shape.bounding_radius + thickness,
    )


def _thickness(body: Body) -> float:
    """Return the smallest width of a body's matter, m; a line has none."""
    return 2 * body.shape.radius if isinstance(body.shape, Segment) else body.shape.min_width


def _cell_size(scene: Scene) -> float:
    """Return the width of a grid cell, m: the largest box's, the few much larger ones left out."""
    sizes = [
        2 * body.shape.bounding_radius + 2 * MOST_MARGIN * body.shape.min_width
        for body in scene.bodies
    ]
    if not sizes:
        return 1.0
    limit = LARGEST_IN_GRID * statistics.median_low(sizes)
    return CELL_MARGIN * max(size for size in sizes if size <= limit)

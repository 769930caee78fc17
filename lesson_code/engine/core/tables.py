"""From a scene to the tables of the engine."""

from __future__ import annotations

import math
from collections.abc import Iterable
from operator import attrgetter
from typing import Any

import numpy as np

from lesson_code.engine.compiled import full_rows, new_table
from lesson_code.engine.core.broad_phase import (
    all_pairs,
    row_stride_for,
    slots_for,
    sweep_and_prune,
    uniform_grid,
)
from lesson_code.engine.core.columns import Columns, Floats
from lesson_code.engine.core.constants import (
    CELL_MARGIN,
    FEWEST_FOR_GRID,
    LARGEST_IN_GRID,
    MOST_COLOURS,
    MOST_MARGIN,
)
from lesson_code.engine.core.mixing import RULES, MixingRule
from lesson_code.engine.core.pipeline import BroadPhase
from lesson_code.engine.core.rows import (
    BodyRow,
    BoxRow,
    ColourRow,
    IndexRow,
    PlaceRow,
    State,
    World,
)
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.sight import NO_SKIN, Sight
from lesson_code.geometry.outline import Point
from lesson_code.geometry.rows import Corner, ManifoldRow, corner_rows

BROAD_PHASES: dict[str, BroadPhase] = {
    "all_pairs": all_pairs,
    "sweep_and_prune": sweep_and_prune,
    "uniform_grid": uniform_grid,
}
"""The ways to find candidate pairs, by name."""

local_values = attrgetter("local_x", "local_y", "local_nx", "local_ny")
"""Returns what of a corner does not change as its body turns."""


def world_of(
    scene: Scene, dt: float, iterations: int, combine: MixingRule, sight: Sight = NO_SKIN
) -> World:
    """Return the tables of a scene as lists of rows, its bodies where they begin.

    Each body that can be pushed gets a skin of so many of its widths: contacts are seen before the
    bodies touch. How far a body may move unwatched is given in widths, too.

    Raises
    ------
    FloatingPointError
        A mass is so small that its inverse is no number.
    """
    return full_rows(arrays_of(scene, dt, iterations, combine, sight))


def arrays_of(
    scene: Scene, dt: float, iterations: int, combine: MixingRule, sight: Sight = NO_SKIN
) -> World:
    """Return the same tables as arrays with all fields."""
    columns, (skin, reach) = scene.columns, sight
    bodies, corners = outlined_bodies(scene, skin)
    count, slots = len(columns), slots_for(len(columns))
    width, thickness = (c[columns.is_free] for c in (columns.min_width, columns.thickness))
    state = State(
        whole=dt,
        dt=dt,
        gravity_x=scene.gravity[0],
        gravity_y=scene.gravity[1],
        damping=scene.damping,
        iterations=iterations,
        restitution_rule=RULES[combine.restitution],
        friction_rule=RULES[combine.friction],
        cell_size=cell_size_for(columns, skin),
        slot_count=slots,
        row_stride=row_stride_for(slots),
        thinnest=_least(thickness),
        reach=_least(np.minimum(reach * width, skin * width + 0.5 * thickness)),
        skin=skin,
        free_count=int(columns.is_free.sum()),
        has_moving_static=columns.has_mover,
    )
    return World(
        state=state,
        bodies=bodies,
        corners=corners,
        pairs=[],
        sorted_pairs=[],
        places=new_table(PlaceRow, count),
        order=new_table(IndexRow, count, index=np.arange(count)),
        boxes=new_table(BoxRow, count),
        slots=new_table(IndexRow, slots + 1),  # one more, for where the last one ends
        fixed_slots=new_table(IndexRow, slots),
        contacts=[],
        visits=[],
        colours=new_table(ColourRow, 2 * MOST_COLOURS),
        static_contacts=[],
        memory=[],
        resting=[],
        impulses=[],
        positions=[],
        velocities=[],
        angles=[],
        spins=[],
        manifold=ManifoldRow(),
    )


def outlined_bodies(scene: Scene, skin: float = 0.0) -> tuple[Any, Any]:
    """Return the tables of bodies and of the corners of their outlines alone, as arrays."""
    bodies = _bodies(scene.columns, skin)
    if not bodies["corner_count"].any():
        return bodies, new_table(Corner, 0)
    return bodies, _corners([body.shape.outline for body in scene.bodies], bodies)


def broad_phase_for(scene: Scene) -> str:
    """Return the name of the broad phase that suits a scene: the grid, unless it is small."""
    return "all_pairs" if len(scene.bodies) < FEWEST_FOR_GRID else "uniform_grid"


def _bodies(c: Columns, skin: float) -> Any:
    """Return the table of bodies, turned to their angles."""
    thickness = np.where(c.is_free, skin * c.min_width, 0.0)
    with np.errstate(over="ignore"):
        inv_m, inv_i = 1 / c.mass, 1 / c.inertia
        is_number = np.isfinite(inv_m + inv_i)
    if not is_number.all():
        raise FloatingPointError(f"body {is_number.argmin()} has left the range of floating point")
    angles = c.angle.tolist()
    return new_table(
        BodyRow,
        len(c),
        x=c.x,
        y=c.y,
        radius=c.rounding + thickness,
        first_corner=np.cumsum(c.corner_count) - c.corner_count,
        corner_count=c.corner_count,
        angle=c.angle,
        cos=[math.cos(angle) for angle in angles],  # NumPy's may differ in the last bit
        sin=[math.sin(angle) for angle in angles],
        vx=c.vx + 0.0,  # not -0.0: a push of 0 would make it 0.0, once or four times at once
        vy=c.vy + 0.0,
        w=c.w + 0.0,
        inv_m=inv_m,
        inv_i=inv_i,
        restitution=c.restitution,
        friction=c.friction,
        min_width=np.where(c.is_free, c.min_width, math.inf),
        bounding_radius=c.bounding_radius + thickness,
    )


def _corners(outlines: Iterable[tuple[Point, ...]], bodies: Any) -> Any:
    """Return the corners of all outlines one after the other, each turned with its body."""
    seen: dict[tuple[Point, ...], list[tuple[float, ...]]] = {}
    local: list[tuple[float, ...]] = []
    for outline in outlines:
        if outline not in seen:
            seen[outline] = [local_values(corner) for corner in corner_rows(outline)]
        local += seen[outline]
    x, y, nx, ny = np.array(local, dtype=float).reshape(-1, 4).T
    cos, sin = (np.repeat(bodies[name], bodies["corner_count"]) for name in ("cos", "sin"))
    return new_table(
        Corner,
        len(local),
        local_x=x,
        local_y=y,
        local_nx=nx,
        local_ny=ny,
        x=cos * x - sin * y,
        y=sin * x + cos * y,
        nx=cos * nx - sin * ny,
        ny=sin * nx + cos * ny,
    )


def _least(widths: Floats) -> float:
    """Return the smallest of some widths, m; infinite where there are none."""
    return float(widths.min(initial=math.inf))


def cell_size_for(c: Columns, skin: float = 0.0) -> float:
    """Return the width of a grid cell, m: that of the largest box with its skin.

    The few bodies that are much larger are left out.
    """
    if not len(c):
        return 1.0
    sizes = np.sort(2 * c.bounding_radius + 2 * (MOST_MARGIN + skin) * c.min_width)
    limit = LARGEST_IN_GRID * sizes[(len(c) - 1) // 2]  # the median, or the lower of two
    return float(CELL_MARGIN * sizes[sizes <= limit][-1])

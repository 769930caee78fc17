"""From the plain numbers of a scene to the tables of the engine, as a program for pages does it.

A page writes what a scene says: ``world.js`` says how. Everything that follows from it is computed
here, by the functions that :mod:`lesson_code.engine.core.tables` and the shapes use.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.broad_phase import row_stride_for, slots_for, sort_along_x
from lesson_code.engine.core.constants import CELL_MARGIN, LARGEST_IN_GRID, MOST_MARGIN, REACH
from lesson_code.engine.core.motion import turn_with_angle
from lesson_code.engine.core.rows import BodyRow, World
from lesson_code.engine.core.scene import is_off_centre
from lesson_code.engine.effects.facts import room_of, thickness
from lesson_code.formulas.rigid_body import disc_inertia, polygon_inertia
from lesson_code.geometry.edges import outward_normal
from lesson_code.geometry.rows import Corner, following
from lesson_code.geometry.shapes import (
    centre_of,
    farthest,
    length_of,
    rod_inertia,
    smallest_width,
)

FAULTS = (
    "",
    "polygon must be convex, with its corners counter-clockwise",
    "segment with a mass must be centred on its body's position (end = -start)",
    "mass must be such that 1 / mass and 1 / inertia are numbers",
)
"""What can be wrong with a body, by the number that `set_up` returns."""

NO_FAULT, NOT_CONVEX, NOT_CENTRED, NO_INVERSE = range(4)


def set_up(world: World) -> int:
    """Compute what follows from the numbers of a scene; return what is wrong with a body, or 0.

    If something is, ``state.lost_body`` says with which. An inertia of 0 stands for that of the
    filled shape.
    """
    state, bodies, first = world.state, world.bodies, 0
    for k in range(len(bodies)):
        body = bodies[k]
        body.vx, body.vy, body.w = body.vx + 0.0, body.vy + 0.0, body.w + 0.0  # not -0.0
        bodies[k].first_corner = first
        first += bodies[k].corner_count
        fault = complete(world, bodies[k])
        if fault != NO_FAULT:
            state.lost_body = k
            return fault
        if bodies[k].inv_m > 0.0:
            state.free_count += 1
            state.thinnest = min(state.thinnest, thickness(bodies[k]))
            state.reach = min(state.reach, room_of(bodies[k], state.skin, REACH))
        elif bodies[k].vx != 0.0 or bodies[k].vy != 0.0 or bodies[k].w != 0.0:
            state.has_moving_static = True
    state.slot_count = slots_for(len(bodies))
    state.row_stride = row_stride_for(state.slot_count)
    state.cell_size = cell_size(world)
    for k in range(len(bodies)):
        if bodies[k].inv_m > 0.0:
            bodies[k].radius += state.skin * bodies[k].min_width
            bodies[k].bounding_radius += state.skin * bodies[k].min_width
        else:
            bodies[k].min_width = math.inf
    return NO_FAULT


def complete(world: World, body: BodyRow) -> int:
    """Compute a body's inverse masses, its widths and its outline; return what is wrong with it."""
    corners = world.corners
    outline = corners[body.first_corner : body.first_corner + body.corner_count]
    is_free = body.mass < math.inf
    per_mass = 0.0
    if body.corner_count == 0:
        per_mass = disc_inertia(1.0, body.radius)
        body.min_width = 2.0 * body.radius
        body.bounding_radius = body.radius
    elif body.corner_count == 2:
        if is_free and is_off_centre(outline):
            return NOT_CENTRED
        length = length_of(outline)
        per_mass = rod_inertia(length, body.radius)
        body.min_width = 2.0 * body.radius if body.radius > 0.0 else length
        body.bounding_radius = farthest(outline) + body.radius
    else:
        if not is_convex(corners, body):
            return NOT_CONVEX
        x, y = centre_of(outline)
        for k in range(body.first_corner, body.first_corner + body.corner_count):
            corners[k].local_x -= x
            corners[k].local_y -= y
        per_mass = polygon_inertia(1.0, outline)
        body.min_width = smallest_width(outline)
        body.bounding_radius = farthest(outline)
    face(corners, body)
    turn_with_angle(world, body)
    return invert(body, per_mass) if is_free else NO_FAULT


def invert(body: BodyRow, per_mass: float) -> int:
    """Compute 1 / mass and 1 / inertia; return what is wrong with them."""
    inertia = body.inertia if body.inertia > 0.0 else body.mass * per_mass
    if not (body.mass > 0.0 and inertia > 0.0):
        return NO_INVERSE
    body.inv_m, body.inv_i = 1.0 / body.mass, 1.0 / inertia
    return NO_FAULT if math.isfinite(body.inv_m + body.inv_i) else NO_INVERSE


def is_convex(corners: list[Corner], body: BodyRow) -> bool:
    """Return whether every corner lies to the left of every edge that it is no end of."""
    first, count = body.first_corner, body.corner_count
    for k in range(first, first + count):
        start, end = corners[k], corners[following(body, k)]
        along_x, along_y = end.local_x - start.local_x, end.local_y - start.local_y
        for n in range(2, count):
            other = corners[first + (k - first + n) % count]
            x, y = other.local_x - start.local_x, other.local_y - start.local_y
            if not along_x * y - along_y * x > 0.0:
                return False
    return True


def face(corners: list[Corner], body: BodyRow) -> None:
    """Compute the outward normals of an outline."""
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        start, end = corners[k], corners[following(body, k)]
        start.local_nx, start.local_ny = outward_normal(
            start.local_x, start.local_y, end.local_x, end.local_y
        )


def cell_size(world: World) -> float:
    """Return the width of a grid cell, m, as :mod:`lesson_code.engine.core.tables` does.

    Bodies are sorted by their sizes, which stand meanwhile for the left sides of their boxes.
    """
    bodies, order = world.bodies, world.order
    margin = MOST_MARGIN + world.state.skin
    if len(bodies) == 0:
        return 1.0
    for k in range(len(bodies)):
        order[k].index = k
        bodies[k].min_x = 2.0 * bodies[k].bounding_radius + 2.0 * margin * bodies[k].min_width
    sort_along_x(bodies, order)
    limit = LARGEST_IN_GRID * bodies[order[(len(bodies) - 1) // 2].index].min_x
    largest = 0.0
    for k in range(len(bodies)):
        if bodies[k].min_x <= limit:
            largest = max(largest, bodies[k].min_x)
        bodies[k].min_x = 0.0
        order[k].index = k
    return CELL_MARGIN * largest

"""A skin: contacts are seen a little before the bodies touch.

A corner that lies on a face is a contact whether rounding puts it a hair above the face or a hair
below. The narrow phase works with outlines that are rounded by the skin. What it finds is the
distance of the skins; that of the bodies is more by both, so that a penetration may be negative:
then it is a gap.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from lesson_code.engine.core.constants import LAST_DIGITS, NEAR
from lesson_code.engine.core.motion import turn_with_angle
from lesson_code.engine.core.narrow_phase import touch
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.effects.flags import EVERY_EFFECT

Place: TypeAlias = tuple[float, float, float]
"""x, y, m, and angle, rad."""

LOOKS_AHEAD = 64
"""Looks ahead at two bodies that touch and turn. A thin rod that whirls needs more: then the part
of the step ends where the last look was."""

LOOK_AGAIN = 0.25
"""Of the thinnest body: how far a corner may move between two looks, so that nothing is passed."""


def take_skins_off(world: World) -> None:
    """Let each contact tell of the bodies without their skins, and act on both at one point.

    An impulse and its opposite at one point leave no torque over. The point lies midway between
    the two surfaces, or on the one of the body that can be pushed: so that a disc rolls by its
    radius, however deep it lies in the floor.
    """
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        skin_a, skin_b = skin_of(world, a), skin_of(world, b)
        c.penetration -= skin_a + skin_b
        c.ax, c.ay = c.ax - skin_a * c.nx, c.ay - skin_a * c.ny
        c.bx, c.by = c.bx + skin_b * c.nx, c.by + skin_b * c.ny
        dx, dy = b.x - a.x, b.y - a.y
        of_b = 0.5 if a.inv_m > 0.0 and b.inv_m > 0.0 else (1.0 if b.inv_m > 0.0 else 0.0)
        c.ax += of_b * (dx + c.bx - c.ax)
        c.ay += of_b * (dy + c.by - c.ay)
        if of_b < 1.0:
            c.bx, c.by = c.ax - dx, c.ay - dy


def skin_of(world: World, body: BodyRow) -> float:
    """Return the thickness of a body's skin, m; one that nothing can push has none."""
    return world.state.skin * body.min_width if body.inv_m > 0.0 else 0.0


def gap_of(c: ContactRow) -> float:
    """Return the distance of two bodies at a contact, m; 0 if they touch or overlap."""
    return max(-c.penetration, 0.0)


def touching_gap(a: BodyRow, b: BodyRow) -> float:
    """Return how far apart two bodies are that touch, at the most, m."""
    places = abs(a.x) + abs(a.y) + abs(b.x) + abs(b.y)
    return NEAR * min(a.min_width, b.min_width) + LAST_DIGITS * places


def next_corner_time(
    world: World, a: BodyRow, b: BodyRow, duration: float, speed: float, depth: float
) -> float:
    """Return when two turning bodies that touch come to touch at another point, s.

    They are moved on by little at a time until a second point is seen, or they are deeper in each
    other by `depth`; then the time is halved in on.

    Parameters
    ----------
    world : World
        Its manifold is that of the bodies as they stand.
    a, b : BodyRow
        They are put back.
    duration : float
        How far to look, s.
    speed : float
        A bound for how fast any corner turns, m/s, > 0.
    depth : float
        m, > 0.

    Returns
    -------
    float
        s; ``math.inf`` if there is none. The end of the last look if there were too many.
    """
    count, before = world.manifold.count, deepest(world)
    look = max(LOOK_AGAIN * world.state.thinnest, depth) / speed
    place_a, place_b = place_of(a), place_of(b)
    safe, late = 0.0, math.inf
    for _ in range(LOOKS_AHEAD):
        if safe == duration or (late < math.inf and (late - safe) * speed < depth):
            break
        t = 0.5 * (safe + late) if late < math.inf else min(safe + look, duration)
        move_on(world, a, place_a, t)
        move_on(world, b, place_b, t)
        touch(world, a, b, EVERY_EFFECT)
        now = world.manifold.count
        if now > count or (now > 0 and deepest(world) > before + depth):
            late = t
        else:
            safe = t
    move_on(world, a, place_a, 0.0)
    move_on(world, b, place_b, 0.0)
    if late < math.inf:
        return late
    return safe if safe < duration else math.inf


def deepest(world: World) -> float:
    """Return the deeper penetration of the manifold, m."""
    m = world.manifold
    return max(m.penetration0, m.penetration1) if m.count == 2 else m.penetration0


def place_of(body: BodyRow) -> Place:
    """Return where a body is."""
    return body.x, body.y, body.angle


def move_on(world: World, body: BodyRow, place: Place, duration: float) -> None:
    """Put a body where it is a while after it was at a place."""
    x, y, angle = place
    body.x, body.y = x + body.vx * duration, y + body.vy * duration
    body.angle = angle + body.w * duration
    if body.corner_count > 0:
        turn_with_angle(world, body)

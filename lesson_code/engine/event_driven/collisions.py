"""Collisions: what happens at the instant when a disc hits a disc or an obstacle.

The impulses are those of every contact in this workbook: along the normal by Newton's rule, along
the tangent by Coulomb's. The rules at the end of a series of collisions are stated here:

- A disc that leaves a face slower than `rest`, and is pressed onto it, rests on it.
- A disc that rests on one face and comes to rest on a second one is held: it does not move.
- Discs that approach slower than `slow` lose no energy, so that a series of ever slower impacts
  ends, and they go on together but for that speed.
- In a pile under gravity, impacts slower than `hop` lose no energy, and discs that are pressed
  together without any speed part at `hop`. A disc is in a pile if it has just met another one.
"""

from __future__ import annotations

import math

from lesson_code.engine.combination import combined
from lesson_code.engine.contact_motion import (
    MovingBody,
    apply_impulse,
    mass_along,
    normal_of,
    tangent_of,
    velocity_along,
)
from lesson_code.engine.event_driven.constants import CLOCK, LEAST_HOP, LEAST_LOSS, PLACE
from lesson_code.engine.event_driven.motion import move_to, seen_from
from lesson_code.engine.event_driven.rows import DiscRow, ExactState, Tables
from lesson_code.engine.event_driven.support import let_go, motion_along_face, settle, ways_to_ends
from lesson_code.engine.rows import BodyRow, ContactRow
from lesson_code.formulas import contact
from lesson_code.formulas.arithmetic import dot
from lesson_code.formulas.validation import equation

normal_impulse = equation(contact.normal_impulse)
friction_impulse = equation(contact.friction_impulse)


def collide_discs(tables: Tables, i: int, j: int) -> None:
    """Let two discs that touch hit each other; the one earlier in the scene is a."""
    if tables.discs[i].body > tables.discs[j].body:
        i, j = j, i
    a, b, c = tables.discs[i], tables.discs[j], tables.contact
    move_to(a, tables.state.now)
    move_to(b, tables.state.now)
    c.a, c.b = a.body, b.body
    aim(c, b.x - a.x, b.y - a.y)
    c.ax, c.ay = c.nx * a.radius, c.ny * a.radius
    c.bx, c.by = -c.nx * b.radius, -c.ny * b.radius
    c.restitution = combined(tables.state.restitution_rule, a.restitution, b.restitution)
    c.friction = combined(tables.state.friction_rule, a.friction, b.friction)
    pressed = dot((b.ax - a.ax, b.ay - a.ay), normal_of(c)) < 0.0
    meet(tables.state, c, a, b, pressed)
    for disc in (a, b):
        let_go(tables.state, disc)
        disc.met = tables.state.now
        disc.changes += 1


def meet(state: ExactState, c: ContactRow, a: MovingBody, b: MovingBody, pressed: bool) -> None:
    """Give the impulses of an impact between two discs, or in a pile."""
    vn = velocity_along(c, a, b, normal_of(c))
    if vn <= -max(state.slow, state.hop):
        push(c, a, b, vn)
    elif vn <= -state.slow:  # in a pile, or so slow that it makes no difference
        least = LEAST_HOP * state.hop if pressed and c.restitution < 1.0 else 0.0
        part(c, a, b, vn, max(-vn, least))
    else:  # the end of a series
        part(c, a, b, vn, state.hop if pressed else abs(vn))


def collide_obstacle(tables: Tables, i: int, k: int, feature: int) -> None:
    """Let a disc hit an obstacle, at an edge or at a corner."""
    disc, obstacle, c = tables.discs[i], tables.obstacles[k], tables.contact
    move_to(disc, tables.state.now)
    c.a, c.b = tables.obstacle_bodies[k].index, disc.body
    aim_at_disc(tables, disc, k, feature)
    touch_with_rim(c, disc)
    c.restitution = combined(tables.state.restitution_rule, obstacle.restitution, disc.restitution)
    c.friction = combined(tables.state.friction_rule, obstacle.friction, disc.friction)
    vn = velocity_along(c, obstacle, disc, normal_of(c))
    rested, support, pull = disc.support >= 0, disc.support, (disc.ax, disc.ay)
    disc.changes += 1
    let_go(tables.state, disc)
    gravity = tables.state.gravity_x, tables.state.gravity_y
    pressing = -dot(gravity, normal_of(c))
    pressed = pressing > 0.0
    if tables.state.now - disc.met <= tables.state.pile_time:
        meet(tables.state, c, obstacle, disc, pressed)
    elif not (pressed and comes_to_rest(tables, disc, -c.restitution * vn, pressing)):
        push(c, obstacle, disc, vn)
    elif rested and support != k and dot(pull, normal_of(c)) <= 0.0:
        hold(disc, obstacle, k, feature)
    elif feature >= 0 and obstacle.corner_count > 0:
        push(c, obstacle, disc, vn)
        settle(tables, disc, k, feature)
        if is_leaving_face(tables, disc):
            leave_face(tables, disc)
    else:
        part(c, obstacle, disc, vn, tables.state.hop)


def comes_to_rest(tables: Tables, disc: DiscRow, speed: float, pressing: float) -> bool:
    """Return whether a bounce at a speed is so slow, low or short that it is only rounding."""
    if tables.contact.restitution == 1.0:
        size = abs(disc.x) + abs(disc.y) + disc.radius
        return speed * speed <= 2 * pressing * PLACE * size
    loss = max(1 - tables.contact.restitution, LEAST_LOSS)
    return speed <= tables.state.rest or speed * loss <= pressing * CLOCK * tables.state.now


def aim(c: ContactRow, dx: float, dy: float) -> None:
    """Set the normal of a contact to a direction; coincident centres have (1, 0).

    Rounding leaves its length off by a last digit, and on average too long where the distance is
    near a power of two: over 1e5 collisions energy would grow by 2e-12. So it is put right once.
    """
    distance = math.sqrt(dx * dx + dy * dy)
    if distance > 0.0:
        nx, ny = dx / distance, dy / distance
        long, short = (nx, ny) if abs(nx) > abs(ny) else (ny, nx)
        excess = (long - 1) * (long + 1) + short * short  # n . n - 1
        c.nx, c.ny = nx - nx * excess / 2, ny - ny * excess / 2
    else:
        c.nx, c.ny = 1.0, 0.0
    c.normal_impulse = 0.0
    c.tangent_impulse = 0.0


def aim_at_disc(tables: Tables, disc: DiscRow, k: int, feature: int) -> None:
    """Set the normal from an obstacle to a disc: a face's own, or away from centre or corner."""
    obstacle = tables.obstacles[k]
    dx, dy = seen_from(obstacle, disc, tables.state.now)
    if obstacle.corner_count == 0:
        aim(tables.contact, dx, dy)
    elif feature >= 0:
        aim(tables.contact, tables.corners[feature].nx, tables.corners[feature].ny)
    else:
        corner = tables.corners[-1 - feature]
        aim(tables.contact, dx - corner.x, dy - corner.y)


def touch_with_rim(c: ContactRow, disc: DiscRow) -> None:
    """Set the lever arms of a contact with an obstacle, which does not turn and needs none."""
    c.ax, c.ay = 0.0, 0.0
    c.bx, c.by = -c.nx * disc.radius, -c.ny * disc.radius


def push(c: ContactRow, a: MovingBody, b: MovingBody, vn: float) -> None:
    """Give the normal impulse and the friction of an impact."""
    jn = normal_impulse(vn, mass_along(c, a, b, normal_of(c)), c.restitution)
    vt = velocity_along(c, a, b, tangent_of(c))
    jt = friction_impulse(vt, mass_along(c, a, b, tangent_of(c)), c.friction, jn)
    apply_impulse(c, a, b, normal_of(c), jn)
    apply_impulse(c, a, b, tangent_of(c), jt)
    c.normal_impulse, c.tangent_impulse = jn, jt


def part(c: ContactRow, a: MovingBody, b: MovingBody, vn: float, speed: float) -> None:
    """Let two bodies that touch part at a speed, m/s."""
    jn = (speed - vn) * mass_along(c, a, b, normal_of(c))
    apply_impulse(c, a, b, normal_of(c), jn)
    c.normal_impulse, c.tangent_impulse = max(jn, 0.0), 0.0


def hold(disc: DiscRow, obstacle: BodyRow, k: int, feature: int) -> None:
    """Let a disc that lies on two faces stay there."""
    disc.vx, disc.vy = obstacle.vx, obstacle.vy
    disc.ax, disc.ay, disc.alpha = 0.0, 0.0, 0.0
    disc.support, disc.face, disc.held = k, feature, True


def leave_face(tables: Tables, disc: DiscRow) -> None:
    """Let a disc that has come to the end of its face hop off it."""
    obstacle, c = tables.obstacles[disc.support], tables.contact
    aim(c, tables.corners[disc.face].nx, tables.corners[disc.face].ny)
    touch_with_rim(c, disc)
    let_go(tables.state, disc)
    disc.changes += 1
    part(c, obstacle, disc, 0.0, tables.state.hop)


def is_leaving_face(tables: Tables, disc: DiscRow) -> bool:
    """Return whether a disc is at an end of its face and moves beyond it."""
    before, beyond = ways_to_ends(tables, disc)
    speed, pull = motion_along_face(tables, disc)
    outward = speed if speed != 0.0 else pull
    return (before <= 0.0 and outward < 0.0) or (beyond <= 0.0 and outward > 0.0)

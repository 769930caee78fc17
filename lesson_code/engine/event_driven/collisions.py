"""Collisions: what happens at the instant when a disc hits a disc or an obstacle.

The impulses are those of every contact in this workbook: along the normal by Newton's rule, along
the tangent by Coulomb's. The normal goes through the centre of a disc, so that only friction turns
it. The rules at the end of a series of collisions are stated here:

- A disc that leaves a face slower than `rest`, and is pressed onto it, rests on it.
- A disc that rests on one face and comes to rest on a second one is held: it does not move.
- Discs that approach slower than `slow` lose no energy, so that a series of ever slower impacts
  ends, and they go on together but for that speed.
- In a pile under gravity, impacts slower than `hop` lose no energy, and discs that are pressed
  together without any speed part at `hop`. A disc is in a pile if it has just met another one.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.contact_motion import normal_of, tangent_of
from lesson_code.engine.core.impulse_pair import MovingBody, exchange, exchange_and_turn
from lesson_code.engine.core.mixing import mixed
from lesson_code.engine.core.rows import BodyRow, ContactRow
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.event_driven.constants import CLOCK, LEAST_HOP, LEAST_LOSS, PLACE
from lesson_code.engine.event_driven.motion import move_to, seen_from
from lesson_code.engine.event_driven.rows import DiscRow, ExactState, Tables
from lesson_code.engine.event_driven.support import let_go, motion_along_face, settle, ways_to_ends
from lesson_code.formulas import contact
from lesson_code.formulas.arithmetic import dot
from lesson_code.formulas.validation import equation

effective_mass = equation(contact.effective_mass)
normal_impulse = equation(contact.normal_impulse)
friction_impulse = equation(contact.friction_impulse)


def collide_discs(tables: Tables, i: int, j: int, effects: Effects = EVERY_EFFECT) -> None:
    """Let two discs that touch hit each other; the one earlier in the scene is a."""
    if tables.discs[i].body > tables.discs[j].body:
        i, j = j, i
    a, b, c = tables.discs[i], tables.discs[j], tables.contact
    move_to(a, tables.state.now, effects)
    move_to(b, tables.state.now, effects)
    c.a, c.b = a.body, b.body
    aim(c, b.x - a.x, b.y - a.y)
    set_surfaces(tables.state, c, a, b, effects)
    if effects.rotation:
        c.ra_x_t, c.rb_x_t = a.radius, -b.radius
    if effects.gravity:
        pressed = dot((b.ax - a.ax, b.ay - a.ay), normal_of(c)) < 0.0
        meet_in_pile(tables.state, c, a, b, pressed, effects)
        let_go(tables.state, a, effects)
        let_go(tables.state, b, effects)
    else:
        meet(tables.state, c, a, b, effects)
    a.met, b.met = tables.state.now, tables.state.now
    a.changes += 1
    b.changes += 1


def set_surfaces(
    state: ExactState, c: ContactRow, a: DiscRow | BodyRow, b: DiscRow, effects: Effects
) -> None:
    """Set the restitution and the friction of a contact; those that are left out stay 0."""
    if effects.restitution:
        c.restitution = mixed(state.restitution_rule, a.restitution, b.restitution)
    if effects.friction:
        c.friction = mixed(state.friction_rule, a.friction, b.friction)


def meet(state: ExactState, c: ContactRow, a: MovingBody, b: MovingBody, effects: Effects) -> None:
    """Give the impulses of an impact that may be one of a series."""
    vn = normal_velocity(c, a, b)
    if vn <= -state.slow:
        push(c, a, b, vn, effects)
    else:  # the end of a series
        part(c, a, b, vn, abs(vn))


def meet_in_pile(
    state: ExactState,
    c: ContactRow,
    a: MovingBody,
    b: MovingBody,
    pressed: bool,
    effects: Effects,
) -> None:
    """Give the impulses of an impact between two discs, or in a pile, under gravity."""
    vn = normal_velocity(c, a, b)
    if vn <= -max(state.slow, state.hop):
        push(c, a, b, vn, effects)
    elif vn <= -state.slow:  # in a pile, or so slow that it makes no difference
        least = LEAST_HOP * state.hop if pressed and c.restitution < 1.0 else 0.0
        part(c, a, b, vn, max(-vn, least))
    else:  # the end of a series
        part(c, a, b, vn, state.hop if pressed else abs(vn))


def collide_obstacle(
    tables: Tables, i: int, k: int, feature: int, effects: Effects = EVERY_EFFECT
) -> None:
    """Let a disc hit an obstacle, at an edge or at a corner."""
    disc, obstacle, c = tables.discs[i], tables.obstacles[k], tables.contact
    move_to(disc, tables.state.now, effects)
    c.a, c.b = tables.obstacle_bodies[k].index, disc.body
    aim_at_disc(tables, disc, k, feature, effects)
    set_surfaces(tables.state, c, obstacle, disc, effects)
    if effects.rotation:
        c.ra_x_t, c.rb_x_t = 0.0, -disc.radius
    disc.changes += 1
    if effects.gravity:
        bounce_or_rest(tables, disc, k, feature, effects)
    elif disc.met == tables.state.now:
        meet(tables.state, c, obstacle, disc, effects)
    else:
        push(c, obstacle, disc, normal_velocity(c, obstacle, disc), effects)


def bounce_or_rest(tables: Tables, disc: DiscRow, k: int, feature: int, effects: Effects) -> None:
    """Let a disc that has hit an obstacle under gravity bounce, or rest where it presses."""
    obstacle, c = tables.obstacles[k], tables.contact
    vn = normal_velocity(c, obstacle, disc)
    rested, support, pull = disc.support >= 0, disc.support, (disc.ax, disc.ay)
    let_go(tables.state, disc, effects)
    pressing = -dot((tables.state.gravity_x, tables.state.gravity_y), normal_of(c))
    if tables.state.now - disc.met <= tables.state.pile_time:
        meet_in_pile(tables.state, c, obstacle, disc, pressing > 0.0, effects)
    elif pressing <= 0.0 or not comes_to_rest(tables, disc, vn, pressing, effects):
        push(c, obstacle, disc, vn, effects)
    elif rested and support != k and dot(pull, normal_of(c)) <= 0.0:
        hold(disc, obstacle, k, feature, effects)
    elif effects.outlines and feature >= 0 and obstacle.corner_count > 0:
        push(c, obstacle, disc, vn, effects)
        settle(tables, disc, k, feature, effects)
        if is_leaving_face(tables, disc):
            leave_face(tables, disc, effects)
    else:
        part(c, obstacle, disc, vn, tables.state.hop)


def comes_to_rest(
    tables: Tables, disc: DiscRow, vn: float, pressing: float, effects: Effects
) -> bool:
    """Return whether a disc would bounce so slow, low or short that it is only rounding."""
    if not effects.restitution:
        return True
    restitution = tables.contact.restitution
    speed = -restitution * vn
    if restitution == 1.0:
        size = abs(disc.x) + abs(disc.y) + disc.radius
        return speed * speed <= 2 * pressing * PLACE * size
    loss = max(1 - restitution, LEAST_LOSS)
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


def aim_at_disc(tables: Tables, disc: DiscRow, k: int, feature: int, effects: Effects) -> None:
    """Set the normal from an obstacle to a disc: a face's own, or away from centre or corner."""
    obstacle = tables.obstacles[k]
    dx, dy = seen_from(obstacle, disc)
    if not (effects.outlines and obstacle.corner_count > 0):
        aim(tables.contact, dx, dy)
    elif feature >= 0:
        aim(tables.contact, tables.corners[feature].nx, tables.corners[feature].ny)
    else:
        corner = tables.corners[-1 - feature]
        aim(tables.contact, dx - corner.x, dy - corner.y)


def normal_velocity(c: ContactRow, a: MovingBody, b: MovingBody) -> float:
    """Return the relative velocity along the normal, m/s; > 0: parting."""
    along: float = dot((b.vx - a.vx, b.vy - a.vy), normal_of(c))
    return along


def push(c: ContactRow, a: MovingBody, b: MovingBody, vn: float, effects: Effects) -> None:
    """Give the normal impulse and the friction of an impact."""
    jn = normal_impulse(vn, effective_mass(a.inv_m, b.inv_m), c.restitution)
    if effects.friction:
        jt = rubbing_impulse(c, a, b, jn, effects)
        apply_impulse(c, a, b, jn)
        rub(c, a, b, jt, effects)
    else:
        apply_impulse(c, a, b, jn)
    c.normal_impulse = jn


def rubbing_impulse(
    c: ContactRow, a: MovingBody, b: MovingBody, jn: float, effects: Effects
) -> float:
    """Return the impulse of friction at the points that touch, N s.

    Discs that cannot turn rub as points do: of the others the rims move, too.
    """
    vt = dot((b.vx - a.vx, b.vy - a.vy), tangent_of(c))
    if effects.rotation:
        vt += b.w * c.rb_x_t - a.w * c.ra_x_t
        mass = effective_mass(a.inv_m, b.inv_m, a.inv_i, b.inv_i, c.ra_x_t, c.rb_x_t)
    else:
        mass = effective_mass(a.inv_m, b.inv_m)
    jt: float = friction_impulse(vt, mass, c.friction, jn)
    return jt


def apply_impulse(c: ContactRow, a: MovingBody, b: MovingBody, jn: float) -> None:
    """Change the velocities of both bodies by an impulse along the normal, N s."""
    exchange(a, b, jn * c.nx, jn * c.ny)


def rub(c: ContactRow, a: MovingBody, b: MovingBody, jt: float, effects: Effects) -> None:
    """Change them, and the turning, by an impulse along the tangent (-ny, nx), N s."""
    if effects.rotation:
        wa, wb = -jt * c.ra_x_t * a.inv_i, jt * c.rb_x_t * b.inv_i
        exchange_and_turn(a, b, -jt * c.ny, jt * c.nx, wa, wb)
    else:
        exchange(a, b, -jt * c.ny, jt * c.nx)
    c.tangent_impulse = jt


def part(c: ContactRow, a: MovingBody, b: MovingBody, vn: float, speed: float) -> None:
    """Let two bodies that touch part at a speed, m/s."""
    jn = (speed - vn) * effective_mass(a.inv_m, b.inv_m)
    apply_impulse(c, a, b, jn)
    c.normal_impulse, c.tangent_impulse = max(jn, 0.0), 0.0


def hold(disc: DiscRow, obstacle: BodyRow, k: int, feature: int, effects: Effects) -> None:
    """Let a disc that lies on two faces stay there."""
    disc.vx, disc.vy = obstacle.vx, obstacle.vy
    disc.ax, disc.ay = 0.0, 0.0
    if effects.rotation:
        disc.alpha = 0.0
    disc.support, disc.face, disc.held = k, feature, True


def leave_face(tables: Tables, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> None:
    """Let a disc that has come to the end of its face hop off it."""
    obstacle, c = tables.obstacles[disc.support], tables.contact
    aim(c, tables.corners[disc.face].nx, tables.corners[disc.face].ny)
    let_go(tables.state, disc, effects)
    disc.changes += 1
    part(c, obstacle, disc, 0.0, tables.state.hop)


def is_leaving_face(tables: Tables, disc: DiscRow) -> bool:
    """Return whether a disc is at an end of its face and moves beyond it."""
    before, beyond = ways_to_ends(tables, disc)
    speed, pull = motion_along_face(tables, disc)
    outward = speed if speed != 0.0 else pull
    return (before <= 0.0 and outward < 0.0) or (beyond <= 0.0 and outward > 0.0)

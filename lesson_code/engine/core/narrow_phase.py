"""Narrow phase: the contact points of every candidate pair, written into the contact table."""

from __future__ import annotations

from lesson_code.engine.core.mixing import mixed
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.internal_edges import drop_internal_edges
from lesson_code.engine.effects.sleeping import is_idle, wake
from lesson_code.geometry.circle_contact import collide_circles
from lesson_code.geometry.manifold import collide_rows, collide_with_circle
from lesson_code.geometry.rows import ManifoldRow


def find_contacts(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Write the contacts of all candidate pairs, in the order of the pairs, without internal edges.

    Returns whether the table had room for them.
    """
    if effects.sleeping and world.state.asleep_count > 0:
        wake_touched(world, effects)
    if not find_overlaps(world, effects):
        return False
    if effects.internal_edges:
        drop_internal_edges(world, effects)
    return True


def wake_touched(world: World, effects: Effects) -> None:
    """Wake every island that something touches which does not sleep."""
    for k in range(world.state.pair_count):
        a, b = world.bodies[world.pairs[k].a], world.bodies[world.pairs[k].b]
        if a.is_asleep and not is_idle(b):
            touch(world, a, b, effects)
            if world.manifold.count > 0:
                wake(world, a.island)
        elif b.is_asleep and not is_idle(a):
            touch(world, a, b, effects)
            if world.manifold.count > 0:
                wake(world, b.island)


def find_overlaps(world: World, effects: Effects) -> bool:
    """Write the contacts of all candidate pairs; return whether the table had room for them."""
    state, m = world.state, world.manifold
    count = 0
    state.static_count = 0
    for k in range(state.pair_count):
        pair = world.pairs[k]
        a, b = world.bodies[pair.a], world.bodies[pair.b]
        if effects.sleeping and is_idle(a) and is_idle(b):
            continue
        touch(world, a, b, effects)
        if m.count == 0:
            continue
        if count + m.count > len(world.contacts):
            state.contacts_wanted = count + m.count
            return False
        for point in range(m.count):
            contact = world.contacts[count]
            contact.a, contact.b = pair.a, pair.b
            if effects.restitution:
                rule = state.restitution_rule
                contact.restitution = mixed(rule, a.restitution, b.restitution)
            if effects.friction:
                contact.friction = mixed(state.friction_rule, a.friction, b.friction)
            write_point(contact, m, point)
            if effects.internal_edges and (a.inv_m == 0.0 or b.inv_m == 0.0):
                world.static_contacts[state.static_count].index = count
                state.static_count += 1
            count += 1
    state.contact_count = count
    return True


def touch(world: World, a: BodyRow, b: BodyRow, effects: Effects) -> None:
    """Fill the manifold of two bodies."""
    if effects.manifolds:
        collide_rows(world.corners, a, b, world.manifold)
    elif effects.outlines:
        collide_with_circle(world.corners, a, b, world.manifold)
    else:
        collide_circles(a, b, world.manifold)


def write_point(contact: ContactRow, m: ManifoldRow, point: int) -> None:
    """Write the geometry of one point of a manifold; the impulses begin at 0."""
    contact.nx, contact.ny = m.nx, m.ny
    if point == 0:
        contact.ax, contact.ay = m.ax0, m.ay0
        contact.bx, contact.by = m.bx0, m.by0
        contact.penetration, contact.feature = m.penetration0, m.feature0
    else:
        contact.ax, contact.ay = m.ax1, m.ay1
        contact.bx, contact.by = m.bx1, m.by1
        contact.penetration, contact.feature = m.penetration1, m.feature1
    contact.normal_impulse = 0.0
    contact.remembered = -1.0
    contact.tangent_impulse = 0.0
    contact.pseudo_impulse = 0.0

"""Internal edges: where two static bodies make one floor, there is nothing to hit between them.

A body that rests on a floor has sunk into it a little. When it comes to the next piece of the
floor, it therefore meets that piece's end, an edge inside the floor, and would stumble over it:
a ghost collision. The rule:

    An edge or a corner of a static body that stands no higher than the face on which another
    static body carries the body, cannot stop it.

It looks at the contacts of one body alone and needs no list of neighbours. A step that is higher
than the tolerance is a step, and a wall is a wall.
"""

from __future__ import annotations

from lesson_code.engine.core.constants import INTERNAL_EDGE_TOLERANCE
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.question import Effect, Finding
from lesson_code.geometry.clipping import facing_edge
from lesson_code.geometry.edges import closest_on_edge
from lesson_code.geometry.rows import following

CROSSWISE = 0.5
"""Cosine of the angle between two normals: faces of polygons that are nearer to parallel than this
both carry the body (a plank on two trestles)."""

ALONG = 1.0 - 1e-9
"""Cosine of the angle between an edge's normal and a contact's at which the edge is the face."""


def rule(facts: Facts) -> Finding:
    """Ask whether there are two static bodies that may stand side by side."""
    count = facts.body_count - facts.free_count
    if count > 1:
        return Finding(True, "{:.0f} static bodies may make one floor", count)
    return Finding(False, "there is at most one static body")


EFFECT = Effect(rule=rule, place=50, functions=("drop_internal_edges",))


def drop_internal_edges(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Take the contacts with covered edges of static bodies out of the contact table."""
    chain_static_contacts(world)
    found = False
    for n in range(world.state.static_count):
        k = world.static_contacts[n].index
        world.contacts[k].is_covered = is_covered(world, k)
        found = found or world.contacts[k].is_covered
    if found:
        close_up(world, effects)


def chain_static_contacts(world: World) -> None:
    """Chain the contacts of each body that can be pushed with static bodies, the last first."""
    for n in range(world.state.static_count):
        c = world.contacts[world.static_contacts[n].index]
        world.bodies[pushed_body(world, c)].static_contact = -1
    for n in range(world.state.static_count):
        k = world.static_contacts[n].index
        body = world.bodies[pushed_body(world, world.contacts[k])]
        world.contacts[k].next_static = body.static_contact
        body.static_contact = k


def close_up(world: World, effects: Effects) -> None:
    """Close the gaps that covered contacts leave in the table, keeping the order."""
    kept = 0
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        is_static = world.bodies[c.a].inv_m == 0.0 or world.bodies[c.b].inv_m == 0.0
        if not (is_static and c.is_covered):
            if kept < k:
                copy_contact(c, world.contacts[kept], effects)
            kept += 1
    world.state.contact_count = kept


def pushed_body(world: World, c: ContactRow) -> int:
    """Return which body of a contact with a static one can be pushed."""
    return c.a if world.bodies[c.a].inv_m > 0.0 else c.b


def is_covered(world: World, k: int) -> bool:
    """Return whether a contact is with an edge that is no higher than what carries the body."""
    c = world.contacts[k]
    pushed = pushed_body(world, c)
    n = world.bodies[pushed].static_contact
    while n >= 0:
        d = world.contacts[n]
        other = d.a + d.b != c.a + c.b  # the pushed body is the same: so the static one differs
        if other and is_deeper(world, d, n, c, k, pushed) and covers(world, d, c, pushed):
            return True
        n = d.next_static
    return False


def is_deeper(world: World, d: ContactRow, n: int, c: ContactRow, k: int, pushed: int) -> bool:
    """Return whether the contact d, in row n, is deeper than c in row k.

    Of two that are as deep but for rounding a face comes before a corner, whose normal is slanted
    where it should be straight, and of two alike the first.
    """
    difference = d.penetration - c.penetration
    if abs(difference) > INTERNAL_EDGE_TOLERANCE * world.bodies[pushed].min_width:
        return difference > 0.0
    if is_straight(world, d, pushed) != is_straight(world, c, pushed):
        return is_straight(world, d, pushed)
    return n < k


def is_straight(world: World, c: ContactRow, pushed: int) -> bool:
    """Return whether a contact's normal is, to the last bit, that of an edge of the static body."""
    static = static_body(world, c, pushed)
    if static.corner_count == 0:
        return False
    nx, ny = towards(c, pushed)
    corner = world.corners[facing_edge(world.corners, static, nx, ny)]
    return corner.nx == nx and corner.ny == ny


def is_with_face(world: World, c: ContactRow, pushed: int) -> bool:
    """Return whether a contact is with a face of the static body, not with a corner."""
    static = static_body(world, c, pushed)
    nx, ny = towards(c, pushed)
    return static.corner_count > 0 and facing(world, static, nx, ny) >= 0


def covers(world: World, d: ContactRow, c: ContactRow, pushed: int) -> bool:
    """Return whether the face of d, on which a body rests, is as high as the edge of c."""
    body = world.bodies[pushed]
    mx, my = towards(d, pushed)
    nx, ny = towards(c, pushed)
    if body.corner_count > 0 and mx * nx + my * ny > CROSSWISE:
        return is_rounded_end(world, c, pushed) and lies_in_rod(world, c, d, pushed)
    px, py = static_point(world, d, pushed)
    return (
        height(world, c, pushed, mx, my) - (px * mx + py * my)
        <= INTERNAL_EDGE_TOLERANCE * body.min_width
    )


def is_rounded_end(world: World, c: ContactRow, pushed: int) -> bool:
    """Return whether the round end of a static segment is hit."""
    static = static_body(world, c, pushed)
    is_rod = static.radius > 0.0 and static.corner_count == 2
    return is_rod and not is_with_face(world, c, pushed)


def lies_in_rod(world: World, c: ContactRow, d: ContactRow, pushed: int) -> bool:
    """Return whether the point that is hit lies in the other static body, a segment with ends."""
    body, static = world.bodies[pushed], static_body(world, d, pushed)
    if static.corner_count != 2:
        return False
    px, py = static_point(world, c, pushed)
    x, y = px + body.x - static.x, py + body.y - static.y
    start, end = world.corners[static.first_corner], world.corners[static.first_corner + 1]
    cx, cy = closest_on_edge(x, y, start.x, start.y, end.x, end.y, -start.ny, start.nx)
    reach = static.radius + INTERNAL_EDGE_TOLERANCE * body.min_width
    return (x - cx) * (x - cx) + (y - cy) * (y - cy) <= reach * reach


def static_body(world: World, c: ContactRow, pushed: int) -> BodyRow:
    """Return the body of a contact that nothing can push."""
    return world.bodies[c.a] if c.b == pushed else world.bodies[c.b]


def facing(world: World, static: BodyRow, nx: float, ny: float) -> int:
    """Return the edge whose normal is (nx, ny), as its first corner in the table; -1: none."""
    edge = facing_edge(world.corners, static, nx, ny)
    corner = world.corners[edge]
    return edge if corner.nx * nx + corner.ny * ny > ALONG else -1


def towards(c: ContactRow, pushed: int) -> tuple[float, float]:
    """Return the unit normal from the static body to the pushed one."""
    return (c.nx, c.ny) if c.b == pushed else (-c.nx, -c.ny)


def static_point(world: World, c: ContactRow, pushed: int) -> tuple[float, float]:
    """Return the point on the static body's surface, seen from the pushed body's position, m."""
    body = world.bodies[pushed]
    if c.b == pushed:
        return world.bodies[c.a].x - body.x + c.ax, world.bodies[c.a].y - body.y + c.ay
    return world.bodies[c.b].x - body.x + c.bx, world.bodies[c.b].y - body.y + c.by


def height(world: World, c: ContactRow, pushed: int, mx: float, my: float) -> float:
    """Return how far along (mx, my) reaches what is hit: a face with both its ends, or a point.

    Seen from the pushed body's position, m.
    """
    body, static = world.bodies[pushed], static_body(world, c, pushed)
    nx, ny = towards(c, pushed)
    px, py = static_point(world, c, pushed)
    reached = px * mx + py * my
    edge = facing(world, static, nx, ny) if static.corner_count > 0 else -1
    if edge >= 0:
        start, end = world.corners[edge], world.corners[following(static, edge)]
        x, y = static.x - body.x + nx * static.radius, static.y - body.y + ny * static.radius
        reached = max(reached, (x + start.x) * mx + (y + start.y) * my)
        reached = max(reached, (x + end.x) * mx + (y + end.y) * my)
    return reached


def copy_contact(of: ContactRow, to: ContactRow, effects: Effects) -> None:
    """Write what the narrow phase has written of one contact into another row."""
    to.a, to.b, to.feature = of.a, of.b, of.feature
    to.nx, to.ny, to.penetration = of.nx, of.ny, of.penetration
    to.ax, to.ay, to.bx, to.by = of.ax, of.ay, of.bx, of.by
    to.restitution = of.restitution
    if effects.friction:
        to.friction = of.friction
    to.normal_impulse, to.tangent_impulse, to.pseudo_impulse = 0.0, 0.0, 0.0

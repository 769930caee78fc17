"""Sequential impulses: visit contact after contact, and correct each until all agree.

======================  =====================================================================
stage                   what it does
======================  =====================================================================
``prepare``             effective masses, the bounce to reach, the overlap to undo
``warm_start``          begin with the impulses of the last step, which are nearly right
``solve``               one sweep: normal impulse, then friction, for each contact in turn
``correct``             one sweep of pushes that undo the overlaps
``store``               remember the impulses for the next step
======================  =====================================================================

Two points of one manifold share their bodies, and what is given to one moves the other. Their
normal impulses are found together, exactly (``two_points``).

The totals are clamped, not the corrections: a later visit may take back what an earlier one
gave too much, as long as the total still pushes (jn >= 0) and friction stays within mu jn.

The push that undoes an overlap has velocities of its own (split impulse). They move the bodies
once and are forgotten, so that no overlap ever turns into speed.

References
----------
Catto, Iterative Dynamics with Temporal Coherence (2005); Catto, Fast and Simple Physics using
Sequential Impulses (2006), for the split impulse too.
"""

from __future__ import annotations

from lesson_code.engine.constants import (
    FEWEST_FOR_STREAMS,
    LEAST_EXCESS,
    PUSH_SHARE,
    SLOP,
    STREAMS,
)
from lesson_code.engine.contact_frame import (
    apply_impulses,
    apply_push,
    missing_push,
    normal_velocity,
    set_frame,
    tangent_velocity,
    velocity_at,
)
from lesson_code.engine.effects import EVERY_EFFECT, Effects
from lesson_code.engine.rows import BodyRow, ContactRow, MemoryRow, World
from lesson_code.engine.two_points import couple, solve_normals, solve_pushes
from lesson_code.formulas import contact
from lesson_code.formulas.validation import equation

normal_impulse = equation(contact.normal_impulse)
friction_impulse = equation(contact.friction_impulse)


def prepare(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Compute what stays the same during the sweeps, at the velocities before gravity acts."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        set_frame(c, a, b)
        # Also where they part already: else a third body that presses them together adds energy.
        c.target_vn = -c.restitution * normal_velocity(c, a, b)
        c.push_speed = push_speed_of(c, a, b, world.state.dt)
        if effects.manifolds:
            c.is_block = False
            if k > 0 and world.contacts[k - 1].a == c.a and world.contacts[k - 1].b == c.b:
                couple(world.contacts[k - 1], c, a, b)


def push_speed_of(c: ContactRow, a: BodyRow, b: BodyRow, dt: float) -> float:
    """Return the speed at which a contact's overlap is undone, m/s; 0 where there is too little."""
    slop = SLOP * min(a.extent, b.extent)
    excess = c.penetration - slop
    return PUSH_SHARE * excess / dt if excess > LEAST_EXCESS * slop else 0.0


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each contact the impulse that it needed in the last step."""
    recall(world)
    give_again(world)


def give_again(world: World) -> None:
    """Apply the impulse that each contact needed in the step before, for a step as long as this."""
    longer = longer_than_before(world)
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        c.normal_impulse *= longer  # a force is remembered, as an impulse a step
        c.tangent_impulse *= longer
        apply_impulses(c, a, b, c.normal_impulse, c.tangent_impulse)


def longer_than_before(world: World) -> float:
    """Return the length of this step over that of the step before; 1 for the first."""
    return world.state.dt / world.state.dt_before if world.state.dt_before > 0.0 else 1.0


def recall(world: World) -> None:
    """Find each contact's impulses of the last step; contacts and memory are sorted alike."""
    count, first = world.state.memory_count, 0
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        while first < count and comes_before(world.memory[first], c):
            first += 1
        n = first
        while n < count and world.memory[n].a == c.a and world.memory[n].b == c.b:
            if world.memory[n].feature == c.feature:
                c.normal_impulse = world.memory[n].normal_impulse
                c.tangent_impulse = world.memory[n].tangent_impulse
            n += 1


def comes_before(old: MemoryRow, c: ContactRow) -> bool:
    """Return whether a remembered contact's pair comes before a contact's in the order."""
    return old.a < c.a or (old.a == c.a and old.b < c.b)


def solve(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Make one sweep over all contacts."""
    count = world.state.contact_count
    stride = stride_of_visits(count)
    for first in range(stride):
        for k in range(first, count, stride):
            c = world.contacts[k]
            a, b = world.bodies[c.a], world.bodies[c.b]
            if effects.manifolds and c.is_block:
                solve_manifold(c, world.contacts[k + 1], a, b)
            elif not (effects.manifolds and is_second_of_block(world, k)):
                solve_contact(c, a, b)


def stride_of_visits(count: int) -> int:
    """Return how many contacts lie between two visits of a sweep; few are visited in order."""
    return count if count < FEWEST_FOR_STREAMS else (count + STREAMS - 1) // STREAMS


def solve_contact(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring the normal velocity to its target, then stop the sliding that there is after it."""
    vn, vt = velocity_at(c, a, b)
    jn = normal_impulse(vn - c.target_vn, c.normal_mass, 0.0, c.normal_impulse)
    more_n = jn - c.normal_impulse
    vt_after = vt + c.skew * more_n
    jt = friction_impulse(vt_after, c.tangent_mass, c.friction, jn, c.tangent_impulse)
    more_t = jt - c.tangent_impulse
    apply_impulses(c, a, b, more_n, more_t)
    c.normal_impulse, c.tangent_impulse = jn, jt


def solve_manifold(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Do the same at the two points of one manifold: both normal velocities at once."""
    solve_normals(c, d, a, b)
    solve_friction(c, a, b)
    solve_friction(d, a, b)


def solve_friction(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Stop the sliding, as far as Coulomb's limit mu jn allows."""
    vt = tangent_velocity(c, a, b)
    total = friction_impulse(vt, c.tangent_mass, c.friction, c.normal_impulse, c.tangent_impulse)
    apply_impulses(c, a, b, 0.0, total - c.tangent_impulse)
    c.tangent_impulse = total


def has_overlap_to_undo(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Return whether any contact overlaps by too much; leave out what will part by itself."""
    found = False
    for k in range(world.state.contact_count):
        found = found or world.contacts[k].push_speed > 0.0
    if found:
        for k in range(world.state.contact_count):
            c = world.contacts[k]
            vn = normal_velocity(c, world.bodies[c.a], world.bodies[c.b])
            c.push_speed -= max(vn, 0.0)
    return found


def correct(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Make one sweep of pushes over all contacts."""
    count = world.state.contact_count
    stride = stride_of_visits(count)
    for first in range(stride):
        for k in range(first, count, stride):
            c = world.contacts[k]
            a, b = world.bodies[c.a], world.bodies[c.b]
            if effects.manifolds and c.is_block:
                solve_pushes(c, world.contacts[k + 1], a, b)
            elif not (effects.manifolds and is_second_of_block(world, k)):
                solve_push(c, a, b)


def is_second_of_block(world: World, k: int) -> bool:
    """Return whether a contact is solved together with the one before it."""
    return k > 0 and world.contacts[k - 1].is_block


def solve_push(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Move the bodies apart, by an impulse that in total only pushes."""
    total = normal_impulse(missing_push(c, a, b), c.normal_mass, 0.0, c.push_impulse)
    apply_push(c, a, b, total - c.push_impulse)
    c.push_impulse = total


def store(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Remember the impulses of this step for the next."""
    for k in range(world.state.contact_count):
        c, m = world.contacts[k], world.memory[k]
        m.a, m.b, m.feature = c.a, c.b, c.feature
        m.normal_impulse, m.tangent_impulse = c.normal_impulse, c.tangent_impulse
    world.state.memory_count = world.state.contact_count
    world.state.dt_before = world.state.dt

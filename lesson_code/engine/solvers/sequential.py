"""Sequential impulses: visit contact after contact, and correct each until all agree.

======================  =====================================================================
stage                   what it does
======================  =====================================================================
``prepare``             effective masses, the bounce to reach, the overlap to undo, the order
``warm_start``          begin with the impulses of the last step, which are nearly right
``solve``               one sweep: normal impulse, then friction, for each contact in turn
``correct``             one sweep of pushes that undo the overlaps
``store``               remember the impulses for the next step
======================  =====================================================================

Two points of one manifold share their bodies, and what is given to one moves the other. Their
normal impulses are found together, exactly (``block_solver``).

The totals are clamped, not the corrections: a later visit may take back what an earlier one
gave too much, as long as the total still pushes (jn >= 0) and friction stays within mu jn.

The push that undoes an overlap has velocities of its own (split impulse). They move the bodies
once and are forgotten, so that no overlap ever turns into speed.

What a scene does not call for is left out once for all contacts, before the loop over them: where
nothing rubs the normal impulse is all there is, and where nothing turns it is a central one.

References
----------
Catto, Iterative Dynamics with Temporal Coherence (2005); Catto, Fast and Simple Physics using
Sequential Impulses (2006), for the split impulse too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from lesson_code.engine.compiled.lanes import in_lanes
from lesson_code.engine.core.constants import (
    BAUMGARTE_FACTOR,
    FASTEST_GROWTH,
    LEAST_EXCESS,
    SLOP,
)
from lesson_code.engine.core.contact_frame import (
    apply_central_impulse,
    apply_central_pseudo_impulse,
    apply_impulses,
    apply_normal_impulse,
    apply_pseudo_impulse,
    bring_to_total,
    central_pseudo_velocity,
    central_velocity,
    friction_impulse,
    missing_pseudo_velocity,
    missing_velocity,
    normal_impulse,
    normal_velocity,
    set_central_frame,
    set_frame,
    set_normal_frame,
    velocity_at,
)
from lesson_code.engine.core.pipeline import SolverStages
from lesson_code.engine.core.rows import BodyRow, ContactRow, MemoryRow, World
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.solvers.block_solver import (
    couple,
    couple_tangents,
    solve_manifold,
    solve_normals,
    solve_pseudo_velocities,
)
from lesson_code.engine.solvers.visits import order_visits

Visit: TypeAlias = Callable[[ContactRow, BodyRow, BodyRow], None]
"""Does something to a contact and its two bodies."""

VisitTwo: TypeAlias = Callable[[ContactRow, ContactRow, BodyRow, BodyRow], None]
"""The same to the two contacts of a manifold."""

Velocity: TypeAlias = Callable[[ContactRow, BodyRow, BodyRow], float]
"""Returns a relative velocity at a contact, m/s."""


def prepare(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Compute what stays the same during the sweeps, at the velocities before gravity acts."""
    if effects.friction:
        prepare_contacts(world, effects, set_frame)
    elif effects.rotation:
        prepare_contacts(world, effects, set_normal_frame)
    else:
        prepare_contacts(world, effects, set_central_frame)
    if effects.restitution:
        set_bounces(world, normal_velocity if effects.rotation else central_velocity)
    order_visits(world, effects)


def prepare_contacts(world: World, effects: Effects, set_contact: Visit) -> None:
    """Compute the effective masses, and the overlaps to undo."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        set_contact(c, a, b)
        c.target_vn = 0.0
        c.pseudo_speed = pseudo_speed_of(c, a, b, world.state.dt)
        if effects.manifolds:
            c.is_block = False
            if k > 0:
                join_points(world.contacts[k - 1], c, a, b, effects)


def join_points(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, effects: Effects) -> None:
    """Let two contacts be solved together if they are the two points of one manifold."""
    if c.a == d.a and c.b == d.b:
        couple(c, d, a, b)
        if effects.friction:
            couple_tangents(c, d, a, b)


def set_bounces(world: World, velocity: Velocity) -> None:
    """Compute the normal velocities to reach.

    Also where the bodies part already: else a third body that presses them together adds energy.
    """
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.target_vn = -c.restitution * velocity(c, world.bodies[c.a], world.bodies[c.b])


def pseudo_speed_of(c: ContactRow, a: BodyRow, b: BodyRow, dt: float) -> float:
    """Return the speed at which a contact's overlap is undone, m/s; 0 where there is too little."""
    slop = SLOP * min(a.min_width, b.min_width)
    excess = c.penetration - slop
    return BAUMGARTE_FACTOR * excess / dt if excess > LEAST_EXCESS * slop else 0.0


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each contact the impulse that it needed in the last step."""
    recall(world, effects)
    give_again(world, effects)


def give_again(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Apply the impulse that each contact needed in the step before, for a step as long as this.

    A force is remembered, as an impulse a step.
    """
    longer = longer_than_before(world)
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        c.normal_impulse *= longer
        c.remembered *= longer
        if effects.friction:
            c.tangent_impulse *= longer
            apply_impulses(c, a, b, c.normal_impulse, c.tangent_impulse)
        elif effects.rotation:
            apply_normal_impulse(c, a, b, c.normal_impulse)
        else:
            apply_central_impulse(c, a, b, c.normal_impulse)


def longer_than_before(world: World) -> float:
    """Return the length of this step over that of the step before; 1 for the first."""
    return world.state.dt / world.state.dt_before if world.state.dt_before > 0.0 else 1.0


def recall(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Find each contact's impulses of the last step; contacts and memory are sorted alike."""
    count, first = world.state.memory_count, 0
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        while first < count and comes_before(world.memory[first], c):
            first += 1
        n = first
        while n < count and world.memory[n].a == c.a and world.memory[n].b == c.b:
            if world.memory[n].feature == c.feature:
                c.normal_impulse = c.remembered = world.memory[n].normal_impulse
                if effects.friction:
                    c.tangent_impulse = world.memory[n].tangent_impulse
            n += 1


def comes_before(old: MemoryRow, c: ContactRow) -> bool:
    """Return whether a remembered contact's pair comes before a contact's in the order."""
    return old.a < c.a or (old.a == c.a and old.b < c.b)


def solve(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Make one sweep over all contacts."""
    if effects.friction:
        sweep(world, effects, solve_contact, solve_manifold)
    elif effects.rotation:
        sweep(world, effects, solve_normal, solve_normals)
    else:
        sweep(world, effects, solve_central, solve_normals)


def sweep(world: World, effects: Effects, visit: Visit, visit_two: VisitTwo) -> None:
    """Visit all contacts; the two points of a manifold together."""
    first = 0
    if effects.manifolds:
        sweep_in_lanes(world, visit, visit_two)
        first = world.state.lanes_of_one
    for n in range(first, world.state.visit_count):
        k = world.visits[n].index
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        if effects.manifolds and c.is_block:
            visit_two(c, world.contacts[k + 1], a, b)
        else:
            visit(c, a, b)


def sweep_in_lanes(world: World, visit: Visit, visit_two: VisitTwo) -> None:
    """Make the first visits, four of one colour at a time: manifolds, then single contacts."""
    state = world.state
    for n in in_lanes(0, state.lanes_of_two):
        k = world.visits[n].index
        c, d = world.contacts[k], world.contacts[k + 1]
        visit_two(c, d, world.bodies[c.a], world.bodies[c.b])
    for n in in_lanes(state.lanes_of_two, state.lanes_of_one):
        c = world.contacts[world.visits[n].index]
        visit(c, world.bodies[c.a], world.bodies[c.b])


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


def solve_normal(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring the normal velocity to its target: all there is to do where nothing rubs."""
    missing = missing_velocity(c, a, b)
    bring_to_total(c, a, b, normal_impulse(missing, c.normal_mass, 0.0, c.normal_impulse))


def solve_central(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Do the same to bodies that cannot rotate."""
    missing = central_velocity(c, a, b) - c.target_vn
    total = normal_impulse(missing, c.normal_mass, 0.0, c.normal_impulse)
    apply_central_impulse(c, a, b, total - c.normal_impulse)
    c.normal_impulse = total


def has_overlap_to_undo(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Return whether any contact overlaps by too much; leave out what will part by itself."""
    found = False
    for k in range(world.state.contact_count):
        found = found or world.contacts[k].pseudo_speed > 0.0
    if found:
        spare_parting(world, normal_velocity if effects.rotation else central_velocity)
    return found


def spare_parting(world: World, velocity: Velocity) -> None:
    """Take from what is to be undone what the velocities will undo."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.pseudo_speed -= max(velocity(c, world.bodies[c.a], world.bodies[c.b]), 0.0)


def correct(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Make one sweep of pushes over all contacts."""
    if effects.rotation:
        sweep(world, effects, solve_pseudo_velocity, solve_pseudo_velocities)
    else:
        sweep(world, effects, solve_central_pseudo_velocity, solve_pseudo_velocities)


def solve_pseudo_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Move the bodies apart, by an impulse that in total only pushes."""
    total = normal_impulse(missing_pseudo_velocity(c, a, b), c.normal_mass, 0.0, c.pseudo_impulse)
    apply_pseudo_impulse(c, a, b, total - c.pseudo_impulse)
    c.pseudo_impulse = total


def solve_central_pseudo_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Do the same to bodies that cannot rotate."""
    missing = central_pseudo_velocity(c, a, b) - c.pseudo_speed
    total = normal_impulse(missing, c.normal_mass, 0.0, c.pseudo_impulse)
    apply_central_pseudo_impulse(c, a, b, total - c.pseudo_impulse)
    c.pseudo_impulse = total


def store(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Remember the impulses of this step for the next."""
    has_impact = effects.continuous and world.state.impacts > 0
    for k in range(world.state.contact_count):
        c, m = world.contacts[k], world.memory[k]
        m.a, m.b, m.feature = c.a, c.b, c.feature
        part = part_to_remember(c) if has_impact else 1.0
        m.normal_impulse = part * c.normal_impulse
        if effects.friction:
            m.tangent_impulse = part * c.tangent_impulse
    world.state.memory_count = world.state.contact_count
    world.state.dt_before = world.state.dt


def part_to_remember(c: ContactRow) -> float:
    """Return how much of an impulse in a part of a step with impacts is that of a lasting force.

    A blow is not: given again in a part a thousand times as long, it would be a thousand blows.
    """
    if c.remembered < 0.0:
        return 0.0
    most = FASTEST_GROWTH * c.remembered
    return most / c.normal_impulse if 0.0 < most < c.normal_impulse else 1.0


SOLVER = Solver(
    name="sequential",
    stages=SolverStages(prepare, warm_start, solve, has_overlap_to_undo, correct, store),
)

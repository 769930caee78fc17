"""Sleep: an island in which nothing moves any more is left alone until something touches it.

An island is what hangs together by contacts: bodies that can be pushed and lead from one to the
other. When all of them have been still for a while it *sleeps*: its bodies do not move, no contact
is sought between them, and nothing is solved. Its contacts keep the impulses that they carried.

A body that is awake and touches one that sleeps wakes its whole island, before the contacts of
that step are found. The impulses go back into the memory, as if they were those of the step
before. So the island continues as if it had never slept: a body that is still moves by less than
a billionth of what gravity gives (:data:`STILL`).
"""

from __future__ import annotations

import math

from lesson_code.engine.core.constants import QUIET_TIME, STEPS_A_LOOK, STILL
from lesson_code.engine.core.contact_motion import contact_point
from lesson_code.engine.core.islands import find_islands, first_of_island
from lesson_code.engine.core.rows import BodyRow, ContactRow, MemoryRow, RestingRow, World
from lesson_code.engine.effects import friction, gravity
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.internal_edges import pushed_body
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether something presses bodies together, takes their energy, and leaves them time."""
    if facts.hears_contacts:
        return Finding(False, "callbacks hear of every contact in every step")
    if not gravity.rule(facts).called_for:
        return Finding(False, "without gravity nothing is held at rest")
    if math.isinf(facts.duration):
        return Finding(False, "nobody knows yet how long the run will be")
    if facts.duration <= QUIET_TIME:
        return Finding(False, "the run is no longer than the {:g} s of quiet it takes", QUIET_TIME)
    loses = friction.rule(facts).called_for or facts.damping > 0.0
    if not loses and facts.least_restitution >= 1.0:
        return Finding(False, "nothing takes energy: every pair has e = 1 and mu = 0")
    return Finding(True, "bodies can come to rest within the run")


def hears_callbacks(facts: Facts) -> bool:
    """Return whether callbacks hear of every contact in every step: one that sleeps is silent."""
    return facts.hears_contacts


EFFECT = Effect(
    rule=rule,
    place=140,
    functions=("let_sleep", "everything_sleeps"),
    is_optional=True,
    is_ruled_out=hears_callbacks,
)


def is_static_and_moves(body: BodyRow) -> bool:
    """Return whether a body that nothing can push moves."""
    return body.inv_m == 0.0 and (body.vx != 0.0 or body.vy != 0.0 or body.w != 0.0)


def is_idle(body: BodyRow) -> bool:
    """Return whether a body sleeps, or never moves: two of that kind do not come to meet."""
    return body.is_asleep or (body.inv_m == 0.0 and not is_static_and_moves(body))


def everything_sleeps(world: World) -> bool:
    """Return whether nothing moves, and nothing will."""
    state = world.state
    return state.asleep_count == state.free_count and not state.has_moving_static


def has_capacity_for_sleep(world: World) -> bool:
    """Return whether the contacts of all islands would find room in the table of those at rest."""
    state = world.state
    wanted = state.contact_count + state.resting_count
    if wanted > len(world.resting):
        state.contacts_wanted = wanted
    return wanted <= len(world.resting)


# Falling asleep


def let_sleep(world: World) -> None:
    """Put to sleep the islands in which nothing has moved for long enough."""
    if note_quiet(world) and world.state.steps_done % STEPS_A_LOOK == 0:
        find_islands(world)
        disturb(world)
        fall_asleep(world)
        lay_down_contacts(world)


def note_quiet(world: World) -> bool:
    """Note for how long each body has been still; return whether one is quiet long enough."""
    state = world.state
    gravity = math.sqrt(state.gravity_x * state.gravity_x + state.gravity_y * state.gravity_y)
    still = STILL * gravity * state.dt
    found = False
    for body in world.bodies:
        if body.inv_m > 0.0 and not body.is_asleep:
            body.quiet = body.quiet + state.dt if is_still(body, still) else 0.0
            found = found or body.quiet >= QUIET_TIME
    return found


def is_still(body: BodyRow, most: float) -> bool:
    """Return whether no point of a body is faster than `most`, m/s, nor pushed faster."""
    speed = abs(body.vx) + abs(body.vy) + abs(body.w) * body.bounding_radius
    push = abs(body.pseudo_vx) + abs(body.pseudo_vy) + abs(body.pseudo_w) * body.bounding_radius
    return speed <= most and push <= most


def disturb(world: World) -> None:
    """Mark the islands that have to stay awake: one body is not quiet, or one touches a mover."""
    bodies = world.bodies
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        if is_static_and_moves(bodies[c.a]) or is_static_and_moves(bodies[c.b]):
            bodies[pushed_body(world, c)].quiet = 0.0
    for i in range(len(bodies)):
        if bodies[i].inv_m > 0.0 and not bodies[i].is_asleep and bodies[i].quiet < QUIET_TIME:
            bodies[first_of_island(bodies, i)].is_restless = True


def fall_asleep(world: World) -> None:
    """Put the bodies of the other islands to sleep."""
    bodies = world.bodies
    for i in range(len(bodies)):
        if bodies[i].inv_m > 0.0 and not bodies[i].is_asleep:
            first = first_of_island(bodies, i)
            if not bodies[first].is_restless:
                bodies[i].island = first
                bodies[i].is_asleep = True
                world.state.asleep_count += 1


def lay_down_contacts(world: World) -> None:
    """Move the contacts of sleeping bodies from the memory to those at rest.

    The memory has just been written: its rows are those of the contacts, in their order.
    """
    state, kept = world.state, 0
    for k in range(state.contact_count):
        c = world.contacts[k]
        if world.bodies[pushed_body(world, c)].is_asleep:
            lay_down(world, c)
        else:
            copy_memory(world.memory[k], world.memory[kept])
            kept += 1
    state.memory_count = kept


def lay_down(world: World, c: ContactRow) -> None:
    """Write down a contact at rest."""
    state = world.state
    rest = world.resting[state.resting_count]
    rest.a, rest.b, rest.feature = c.a, c.b, c.feature
    rest.island = world.bodies[pushed_body(world, c)].island
    rest.dt = state.dt
    rest.x, rest.y = contact_point(c, world.bodies[c.a], world.bodies[c.b])
    rest.nx, rest.ny, rest.penetration = c.nx, c.ny, c.penetration
    rest.normal_impulse, rest.tangent_impulse = c.normal_impulse, c.tangent_impulse
    state.resting_count += 1


def copy_memory(of: MemoryRow, to: MemoryRow) -> None:
    """Copy a row of the memory."""
    to.a, to.b, to.feature = of.a, of.b, of.feature
    to.normal_impulse, to.tangent_impulse = of.normal_impulse, of.tangent_impulse


# Waking up


def wake(world: World, island: int) -> None:
    """Wake the bodies of an island, and put its contacts back into the memory."""
    state = world.state
    for body in world.bodies:
        if body.is_asleep and body.island == island:
            body.is_asleep = False
            body.quiet = 0.0
            state.asleep_count -= 1
    kept = 0
    for k in range(state.resting_count):
        if world.resting[k].island == island:
            remember(world, k)
        else:
            copy_resting(world.resting[k], world.resting[kept])
            kept += 1
    state.resting_count = kept


def remember(world: World, k: int) -> None:
    """Put the contact at rest in row k into the memory, at its place in the order of the pairs."""
    state, rest = world.state, world.resting[k]
    n = state.memory_count
    while n > 0 and is_after(world.memory[n - 1], rest.a, rest.b):
        copy_memory(world.memory[n - 1], world.memory[n])
        n -= 1
    m, longer = world.memory[n], state.dt_before / rest.dt
    m.a, m.b, m.feature = rest.a, rest.b, rest.feature
    m.normal_impulse = rest.normal_impulse * longer
    m.tangent_impulse = rest.tangent_impulse * longer
    state.memory_count += 1


def is_after(m: MemoryRow, a: int, b: int) -> bool:
    """Return whether a remembered contact comes after a pair in the order."""
    return m.a > a or (m.a == a and m.b > b)


def copy_resting(of: RestingRow, to: RestingRow) -> None:
    """Copy a row of the contacts at rest."""
    to.a, to.b, to.feature, to.island, to.dt = of.a, of.b, of.feature, of.island, of.dt
    to.x, to.y, to.nx, to.ny, to.penetration = of.x, of.y, of.nx, of.ny, of.penetration
    to.normal_impulse, to.tangent_impulse = of.normal_impulse, of.tangent_impulse

"""Impacts before the sub-steps: rigid, sweep after sweep, and no island gains energy by them.

Newton's e speaks of each contact by itself. Where bodies rub, or push one another at several
contacts, an island that bounces by it may have more energy after the impacts than before. Impacts
with e = 0 never gain any: at each contact the impulse J does the work J (u_before + u_after) / 2,
and with u_after = u_before + K J the sum of them is J u_after - J K J / 2, of which the first part
is 0 along the normals and what friction takes along the tangents.

So an island that would gain is given the impulses in between,

    J = J_0 + s (J_e - J_0),    0 <= s <= 1

J_e with the bounce, J_0 with e = 0: the largest s at which it gains nothing. What holds for both
holds for what is between them: momentum is kept, nothing approaches, friction is within mu jn.
Where nothing takes energy and the last sweep has left some out, s is a little more than 1.

References
----------
Stronge, Impact Mechanics (2000): where Newton's rule gains energy. Moreau, Unilateral contact and
dry friction in finite freedom dynamics (1988): e = 0 as the impact that dissipates.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.constants import (
    IMPACT_ROUNDING,
    IMPACT_SWEEPS,
    IMPACT_WAY,
    MOST_IMPACT_SWEEPS,
    ROUNDING_OF_WORK,
)
from lesson_code.engine.core.contact_frame import missing_velocity, velocity_at
from lesson_code.engine.core.islands import find_islands, first_of_island
from lesson_code.engine.core.motion import note_velocities
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.internal_edges import pushed_body
from lesson_code.engine.solvers import sequential as contact_solver


def let_impacts_pass(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Let bodies that approach bounce or stop, and no island gain energy by that."""
    note_velocities(world)
    solve_impacts(world, effects)
    if has_bounced(world) and note_gains(world):
        take_bounces_back(world)
        solve_impacts(world, effects)
        note_losses(world)
        give_part_of_bounces(world)


def solve_impacts(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Let bodies that approach bounce or stop, in as many sweeps as it takes up to a limit.

    A body at rest gains g h in a sub-step. Slower than that there is no impact to solve: a bounce
    would be over after two sub-steps. Without gravity the slowest impact counts.

    A pair that parts may be pressed together by a third body, up to e times its speed. It then
    approaches, and bounces in the next step.

    Where many bodies are pressed together the limit is reached before all impacts fit. What is left
    over moves bodies into one another: there it goes on for as long as that would be much.
    """
    state = world.state
    gravity = math.sqrt(state.gravity_x * state.gravity_x + state.gravity_y * state.gravity_y)
    most = gravity * state.dt + IMPACT_ROUNDING
    sweeps = 0
    while sweeps < IMPACT_SWEEPS and is_off_target(world, most):
        contact_solver.solve(world, effects)
        most = IMPACT_ROUNDING
        sweeps += 1
    while sweeps < MOST_IMPACT_SWEEPS and would_enter(world):
        contact_solver.solve(world, effects)
        sweeps += 1


def would_enter(world: World) -> bool:
    """Return whether bodies would enter one another in a sub-step, by more than a little."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        way = -missing_velocity(c, a, b) * world.state.dt
        if way > IMPACT_WAY * min(a.min_width, b.min_width):
            return True
    return False


def is_off_target(world: World, most: float) -> bool:
    """Return whether a normal velocity is wrong by more than so much, m/s."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        missing = missing_velocity(c, world.bodies[c.a], world.bodies[c.b])
        if missing < -most or (c.normal_impulse > 0.0 and missing > most):
            return True
    return False


def has_bounced(world: World) -> bool:
    """Return whether two bodies have been brought apart."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        if c.normal_impulse > 0.0 and c.target_vn > 0.0:
            return True
    return False


def note_gains(world: World) -> bool:
    """Note what each island has gained, in its first body; return whether that is wrong for one.

    A little more than rounding is none.
    """
    find_islands(world)
    for body in world.bodies:
        body.gained = body.rounding = body.lost = body.between = 0.0
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        rounding = ROUNDING_OF_WORK * c.normal_impulse * abs(c.target_vn)
        first = first_body(world, c)
        first.gained += work_on(world, c) - rounding
        first.rounding += 2 * rounding
    found = False
    for body in world.bodies:
        found = found or has_wrong_energy(world, body)
    return found


def has_wrong_energy(world: World, island: BodyRow) -> bool:
    """Return whether an island, by its first body, has gained energy, or lost what it must keep.

    Where nothing takes energy, impacts that do not fit yet after the last sweep have lost some.
    """
    return island.gained > 0.0 or (world.state.only_blows and -island.gained > island.rounding)


def work_on(world: World, c: ContactRow) -> float:
    """Return the work of a contact's impulse on its two bodies, J: that of a mover is not in it."""
    a, b = world.bodies[c.a], world.bodies[c.b]
    vn, vt = velocity_at(c, a, b)
    exchange_with_start(a, b)
    start_vn, start_vt = velocity_at(c, a, b)
    exchange_with_start(a, b)
    return (c.normal_impulse * (start_vn + vn) + c.tangent_impulse * (start_vt + vt)) / 2


def exchange_with_start(a: BodyRow, b: BodyRow) -> None:
    """Give two bodies the velocities from before the impacts; a second time undoes it."""
    for body in (a, b):
        vx, vy, w = body.vx, body.vy, body.w
        body.vx, body.vy, body.w = body.start_vx, body.start_vy, body.start_w
        body.start_vx, body.start_vy, body.start_w = vx, vy, w


def first_body(world: World, c: ContactRow) -> BodyRow:
    """Return the first body of the island that a contact belongs to."""
    return world.bodies[first_of_island(world.bodies, pushed_body(world, c))]


def take_bounces_back(world: World) -> None:
    """Go back to before the impacts, where nothing is to bounce; keep what they have made."""
    for body in world.bodies:
        body.pseudo_vx, body.pseudo_vy, body.pseudo_w = body.vx, body.vy, body.w
        body.vx, body.vy, body.w = body.start_vx, body.start_vy, body.start_w
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.normal_total, c.tangent_total = c.normal_impulse, c.tangent_impulse
        c.normal_impulse = c.tangent_impulse = 0.0
        c.target_vn = min(c.target_vn, 0.0)


def note_losses(world: World) -> None:
    """Note what each island loses without a bounce, and how far from that it is with one, J."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        first_body(world, c).lost -= work_on(world, c)
    for i in range(len(world.bodies)):
        body = world.bodies[i]
        if body.inv_m > 0.0 and not body.is_asleep:
            first = world.bodies[first_of_island(world.bodies, i)]
            dx, dy = body.pseudo_vx - body.vx, body.pseudo_vy - body.vy
            first.between += energy_of_motion(body, dx, dy, body.pseudo_w - body.w)


def energy_of_motion(body: BodyRow, vx: float, vy: float, w: float) -> float:
    """Return the kinetic energy that a body has at some velocity, J."""
    turning = w * w / body.inv_i if body.inv_i > 0.0 else 0.0
    return ((vx * vx + vy * vy) / body.inv_m + turning) / 2


def give_part_of_bounces(world: World) -> None:
    """Give each island as much of its bounce as its energy is enough for."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        s = part_of_bounce(world, first_body(world, c))
        c.normal_impulse += s * (c.normal_total - c.normal_impulse)
        c.tangent_impulse += s * (c.tangent_total - c.tangent_impulse)
    for i in range(len(world.bodies)):
        body = world.bodies[i]
        if body.inv_m > 0.0 and not body.is_asleep:
            s = part_of_bounce(world, world.bodies[first_of_island(world.bodies, i)])
            body.vx += s * (body.pseudo_vx - body.vx)
            body.vy += s * (body.pseudo_vy - body.vy)
            body.w += s * (body.pseudo_w - body.w)
        body.pseudo_vx = body.pseudo_vy = body.pseudo_w = 0.0


def part_of_bounce(world: World, island: BodyRow) -> float:
    """Return the s at which an island, by its first body, keeps its energy; 1 if it may lose more.

    gain(s) = -lost + (gained + lost - between) s + between s^2
    """
    if island.between == 0.0 or not has_wrong_energy(world, island):
        return 1.0
    if island.lost <= 0.0:
        return 0.0
    half = (island.gained + island.lost - island.between) / 2
    root = math.sqrt(half * half + island.between * island.lost)
    if half > 0.0:
        return island.lost / (half + root)
    return (root - half) / island.between

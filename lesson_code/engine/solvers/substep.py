"""Soft contacts in sub-steps: springs hold bodies apart; a relax pass takes back their speed.

Contacts are found once a step. Then the bodies move several times, and the contacts follow them.

======================  =====================================================================
stage                   what it does
======================  =====================================================================
``prepare``             effective masses, impacts, deep overlaps; once a step
``warm_start``          how far apart the points are by now; the impulses of the last sub-step
``solve``               mostly one sweep before the bodies move, each contact a damped spring
``correct``             one sweep after they have moved, each contact rigid: the relax pass
``store``               remember the impulses of the last sub-step; once a step
======================  =====================================================================

A spring of natural frequency omega and damping ratio zeta, stepped implicitly by h, asks for

    vn + gamma jn >= beta overlap / h
    beta = omega h / (2 zeta + omega h),    gamma = 1 / (m_eff omega h (2 zeta + omega h))

It gives way by gamma jn, no more than one sweep can follow: a heavy body on a light one sinks
until beta overlap / h = gamma jn, where rigid contacts would need many sweeps to carry it. What
the spring has pushed would be speed out of nothing: after the motion the rigid sweep asks for
vn >= 0 and takes it back.

What has carried a load in the last sub-step is given again, as far as that adds no energy
(``loads``). Where it no longer balances, since bodies have turned or others have come, the springs
are swept until they fit: under a heavy load a light body would be shot through a wall.

Impacts are no springs. They are solved first, rigid, from e times the speed of approach, sweep
after sweep until they fit (``impacts``); there is no other bounce in the step. Their impulses are
not repeated in a warm start. So an impact with e = 1 keeps its energy, and nothing fast is let in.

Where the points have parted within the step, they may come together again as far as the gap is
wide, and no faster: no contact pulls, and none is missed. The same holds for a contact that is
seen before the bodies touch; if they bounce, it is in the step in which they would meet. So what
just touches at the start is carried from the first sub-step on: a stack does not fall first.

What no contact has pushed in a sub-step follows its parabola: gravity makes it faster by g h, and
it moves at the mean velocity. So the energy of what flies and bounces with e = 1 is kept.

Where nothing takes energy and nobody stands from the start, nothing ever comes to rest. There are
no springs then and no relax pass: bodies pass blows after each sub-step (``blows``).

Where nothing presses bodies together, neither gravity nor a mover, there is nothing to carry. Their
contacts are rigid then, and an overlap is undone by pushes alone: a spring would give it a speed.

Two points of one manifold are solved together here too. In turn, a tower of 20 boxes that does
not stand straight has leaned over by 35 mm after 20 s; together, by 6 mm.

References
----------
Catto, Soft Constraints, Game Developers Conference (2011): beta and gamma. Macklin et al., Small
Steps in Physics Simulation (2019): sub-steps instead of sweeps. Catto, Solver2D (2024): soft
contacts with a relax pass, as in Box2D v3, compared with other solvers.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.constants import (
    BAUMGARTE_FACTOR,
    IMPACT_SWEEPS,
    MOST_IMPACT_SWEEPS,
    MOST_SUNK,
    MOST_SUNK_IN_WALL,
    SLOP,
    SOFT_DAMPING,
    SOFT_FREQUENCY,
    SOFT_SKIN,
    SOFT_WAY,
)
from lesson_code.engine.core.contact_frame import (
    apply_impulses,
    bring_to_total,
    friction_impulse,
    missing_pseudo_velocity,
    normal_impulse,
    normal_velocity,
    tangent_velocity,
)
from lesson_code.engine.core.contact_motion import gap_between, way_apart
from lesson_code.engine.core.pipeline import SolverStages
from lesson_code.engine.core.rows import BodyRow, ContactRow, State, World
from lesson_code.engine.core.sight import Sight
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.core.step import soft_part
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.solvers import sequential as contact_solver
from lesson_code.engine.solvers.block_solver import solve_pseudo_velocities, two_impulses
from lesson_code.engine.solvers.blows import pass_blows
from lesson_code.engine.solvers.impacts import let_impacts_pass
from lesson_code.engine.solvers.loads import give_loads
from lesson_code.engine.solvers.sequential import (
    has_overlap_to_undo,
    longer_than_before,
    recall,
    solve_pseudo_velocity,
)
from lesson_code.engine.solvers.visits import is_second_of_block

# Once a step


def prepare(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Compute what stays the same during the sub-steps, and let impacts and deep overlaps pass.

    Springs get no stiffer in a step that is shorter than the one before, such as the last one of a
    run may be: what rests on them would be thrown up.
    """
    contact_solver.prepare(world, effects)
    sweeps = world.state.iterations
    longest = max(world.state.dt, world.state.dt_before)
    world.state.omega = 2 * math.pi * SOFT_FREQUENCY * math.sqrt(sweeps) / longest
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        c.gap_origin = -c.penetration - way_apart(c, a, b)
        c.slack_vn = min(c.target_vn, 0.0)
        if c.penetration < 0.0:
            close_gap(world.state, c, a, b)
    let_impacts_pass(world, effects)
    begin_totals(world, effects)
    if not (world.state.only_blows and has_load(world)):
        push_deep(world, effects)


def close_gap(state: State, c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Let two bodies with skins, of which only those touch, come as near as the gap is wide.

    If they are to bounce, and would meet in this step, they bounce now: later they would be in each
    other. Two that part may be pressed together again, but come no nearer than that either.
    """
    closing = c.penetration / state.dt
    if c.target_vn <= 0.0 or normal_velocity(c, a, b) * state.substeps > closing:
        c.target_vn = closing


def begin_totals(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Put the impulses of impacts into the totals, and recall those of the last sub-step.

    The first warm start will count what is recalled, though it was given in the last step.
    """
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.normal_total, c.tangent_total = c.normal_impulse, c.tangent_impulse
        c.normal_impulse, c.tangent_impulse = 0.0, 0.0
    if has_load(world) and not world.state.only_blows:
        recall(world, effects)
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.normal_total -= c.normal_impulse
        c.tangent_total -= c.tangent_impulse


def push_deep(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Push bodies out of an overlap that is too deep for springs; the first sub-step moves them.

    What lies under a heap is pushed back in by all that is above it, the more so the lighter it is.
    There some more sweeps follow, but not many: in a box too small for its bodies they have no end.
    If they are not enough, the last word is that of the walls: what has crossed one is lost.
    """
    longer = longer_than_before(world)
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        deep = max(c.penetration - soft_depth(world, c, longer * c.normal_impulse), 0.0)
        vn = normal_velocity(c, world.bodies[c.a], world.bodies[c.b])
        later = max(vn, 0.0) * world.state.dt * (world.state.substeps - 1)
        c.pseudo_speed = max(BAUMGARTE_FACTOR * deep - later, 0.0) / world.state.dt
    if has_overlap_to_undo(world, effects):
        fewest, sweeps = world.state.substeps * world.state.iterations, 0
        while sweeps < fewest or (sweeps < IMPACT_SWEEPS and would_stay_deep(world)):
            contact_solver.correct(world, effects)
            sweeps += 1
        if sweeps == IMPACT_SWEEPS:
            push_out_of_walls(world, effects)


def push_out_of_walls(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Push bodies out of what nothing can push, be it into one another."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        if (a.inv_m > 0.0 and b.inv_m > 0.0) or is_second_of_block(world, k, effects):
            continue
        if effects.manifolds and c.is_block:
            solve_pseudo_velocities(c, world.contacts[k + 1], a, b)
        else:
            solve_pseudo_velocity(c, a, b)


def would_stay_deep(world: World) -> bool:
    """Return whether pushes leave bodies deeper in one another than they are to, by the slop."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        way = -missing_pseudo_velocity(c, a, b) * world.state.dt
        if way > SLOP * min(a.min_width, b.min_width):
            return True
    return False


def soft_depth(world: World, c: ContactRow, impulse: float) -> float:
    """Return the overlap that is left to the spring, m: what its load sinks by, and the slop."""
    state, width = world.state, min(world.bodies[c.a].min_width, world.bodies[c.b].min_width)
    sinking = impulse / (state.dt * c.normal_mass * state.omega * state.omega)
    return min(sinking, most_sunk(world, c)) + SLOP * width


def most_sunk(world: World, c: ContactRow) -> float:
    """Return the overlap at most to which a spring gives way, m: less in what nothing can push."""
    a, b = world.bodies[c.a], world.bodies[c.b]
    is_wall = a.inv_m == 0.0 or b.inv_m == 0.0
    return (MOST_SUNK_IN_WALL if is_wall else MOST_SUNK) * min(a.min_width, b.min_width)


def spring_frequency(world: World, c: ContactRow) -> float:
    """Return omega of a contact's spring, rad/s: stiffer where its load would sink too deep."""
    stiffness = c.normal_impulse / (world.state.dt * most_sunk(world, c))
    return max(world.state.omega, math.sqrt(stiffness / c.normal_mass))


def has_load(world: World) -> bool:
    """Return whether anything presses bodies together for long: gravity, or a mover."""
    state = world.state
    return state.gravity_x != 0.0 or state.gravity_y != 0.0 or state.has_moving_static


# In each sub-step


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each contact the impulse of the last sub-step; set its spring by the overlap it has.

    Without a load no force lasts: what has been given was a blow, or a push.
    """
    if world.state.only_blows:
        return
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.normal_total += c.normal_impulse
        c.tangent_total += c.tangent_impulse
    if has_load(world):
        give_loads(world, effects)
    else:
        forget(world)
    world.state.dt_before = world.state.dt
    for k in range(world.state.contact_count):
        soften(world, world.contacts[k])


def forget(world: World) -> None:
    """Begin a sub-step without impulses."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.normal_impulse = c.tangent_impulse = 0.0


def soften(world: World, c: ContactRow) -> None:
    """Set the spring of a contact by its overlap; with a gap, or nothing to carry, it is rigid."""
    h = world.state.dt
    gap = gap_between(c, world.bodies[c.a], world.bodies[c.b])
    c.target_vn = min(c.slack_vn, -max(gap, 0.0) / h)
    if gap > 0.0 or not has_load(world):
        c.soft_vn, c.softness, c.soft_mass = c.target_vn, 0.0, c.normal_mass
    else:
        omega = spring_frequency(world, c)
        damping = 2 * SOFT_DAMPING + omega * h
        overlap = min(-gap, soft_depth(world, c, c.normal_impulse))
        c.soft_vn = omega * overlap / damping  # beta overlap / h
        c.softness = 1 / (c.normal_mass * omega * h * damping)  # gamma
        c.soft_mass = 1 / (1 / c.normal_mass + c.softness)


def solve(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Sweep over all contacts as springs, mostly once: until none is far from what it asks for.

    One sweep does where the impulses of the last sub-step still balance. Where the bodies have
    turned since then, or a new contact has come, those of a heavy load give a light body a speed
    that carries it through a wall; then some more follow. Springs give way, so that they soon fit.

    Friction holds here too, or the springs would move bodies sideways: with friction in the relax
    pass alone a box of mu = 0.578 on a slope of 30 degrees still creeps at 4 mm/s after 2 s.
    """
    if world.state.only_blows:
        return
    sweeps = 0
    while sweeps == 0 or (sweeps < MOST_IMPACT_SWEEPS and is_far_from_springs(world)):
        sweep_springs(world, effects)
        sweeps += 1


def sweep_springs(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Make one sweep over all contacts as springs."""
    if effects.friction:
        contact_solver.sweep(world, effects, solve_soft_contact, solve_soft_manifold)
    else:
        contact_solver.sweep(world, effects, solve_soft_normal, solve_soft_normals)


def is_far_from_springs(world: World) -> bool:
    """Return whether a contact would move, in this sub-step, otherwise than its spring asks for."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        way = missing_soft_velocity(c, a, b) * world.state.dt
        may_change = way < 0.0 or c.normal_impulse > 0.0
        if may_change and abs(way) > SOFT_WAY * min(a.min_width, b.min_width):
            return True
    return False


def solve_soft_contact(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Solve one contact as a spring, then its friction."""
    solve_soft_normal(c, a, b)
    solve_friction(c, a, b)


def solve_soft_manifold(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Solve two points of one manifold as springs at once, then the friction of each."""
    solve_soft_normals(c, d, a, b)
    solve_friction(c, a, b)
    solve_friction(d, a, b)


def solve_soft_normal(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring one contact to its spring's velocity, by an impulse that in total only pushes."""
    missing = missing_soft_velocity(c, a, b)
    bring_to_total(c, a, b, normal_impulse(missing, c.soft_mass, 0.0, c.normal_impulse))


def solve_soft_normals(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring two points of one manifold to their springs' velocities at once."""
    missing = missing_soft_velocity(c, a, b), missing_soft_velocity(d, a, b)
    k = 1 / c.soft_mass, c.k_cross, 1 / d.soft_mass
    totals = two_impulses(k, missing, (c.normal_impulse, d.normal_impulse))
    bring_to_total(c, a, b, totals[0])
    bring_to_total(d, a, b, totals[1])


def solve_friction(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Stop the sliding, as far as Coulomb's limit mu jn allows."""
    vt = tangent_velocity(c, a, b)
    total = friction_impulse(vt, c.tangent_mass, c.friction, c.normal_impulse, c.tangent_impulse)
    apply_impulses(c, a, b, 0.0, total - c.tangent_impulse)
    c.tangent_impulse = total


def missing_soft_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return how far vn + gamma jn is from what the spring asks for, m/s."""
    return normal_velocity(c, a, b) + c.softness * c.normal_impulse - c.soft_vn


def correct(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Make one sweep over all contacts as rigid ones: springs have moved the bodies, no more."""
    if world.state.only_blows:
        pass_blows(world)
    else:
        contact_solver.solve(world, effects)


# Once a step again


def store(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Remember the impulses of the last sub-step; show those of the whole step."""
    contact_solver.store(world, effects)
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        c.normal_impulse += c.normal_total
        c.tangent_impulse += c.tangent_total


SOLVER = Solver(
    name="substep",
    stages=SolverStages(prepare, warm_start, solve, has_overlap_to_undo, correct, store),
    make_part=soft_part,
    shares_contacts=True,
    sight=Sight(SOFT_SKIN),
    iterations=1,
    substeps=4,
    built_in={"warm_starting": "each sub-step begins with the impulses of the one before"},
)

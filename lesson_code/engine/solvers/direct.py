"""The direct solver: the contacts of each island are solved at once, and exactly.

Sweeps carry a load from contact to contact, a little with each; the taller a stack and the heavier
the body on top, the more of them it takes. Here the impulses of all contacts of an island are the
answer of one complementarity problem (``complementarity``), whatever the masses.

=============  ==============================================================================
stage          what it does
=============  ==============================================================================
`warm_start`   recalls what each contact did in the last step: opened, stuck or slid
`prepare`      lets impacts pass (``direct_impacts``)
`solve`        finds the impulses that keep contacts closed against gravity, and gives them
`correct`      finds the pushes that undo overlaps, and gives them
`store`        stops what sticks, and remembers the impulses
=============  ==============================================================================

Its step (``step.midpoint_part``) breaks no law by its length. An impact takes no time: its impulses
follow from the velocities before it, by a law that gains no energy. The forces hold for the
velocity u at which the contacts really move, (1 - theta) u before + theta u after them:

    jn >= 0,    gap + h un >= 0,    jn (gap + h un) = 0     and friction against ut

With theta = 1/2 the work of all forces on the way is the change of the energy, and that of the
contacts is <= 0; with theta = 1 it is less than that by x K x / 2. Impulses of a pair act at one
point, so that both momenta are kept.

This solver works on arrays with NumPy, and is not meant to be compiled.

References
----------
Moreau, Unilateral contact and dry friction in finite freedom dynamics (1988). Jean, The non-smooth
contact dynamics method (1999). Acary, Energy conservation and dissipation properties of
time-integration methods for nonsmooth elastodynamics with contact (2016): theta = 1/2.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from lesson_code.engine.core.constants import (
    BAUMGARTE_FACTOR,
    FINE_SLOP,
    LOOKS_OF_AN_IMPACT,
    SKIN,
)
from lesson_code.engine.core.islands import (
    Floats,
    Island,
    apply_impulses,
    apply_pseudo_impulses,
    islands_of,
    pseudo_velocities,
    start_velocities,
    velocities,
)
from lesson_code.engine.core.pipeline import SolverStages
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.core.sight import Sight
from lesson_code.engine.core.skin import gap_of
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.core.step import midpoint, midpoint_part
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.solvers import sequential as contact_solver
from lesson_code.engine.solvers.angular_momentum import keep_angular_momentum
from lesson_code.engine.solvers.complementarity import solve_contacts
from lesson_code.engine.solvers.contact_problem import (
    BACKWARD,
    FORWARD,
    OPEN,
    STICK,
    UNKNOWN,
    Problem,
)
from lesson_code.engine.solvers.direct_impacts import (
    impacts_of,
    is_fine,
    next_closing,
    open_gap,
    pairs_of,
    quiet_of,
    rounding_of,
)
from lesson_code.engine.solvers.impact_rules import (
    STRIKE_RULES,
    StrikeRule,
    gravity_of,
    quiet_speed,
)
from lesson_code.engine.solvers.pivoting import least_solution

NEW = -1.0
"""What stands in a contact's impulse until the memory has been asked."""

ALMOST = 1.0 - 1e-9
"""Of mu jn: a friction impulse that is no smaller is at the limit, but for rounding."""

SIDE = {FORWARD: 1.0, BACKWARD: -1.0}
"""The sign of the friction impulse where a contact slides."""


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Recall the cases of the last step: the first guess, whatever its length was."""
    contacts = world.contacts[: world.state.contact_count]
    for c in contacts:
        c.normal_impulse = NEW
    contact_solver.recall(world)
    for c in contacts:
        c.case = case_of(c)
        c.normal_impulse, c.tangent_impulse = 0.0, 0.0
        c.normal_total, c.tangent_total = 0.0, 0.0


def case_of(c: ContactRow) -> int:
    """Return the case that a contact's impulses belong to."""
    if c.normal_impulse == NEW:
        return UNKNOWN
    if c.normal_impulse <= 0.0:
        return OPEN
    if abs(c.tangent_impulse) < c.friction * c.normal_impulse * ALMOST:
        return STICK
    return FORWARD if c.tangent_impulse > 0.0 else BACKWARD


def prepare(
    world: World, effects: Effects = EVERY_EFFECT, *, islands: list[Island], rule: StrikeRule
) -> None:
    """Find the islands, give each the impulses of its impacts, and note when the next is due.

    What stops no more than a quiet approach is no impact: it may be rounding, and the looks that an
    impact counts for are missing where something else comes down in this step.
    """
    state = world.state
    islands[:] = islands_of(world) if state.contact_count > 0 else []
    has_impact = False
    for island in islands:
        contacts, m = island.contacts, len(island.contacts)
        gap = np.array([open_gap(world, c) for c in contacts])
        u = velocities(island)
        if (u[:m] < 0.0).any():
            x = impacts_of(world, island, gap, u, rule)
            change = island.delassus @ x
            has_impact = has_impact or float(change[:m].max()) > quiet_of(world, island, u)
            apply_impulses(island, x)
            add_to_totals(contacts, x)
            u = u + change
        if is_fine(world, island):
            state.horizon = min(state.horizon, next_closing(world, island, gap, u[:m]))
    if state.horizon < state.left:
        state.impacts += LOOKS_OF_AN_IMPACT if has_impact else 1


# Forces


def solve(world: World, effects: Effects = EVERY_EFFECT, *, islands: list[Island]) -> None:
    """Give each island the impulses that keep its contacts from closing further."""
    state = world.state
    theta = midpoint(state)
    for island in islands:
        contacts, m = island.contacts, len(island.contacts)
        x = np.zeros(2 * m)
        if not any(body.waits for body in island.bodies):
            u = (1.0 - theta) * start_velocities(island) + theta * velocities(island)
            u[:m] += gaps_left(world, island) / state.dt
            problem = Problem(theta * island.delassus, u, island.friction, island.scale)
            answer = solve_contacts(problem, np.array([c.case for c in contacts]))
            x = answer.impulses
            state.softened += answer.method == "softened"
            apply_impulses(island, x)
        jn, jt = x[:m].tolist(), x[m:].tolist()
        for c, normal, tangent in zip(contacts, jn, jt, strict=True):
            c.normal_impulse, c.tangent_impulse = normal, tangent
            c.case = case_of(c)


def gaps_left(world: World, island: Island) -> Floats:
    """Return how far each contact may still close, m, shape (m,).

    A gap counts as closed if what rounding leaves of the velocities opens as much in one step. A
    light box under a heavy load would rock on its corners for ever.
    """
    gap = np.array([gap_of(c) for c in island.contacts])
    return np.where(gap > world.state.dt * standing_rounding(world, island), gap, 0.0)


def standing_rounding(world: World, island: Island) -> float:
    """Return what rounding leaves of the velocities of an island that stands, m/s."""
    return rounding_of(island, gravity_of(world.state) * world.state.dt)


def store(world: World, effects: Effects = EVERY_EFFECT, *, islands: list[Island]) -> None:
    """Stop what sticks, and remember the impulses of the forces; then add those of the impacts.

    At theta = 1/2 it is the mean velocity of a contact that is 0 where it sticks. What it slid with
    before, it slides back with after: that is taken from it, which can only cost energy. So is what
    a contact slides back with that stops on the way. The bodies move as they would have.
    """
    if midpoint(world.state) < 1.0:
        for island in islands:
            if any(c.normal_impulse > 0.0 for c in island.contacts):
                settle(island, max(quiet_speed(world.state), standing_rounding(world, island)))
    contact_solver.store(world, effects)
    for c in world.contacts[: world.state.contact_count]:
        c.normal_impulse += c.normal_total
        c.tangent_impulse += c.tangent_total


def settle(island: Island, quiet: float) -> None:
    """Take the sliding velocity from contacts that stick, and what is quiet where they rest.

    Otherwise what rounding leaves of a velocity would come and go for ever. Where a contact slides,
    the impulse that stops its approach comes with its friction; but in a jam that may be so large
    that it gains energy, and then without it: a velocity that is taken away costs some.

    What a pair of bodies slides with is the mean of its contacts that stick. They lie on a line
    along the tangent, but for a little overlap; held each for itself, they would stop the spin of a
    plank by the lever of that overlap, with friction a hundred thousand times its weight.
    """
    contacts, m = island.contacts, len(island.contacts)
    u = velocities(island)
    rests = [k for k, c in enumerate(contacts) if c.normal_impulse > 0.0 and abs(u[k]) <= quiet]
    sides = [SIDE.get(c.case, 0.0) for c in contacts]
    for k, side in enumerate(sides):
        if island.friction[k] > 0.0 and side * u[m + k] > 0.0:  # friction has turned it round
            contacts[k].case, sides[k] = STICK, 0.0
    stuck = [[m + k for k in pair if contacts[k].case == STICK] for pair in pairs_of(contacts)]
    held = [[k] for k in rests] + [places for places in stuck if places]
    of_held = np.zeros((2 * m, len(held)))
    for column, places in enumerate(held):
        of_held[places, column] = 1.0 / len(places)
    if (u @ of_held).any():
        with_friction = of_held.copy()
        for column, k in enumerate(rests):
            with_friction[m + k, column] = sides[k] * island.friction[k]
        d = np.concatenate((island.scale, island.scale)) @ of_held
        for given in (with_friction, of_held):
            equations = (of_held * d).T @ island.delassus @ (given * d)
            x = given @ (d * least_solution(equations, d * (u @ of_held)))
            gained = x @ u + x @ island.delassus @ x / 2.0
            if gained <= 0.0:
                break
        apply_impulses(island, x)
        apply_pseudo_impulses(island, -x)
        add_to_totals(contacts, x)


def add_to_totals(contacts: list[ContactRow], x: Floats) -> None:
    """Add impulses to those that are written down beside the forces'."""
    m = len(contacts)
    for c, normal, tangent in zip(contacts, x[:m].tolist(), x[m:].tolist(), strict=True):
        c.normal_total += normal
        c.tangent_total += tangent


# Pushes


def _width(world: World, c: ContactRow) -> float:
    """Return the smaller width of the bodies of a contact, m."""
    return min(world.bodies[c.a].min_width, world.bodies[c.b].min_width)


def has_overlap_to_undo(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Return whether any contact overlaps by too much; note how fast each is to be undone."""
    found = False
    for c in world.contacts[: world.state.contact_count]:
        excess = c.penetration - FINE_SLOP * _width(world, c)
        c.pseudo_speed = BAUMGARTE_FACTOR * max(excess, 0.0) / world.state.dt
        c.pseudo_impulse = 0.0
        found = found or excess > 0.0
    return found


def correct(world: World, effects: Effects = EVERY_EFFECT, *, islands: list[Island]) -> None:
    """Give each island with an overlap to undo the pushes that undo it, with friction."""
    for island in islands:
        contacts, m = island.contacts, len(island.contacts)
        if any(c.pseudo_speed > 0.0 for c in contacts):
            moving = velocities(island) + pseudo_velocities(island)
            missing = np.zeros(2 * m)
            missing[:m] = np.maximum(moving[:m], 0.0)
            missing[:m] += [gap_of(c) / world.state.dt - c.pseudo_speed for c in contacts]
            problem = Problem(island.delassus, missing, island.friction, island.scale)
            if (missing[:m] < 0.0).any() and not any(body.waits for body in island.bodies):
                x = solve_contacts(problem).impulses
                apply_pseudo_impulses(island, x)
                keep_angular_momentum(island, x, world.state.dt)
                for c, push in zip(contacts, x[:m].tolist(), strict=True):
                    c.pseudo_impulse = push


def make_stages(impacts: str, restitution_law: str) -> SolverStages:
    """Return the stages of a run; its islands are found once for each part of a step."""
    islands: list[Island] = []
    rule = STRIKE_RULES[impacts, restitution_law]
    return SolverStages(
        prepare=partial(prepare, islands=islands, rule=rule),
        warm_start=warm_start,
        solve=partial(solve, islands=islands),
        has_overlap_to_undo=has_overlap_to_undo,
        correct=partial(correct, islands=islands),
        store=partial(store, islands=islands),
    )


_OWN = "the direct solver finds all impulses of an island at once"

SOLVER = Solver(
    name="direct",
    make_part=midpoint_part,
    sight=Sight(SKIN, SKIN),
    has_matrices=True,
    has_one_sweep=True,
    options={
        "impacts": ("simultaneous", "sequential"),
        "restitution_law": ("energetic", "newton"),
    },
    make_stages=make_stages,
    never_compiled="the direct solver works on arrays of its own",
    built_in={"friction": _OWN, "warm_starting": "the cases of the last step are the first guess"},
)

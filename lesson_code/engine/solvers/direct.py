"""The direct solver: the contacts of each island are solved at once, and exactly.

Sweeps carry a load from contact to contact, a little with each; the taller a stack and the heavier
the body on top, the more of them it takes. Here the impulses of all contacts of an island are the
answer of one complementarity problem (``complementarity``), whatever the masses.

=============  ==============================================================================
stage          what it does
=============  ==============================================================================
`warm_start`   recalls what each contact did in the last step: opened, stuck or slid
`prepare`      lets impacts pass, by a law of impacts (``impact_rules``)
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

import math
from functools import partial

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.constants import (
    BAUMGARTE_FACTOR,
    FINE_LOOKS,
    FINE_SLOP,
    LOOKS_OF_AN_IMPACT,
    MOST_FINE,
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
from lesson_code.engine.core.skin import gap_of, touching_gap
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
    ROUNDING,
    STICK,
    UNKNOWN,
    Problem,
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

MOST_ROUNDS, MOST_IN_FEW = 8, 10_000
"""Rounds of impacts at one time, in an island of m contacts: 8 m, or 10,000 / m if that is more.
What still closes then stops without a bounce. A light elastic body hits two heavy ones that close
as often as the root of the ratio of their masses, once a round."""

QUIET = 1e-9
"""Of the fastest approach: slower ones are stopped without a bounce."""

STILL = 4e-12
"""Of the fastest approach and the speed that gravity gives in a step: slower ones are none, so that
what stands costs no impact in each step. At 1e-12 rounding in a stack of 64 is above it."""


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


# Impacts


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
            jn, jt = x[:m].tolist(), x[m:].tolist()
            for c, normal, tangent in zip(contacts, jn, jt, strict=True):
                c.normal_total, c.tangent_total = normal, tangent
            u = u + change
        if is_fine(world, island):
            state.horizon = min(state.horizon, next_closing(world, island, gap, u[:m]))
    if state.horizon < state.left:
        state.impacts += LOOKS_OF_AN_IMPACT if has_impact else 1


def is_fine(world: World, island: Island) -> bool:
    """Return whether impacts in an island come exactly where its bodies touch."""
    return len(island.contacts) <= MOST_FINE and world.state.impacts < FINE_LOOKS


def open_gap(world: World, c: ContactRow) -> float:
    """Return the gap that a contact has still to close, m; 0 if the bodies touch."""
    gap = gap_of(c)
    return gap if gap > touching_gap(world.bodies[c.a], world.bodies[c.b]) else 0.0


def is_to_come(way: Floats, gap: Floats) -> NDArray[np.bool_]:
    """Return which contacts have not closed yet, and do if they come nearer by so much, m."""
    comes: NDArray[np.bool_] = (gap > 0.0) & (way > gap)
    return comes


def next_closing(world: World, island: Island, gap: Floats, un: Floats) -> float:
    """Return when the next gap closes, s, at the earliest; infinite if none does in this step.

    Where bodies bounce, gravity alone may close it: gap = -un t + g t^2 / 2.
    """
    left, g = world.state.left, gravity_of(world.state)
    pulls = [pull(world, c) if c.restitution > 0.0 else 0.0 for c in island.contacts]
    falls = np.maximum(pulls, 0.0) * left * left / 2
    comes = is_to_come(falls - un * left, gap)
    gap, approach = gap[comes], -un[comes]
    times = 2.0 * gap / (approach + np.sqrt(approach * approach + 2.0 * g * gap))
    return float(times.min(initial=math.inf))


def pull(world: World, c: ContactRow) -> float:
    """Return how gravity makes the bodies of a contact approach, m/s^2."""
    state, a, b = world.state, world.bodies[c.a], world.bodies[c.b]
    falls = float(a.inv_m > 0.0) - float(b.inv_m > 0.0)
    return falls * (state.gravity_x * c.nx + state.gravity_y * c.ny)


def impacts_of(world: World, island: Island, gap: Floats, u: Floats, rule: StrikeRule) -> Floats:
    """Return the impulses of the impacts of an island, shape (2m,), N s.

    All contacts that touch take part; in a large island, and after too many impacts in this step,
    those as well that would touch before its end. No law of impacts lets contacts close faster
    than e times the speed at which they parted; where they do, no answer was found, and they are
    stopped.
    """
    contacts, m = island.contacts, len(island.contacts)
    touches = gap == 0.0
    problem = Problem(island.delassus, u, island.friction, island.scale)
    restitution = np.array([c.restitution for c in contacts])
    speed, quiet = speed_of(world, island, u), quiet_of(world, island, u)
    x, has_answer = np.zeros(2 * m), True
    for rounds in reversed(range(max(MOST_ROUNDS * m, MOST_IN_FEW // m))):
        if not is_fine(world, island):
            touches |= is_to_come(-u[:m] * world.state.left, gap)
        closes = touches & (u[:m] < -STILL * speed)
        if not closes.any():
            break
        is_last = rounds == 0 or not has_answer or (u[:m][closes] >= -quiet).all()
        points = np.flatnonzero(touches)
        both = np.concatenate((points, m + points))
        part = problem._replace(velocity=u).part(points)
        if is_last:
            y = solve_contacts(part).impulses
        else:
            y = rule(part, restitution[points], _pairs([contacts[k] for k in points]), quiet)
        x[both] += y
        least = -restitution[points] * np.maximum(u[points], 0.0) - quiet
        u = u + island.delassus[:, both] @ y
        has_answer = bool((u[points] >= least).all())
        if is_last:
            break
    return x


def quiet_of(world: World, island: Island, u: Floats) -> float:
    """Return the speed of approach, m/s, that an island stops without a bounce."""
    fastest = -float(u[: len(island.contacts)].min())
    rounding = rounding_of(island, speed_of(world, island, u))
    return max(quiet_speed(world.state), QUIET * fastest, rounding)


def speed_of(world: World, island: Island, u: Floats) -> float:
    """Return the fastest approach in an island and what gravity gives in a step, m/s."""
    fastest = -float(u[: len(island.contacts)].min())
    return fastest + gravity_of(world.state) * world.state.dt


def rounding_of(island: Island, speed: float) -> float:
    """Return what rounding leaves of the velocities of an island that stops from a speed, m/s.

    A light body between heavy ones shows it most: the impulses that stop those add up to nothing
    for it, but for their last digits.
    """
    load = speed * sum(1.0 / body.inv_m for body in island.bodies if body.inv_m > 0.0)
    return ROUNDING * float(island.delassus.diagonal().max()) * load


def _pairs(contacts: list[ContactRow]) -> list[list[int]]:
    """Return the places of the contacts of each pair of bodies, which stand side by side."""
    pairs: list[list[int]] = []
    last = (-1, -1)
    for k, c in enumerate(contacts):
        if (c.a, c.b) != last:
            pairs.append([])
            last = (c.a, c.b)
        pairs[-1].append(k)
    return pairs


def _width(world: World, c: ContactRow) -> float:
    """Return the smaller width of the bodies of a contact, m."""
    return min(world.bodies[c.a].min_width, world.bodies[c.b].min_width)


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
    the impulse that stops its approach comes with its friction.

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
    stuck = [[m + k for k in pair if contacts[k].case == STICK] for pair in _pairs(contacts)]
    held = [[k] for k in rests] + [places for places in stuck if places]
    of_held = np.zeros((2 * m, len(held)))
    for column, places in enumerate(held):
        of_held[places, column] = 1.0 / len(places)
    if (u @ of_held).any():
        with_friction = of_held.copy()
        for column, k in enumerate(rests):
            with_friction[m + k, column] = sides[k] * island.friction[k]
        d = np.concatenate((island.scale, island.scale)) @ of_held
        equations = (of_held * d).T @ island.delassus @ (with_friction * d)
        x = with_friction @ (d * least_solution(equations, d * (u @ of_held)))
        apply_impulses(island, x)
        apply_pseudo_impulses(island, -x)


# Pushes


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
    skin=SKIN,
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

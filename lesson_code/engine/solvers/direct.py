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

from functools import partial

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.constants import BAUMGARTE_FACTOR, FINE_IMPACTS, FINE_SLOP, SKIN
from lesson_code.engine.core.islands import (
    Floats,
    Island,
    apply_impulses,
    apply_pseudo_impulses,
    island_of,
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
    RANK,
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

NEW = -1.0
"""What stands in a contact's impulse until the memory has been asked."""

ALMOST = 1.0 - 1e-9
"""Of mu jn: a friction impulse that is no smaller is at the limit, but for rounding."""

MOST_ROUNDS = 8
"""Impacts at each contact at one time: then what still closes stops without a bounce."""

ROUNDING = 1e-9
"""Of the fastest approach: slower ones are left over by rounding, and stopped without a bounce."""


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Recall the cases of the last step: the first guess, whatever its length was."""
    contacts = world.contacts[: world.state.contact_count]
    for c in contacts:
        c.normal_impulse = NEW
    contact_solver.recall(world)
    for c in contacts:
        c.case = case_of(c)
        c.normal_impulse, c.tangent_impulse = 0.0, 0.0


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


def prepare(world: World, effects: Effects = EVERY_EFFECT, *, rule: StrikeRule) -> None:
    """Give each island the impulses of its impacts, and note when the next one is due."""
    state = world.state
    for c in world.contacts[: state.contact_count]:
        c.normal_total, c.tangent_total = 0.0, 0.0
    for contacts in islands_of(world):
        island, m = island_of(world, contacts), len(contacts)
        gap = np.array([gap_of(c) for c in contacts])
        u = velocities(island)
        if (u[:m] < 0.0).any():
            x = impacts_of(world, island, gap, u, rule)
            apply_impulses(island, x)
            jn, jt = x[:m].tolist(), x[m:].tolist()
            for c, normal, tangent in zip(contacts, jn, jt, strict=True):
                c.normal_total, c.tangent_total = normal, tangent
            u = u + island.delassus @ x
            comes = is_to_come(u[:m], gap, state.left)
            if comes.any():
                after = closing_times(gap[comes], -u[:m][comes], gravity_of(state))
                state.horizon = min(state.horizon, float(after.min()))
    if state.horizon < state.left:
        state.impacts += 1


def is_to_come(un: Floats, gap: Floats, left: float) -> NDArray[np.bool_]:
    """Return which contacts close in the time that is left, s, and have not closed yet."""
    comes: NDArray[np.bool_] = (gap > 0.0) & (-un * left > gap)
    return comes


def closing_times(gap: Floats, approach: Floats, gravity: float) -> Floats:
    """Return when gaps close, s, at the earliest: gap = approach t + gravity t^2 / 2."""
    times: Floats = 2.0 * gap / (approach + np.sqrt(approach * approach + 2.0 * gravity * gap))
    return times


def impacts_of(world: World, island: Island, gap: Floats, u: Floats, rule: StrikeRule) -> Floats:
    """Return the impulses of the impacts of an island, shape (2m,), N s.

    All contacts that touch take part; if there have been too many impacts in this step, those as
    well that would touch before its end.
    """
    contacts, m = island.contacts, len(island.contacts)
    bodies = world.bodies
    touches = gap <= np.array([touching_gap(bodies[c.a], bodies[c.b]) for c in contacts])
    gap[touches] = 0.0
    problem = Problem(island.delassus, u, island.friction, island.scale)
    restitution = np.array([c.restitution for c in contacts])
    quiet = max(quiet_speed(world.state), -ROUNDING * float(u[:m].min()))
    x = np.zeros(2 * m)
    for rounds in reversed(range(MOST_ROUNDS * m)):
        if world.state.impacts >= FINE_IMPACTS:
            touches |= is_to_come(u[:m], gap, world.state.left)
        closes = touches & (u[:m] < 0.0)
        if not closes.any():
            break
        is_last = rounds == 0 or (u[:m][closes] >= -quiet).all()
        points = np.flatnonzero(touches)
        both = np.concatenate((points, m + points))
        part = problem._replace(velocity=u).part(points)
        if is_last:
            y = solve_contacts(part).impulses
        else:
            y = rule(part, restitution[points], _pairs([contacts[k] for k in points]), quiet)
        x[both] += y
        u = u + island.delassus[:, both] @ y
        if is_last:
            break
    return x


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


def solve(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each island the impulses that keep its contacts from closing further."""
    state = world.state
    theta = midpoint(state)
    for contacts in islands_of(world):
        island, m = island_of(world, contacts), len(contacts)
        x = np.zeros(2 * m)
        if not any(body.waits for body in island.bodies):
            u = (1.0 - theta) * start_velocities(island) + theta * velocities(island)
            u[:m] += np.array([gap_of(c) for c in contacts]) / state.dt
            problem = Problem(theta * island.delassus, u, island.friction, island.scale)
            answer = solve_contacts(problem, np.array([c.case for c in contacts]))
            x = answer.impulses
            state.softened += answer.method == "softened"
            apply_impulses(island, x)
        jn, jt = x[:m].tolist(), x[m:].tolist()
        for c, normal, tangent in zip(contacts, jn, jt, strict=True):
            c.normal_impulse, c.tangent_impulse = c.normal_total + normal, c.tangent_total + tangent
            sticks = abs(tangent) < c.friction * normal * ALMOST
            c.case = STICK if sticks else OPEN


def store(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Stop what sticks, and remember the impulses of this step for the next.

    At theta = 1/2 it is the mean velocity of a contact that is 0 where it sticks. What it slid with
    before, it slides back with after: that is taken from it, which can only cost energy. The
    bodies move as they would have.
    """
    if midpoint(world.state) < 1.0:
        for contacts in islands_of(world):
            if any(c.case == STICK for c in contacts):
                settle(island_of(world, contacts))
    contact_solver.store(world, effects)


def settle(island: Island) -> None:
    """Take the sliding velocity from contacts that stick."""
    contacts, m = island.contacts, len(island.contacts)
    sticks = m + np.array([k for k, c in enumerate(contacts) if c.case == STICK])
    sliding = velocities(island)[sticks]
    if sliding.any():
        d = island.scale[sticks - m]
        k = island.delassus[np.ix_(sticks, sticks)] * d * d[:, np.newaxis]
        x = np.zeros(2 * m)
        x[sticks] = d * np.linalg.lstsq(k, -d * sliding, rcond=RANK)[0]
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


def correct(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each island with an overlap to undo the pushes that undo it, with friction."""
    for contacts in islands_of(world):
        if any(c.pseudo_speed > 0.0 for c in contacts):
            island, m = island_of(world, contacts), len(contacts)
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


def stages_with(rule: StrikeRule) -> SolverStages:
    """Return the stages for a rule of impacts."""
    impacts = partial(prepare, rule=rule)
    return SolverStages(impacts, warm_start, solve, has_overlap_to_undo, correct, store)


_OWN = "the direct solver finds all impulses of an island at once"

_STAGES = {values: stages_with(rule) for values, rule in STRIKE_RULES.items()}

SOLVER = Solver(
    name="direct",
    stages=_STAGES["simultaneous", "energetic"],
    make_part=midpoint_part,
    skin=SKIN,
    has_one_sweep=True,
    options={
        "impacts": ("simultaneous", "sequential"),
        "restitution_law": ("energetic", "newton"),
    },
    variants=_STAGES,
    never_compiled="the direct solver works on arrays of its own",
    built_in={"friction": _OWN, "warm_starting": "the cases of the last step are the first guess"},
)

"""The direct solver: the contacts of each island are solved at once, and exactly.

Sweeps carry a load from contact to contact, a little with each; the taller a stack and the heavier
the body on top, the more of them it takes. Here the impulses of all contacts of an island are the
answer of one complementarity problem (``complementarity``), whatever the masses.

=============  ==============================================================================
stage          what it does
=============  ==============================================================================
`prepare`      the bounce to reach, the overlap to undo: as the sequential solver does
`warm_start`   recalls what each contact did in the last step: opened, stuck or slid
`solve`        finds the impulses of each island, and gives them
`correct`      finds the pushes that undo the overlaps of each island, and gives them
`store`        remembers the impulses, of which that can be read
=============  ==============================================================================

`solve` and `correct` add what is missing to what has been given; a second call adds nothing.
`prepare_strikes` and `begin_with_strikes` take the places of `prepare` and `warm_start` where a
rule for impacts other than Newton's, for all at once, is wanted (``impact_rules``).

This solver works on arrays with NumPy, and is not meant to be compiled.
"""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from lesson_code.engine.core.constants import BAUMGARTE_FACTOR, FINE_SLOP
from lesson_code.engine.core.contact_motion import apply_impulse, normal_of, tangent_of
from lesson_code.engine.core.islands import (
    Floats,
    Island,
    apply_impulses,
    apply_pseudo_impulses,
    island_of,
    islands_of,
    pseudo_velocities,
    velocities,
)
from lesson_code.engine.core.pipeline import SolverStages
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.core.solver import NEVER_SLEEPS, Solver
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.solvers import sequential as contact_solver
from lesson_code.engine.solvers.complementarity import solve_contacts
from lesson_code.engine.solvers.contact_problem import (
    BACKWARD,
    FORWARD,
    OPEN,
    STICK,
    UNKNOWN,
    Problem,
)
from lesson_code.engine.solvers.impact_rules import STRIKE_RULES, StrikeRule, quiet_speed

store = contact_solver.store

NEW = -1.0
"""What stands in a contact's impulse until the memory has been asked."""

ALMOST = 1.0 - 1e-9
"""Of mu jn: a friction impulse that is no smaller is at the limit, but for rounding."""


def prepare(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Prepare as the sequential solver does, but for a finer slop."""
    contact_solver.prepare(world, effects)
    for c in world.contacts[: world.state.contact_count]:
        slop = FINE_SLOP * min(world.bodies[c.a].min_width, world.bodies[c.b].min_width)
        c.pseudo_speed = BAUMGARTE_FACTOR * max(c.penetration - slop, 0.0) / world.state.dt


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Begin without impulses, but with the cases of the last step.

    They are the first guess, whatever the length of that step was; the answer is exact without it.
    """
    recall_cases(world)


def recall_cases(world: World) -> None:
    """Set each contact's case from the last step; the impulses given so far stay."""
    contacts = world.contacts[: world.state.contact_count]
    given = [(c.normal_impulse, c.tangent_impulse) for c in contacts]
    for c in contacts:
        c.normal_impulse = NEW
    contact_solver.recall(world)
    for c, impulses in zip(contacts, given, strict=True):
        c.case = case_of(c)
        c.normal_impulse, c.tangent_impulse = impulses


def case_of(c: ContactRow) -> int:
    """Return the case that a contact's impulses belong to."""
    if c.normal_impulse == NEW:
        return UNKNOWN
    if c.normal_impulse <= 0.0:
        return OPEN
    if abs(c.tangent_impulse) < c.friction * c.normal_impulse * ALMOST:
        return STICK
    return FORWARD if c.tangent_impulse > 0.0 else BACKWARD


def solve(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each island the impulses that bring its contacts to their targets."""
    for contacts in islands_of(world):
        island = island_of(world, contacts)
        missing = velocities(island)
        missing[: len(contacts)] -= [c.target_vn for c in contacts]
        problem = Problem(island.delassus, missing, island.friction)
        answer = solve_contacts(problem, np.array([c.case for c in contacts]))
        apply_impulses(island, answer.impulses)
        note_impulses(contacts, answer.impulses)
        if answer.method == "softened":
            world.state.softened += 1


def has_overlap_to_undo(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Return whether any contact overlaps by too much."""
    return any(c.pseudo_speed > 0.0 for c in world.contacts[: world.state.contact_count])


def correct(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each island with an overlap to undo the pushes that undo it."""
    for contacts in islands_of(world):
        if any(c.pseudo_speed > 0.0 for c in contacts):
            island = island_of(world, contacts)
            x = solve_contacts(_push_problem(island)).impulses
            apply_pseudo_impulses(island, x)
            for k, c in enumerate(contacts):
                c.pseudo_impulse += float(x[k])


def prepare_strikes(world: World, effects: Effects = EVERY_EFFECT, *, rule: StrikeRule) -> None:
    """Find the impulses of all impacts by a rule, at the velocities before gravity acts.

    What the impacts have brought a contact to is the velocity it has to keep against gravity.
    """
    prepare(world, effects)
    quiet = quiet_speed(world.state)
    for contacts in islands_of(world):
        island = island_of(world, contacts)
        restitution = np.array([c.restitution for c in contacts])
        problem = Problem(island.delassus, velocities(island), island.friction)
        x = rule(problem, restitution, _pairs(contacts), quiet)
        note_impulses(contacts, x)
        reached = problem.velocity + island.delassus @ x
        for k, c in enumerate(contacts):
            c.target_vn = max(float(reached[k]), 0.0) if x[k] > 0.0 else 0.0


def begin_with_strikes(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give the bodies the impulses of the impacts."""
    recall_cases(world)
    for c in world.contacts[: world.state.contact_count]:
        a, b = world.bodies[c.a], world.bodies[c.b]
        apply_impulse(c, a, b, normal_of(c), c.normal_impulse)
        apply_impulse(c, a, b, tangent_of(c), c.tangent_impulse)


def note_impulses(contacts: list[ContactRow], x: Floats) -> None:
    """Add impulses to what the contacts have received."""
    jn, jt = x[: len(contacts)].tolist(), x[len(contacts) :].tolist()
    for c, normal, tangent in zip(contacts, jn, jt, strict=True):
        c.normal_impulse += normal
        c.tangent_impulse += tangent


def _push_problem(island: Island) -> Problem:
    """Return the problem of the position correction; the bodies' own parting counts."""
    m = len(island.contacts)
    missing = pseudo_velocities(island)
    missing[:m] += np.maximum(velocities(island)[:m], 0.0)
    missing[:m] -= [c.pseudo_speed for c in island.contacts]
    missing[m:] = 0.0
    return Problem(island.delassus, missing, np.zeros(m))


def _pairs(contacts: list[ContactRow]) -> list[list[int]]:
    """Return the places of the contacts of each pair of bodies, which stand side by side."""
    pairs: list[list[int]] = []
    last = (math.nan, math.nan)
    for k, c in enumerate(contacts):
        if (c.a, c.b) != last:
            pairs.append([])
            last = (c.a, c.b)
        pairs[-1].append(k)
    return pairs


def stages_with(rule: StrikeRule) -> SolverStages:
    """Return the stages for a rule of impacts that is not the usual one."""
    first = partial(prepare_strikes, rule=rule)
    return SolverStages(first, begin_with_strikes, solve, has_overlap_to_undo, correct, store)


_OWN = "the direct solver finds all impulses of an island at once"

SOLVER = Solver(
    name="direct",
    stages=SolverStages(prepare, warm_start, solve, has_overlap_to_undo, correct, store),
    has_one_sweep=True,
    options={
        "impacts": ("simultaneous", "sequential"),
        "restitution_law": ("newton", "energetic"),
    },
    variants={values: stages_with(rule) for values, rule in STRIKE_RULES.items()},
    never_compiled="the direct solver works on arrays of its own",
    lacks=NEVER_SLEEPS,
    built_in={"friction": _OWN, "warm_starting": "the cases of the last step are the first guess"},
)

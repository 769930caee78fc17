"""The impacts of the direct solver: they come where bodies touch, and take no time.

The step of the solver (``step.midpoint_part``) ends where the next gap closes. There the impulses
of an island follow from its velocities, by a law of impacts (``impact_rules``).
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.constants import FINE_LOOKS, MOST_FINE
from lesson_code.engine.core.islands import Floats, Island
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.core.skin import gap_of, touching_gap
from lesson_code.engine.solvers.complementarity import solve_contacts
from lesson_code.engine.solvers.contact_problem import ROUNDING, Problem
from lesson_code.engine.solvers.impact_rules import StrikeRule, gravity_of, quiet_speed

MOST_ROUNDS, MOST_IN_FEW = 8, 10_000
"""Rounds of impacts at one time, in an island of m contacts: 8 m, or 10,000 / m if that is more.
What still closes then stops without a bounce. A light elastic body hits two heavy ones that close
as often as the root of the ratio of their masses, once a round."""

QUIET = 1e-9
"""Of the fastest approach: slower ones are stopped without a bounce."""

STILL = 4e-12
"""Of the fastest approach and the speed that gravity gives in a step: slower ones are none, so that
what stands costs no impact in each step. At 1e-12 rounding in a stack of 64 is above it."""


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
    if not gap.any():
        return math.inf
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
        part = replace(problem, velocity=u).part(points)
        if is_last:
            y = solve_contacts(part).impulses
        else:
            y = rule(part, restitution[points], pairs_of([contacts[k] for k in points]), quiet)
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
    return ROUNDING * float(island.delassus.diagonal().max()) * (speed * island.mass)


def pairs_of(contacts: list[ContactRow]) -> list[list[int]]:
    """Return the places of the contacts of each pair of bodies, which stand side by side."""
    pairs: list[list[int]] = []
    last = (-1, -1)
    for k, c in enumerate(contacts):
        if (c.a, c.b) != last:
            pairs.append([])
            last = (c.a, c.b)
        pairs[-1].append(k)
    return pairs

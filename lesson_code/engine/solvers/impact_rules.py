"""What happens when several contacts strike at once: rules between which experiment decides.

=================  =========================================================================
choice             rule
=================  =========================================================================
``simultaneous``   all contacts of an island bounce at the same instant
``sequential``     one pair after the other, the fastest approach first, until all is quiet
=================  =========================================================================

Five balls in a row, the first of them struck: simultaneous, they leave with -3/5 and four times 2/5
of its velocity; one by one, the last leaves alone. Both keep momentum and energy. In the first
the forces are there together for the whole of the impact; in the second each is over before the
next begins, as between hard balls that touch loosely.

The sequence ends when no pair approaches faster than a millionth of the fastest approach there
was (or of what gravity gives in a step), or after 100 strikes for each contact, because balls that
lose energy may need infinitely many. What approaches still the solver stops, all at once and
without a bounce.

=================  =========================================================================
restitution law    what e is the ratio of
=================  =========================================================================
``newton``         normal velocities, after to before; with friction it may gain energy
``energetic``      work of the normal force, given back to taken (its square root); never gains
=================  =========================================================================

The energetic law is Stronge's where one contact strikes alone. Where several do together, their
impulses are those of Newton's law, drawn back towards those without a bounce until the energy is
no more than before.

All of it happens in the velocities u of the contacts; an impulse x changes them by K x.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from lesson_code.engine.core.rows import State
from lesson_code.engine.solvers.complementarity import solve_contacts
from lesson_code.engine.solvers.contact_problem import Cases, Floats, Problem, cases_of
from lesson_code.formulas.energetic import energetic_impulse
from lesson_code.formulas.validation import equation

StrikeRule: TypeAlias = Callable[[Problem, Floats, list[list[int]], float], Floats]
"""From a problem whose b is u before the impacts, every contact's e, the contacts of each pair and
the speed that counts as quiet, m/s, to the impulses of the impacts, shape (2m,)."""

Law: TypeAlias = Callable[[Problem, Floats], Floats]
"""From a problem and every contact's e to the impulses of contacts that strike together."""

QUIET = 1e-6
"""Of the fastest approach, or of the speed that gravity gives in a step: what is no strike."""

MOST_STRIKES = 100
"""For each contact of an island; then what is left is stopped."""

stronge = equation(energetic_impulse)


def quiet_speed(state: State) -> float:
    """Return the speed of approach, m/s, that gravity alone explains."""
    return QUIET * gravity_of(state) * state.dt


def gravity_of(state: State) -> float:
    """Return the strength of gravity, m/s^2."""
    return math.hypot(state.gravity_x, state.gravity_y)


def newton(problem: Problem, restitution: Floats, guess: Cases | None = None) -> Floats:
    """Return impulses after which un' >= -e un, and = where a contact pushes."""
    m = len(restitution)
    wanted = problem.velocity.copy()
    wanted[:m] *= 1.0 + restitution
    return solve_contacts(replace(problem, velocity=wanted), guess).impulses


def energetic(problem: Problem, restitution: Floats) -> Floats:
    """Return impulses that never gain energy."""
    m = len(restitution)
    approaches = np.flatnonzero(problem.velocity[:m] < 0.0)
    if m > 1 or len(approaches) == 0:
        return held_back(problem, restitution)
    (knn, knt), (_, ktt) = problem.delassus.tolist()
    un, ut = problem.velocity.tolist()
    e, mu = float(restitution[0]), float(problem.friction[0])
    return np.array(stronge(un, ut, knn, knt, ktt, e, mu))


def held_back(problem: Problem, restitution: Floats) -> Floats:
    """Return Newton's impulses, or what lies between those and no bounce and gains no energy.

    The energy that impulses x bring is u . x + x K x / 2. Without a bounce it is never > 0; along
    the way from there to Newton's it is a parabola, open upwards.
    """
    stopped = solve_contacts(problem).impulses
    if not restitution.any():
        return stopped
    guess = cases_of(problem.friction, stopped)
    bounce = newton(problem, restitution, guess) - stopped
    slope = float((problem.velocity + problem.delassus @ stopped) @ bounce)
    curve = float(bounce @ problem.delassus @ bounce)
    lost = max(-energy_gain(problem, stopped), 0.0)
    if slope + curve / 2 <= lost:
        return stopped + bounce
    # The positive root of  curve / 2 s^2 + slope s = lost, in the form that does not cancel.
    root = math.sqrt(slope * slope + 2 * curve * lost)
    share = 2 * lost / (root + slope) if slope > 0.0 else (root - slope) / curve
    return stopped + min(share, 1.0) * bounce


def energy_gain(problem: Problem, x: Floats) -> float:
    """Return the kinetic energy that impulses bring, J."""
    return float(problem.velocity @ x + x @ problem.delassus @ x / 2)


def one_by_one(
    problem: Problem, restitution: Floats, pairs: list[list[int]], quiet: float, *, law: Law
) -> Floats:
    """Return the impulses of the pairs striking in turn, the fastest approach first."""
    m = len(restitution)
    x, u = np.zeros(2 * m), problem.velocity.copy()
    starts = np.array([pair[0] for pair in pairs])
    quiet = max(quiet, -QUIET * float(u[:m].min()))
    for _ in range(MOST_STRIKES * m):
        approach = -np.minimum.reduceat(u[:m], starts)
        fastest = int(np.argmax(approach))
        if approach[fastest] <= quiet:
            break
        points = np.array(pairs[fastest])
        both = np.concatenate((points, m + points))
        strike = law(replace(problem, velocity=u).part(points), restitution[points])
        x[both] += strike
        u += problem.delassus[:, both] @ strike
    return x


def _all_energetic(p: Problem, e: Floats, pairs: list[list[int]], quiet: float) -> Floats:
    """Return the impulses of all contacts at once by the energetic law."""
    return energetic(p, e)


def _newton_in_turn(p: Problem, e: Floats, pairs: list[list[int]], quiet: float) -> Floats:
    """Return the impulses of one pair after the other by Newton's law."""
    return one_by_one(p, e, pairs, quiet, law=newton)


def _energetic_in_turn(p: Problem, e: Floats, pairs: list[list[int]], quiet: float) -> Floats:
    """Return the impulses of one pair after the other by the energetic law."""
    return one_by_one(p, e, pairs, quiet, law=energetic)


def _all_newton(p: Problem, e: Floats, pairs: list[list[int]], quiet: float) -> Floats:
    """Return the impulses of all contacts at once by Newton's law."""
    return newton(p, e)


STRIKE_RULES: dict[tuple[str, ...], StrikeRule] = {
    ("simultaneous", "newton"): _all_newton,
    ("simultaneous", "energetic"): _all_energetic,
    ("sequential", "newton"): _newton_in_turn,
    ("sequential", "energetic"): _energetic_in_turn,
}
"""The rules by their names."""

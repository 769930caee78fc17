"""Which solver suits a scene: the rules behind `solver="auto"`, each with its reason.

1. A rule for impacts is asked for: only the direct solver has one.
2. Sweeps or sub-steps are asked for: the sequential solver makes them.
3. Discs in free flight, one collision at a time: the exact solver. Where two collisions of a disc
   come at once it gives up, and the next one runs.
4. Few bodies, or some more that stand from the start or that nothing presses together: the direct
   solver. All contacts are solved at once, and at any step energy and momentum keep their laws.
   Sweeps take less time, and break them.
5. Many bodies: the solver with sub-steps. Sweeps take a third to all of its time; in a heap they
   let bodies pass through one another, and rough impacts gain energy by them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.constants import (
    FEWEST_FOR_GRID,
    MOST_DRIFTING,
    MOST_FALLING,
    MOST_FOR_DIRECT,
    MOST_STANDING,
    SKIN,
    TOUCHING,
)
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.neighbours import has_neighbour
from lesson_code.engine.core.penetration import EVERY_OVERLAP, deepest_overlaps, see_contacts
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.core.sight import Sight
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.effects.choice import capabilities, checked_wishes
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Question
from lesson_code.engine.event_driven import why_not
from lesson_code.geometry.manifold import collide
from lesson_code.geometry.shapes import Circle, Shape


class SolverChoice(NamedTuple):
    """A solver, and why it."""

    solver: str
    reason: str


def solvers_for(
    question: Question,
    *,
    asked: Mapping[str, Any],
    effects: Mapping[str, bool] | None = None,
    compiled: bool | None = None,
) -> Iterator[SolverChoice]:
    """Yield the solvers that suit a scene, the best first: the next one is for when it gives up.

    Parameters
    ----------
    question : Question
        The scene and how it is to be run; its solver does not matter.
    asked : mapping
        Settings that the user has given; "iterations", "substeps" and "impact_rules" matter.
    effects : mapping, optional
        Effects that are forced on rule out the solvers that do not have them; those that are left
        out, the solvers that cannot do without.
    compiled : bool, optional
        True rules out the direct solver.

    Examples
    --------
    >>> from lesson_code.engine.core.scene import Body, Material
    >>> ball = {"mass": 1.0, "material": Material(restitution=1.0)}
    >>> scene = Scene([Body(Circle(1), position=(3 * k, 0), **ball) for k in range(3)])
    >>> first, *_ = solvers_for(Question(scene, duration=1.0), asked={})
    >>> first.solver, first.reason
    ('exact', 'discs that fly freely between their collisions')
    """
    scene = question.scene
    wishes = checked_wishes(effects)
    if asked.get("impact_rules"):
        yield SolverChoice("direct", "it alone knows the rule for impacts that is asked for")
        return
    if asked.get("iterations") or asked.get("substeps"):
        yield SolverChoice("sequential", "iterations or sub-steps are asked for")
        return
    if _has_all("exact", wishes) and flies_freely(question):
        yield SolverChoice("exact", "discs that fly freely between their collisions")
    free = int(scene.columns.is_free.sum())
    if _has_all("direct", wishes) and compiled is not True:
        falls = falling(scene) if MOST_FALLING < free <= MOST_STANDING else 0
        if free <= MOST_FOR_DIRECT and falls <= MOST_FALLING:
            yield SolverChoice("direct", "few bodies: all contacts are solved at once")
        elif free <= MOST_STANDING and any(scene.gravity) and falls == 0:
            yield SolverChoice("direct", "all bodies stand: their contacts are solved at once")
        elif free <= MOST_DRIFTING and not any(scene.gravity) and not scene.columns.has_mover:
            yield SolverChoice("direct", "nothing presses the bodies: few of them touch at once")
    if _has_all("substep", wishes):
        yield SolverChoice("substep", "many bodies: their impacts gain no energy, and springs hold")
    yield SolverChoice("sequential", "what is asked for leaves sweeps alone")


def _has_all(solver: str, wishes: Mapping[str, bool]) -> bool:
    """Return whether a solver has what is forced on, and can do without what is left out."""
    lacking, built_in = capabilities(solver)
    return not any(name in (lacking if wish else built_in) for name, wish in wishes.items())


def flies_freely(question: Question) -> bool:
    """Return whether the exact solver suits a scene: discs that meet two at a time, and part.

    With gravity, discs that lose no energy, or a single one over a single obstacle: others may come
    to rest in a pile or in a wedge. Bodies that touch at the start are struck together; those that
    never bounce stay together. Walls that move may come together, and what is between them bounces
    more and more often.
    """
    scene = question.scene
    free = int(scene.columns.is_free.sum())
    if why_not(scene) or free == 0 or scene.columns.has_mover:
        return False
    facts = question.facts
    if any(scene.gravity):
        if _takes_energy(facts) and (free > 1 or len(scene.bodies) > 2):
            return False
    elif facts.least_restitution <= 0.0:
        return False
    return is_apart(scene)


def passes_only_blows(question: Question) -> bool:
    """Return whether no contact takes energy or carries: all is elastic, and nobody stands."""
    facts, scene = question.facts, question.scene
    if _takes_energy(facts) or facts.may_change_impulses or facts.has_mover:
        return False
    return not any(scene.gravity) or falling(scene) == int(scene.columns.is_free.sum())


def _takes_energy(facts: Facts) -> bool:
    """Return whether some contact, or damping, takes energy, so that bodies may come to rest."""
    return facts.least_restitution < 1.0 or facts.most_friction > 0.0 or facts.damping > 0.0


def is_apart(scene: Scene) -> bool:
    """Return whether no two bodies touch, one of which is a disc that can be pushed."""
    if len(scene.bodies) < FEWEST_FOR_GRID:
        return not any(_touch(a, b) for a, b in combinations(scene.bodies, 2))
    near = _with_neighbours(scene).bodies
    larger = [replace(body, shape=_with_edge(body)) for body in near]
    positions = np.array([[body.position for body in near]])
    angles = np.array([[body.angle for body in near]])
    return bool(deepest_overlaps(Scene(larger), positions, angles)[0] == 0.0)


def _touch(a: Body, b: Body) -> bool:
    """Return whether two bodies touch, one of which can be pushed."""
    if a.is_static and b.is_static:
        return False
    shape_a, shape_b = _with_edge(a), _with_edge(b)
    if math.dist(a.position, b.position) > shape_a.bounding_radius + shape_b.bounding_radius:
        return False
    return collide(shape_a, (*a.position, a.angle), shape_b, (*b.position, b.angle)) is not None


def _with_edge(body: Body) -> Shape:
    """Return a body's shape, that of a disc which can be pushed a little larger."""
    if isinstance(body.shape, Circle) and not body.is_static:
        return Circle(body.shape.radius * (1 + TOUCHING))
    return body.shape


def falling(scene: Scene) -> int:
    """Return how many bodies fall: gravity acts, and they touch no other one."""
    if not any(scene.gravity):
        return 0
    free, near = int(scene.columns.is_free.sum()), _with_neighbours(scene)
    world = world_of(near, dt=1.0, iterations=0, combine=MixingRule(), sight=Sight(SKIN))
    while not see_contacts(world, BROAD_PHASES[broad_phase_for(near)], EVERY_OVERLAP):
        world = add_capacity(world)
    contacts = world.contacts[: world.state.contact_count]
    touching = {number for c in contacts for number in (c.a, c.b)}
    return free - sum(not near.bodies[number].is_static for number in touching)


def _with_neighbours(scene: Scene) -> Scene:
    """Return the bodies of a scene that may touch another one: their boxes with a skin overlap."""
    near = has_neighbour(scene, margin=2 * SKIN)
    return Scene([scene.bodies[n] for n in np.flatnonzero(near)])

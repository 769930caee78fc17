"""Which effects a scene calls for: a rule for each, with the reason in a sentence.

=======================  ===================================================================
effect                   called for when
=======================  ===================================================================
``collisions``           two bodies can meet within the run
``broad_phase``          there are too many bodies to compare all pairs
``outlines``             a body has corners
``manifolds``            two bodies with corners can meet
``seams``                several static bodies may make one floor
``continuous``           a body may move by more than half of its width in a step
``restitution``          a pair has e > 0
``friction``             a pair has mu > 0
``rotation``             a body turns, or an impulse can turn one
``gravity``              it is not zero
``damping``              it is not zero
``warm_starting``        contacts can last
``position_correction``  steps let bodies overlap
``sleeping``             bodies can come to rest, and the run is long enough
``callbacks``            the scene has some
``impulse_record``       contacts are to be read afterwards
=======================  ===================================================================

What becomes of a run is decided from these findings in ``effect_choice.py``.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations_with_replacement
from typing import NamedTuple, TypeAlias

from lesson_code.engine.core.constants import FEWEST_FOR_GRID, QUIET_TIME, SPEED_DOUBT
from lesson_code.engine.core.mixing import COMBINATIONS, UNSPECIFIED, Combination, combined
from lesson_code.engine.core.mixing import RULES as COMBINATION_RULES
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.effects.reach import can_meet, fastest_way
from lesson_code.geometry.shapes import Circle


class Finding(NamedTuple):
    """Whether an effect is called for, and why."""

    called_for: bool
    reason: str


@dataclass(frozen=True)
class Question:
    """What is asked of the rules: a scene, and how it is to be run.

    Attributes
    ----------
    scene : Scene
        Bodies, gravity, damping, callbacks.
    solver : str
        One of the engine's, by name.
    dt : float
        The time step, s.
    duration : float
        s; ``math.inf``: nobody knows yet.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    """

    scene: Scene
    solver: str = "sequential"
    dt: float = 1 / 60
    duration: float = math.inf
    combine: Combination = COMBINATIONS["workbook"]

    @cached_property
    def has_meeting(self) -> bool:
        """Whether any two bodies can meet. Most rules want to know, and it takes a look at all."""
        return can_meet(self.scene, self.duration, self.dt)


Rule: TypeAlias = Callable[[Question], Finding]


def collisions(question: Question) -> Finding:
    """Ask whether any two bodies can meet."""
    if question.has_meeting:
        return Finding(True, "two bodies can meet")
    return Finding(False, "no two bodies can meet within the run")


def broad_phase(question: Question) -> Finding:
    """Ask whether there are so many bodies that a grid costs less than a look at every pair."""
    count = len(question.scene.bodies)
    if count >= FEWEST_FOR_GRID:
        return Finding(True, f"{count} bodies: from {FEWEST_FOR_GRID} on a grid finds the pairs")
    return Finding(False, f"{count} bodies: below {FEWEST_FOR_GRID} all pairs are compared")


def outlines(question: Question) -> Finding:
    """Ask whether any body has corners."""
    count = len(_cornered(question.scene))
    return Finding(count > 0, f"{_bodies(count)} corners" if count else "every body is a circle")


def manifolds(question: Question) -> Finding:
    """Ask whether two bodies with corners can meet: a circle touches at one point."""
    cornered = _cornered(question.scene)
    if len(cornered) > 1 and any(not body.is_static for body in cornered):
        return Finding(True, "two bodies with corners can touch at two points")
    return Finding(False, "bodies touch at one point: one of the two is a circle")


def seams(question: Question) -> Finding:
    """Ask whether there are two static bodies that may stand side by side."""
    count = sum(body.is_static for body in question.scene.bodies)
    if count > 1:
        return Finding(True, f"{count} static bodies may make one floor")
    return Finding(False, "there is at most one static body")


def continuous(question: Question) -> Finding:
    """Ask whether a body may move by more than half of its width within a step.

    Without gravity the energy of all bodies together bounds the speed of each, as long as no
    impact makes energy: e is at most 1, and none of Newton's law with friction at a corner.
    """
    scene = question.scene
    if any(scene.gravity):
        return Finding(True, "gravity makes bodies faster, nobody knows how fast")
    if _callbacks_decide(scene):
        return Finding(True, "a callback may set how bodies bounce")
    if any(map(is_mover, scene.bodies)):
        return Finding(True, "a body that nothing can push moves, and may hit others fast")
    corners_rub = friction(question).called_for and _cornered(scene)
    if corners_rub and restitution(question).called_for:
        return Finding(True, "bounces at corners that rub may gain speed")
    way, room = fastest_way(scene, question.dt)
    if SPEED_DOUBT * way > room:
        return Finding(True, f"a body may move {way:.3g} m in a step, and has {room:.3g} m")
    return Finding(False, f"no body can move more than {way:.3g} m in a step, and has {room:.3g} m")


def restitution(question: Question) -> Finding:
    """Ask whether any pair bounces."""
    if _callbacks_decide(question.scene):
        return Finding(True, "a callback may set e")
    most = _largest_of_pairs(question, "restitution")
    return Finding(most > 0, f"a pair has e = {most:g}" if most > 0 else "every pair has e = 0")


def friction(question: Question) -> Finding:
    """Ask whether any pair rubs."""
    if _callbacks_decide(question.scene):
        return Finding(True, "a callback may set mu")
    most = _largest_of_pairs(question, "friction")
    return Finding(most > 0, f"a pair has mu = {most:g}" if most > 0 else "every pair has mu = 0")


def rotation(question: Question) -> Finding:
    """Ask whether any body turns, or an impulse can turn it."""
    bodies = question.scene.bodies
    if any(body.angular_velocity != 0.0 for body in bodies):
        return Finding(True, "a body turns from the start")
    free = [body for body in bodies if body.inertia is not None and math.isfinite(body.inertia)]
    if any(not isinstance(body.shape, Circle) for body in free):
        return Finding(True, "a body with corners can be turned by an impulse off its centre")
    if free and friction(question).called_for:
        return Finding(True, "friction turns discs")
    return Finding(False, "nothing turns: impulses without friction go through a disc's centre")


def gravity(question: Question) -> Finding:
    """Ask whether there is any."""
    x, y = question.scene.gravity
    is_there = x != 0.0 or y != 0.0
    return Finding(is_there, f"g = ({x:g}, {y:g}) m/s^2" if is_there else "g = 0")


def damping(question: Question) -> Finding:
    """Ask whether there is any."""
    rate = question.scene.damping
    return Finding(rate != 0.0, f"motion dies away at {rate:g} /s" if rate else "the rate is 0")


def warm_starting(question: Question) -> Finding:  # noqa: ARG001
    """Ask whether contacts can last: they can wherever bodies can meet."""
    return Finding(True, "a contact may last for more than one step")


def position_correction(question: Question) -> Finding:  # noqa: ARG001
    """Ask whether bodies get into one another: they do between any two steps."""
    return Finding(True, "between two steps bodies move into one another")


def sleeping(question: Question) -> Finding:
    """Ask whether something presses bodies together, takes their energy, and leaves them time."""
    scene = question.scene
    if scene.callbacks.wanted:
        return Finding(False, "callbacks hear of every contact in every step")
    if not any(scene.gravity):
        return Finding(False, "without gravity nothing is held at rest")
    if math.isinf(question.duration):
        return Finding(False, "nobody knows yet how long the run will be")
    if question.duration <= QUIET_TIME:
        return Finding(False, f"the run is no longer than the {QUIET_TIME:g} s of quiet it takes")
    loses = friction(question).called_for or scene.damping > 0.0
    if not loses and smallest_restitution(question) >= 1.0:
        return Finding(False, "nothing takes energy: every pair has e = 1 and mu = 0")
    return Finding(True, "bodies can come to rest within the run")


def callbacks(question: Question) -> Finding:
    """Ask whether the scene wants to be told of contacts."""
    wanted = question.scene.callbacks.wanted
    return Finding(wanted, "the scene asks to be told" if wanted else "the scene has none")


def impulse_record(question: Question) -> Finding:  # noqa: ARG001
    """Ask whether contacts are to be read afterwards: yes, unless that is declined."""
    return Finding(True, "run.contacts lists every impulse")


RULES: dict[str, Rule] = {
    "collisions": collisions,
    "broad_phase": broad_phase,
    "outlines": outlines,
    "manifolds": manifolds,
    "seams": seams,
    "continuous": continuous,
    "restitution": restitution,
    "friction": friction,
    "rotation": rotation,
    "gravity": gravity,
    "damping": damping,
    "warm_starting": warm_starting,
    "position_correction": position_correction,
    "sleeping": sleeping,
    "callbacks": callbacks,
    "impulse_record": impulse_record,
}
"""The rule of each effect, by its name, in the order of the stages."""


def _cornered(scene: Scene) -> list[Body]:
    """Return the bodies that have corners."""
    return [body for body in scene.bodies if not isinstance(body.shape, Circle)]


def _bodies(count: int) -> str:
    """Return a number of bodies in words, with their verb."""
    return "1 body has" if count == 1 else f"{count} bodies have"


def is_mover(body: Body) -> bool:
    """Return whether a body moves that nothing can push."""
    return body.is_static and (any(body.velocity) or body.angular_velocity != 0.0)


def _callbacks_decide(scene: Scene) -> bool:
    """Return whether callbacks may set what a pair does."""
    return scene.callbacks.begin is not None or scene.callbacks.pre_solve is not None


def _largest_of_pairs(question: Question, name: str) -> float:
    """Return the largest coefficient of the pairs that can meet."""
    return max(_of_pairs(question, name), default=0.0)


def smallest_restitution(question: Question) -> float:
    """Return the smallest restitution of the pairs that can meet."""
    return min(_of_pairs(question, "restitution"), default=0.0)


def _of_pairs(question: Question, name: str) -> list[float]:
    """Return a coefficient of all sorts of pairs, of which one body at least can be pushed."""
    rule = COMBINATION_RULES[getattr(question.combine, name)]
    sorts = Counter(
        (UNSPECIFIED if (value := getattr(body.material, name)) is None else value, body.is_static)
        for body in question.scene.bodies
    )
    return [
        combined(rule, a, b)
        for (a, a_static), (b, b_static) in combinations_with_replacement(sorts, 2)
        if not (a_static and b_static)
        if (a, a_static) != (b, b_static) or sorts[a, a_static] > 1
    ]

"""The question that an effect's rule answers, and the description of an effect."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from lesson_code.engine.core.mixing import MIXING_RULES, RULES, MixingRule
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.sight import NO_SKIN, Sight
from lesson_code.engine.effects.facts import Coefficients, Facts, Seen, SeenBody, look
from lesson_code.engine.effects.flights import can_meet


class Finding(NamedTuple):
    """Whether an effect is called for, and why: words, with places for two numbers.

    >>> Finding(True, "a pair has mu = {:g}", 0.5).reason
    'a pair has mu = 0.5'
    """

    called_for: bool
    words: str
    first: float = 0.0
    second: float = 0.0

    @property
    def reason(self) -> str:
        """Why, in a sentence."""
        return self.words.format(self.first, self.second)


@dataclass(frozen=True)
class Question:
    """A scene, and how it is to be run: the rules say which effects that calls for.

    Attributes
    ----------
    scene : Scene
        Bodies, gravity, damping, callbacks.
    solver : str
        One of the engine's, by name.
    dt : float
        The time step, s.
    duration : float
        s; ``math.inf``: not yet known.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    sight : Sight
        From where on the solver sees contacts, and how far a body may move in a step unwatched.
    """

    scene: Scene
    solver: str = "sequential"
    dt: float = 1 / 60
    duration: float = math.inf
    combine: MixingRule = MIXING_RULES["workbook"]
    sight: Sight = NO_SKIN

    @cached_property
    def facts(self) -> Facts:
        """What the rules ask of the scene, from one look at it, which is kept with the scene."""
        kept: dict[Any, Facts] = vars(self.scene).setdefault("_facts", {})
        how = self.dt, self.duration, self.combine, self.sight
        if how not in kept:
            kept[how] = self._look()
        return kept[how]

    def _look(self) -> Facts:
        """Return the facts of the scene, if it is run so."""
        scene = self.scene
        gravity_x, gravity_y = scene.gravity
        facts = Facts(
            gravity_x,
            gravity_y,
            scene.damping,
            self.dt,
            self.duration,
            *self.sight,
            RULES[self.combine.restitution],
            RULES[self.combine.friction],
            scene.callbacks.wanted,
            scene.callbacks.may_change_impulses,
            can_meet(scene, self.duration, self.dt),
        )
        look(Seen(facts, _seen_bodies(scene), *(Coefficients() for _ in range(4))))
        return facts


def _seen_bodies(scene: Scene) -> list[SeenBody]:
    """Return what is asked of each body."""
    c = scene.columns
    with np.errstate(over="ignore"):
        inv_i = 1.0 / c.inertia
    columns: tuple[Any, ...] = (c.vx, c.vy, c.w, c.mass, inv_i, c.rounding, c.min_width)
    columns += (c.bounding_radius, c.corner_count, c.restitution, c.friction)
    return list(map(SeenBody, *(column.tolist() for column in columns)))


Rule: TypeAlias = Callable[[Facts], Finding]


def never(_facts: Facts) -> bool:
    """Return False, whatever the scene."""
    return False


@dataclass(frozen=True, kw_only=True)
class Effect:
    """An effect: the value `EFFECT` of a file in this folder, whose name is that of its flag.

    Attributes
    ----------
    rule : callable
        Says of the facts of a scene whether the effect is called for, and why.
    place : int
        Where it stands in a plan: in the order of the stages, by tens, so that one fits between.
    functions : tuple of str
        The functions that are called for its sake alone, in a step of the sequential solver.
    needs_collisions : bool
        Whether a scene calls for it only if bodies can meet.
    is_optional : bool
        Whether it may be left out although it is called for: no state of the run depends on it.
    is_ruled_out : callable
        Says of the facts whether the effect cannot even be forced on.
    """

    rule: Rule
    place: int
    functions: tuple[str, ...]
    needs_collisions: bool = True
    is_optional: bool = False
    is_ruled_out: Callable[[Facts], bool] = never

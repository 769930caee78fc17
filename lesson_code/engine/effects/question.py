"""The question that an effect's rule answers, and the description of an effect."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import NamedTuple, TypeAlias

from lesson_code.engine.core.mixing import (
    MIXING_RULES,
    RULES,
    MixingRule,
    mixed,
)
from lesson_code.engine.core.scene import Scene


class Finding(NamedTuple):
    """Whether an effect is called for, and why."""

    called_for: bool
    reason: str


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
    skin : float
        Of a body's width: how far from its surface the solver sees contacts.
    """

    scene: Scene
    solver: str = "sequential"
    dt: float = 1 / 60
    duration: float = math.inf
    combine: MixingRule = MIXING_RULES["workbook"]
    skin: float = 0.0

    def coefficients(self, name: str) -> list[float]:
        """Return the values of "restitution" or "friction" that the pairs of bodies can have.

        In each pair one body at least can be pushed. Bodies that are alike are counted, not
        compared, so that this takes no longer for many of them.
        """
        rule = RULES[getattr(self.combine, name)]
        columns = self.scene.columns
        sorts = columns.friction_sorts if name == "friction" else columns.restitution_sorts
        return [
            mixed(rule, a, b)
            for (a, a_free), (b, b_free) in combinations_with_replacement(sorts, 2)
            if a_free or b_free
            if (a, a_free) != (b, b_free) or sorts[a, a_free] > 1
        ]


Rule: TypeAlias = Callable[[Question], Finding]


def never(_question: Question) -> bool:
    """Return False, whatever the scene."""
    return False


@dataclass(frozen=True, kw_only=True)
class Effect:
    """An effect: the value `EFFECT` of a file in this folder, whose name is that of its flag.

    Attributes
    ----------
    rule : callable
        Says of a question whether the effect is called for, and why.
    place : int
        Where it stands in a plan: in the order of the stages, by tens, so that one fits between.
    functions : tuple of str
        The functions that are called for its sake alone, in a step of the sequential solver.
    needs_collisions : bool
        Whether a scene calls for it only if bodies can meet.
    is_optional : bool
        Whether it may be left out although it is called for: no state of the run depends on it.
    is_ruled_out : callable
        Says of a question whether the effect cannot even be forced on.
    """

    rule: Rule
    place: int
    functions: tuple[str, ...]
    needs_collisions: bool = True
    is_optional: bool = False
    is_ruled_out: Callable[[Question], bool] = never

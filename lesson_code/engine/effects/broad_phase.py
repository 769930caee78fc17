"""Broad phase: a grid finds the pairs that may touch, where comparing all of them takes longer.

The stage is :func:`lesson_code.engine.core.broad_phase.uniform_grid`.
"""

from __future__ import annotations

from lesson_code.engine.core.constants import FEWEST_FOR_GRID
from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether there are so many bodies that a grid costs less than a look at every pair."""
    count = len(question.scene.bodies)
    if count >= FEWEST_FOR_GRID:
        return Finding(True, f"{count} bodies: from {FEWEST_FOR_GRID} on a grid finds the pairs")
    return Finding(False, f"{count} bodies: below {FEWEST_FOR_GRID} all pairs are compared")


EFFECT = Effect(rule=rule, place=20, functions=("uniform_grid",), is_optional=True)

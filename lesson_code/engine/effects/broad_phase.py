"""Broad phase: a grid finds the pairs that may touch, where comparing all of them takes longer.

The stage is :func:`lesson_code.engine.core.broad_phase.uniform_grid`.
"""

from __future__ import annotations

from lesson_code.engine.core.constants import FEWEST_FOR_GRID
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether there are so many bodies that a grid costs less than a look at every pair."""
    count, fewest = facts.body_count, FEWEST_FOR_GRID
    if count >= fewest:
        return Finding(True, "{:.0f} bodies: from {:.0f} on a grid finds the pairs", count, fewest)
    return Finding(False, "{:.0f} bodies: below {:.0f} all pairs are compared", count, fewest)


EFFECT = Effect(rule=rule, place=20, functions=("uniform_grid",), is_optional=True)

"""Manifolds: two bodies with corners may touch at two points; a circle touches at one."""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether two bodies with corners can meet."""
    if facts.cornered_count > 1 and facts.has_free_cornered:
        return Finding(True, "two bodies with corners can touch at two points")
    return Finding(False, "bodies touch at one point: one of the two is a circle")


EFFECT = Effect(rule=rule, place=40, functions=("collide_rows", "couple"))

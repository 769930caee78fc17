"""Outlines: some body has corners, and circles are not all there is."""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether any body has corners."""
    if facts.cornered_count == 0:
        return Finding(False, "every body is a circle")
    if facts.cornered_count == 1:
        return Finding(True, "1 body has corners")
    return Finding(True, "{:.0f} bodies have corners", facts.cornered_count)


EFFECT = Effect(rule=rule, place=30, functions=("collide_with_circle", "collide_rows"))

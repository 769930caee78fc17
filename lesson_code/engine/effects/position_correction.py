"""Position correction: bodies that overlap are pushed apart."""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(_facts: Facts) -> Finding:
    """Ask whether bodies get into one another: they do between any two steps."""
    return Finding(True, "between two steps bodies move into one another")


EFFECT = Effect(rule=rule, place=130, functions=("has_overlap_to_undo", "correct"))

"""Warm starting: the solver begins with the impulses of the step before."""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(_facts: Facts) -> Finding:
    """Ask whether contacts can last: they can wherever bodies can meet."""
    return Finding(True, "a contact may last for more than one step")


EFFECT = Effect(rule=rule, place=120, functions=("warm_start", "recall", "store"))

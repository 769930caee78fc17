"""Restitution: some pair of bodies bounces."""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether any pair bounces."""
    if facts.may_change_impulses:
        return Finding(True, "a callback may set e")
    if facts.most_restitution > 0.0:
        return Finding(True, "a pair has e = {:g}", facts.most_restitution)
    return Finding(False, "every pair has e = 0")


EFFECT = Effect(rule=rule, place=70, functions=("set_bounces",))

"""Friction: some pair of bodies rubs."""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether any pair rubs."""
    if facts.may_change_impulses:
        return Finding(True, "a callback may set mu")
    if facts.most_friction > 0.0:
        return Finding(True, "a pair has mu = {:g}", facts.most_friction)
    return Finding(False, "every pair has mu = 0")


EFFECT = Effect(
    rule=rule,
    place=80,
    functions=("set_frame", "solve_contact", "couple_tangents", "friction_impulse"),
)

"""Rotation: some body turns, or an impulse may make it turn."""

from __future__ import annotations

from lesson_code.engine.effects import friction
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether any body turns, or an impulse can turn it."""
    if facts.has_spin:
        return Finding(True, "a body turns from the start")
    if facts.has_turnable_cornered:
        return Finding(True, "a body with corners can be turned by an impulse off its centre")
    if facts.has_turnable and friction.rule(facts).called_for:
        return Finding(True, "friction turns discs")
    return Finding(False, "nothing turns: impulses without friction go through a disc's centre")


EFFECT = Effect(rule=rule, place=90, functions=("turn_on",), needs_collisions=False)

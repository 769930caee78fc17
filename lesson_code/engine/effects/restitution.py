"""Restitution: some pair of bodies bounces."""

from __future__ import annotations

from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether any pair bounces."""
    if question.scene.callbacks.may_change_impulses:
        return Finding(True, "a callback may set e")
    most = max(question.coefficients("restitution"), default=0.0)
    return Finding(most > 0, f"a pair has e = {most:g}" if most > 0 else "every pair has e = 0")


EFFECT = Effect(rule=rule, place=70, functions=("set_bounces",))


def smallest_restitution(question: Question) -> float:
    """Return the smallest restitution of the pairs that can meet."""
    return min(question.coefficients("restitution"), default=0.0)

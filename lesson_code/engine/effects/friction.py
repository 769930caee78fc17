"""Friction: some pair of bodies rubs."""

from __future__ import annotations

from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether any pair rubs."""
    if question.scene.callbacks.may_change_impulses:
        return Finding(True, "a callback may set mu")
    most = max(question.coefficients("friction"), default=0.0)
    return Finding(most > 0, f"a pair has mu = {most:g}" if most > 0 else "every pair has mu = 0")


EFFECT = Effect(
    rule=rule,
    place=80,
    functions=("set_frame", "solve_contact", "couple_tangents", "friction_impulse"),
)

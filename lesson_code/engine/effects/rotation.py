"""Rotation: some body turns, or an impulse may make it turn."""

from __future__ import annotations

import math

from lesson_code.engine.effects import friction
from lesson_code.engine.effects.question import Effect, Finding, Question
from lesson_code.geometry.shapes import Circle


def rule(question: Question) -> Finding:
    """Ask whether any body turns, or an impulse can turn it."""
    bodies = question.scene.bodies
    if any(body.angular_velocity != 0.0 for body in bodies):
        return Finding(True, "a body turns from the start")
    free = [body for body in bodies if body.inertia is not None and math.isfinite(body.inertia)]
    if any(not isinstance(body.shape, Circle) for body in free):
        return Finding(True, "a body with corners can be turned by an impulse off its centre")
    if free and friction.rule(question).called_for:
        return Finding(True, "friction turns discs")
    return Finding(False, "nothing turns: impulses without friction go through a disc's centre")


EFFECT = Effect(rule=rule, place=90, functions=("turn_on",), needs_collisions=False)

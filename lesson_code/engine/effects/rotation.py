"""Rotation: some body turns, or an impulse may make it turn."""

from __future__ import annotations

import numpy as np

from lesson_code.engine.effects import friction
from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether any body turns, or an impulse can turn it."""
    columns = question.scene.columns
    if (columns.w != 0.0).any():
        return Finding(True, "a body turns from the start")
    can_be_turned = np.isfinite(columns.inertia)
    if (can_be_turned & columns.has_corners).any():
        return Finding(True, "a body with corners can be turned by an impulse off its centre")
    if can_be_turned.any() and friction.rule(question).called_for:
        return Finding(True, "friction turns discs")
    return Finding(False, "nothing turns: impulses without friction go through a disc's centre")


EFFECT = Effect(rule=rule, place=90, functions=("turn_on",), needs_collisions=False)

"""Outlines: some body has corners, and circles are not all there is."""

from __future__ import annotations

from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether any body has corners."""
    count = int(question.scene.columns.has_corners.sum())
    if count == 0:
        return Finding(False, "every body is a circle")
    return Finding(True, "1 body has corners" if count == 1 else f"{count} bodies have corners")


EFFECT = Effect(rule=rule, place=30, functions=("collide_with_circle", "collide_rows"))

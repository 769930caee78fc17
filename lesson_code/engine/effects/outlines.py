"""Outlines: some body has corners, and circles are not all there is."""

from __future__ import annotations

from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.effects.question import Effect, Finding, Question
from lesson_code.geometry.shapes import Circle


def cornered(scene: Scene) -> list[Body]:
    """Return the bodies that have corners."""
    return [body for body in scene.bodies if not isinstance(body.shape, Circle)]


def rule(question: Question) -> Finding:
    """Ask whether any body has corners."""
    count = len(cornered(question.scene))
    if count == 0:
        return Finding(False, "every body is a circle")
    return Finding(True, "1 body has corners" if count == 1 else f"{count} bodies have corners")


EFFECT = Effect(rule=rule, place=30, functions=("collide_with_circle", "collide_rows"))

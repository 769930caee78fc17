"""Manifolds: two bodies with corners may touch at two points; a circle touches at one."""

from __future__ import annotations

from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether two bodies with corners can meet."""
    columns = question.scene.columns
    cornered = columns.has_corners
    if cornered.sum() > 1 and (cornered & columns.is_free).any():
        return Finding(True, "two bodies with corners can touch at two points")
    return Finding(False, "bodies touch at one point: one of the two is a circle")


EFFECT = Effect(rule=rule, place=40, functions=("collide_rows", "couple"))

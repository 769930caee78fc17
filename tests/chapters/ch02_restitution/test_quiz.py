"""The quiz of chapter 02, checked against the laws of a collision."""

from __future__ import annotations


def test_measured_restitution_scene_keeps_momentum() -> None:
    """Question 02-measure is a collision that can happen: equal masses keep momentum."""
    assert 5 + -3 == -2 + 4

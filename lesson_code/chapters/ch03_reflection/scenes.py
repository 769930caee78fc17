"""Scenes of chapter 03."""

from __future__ import annotations

from itertools import pairwise

from lesson_code.chapters.billiards.rules import LAUNCH, TABLE
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.geometry.shapes import Circle, Segment

CUSHIONS = ("top", "right", "bottom", "left", "bumper")
"""What the ball can hit, in the order of the scene's bodies; the ball is the last of these."""


def billiard_table() -> Scene:
    """Return the table of the billiards and its first shot, in pixels, with y down.

    >>> [type(body.shape).__name__ for body in billiard_table().bodies[-2:]]
    ['Segment', 'Circle']
    """
    rubber, w, h = Material(TABLE.restitution, 0.0), TABLE.width, TABLE.height
    sides = pairwise([(0.0, 0.0), (w, 0.0), (w, h), (0.0, h), (0.0, 0.0)])
    bumper = Segment(TABLE.bumper_start, TABLE.bumper_end, TABLE.bumper_half_thickness)
    position, velocity = LAUNCH
    ball = Body(
        Circle(TABLE.radius), position=position, velocity=velocity, mass=1.0, material=rubber
    )
    walls = [Body(shape, material=rubber) for shape in (*(Segment(a, b) for a, b in sides), bumper)]
    return Scene([*walls, ball])

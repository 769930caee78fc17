"""The effects that a scene calls for: what is not called for is left out of the program it runs as.

An effect is a flag that is known before the run. Plain Python looks at it; from a compiled program
the linker has removed it, and the branch that it closes.
"""

from __future__ import annotations

from typing import NamedTuple

from lesson_code.engine.scene import Scene
from lesson_code.geometry.shapes import Circle


class Effects(NamedTuple):
    """What a run has to reckon with."""

    outlines: bool = True  # some body has corners: not all of them are circles
    manifolds: bool = True  # two bodies with corners may meet, at two points
    turning: bool = True  # a body with corners may turn
    seams: bool = True  # several static bodies may make one floor


EVERY_EFFECT = Effects()


def effects_of(scene: Scene) -> Effects:
    """Return the effects that a scene calls for.

    >>> from lesson_code import Body, Scene, Segment
    >>> floor, ball = Body(Segment((0, 0), (1, 0))), Body(Circle(1), mass=1.0)
    >>> effects_of(Scene([floor, ball]))
    Effects(outlines=True, manifolds=False, turning=False, seams=False)
    """
    cornered = [body for body in scene.bodies if not isinstance(body.shape, Circle)]
    can_meet = len(cornered) > 1 and any(not body.is_static for body in cornered)
    turns = any(not body.is_static or body.angular_velocity != 0.0 for body in cornered)
    walls = sum(body.is_static for body in scene.bodies)
    return Effects(outlines=bool(cornered), manifolds=can_meet, turning=turns, seams=walls > 1)

"""The effects that a program reckons with: what a scene does not call for is left out of it.

An effect is a flag that is known before the run. Plain Python looks at it; from a compiled program
the linker has removed it, and the branch that it closes. Which effects a scene calls for, and why,
is worked out in :mod:`lesson_code.engine.effects.choice`.
"""

from __future__ import annotations

from typing import NamedTuple


class Effects(NamedTuple):
    """What a run has to reckon with."""

    collisions: bool = True  # bodies may meet
    outlines: bool = True  # some body has corners: not all of them are circles
    manifolds: bool = True  # two bodies with corners may meet, at two points
    seams: bool = True  # several static bodies may make one floor
    restitution: bool = True  # some pair bounces
    friction: bool = True  # some pair rubs
    rotation: bool = True  # some body turns, or may be made to
    gravity: bool = True
    damping: bool = True
    warm_starting: bool = True  # impulses are remembered from step to step
    position_correction: bool = True  # overlaps are undone
    sleeping: bool = False  # islands at rest are left alone


EVERY_EFFECT = Effects()
"""All but sleeping, which is the only one that may change the last bits of a result."""

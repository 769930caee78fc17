"""Our pairs' coefficients as values of Box2D's shapes.

Box2D gives a pair the larger restitution and the geometric mean of the frictions, and its binding
offers no way to give it others. Where each body can be given values of which that rule makes ours,
that is done. Elsewhere each body gets several shapes in one place: one for each kind of material
that there is, with the coefficients of the two, and each meets its counterpart alone.

Two materials, 0 and 1, need the four bits (0, 0), (0, 1), (1, 0) and (1, 1). A body of material 0
has a shape for its own kind, which is (0, 0) and meets (0, 0), and one for the other kind, which
is (0, 1) and meets (1, 0).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from lesson_code.engine.core.mixing import MIXING_RULES, MixingRule
from lesson_code.engine.core.scene import Body
from lesson_code.reference.scene_mapping import coefficients, own_values

BITS = 64
"""Of a filter in Box2D."""

EVERYTHING = 2**BITS - 1
"""What a shape meets by default: all bits."""


class Surface(NamedTuple):
    """Coefficients of a shape, what it is to a filter, and what it meets.

    Attributes
    ----------
    restitution, friction : float
        Of which Box2D makes the pair's.
    category, mask : int
        Sets of bits. Two shapes meet where each one's category is in the other one's mask.
    """

    restitution: float
    friction: float
    category: int = 1
    mask: int = EVERYTHING


def surfaces(bodies: Sequence[Body], combine: MixingRule) -> list[list[Surface]]:
    """Return the surfaces of each body's shapes: one, or one for each kind of material.

    Parameters
    ----------
    bodies : sequence of Body
        All bodies of a scene.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.

    Raises
    ------
    ValueError
        There are more kinds of material than the bits of a filter can tell apart.

    Examples
    --------
    >>> from lesson_code import Circle, Material, MixingRule
    >>> balls = [Body(Circle(1), mass=1.0, material=Material(e)) for e in (0.4, 0.4, 0.8)]
    >>> [[s.restitution for s in own] for own in surfaces(balls, MixingRule("max"))]
    [[0.4], [0.4], [0.8]]
    >>> [[s.restitution for s in own] for own in surfaces(balls, MixingRule("min"))]
    [[0.4, 0.4], [0.4, 0.4], [0.4, 0.8]]
    """
    values = own_values(bodies, combine, MIXING_RULES["box2d"])
    if values is not None:
        return [[Surface(*own)] for own in values]
    kinds = list(dict.fromkeys(body.material for body in bodies))
    most = math.isqrt(BITS)
    if len(kinds) > most:
        raise ValueError(
            f"materials must be of at most {most} kinds for Box2D, whose own rule (the larger "
            f"restitution, the geometric mean of the frictions) is another one, got {len(kinds)}"
        )
    own = {}
    for i, kind in enumerate(kinds):
        own[kind] = [
            Surface(
                *coefficients(combine, kind, other),
                category=1 << (i * most + j),
                mask=1 << (j * most + i),
            )
            for j, other in enumerate(kinds)
        ]
    return [own[body.material] for body in bodies]

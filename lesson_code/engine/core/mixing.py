"""How a pair's restitution and friction come from those of its two bodies.

Engines differ here more than anywhere else, which is why two of them disagree about the same
scene. Set the *pair's* value equal before comparing them.

================  ===========================  =========================
name              restitution                  friction
================  ===========================  =========================
``"workbook"``    the smaller                  the geometric mean
``"pymunk"``      the product                  the product
``"box2d"``       the larger                   the geometric mean
================  ===========================  =========================
"""

from __future__ import annotations

import math
from dataclasses import dataclass

MIN, MAX, PRODUCT, GEOMETRIC_MEAN, MEAN = range(5)

RULES = {
    "min": MIN,
    "max": MAX,
    "product": PRODUCT,
    "geometric_mean": GEOMETRIC_MEAN,
    "mean": MEAN,
}
"""The rules by name, and the numbers that the tables hold for them."""

UNSPECIFIED = -1.0
"""What the tables hold for a body that leaves a coefficient to the other one."""


@dataclass(frozen=True)
class MixingRule:
    """A rule for the restitution of a pair, and one for its friction.

    Attributes
    ----------
    restitution, friction : str
        "min", "max", "product", "geometric_mean" or "mean".

    Raises
    ------
    ValueError
        There is no rule of that name.

    Examples
    --------
    >>> MixingRule(restitution="max", friction="min").friction
    'min'
    """

    restitution: str = "min"
    friction: str = "geometric_mean"

    def __post_init__(self) -> None:
        """Refuse a rule that does not exist."""
        for name in ("restitution", "friction"):
            if getattr(self, name) not in tuple(RULES):
                raise ValueError(
                    f"{name} must be one of {', '.join(RULES)}, got {getattr(self, name)!r}"
                )


MIXING_RULES = {
    "workbook": MixingRule(),
    "pymunk": MixingRule("product", "product"),
    "box2d": MixingRule("max", "geometric_mean"),
}
"""The mixing rules of the engines one may want to compare with, by name."""


def mixing_rule(combine: str | MixingRule) -> MixingRule:
    """Return a mixing rule, which may be given by its name.

    Raises
    ------
    ValueError
        There is none of that name.

    Examples
    --------
    >>> mixing_rule("box2d").restitution
    'max'
    """
    if isinstance(combine, MixingRule):
        return combine
    if combine not in tuple(MIXING_RULES):
        raise ValueError(
            f"combine must be one of {', '.join(MIXING_RULES)} or a MixingRule, got {combine!r}"
        )
    return MIXING_RULES[combine]


def mixed(rule: int, a: float, b: float) -> float:
    """Return the pair's coefficient by a rule; a negative one is left to the other body.

    Where both are left open the pair's is 0.

    >>> mixed(MIN, 0.5, 0.8), mixed(PRODUCT, 0.5, UNSPECIFIED)
    (0.5, 0.5)
    """
    if a < 0 and b < 0:
        return 0.0
    if a < 0:
        return b
    if b < 0:
        return a
    if rule == MIN:
        return min(a, b)
    if rule == MAX:
        return max(a, b)
    if rule == PRODUCT:
        return a * b
    if rule == GEOMETRIC_MEAN:
        return math.sqrt(a * b)
    return (a + b) / 2

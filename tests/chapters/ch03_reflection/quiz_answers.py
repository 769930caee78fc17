"""The quiz of chapter 03: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below


def squared(*components: F) -> F:
    """Return the square of a vector's length."""
    return sum((c * c for c in components), F(0))


def mirrored_y(normal_part_times: int) -> F:
    """Return the y component of (3, -4) after its part along (0.6, 0.8) is removed so often."""
    nx, ny = F(3, 5), F(4, 5)
    return -4 - normal_part_times * (3 * nx - 4 * ny) * ny


E = F(4, 5)

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "03-popular": (
        100 * F(95, 100) ** 2,
        [
            F(95),
            100 * (F(280) ** 2 + (F(95, 100) * 180) ** 2) / (F(280) ** 2 + F(180) ** 2),
            100 * (1 - F(95, 100) ** 2),
        ],
    ),
    "03-reflect": (
        mirrored_y(2),
        [
            mirrored_y(1),
            F(4),
            -mirrored_y(2),
            mirrored_y(-2),
            3 - 2 * (3 * F(3, 5) - 4 * F(4, 5)) * F(3, 5),
            -4 - 2 * (-4 * F(4, 5)) * F(4, 5),
        ],
    ),
    "03-bounce": (
        math.sqrt(squared(F(3), 5 * E)),
        [
            math.sqrt(squared(3 * E, 5 * E)),
            math.sqrt(squared(F(3), F(5))),
            5 * E,
            3 + 5 * E,
            math.sqrt(3**2 + 5**2 * E),
        ],
    ),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "03-normal-part": "The normal component of I: a vector",
    "03-gate": "v·N < 0",
    "03-either-normal": "N stands twice",
}
"""What the right options of some questions say, as the lesson does."""


def bumped(times: int) -> tuple[F, F]:
    """Return (0, -2) after its part along (1, 1)/√2 is taken away so many times."""
    along = F(-2, 2)  # the dot product with (1, 1), over the square of its length
    return -times * along, -2 - times * along


TIPS = {
    "03-bumper": (bumped(2), [(0, 2), (2, 2), (1, 1), bumped(0), bumped(1), (-2, 0)]),
}
"""For each arrow the tip of the right one, and those of the mistakes."""

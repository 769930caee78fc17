"""The quiz of chapter 04: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "04-by-hand": (
        2 - F(17, 10) * 3 * F(3, 4),
        [
            2 + F(17, 10) * 3 * F(3, 4),
            -1 + F(17, 10) * 3 * F(3, 4) / 3,
            F(1 * 2 + 3 * -1, 1 + 3),
            2 - F(17, 10) * 3 * (1 + 3),
        ],
    ),
    "04-depth": (
        F(2) + F(7, 2) - math.isqrt(3**2 + 4**2),
        [
            math.isqrt(3**2 + 4**2) - (F(2) + F(7, 2)),
            F(math.isqrt(3**2 + 4**2)),
            F(2) + F(7, 2),
            (F(2) + F(7, 2)) ** 2 - (3**2 + 4**2),
            F(2) + F(7, 2) - (3 + 4),
        ],
    ),
    "04-impulse": (
        F(3, 4) * F(3, 2) * 4,
        [
            F(3, 4) * 2 * F(3, 2) * 4,
            F(3, 4) * 2 * 4,
            F(3, 4) * 4,
            (1 + 3) * F(3, 2) * 4,
            (F(1, 1) + F(1, 3)) * F(3, 2) * 4,
            F(3, 4) * F(1, 2) * 4,
        ],
    ),
    "04-split": (
        F(4, 10) * F(3, 1 + 3),
        [F(4, 10) / 2, F(4, 10) * F(1, 1 + 3), F(4, 10), F(4, 10) / 3],
    ),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "04-separating": "Move them apart by 0.1 m; leave their velocities alone",
}
"""What the right options of some questions say, as the lesson does."""


def after(share: F) -> tuple[F, F]:
    """Return (4, 0) less this share of its part along (1, 1)/√2, which is (2, 2)."""
    return 4 - 2 * share, -2 * share


TIPS = {
    "04-angle": (
        after(F(1)),
        [(4 - after(F(1))[0], -after(F(1))[1]), (0, 0), (-4, 0), after(F(2)), after(F(0))],
    ),
}
"""For each arrow the tip of the right one, and those of the mistakes."""

"""The quiz of chapter 07: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below


def let_through(reach: F) -> F:
    """Return how many per cent of balls pass that are stopped on so many m of a step of 0.5 m."""
    return 100 * (1 - reach / (50 * F(1, 100)))


ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "07-escape": (
        let_through(F(1, 10) + F(1, 20)),
        [
            100 - let_through(F(1, 10) + F(1, 20)),
            let_through(2 * F(1, 10) + F(1, 10)),
            let_through(F(1, 10) + F(1, 10)),
            let_through(F(1, 10)),
            let_through(F(1, 10) + F(1, 20)) / 100,
        ],
    ),
    "07-first-touch": (
        F(14 - math.isqrt(5**2 - 3**2), 3 + 2),
        [
            F(14, 3 + 2),
            F(14 + math.isqrt(5**2 - 3**2), 3 + 2),
            F(14 - math.isqrt(5**2 - 3**2), 3),
            F(14 - 5, 3 + 2),
            F(14 - math.isqrt(5**2 - 3**2), 3 - 2),
        ],
    ),
    "07-first-speed": (
        60 * (F(1, 10) + F(1, 10) / 2),
        [60 * F(1, 10), 60 * (F(1, 10) + F(1, 10)), 2 * 60 * (F(1, 10) + F(1, 10) / 2)],
    ),
    "07-pi": (F(1 + 1 + 1), [F(1 + 1), F(1)]),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "07-zero": "The hit is lost",
    "07-at-the-instant": "Nothing, or something only if rounding",
}
"""What the right options of some questions say, as the lesson does."""

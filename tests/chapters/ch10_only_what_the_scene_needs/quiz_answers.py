"""The quiz of chapter 10: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "10-pair": (
        math.sqrt(0.9 * 0.4),
        [F(9, 10), F(9, 10) * F(4, 10), (F(9, 10) + F(4, 10)) / 2, F(4, 10), F(0)],
    ),
    "10-bound": (
        math.sqrt(8 * 3**2 / 0.5),
        [
            F(3),
            math.sqrt(8 * 3**2 / 2),
            24 / 10.5 + math.sqrt(2 * (36 - 24**2 / 2 / 10.5) * 10 / 10.5 / 0.5),
            math.sqrt(8 * 3**2 / 2 / 0.5),
            F(8 * 3) / F(1, 2),
        ],
    ),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "10-side": "call for an effect that turns out not to be needed",
    "10-island": "floors do not join islands",
}
"""What the right options of some questions say, as the lesson does."""

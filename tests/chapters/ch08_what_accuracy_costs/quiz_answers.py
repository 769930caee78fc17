"""The quiz of chapter 08: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "08-order": (
        F(1),  # 24/8 = ((1/60) / (1/180))^p
        [F(24, 8), math.log2(24 / 8), F(-1), F(2)],
    ),
    "08-late": (
        100 * (1 + F(1, 2)) * 6 * F(1, 50) / 2,
        [
            100 * (1 + F(1, 2)) * 6 * F(1, 50),
            100 * 6 * F(1, 50) / 2,
            100 * (1 + F(1)) * 6 * F(1, 50) / 2,
            100 * (1 - F(1, 2)) * 6 * F(1, 50) / 2,
            (1 + F(1, 2)) * 6 * F(1, 50) / 2,
        ],
    ),
    "08-halved": (F(1), [F(2), F(1, 2)]),
    "08-millimetre": (30 * F(630), [F(630), 30 / F(630)]),  # 0.63 m is 630 times 1 mm
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

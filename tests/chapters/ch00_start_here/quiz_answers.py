"""The quiz of chapter 00: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "00-half-way": (math.degrees(math.acos(1 / 2)), [F(90, 2), math.degrees(math.asin(1 / 2))]),
    "00-unit-normal": (
        F(3, math.isqrt(3**2 + 4**2)),
        [F(3), F(3, 3 + 4), F(4, 5), F(3, 3**2 + 4**2), F(-3, 5)],
    ),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

"""The quiz of chapter 06: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "06-overlap": (
        F(min(40 - 22, 32 - 0)),
        [F(min(40, 32) - max(0, 22)), F(max(40 - 22, 32 - 0)), F(40 - 32), F(22 - 0), F(40 - 0)],
    ),
    "06-inside": (
        F(1, 2) + F(1, 5),
        [F(1, 2) - F(1, 5), F(1, 5), F(1, 2), F(1, 2) + 2 * F(1, 5)],
    ),
    "06-diagonal": (math.hypot(2, 2), [F(2), math.hypot(1, 1), F(2 + 2)]),
    "06-nested": (F(min(40 - 15, 25 - 0)), [F(min(40, 25) - max(0, 15)), F(15 - 0)]),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

"""The quiz of chapter 09: each number, worked out without the bank, and what is right."""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "09-sweeps": (
        100 * F(3, 3 + 1) ** 2,
        [
            100 * F(3, 3 + 1),
            100 * (1 - 2 * F(1, 3 + 1)),
            100 * F(1, 3 + 1) ** 2,
            100 * F(1, 2) ** 2,
        ],
    ),
    "09-jumps": (
        F(9, 10) * F((3 - 1) ** 2, 3) ** 2,
        [
            F(9, 10) * F((3 - 1) ** 2, 3),
            F(9, 10) * F((3 - 1) ** 2, 3) ** 4,
            F(9, 10) * F((3 - 1) ** 2, 3) * 2,
            F(9, 10) * 3**2,
        ],
    ),
    "09-ten-sweeps": (F(100, 100 + 1) ** 10, [F(1, 1 + 1) ** 10, F(100, 100 + 1)]),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "09-cradle": "two equations for five unknowns",
    "09-energy": "more energy after the impact",
}
"""What the right options of some questions say, as the lesson does."""

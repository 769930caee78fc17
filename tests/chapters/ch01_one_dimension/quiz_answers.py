"""The quiz of chapter 01: each number, worked out without the bank, and what is right."""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "01-momentum": (
        F(2 * 3 + 5 * -1),
        [F(2 * 3 + 5 * 1), F(5 * 1 - 2 * 3), F((2 + 5) * (3 - 1)), F(3 - 1)],
    ),
    "01-sticking": (
        F(3 * 4 + 1 * -2, 3 + 1),
        [
            F(3 * 4 + 1 * 2, 3 + 1),
            F(4 - 2, 2),
            F(3 * 4, 3 + 1),
            F(1 * 4 + 3 * -2, 3 + 1),
            F(3 * 4 - 2),
        ],
    ),
    "01-stick": (F(3 - 3, 4), [F(3 - 1, 2), F(3 * 3 - 1, 4), F(3 + 3, 4)]),
    "01-share": (F(1 * 3, 3), [F(3), F(3 * 3), F(-1 * 3, 3)]),
    "01-elastic": (
        2 * F(2 - 3, 4) - 2,
        [F(-2), F(-1), F(2 - 3, 4) - 2, 2 * F(2 - 3, 4) + 2],
    ),
    "01-stops": (1 / F(1, 2), [F(1), F(1, 2)]),
    "01-wall-comes": (F(2 * -1 - 3), [F(-3), F(-(3 + 1)), F(-(3 - 1))]),
    "01-velocity-change": (F(-6, 12), [F(6, 12), F(6, 3), F(-6, 3), F(-6, 12 + 3), F(-6 * 12)]),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "01-heavy-moves-less": "Δv = J/m",
    "01-wall": "Ball \N{MINUS SIGN}5 m/s, wall 0 m/s",
}
"""What the right options of some questions say, as the lesson does."""

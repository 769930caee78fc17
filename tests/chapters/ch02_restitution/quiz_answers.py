"""The quiz of chapter 02: each number, worked out without the bank, and what is right."""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817 - written many times below
from math import sqrt


def squared(*components: F) -> F:
    """Return the square of a vector's length."""
    return sum((c * c for c in components), F(0))


E = F(4, 5)

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "02-measure": (
        F(4 - -2, 5 - -3),
        [
            F(4 - -2, 5 - 3),
            F(4 - 2, 5 - -3),
            F(4 - 2, 5 - 3),
            F(5 - -3, 4 - -2),
            F(-2 - 4, 5 - -3),
            squared(F(-2), F(4)) / squared(F(5), F(-3)),
        ],
    ),
    "02-energy-kept": (
        100 * F(7, 10) ** 2,
        [F(70), 100 * (1 - F(7, 10) ** 2), 100 * (1 - F(7, 10))],
    ),
    "02-ruler": (F(1, 2), [F(1, 4), F(1, 4) ** 2, 1 - F(1, 4)]),
    "02-longer": (sqrt(2 / 9.81) * 19, [sqrt(2 / 9.81) * 9 * k for k in (9 / 8, 81 / 64)]),
    "02-heights": (2 * E ** (2 * 3), [2 * E**3, 2 * E ** (2 * 2), 2 * E ** (2 * 4), E ** (2 * 3)]),
    "02-energy-lost": (
        100 * (1 - F(9, 10) ** 2),
        [
            100 * F(9, 10) ** 2,
            100 * (1 - F(9, 10)),
            100 * F(9, 10),
            100 * (1 - F(9, 10)) ** 2,
            1 - F(9, 10) ** 2,
        ],
    ),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "02-zeno": "Infinitely often, and it rests after a finite time",
}
"""What the right options of some questions say, as the lesson does."""

"""The quiz of chapter 11: each number, worked out without the bank, and what is right."""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817 - written many times below

ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "11-step": (
        5 - (2 + 3) * F(1, 10),
        [5 - (3 + 4) * F(1, 10), 5 - 2 * F(2, 10) - 5 * F(2, 10) ** 2, 5 - 4 * F(1, 10), F(5, 10)],
    ),
    "11-pairs": (F(20 * 19, 2), [F(20 * 20), F(20 * 19), F(20 * 20, 2), F(20)]),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "11-gate": "only who moves into the wall is turned round",
}
"""What the right options of some questions say, as the lesson does."""

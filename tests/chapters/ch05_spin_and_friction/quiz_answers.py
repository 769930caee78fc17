"""The quiz of chapter 05: each number, worked out without the bank, and what is right."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below


def rolling(k: F) -> F:
    """Return at which speed a body rolls that slid at 6 m/s; its inertia is k m r^2."""
    return 6 / (1 + k)


ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "05-contact-velocity": (
        3 - F(-4) * F(-1, 2),
        [3 - F(-4) * F(1, 2), F(3), -F(-4) * F(-1, 2), F(3 - 4)],
    ),
    "05-clamp": (
        -min(F(1, 2) * 4, F(3 * 2)),
        [F(-3 * 2), F(1, 2) * 4, F(3 * 2), -min(F(4), F(3 * 2)), -F(1, 2), F(-3)],
    ),
    "05-roll": (
        rolling(F(1, 2)),
        [rolling(F(1)), rolling(F(2, 5)), math.sqrt(6**2 / (1 + F(1, 2))), F(6), F(0)],
    ),
    "05-wheel": (F(3) - 6 * F(1, 2), [F(3), 3 + 6 * F(1, 2), -6 * F(1, 2)]),
    "05-sticks": (F(1 * 3, 4), [F(4, 3), F(3)]),
    "05-rubber": (
        F(-1) * F(1, 2) / (F(1, 2) * F(1, 2) ** 2),
        [F(4), F(-6) * F(1, 2) / (F(1, 2) * F(1, 2) ** 2), F(-3) / F(1, 2)],
    ),
    "05-hoop": (F(1, 1 + 1), [F(1), 1 / (1 + F(1, 2))]),
}
"""For each numeric question the answer, and the wrong values in the order of the bank.

Each wrong value is computed by the mistake that its feedback speaks of.
"""

RIGHT_OPTIONS = {
    "05-off-centre": "At the middle",
    "05-extra-vertex": "Nothing: the body is the same",
    "05-what-is-kept": "The total momentum and the total angular momentum",
}
"""What the right options of some questions say, as the lesson does."""

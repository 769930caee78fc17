"""Rows of balls that strike pair by pair, drawn so that the order of the strikes counts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from random import Random
from typing import TypeAlias

from lesson_code.formulas import collide_1d
from lesson_code.formulas.validation import equation

Order: TypeAlias = Callable[[list[float]], Sequence[int]]
"""Which pairs a round goes through, by the approaches, m/s, that it begins with."""

MOST_STRIKES = 60
"""A row that has not come to an end by then is not drawn."""

STRIKE = equation(collide_1d)
"""The bare formula, since a draw takes hundreds of strikes."""

CLEAR = 0.05
"""m/s, by which another order changes a velocity at least."""


def leftmost(approaches: list[float]) -> Sequence[int]:
    """Return the leftmost pair that approaches."""
    return _approaching(approaches)[:1]


def rightmost(approaches: list[float]) -> Sequence[int]:
    """Return the rightmost pair that approaches."""
    return _approaching(approaches)[-1:]


def fastest(approaches: list[float]) -> Sequence[int]:
    """Return the pair that approaches fastest."""
    return ranked(approaches)[:1]


def ranked(approaches: list[float]) -> Sequence[int]:
    """Return all pairs that approach, the fastest first."""
    return sorted(_approaching(approaches), key=lambda k: -approaches[k])


def to_the_right(approaches: list[float]) -> Sequence[int]:
    """Return all pairs from left to right."""
    return range(len(approaches))


def to_the_left(approaches: list[float]) -> Sequence[int]:
    """Return all pairs from right to left."""
    return range(len(approaches))[::-1]


ORDERS: tuple[Order, ...] = (leftmost, rightmost, fastest, ranked, to_the_right, to_the_left)


def _approaching(approaches: list[float]) -> list[int]:
    """Return the pairs that approach, from the left."""
    return [k for k, approach in enumerate(approaches) if approach > SLOWEST]


SLOWEST = 1e-9
"""m/s: slower is no approach."""


def after_strikes(
    masses: Sequence[float], velocities: Sequence[float], restitution: float, order: Order
) -> list[float] | None:
    """Return the velocities after all strikes, m/s, or None if they are many."""
    v, strikes = list(velocities), 0
    while strikes <= MOST_STRIKES:
        places = order([a - b for a, b in pairwise(v)])
        before = strikes
        for k in places:
            if v[k] - v[k + 1] > SLOWEST:
                v[k : k + 2] = STRIKE(masses[k], v[k], masses[k + 1], v[k + 1], restitution)
                strikes += 1
        if strikes == before:
            return v
    return None


def row_in_which_order_counts(
    stream: Random, restitution: float, right: Order, other: Order
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return masses, kg, and velocities, m/s, of four balls, for which two orders differ clearly.

    All neighbours approach at the start.
    """
    while True:
        masses = tuple(round(stream.uniform(0.5, 4.0), 2) for _ in range(4))
        speeds = sorted((round(stream.uniform(-4.0, 4.0), 2) for _ in masses), reverse=True)
        one, two = (after_strikes(masses, speeds, restitution, each) for each in (right, other))
        if one and two and max(abs(a - b) for a, b in zip(one, two, strict=True)) > CLEAR:
            return masses, tuple(speeds)

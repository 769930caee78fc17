"""How a cradle moves: exact swings from impact to impact, and two laws of impacts.

The balls hang side by side on strings of one length, so that neighbours touch exactly where their
angles are equal. They are on one level then, and an impulse j between them changes their rates by
j/(m L) each, like one between carts on a line. Between impacts each ball is a pendulum,

    angle'' = -g/L sin(angle)

whose Taylor series is summed until its terms are below the rounding of a number. So the energy is
kept to rounding, whatever the masses and for any time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, zip_longest
from operator import mul
from typing import NamedTuple, TypeAlias

import numpy as np

from lesson_code.chapters.cradle.rules import GRAVITY, collide_row
from lesson_code.engine.solvers.contact_problem import Problem
from lesson_code.engine.solvers.impact_rules import newton

TERMS = 14
"""Of the series: with L = 3 m and steps of 1/60 s the next one is below 1e-20 rad."""

TOUCHING = 1e-12
"""rad: neighbours whose angles differ by less touch."""

CREEPING = 1e-12
"""rad/s: neighbours that approach more slowly go on together."""

MOST_IMPACTS = 200
"""Times of impact in a step: then what still approaches goes on together."""

Law: TypeAlias = Callable[[Sequence[float], Sequence[float], float], list[float]]
"""Velocities after an impact of balls that all touch, from masses, velocities and restitution."""


class Impact(NamedTuple):
    """Neighbours that have struck each other: the left one, and the impulse, N s."""

    left: int
    impulse: float


@dataclass
class Row:
    """Balls on strings, from the left: kg, rad (positive to the right), rad/s, and m."""

    masses: list[float]
    angles: list[float]
    rates: list[float]
    length: float

    def energy(self) -> float:
        """Return kinetic and potential energy, J; 0 for balls that hang still."""
        balls = zip(self.masses, self.angles, self.rates, strict=True)
        # 1 - cos a = 2 sin(a/2)^2: no digits are lost where a ball hangs nearly still
        return sum(
            m * self.length * (self.length * w * w / 2 + GRAVITY * 2 * math.sin(a / 2) ** 2)
            for m, a, w in balls
        )

    def velocities(self) -> list[float]:
        """Return how fast the balls move along their circles, m/s."""
        return [self.length * rate for rate in self.rates]


def in_turn(
    masses: Sequence[float], velocities: Sequence[float], restitution: float
) -> list[float]:
    """Return the velocities after one pair has struck after the other.

    >>> in_turn([1, 1, 1], [3.0, 0.0, 0.0], 1.0)
    [0.0, 0.0, 3.0]
    """
    return collide_row(masses, velocities, restitution)


def all_at_once(
    masses: Sequence[float], velocities: Sequence[float], restitution: float
) -> list[float]:
    """Return the velocities after all pairs have struck at the same instant.

    Impulses j >= 0 between neighbours, after which each pair parts at e times its approach at the
    least, and exactly so where it is pushed.

    >>> [round(v, 9) for v in all_at_once([1, 1, 1], [3.0, 0.0, 0.0], 1.0)]
    [-1.0, 2.0, 2.0]
    """
    pairs, inverse = len(masses) - 1, 1.0 / np.asarray(masses, dtype=float)
    delassus = np.eye(2 * pairs)
    delassus[:pairs, :pairs] = np.diag(inverse[:-1] + inverse[1:])
    for k in range(pairs - 1):
        delassus[k, k + 1] = delassus[k + 1, k] = -inverse[k + 1]
    approach = np.concatenate((np.diff(velocities), np.zeros(pairs)))
    impulses = newton(Problem(delassus, approach, np.zeros(pairs)), np.full(pairs, restitution))
    j = np.concatenate(([0.0], impulses[:pairs], [0.0]))
    return [float(v) for v in np.asarray(velocities) + (j[:-1] - j[1:]) * inverse]


LAWS: dict[str, Law] = {"in turn": in_turn, "all at once": all_at_once}
"""Both keep momentum, and with e = 1 energy."""


def step(row: Row, dt: float, law: Law, restitution: float) -> list[Impact]:
    """Let the balls swing for a time, s, and strike where they meet; return what has struck."""
    impacts, left, times = strike(row, law, restitution), dt, 0
    while left > 0.0:
        series = [_series(a, w, row.length) for a, w in zip(row.angles, row.rates, strict=True)]
        until = min(_meetings(series, left), default=left)
        row.angles = [_sum(terms, until) for terms in series]
        row.rates = [_slope(terms, until) for terms in series]
        left -= until
        times += 1
        impacts += strike(row, law, restitution if times < MOST_IMPACTS else 0.0)
        if times > 2 * MOST_IMPACTS:
            break
    return impacts


def strike(row: Row, law: Law, restitution: float) -> list[Impact]:
    """Let neighbours that touch and approach strike each other, by a law; return the impulses."""
    impacts: list[Impact] = []
    for first, end in _clusters(row):
        balls = slice(first, end)
        masses, before = row.masses[balls], row.velocities()[balls]
        if not _approaches(before, CREEPING * row.length):
            continue
        after = law(masses, before, restitution)
        if _approaches(after, CREEPING * row.length):
            after = all_at_once(masses, after, 0.0)
        row.rates[balls] = [v / row.length for v in after]
        passed = 0.0  # what the balls so far have passed on to the right
        for k in range(end - first - 1):
            passed += masses[k] * (before[k] - after[k])
            impacts.append(Impact(first + k, passed))
    return impacts


def _clusters(row: Row) -> Iterator[tuple[int, int]]:
    """Yield the first ball of each group that touches, and the one after its last."""
    first = 0
    for k in range(1, len(row.angles) + 1):
        if k == len(row.angles) or row.angles[k] - row.angles[k - 1] > TOUCHING:
            if k - first > 1:
                yield first, k
            first = k


def _approaches(velocities: Sequence[float], least: float) -> bool:
    """Return whether any neighbours approach faster than so much, m/s."""
    return any(a - b > least for a, b in pairwise(velocities))


def _series(angle: float, rate: float, length: float) -> list[float]:
    """Return the Taylor coefficients of a pendulum's angle, from those of its sine and cosine."""
    a = [angle, rate]
    if angle == 0.0 and rate == 0.0:
        return a
    s, c, turns = [math.sin(angle)], [math.cos(angle)], []
    for n in range(TERMS - 2):
        a.append(-GRAVITY / length * s[n] / ((n + 2) * (n + 1)))
        turns.append((n + 1) * a[n + 1])
        of_sine = sum(map(mul, turns, reversed(c))) / (n + 1)
        c.append(-sum(map(mul, turns, reversed(s))) / (n + 1))
        s.append(of_sine)
    return a


def _sum(terms: Sequence[float], t: float) -> float:
    """Return the value of a series at a time."""
    value = 0.0
    for term in reversed(terms):
        value = value * t + term
    return value


def _slope(terms: Sequence[float], t: float) -> float:
    """Return the derivative of a series at a time."""
    return _sum([n * term for n, term in enumerate(terms)][1:], t)


def _meetings(series: Sequence[Sequence[float]], end: float) -> Iterator[float]:
    """Yield when neighbours that are apart now meet, s, within a time."""
    for left, right in pairwise(series):
        if right[0] - left[0] > TOUCHING:
            terms = zip_longest(right, left, fillvalue=0.0)  # a ball that hangs still has only two
            gap = [b - a for b, a in terms]
            if _sum(gap, end) < 0.0:
                yield _root(gap, end)


def _root(gap: Sequence[float], end: float) -> float:
    """Return when a gap closes that is open at 0 and not at the end, s.

    By Newton's method; where a guess leaves the interval that is left, that is halved.
    """
    low, high, t = 0.0, end, end / 2
    for _ in range(60):
        value = _sum(gap, t)
        low, high = (t, high) if value > 0.0 else (low, t)
        slope = _slope(gap, t)
        guess = t - value / slope if slope != 0.0 else t
        guess = guess if low < guess < high else (low + high) / 2
        if abs(guess - t) <= 1e-16:
            break
        t = guess
    return t

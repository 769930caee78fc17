"""Circles in flight: pairs that hit, graze, miss or touch, and crowds in which one pair is first.

A hit is drawn backwards: the circles are put where they touch, and flown back to the start.
Positions have two decimals; where a thousandth of a metre decides, four.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from random import Random
from typing import TypeAlias

from lesson_code.chapters import draws
from lesson_code.chapters.draws import Vector
from lesson_code.course.grading.task import Arguments

Circle: TypeAlias = tuple[complex, complex, float]
"""Position, m, and velocity, m/s, as complex numbers, and radius, m."""

SAMPLES = 10
"""Samples in a step; between two of them a fast graze begins and ends."""

ORDERS = (2, 5, 0, 6, 4, 1, 7, 3), (0, 2, 6, 5, 1, 3, 4, 7), (0, 6, 1, 5, 7, 4, 2, 3)
"""Of a crowd: 0 and 1 are the slow pair, 2 and 3 the fast one, 4 and 5 the followers of these."""

LATE = 50.0
"""A late crowd moves so many times as slowly: its first pair meets after some 30 s."""

FAR = 60.0
"""m between two groups of a crowd: at their speeds they cannot meet before the first pair does."""


# Two circles: p1, v1, r1, p2, v2, r2, dt


def hits(stream: Random) -> Iterator[Arguments]:
    """Draw circles that meet obliquely within the step, both moving; either catches up, or both."""
    for pair in (draws.first_overtakes, draws.second_overtakes, draws.approaching_pair):
        *circles, t = _hit(stream, pair)
        yield *circles, round(t * stream.uniform(1.3, 2.5), 2)


def late_hits(stream: Random) -> Iterator[Arguments]:
    """Draw circles that meet after the step has ended, and two that have all the time."""
    for part in (0.5, 0.9, math.inf):
        *circles, t = _hit(stream)
        yield *circles, part * t


def fast_grazes(stream: Random) -> Iterator[Arguments]:
    """Draw circles that overlap for less than a tenth of the step, between two of ten samples."""
    for _ in range(2):
        (r1, r2), dt = draws.unequal_radii(stream), round(stream.uniform(0.2, 0.4), 2)
        speed = round(stream.uniform(100, 200), 1)
        half_chord = 0.15 * speed * dt / SAMPLES
        middle = (stream.randrange(3, 7) + 0.5) * dt / SAMPLES
        along = _turn(stream)
        p1, v1 = (complex(*draws.position(stream)) for _ in range(2))
        aside = stream.choice((-1j, 1j)) * along * math.sqrt((r1 + r2) ** 2 - half_chord**2)
        v2 = v1 + speed * along
        p2 = p1 + aside - speed * along * middle
        yield _seen(p1), _seen(v1), r1, _seen(p2, 4), _seen(v2, 4), r2, dt


def misses(stream: Random) -> Iterator[Arguments]:
    """Draw circles that pass each other, that part, and that fly side by side; two meet."""
    yield _pass(stream)
    *meeting, t = _hit(stream)
    yield *meeting, 3 * t
    p1, v1, r1, p2, v2, r2, t = _hit(stream)
    yield p1, (-v1[0], -v1[1]), r1, p2, (-v2[0], -v2[1]), r2, 3 * t
    yield p1, v1, r1, p2, v1, r2, math.inf


def in_touch(stream: Random) -> Iterator[Arguments]:
    """Draw circles that overlap or just touch, and approach or part."""
    for velocities in (draws.approaching_pair, draws.separating_pair):
        n, (r1, r2) = draws.oblique_normal(stream), draws.unequal_radii(stream)
        p1, (v1, v2) = draws.position(stream), velocities(stream, n)
        yield p1, v1, r1, draws.at_distance(p1, 0.8 * (r1 + r2), n), v2, r2, 1.0
    for way in (1, -1):
        p1, r1, p2, r2 = _touching(stream)
        yield p1, (way * 1.5, 0.5), r1, p2, (way * -0.75, 0.25), r2, 1.0


def _hit(
    stream: Random, pair: Callable[[Random, Vector], tuple[Vector, Vector]] = draws.approaching_pair
) -> tuple[Vector, Vector, float, Vector, Vector, float, float]:
    """Return two circles that meet obliquely, and when."""
    n, (r1, r2) = draws.oblique_normal(stream), draws.unequal_radii(stream)
    v1, v2 = pair(stream, n)
    t, p1 = round(stream.uniform(0.4, 0.9), 2), draws.position(stream)
    back = complex(*v2) - complex(*v1)
    p2 = complex(*p1) + (r1 + r2) * complex(*n) - back * t
    return p1, v1, r1, _seen(p2), v2, r2, t


def _pass(stream: Random) -> Arguments:
    """Return two circles that pass each other at a small distance, though their boxes meet."""
    (r1, r2), way, speed = draws.unequal_radii(stream), _turn(stream), 8.0
    p1, v1 = (complex(*draws.position(stream)) for _ in range(2))
    aside = stream.choice((-1j, 1j)) * way * (r1 + r2) * stream.uniform(1.02, 1.06)
    p2 = p1 + aside - speed * way * 0.5
    return _seen(p1), _seen(v1), r1, _seen(p2, 4), _seen(v1 + speed * way, 4), r2, 1.0


def _touching(stream: Random) -> tuple[Vector, float, Vector, float]:
    """Return circles exactly in touch, the second one to the right; no number is rounded."""
    x, y = (stream.randrange(-40, 40) / 8 for _ in range(2))
    size = stream.randrange(2, 9) / 8
    r1 = size * stream.choice((1.5, 3.5))
    return (x, y), r1, (x + 3 * size, y - 4 * size), 5 * size - r1


# Crowds: positions, velocities, radii


def crowds(stream: Random) -> Iterator[Arguments]:
    """Draw crowds in which a far, fast pair meets before a near, slow one.

    A third pair meets later still, or met in the past. The fast pair has followers, who are nearer
    to its circles than these to each other. Its places are first and last, any, and the last two.
    """
    later, earlier = (3.0, 1.0), (2.0, -3.0)
    for other, order in zip((later, earlier, later), ORDERS, strict=True):
        slow, fast = _pair(stream, 0.5, 0.4), _with_followers(_pair(stream, 4.0, 6.0))
        groups = _scattered(stream, (slow, fast, _pair(stream, *other)))
        yield _crowd([groups[n] for n in order])


def crowds_soon_and_late(stream: Random) -> Iterator[Arguments]:
    """Draw these crowds, and one in which all happens late."""
    yield from crowds(stream)
    positions, velocities, radii = next(crowds(stream))
    yield positions, tuple(_seen(complex(*v) / LATE, 4) for v in velocities), radii


def crowds_with_a_hit_now(stream: Random) -> Iterator[Arguments]:
    """Draw crowds in which a pair overlaps and approaches, while others will meet later.

    In the order of the pairs, that one is the second that meets, and then the first.
    """
    for is_second in (True, False):
        pairs = (_pair(stream, 2.0, 5.0), _pair(stream, -0.3, 2.0))
        first, second, third, fourth = _scattered(stream, pairs if is_second else pairs[::-1])
        yield _crowd([first, third, second, fourth])


def crowds_that_part(stream: Random) -> Iterator[Arguments]:
    """Draw a crowd that flies apart as after a burst, one in step, and two that meet.

    In the second of these two circles overlap, but part.
    """
    yield next(crowds(stream))
    pairs = (_pair(stream, 2.0, 5.0), _pair(stream, -0.3, -2.0))
    first, second, third, fourth = _scattered(stream, pairs)
    yield _crowd([third, first, fourth, second])
    turn, start = _turn(stream), complex(*draws.position(stream))
    places = [turn * place for place in (-4, 4j, 5 - 2j)]
    radii = [round(stream.uniform(0.5, 1.2), 2) for _ in places]
    for velocities in (places, [turn] * len(places)):
        yield _crowd([(start + p, v, r) for p, v, r in zip(places, velocities, radii, strict=True)])


def _pair(stream: Random, gap: float, approach: float) -> list[Circle]:
    """Return two circles with a gap, m, that approach each other, m/s."""
    (r1, r2), n = draws.unequal_radii(stream), complex(*draws.oblique_normal(stream))
    v = complex(*draws.position(stream)) / 5
    apart, speed = gap * stream.uniform(0.9, 1.1), approach * stream.uniform(0.9, 1.1)
    p2, v2 = (r1 + r2 + apart) * n, v - (speed + 0.1j) * n
    return [(0j, v, r1), (p2, v2, r2)]


def _with_followers(pair: list[Circle]) -> list[Circle]:
    """Return two circles and, at their backs, one for each that flies in step with it."""
    (p1, v1, r1), (p2, v2, r2) = pair
    n = (p2 - p1) / abs(p2 - p1)
    behind = [(p1 - (r1 + 2) * n, v1, 1.0), (p2 + (r2 + 2) * n, v2, 1.0)]
    return [*pair, *behind]


def _scattered(stream: Random, pairs: tuple[list[Circle], ...]) -> list[Circle]:
    """Return the circles of some pairs, each pair far from the others."""
    turn = _turn(stream)
    return [(p + FAR * place * turn, v, r) for place, pair in enumerate(pairs) for p, v, r in pair]


def _crowd(circles: list[Circle]) -> Arguments:
    """Return positions, velocities and radii of some circles."""
    positions, velocities, radii = zip(*circles, strict=True)
    return tuple(map(_seen, positions)), tuple(map(_seen, velocities)), radii


def _turn(stream: Random) -> complex:
    """Return a direction that lies along no axis, as a complex number of length 1."""
    return complex(*draws.oblique_normal(stream))


def _seen(vector: complex, decimals: int = 2) -> Vector:
    """Return a complex number as a vector, rounded."""
    return round(vector.real, decimals), round(vector.imag, decimals)

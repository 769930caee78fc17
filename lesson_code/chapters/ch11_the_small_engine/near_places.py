"""Three ways to find which of many places are near each other, and how often each compares two.

Places are rows (x, y), and near are two that differ by at most `reach` along x and along y. Each
way returns the pairs and the number of comparisons.
"""

from __future__ import annotations

import math
import timeit
from collections import defaultdict
from collections.abc import Callable, Iterator
from itertools import combinations, product
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch11_the_small_engine import own_answers as answers
from lesson_code.course.grading.own import OwnFunction

Pair: TypeAlias = tuple[int, int]
Found: TypeAlias = tuple[set[Pair], int]
Place: TypeAlias = tuple[float, float]

LONG = 1.0
"""s: what takes longer is timed once."""


def every_pair(places: list[Place], reach: float) -> Found:
    """Compare every place with every other: N (N - 1) / 2 times."""
    return _near(places, reach, combinations(range(len(places)), 2))


def sweep(places: list[Place], reach: float) -> Found:
    """Go from left to right; compare a place with those that are not too far behind.

    About N^1.5 times where places fill a square evenly: a strip of the width of `reach` holds about
    the square root of N.
    """

    def candidates() -> Iterator[Pair]:
        order = sorted(range(len(places)), key=lambda n: places[n])
        behind: list[int] = []
        for n in order:
            behind = [k for k in behind if places[n][0] - places[k][0] <= reach]
            yield from ((k, n) for k in behind)
            behind.append(n)

    return _near(places, reach, candidates())


def grid(places: list[Place], reach: float) -> Found:
    """Sort the places into cells of the size of `reach`; look into a cell and its neighbours.

    About N times: a cell holds few, however many there are.
    """

    def candidates() -> Iterator[Pair]:
        cells: dict[Pair, list[int]] = defaultdict(list)
        for n, (x, y) in enumerate(places):
            column, row = math.floor(x / reach), math.floor(y / reach)
            for i, j in product((-1, 0, 1), repeat=2):
                yield from ((k, n) for k in cells.get((column + i, row + j), ()))
            cells[column, row].append(n)

    return _near(places, reach, candidates())


Way: TypeAlias = Callable[[list[Place], float], Found]

WAYS: dict[str, Way] = {
    "every pair": every_pair,
    "sweep": sweep,
    "grid": grid,
}


def own_way(own: OwnFunction) -> dict[str, Way]:
    """Return a reader's near_pairs as one more way, whose comparisons nobody counts.

    There is none where it is not written; and it gives up where it fails for twenty places.
    """

    def yours(places: list[Place], reach: float) -> Found:
        x, y = np.array(places).T
        boxes = np.column_stack((x - reach / 2, x + reach / 2, y - reach / 2, y + reach / 2))
        return answers.pairs(own.function(boxes)) if own.function else set(), 0

    try:
        yours(crowd(20), 1.0)
    except Exception as error:  # a reader's code may raise anything
        own.give_up(f"failed with {type(error).__name__}: {error}")
    return {"yours": yours} if own.is_own else {}


def _near(places: list[Place], reach: float, candidates: Iterator[Pair]) -> Found:
    """Return which of some pairs are near, and how many pairs there were."""
    found, compared = set(), 0
    for i, j in candidates:
        compared += 1
        (x, y), (u, v) = places[i], places[j]
        if abs(x - u) <= reach and abs(y - v) <= reach:
            found.add((min(i, j), max(i, j)))
    return found, compared


def crowd(count: int, seed: int = 1) -> list[Place]:
    """Return places all over a square whose area grows with their number: one to each m^2."""
    side = math.sqrt(count)
    drawn: Any = np.random.default_rng(seed).uniform(0, side, (count, 2))
    return [(x, y) for x, y in drawn.tolist()]


def seconds(way: Way, places: list[Place]) -> float:
    """Return how long a way takes, s: the shortest of three times, or the first if that is long."""
    took = timeit.timeit(lambda: way(places, 1.0), number=1)
    again = 2 if took < LONG else 0
    return min([took, *timeit.repeat(lambda: way(places, 1.0), number=1, repeat=again)])

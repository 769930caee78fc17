"""Whether a vector of an answer has been changed along another direction than it should."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import combinations
from typing import Any, TypeAlias

from lesson_code.course.grading.recognition.in_source import model
from lesson_code.course.grading.task import Task, WrongModel
from lesson_code.course.grading.tried import TriedCall
from lesson_code.course.isolation.inside.answers import plain

PARALLEL = 1e-9
"""The largest sine between directions that are the same: far above the rounding of an answer."""

FEWEST_CALLS = 2
"""Wrong calls in which a direction must be the same: by luck it is so in none."""

FEWEST_CALLS_ON_AXES = 4
"""Wrong calls in which a vector must change along x or along y: among walls it often does so."""

DIMENSIONS = 2

DIRECTIONS = ("normal", "direction")
"""Arguments that are directions: other vectors are changed along them, they never are."""

Given: TypeAlias = dict[str, Any]
"""The arguments of a call by their names."""

Direction: TypeAlias = tuple[str, Callable[[Given], list[float]]]
"""What a direction is called, and what it is in a call."""


def direction_of(task: Task, names: Sequence[str], calls: Sequence[TriedCall]) -> WrongModel | None:
    """Return along which direction an answer has changed a vector, if it should be another.

    Parameters
    ----------
    task : Task
        What was asked.
    names : Sequence of str
        Of its arguments.
    calls : Sequence of TriedCall
        The wrong calls.
    """
    parts = len(calls[0].wanted) if isinstance(calls[0].wanted, list) else 0
    given = [dict(zip(names, plain(list(call.arguments)), strict=True)) for call in calls]
    vectors = [name for name in names if all(_is_vector(each[name]) for each in given)]
    for place in (None, *range(parts)):
        moved = [
            (_part(call.got, place), _part(call.wanted, place), each)
            for call, each in zip(calls, given, strict=True)
        ]
        if not all(_is_vector(got) and _is_vector(wanted) for got, wanted, _ in moved):
            continue
        off = [each for each in moved if math.dist(each[0], each[1]) > PARALLEL]
        if len(off) < FEWEST_CALLS or any(_tells_nothing(*each) for each in off):
            continue
        for start in (name for name in vectors if name not in DIRECTIONS):
            on_axes = len(off) < FEWEST_CALLS_ON_AXES or all(
                _is_on_an_axis(wanted, each[start]) for _, wanted, each in off
            )
            for said, along in _directions(vectors, on_axes):
                mine = [_parallel(got, each[start], along(each)) for got, _, each in off]
                right = (
                    all(_parallel(wanted, each[name], along(each)) for _, wanted, each in off)
                    for name in vectors
                )
                if all(mine) and not any(right):
                    return model(
                        task.id, "direction", lambda *_: None, {"name": start, "along": said}
                    )
    return None


def _tells_nothing(got: list[float], wanted: list[float], given: Given) -> bool:
    """Return whether an argument came back as it was, or should have: that is no direction."""
    return any(vector in (got, wanted) for vector in given.values() if _is_vector(vector))


def _directions(vectors: Sequence[str], on_axes: bool) -> Iterator[Direction]:
    """Yield the directions that the arguments of a call hold, and the axes.

    Where the right answer, too, changes a vector along an axis, or few calls are wrong, an axis
    tells nothing.
    """
    for name in vectors:
        yield name, partial(_given, name)
        yield f"a right angle to {name}", partial(_turned, name)
    for one, other in combinations(vectors, 2):
        yield f"{one} - {other}", partial(_between, one, other)
    if not on_axes:
        yield "x", lambda _: [1.0, 0.0]
        yield "y", lambda _: [0.0, 1.0]


def _given(name: str, given: Given) -> list[float]:
    return [*given[name]]


def _turned(name: str, given: Given) -> list[float]:
    x, y = given[name]
    return [-y, x]


def _between(one: str, other: str, given: Given) -> list[float]:
    return _way(given[one], given[other])


def _is_vector(value: Any) -> bool:
    """Return whether a plain value is a vector of two components."""
    is_pair = isinstance(value, list) and len(value) == DIMENSIONS
    return is_pair and all(type(part) in (int, float) for part in value)


def _part(value: Any, place: int | None) -> Any:
    """Return one part of an answer, or all of it; None where there is no such part."""
    if place is None:
        return value
    return value[place] if isinstance(value, list) and place < len(value) else None


def _way(end: list[float], start: list[float]) -> list[float]:
    return [end[0] - start[0], end[1] - start[1]]


def _is_on_an_axis(end: list[float], start: list[float]) -> bool:
    """Return whether a vector changes along x or along y, or is mirrored at walls along these."""
    is_mirrored = all(abs(abs(a) - abs(b)) <= PARALLEL for a, b in zip(end, start, strict=True))
    return is_mirrored or min(map(abs, _way(end, start))) <= PARALLEL


def _parallel(end: list[float], start: list[float], along: list[float]) -> bool:
    """Return whether the way from a start to an end is not 0, and lies along a direction."""
    way = _way(end, start)
    size = math.hypot(*way) * math.hypot(*along)
    return size > 0 and abs(way[0] * along[1] - way[1] * along[0]) <= PARALLEL * size

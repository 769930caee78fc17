"""Slips around a right answer: in what goes into it, and in what comes out of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import accumulate, combinations, permutations, product
from typing import Any, TypeAlias

from lesson_code.course.grading.recognition.edits import MASSES, others_of, parts_of
from lesson_code.course.grading.recognition.in_source import model
from lesson_code.course.grading.task import Function, WrongModel
from lesson_code.course.isolation.inside.answers import plain
from lesson_code.course.isolation.inside.vectors import shape_of, vector

Change: TypeAlias = Callable[[Any], Any]

NUMBERS: tuple[tuple[str, Change], ...] = (
    ("minus", lambda x: -x),
    ("factor", lambda x: 2 * x),
    ("factor", lambda x: x / 2),
    ("absolute", abs),
    ("degrees", math.degrees),
    ("degrees", math.radians),
    ("power_more", lambda x: x * x),
    ("power_less", lambda x: math.copysign(math.sqrt(abs(x)), x)),
    ("upside_down", lambda x: 1 / x),
    ("rounding", math.trunc),
    *(("rounding", lambda x, digits=digits: round(x, digits)) for digits in range(8)),
)
"""What may be done to each number that is returned."""

ARGUMENTS: tuple[tuple[str, Change], ...] = (
    ("sign", lambda x: -x),
    ("ignored", lambda x: 0 * x),
    ("factor", lambda x: 2 * x),
    ("factor", lambda x: x / 2),
    ("absolute", abs),
    ("degrees", lambda x: x * (180 / math.pi)),
    ("degrees", lambda x: x * (math.pi / 180)),
    ("power_more", lambda x: x * x),
    ("power_less", lambda x: x**0.5),
    ("upside_down", lambda x: 1 / x),
    ("index", lambda x: x[::-1]),
)
"""What may be done to one argument before it is used."""

SIGNS: tuple[Change, ...] = (lambda x: x, abs, lambda x: -abs(x), lambda x: -x)
"""What may become of the sign of an argument that has one."""

LARGE = (1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e12)
"""What is taken for infinity."""

MOST_OF_ANY_KIND = 6
"""With more arguments only those are exchanged that are two of a pair by their names."""

LARGEST_ORDER = 4
"""Values in an answer whose order and parts are looked at one by one."""


def slips_around(right: Function, task: str, parameters: Sequence[str]) -> Iterator[WrongModel]:
    """Yield a wrong model for each slip in the arguments and in the answer of a right function."""
    yield from of_the_answer(right, task)
    for place, name in enumerate(parameters):
        for kind, change in ARGUMENTS:
            yield model(task, kind, _with_argument(right, place, change), {"name": name})
    for i, k in combinations(range(len(parameters)), 2):
        one, other = parameters[i], parameters[k]
        if len(parameters) > MOST_OF_ANY_KIND and other not in others_of(one, {*parameters}):
            continue
        if other in others_of(one, {*parameters}):
            yield model(task, "alike", _with_both_one(right, i, k), {"first": one, "second": other})
        exchanged = _with_places(right, {i: k, k: i})
        yield model(task, "exchanged", exchanged, {"first": one, "second": other})
        for a, b in ((i, k), (k, i)):
            names = {"wrong": parameters[b], "right": parameters[a]}
            yield model(task, "other", _with_places(right, {a: b}), names)

    for place, name in enumerate(parameters):
        for count in range(2, LARGEST_ORDER + 1):
            for part in range(count):
                unchanged = _with_argument_returned(right, count, part, place)
                yield model(task, "unchanged", unchanged, {"name": name})

    for i, k in permutations(range(min(len(parameters), MOST_OF_ANY_KIND)), 2):
        names = {"name": f"{parameters[i]} and {parameters[k]} come back"}
        yield model(task, "given", lambda *given, i=i, k=k: (given[i], given[k]), names)

    yield from slips_by_parts(right, task, parameters)


def rarer_slips_around(
    right: Function, task: str, parameters: Sequence[str]
) -> Iterator[WrongModel]:
    """Yield slips in arguments and answers that are seldom made, such as large for infinite."""
    for value in FOR_NONE:
        yield model(task, "no_answer", _then(right, partial(_or_else, other=value)), {})
    for place, name in enumerate(parameters):
        for kind, change in RARER_ARGUMENTS:
            yield model(task, kind, _with_argument(right, place, change), {"name": name})
        for power in (1, -1):
            yield model(task, "scaled", _scaled(right, place, power), {"name": name})
        for first in (0, 1):
            yield model(task, "updated", _with_component(right, place, first), {})
    if parameters:
        shorter = lambda *given: right(*given[: len(parameters) - 1])  # noqa: E731
        yield model(task, "default", shorter, {"name": parameters[-1]})
    for most in LARGE:
        yield model(task, "infinite", _with_finite(right, most), {})
    for i, k in combinations(range(len(parameters)), 2):
        one, other = parameters[i], parameters[k]
        if other in others_of(one, {*parameters}):
            for change, another in product(SIGNS, SIGNS):
                signed = _with_argument(_with_argument(right, k, another), i, change)
                yield model(task, "signs", signed, {"first": one, "second": other})


def last_slips_around(
    right: Function, task: str, parameters: Sequence[str]
) -> Iterator[WrongModel]:
    """Yield slips in arguments and answers that are made most seldom, such as numbers from 1."""
    for i, k in combinations(range(len(parameters)), 2):
        one, other = parameters[i], parameters[k]
        if other in others_of(one, {*parameters}):
            for kind, change in ARGUMENTS:
                alike = _with_argument(_with_argument(right, k, change), i, change)
                yield model(task, kind, alike, {"name": f"each of {one} and {other}"})
    for place, name in enumerate(parameters):
        yield model(task, "columns", _with_argument(right, place, _exchanged), {"name": name})
        if {*parts_of(name)} & MASSES:
            yield model(task, "fixed", _with_argument(right, place, _endless), {"name": name})
    for kind, change in RARER_ANSWERS:
        yield model(task, kind, _then(right, change), {})


def _endless(value: Any) -> Any:
    """Return an endless number, or as many as there are."""
    return 0 * value + math.inf


def _exchanged(rows: Any) -> Any:
    """Return rows with their first two values exchanged."""
    return [[second, first, *rest] for first, second, *rest in rows]


def _sums(values: Any) -> Any:
    """Return the sums of a list from its first value on."""
    return list(accumulate(values))


def _counted_on(value: Any, by: int) -> Any:
    """Return a number that counts, changed by one."""
    if not isinstance(value, int):
        raise ValueError("value must be a number that counts")
    return value + by


RARER_ANSWERS: tuple[tuple[str, Change], ...] = (
    ("summed_up", _sums),
    ("order", lambda rows: [row[::-1] for row in rows]),
    ("from_one", lambda rows: [_mapped(row, partial(_counted_on, by=1)) for row in rows]),
    ("count", partial(_counted_on, by=1)),
    ("count", partial(_counted_on, by=-1)),
)
"""What may be done to an answer, more seldom."""

FOR_NONE = (-1, False, (), 0.0, math.inf)
"""What may be returned where None is asked for."""

RARER_ARGUMENTS: tuple[tuple[str, Change], ...] = (
    ("as_one", lambda x: 0 * x + 1),
    ("complement", lambda x: 1 - x),
)
"""What may be done to one argument before it is used, more seldom."""

ALONG: tuple[tuple[str, Callable[[Any, float], Any]], ...] = (
    ("is kept", lambda part, _: part),
    ("is turned round", lambda part, _: -part),
    ("is lost", lambda part, _: 0 * part),
    ("is multiplied by e", lambda part, e: e * part),
    ("is turned round and multiplied by e", lambda part, e: -e * part),
)
"""What may become of the part of a velocity along the normal, or along the wall."""

AS_IT_SHOULD_BE = "is as it should be"
ACROSS = (*ALONG, (AS_IT_SHOULD_BE, None))
"""What may become of the part along the normal: it may also be right."""

BOTH = ((2, 0, 1), (4, 1, 3))
"""Values in an answer that holds the velocities of both bodies, and the places of these."""


def slips_by_parts(right: Function, task: str, parameters: Sequence[str]) -> Iterator[WrongModel]:
    """Yield answers in which the parts of one velocity are treated each in a way of its own.

    A velocity of the answer stands alone or is one of its parts; where the right answer moves
    none, as for bodies that part, none is moved.
    """
    names = list(parameters)
    if "normal" not in names:
        return
    places = [None, *((count, k) for count in range(2, LARGEST_ORDER + 1) for k in range(count))]
    for name in {"velocity", "incident", "v1", "v2"} & {*names}:
        for place, across, along in product(places, ACROSS, ALONG):
            changed = _by_parts(right, names, name, place, across[1], along[1])
            said = {"normal": across[0], "along": along[0]}
            yield model(task, "parts", changed, said)
    if {"v1", "v2"} <= {*names}:
        for (count, *two), across, along in product(BOTH, ACROSS, ALONG):
            changed = right
            for name, k in zip(("v1", "v2"), two, strict=True):
                changed = _by_parts(changed, names, name, (count, k), across[1], along[1])
            said = {"normal": across[0], "along": along[0]}
            yield model(task, "parts", changed, said)


def _by_parts(
    right: Function,
    names: list[str],
    velocity: str,
    place: tuple[int, int] | None,
    across: Callable[[Any, float], Any] | None,
    along: Callable[[Any, float], Any],
) -> Function:
    """Return a function that changes both parts of one velocity of an answer."""

    def answer(*given: Any) -> Any:
        value = plain(right(*given))
        before, n = (vector(given[names.index(name)]) for name in (velocity, "normal"))
        e = given[names.index("restitution")] if "restitution" in names else 1.0
        after = value if place is None else value[place[1]]
        if (place is not None and len(value) != place[0]) or shape_of(after) != shape_of(before):
            raise ValueError("value must hold a velocity in that place")
        if max(map(abs, plain(vector(after) - before))) > 1e-12:
            part = before @ n * n
            normal_part = vector(after) @ n * n if across is None else across(part, e)
            after = plain(normal_part + along(before - part, e))
        return after if place is None else [*value[: place[1]], after, *value[place[1] + 1 :]]

    return answer


def of_the_answer(right: Function, task: str) -> Iterator[WrongModel]:
    """Yield a wrong model for each slip in the answer of a function."""
    for kind, change in NUMBERS:
        yield model(task, kind, _then(right, partial(_mapped, change=change)), {})
    yield model(task, "order", _then(right, lambda value: value and value[::-1]), {})
    for count in range(2, LARGEST_ORDER + 1):
        for order in permutations(range(count)):
            if list(order) != sorted(order):
                yield model(task, "order", _then(right, _reordered(order)), {})
    for count in range(2, LARGEST_ORDER + 1):
        for place in range(count):
            for kind, change in NUMBERS[:3]:
                said = "sign" if kind == "minus" else kind
                yield model(task, said, _then(right, _in_part(count, place, change)), {})


def _then(right: Function, change: Change) -> Function:
    """Return a function whose answer is changed."""
    return lambda *arguments: change(plain(right(*arguments)))


def _or_else(value: Any, other: Any) -> Any:
    """Return an answer, or something else for None."""
    return other if value is None else value


def _scaled(right: Function, place: int, power: int) -> Function:
    """Return a function whose answer is multiplied or divided by a number among its arguments."""

    def answer(*given: Any) -> Any:
        if shape_of(given[place]):
            raise ValueError("given must be a number in that place")
        factor = given[place] ** power
        return _mapped(plain(right(*given)), lambda number: number * factor)

    return answer


def _mapped(value: Any, change: Change) -> Any:
    """Return an answer with all its numbers changed."""
    if isinstance(value, list):
        return [_mapped(item, change) for item in value]
    return value if value is None or isinstance(value, bool | str) else change(value)


def _reordered(order: tuple[int, ...]) -> Change:
    """Return what puts an answer of just as many parts into an order."""

    def change(value: Any) -> Any:
        if value is None:
            return None
        if len(value) != len(order):
            raise ValueError(f"value must have {len(order)} parts, got {len(value)}")
        return [value[index] for index in order]

    return change


def _in_part(count: int, place: int, change: Change) -> Change:
    """Return what changes one part of an answer of just as many parts."""

    def changed(value: Any) -> Any:
        if value is None:
            return None
        if len(value) != count:
            raise ValueError(f"value must have {count} parts, got {len(value)}")
        return [_mapped(x, change) if i == place else x for i, x in enumerate(value)]

    return changed


def _with_argument(right: Function, place: int, change: Change) -> Function:
    """Return a function that uses one of its arguments changed."""
    return lambda *given: right(*given[:place], change(given[place]), *given[place + 1 :])


def _with_component(right: Function, place: int, first: int) -> Function:
    """Return a function that finds one component of a vector from the other one's new value."""

    def answer(*given: Any) -> Any:
        value, before = plain(right(*given)), plain(vector(given[place]))
        if shape_of(value) != (2,) or shape_of(before) != (2,):
            raise ValueError("value and given must be vectors")
        before[first] = value[first]
        later = plain(right(*given[:place], vector(before), *given[place + 1 :]))
        later[first] = value[first]
        return later

    return answer


def _with_finite(right: Function, most: float) -> Function:
    """Return a function that takes a large number for infinity."""

    def finite(value: Any) -> Any:
        return most if shape_of(value) == () and value == math.inf else value

    return lambda *given: right(*map(finite, given))


def _with_both_one(right: Function, i: int, k: int) -> Function:
    """Return a function that takes 1 for two of its arguments, where they are numbers."""

    def answer(*given: Any) -> Any:
        if shape_of(given[i]) or shape_of(given[k]):
            raise ValueError("given must be a number for each of the two")
        return right(*(1.0 if place in (i, k) else value for place, value in enumerate(given)))

    return answer


def _with_argument_returned(right: Function, count: int, part: int, place: int) -> Function:
    """Return a function that gives back an argument as one of the parts of its answer."""

    def answer(*given: Any) -> Any:
        value = plain(right(*given))
        if value is None:
            return None
        if len(value) != count or shape_of(value[part]) != shape_of(given[place]):
            raise ValueError(f"value must have {count} parts like the argument, got {value}")
        return [*value[:part], given[place], *value[part + 1 :]]

    return answer


def _with_places(right: Function, places: dict[int, int]) -> Function:
    """Return a function that uses some of its arguments in the place of others."""
    return lambda *given: right(*(given[places.get(i, i)] for i in range(len(given))))

"""What the numbers of a call and of its answer tell: whether one is special, given, or new."""

from __future__ import annotations

import math
import zlib
from typing import Any

from lesson_code.course.grading.task import Arguments
from lesson_code.course.grading.tried import TriedCall
from lesson_code.course.isolation.inside.answers import plain


def signature(value: Any) -> float:
    """Return a number that is nearly the same for answers that agree.

    >>> abs(signature([1.0, None]) - signature([1.0 + 1e-12, None])) < 1e-11
    True
    """
    parts = _flat(value)
    return float(sum(part * math.cos(place) for place, part in enumerate(parts)))


def _flat(value: Any) -> list[float]:
    """Return numbers for all parts of a plain value."""
    if isinstance(value, list):
        return [number for item in value for number in _flat(item)]
    if isinstance(value, int | float):
        return [float(value)]
    return [zlib.crc32(repr(value).encode()) / 2**32]


def is_degenerate(arguments: Arguments) -> bool:
    """Return whether a call has a special case in it: 0, infinity, two equal vectors.

    >>> is_degenerate((1.0, (0.0, 0.0))), is_degenerate((math.inf,)), is_degenerate((1.0, 2.0))
    (True, True, False)
    """
    values = plain(list(arguments))
    vectors = [value for value in values if isinstance(value, list)]
    single = leaves([value for value in values if not isinstance(value, list)])
    return (
        any(number == 0 or math.isinf(number) for number in single)
        or any(not any(leaves(vector)) for vector in vectors)
        or any(a == b for i, a in enumerate(vectors) for b in vectors[:i])
    )


def holds_a_telling_number(call: TriedCall) -> bool:
    """Return whether a wrong answer holds a number that is neither given, expected nor whole."""
    return telling_numbers(call) > 0


def telling_numbers(call: TriedCall) -> int:
    """Return how many numbers of a wrong answer are neither given, expected nor whole.

    Where None was expected or came, a condition was wrong, and the numbers tell nothing of it.
    """
    if call.got is None or call.wanted is None:
        return 0
    return _others(call.got, [plain(list(call.arguments)), call.wanted])


def worked_out_numbers(call: TriedCall) -> int:
    """Return how many numbers of a wrong answer are neither given nor whole."""
    return _others(call.got, plain(list(call.arguments)))


def _others(value: Any, known: Any) -> int:
    """Return how many numbers of a value are not whole, and not among those that are known."""
    others = set(leaves(known))
    return sum(
        isinstance(number, float) and not number.is_integer() and number not in others
        for number in leaves(value)
    )


def leaves(value: Any) -> list[Any]:
    """Return all numbers of a plain value.

    >>> leaves([1.0, [2.0, None, "left"]])
    [1.0, 2.0]
    """
    if isinstance(value, list):
        return [number for item in value for number in leaves(item)]
    return [value] if isinstance(value, int | float) and not isinstance(value, bool) else []

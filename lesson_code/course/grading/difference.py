"""In words, how an answer differs from what was expected: what a reader would see at a glance.

Only what holds of the whole answer is said: another form, another sign, another order, a factor.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from typing import Any

from lesson_code.course.grading.compare import agrees

COUNTS = ("no", "one", "two", "three", "four", "five", "six")
FACTORS = {-1.0: "minus", 2.0: "twice", 0.5: "half of", -2.0: "minus twice", -0.5: "minus half of"}

PLACES = ("first", "second", "third", "fourth")

UNTELLING = {0.0, 1.0}
"""Numbers that stand in many answers: a normal turned by a right angle is not in another order."""

NAN = "nan is no number: it comes of 0/0, or of inf - inf."

ALMOST = 1e-4
"""Relative difference up to which an answer counts as right but for its last digits: a slip in a
formula changes more, four decimals and a float32 less."""


def of_form(got: Any, expected: Any, *, may_be_none: bool = False) -> str:
    """Return a sentence about how the form of two plain values differs, or nothing if it does not.

    Where other calls of the task are answered by None, as for circles that do not touch, None is
    no sign of a forgotten return.

    >>> of_form(None, [1.0, 2.0])
    'Two values were asked for; is a return missing?'
    >>> of_form([[1.0], 2.0], [1.0, 2.0])
    'There is a tuple where one number was asked for.'
    """
    if got is None and expected is not None:
        if may_be_none:
            return f"{_asked_for(expected)} here: None is right in other cases only."
        return f"{_asked_for(expected)}; is a return missing?"
    if expected is None:
        return "" if got is None else "There is nothing to return here: None was asked for."
    if isinstance(expected, list) != isinstance(got, list):
        return f"{_asked_for(expected)}."
    is_flat = isinstance(expected, list) and not any(isinstance(item, list) for item in expected)
    if is_flat and expected and _is_column(got):
        return f"{_asked_for(expected)}: one row, and yours is a column. np.ravel(...) helps."
    if isinstance(expected, list) and len(got) != len(expected):
        return f"{_asked_for(expected)}, and there {_are(len(got))}."
    return _of_form_inside(got, expected)


def _of_form_inside(got: Any, expected: Any) -> str:
    """Return such a sentence about the first of some values whose form differs, or nothing."""
    if not isinstance(expected, list):
        return ""
    for place, (mine, right) in enumerate(zip(got, expected, strict=True)):
        if said := of_form(mine, right):
            asked = _asked_for(right)
            if isinstance(mine, list) != isinstance(right, list) and mine is not None:
                there = "a tuple" if isinstance(mine, list) else "one value"
                return f"There is {there} where {asked[0].lower()}{asked[1:]}."
            if 1 < len(expected) <= len(PLACES):
                return f"In the {PLACES[place]}: {said[0].lower()}{said[1:]}"
            return said
    return ""


def kind_of(value: Any) -> str:
    """Return of what kind a plain value is at first sight, in a word."""
    if isinstance(value, list):
        return "list"
    return {type(None): "None", bool: "truth", str: "text"}.get(type(value), "number")


def of_given(got: Any, expected: Any, given: Mapping[str, Any]) -> str:
    """Return a sentence where an answer holds nothing but arguments as they came in, or nothing.

    >>> of_given([3.0, -1.5], [1.0, 2.0], {"m1": 2.0, "v1": 3.0, "m2": 5.0, "v2": -1.5})
    'That is v1 and v2 as they came in.'
    >>> of_given([3.0, 4.0], [-3.0, 4.0], {"velocity": [3.0, 4.0]})
    'That is velocity as it came in.'
    """
    if agrees(got, expected):
        return ""
    if whole := _name_of(got, given):
        return f"That is {whole} as it came in."
    if not isinstance(got, list) or len(got) > len(PLACES):
        return ""
    names = [_name_of(item, given) for item in got]
    if len(names) < 2 or not all(names) or len(set(names)) < len(names):
        return ""
    return f"That is {', '.join(names[:-1])} and {names[-1]} as they came in."


def _name_of(value: Any, given: Mapping[str, Any]) -> str:
    """Return the name of the only argument that is a value, if that tells anything."""
    if {abs(number) for number in _numbers(value) or ()} <= UNTELLING:
        return ""
    names = [name for name, argument in given.items() if agrees(value, argument)]
    return names[0] if len(names) == 1 else ""


def of_numbers(got: Any, expected: Any) -> str:
    """Return a sentence that holds of all numbers of two answers of the same form, or nothing.

    >>> of_numbers([3.0, -1.0], [-1.0, 3.0])
    'That is the right answer in another order.'
    """
    if _is_nan_in(got):
        return NAN
    mine, right = _numbers(got), _numbers(expected)
    if mine is None or right is None or len(mine) != len(right):
        return ""
    if any(math.isinf(number) for number in mine):
        return "inf is beyond all numbers: something was divided by zero."
    if not any(right) or not any(mine):
        return ""
    return (
        _of_a_factor(mine, right)
        or _of_one_part(got, expected)
        or _of_the_order(mine, right)
        or _of_digits(mine, right)
    )


def _of_a_factor(mine: list[float], right: list[float]) -> str:
    """Return in a sentence which factor lies between all numbers, or nothing."""
    for factor, words in FACTORS.items():
        if agrees(mine, [factor * number for number in right]):
            return f"That is {words} what was expected."
    return ""


def _of_one_part(got: Any, expected: Any) -> str:
    """Return in a sentence which one of several parts is wrong by a factor, or nothing."""
    if not isinstance(expected, list) or len(expected) < 2:
        return ""
    wrong = [k for k in range(len(expected)) if not agrees(got[k], expected[k])]
    if len(wrong) != 1 or wrong[0] >= len(PLACES):
        return ""
    mine, right = _numbers(got[wrong[0]]) or [], _numbers(expected[wrong[0]]) or []
    for factor, words in FACTORS.items():
        if any(right) and agrees(mine, [factor * number for number in right]):
            return f"The {PLACES[wrong[0]]} is {words} what was expected; all else is right."
    return ""


def _of_the_order(mine: list[float], right: list[float]) -> str:
    """Return in a sentence that two different numbers stand in each other's places, or nothing."""
    moved = [b for a, b in zip(mine, right, strict=True) if not agrees(a, b)]
    sizes = {round(abs(number), 9) for number in moved}
    if len(sizes) > 1 and sizes - UNTELLING and agrees(sorted(mine), sorted(right)):
        return "That is the right answer in another order."
    return ""


def _of_digits(mine: list[float], right: list[float]) -> str:
    """Return in a sentence that an answer is right to some digits only, or nothing."""
    errors = [abs(a - b) / max(1.0, abs(b)) for a, b in zip(mine, right, strict=True)]
    if max(errors) > ALMOST:
        return ""
    if all(map(_is_float32, mine)):
        return "That is right to the 7 digits of a float32. Use float64, which Python's float is."
    return f"That is right to {int(-math.log10(max(errors)))} digits. Is something rounded?"


def _is_float32(number: float) -> bool:
    """Return whether a number has no more digits than a float32 holds."""
    try:
        return struct.unpack("f", struct.pack("f", number)) == (number,)
    except OverflowError:
        return False


def _is_column(value: Any) -> bool:
    """Return whether a plain value is a list of lists of one number each."""
    return (
        isinstance(value, list)
        and len(value) > 1
        and all(isinstance(item, list) and len(item) == 1 for item in value)
    )


def _is_nan_in(value: Any) -> bool:
    """Return whether nan is among the numbers of a plain value."""
    if isinstance(value, list):
        return any(map(_is_nan_in, value))
    return isinstance(value, float) and math.isnan(value)


def _numbers(value: Any) -> list[float] | None:
    """Return all numbers of a plain value in their order; None where something else is in it."""
    if isinstance(value, list):
        parts = [_numbers(item) for item in value]
        return None if None in parts else [number for part in parts for number in part or []]
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return [float(value)]


def _asked_for(expected: Any) -> str:
    """Return how many values were asked for."""
    if not isinstance(expected, list):
        kind = {bool: "True or False", str: "A text"}.get(type(expected), "One number")
        return f"{kind} was asked for"
    values = f"{_count(len(expected))} value{'s' if len(expected) != 1 else ''}"
    return f"{values[:1].upper()}{values[1:]} {'was' if len(expected) == 1 else 'were'} asked for"


def _are(number: int) -> str:
    """Return how many there are."""
    return f"{'is' if number == 1 else 'are'} {_count(number) if number else 'none'}"


def _count(number: int) -> str:
    """Return a small number in words."""
    return COUNTS[number] if number < len(COUNTS) else str(number)

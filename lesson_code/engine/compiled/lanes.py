"""Lanes: one line of source for one visit in plain Python, and for four at once in machine code.

A processor can add four pairs of numbers by one instruction. A loop over :func:`in_lanes` says that
its turns have nothing to do with one another. In plain Python it takes them one by one; compiled,
four at a time: a number of a row is then four numbers, one of each of four rows
(``lane_types.py``). Each lane gets the bits that it would get on its own.

Four visits cannot take different branches. In what such a loop calls, a choice between numbers is
made by :func:`where`, `min`, `max` or `clamp`, and :func:`everywhere` asks all four.
"""

from __future__ import annotations

from typing import TypeVar

Value = TypeVar("Value")

LANES = 4
"""Visits at once: as many numbers of 64 bits as the instructions of most processors hold."""


def in_lanes(begin: int, end: int) -> range:
    """Return the numbers from begin to end, of which a compiled loop takes four at a time.

    There have to be a multiple of four.
    """
    return range(begin, end)


def where(condition: bool, one: Value, other: Value) -> Value:
    """Return one value where a condition holds, and the other where it does not; both are computed.

    >>> where(1 > 2, 0.5, 1.5)
    1.5
    """
    return one if condition else other


def everywhere(condition: bool) -> bool:
    """Return whether a condition holds in all lanes.

    A visit that ends there must be one that changes nothing: with other lanes it goes on.
    """
    return condition

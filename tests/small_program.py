"""A program that is compiled in half a second, and its tables."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from lesson_code.engine.compiled import Program, as_arrays, program_of


@dataclass(slots=True)
class Item:
    """A number of many."""

    value: float = 0.0


@dataclass(slots=True)
class Total:
    """What they add up to."""

    half: float = 0.0
    count: int = 0


class Numbers(NamedTuple):
    """A table, and a single row."""

    total: Total
    items: list[Item]


SOURCE = """from __future__ import annotations

SHARE = 0.5


def part(x: float) -> float:
    return SHARE * x


def entry(numbers: Numbers) -> float:
    total = numbers.total
    for i in range(len(numbers.items)):
        total.half += part(numbers.items[i].value)
        total.count += 1
    return total.half
"""
"""Half of all numbers are added up."""


def small_program(source: str = SOURCE) -> Program:
    """Return the program, perhaps of another source."""
    return program_of(source, "entry", Numbers)


def numbers(*values: float) -> Numbers:
    """Return its tables."""
    return as_arrays(Numbers(Total(), [Item(value) for value in values]), SOURCE)

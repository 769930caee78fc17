"""Unusual right answers to chapter 02: restitution."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Number: TypeAlias = Any


@alternative("2.1")
def both_signs_turned(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Separation and approach are both written the other way round."""
    return (v1_after - v2_after) / (v2 - v1)


@alternative("2.1")
def in_fractions(v1: float, v2: float, v1_after: float, v2_after: float) -> object:
    """Exact arithmetic; a Fraction comes back."""
    from fractions import Fraction

    before, after = Fraction(v1) - Fraction(v2), Fraction(v2_after) - Fraction(v1_after)
    return after / before


@alternative("2.2")
def with_reduced_mass(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """The impulse is (1 + e) times the reduced mass times the approach."""
    impulse = (1 + restitution) * (v1 - v2) * m1 * m2 / (m1 + m2)
    return v1 - impulse / m1, v2 + impulse / m2


@alternative("2.2")
def between_sticking_and_elastic(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> list[float]:
    """The answer lies the part e of the way from sticking to elastic."""
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return [(1 - restitution) * v + restitution * (2 * v - before) for before in (v1, v2)]


@alternative("2.3")
def step_by_step(height: float, restitution: float, count: int):  # type: ignore[no-untyped-def]
    import numpy as np

    heights = np.empty(int(count))
    for n in range(int(count)):
        speed_down = (2 * 9.81 * height) ** 0.5
        height = (restitution * speed_down) ** 2 / (2 * 9.81)
        heights[n] = height
    return heights


@alternative("2.4")
def as_a_long_sum(height: float, restitution: float, gravity: float) -> float:
    """Ten thousand flights are added up; the rest is below rounding."""
    fall = (2 * height / gravity) ** 0.5
    return float(fall + sum(2 * fall * restitution**n for n in range(1, 10_001)))


@alternative("2.2")
def as_the_textbook_has_it(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """One velocity from the momentum, the other one from the speed of separation."""
    u1 = (m1 * v1 + m2 * v2 - m2 * restitution * (v1 - v2)) / (m1 + m2)
    u2 = u1 + restitution * (v1 - v2)
    return u1, u2


@alternative("2.3")
def height_after_height(height: float, restitution: float, count: int) -> list[float]:
    """Each height is e^2 of the one before."""
    heights: list[float] = []
    while len(heights) < count:
        height = height * restitution**2
        heights.append(height)
    return heights


@alternative("2.4")
def flight_by_flight(height: Number, restitution: float, gravity: float) -> Number:
    """Flights are added until they are below rounding."""
    time = (2 * height / gravity) ** 0.5
    height = height * restitution**2
    while height > 1e-30:
        time = time + 2 * (2 * height / gravity) ** 0.5
        height = height * restitution**2
    return time

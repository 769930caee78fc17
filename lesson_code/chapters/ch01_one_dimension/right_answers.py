"""Unusual right answers to chapter 01: collisions on a line."""

from __future__ import annotations

from lesson_code.course.grading.task import alternative


@alternative("1.1")
def from_the_centre_of_mass(m1: float, v1: float, m2: float, v2: float) -> list[float]:
    """Each velocity is mirrored at the centre of mass; a list comes back."""
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return [2 * v - v1, 2 * v - v2]


@alternative("1.1")
def with_reduced_mass(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The impulse is twice the reduced mass times the approach."""
    impulse = 2 * (v1 - v2) / (1 / m1 + 1 / m2)
    return v1 - impulse / m1, v2 + impulse / m2


@alternative("1.1")
def as_a_linear_system(m1: float, v1: float, m2: float, v2: float):  # type: ignore[no-untyped-def]
    import numpy as np

    matrix = np.array([[m1, m2], [-1, 1]])
    return np.linalg.solve(matrix, [m1 * v1 + m2 * v2, v1 - v2])


@alternative("1.1")
def in_fractions(m1: float, v1: float, m2: float, v2: float) -> tuple[object, object]:
    """Exact arithmetic; two Fractions come back."""
    from fractions import Fraction

    a, b, x, y = (Fraction(number) for number in (m1, m2, v1, v2))
    return ((a - b) * x + 2 * b * y) / (a + b), ((b - a) * y + 2 * a * x) / (a + b)


@alternative("1.2")
def from_the_first_body(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The first body's velocity is corrected by the second's part of the difference."""
    v = v1 + m2 / (m1 + m2) * (v2 - v1)
    return v, v


@alternative("1.2")
def as_an_average(m1: float, v1: float, m2: float, v2: float):  # type: ignore[no-untyped-def]
    import numpy as np

    return np.full(2, np.average([v1, v2], weights=[m1, m2]))


@alternative("1.3")
def from_the_velocity_change(m1: float, v1: float, m2: float, v2: float) -> float:
    """The impulse is what the second body's momentum gains."""
    v2_after = ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)
    return m2 * (v2_after - v2)

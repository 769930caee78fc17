"""Unusual right answers to dominoes."""

from __future__ import annotations

import cmath
import math
from itertools import pairwise
from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("D.1")
def phase_of_the_diagonal(width: float, height: float) -> float:
    """The angle of the complex number height + i width."""
    return cmath.phase(complex(height, width))


@alternative("D.2")
def through_the_tipping_angle(width: float, height: float) -> float:
    """With half the diagonal d and the tipping angle a: w^2 = (3/2) g (1 - cos a) / d."""
    d = math.hypot(width, height) / 2
    angle = math.atan2(width, height)
    # 1 - cos a, written so that a small angle loses no digits
    return math.sqrt(1.5 * 9.81 * 2 * math.sin(angle / 2) ** 2 / d)


@alternative("D.3")
def as_a_list_of_pairs(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """Each domino is a pair; the clamp comes as min, the touch as an average of two."""
    row = [[float(a), float(r)] for a, r in zip(angles, rates, strict=True)]
    for _ in range(int(steps)):
        for domino in row:
            domino[1] += 1.5 * 9.81 / height * math.sin(domino[0]) * dt
            domino[0] += domino[1] * dt
        for one, following in pairwise(row):
            if height * math.sin(min(one[0], math.pi / 2)) > spacing and one[1] > following[1]:
                one[1] = following[1] = 0.5 * (one[1] + following[1])
        row = [[a, r] if a <= math.pi / 2 else [math.pi / 2, 0] for a, r in row]
    return [a for a, _ in row], [r for _, r in row]

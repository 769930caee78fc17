"""Unusual right answers to Breakout."""

from __future__ import annotations

import cmath
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.breakout.rules import STEEPEST, brick_impact
from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("K.1")
def as_a_complex_number(offset: float, speed: float) -> Any:
    """A quarter turn less the paddle's angle, as a complex number."""
    return 1j * cmath.rect(speed, -STEEPEST * sorted((-1, offset, 1))[1])


@alternative("K.2")
def by_safe_steps(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """Sphere tracing: the distance to the brick is always a safe way to go."""
    speed = np.hypot(*velocity)
    if speed == 0:
        return None
    time = 0.0
    for _ in range(2000):
        centre = position + velocity * time
        away = centre - np.clip(centre, box[:2], box[:2] + box[2:])
        distance = np.hypot(*away)
        gap = distance - radius
        closing = -np.dot(away, velocity) / distance
        if gap <= 1e-13 * max(1.0, speed):
            return (time, away / distance) if closing > 0 and time <= 1 else None
        if time > 1:
            return None
        # Along the line to the nearest point the gap closes by no more than this speed.
        time += gap / (closing if closing > 0.999999 * speed else speed)
    return (time, away / distance)


@alternative("K.3")
def by_recursion(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """A flight is the way to the first brick, and a flight among those that are left."""

    def onward(p: Vector, v: Vector, left: float, standing: tuple[int, ...]) -> Any:
        hits = {k: brick_impact(p, v, radius, bricks[k]) for k in standing}
        met = {k: hit for k, hit in hits.items() if hit is not None and hit[0] <= left}
        if not met:
            return p + left * v, v, ()
        k = min(met, key=lambda name: met[name][0])
        time, n = met[k][0], np.array(met[k][1])
        mirror = np.eye(2) - 2 * np.outer(n, n)
        rest = tuple(name for name in standing if name != k)
        end, after, broken = onward(p + time * v, mirror @ v, left - time, rest)
        return end, after, (k, *broken)

    return onward(position, velocity, duration, tuple(range(len(bricks))))

"""Wrong models of chapter 07, tasks 7.4 and 7.5: from event to event.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import WrongModel, marked, wrong_model

Vector: TypeAlias = Any


@wrong_model("7.4", "A snail is near, a bullet is far. Which of them arrives first?")
def the_nearest_pair(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """The pair with the smallest gap meets first."""
    found = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (
                positions[j] - positions[i],
                velocities[j] - velocities[i],
                radii[i] + radii[j],
            )
            a, b, c = v @ v, d @ v, d @ d - r * r
            if b < 0 <= b * b - a * c:
                t = max(c, 0.0) / (-b + math.sqrt(b * b - a * c))
                found.append((np.hypot(*d) - radii[i] - radii[j], t, i, j))
    return min(found)[1:] if found else None


@wrong_model("7.4", "You stop at the first pair that meets. Is there one that meets before it?")
def the_first_pair_found(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """The first pair that will meet is the one that meets first."""
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (
                positions[j] - positions[i],
                velocities[j] - velocities[i],
                radii[i] + radii[j],
            )
            a, b, c = v @ v, d @ v, d @ d - r * r
            if b < 0 <= b * b - a * c:
                return max(c, 0.0) / (-b + math.sqrt(b * b - a * c)), i, j
    return None


@wrong_model("7.4", "Is your event the next one, or the last one?")
def the_last_event(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """Of all times the largest one is the next."""
    found = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (
                positions[j] - positions[i],
                velocities[j] - velocities[i],
                radii[i] + radii[j],
            )
            a, b, c = v @ v, d @ v, d @ d - r * r
            if b < 0 <= b * b - a * c:
                found.append((max(c, 0.0) / (-b + math.sqrt(b * b - a * c)), i, j))
    return max(found, default=None)


@wrong_model("7.4", "Can number 0 meet number 2, before either of them meets number 1?")
def only_neighbours(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """A circle meets the next one in the list."""
    found = []
    for i in range(len(radii) - 1):
        d, v = positions[i + 1] - positions[i], velocities[i + 1] - velocities[i]
        a, b, c = v @ v, d @ v, d @ d - (radii[i] + radii[i + 1]) ** 2
        if b < 0 <= b * b - a * c:
            found.append((max(c, 0.0) / (-b + math.sqrt(b * b - a * c)), i, i + 1))
    return min(found, default=None)


@wrong_model("7.4", "Two circles meet at the time 0.0. What does Python make of `if 0.0:`?")
def now_is_no_time(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """`if t` asks whether two circles meet."""
    found = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (
                positions[j] - positions[i],
                velocities[j] - velocities[i],
                radii[i] + radii[j],
            )
            a, b, c = v @ v, d @ v, d @ d - r * r
            t = None
            if b < 0 <= b * b - a * c:
                t = max(c, 0.0) / (-b + math.sqrt(b * b - a * c))
            if t:
                found.append((t, i, j))
    return min(found, default=None)


@wrong_model("7.4", "One of your times is negative. Has that pair still to meet?")
def meetings_of_the_past(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """The smallest root of all is the next event."""
    found = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (
                positions[j] - positions[i],
                velocities[j] - velocities[i],
                radii[i] + radii[j],
            )
            a, b, c = v @ v, d @ v, d @ d - r * r
            if a > 0 and b * b - a * c >= 0:
                found.append(((-b - math.sqrt(b * b - a * c)) / a, i, j))
    return min(found, default=None)


@wrong_model("7.4", "Which number has the first circle of a list in Python?")
def numbered_from_one(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """The first circle is number 1."""
    found = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (
                positions[j] - positions[i],
                velocities[j] - velocities[i],
                radii[i] + radii[j],
            )
            a, b, c = v @ v, d @ v, d @ d - r * r
            if b < 0 <= b * b - a * c:
                found.append((max(c, 0.0) / (-b + math.sqrt(b * b - a * c)), i + 1, j + 1))
    return min(found, default=None)


@wrong_model("7.5", "Is it pi for every mass ratio? Count by hand for a ratio of 2.")
def digits_of_pi(mass_ratio: float) -> int:
    """The count is pi times the square root of the ratio, rounded down."""
    return int(math.pi * math.sqrt(mass_ratio))


@wrong_model("7.5", "The light block has hit the wall. Did you count that?")
def walls_not_counted(mass_ratio: float) -> int:
    """A collision takes two blocks."""
    light, heavy, count = 0.0, -1.0, 0
    while light > heavy:
        centre = (light + mass_ratio * heavy) / (1 + mass_ratio)
        light, heavy, count = abs(2 * centre - light), 2 * centre - heavy, count + 1
    return count


@wrong_model("7.5", "The heavy block has turned round. Can the light one still catch up with it?")
def until_the_heavy_block_turns(mass_ratio: float) -> int:
    """When the heavy block moves away, all is over."""
    light, heavy, count = 0.0, -1.0, 0
    while heavy < 0:
        centre = (light + mass_ratio * heavy) / (1 + mass_ratio)
        light, heavy, count = 2 * centre - light, 2 * centre - heavy, count + 1
        if light < 0:
            light, count = -light, count + 1
    return count


@wrong_model("7.5", "Which of the blocks stands at the wall, the heavy one or the light one?")
def heavy_block_at_the_wall(mass_ratio: float) -> int:
    """The block that comes is the light one."""
    inner, outer, count = 0.0, -1.0, 0
    while inner > outer:
        centre = (mass_ratio * inner + outer) / (mass_ratio + 1)
        inner, outer, count = 2 * centre - inner, 2 * centre - outer, count + 1
        if inner < 0:
            inner, count = -inner, count + 1
    return count


@wrong_model("7.5", "Only equal masses exchange their velocities. What does the mass ratio do?")
def exchanges_velocities(mass_ratio: float) -> int:
    """In an elastic collision the blocks exchange their velocities."""
    light, heavy, count = 0.0, -1.0, 0
    while light > heavy:
        light, heavy, count = heavy, light, count + 1
        if light < 0:
            light, count = -light, count + 1
    return count


@wrong_model("7.5", "How many collisions can there be between two looks? How many do you count?")
def steps_in_time(mass_ratio: float) -> int:
    """One looks sixty times in a second, and counts what has met."""
    x1, x2, v1, v2, count = 1.0, 2.0, 0.0, -1.0, 0
    for _ in range(1200):
        x1, x2 = x1 + v1 / 60, x2 + v2 / 60
        if x2 <= x1 and v2 < v1:
            centre = (v1 + mass_ratio * v2) / (1 + mass_ratio)
            v1, v2, count = 2 * centre - v1, 2 * centre - v2, count + 1
        if x1 <= 0 and v1 < 0:
            v1, count = -v1, count + 1
    return count


WRONG_MODELS = marked(globals(), WrongModel)

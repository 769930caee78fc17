"""Tasks of chapter 04: two circles that touch, found, resolved and separated."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.course.isolation.inside.vectors import vector
from lesson_code.formulas.smooth_pair import separating_push, smooth_impulse

DIAGONAL = (math.sqrt(0.5), -math.sqrt(0.5))
"""The direction in which two boxes still overlap when the circles in them do not."""

CLOSE = 2.0**-10
"""m: a gap or an overlap of a thousandth, without rounding: the circles barely miss or meet."""

NEARLY = 2.0**-20
"""m: a millionth, without rounding; between centres so near there is a direction still."""


# 4.1: who touches whom


def overlapping(stream: Random) -> Iterator[Arguments]:
    """Draw circles of unequal radii that overlap, one centre obliquely beside the other."""
    for _ in range(3):
        yield _circles(stream, draws.oblique_normal(stream), stream.uniform(0.8, 0.9))


def near_each_other(stream: Random) -> Iterator[Arguments]:
    """Draw circles that miss each other although their boxes overlap, and some that meet.

    Two small ones meet as well: of a distance below 1 m the square is less than the distance. And
    two meet whose distance lies between the larger radius and the root of r1^2 + r2^2, and two
    whose distance is more than 1 m, but its square less than r1 + r2.
    """
    yield _circles(stream, DIAGONAL, stream.uniform(1.1, 1.3))
    yield _circles(stream, DIAGONAL, stream.uniform(0.8, 0.9))
    (x1, y1), r1, (x2, y2), r2 = _circles(stream, DIAGONAL, stream.uniform(0.8, 0.9))
    yield (x1 / 5, y1 / 5), r1 / 5, (x2 / 5, y2 / 5), r2 / 5
    p1, (r1, r2) = draws.position(stream), draws.unequal_radii(stream)
    yield p1, r1, draws.at_distance(p1, (max(r1, r2) + math.hypot(r1, r2)) / 2, DIAGONAL), r2
    p1, (r1, r2) = draws.position(stream), draws.unequal_radii(stream)
    yield p1, r1, draws.at_distance(p1, stream.uniform(1.1, 1.3), DIAGONAL), r2


def just_touching(stream: Random) -> Iterator[Arguments]:
    """Draw circles exactly in touch, just apart and just overlapping; no number is rounded."""
    for gap in (0.0, CLOSE, -CLOSE):
        (x, y), size = _eighths(stream), stream.randrange(2, 9) / 8
        r1 = size * stream.choice((1.5, 3.5))
        yield (x, y), r1, (x + 3 * size, y - 4 * size), 5 * size - r1 - gap


def on_the_same_centre(stream: Random) -> Iterator[Arguments]:
    """Draw circles whose centres coincide, nearly do, and lie one above the other."""
    for apart in (0.0, NEARLY):
        (x, y), (r1, r2) = _eighths(stream), draws.unequal_radii(stream)
        yield (x, y), r1, (x - 3 * apart, y + 4 * apart), r2
    (x, y), (r1, r2) = _eighths(stream), draws.unequal_radii(stream)
    yield (x, y), r1, (x, y + stream.uniform(0.8, 0.9) * (r1 + r2)), r2


def _circles(stream: Random, direction: draws.Vector, part: float) -> Arguments:
    """Return p1, r1, p2, r2 of circles whose centres are `part` of r1 + r2 apart."""
    p1, (r1, r2) = draws.position(stream), draws.unequal_radii(stream)
    return p1, r1, draws.at_distance(p1, part * (r1 + r2), direction), r2


def _eighths(stream: Random) -> draws.Vector:
    """Return a position in whole eighths of a metre, which are exact as floats."""
    return stream.randrange(-40, 40) / 8, stream.randrange(-40, 40) / 8


# 4.2: the impulse


def approaching(stream: Random) -> Iterator[Arguments]:
    """Draw unequal circles that hit each other obliquely, both moving, with some loss.

    The first catches up with the second, the second with the first, and the last two meet slowly.
    """
    for pair in (draws.first_overtakes, draws.second_overtakes, draws.creeping_pair):
        yield _hit(stream, pair, draws.restitution(stream))


def separating(stream: Random) -> Iterator[Arguments]:
    """Draw circles that already move apart, fast and slowly."""
    for how_fast in (draws.speed, draws.creep):
        pair = partial(draws.separating_pair, how_fast=how_fast)
        yield _hit(stream, pair, draws.restitution(stream))


def without_loss(stream: Random) -> Iterator[Arguments]:
    """Draw hits with restitution 1 and 0; in the second one circle catches up with the other."""
    yield _hit(stream, draws.approaching_pair, 1.0)
    yield _hit(stream, draws.first_overtakes, 0.0)


def _hit(
    stream: Random, pair: Callable[[Random, draws.Vector], Any], restitution: float
) -> Arguments:
    """Return v1, m1, v2, m2, normal and restitution of an oblique hit."""
    normal, (m1, m2) = draws.oblique_normal(stream), draws.unequal_masses(stream)
    v1, v2 = pair(stream, normal)
    return v1, m1, v2, m2, normal, restitution


# 4.3: the way apart


def of_equal_masses(stream: Random) -> Iterator[Arguments]:
    """Draw overlapping circles of the same mass."""
    mass = draws.unequal_masses(stream)[0]
    yield _overlap(stream, mass, mass)


def of_unequal_masses(stream: Random) -> Iterator[Arguments]:
    """Draw overlapping circles, the first heavier in one pair, the second in the other."""
    for order in (1, -1):
        m1, m2 = sorted(draws.unequal_masses(stream))[::order]
        yield _overlap(stream, m1, m2)


def one_fixed(stream: Random) -> Iterator[Arguments]:
    """Draw overlapping circles of which the first, or the second, is fixed."""
    for order in (1, -1):
        m1, m2 = (math.inf, draws.unequal_masses(stream)[0])[::order]
        yield _overlap(stream, m1, m2)


def _overlap(stream: Random, m1: float, m2: float) -> Arguments:
    """Return p1, m1, p2, m2, normal and depth of an overlap."""
    normal = draws.oblique_normal(stream)
    p1 = draws.position(stream)
    return p1, m1, draws.at_distance(p1, 2.0, normal), m2, normal, draws.depth(stream)


# 4.4: both together


def overlapping_and_approaching(stream: Random) -> Iterator[Arguments]:
    """Draw circles that overlap and move into each other; either catches up with the other."""
    for pair in (draws.first_overtakes, draws.second_overtakes, draws.creeping_pair):
        yield _pair(stream, draws.unequal_masses(stream), pair)


def overlapping_but_separating(stream: Random) -> Iterator[Arguments]:
    """Draw circles that overlap and are already on their way apart, fast and slowly."""
    for how_fast in (draws.speed, draws.creep):
        pair = partial(draws.separating_pair, how_fast=how_fast)
        yield _pair(stream, draws.unequal_masses(stream), pair)


def against_a_fixed_one(stream: Random) -> Iterator[Arguments]:
    """Draw circles that move into a fixed one at rest, and one that is left by it."""
    for order in (1, -1):
        masses = (math.inf, draws.unequal_masses(stream)[0])[::order]
        yield _pair(stream, masses, draws.approaching_pair)


def _pair(
    stream: Random,
    masses: tuple[float, ...],
    velocities: Callable[[Random, draws.Vector], tuple[draws.Vector, draws.Vector]],
) -> Arguments:
    """Return p1, v1, m1, p2, v2, m2, normal, depth and restitution; a fixed circle is at rest."""
    p1, m1, p2, m2, normal, depth = _overlap(stream, *masses)
    v1, v2 = velocities(stream, normal)
    rest = v1 if math.isinf(m1) else v2 if math.isinf(m2) else (0.0, 0.0)
    v1, v2 = _minus(v1, rest), _minus(v2, rest)
    return p1, v1, m1, p2, v2, m2, normal, depth, draws.restitution(stream)


def _minus(a: draws.Vector, b: draws.Vector) -> draws.Vector:
    """Return the difference of two vectors."""
    return a[0] - b[0], a[1] - b[1]


# What is expected


def _circle_contact(p1: Any, r1: float, p2: Any, r2: float) -> tuple[Any, float] | None:
    """Return normal and depth of two circles, or None if they do not overlap."""
    distance = float(np.hypot(*(p2 - p1)))
    if not distance < r1 + r2:
        return None
    normal = (p2 - p1) / distance if distance > 0 else (1.0, 0.0)
    return normal, r1 + r2 - distance


def _resolve_circles(
    v1: Any, m1: float, v2: Any, m2: float, normal: Any, restitution: float
) -> tuple[Any, Any]:
    """Return both velocities after the impulse along the normal."""
    impulse = smooth_impulse(v1, m1, v2, m2, normal, restitution)
    return v1 - impulse / m1, v2 + impulse / m2


def _separate(p1: Any, m1: float, p2: Any, m2: float, normal: Any, depth: float) -> tuple[Any, Any]:
    """Return both positions after the circles were moved apart, the lighter one further."""
    push = separating_push(m1, m2, normal, depth)
    return p1 - push / m1, p2 + push / m2


def _resolve_overlap(
    p1: Any,
    v1: Any,
    m1: float,
    p2: Any,
    v2: Any,
    m2: float,
    normal: Any,
    depth: float,
    restitution: float,
) -> tuple[Any, ...]:
    """Return p1', v1', p2', v2' after the circles were moved apart and, if need be, bounced."""
    p1, p2 = _separate(p1, m1, p2, m2, normal, depth)
    v1, v2 = _resolve_circles(v1, m1, v2, m2, normal, restitution)
    return p1, v1, p2, v2


# Why


def distance_and_reach(arguments: Arguments, answer: Any) -> str:
    """Say how far the centres are apart, how far the radii reach, and how long the normal is."""
    p1, r1, p2, r2 = arguments
    says = f"The centres are {written(math.dist(p1, p2))} m apart; r1 + r2 is {written(r1 + r2)} m."
    if answer is None:
        return says
    normal, _ = answer
    return f"{says} The length of your normal is {written(math.hypot(*normal))}."


def momentum_and_speed_along_normal(arguments: Arguments, answer: Any) -> str:
    """Say what the momentum and the relative velocity were, and what the answer makes of them."""
    v1, m1, v2, m2, normal, _ = arguments
    w1, w2 = answer
    before, after = (
        tuple(m1 * a + m2 * b for a, b in zip(*pair, strict=True)) for pair in ((v1, v2), (w1, w2))
    )
    momentum = f"Momentum {written(before)} before, {written(after)} after yours"
    if written(after) == written(before):
        momentum = f"Momentum stays {written(before)}, as it should"
    return (
        f"{momentum}; (v2 - v1) . n "
        f"{_relative(v1, v2, normal)} before, {_relative(w1, w2, normal)} after."
    )


def way_apart(arguments: Arguments, answer: Any) -> str:
    """Say how far the answer moves each circle along the normal."""
    p1, m1, p2, m2, normal, depth = arguments
    q1, q2 = answer
    return (
        f"They overlap by {written(depth)} m. Along the normal you move the first"
        f" ({written(m1)} kg) by {_relative(p1, q1, normal)} m and the second"
        f" ({written(m2)} kg) by {_relative(p2, q2, normal)} m."
    )


def positions_and_velocities(arguments: Arguments, answer: Any) -> str:
    """Say how far the answer moves the circles, and what it does to their relative velocity."""
    p1, v1, m1, p2, v2, m2, normal, depth, _ = arguments
    q1, w1, q2, w2 = answer
    return (
        f"{way_apart((p1, m1, p2, m2, normal, depth), (q1, q2))} (v2 - v1) . n "
        f"{_relative(v1, v2, normal)} before, {_relative(w1, w2, normal)} after yours."
    )


def _relative(a: Any, b: Any, normal: Any) -> str:
    """Return how far b - a reaches along the normal, written."""
    return written(float((vector(b) - vector(a)) @ vector(normal)))


TASKS = (
    Task(
        id="4.1",
        function="circle_contact",
        section=1,
        objective="Whether two circles overlap, in which direction and how deep.",
        expected=_circle_contact,
        criteria=(
            Criterion("overlapping circles", overlapping, points=2),
            Criterion("circles that miss each other, and two that meet", near_each_other),
            Criterion("touching is not overlapping", just_touching),
            Criterion("the same centre", on_the_same_centre),
        ),
        explain=distance_and_reach,
    ),
    Task(
        id="4.2",
        function="resolve_circles",
        section=3,
        objective="The velocities of two circles after an impulse along their normal.",
        expected=_resolve_circles,
        criteria=(
            Criterion("oblique hits of unequal masses", approaching, points=2),
            Criterion("circles that already separate", separating),
            Criterion("the limits e = 1 and e = 0", without_loss),
        ),
        explain=momentum_and_speed_along_normal,
    ),
    Task(
        id="4.3",
        function="separate",
        section=5,
        objective="The positions of two overlapping circles after they were moved apart.",
        expected=_separate,
        criteria=(
            Criterion("equal masses", of_equal_masses),
            Criterion("unequal masses", of_unequal_masses, points=2),
            Criterion("a fixed circle", one_fixed),
        ),
        explain=way_apart,
    ),
    Task(
        id="4.4",
        function="resolve_overlap",
        section=5,
        objective="Separate first: positions and velocities of two circles that overlap.",
        expected=_resolve_overlap,
        criteria=(
            Criterion("circles that approach", overlapping_and_approaching, points=2),
            Criterion("circles that already separate", overlapping_but_separating),
            Criterion("a fixed circle", against_a_fixed_one),
        ),
        explain=positions_and_velocities,
    ),
)

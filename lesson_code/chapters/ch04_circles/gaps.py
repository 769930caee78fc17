"""What the reader of notebook 04 writes: the test, the impulse, and the ways apart."""

from __future__ import annotations

from random import Random
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


def do_overlap(d: Vector, r1: float, r2: float) -> bool:
    """Return whether two discs overlap whose centres lie d apart."""
    return bool(np.dot(d, d) < (r1 + r2) ** 2)


@wrong_model("04-overlap", "You squared the distance. What else has to be squared?")
def only_one_side_squared(d: Vector, r1: float, r2: float) -> bool:
    """The squared distance is compared with the radii."""
    return bool(np.dot(d, d) < r1 + r2)


@wrong_model("04-overlap", "Two discs touch. Is the distance of their centres r1² + r2², squared?")
def radii_squared_apart(d: Vector, r1: float, r2: float) -> bool:
    """The square of a sum is the sum of the squares."""
    return bool(np.dot(d, d) < r1**2 + r2**2)


@wrong_model("04-overlap", "Your answer is true for discs that are far apart. Which is smaller?")
def far_apart(d: Vector, r1: float, r2: float) -> bool:
    """Discs overlap if their centres are farther apart than the radii reach."""
    return bool(np.dot(d, d) > (r1 + r2) ** 2)


def impulse_along_n(vn: float, m1: float, m2: float, e: float) -> float:
    """Return the impulse j along the normal on disc 2, N s, of discs that approach."""
    return -(1 + e) * vn / (1 / m1 + 1 / m2)


@wrong_model("04-impulse", "Set e = 1 and compare the energy before and after. Should it grow?")
def doubled(vn: float, m1: float, m2: float, e: float) -> float:
    """Both discs get an impulse, so it counts twice."""
    return -2 * (1 + e) * vn / (1 / m1 + 1 / m2)


@wrong_model("04-impulse", "Both discs give way. Is their joint resistance more than one mass?")
def adds_masses(vn: float, m1: float, m2: float, e: float) -> float:
    """The masses of both discs resist together, so they add."""
    return -(1 + e) * vn * (m1 + m2)


@wrong_model("04-impulse", "vn is negative. Which way does your impulse push disc 2?")
def sign_lost(vn: float, m1: float, m2: float, e: float) -> float:
    """The impulse points the way in which the discs approach."""
    return (1 + e) * vn / (1 / m1 + 1 / m2)


@wrong_model("04-impulse", "With e = 0 yours is zero. What must stop all the same?")
def forgets_to_stop(vn: float, m1: float, m2: float, e: float) -> float:
    """The impulse gives back the part e of the approach."""
    return -e * vn / (1 / m1 + 1 / m2)


def ways_apart(depth: float, m1: float, m2: float) -> tuple[float, float]:
    """Return how far each disc moves, m, so that together they move by the depth."""
    return depth * m2 / (m1 + m2), depth * m1 / (m1 + m2)


@wrong_model("04-ways", "A marble overlaps a truck. Should the truck move as far as the marble?")
def half_each(depth: float, m1: float, m2: float) -> tuple[float, float]:
    """Both discs share the way."""
    return depth / 2, depth / 2


@wrong_model("04-ways", "In yours the heavier disc moves further. Which is easier to push aside?")
def in_proportion_to_mass(depth: float, m1: float, m2: float) -> tuple[float, float]:
    """The larger mass takes the larger part of the way."""
    return depth * m1 / (m1 + m2), depth * m2 / (m1 + m2)


@wrong_model("04-ways", "Add up your two ways. How far did the discs overlap?")
def the_whole_depth_each(depth: float, m1: float, m2: float) -> tuple[float, float]:
    """Each disc has to move out of the other."""
    return depth, depth


def two_masses(stream: Random) -> tuple[float, float]:
    """Draw a light and a heavy mass."""
    return round(stream.uniform(0.5, 2), 2), round(stream.uniform(3, 9), 2)


def two_discs(stream: Random) -> tuple[Any, ...]:
    """Draw two discs that are nearer or farther than their radii reach, as it falls."""
    r1, r2 = round(stream.uniform(0.5, 3), 2), round(stream.uniform(0.5, 3), 2)
    angle, reach = stream.uniform(0, 2 * np.pi), stream.uniform(0.3, 1.4) * (r1 + r2)
    return (reach * np.cos(angle), reach * np.sin(angle)), r1, r2


def an_approach(stream: Random) -> tuple[float, ...]:
    """Draw a speed of approach, masses and a restitution."""
    vn = round(stream.uniform(-6, -1), 2)
    return vn, *two_masses(stream), round(stream.uniform(0.2, 0.8), 2)


def an_overlap(stream: Random) -> tuple[float, ...]:
    """Draw a depth and masses."""
    return round(stream.uniform(0.1, 0.8), 2), *two_masses(stream)


GAPS = (
    Gap(
        id="04-overlap",
        ours=do_overlap,
        draw=two_discs,
        wrong_models=(only_one_side_squared, radii_squared_apart, far_apart),
    ),
    Gap(
        id="04-impulse",
        ours=impulse_along_n,
        draw=an_approach,
        wrong_models=(doubled, adds_masses, sign_lost, forgets_to_stop),
    ),
    Gap(
        id="04-ways",
        ours=ways_apart,
        draw=an_overlap,
        wrong_models=(half_each, in_proportion_to_mass, the_whole_depth_each),
    ),
)

"""What the reader of notebook 10 writes: the friction of a pair, and a bound on every speed."""

from __future__ import annotations

import math
from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def friction_of_pair(mu_a: float, mu_b: float) -> float:
    """Return the friction coefficient of a pair: the square root of the product."""
    return math.sqrt(mu_a * mu_b)


@wrong_model("10-pair", "A rough disc on ice: does your rule let it rub?")
def the_mean(mu_a: float, mu_b: float) -> float:
    """A pair's coefficient is the mean of the two."""
    return (mu_a + mu_b) / 2


@wrong_model("10-pair", "A rough disc on ice: whose surface decides in your rule?")
def the_larger(mu_a: float, mu_b: float) -> float:
    """The rougher surface decides."""
    return max(mu_a, mu_b)


@wrong_model("10-pair", "Two surfaces of 0.5 each: what should the pair have?")
def the_product(mu_a: float, mu_b: float) -> float:
    """A pair's coefficient is the product."""
    return mu_a * mu_b


def fastest(energy: float, lightest: float) -> float:
    """Return a speed that no body can pass, m/s, from the energy of all and the least mass."""
    return math.sqrt(2 * energy / lightest)


@wrong_model("10-fastest", "Which power of the speed is in the energy?")
def without_the_root(energy: float, lightest: float) -> float:
    """The speed is 2 E/m."""
    return 2 * energy / lightest


@wrong_model("10-fastest", "E = m v^2/2. What is v^2?")
def without_the_half(energy: float, lightest: float) -> float:
    """The energy is m v^2."""
    return math.sqrt(energy / lightest)


@wrong_model(
    "10-fastest", "With all of the energy, is a light body slower or faster than a heavy one?"
)
def mass_above_the_line(energy: float, lightest: float) -> float:
    """A larger mass makes a larger speed."""
    return math.sqrt(2 * energy * lightest)


def two_surfaces(stream: Random) -> tuple[float, ...]:
    """Draw two coefficients; one of some pairs is 0."""
    return round(stream.uniform(0.1, 1), 2), stream.choice((0.0, round(stream.uniform(0.1, 1), 2)))


def energy_and_mass(stream: Random) -> tuple[float, ...]:
    """Draw an energy, J, and a mass, kg."""
    return round(stream.uniform(1, 50), 1), round(stream.uniform(0.05, 4), 2)


GAPS = (
    Gap("10-pair", friction_of_pair, two_surfaces, (the_mean, the_larger, the_product)),
    Gap("10-fastest", fastest, energy_and_mass,
        (without_the_root, without_the_half, mass_above_the_line)),
)  # fmt: skip

"""What the reader of notebook 00 writes: a floor clamp, a direction, and who is in front."""

from __future__ import annotations

from random import Random
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


def onto_the_floor(y: float, radius: float) -> float:
    """Return the height of a ball's centre, m, raised where the ball would be below the floor."""
    return max(y, radius)


@wrong_model("00-clamp", "y is the height of the centre. How high is the lowest point of the ball?")
def centre_on_the_floor(y: float, radius: float) -> float:
    """The centre must not be below the floor."""
    return max(y, 0.0)


@wrong_model("00-clamp", "A ball high up in the air: where does yours put it?")
def always_on_the_floor(y: float, radius: float) -> float:
    """The ball is always set onto the floor."""
    return radius


@wrong_model(
    "00-clamp", "Which of the two heights is right for a ball that has sunk: the larger one?"
)
def smaller_one(y: float, radius: float) -> float:
    """The smaller of two heights is the safe one."""
    return min(y, radius)


def unit_vector(v: Vector) -> Vector:
    """Return a vector divided by its length."""
    return v / np.hypot(*v)


@wrong_model("00-direction", "The length of (3, 4) is 5. Is it 3 + 4?")
def divided_by_the_sum(v: Vector) -> Vector:
    """The length is the sum of the components."""
    return v / (v[0] + v[1])


@wrong_model("00-direction", "You divided by x² + y². What is still to be done to get a length?")
def divided_by_the_square(v: Vector) -> Vector:
    """The length is the sum of the squares."""
    return v / (v[0] ** 2 + v[1] ** 2)


@wrong_model("00-direction", "A length is a number. Which vector has this length divided out?")
def the_length(v: Vector) -> float:
    """To normalise is to find the length."""
    return float(np.hypot(*v))


def a_height(stream: Random) -> tuple[float, ...]:
    """Draw a height and a radius; half of the balls have sunk."""
    radius = round(stream.uniform(0.2, 1), 2)
    return round(radius + stream.uniform(-1.5, 1.5), 2), radius


def a_vector(stream: Random) -> tuple[Any, ...]:
    """Draw a vector with two different components."""
    return ((round(stream.uniform(1, 5), 2), round(stream.uniform(-9, -6), 2)),)


GAPS = (
    Gap(
        id="00-clamp",
        ours=onto_the_floor,
        draw=a_height,
        wrong_models=(centre_on_the_floor, always_on_the_floor, smaller_one),
    ),
    Gap(
        id="00-direction",
        ours=unit_vector,
        draw=a_vector,
        wrong_models=(divided_by_the_sum, divided_by_the_square, the_length),
    ),
)

"""What the reader of notebook 02 writes: the number e, and what it does to a dropped ball."""

from __future__ import annotations

from random import Random

from lesson_code.chapters.ch02_restitution import wrong_answers as wrong
from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model
from lesson_code.formulas import restitution_1d
from lesson_code.reference.closed_forms import rest_time


def height_after(height: float, e: float, bounces: int) -> float:
    """Return the height to which a dropped ball rises after some bounces, m."""
    return height * e ** (2 * bounces)


@wrong_model("02-height", "The speed shrinks by e at each bounce. How does height depend on speed?")
def speed_factor(height: float, e: float, bounces: int) -> float:
    """Heights shrink as speeds do."""
    return height * e**bounces


@wrong_model("02-height", "That is the first bounce. What does the second one start from?")
def one_bounce(height: float, e: float, bounces: int) -> float:
    """Every bounce reaches the same height."""
    return height * e**2


@wrong_model("02-height", "e² is the factor of one bounce. What do you do with it at the next one?")
def multiplied_by_the_count(height: float, e: float, bounces: int) -> float:
    """Three bounces do three times what one bounce does."""
    return height * e**2 * bounces


def four_velocities(stream: Random) -> tuple[float, ...]:
    """Draw velocities of two bodies before and after they meet."""
    v1, v2 = round(stream.uniform(2, 6), 2), round(stream.uniform(-3, 1), 2)
    v1_after = round(stream.uniform(-2, 0), 2)
    return v1, v2, v1_after, round(v1_after + stream.uniform(0.3, 0.8) * (v1 - v2), 2)


def a_drop(stream: Random) -> tuple[float, ...]:
    """Draw a height, a restitution and a number of bounces."""
    return (
        round(stream.uniform(0.5, 3), 2),
        round(stream.uniform(0.5, 0.9), 2),
        stream.choice((2, 3)),
    )


def a_drop_with_gravity(stream: Random) -> tuple[float, ...]:
    """Draw a height, a restitution and the gravity of some planet."""
    height, e, _ = a_drop(stream)
    return height, e, round(stream.uniform(1.6, 24.8), 2)


GAPS = (
    Gap(
        id="02-restitution",
        ours=restitution_1d,
        draw=four_velocities,
        wrong_models=(
            wrong.sign_lost,
            wrong.as_energy_ratio,
            wrong.first_body_only,
            wrong.upside_down,
        ),
    ),
    Gap(
        id="02-height",
        ours=height_after,
        draw=a_drop,
        wrong_models=(speed_factor, one_bounce, multiplied_by_the_count),
    ),
    Gap(
        id="02-rest",
        ours=rest_time,
        draw=a_drop_with_gravity,
        wrong_models=(
            wrong.first_fall_like_the_others,
            wrong.forgets_the_way_up,
            wrong.times_shrink_like_heights,
            wrong.ten_bounces,
        ),
    ),
)

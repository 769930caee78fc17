"""What the reader of notebook 11 writes: how many pairs there are, and which error to expect."""

from __future__ import annotations

from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def pairs_of(n: int) -> int:
    """Return how many pairs n bodies make."""
    return n * (n - 1) // 2


@wrong_model("11-pairs-of", "Three bodies make three pairs. What does your formula say?")
def ordered_pairs(n: int) -> int:
    """Each body meets every other one."""
    return n * (n - 1)


@wrong_model("11-pairs-of", "Does a body meet itself?")
def with_itself(n: int) -> int:
    """The pairs are half of a square table."""
    return n * (n + 1) // 2


@wrong_model("11-pairs-of", "A table of n by n: which of its entries are pairs, and how often?")
def the_whole_table(n: int) -> int:
    """There are as many pairs as entries in a table."""
    return n * n


def error_at(dt_2: float, dt_1: float, error_1: float) -> float:
    """Return the error at another step, for a method of the first order."""
    return error_1 * dt_2 / dt_1


@wrong_model("11-error-at", "A shorter step: does your error grow or fall?")
def the_other_way_round(dt_2: float, dt_1: float, error_1: float) -> float:
    """The error grows as the step falls."""
    return error_1 * dt_1 / dt_2


@wrong_model(
    "11-error-at", "First order: half the step leaves half the error. What does yours leave?"
)
def of_second_order(dt_2: float, dt_1: float, error_1: float) -> float:
    """The error falls with the square of the step."""
    return error_1 * (dt_2 / dt_1) ** 2


@wrong_model("11-error-at", "Is it the difference of the steps that counts, or their ratio?")
def by_the_difference(dt_2: float, dt_1: float, error_1: float) -> float:
    """The error falls by what the step falls."""
    return error_1 - (dt_1 - dt_2)


def bodies(stream: Random) -> tuple[int]:
    """Draw a number of bodies."""
    return (stream.randint(3, 60),)


def two_steps(stream: Random) -> tuple[float, ...]:
    """Draw a shorter step and a longer one with its error."""
    dt_1 = 1 / stream.choice((30, 60))
    return dt_1 / stream.choice((2, 4, 10)), dt_1, round(stream.uniform(0.1, 0.6), 2)


GAPS = (
    Gap("11-pairs-of", pairs_of, bodies, (ordered_pairs, with_itself, the_whole_table)),
    Gap("11-error-at", error_at, two_steps,
        (the_other_way_round, of_second_order, by_the_difference)),
)  # fmt: skip

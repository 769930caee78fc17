"""What the reader of notebook 06 writes: the way out of an interval, and what a sweep leaves."""

from __future__ import annotations

from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def shorter_way(low_a: float, high_a: float, low_b: float, high_b: float) -> float:
    """Return how far B must move to leave A, the shorter way; the two overlap."""
    return min(high_a - low_b, high_b - low_a)


@wrong_model("06-way-out", "B lies inside A. Move it by your answer: is it out?")
def the_shared_part(low_a: float, high_a: float, low_b: float, high_b: float) -> float:
    """The way out is as long as the part that both share."""
    return min(high_a, high_b) - max(low_a, low_b)


@wrong_model("06-way-out", "B hangs over A's low end. Does it have to climb over all of A?")
def always_upwards(low_a: float, high_a: float, low_b: float, high_b: float) -> float:
    """B leaves upwards."""
    return high_a - low_b


@wrong_model("06-way-out", "Both ways lead out. Which of them would you take?")
def the_longer_way(low_a: float, high_a: float, low_b: float, high_b: float) -> float:
    """The way out is the longer one."""
    return max(high_a - low_b, high_b - low_a)


def error_left(k11: float, k12: float, sweeps: int) -> float:
    """Return which part of an error some sweeps over two contacts leave."""
    return (k12 / k11) ** (2 * sweeps)


@wrong_model("06-error-left", "A sweep visits both contacts. How often is the error passed on?")
def once_a_sweep(k11: float, k12: float, sweeps: int) -> float:
    """The error shrinks by k12/k11 in a sweep."""
    return (k12 / k11) ** sweeps


@wrong_model("06-error-left", "Two sweeps: does the second shrink what the first has left?")
def a_share_for_each(k11: float, k12: float, sweeps: int) -> float:
    """The error shrinks by the same amount in every sweep."""
    return (k12 / k11) ** 2 / sweeps


@wrong_model("06-error-left", "If the contacts hardly feel each other, k12 is small. Is much left?")
def the_other_way_up(k11: float, k12: float, sweeps: int) -> float:
    """The larger k12, the less is left."""
    return (1 - abs(k12) / k11) ** (2 * sweeps)


def that_overlap(stream: Random) -> tuple[float, ...]:
    """Draw two intervals that overlap, from either side or one in the other."""
    low, length = round(stream.uniform(-5, 5), 1), round(stream.uniform(3, 8), 1)
    width = round(stream.uniform(0.5, 2.5), 1)
    start = round(stream.uniform(low - 0.4 * width, low + length - 0.6 * width), 1)
    return low, round(low + length, 1), start, round(start + width, 1)


def coupled(stream: Random) -> tuple[float, ...]:
    """Draw k11, k12 and a number of sweeps."""
    k11 = round(stream.uniform(1, 3), 2)
    return k11, round(k11 * stream.uniform(-0.8, 0.8), 2) or 0.1, stream.randint(2, 5)


GAPS = (
    Gap("06-way-out", shorter_way, that_overlap,
        (the_shared_part, always_upwards, the_longer_way)),
    Gap("06-error-left", error_left, coupled,
        (once_a_sweep, a_share_for_each, the_other_way_up)),
)  # fmt: skip

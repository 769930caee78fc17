"""What the reader of notebook 07 writes: who passes a wall, and when two circles meet."""

from __future__ import annotations

import math
from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def share_passing(v: float, dt: float, r: float, th: float) -> float:
    """Return which part of the balls passes a wall, 0 to 1."""
    return max(1 - (r + th / 2) / (v * dt), 0)


@wrong_model("07-passing", "A slow ball: can less than none of them pass?")
def below_zero_for_slow_balls(v: float, dt: float, r: float, th: float) -> float:
    """The formula holds for slow balls, too."""
    return 1 - (r + th / 2) / (v * dt)


@wrong_model("07-passing", "Behind the middle of the wall: which way out is the shorter one?")
def seen_in_all_of_the_wall(v: float, dt: float, r: float, th: float) -> float:
    """A ball is stopped anywhere in the wall."""
    return max(1 - (r + th) / (v * dt), 0)


@wrong_model("07-passing", "That is who is seen in time. And who is not?")
def those_that_are_stopped(v: float, dt: float, r: float, th: float) -> float:
    """The part is that of the places at which a ball is seen."""
    return min((r + th / 2) / (v * dt), 1)


@wrong_model("07-passing", "A ball is seen as soon as its rim is in the wall. Where is its centre?")
def a_ball_without_a_radius(v: float, dt: float, r: float, th: float) -> float:
    """The ball is a point."""
    return max(1 - th / 2 / (v * dt), 0)


def first_touch(a: float, b: float, c: float) -> float:
    """Return the smaller root of a t^2 + 2 b t + c, without a difference of near numbers."""
    return c / (-b + math.sqrt(b * b - a * c))


@wrong_model("07-first-touch", "Try b = -1, a = 1e-20, c = 1: which two numbers do you subtract?")
def with_a_difference(a: float, b: float, c: float) -> float:
    """The first form is as good as the second."""
    return (-b - math.sqrt(b * b - a * c)) / a


@wrong_model("07-first-touch", "Which of the two roots comes first, the smaller or the larger one?")
def the_other_root(a: float, b: float, c: float) -> float:
    """The root with the plus sign."""
    return (-b + math.sqrt(b * b - a * c)) / a


@wrong_model("07-first-touch", "The middle term is 2 b t here. Which b is in your formula?")
def with_four_times_ac(a: float, b: float, c: float) -> float:
    """The root is that of a t^2 + b t + c."""
    return 2 * c / (-b + math.sqrt(b * b - 4 * a * c))


def balls_at_a_wall(stream: Random) -> tuple[float, ...]:
    """Draw a speed, m/s, a step, s, a radius and a thickness, m; some balls are slow."""
    dt, r = 1 / stream.choice((30, 60, 120)), round(stream.uniform(0.05, 0.2), 2)
    th = round(stream.uniform(0.02, 0.2), 2)
    return round((r + th / 2) / dt * stream.choice((0.6, 0.8, 1.5, 2.5, 4.0)), 1), dt, r, th


def that_meet(stream: Random) -> tuple[float, ...]:
    """Draw a, b < 0 and c > 0 with a root; in some a is so small that digits are lost."""
    b, c = -round(stream.uniform(1, 5), 2), round(stream.uniform(0.1, 2), 2)
    part = stream.choice((0.05, 0.15, 0.2, 1e-14))
    return part * b * b / c, b, c


GAPS = (
    Gap("07-passing", share_passing, balls_at_a_wall,
        (below_zero_for_slow_balls, seen_in_all_of_the_wall, those_that_are_stopped,
         a_ball_without_a_radius)),
    Gap("07-first-touch", first_touch, that_meet,
        (with_a_difference, the_other_root, with_four_times_ac)),
)  # fmt: skip

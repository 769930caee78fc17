"""What the reader of notebook 08 writes: a solver, an order from two errors, a late impact."""

from __future__ import annotations

import math
from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def step(x: float, v: float, dt: float, low: float, high: float) -> tuple[float, float]:
    """Return place, m, and velocity, m/s, of a ball on a line after a step between two walls."""
    x = x + v * dt
    is_leaving = (x < low and v < 0) or (x > high and v > 0)
    return x, -v if is_leaving else v


@wrong_model("08-step", "A ball beyond the wall is on its way back in. Should it turn round again?")
def turns_whatever_its_way(
    x: float, v: float, dt: float, low: float, high: float
) -> tuple[float, float]:
    """A ball beyond a wall turns round."""
    x = x + v * dt
    return x, v if low <= x <= high else -v


@wrong_model("08-step", "Positive is to the right. Which sign has v on its way out at `low`?")
def turns_on_its_way_in(
    x: float, v: float, dt: float, low: float, high: float
) -> tuple[float, float]:
    """A ball that comes back from beyond a wall turns round."""
    x = x + v * dt
    is_coming = (x < low and v > 0) or (x > high and v < 0)
    return x, -v if is_coming else v


@wrong_model("08-step", "You moved the ball to the wall. By how far did it fly back in that step?")
def put_at_the_wall(x: float, v: float, dt: float, low: float, high: float) -> tuple[float, float]:
    """A ball beyond a wall is put on its surface."""
    x, v = step(x, v, dt, low, high)
    return min(max(x, low), high), v


@wrong_model(
    "08-step",
    "Your mirror is exact at a flat wall. What would it need to know of a ball that hits a ball? "
    "Leave x where it is, for now.",
)
def mirrored(x: float, v: float, dt: float, low: float, high: float) -> tuple[float, float]:
    """A ball beyond a wall is put as far in front of it."""
    x, v = step(x, v, dt, low, high)
    return (2 * low - x if x < low else 2 * high - x if x > high else x), v


def order_of(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """Return the order of a method from two steps and their errors."""
    return math.log(error_1 / error_2) / math.log(dt_1 / dt_2)


@wrong_model("08-order-of", "Halve the step. By which factor does an error of second order fall?")
def ratio_of_the_errors(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is by how many times the error falls."""
    return error_1 / error_2 / (dt_1 / dt_2)


@wrong_model("08-order-of", "Which of the two ratios stands below the line: errors, or steps?")
def upside_down(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is the logarithm of the steps over that of the errors."""
    return math.log(dt_1 / dt_2) / math.log(error_1 / error_2)


@wrong_model(
    "08-order-of", "A slope takes differences. Of the errors themselves, or of their logarithms?"
)
def slope_without_logarithms(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is the slope of the errors over the steps."""
    return (error_1 - error_2) / (dt_1 - dt_2)


def late_by(e: float, v: float, tau: float) -> float:
    """Return by how much a body is wrong after an impact that is seen late by tau, m."""
    return (1 + e) * v * tau


@wrong_model("08-late", "It is too deep when it is seen. And where should it be by then?")
def only_too_deep(e: float, v: float, tau: float) -> float:
    """The body is wrong by how deep it is."""
    return v * tau


@wrong_model("08-late", "With e = 0 the body stays at the wall. Is it wrong by nothing?")
def only_the_way_back(e: float, v: float, tau: float) -> float:
    """The body is wrong by the way that it should have gone back."""
    return e * v * tau


@wrong_model(
    "08-late", "With e = 1 your answer is 0. Is a ball that bounces late at the right place?"
)
def the_difference(e: float, v: float, tau: float) -> float:
    """The way in and the way back cancel in part."""
    return (1 - e) * v * tau


def flight(stream: Random) -> tuple[float, ...]:
    """Draw a place, m, a velocity, m/s, a step, s, and two walls, m.

    The ball flies free, out through a wall, or back in from beyond one.
    """
    low, high, speed = 0.25, round(stream.uniform(2, 4), 2), round(stream.uniform(1, 3), 2)
    out = (low + 0.02, -speed), (high - 0.02, speed)
    back = (low - 0.2, speed), (high + 0.2, -speed)
    x, v = stream.choice((*out, *back, (1.0, speed)))
    return x, v, 0.05, low, high


def two_runs(stream: Random) -> tuple[float, ...]:
    """Draw two steps, s, and errors, m, of some order."""
    dt_1, ratio = 1 / stream.choice((30, 60, 120)), stream.choice((2.0, 4.0, 8.0))
    error = round(stream.uniform(0.05, 0.5), 3)
    return dt_1, error, dt_1 / ratio, round(error / ratio ** stream.uniform(0.5, 2), 6)


def late_impact(stream: Random) -> tuple[float, ...]:
    """Draw a restitution, a speed, m/s, and a delay, s."""
    return round(stream.uniform(0.2, 0.8), 2), round(stream.uniform(1, 9), 1), 0.01


GAPS = (
    Gap("08-step", step, flight,
        (turns_whatever_its_way, turns_on_its_way_in, put_at_the_wall, mirrored)),
    Gap("08-order-of", order_of, two_runs,
        (ratio_of_the_errors, upside_down, slope_without_logarithms)),
    Gap("08-late", late_by, late_impact, (only_too_deep, only_the_way_back, the_difference)),
)  # fmt: skip

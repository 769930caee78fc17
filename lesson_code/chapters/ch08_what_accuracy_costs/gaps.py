"""What the reader of notebook 08 writes: an order from two errors, and what an impact costs."""

from __future__ import annotations

import math
from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


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


def two_runs(stream: Random) -> tuple[float, ...]:
    """Draw two steps, s, and errors, m, of some order."""
    dt_1, ratio = 1 / stream.choice((30, 60, 120)), stream.choice((2.0, 4.0, 8.0))
    error = round(stream.uniform(0.05, 0.5), 3)
    return dt_1, error, dt_1 / ratio, round(error / ratio ** stream.uniform(0.5, 2), 6)


def late_impact(stream: Random) -> tuple[float, ...]:
    """Draw a restitution, a speed, m/s, and a delay, s."""
    return round(stream.uniform(0.2, 0.8), 2), round(stream.uniform(1, 9), 1), 0.01


GAPS = (
    Gap("08-order-of", order_of, two_runs,
        (ratio_of_the_errors, upside_down, slope_without_logarithms)),
    Gap("08-late", late_by, late_impact, (only_too_deep, only_the_way_back, the_difference)),
)  # fmt: skip

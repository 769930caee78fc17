"""Wrong models of chapter 08: norms, and orders of convergence.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


@wrong_model("8.1", "Your ball is 3 m off for one moment, and right at the end. Is that no error?")
def only_at_the_end(places: Vector, right: Vector) -> float:
    """What counts is where the body is in the end."""
    return float(np.hypot(*(places[-1] - right[-1])))


@wrong_model("8.1", "3 m to the right and 4 m up: how far is that in a straight line?")
def the_larger_coordinate(places: Vector, right: Vector) -> float:
    """The error is the largest difference of any two coordinates."""
    return float(np.abs(places - right).max())


@wrong_model("8.1", "Go 3 m east and 4 m north. How far are you from the start?")
def along_the_axes(places: Vector, right: Vector) -> float:
    """The errors of x and of y are added."""
    return float(np.abs(places - right).sum(axis=1).max())


@wrong_model("8.1", "Somebody wants to know how wrong it ever is. Does a mean say that?")
def the_mean_distance(places: Vector, right: Vector) -> float:
    """The error is the distance on average."""
    return float(np.hypot(*(places - right).T).mean())


@wrong_model("8.1", "A body is 2 m too far out on a circle of 9 m. By how much do lengths differ?")
def difference_of_lengths(places: Vector, right: Vector) -> float:
    """The error is by how much the distances from the origin differ."""
    return float(np.abs(np.hypot(*places.T) - np.hypot(*right.T)).max())


@wrong_model("8.1", "What is the unit of your number: metres, or square metres?")
def square_not_undone(places: Vector, right: Vector) -> float:
    """The largest sum of squares is the error."""
    return float(((places - right) ** 2).sum(axis=1).max())


@wrong_model("8.2", "A third of the step makes the error a third. Is that the order 3, or 1?")
def ratio_of_errors(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order says how many times smaller the error has become."""
    return error_1 / error_2


@wrong_model("8.2", "You took a logarithm to the base 2. By how much did the step change here?")
def as_if_halved(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The step is always halved."""
    return math.log2(error_1 / error_2)


@wrong_model("8.2", "Errors go down with dt^p. Is p the ratio of two ratios, or an exponent?")
def ratio_of_ratios(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is how much faster the errors shrink than the steps."""
    return (error_1 / error_2) / (dt_1 / dt_2)


@wrong_model("8.2", "You have divided the right two numbers the wrong way round. Which is p?")
def upside_down(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is the logarithm of the steps over that of the errors."""
    return math.log(dt_1 / dt_2) / math.log(error_1 / error_2)


@wrong_model("8.2", "Does a smaller step make your errors larger? Look at the sign.")
def wrong_sign(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is negative, for the errors go down."""
    return -math.log(error_1 / error_2) / math.log(dt_1 / dt_2)


@wrong_model("8.2", "A slope between two points: on which kind of axes is dt^p a straight line?")
def slope_without_logarithms(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is the slope of the error over the step."""
    return (error_1 - error_2) / (dt_1 - dt_2)


@wrong_model("8.3", "One error is small by chance. How much does it count if you use two points?")
def first_and_last(steps: Vector, errors: Vector) -> tuple[float, float]:
    """The slope is that from the first point to the last."""
    order = math.log(errors[0] / errors[-1]) / math.log(steps[0] / steps[-1])
    return order, errors[0] / steps[0] ** order


@wrong_model("8.3", "Your straight line goes through errors and steps. Is dt^2 a straight line?")
def without_logarithms(steps: Vector, errors: Vector) -> tuple[float, float]:
    """The line is fitted through the errors themselves."""
    slope, shift = np.polyfit(steps, errors, 1)
    return float(slope), float(shift)


@wrong_model("8.3", "Your second number is where ln dt = 0. What is the error there?")
def logarithm_of_the_factor(steps: Vector, errors: Vector) -> tuple[float, float]:
    """The second number of the fit is C."""
    slope, shift = np.polyfit(np.log(steps), np.log(errors), 1)
    return float(slope), float(shift)


@wrong_model("8.3", "Your logarithms are to the base 10. What undoes such a logarithm?")
def two_kinds_of_logarithm(steps: Vector, errors: Vector) -> tuple[float, float]:
    """The function exp undoes every logarithm."""
    slope, shift = np.polyfit(np.log10(steps), np.log10(errors), 1)
    return float(slope), math.exp(shift)


@wrong_model("8.3", "Which of the two do you predict: the error from the step, or the reverse?")
def step_over_error(steps: Vector, errors: Vector) -> tuple[float, float]:
    """The line predicts the step from the error."""
    slope, shift = np.polyfit(np.log(errors), np.log(steps), 1)
    return float(slope), float(np.exp(shift))


@wrong_model(
    "8.3", "Between each two neighbours you get a slope. Do the inner points count at all?"
)
def mean_of_the_slopes(steps: Vector, errors: Vector) -> tuple[float, float]:
    """The order is the mean of the orders of neighbours."""
    slopes = np.diff(np.log(errors)) / np.diff(np.log(steps))
    order = float(np.mean(slopes))
    return order, float(np.exp(np.mean(np.log(errors) - order * np.log(steps))))


@wrong_model("8.1", "One distance is large, a hundred are small. What does the root of a mean say?")
def root_mean_square(places: Vector, right: Vector) -> float:
    """The error is the root of the mean square of the distances."""
    return float(np.sqrt(np.mean(np.sum((places - right) ** 2, axis=1))))


@wrong_model("8.3", "The errors scatter. Does the first row alone know the factor?")
def factor_of_the_first_row(steps: Vector, errors: Vector) -> Any:
    """The slope comes from all rows, and C from the first one: C = error / dt^p."""
    slope, _ = np.polyfit(np.log(steps), np.log(errors), 1)
    return slope, errors[0] / steps[0] ** slope


@wrong_model("8.3", "A line has a slope and a height. Which of both did you take to be 0?")
def through_the_origin(steps: Vector, errors: Vector) -> Any:
    """The line through the logarithms goes through the origin, so C is 1."""
    x, y = np.log(steps), np.log(errors)
    return x @ y / (x @ x), 1.0


@wrong_model("8.1", "Half of the errors are larger than yours. Is any of them the largest?")
def the_middle_one(places: Vector, right: Vector) -> float:
    """The error is the one in the middle of all."""
    return float(np.median(np.hypot(*(places - right).T)))


@wrong_model(
    "8.3", "The fit has found a line. Is its height what you get from a mean of quotients?"
)
def mean_of_the_factors(steps: Vector, errors: Vector) -> Any:
    """The slope is fitted, and C is the mean of error / dt^p."""
    slope, _ = np.polyfit(np.log(steps), np.log(errors), 1)
    return slope, np.mean(errors / steps**slope)


@wrong_model("8.1", "Is the body farthest off along x and along y at one and the same time?")
def worst_of_x_and_of_y(places: Vector, right: Vector) -> float:
    """The largest error along x and the largest along y make the largest distance."""
    return float(np.hypot(*np.abs(places - right).max(axis=0)))


@wrong_model("8.1", "What is the unit of your number: metres, or none?")
def relative_to_the_place(places: Vector, right: Vector) -> float:
    """An error is a part of the distance from the origin."""
    return float((np.hypot(*(places - right).T) / np.hypot(*right.T)).max())


@wrong_model("8.1", "Look twice as often at the same way. Does your error grow by that?")
def norm_of_the_table(places: Vector, right: Vector) -> float:
    """The norm of all differences together is the largest of them."""
    return float(np.sqrt(((places - right) ** 2).sum()))


@wrong_model("8.2", "C dt^p with C = 5: what is log(error) / log(dt) then? Is it p?")
def from_one_run(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The order is the logarithm of the error to the base of the step, so one run will do."""
    return math.log(error_1) / math.log(dt_1)


@wrong_model("8.2", "Is the logarithm of a quotient the quotient of the logarithms?")
def quotients_of_logarithms(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The logarithm of a quotient is the quotient of the logarithms."""
    return math.log(error_1) / math.log(error_2) / (math.log(dt_1) / math.log(dt_2))


@wrong_model("8.2", "You took the logarithm of the errors. What about the steps?")
def logarithms_of_the_errors_alone(
    dt_1: float, error_1: float, dt_2: float, error_2: float
) -> float:
    """The order is the slope of the logarithm of the error over the step."""
    return (math.log(error_1) - math.log(error_2)) / (dt_1 - dt_2)


@wrong_model("8.3", "To which base is np.log? What undoes it?")
def undone_to_the_base_of_ten(steps: Vector, errors: Vector) -> Any:
    """A power of 10 undoes np.log."""
    slope, shift = np.polyfit(np.log(steps), np.log(errors), 1)
    return slope, 10**shift

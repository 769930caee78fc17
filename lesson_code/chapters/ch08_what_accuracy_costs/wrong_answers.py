"""Wrong models of chapter 08: norms, orders of convergence, equal work, the cheapest setting.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch08_what_accuracy_costs.right_answers import the_best_so_far
from lesson_code.course.grading.task import edited, wrong_model

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


@wrong_model("8.4", "Your setting costs more than all others. Was that equal work?")
def least_error_of_all(table: Vector, sweeps: float) -> Any:
    """The best row is the one with the least error."""
    row = min(table, key=lambda r: r[2])
    return float(row[0]), float(row[1])


@wrong_model("8.4", "You have added sub-steps and iterations. How often is a contact visited?")
def a_sum_of_sweeps(table: Vector, sweeps: float) -> Any:
    """The sweeps are sub-steps and iterations together."""
    rows = [row for row in table if row[0] + row[1] == sweeps and math.isfinite(row[2])]
    if not rows:
        return None
    row = min(rows, key=lambda r: r[2])
    return float(row[0]), float(row[1])


@wrong_model("8.4", "Are many small steps always best? Look at the errors in the table.")
def most_substeps(table: Vector, sweeps: float) -> Any:
    """Sub-steps beat iterations: take as many as there are."""
    rows = [row for row in table if row[0] * row[1] == sweeps and math.isfinite(row[2])]
    if not rows:
        return None
    row = max(rows, key=lambda r: r[0])
    return float(row[0]), float(row[1])


@wrong_model("8.4", "Are many iterations always best? Look at the errors in the table.")
def most_iterations(table: Vector, sweeps: float) -> Any:
    """The solver has to converge: take as many iterations as there are."""
    rows = [row for row in table if row[0] * row[1] == sweeps and math.isfinite(row[2])]
    if not rows:
        return None
    row = max(rows, key=lambda r: r[1])
    return float(row[0]), float(row[1])


@wrong_model("8.4", "Some of your rows cost less than was allowed. Was the work equal?")
def at_most_so_many(table: Vector, sweeps: float) -> Any:
    """Fewer sweeps will do as well."""
    rows = [row for row in table if row[0] * row[1] <= sweeps and math.isfinite(row[2])]
    if not rows:
        return None
    row = min(rows, key=lambda r: r[2])
    return float(row[0]), float(row[1])


@wrong_model("8.4", "In all rows of equal work the tower fell. Which of them do you recommend?")
def the_best_of_the_fallen(table: Vector, sweeps: float) -> Any:
    """Some row is always the best one."""
    rows = [row for row in table if row[0] * row[1] == sweeps]
    if not rows:
        return None
    row = min(rows, key=lambda r: r[2])
    return float(row[0]), float(row[1])


@wrong_model("8.5", "Somebody allows 1 cm. Do they want to pay for 1 nm?")
def the_most_accurate(table: Vector, allowed: float) -> Any:
    """The best setting is the one with the least error."""
    best = min(range(len(table)), key=lambda n: table[n][1])
    return best if table[best][1] <= allowed else None


@wrong_model("8.5", "Your setting is the fastest. Is it good enough?")
def the_fastest(table: Vector, allowed: float) -> Any:
    """The best setting is the one that takes the least time."""
    return min(range(len(table)), key=lambda n: table[n][0])


@wrong_model("8.5", "You took the first row that is good enough. Is there a faster one below it?")
def the_first_good_one(table: Vector, allowed: float) -> Any:
    """The table is sorted by time."""
    for n, (_, error) in enumerate(table):
        if error <= allowed:
            return n
    return None


@wrong_model("8.5", "Multiply both by ten: does the same setting still reach what is allowed?")
def time_times_error(table: Vector, allowed: float) -> Any:
    """The best setting has the least product of time and error."""
    best = min(range(len(table)), key=lambda n: table[n][0] * table[n][1])
    return best if table[best][1] <= allowed else None


@wrong_model("8.5", "An error of just what is allowed: is that allowed?")
def strictly_less(table: Vector, allowed: float) -> Any:
    """The error has to be less than what is allowed."""
    good = [n for n in range(len(table)) if table[n][1] < allowed]
    return min(good, key=lambda n: table[n][0], default=None)


@wrong_model("8.5", "Nothing in the table is good enough. What do you recommend?")
def something_is_always_best(table: Vector, allowed: float) -> Any:
    """Where nothing is good enough, the most accurate will have to do."""
    good = [n for n in range(len(table)) if table[n][1] <= allowed]
    return min(good or range(len(table)), key=lambda n: table[n][0] if good else table[n][1])


@wrong_model("8.5", "Does the least accurate row that is allowed always take the least time?")
def the_least_accurate(table: Any, allowed: float) -> int | None:
    """The less accurate a setting is, the less it costs."""
    good = [n for n, (_, error) in enumerate(table) if error <= allowed]
    return max(good, key=lambda n: table[n][1], default=None)


@wrong_model("8.5", "You sorted out the bad rows first. Whose number is yours: in which table?")
def number_among_the_good(table: Any, allowed: float) -> int | None:
    """The number of a row is its place among those that are good enough."""
    good = [time for time, error in table if error <= allowed]
    return good.index(min(good)) if good else None


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


@wrong_model("8.4", "One of the rows with this work has failed. What of the others?")
@edited(
    the_best_so_far,
    {
        'float("inf"):\n            continue': 'float("inf"):\n            return None',
    },
)
def one_failure_is_enough() -> None:
    """Where one row of this work has failed, there is no best one."""


@wrong_model("8.4", "No row has just this work. What was asked for then?")
def the_nearest_work(table: Vector, sweeps: float) -> Any:
    """Where no row has this work, the one that comes nearest will do."""
    good = [row for row in table if row[2] < np.inf]
    near = min((abs(row[0] * row[1] - sweeps) for row in good), default=None)
    equal = [row for row in good if abs(row[0] * row[1] - sweeps) == near]
    return tuple(min(equal, key=lambda row: row[2])[:2]) if equal else None


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

"""Unusual right answers to chapter 08: norms, orders of convergence, and what is cheapest."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("8.1")
def with_complex_numbers(places: Vector, right: Vector) -> float:
    """A place in the plane is a complex number, and its length is its absolute value."""
    return max(
        abs(complex(*place) - complex(*there)) for place, there in zip(places, right, strict=True)
    )


@alternative("8.1")
def by_the_infinity_norm(places: Vector, right: Vector) -> Any:
    """NumPy's norms: the 2-norm of each row, and of those the largest."""
    import numpy as np

    return np.linalg.norm(np.linalg.norm(places - right, axis=1), ord=np.inf)


@alternative("8.2")
def to_the_base_of_the_steps(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The exponent is the logarithm to a base: that by which the step was made smaller."""
    from math import log

    return log(error_2 / error_1, dt_2 / dt_1)


@alternative("8.2")
def by_halving_an_interval(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """The exponent for which the error is predicted: sought by bisection, without a logarithm."""
    ratio, wanted = dt_1 / dt_2, error_1 / error_2
    low, high = -60.0, 60.0
    for _ in range(200):
        middle = (low + high) / 2
        if (ratio**middle < wanted) == (ratio > 1):
            low = middle
        else:
            high = middle
    return (low + high) / 2


@alternative("8.3")
def normal_equations(steps: Vector, errors: Vector) -> Any:
    """The slope is covariance over variance, and the line goes through the middle of the points."""
    import numpy as np

    x, y = np.log2(steps), np.log2(errors)
    order = ((x - x.mean()) * (y - y.mean())).sum() / ((x - x.mean()) ** 2).sum()
    return [order, 2 ** (y.mean() - order * x.mean())]


@alternative("8.3")
def least_squares_of_a_matrix(steps: Vector, errors: Vector) -> Any:
    """Two unknowns and more equations than that."""
    import numpy as np

    matrix = np.column_stack((np.ones(len(steps)), np.log(steps)))
    (shift, order), *_ = np.linalg.lstsq(matrix, np.log(errors), rcond=None)
    return order, np.exp(shift)


@alternative("8.4")
def sorted_by_error(table: Vector, sweeps: float) -> Any:
    """The rows in the order of their errors; the first of equal work is the answer."""
    for substeps, iterations, error in sorted(map(tuple, table), key=lambda row: row[2]):
        if substeps * iterations == sweeps and error < float("inf"):
            return [substeps, iterations]
    return None


@alternative("8.4")
def with_masks(table: Vector, sweeps: float) -> Any:
    """Rows that do not count are given an endless error; then one look at all."""
    import numpy as np

    equal = np.isclose(table[:, 0] * table[:, 1], sweeps)
    error = np.where(equal, table[:, 2], np.inf)
    best = int(np.argmin(error))
    return None if np.isinf(error[best]) else table[best, :2]


@alternative("8.5")
def fastest_first(table: Vector, allowed: float) -> Any:
    """Go through the rows from the fastest to the slowest, and stop at the first good one."""
    import numpy as np

    for n in np.argsort(table[:, 0]):
        if table[n, 1] <= allowed:
            return n
    return None


@alternative("8.5")
def endless_time_for_the_bad(table: Vector, allowed: float) -> Any:
    """What is not good enough takes for ever; the least time is then the answer."""
    times = [time if error <= allowed else float("inf") for time, error in table]
    least = min(times)
    return None if least == float("inf") else times.index(least)


@alternative("8.1")
def row_by_row(places: Vector, right: Vector) -> float:
    """The largest distance so far is kept."""
    largest = 0.0
    for (x, y), (right_x, right_y) in zip(places, right, strict=True):
        distance = ((x - right_x) ** 2 + (y - right_y) ** 2) ** 0.5
        if distance > largest:
            largest = distance
    return largest


@alternative("8.4")
def the_best_so_far(table: Vector, sweeps: float) -> Any:
    """One pass: rows of other work and failed ones are skipped, the best one is kept."""
    best = None
    for substeps, iterations, error in table:
        if substeps * iterations != sweeps:
            continue
        if error == float("inf"):
            continue
        if best is None or error < best[2]:
            best = substeps, iterations, error
    if best is None:
        return None
    return best[0], best[1]


@alternative("8.5")
def the_fastest_so_far(table: Vector, allowed: float) -> Any:
    """One pass: rows that are not good enough are skipped, the fastest one is kept."""
    best, least = None, float("inf")
    for n in range(len(table)):
        time, error = table[n]
        if error > allowed:
            continue
        if time < least:
            best, least = n, time
    return best

"""Wrong models of chapter 08: equal work, and the cheapest setting."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch08_what_accuracy_costs.right_answers import (
    the_best_so_far,
    the_fastest_so_far,
)
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("8.4", "Your setting costs more than all others. Was that equal work?")
@edited(the_best_so_far, {"substeps * iterations != sweeps": "False"})
def least_error_of_all() -> None:
    """The best row is the one with the least error."""


@wrong_model("8.4", "You have added sub-steps and iterations. How often is a contact visited?")
@edited(the_best_so_far, {"substeps * iterations != sweeps": "substeps + iterations != sweeps"})
def a_sum_of_sweeps() -> None:
    """The sweeps are sub-steps and iterations together."""


@wrong_model("8.4", "Are many small steps always best? Look at the errors in the table.")
@edited(the_best_so_far, {"error < best[2]": "substeps > best[0]"})
def most_substeps() -> None:
    """Sub-steps beat iterations: take as many as there are."""


@wrong_model("8.4", "Are many iterations always best? Look at the errors in the table.")
@edited(the_best_so_far, {"error < best[2]": "iterations > best[1]"})
def most_iterations() -> None:
    """The solver has to converge: take as many iterations as there are."""


@wrong_model("8.4", "Some of your rows cost less than was allowed. Was the work equal?")
@edited(the_best_so_far, {"substeps * iterations != sweeps": "substeps * iterations > sweeps"})
def at_most_so_many() -> None:
    """Fewer sweeps will do as well."""


@wrong_model("8.4", "In all rows of equal work the tower fell. Which of them do you recommend?")
@edited(the_best_so_far, {'error == float("inf")': "False"})
def the_best_of_the_fallen() -> None:
    """Some row is always the best one."""


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


@wrong_model("8.4", "You stop at the first row that fits. Are there others with less error?")
@edited(the_best_so_far, {"best is None or error < best[2]": "best is None"})
def the_first_row_that_fits() -> None:
    """The first row of this work that stands is the best."""


@wrong_model("8.4", "What is asked for: the number of the row, or what stands in it?")
def number_of_the_row(table: Vector, sweeps: float) -> Any:
    """A row is given by its number."""
    good = [n for n, (s, k, e) in enumerate(table) if s * k == sweeps and e < math.inf]
    return min(good, key=lambda n: table[n][2], default=None)


@wrong_model("8.4", "You sorted out the other rows first. In which table is your number a place?")
def place_of_another_table(table: Vector, sweeps: float) -> Any:
    """The place among the rows of this work is the place in the table."""
    errors = [e for s, k, e in table if s * k == sweeps]
    if not errors or min(errors) == math.inf:
        return None
    return tuple(table[errors.index(min(errors))][:2])


@wrong_model("8.5", "The fastest row is not good enough. Is there no other one?")
def the_fastest_or_none(table: Any, allowed: float) -> int | None:
    """If the fastest setting is not good enough, none is."""
    best = min(range(len(table)), key=lambda n: table[n][0])
    return best if table[best][1] <= allowed else None


@wrong_model("8.5", "What is asked for: the number of the row, or its time?")
@edited(the_fastest_so_far, {"    return best": "    return None if best is None else least"})
def time_of_the_row() -> None:
    """The answer is how long the cheapest takes."""


@wrong_model("8.5", "Which number has the first row of a table in Python?")
@edited(the_fastest_so_far, {"    return best": "    return None if best is None else best + 1"})
def counted_from_one() -> None:
    """The first row is number 1."""


@wrong_model("8.5", "Row 0 is the best so far. What does Python make of `not best` then?")
@edited(the_fastest_so_far, {"if time < least:": "if not best or time < least:"})
def row_0_is_none() -> None:
    """`not best` asks whether there is no best row yet."""


@wrong_model("8.4", "First the rows with that many sweeps, or first the best of all? Try both.")
def best_of_all_work(table: Any, sweeps: int) -> Any:
    """The best row of the whole table is the answer, if it has that many sweeps."""
    best = table[np.argmin(table[:, 2])]
    if best[0] * best[1] != sweeps or math.isinf(best[2]):
        return None
    return best[0], best[1]

# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 08: what accuracy costs
#
# Five functions to write, twenty points. Read notebook
# [08](../notebooks/08_what_accuracy_costs.ipynb) first. With these five you can measure any
# simulation, and choose its settings.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own, and call the functions of earlier tasks.
#   Formulas from `lesson_code` do not count: imports of it are left out when your work is graded.
# - `workbook grade exercises/08_what_accuracy_costs.ipynb` marks the whole file.
#
# Tables are NumPy arrays, a row for each setting. An error of `math.inf` means that the run has
# failed.

# %%
import math

import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 8.1 How wrong is it? (3 points)
#
# `places` and `right` have the shape (F, 2): where a body is at F times, and where it should be,
# in metres. Return the largest distance between the two, m.


# %% tags=["task"]
def largest_error(places, right):
    """Return the largest distance of a body from where it should be, m."""
    return np.hypot(*(places - right).T).max()


# %% tags=["check", "nbval-check-output"]
check_task("8.1", largest_error)

# %% [markdown] tags=["solution"]
# **Why.** At each time the error is a vector; its length is the distance. Of all distances the
# largest says how wrong it ever is. A mean would hide a bad moment, and the last value may be
# small by luck.

# %% [markdown]
# ## Task 8.2 The order that two errors show (4 points)
#
# With the step dt_1 a run is wrong by error_1, with dt_2 by error_2. Suppose that the errors
# follow E = C dt^p. Return p.


# %% tags=["task"]
def observed_order(dt_1, error_1, dt_2, error_2):
    """Return the order of convergence that two errors show."""
    return math.log(error_1 / error_2) / math.log(dt_1 / dt_2)


# %% tags=["check", "nbval-check-output"]
check_task("8.2", observed_order)

# %% [markdown] tags=["solution"]
# **Why.** Divide E1 = C dt1^p by E2 = C dt2^p: C falls out, and E1/E2 = (dt1/dt2)^p. The logarithm
# brings p down. If the errors grow while the step shrinks, p is negative: it does not converge.

# %% [markdown]
# ## Task 8.3 The order of many errors (4 points)
#
# One error may be small by chance. `steps` and `errors` are arrays of several. Fit the straight
# line ln E = ln C + p ln dt through all points, by least squares of ln E, and return (p, C).
# `np.polyfit(x, y, 1)` returns slope and shift of such a line.


# %% tags=["task"]
def fit_power(steps, errors):
    """Return (p, C) of the power C dt^p that fits the errors best."""
    slope, shift = np.polyfit(np.log(steps), np.log(errors), 1)
    return slope, math.exp(shift)


# %% tags=["check", "nbval-check-output"]
check_task("8.3", fit_power)

# %% [markdown] tags=["solution"]
# **Why.** In logarithms a power is a straight line: p is its slope. Its height at ln dt = 0 is
# ln C, so exp gives C: the error that a step of 1 s would have.

# %% [markdown]
# ## Task 8.4 Equal work (4 points)
#
# The rows of `table` are (substeps, iterations, error). A step of such a setting makes
# substeps times iterations sweeps. Of the rows with exactly `sweeps` sweeps, return
# (substeps, iterations) of the one with the least error (only one has it). Return `None` if there
# is no such row, or if all of them have failed.


# %% tags=["task"]
def best_split(table, sweeps):
    """Return (substeps, iterations) of the best row with exactly `sweeps` sweeps, or None."""
    equal = [row for row in table if row[0] * row[1] == sweeps and row[2] < math.inf]
    if not equal:
        return None
    best = min(equal, key=lambda row: row[2])
    return best[0], best[1]


# %% tags=["check", "nbval-check-output"]
check_task("8.4", best_split)

# %% [markdown] tags=["solution"]
# **Why.** Settings can only be compared at equal work: with more sweeps almost everything gets
# better. If every run has failed, all errors are infinite, and there is no best one.

# %% [markdown]
# ## Task 8.5 The cheapest that is good enough (5 points)
#
# The rows of `table` are (milliseconds, error). Return the number of the row, from 0, that takes
# the least time among those whose error is at most `allowed`; or `None` if no row is good enough.
# No two times are equal.


# %% tags=["task"]
def cheapest(table, allowed):
    """Return which row is the fastest of those that are good enough, or None."""
    good = [n for n in range(len(table)) if table[n][1] <= allowed]
    return min(good, key=lambda n: table[n][0]) if good else None


# %% tags=["check", "nbval-check-output"]
check_task("8.5", cheapest)

# %% [markdown] tags=["solution"]
# **Why.** First what is good enough, then what is cheap: in this order. Ask for the most accurate,
# and you pay for digits that nobody wants. Ask for the fastest, and you may get one that fell.

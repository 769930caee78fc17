"""A common mistake in every task: what accuracy costs."""

import math
import numpy as np


def largest_error(places, right):
    """The error is the largest difference of any two coordinates."""
    return float(np.abs(places - right).max())


def observed_order(dt_1, error_1, dt_2, error_2):
    """The step is always halved."""
    return math.log2(error_1 / error_2)


def fit_power(steps, errors):
    """The line is fitted through the errors themselves."""
    slope, shift = np.polyfit(steps, errors, 1)
    return (float(slope), float(shift))


def best_split(table, sweeps):
    """The sweeps are sub-steps and iterations together."""
    rows = [row for row in table if row[0] + row[1] == sweeps and math.isfinite(row[2])]
    if not rows:
        return None
    row = min(rows, key=lambda r: r[2])
    return (float(row[0]), float(row[1]))


def cheapest(table, allowed):
    """The best setting is the one that takes the least time."""
    return min(range(len(table)), key=lambda n: table[n][0])

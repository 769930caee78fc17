"""Lemke's method for the linear complementarity problem: w = q + M z, w >= 0, z >= 0, w z = 0.

An artificial variable z0 lifts w = q + M z + z0 d, d > 0, until no w is negative. Then pairs
(w, z) change places one after the other, so that one of each pair stays 0, until z0 leaves.

References
----------
Lemke, Bimatrix equilibrium points and mathematical programming (1965). Cottle, Pang and Stone, The
Linear Complementarity Problem (1992), section 4.4: it finds an answer whenever M is strictly
copositive (z M z > 0 for all z >= 0 but 0).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

SMALLEST_PIVOT = 1e-11
"""Of the largest in its column: a smaller one is what rounding has left of 0."""

PIVOTS = 6
"""For each variable: more mean that rounding leads the method in a circle."""

GOLDEN = 0.6180339887498949
"""Its multiples spread evenly over [0, 1): they make d uneven, so that no two rows tie."""


def lemke(matrix: Floats, q: Floats) -> Floats | None:
    """Return z, or None when the method finds none.

    Parameters
    ----------
    matrix : ndarray, shape (N, N)
        M.
    q : ndarray, shape (N,)

    Returns
    -------
    ndarray, shape (N,), or None
        z >= 0. None: the search has left on a ray, or has made too many steps.

    Examples
    --------
    >>> lemke(np.array([[2.0, 1.0], [1.0, 2.0]]), np.array([-4.0, -1.0])).tolist()
    [2.0, 0.0]
    """
    n = len(q)
    if (q >= 0.0).all():
        return np.zeros(n)
    lift = 1.0 + (np.arange(n) * GOLDEN) % 1.0
    table = np.column_stack((q, matrix, lift))  # each row: w = q + M z + d z0
    basic, free = np.arange(n), np.concatenate(([-1], n + np.arange(n), [2 * n]))
    row, column = int(np.argmin(q / lift)), n + 1
    for _ in range(PIVOTS * n):
        _exchange(table, row, column)
        leaving = int(basic[row])
        basic[row], free[column] = free[column], leaving
        if leaving == 2 * n:
            return _values(table, basic, n)
        column = int(np.flatnonzero(free == (leaving + n if leaving < n else leaving - n))[0])
        found = _blocking_row(table, column, basic, 2 * n)
        if found is None:
            return None
        row = found
    return None


def _exchange(table: Floats, row: int, column: int) -> None:
    """Let a basic and a free variable change places."""
    pivot = table[row, column]
    factors = table[:, column] / pivot
    new_row = table[row] / -pivot
    table -= np.outer(factors, table[row])
    table[:, column] = factors
    table[row] = new_row
    table[row, column] = 1.0 / pivot


def _blocking_row(table: Floats, column: int, basic: NDArray[np.int64], z0: int) -> int | None:
    """Return the row of the variable that is first to reach 0, z0 before others; None: none."""
    falls = -table[:, column]
    able = np.flatnonzero(falls > SMALLEST_PIVOT * np.abs(falls).max())
    if len(able) == 0:
        return None
    ratios = np.maximum(table[able, 0], 0.0) / falls[able]
    first = able[ratios <= ratios.min() * (1.0 + 1e-12)]
    last = first[basic[first] == z0]
    return int(last[0]) if len(last) else int(first[np.argmax(falls[first])])


def _values(table: Floats, basic: NDArray[np.int64], n: int) -> Floats:
    """Return z from the last table."""
    z = np.zeros(n)
    is_z = (basic >= n) & (basic < 2 * n)
    z[basic[is_z] - n] = np.maximum(table[is_z, 0], 0.0)
    return z

"""Orders of convergence, and other exponents: a straight line through logarithms.

error = C dt^p,    ln error = ln C + p ln dt

p     order: half the step makes the error 2^p times smaller
C     how large it is at a step of 1 s
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Fit:
    """An order, and where it was fitted.

    Attributes
    ----------
    order : float
        p; the slope of the straight line in a log-log figure.
    factor : float
        C, in the error's unit.
    finest, coarsest : float
        Steps between which it was fitted, s.
    scatter : float
        By what factor a point lies off the line, typically: exp of the root mean square.
    """

    order: float
    factor: float
    finest: float
    coarsest: float
    scatter: float

    def at(self, dt: float) -> float:
        """Return the error that the fit predicts for a step, s."""
        return self.factor * math.pow(dt, self.order)

    def __str__(self) -> str:
        """Return the order and its range in words."""
        ends = f"1/{1 / self.coarsest:.0f} to 1/{1 / self.finest:.0f} s"
        return f"{self.order:.2f} ({ends}, off by x{self.scatter:.2f})"


def fit_order(steps: Sequence[float], errors: Sequence[float]) -> Fit:
    """Return the order of errors at some steps, by least squares of ln error over ln dt.

    Parameters
    ----------
    steps : sequence of float
        dt, s, > 0; at least two different ones.
    errors : sequence of float
        > 0.

    Raises
    ------
    ValueError
        There are not two different steps, or a number is not > 0.

    Examples
    --------
    Half the step, a quarter of the error: the second order.

    >>> fit = fit_order([0.1, 0.05, 0.025], [4.0, 1.0, 0.25])
    >>> round(fit.order, 9), round(fit.scatter, 9)
    (2.0, 1.0)
    """
    if len(steps) != len(errors) or len(set(steps)) < 2:
        raise ValueError(f"steps must be two at least, one for each error, got {list(steps)}")
    if min(*steps, *errors) <= 0:
        raise ValueError(f"steps and errors must be > 0, got {min(*steps, *errors)}")
    x, y = np.log(steps), np.log(errors)
    order, shift = (float(number) for number in np.polyfit(x, y, 1))
    off = y - order * x - shift
    scatter = math.exp(math.sqrt(float(np.mean(off * off))))
    return Fit(order, math.exp(shift), min(steps), max(steps), scatter)

"""What a work-precision result says: orders of convergence, the best split, the cheapest method.

error = C dt^p,    ln error = ln C + p ln dt

p     order: half the step makes the error 2^p times smaller
C     how large it is at a step of 1 s
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from lesson_code.evidence.work_precision.methods import COMPILED, METHODS
from lesson_code.evidence.work_precision.result import Line, Point, WorkPrecision

FLOOR = 1e-12
"""Below this an error is rounding, and has no order."""

FEWEST = 4
"""Points through which an order is fitted: three halvings of the step."""


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
        """Return the error that the fit foretells for a step, s."""
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


def order_of(points: Iterable[Point]) -> Fit | None:
    """Return the order of a line's points that have not failed and are no rounding.

    None: there are too few of them, or they have no step.
    """
    used = [p for p in points if not p.failure and p.dt > 0 and p.error > FLOOR]
    if len({point.dt for point in used}) < FEWEST:
        return None
    return fit_order([point.dt for point in used], [point.error for point in used])


def orders(result: WorkPrecision, scene: str) -> dict[Line, Fit]:
    """Return the order of each line of a scene that has one."""
    fits = {line: order_of(points) for line, points in result.lines(scene).items()}
    return {line: fit for line, fit in fits.items() if fit is not None}


def sweeps_of(point: Point) -> int:
    """Return how many times a step of a point visits all contacts."""
    return point.setting.sweeps * METHODS[point.method].sweeps_an_iteration


def splits(result: WorkPrecision, scene: str, sweeps: int) -> dict[str, list[Point]]:
    """Return the points of each method with so many sweeps in a step, by their sub-steps.

    Each method once, in its fastest code.
    """
    found: dict[str, list[Point]] = {}
    for (method, _), points in result.lines(scene).items():
        equal = [point for point in points if sweeps_of(point) == sweeps]
        if len(equal) > 1 and method not in found:
            found[method] = sorted(equal, key=lambda point: point.substeps)
    return found


def cheapest(result: WorkPrecision, scene: str, error: float) -> Point | None:
    """Return the point that reaches an error in the least time, or None: nothing does.

    A setting counts only if all finer ones of its line are good enough too: one lucky hit is no
    accuracy.

    Parameters
    ----------
    result : WorkPrecision
        What was measured.
    scene : str
        Its name.
    error : float
        How wrong it may be, in the scene's norm, > 0.

    Raises
    ------
    ValueError
        The scene was not measured, or the error is not > 0.
    """
    if not error > 0:
        raise ValueError(f"error must be > 0, got {error}")
    good = [
        point
        for points in result.lines(scene).values()
        for point in points
        if math.isfinite(point.seconds) and _is_sure(point, points, error)
    ]
    return min(good, key=lambda point: point.seconds, default=None)


def _is_sure(point: Point, line: Sequence[Point], error: float) -> bool:
    """Return whether a point and all that differ from it by a shorter step alone are that good."""
    finer = [
        other
        for other in line
        if other.dt <= point.dt
        and (other.iterations, other.substeps) == (point.iterations, point.substeps)
    ]
    return all(not other.failure and other.error <= error for other in finer)


def in_words(point: Point) -> str:
    """Return what a point stands for: method, setting and time.

    >>> in_words(Point("drop", "pymunk", "C", 0.0125, 10, 1, error=0.1, seconds=0.002))
    'pymunk in C, 1/80 s, 1 x 10: 2 ms'
    """
    code = (
        f"{point.method}, compiled" if point.code == COMPILED else f"{point.method} in {point.code}"
    )
    return f"{code}, {point.setting}: {point.milliseconds:.2g} ms"

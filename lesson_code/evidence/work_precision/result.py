"""The results: a point for each method, code and setting, and conclusions from the points.

A failed point stays in the list, with its error, if it has one, and the kind of failure.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeAlias

from rich.table import Table

from lesson_code.evidence.measurement import Measurement, digits, rows_with, table
from lesson_code.evidence.orders import Fit, fit_order
from lesson_code.evidence.work_precision.methods import COMPILED, METHODS, Setting
from lesson_code.evidence.work_precision.scenes import scenes

FLOOR = 1e-12
"""Below this an error is rounding, and has no order."""

FEWEST = 4
"""Points through which an order is fitted: three halvings of the step."""


Line: TypeAlias = tuple[str, str]
"""A method and its code."""


@dataclass(frozen=True)
class Point:
    """One method at one setting, in one code, in one scene.

    Attributes
    ----------
    scene, method, code : str
        Names; the code is "Python", "compiled" or "C".
    dt : float
        s; 0 for the method that has no step.
    iterations, substeps : int
        In a step.
    error : float
        In the scene's norm; nan where there is no answer at all.
    seconds : float
        The shortest of the repeats, s; nan where nothing was timed.
    contact_solves : float
        Visits to a contact: contacts times sweeps, over the whole run; nan: not known.
    pair_tests : float
        Pairs whose outlines were compared, over the whole run; nan: not known.
    failure : str
        What went wrong, in a word or two; "" where nothing did.
    """

    scene: str
    method: str
    code: str
    dt: float
    iterations: int
    substeps: int
    error: float
    seconds: float = math.nan
    contact_solves: float = math.nan
    pair_tests: float = math.nan
    failure: str = ""

    @property
    def setting(self) -> Setting:
        """The method's setting."""
        return Setting(self.dt, self.iterations, self.substeps)

    @property
    def line(self) -> Line:
        """The line it belongs to in a figure."""
        return self.method, self.code

    @property
    def milliseconds(self) -> float:
        """Its time, ms."""
        return 1e3 * self.seconds


@dataclass(frozen=True)
class WorkPrecision(Measurement):
    """All points of a measurement, and where and how it was made.

    Attributes
    ----------
    repeats : int
        How often each was timed, unless it was slow.
    machine : dict
        As :func:`lesson_code.evidence.measurement.machine` returns it.
    points : tuple of Point
        In the order in which they were measured.
    """

    command = "measure accuracy"
    version = 2
    file = Path(__file__).with_name("stored.json")
    rows = {"points": Point}  # noqa: RUF012 - a class variable of the base

    repeats: int
    machine: dict[str, Any]
    points: tuple[Point, ...]

    @property
    def scenes(self) -> list[str]:
        """The names of the scenes, in order."""
        return list(dict.fromkeys(point.scene for point in self.points))

    def of(self, scene: str) -> list[Point]:
        """Return the points of a scene.

        Raises
        ------
        ValueError
            It was not measured.
        """
        return rows_with(self.points, scene=scene)

    def lines(self, scene: str) -> dict[Line, list[Point]]:
        """Return the points of a scene, line by line."""
        lines: dict[Line, list[Point]] = {}
        for point in self.of(scene):
            lines.setdefault(point.line, []).append(point)
        return lines

    def merged(self, other: WorkPrecision) -> WorkPrecision:
        """Return a result in which scenes measured anew stand in the place of the old ones."""
        points = [point for point in self.points if point.scene not in other.scenes]
        points += other.points
        order = list(dict.fromkeys([*self.scenes, *other.scenes]))
        points.sort(key=lambda point: order.index(point.scene))
        return replace(other, points=tuple(points))

    def tables(self) -> Iterator[Table]:
        """Yield a table for each scene, with the fitted orders below it."""
        for name in self.scenes:
            fits = orders(self, name)
            fitted = [f"{method}, {code}: order {fit}" for (method, code), fit in fits.items()]
            title = f"{name}: {scenes()[name].norm}"
            yield table(title, COLUMNS, self.of(name), words=2, caption="\n".join(fitted))


COLUMNS: dict[str, Callable[[Point], str]] = {
    "method": lambda point: point.method,
    "code": lambda point: point.code,
    "dt, s": lambda point: f"1/{1 / point.dt:.0f}" if point.dt > 0 else "none",
    "sweeps": lambda point: f"{point.substeps} x {point.iterations}" if point.dt > 0 else "",
    "error": lambda point: f"{_short(point.error)} {point.failure}".strip(),
    "ms": lambda point: digits(point.milliseconds),
    "visits": lambda point: digits(point.contact_solves),
    "pairs": lambda point: digits(point.pair_tests),
}
"""Sweeps are sub-steps times iterations; visits are to contacts; pairs are those tested."""


def _short(error: float) -> str:
    return f"{error:.1e}" if math.isfinite(error) else ""


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
    """Return the points of each method with a number of sweeps in a step, by their sub-steps.

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

    A setting counts only if all finer ones of its line are good enough too: a single lucky result
    does not count as accuracy.

    Parameters
    ----------
    result : WorkPrecision
        What was measured.
    scene : str
        Its name.
    error : float
        The largest error allowed, in the scene's norm, > 0.

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
    """Describe a point in words: method, setting and time.

    >>> in_words(Point("drop", "pymunk", "C", 0.0125, 10, 1, error=0.1, seconds=0.002))
    'pymunk in C, 1/80 s, 1 x 10: 2 ms'
    """
    code = (
        f"{point.method}, compiled" if point.code == COMPILED else f"{point.method} in {point.code}"
    )
    return f"{code}, {point.setting}: {point.milliseconds:.2g} ms"

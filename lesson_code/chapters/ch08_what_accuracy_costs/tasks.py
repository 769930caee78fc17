"""Tasks of chapter 08: the error in a norm, its order, equal work, and the cheapest setting."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters import draws
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.evidence.orders import fit_order

Table: TypeAlias = tuple[tuple[float, ...], ...]

SPLITS = {
    24.0: ((1, 24), (2, 12), (4, 6), (6, 4), (12, 2), (24, 1)),
    60.0: ((1, 60), (3, 20), (6, 10), (10, 6), (20, 3), (60, 1)),
}
"""Sub-steps and iterations of equal work, by the sweeps that they make."""

# 8.1: the norm


def small_errors(stream: Random) -> Iterator[Arguments]:
    """Draw bodies that are off by more and more, and less again in the end."""
    for _ in range(2):
        yield _track(stream, scale=0.1)


def one_large_error(stream: Random) -> Iterator[Arguments]:
    """Draw bodies that are far off once, in the middle of their way."""
    for _ in range(2):
        yield _track(stream, scale=3.0)


def at_one_time(stream: Random) -> Iterator[Arguments]:
    """Draw a body that is looked at a single time, and two that are where they should be."""
    places, right = _track(stream, scale=1.0)
    yield places[2:3], right[2:3]
    yield right, right


def _track(stream: Random, scale: float) -> Arguments:
    """Return places of a body at six times and where it should be, m: the largest error is fourth.

    The way off is oblique, and turned against the place, so that no other norm gives the same.
    Along x the fifth error is larger.
    """
    right = tuple(
        (round(stream.uniform(2, 6), 2), round(stream.uniform(2, 6), 2)) for _ in "123456"
    )
    sizes = (0.0, 0.3, 0.5, 1.0, 0.9, 0.4)
    from_to = (115, 155), (115, 155), (115, 155), (115, 130), (145, 155), (115, 155)
    angles = [math.radians(stream.uniform(*limits)) for limits in from_to]
    size = scale * stream.uniform(0.8, 1.2)
    off = [
        (size * s * math.cos(a), size * s * math.sin(a)) for s, a in zip(sizes, angles, strict=True)
    ]
    places = tuple(
        (round(x + dx, 3), round(y + dy, 3)) for (x, y), (dx, dy) in zip(right, off, strict=True)
    )
    return places, right


# 8.2 and 8.3: orders


def halved(stream: Random) -> Iterator[Arguments]:
    """Draw two errors, the second at half of the step, of an order that is no whole number."""
    for _ in range(2):
        yield _two_errors(stream, by=2.0)


def shortened(stream: Random) -> Iterator[Arguments]:
    """Draw two errors, the second at a step that is shorter by another factor."""
    for by in (3.0, 10.0):
        yield _two_errors(stream, by)


def the_other_way_round(stream: Random) -> Iterator[Arguments]:
    """Draw two errors, the second at the longer step."""
    dt_1, error_1, dt_2, error_2 = _two_errors(stream, by=4.0)
    yield dt_2, error_2, dt_1, error_1


def not_converging(stream: Random) -> Iterator[Arguments]:
    """Draw two errors of which the second is the larger one, at the shorter step."""
    dt_1, error_1, dt_2, _ = _two_errors(stream, by=3.0)
    yield dt_1, error_1, dt_2, error_1 * round(stream.uniform(1.2, 1.8), 2)


def _two_errors(stream: Random, by: float) -> Arguments:
    """Return dt, error, dt, error, the second step `by` times shorter; the order is 0.6 to 2.4."""
    dt = round(stream.uniform(0.02, 0.09), 3)
    order = stream.choice((round(stream.uniform(0.6, 0.9), 2), round(stream.uniform(1.2, 2.4), 2)))
    error = round(stream.uniform(0.2, 0.9), 3)
    return dt, error, dt / by, error / by**order


def exact_powers(stream: Random) -> Iterator[Arguments]:
    """Draw errors that are a power of the step."""
    for order in (1.0, 2.0):
        factor = round(stream.uniform(3.0, 9.0), 2)
        steps = _steps(stream, 4)
        yield steps, tuple(factor * dt**order for dt in steps)


def scattered(stream: Random) -> Iterator[Arguments]:
    """Draw errors that lie off their line, by factors of up to two; the last is small by chance."""
    for count in (5, 7):
        steps = _steps(stream, count)
        order, factor = stream.uniform(0.8, 1.3), stream.uniform(3.0, 9.0)
        off = [stream.uniform(0.6, 1.6) for _ in steps[:-1]] + [0.3]
        yield steps, tuple(f * factor * dt**order for f, dt in zip(off, steps, strict=True))


def _steps(stream: Random, count: int) -> tuple[float, ...]:
    """Return steps, s, each shorter than the one before, by uneven factors."""
    steps = [round(stream.uniform(0.05, 0.09), 3)]
    for _ in range(count - 1):
        steps.append(steps[-1] / stream.uniform(1.5, 3.0))
    return tuple(steps)


# 8.4: equal work


def optimum_inside(stream: Random) -> Iterator[Arguments]:
    """Draw tables in which the best split has neither most sub-steps nor most iterations.

    It is the first row, and the last one.
    """
    for sweeps, end in zip(SPLITS, (0, -1), strict=True):
        best = stream.choice((2, 3))
        table = _splits(stream, sweeps, best)
        yield _with_at(end, table, SPLITS[sweeps][best]), sweeps


def optimum_at_an_end(stream: Random) -> Iterator[Arguments]:
    """Draw tables in which the best split is one of the two ends; row 0 is better, at more work.

    It is not the first row of equal work that stands. In the last table all stand.
    """
    for sweeps, best in zip(SPLITS, stream.sample((0, 5), 2), strict=True):
        yield _with_at(0, _best_is_not_first(stream, sweeps, best), (6.0, sweeps / 2)), sweeps
    table = _best_is_not_first(stream, 24.0, best=5)
    yield tuple((n, k, min(e, 0.05)) for n, k, e in table), 24.0


def all_fell(stream: Random) -> Iterator[Arguments]:
    """Draw tables in which all of equal work have fallen, or none has so many; and one that stands.

    The last is for answers that never find anything; the best one is its last row.
    """
    for sweeps in SPLITS:
        table = _splits(stream, sweeps, best=2)
        yield tuple((n, k, math.inf if n * k == sweeps else e) for n, k, e in table), sweeps
    yield _splits(stream, 24.0, best=3), 7.0
    yield _with_at(-1, _splits(stream, 24.0, best=3), SPLITS[24.0][3]), 24.0


def _with_at(end: int, table: Table, split: tuple[float, float]) -> Table:
    """Return a table with the row of a split put first, for 0, or last, for -1."""
    others = tuple(row for row in table if row[:2] != split)
    row = tuple(row for row in table if row[:2] == split)
    return row + others if end == 0 else others + row


def _best_is_not_first(stream: Random, sweeps: float, best: int) -> Table:
    """Return rows of which the best is not the first of equal work that stands."""

    def first(table: Table) -> tuple[float, ...]:
        return next(row[:2] for row in table if row[:2] in SPLITS[sweeps] and row[2] < math.inf)

    return draws.until(
        lambda table: first(table) != SPLITS[sweeps][best],
        lambda: _splits(stream, sweeps, best),
    )


def _splits(stream: Random, sweeps: float, best: int) -> Table:
    """Return rows of sub-steps, iterations and error, m; those beside have more or fewer sweeps.

    Of equal work, one has fallen: its error is infinite.
    """
    splits = SPLITS[sweeps]
    least = stream.uniform(0.002, 0.004)
    rows = [
        (float(n), float(k), round(least * (1 + 2 * abs(place - best)), 6))
        for place, (n, k) in enumerate(splits)
    ]
    fallen = 5 if best < 3 else 0
    rows[fallen] = (*rows[fallen][:2], math.inf)
    more = [
        (6.0, sweeps / 2, round(least / 5, 6)),  # three times the work
        (2.0, sweeps / 4, round(least / 2, 6)),  # half of it
        (sweeps - 4.0, 4.0, round(least / 3, 6)),  # their sum is right
    ]
    rows += more
    stream.shuffle(rows)
    return tuple(rows)


# 8.5: the cheapest


def one_is_cheapest(stream: Random) -> Iterator[Arguments]:
    """Draw tables in which some are good enough, and one of these is the fastest.

    In two of them it is the first row, and the last one.
    """
    for place, end in ((2, None), (4, None), (2, 0), (4, -1)):
        table = _costs(stream)
        by_error = sorted(table, key=lambda row: row[1])
        allowed = round(by_error[place][1] * 1.1, 9)
        if end is not None:
            fastest = (min(row for row in table if row[1] <= allowed),)
            others = tuple(row for row in table if row not in fastest)
            table = fastest + others if end == 0 else others + fastest
        yield table, allowed


def just_allowed(stream: Random) -> Iterator[Arguments]:
    """Draw a table and as the allowed error that of one of its rows.

    The worst row comes first, and then the best, which is slow. The fastest that is allowed does
    not have the least product of time and error.
    """
    best, *others, worst = draws.until(
        lambda rows: min(rows, key=math.prod) != min(rows[:5]),
        lambda: sorted(_costs(stream), key=lambda row: row[1]),
    )
    allowed = others[3][1]
    stream.shuffle(others)
    yield (worst, best, *others), allowed


def with_failures(stream: Random) -> Iterator[Arguments]:
    """Draw tables whose fastest rows have failed; in one of them, nothing is good enough."""
    table = _costs(stream)
    least = min(time for time, _ in table)
    failed = ((round(least / 3, 4), math.inf), *table, (round(least / 2, 4), math.inf))
    yield failed, max(error for _, error in table) * 2
    yield table, min(error for _, error in table) / 3


def _costs(stream: Random) -> tuple[tuple[float, float], ...]:
    """Return rows of time, ms, and error, m: two methods, of which one is ten times as fast.

    The fast one is more accurate at the same step too. In the order of their errors, from the
    least: a very slow row, fast, fast, slow, fast. The first row is the slow one among these.
    """
    error = stream.uniform(0.3, 0.5)
    rows = [
        (
            round(stream.uniform(0.9, 1.1) * 2**n / speed, 4),
            round(stream.uniform(0.95, 1.05) * error / (speed**0.5 * 2.2**n), 6),
        )
        for speed in (1.0, 10.0)
        for n in range(4)
    ]
    first = rows.pop(3)
    stream.shuffle(rows)
    slow_and_good = (round(stream.uniform(200, 300), 4), round(stream.uniform(1e-4, 2e-4), 7))
    return (first, *rows, slow_and_good)


# What is expected


def _largest_error(places: Any, right: Any) -> float:
    """Return the largest distance of a body from where it should be, m."""
    return float(np.sqrt(((places - right) ** 2).sum(axis=1)).max())


def _observed_order(dt_1: float, error_1: float, dt_2: float, error_2: float) -> float:
    """Return the order that two errors show."""
    return (math.log(error_1) - math.log(error_2)) / (math.log(dt_1) - math.log(dt_2))


def _fit(steps: Any, errors: Any) -> tuple[float, float]:
    """Return order and factor of errors at several steps."""
    fit = fit_order(steps.tolist(), errors.tolist())
    return fit.order, fit.factor


def _best_split(table: Any, sweeps: float) -> tuple[float, float] | None:
    """Return sub-steps and iterations of the best row of equal work that stands, or None."""
    rows = [row for row in table.tolist() if row[0] * row[1] == sweeps and math.isfinite(row[2])]
    if not rows:
        return None
    substeps, iterations, _ = min(rows, key=lambda row: row[2])
    return substeps, iterations


def _cheapest(table: Any, allowed: float) -> int | None:
    """Return which row is the fastest of those that are good enough, or None."""
    good = [n for n, (_, error) in enumerate(table.tolist()) if error <= allowed]
    return min(good, key=lambda n: table[n][0], default=None)


# Why


def distances(arguments: Arguments, _answer: Any) -> str:
    """Say how far the body is off at each time."""
    distances = [math.dist(place, right) for place, right in zip(*arguments, strict=True)]
    return f"Distances, m: {written(distances)}."


def predicted(arguments: Arguments, answer: Any) -> str:
    """Say what the order that was returned would make of the second error."""
    dt_1, error_1, dt_2, error_2 = arguments
    if not isinstance(answer, int | float) or abs(answer) > MOST_ORDER:
        return ""
    says = error_1 * (dt_2 / dt_1) ** answer
    return f"With your order the second error would be {written(says)}; it is {written(error_2)}."


MOST_ORDER = 20
"""With a larger answer nothing is predicted: the numbers would overflow."""


def sweeps_of_the_rows(arguments: Arguments, _answer: Any) -> str:
    """Say which rows have the sweeps that are asked for."""
    table, sweeps = arguments
    equal = [row for row in table if row[0] * row[1] == sweeps]
    rows = "; ".join(f"{n:g} x {k:g}: {written(float(e))} m" for n, k, e in equal)
    return f"Rows of {sweeps:g} sweeps: {rows or 'none'}."


def rows_that_are_good_enough(arguments: Arguments, _answer: Any) -> str:
    """Say which rows are good enough, and how long they take."""
    table, allowed = arguments
    good = [
        f"row {n}: {written(time)} ms" for n, (time, error) in enumerate(table) if error <= allowed
    ]
    return f"Good enough: {'; '.join(good) or 'none'}."


TASKS = (
    Task(
        id="8.1",
        function="largest_error",
        section=1,
        objective="The error of a run, as one number in a stated norm.",
        expected=_largest_error,
        criteria=(
            Criterion("small errors at six times", small_errors),
            Criterion("one large error", one_large_error),
            Criterion("a single time, and no error", at_one_time),
        ),
        explain=distances,
    ),
    Task(
        id="8.2",
        function="observed_order",
        section=2,
        objective="The order of convergence that two errors show.",
        expected=_observed_order,
        criteria=(
            Criterion("half of the step", halved),
            Criterion("a third, a tenth of the step", shortened),
            Criterion("the longer step second", the_other_way_round),
            Criterion("errors that grow", not_converging),
        ),
        explain=predicted,
    ),
    Task(
        id="8.3",
        function="fit_power",
        section=2,
        objective="Order and factor of many errors that scatter, by least squares.",
        expected=_fit,
        criteria=(
            Criterion("errors that are a power of the step", exact_powers, points=2),
            Criterion("errors that scatter", scattered, points=2),
        ),
    ),
    Task(
        id="8.4",
        function="best_split",
        section=6,
        objective="Of equal work, the split into sub-steps and iterations with the least error.",
        expected=_best_split,
        criteria=(
            Criterion("the best split is inside", optimum_inside, points=2),
            Criterion("the best split is at an end", optimum_at_an_end),
            Criterion("whether anything stands", all_fell),
        ),
        explain=sweeps_of_the_rows,
    ),
    Task(
        id="8.5",
        function="cheapest",
        section=7,
        objective="The setting that is good enough and takes the least time.",
        expected=_cheapest,
        criteria=(
            Criterion("several are good enough", one_is_cheapest, points=2),
            Criterion("an error of just what is allowed", just_allowed),
            Criterion("failures, and nothing good enough", with_failures, points=2),
        ),
        explain=rows_that_are_good_enough,
    ),
)

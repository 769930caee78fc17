"""A work-precision result as tables for the terminal."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rich.table import Table

from lesson_code.evidence.work_precision.orders import orders
from lesson_code.evidence.work_precision.result import Point, WorkPrecision
from lesson_code.evidence.work_precision.scenes import scenes


def as_tables(result: WorkPrecision) -> Iterator[Table]:
    """Yield a table for each scene: a row for each point, then the fitted orders below it."""
    for name in result.scenes:
        fits = orders(result, name)
        fitted = "; ".join(f"{method}, {code}: {fit}" for (method, code), fit in fits.items())
        table = Table(
            *("method", "code", "step, sub-steps x iterations", "error", "ms"),
            *("contact solves", "pair tests", ""),
            title=f"{name}: {scenes()[name].norm}",
            caption=f"Order of the error in dt. {fitted}" if fitted else None,
        )
        for point in result.of(name):
            table.add_row(*_row(point))
        yield table


def _row(point: Point) -> Iterator[str]:
    """Yield the cells of a point."""
    yield from (point.method, point.code, str(point.setting))
    yield f"{point.error:.2e}" if math.isfinite(point.error) else ""
    yield f"{point.milliseconds:.3g}" if math.isfinite(point.seconds) else ""
    for count in (point.contact_solves, point.pair_tests):
        yield f"{count:,}" if count >= 0 else ""
    yield point.failure

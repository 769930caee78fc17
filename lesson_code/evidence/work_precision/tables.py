"""A work-precision result as tables for the terminal, no wider than 80 characters."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rich import box
from rich.table import Table

from lesson_code.evidence.work_precision.orders import orders
from lesson_code.evidence.work_precision.result import Point, WorkPrecision
from lesson_code.evidence.work_precision.scenes import scenes

COLUMNS = ("method", "code", "dt, s", "sweeps", "error", "ms", "visits", "pairs")
"""Sweeps are sub-steps times iterations; visits are to contacts; pairs are those tested."""


def as_tables(result: WorkPrecision) -> Iterator[Table]:
    """Yield a table for each scene: a row for each point, then the fitted orders below it."""
    for name in result.scenes:
        fits = orders(result, name)
        fitted = [f"{method}, {code}: order {fit}" for (method, code), fit in fits.items()]
        table = Table(
            *COLUMNS,
            title=f"{name}: {scenes()[name].norm}",
            caption="\n".join(fitted) or None,
            box=box.SIMPLE_HEAD,
            pad_edge=False,
        )
        for point in result.of(name):
            table.add_row(*_row(point))
        yield table


def _row(point: Point) -> Iterator[str]:
    """Yield the cells of a point."""
    yield from (point.method, point.code)
    yield f"1/{1 / point.dt:.0f}" if point.dt > 0 else "none"
    yield f"{point.substeps} x {point.iterations}" if point.dt > 0 else ""
    error = f"{point.error:.1e} " if math.isfinite(point.error) else ""
    yield f"{error}{point.failure}".strip()
    yield f"{point.milliseconds:.3g}" if math.isfinite(point.seconds) else ""
    for count in (point.contact_solves, point.pair_tests):
        yield str(count) if count >= 0 else ""

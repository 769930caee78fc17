"""Figures of measurements: marks where figures are known, in axes or in named rows."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from matplotlib.axes import Axes


def marks(ax: Axes, points: Iterable[tuple[float, float]], **look: Any) -> None:
    """Draw marks at the points that are finite; a figure that is not known has no mark.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    points : iterable of (float, float)
        x and y of each.
    **look
        As :meth:`matplotlib.axes.Axes.plot` takes it; no line joins them unless `linestyle` says.
    """
    known = [(x, y) for x, y in points if math.isfinite(x) and math.isfinite(y)]
    xs, ys = [x for x, _ in known], [y for _, y in known]
    ax.plot(xs, ys, **{"linestyle": "", **look})


def rows(ax: Axes, names: Sequence[str], *, margin: float = 0.6, **text: Any) -> None:
    """Give each name a row, at y = 0, 1, 2 ...; the first is on top.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    names : sequence of str
        What stands beside each row.
    margin : float
        Above the first row and below the last, in rows.
    **text
        As :meth:`matplotlib.axes.Axes.set_yticks` takes it, such as `fontsize`.
    """
    ax.set_yticks(range(len(names)), names, **text)
    ax.set_ylim(len(names) - 1 + margin, -margin)

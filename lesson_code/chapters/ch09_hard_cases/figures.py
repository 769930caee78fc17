"""Figures of the hard cases: which share of its draws each engine holds, family by family."""

from __future__ import annotations

import math

from matplotlib.axes import Axes

from lesson_code.evidence.hard_cases import Comparison, by_theme, family_by_name
from lesson_code.view.matplotlib.measured import marks, rows
from lesson_code.view.matplotlib.style import BLUE, GREEN, GREY, ORANGE, PURPLE, VERMILION

LEFT, RIGHT = -8.0, 14.0
"""Powers of ten over the bound: what is further off, or infinitely so, is drawn at the edge."""

MARKS = {
    "naive": ("x", ORANGE, "naive"),
    "box2d": ("s", GREEN, "Box2D"),
    "pymunk": ("^", VERMILION, "pymunk"),
    "sequential": ("D", PURPLE, "sweeps"),
    "ours": ("o", BLUE, "ours"),
}
"""Marker, colour and name of each engine; ours is drawn last, on top."""


def shares_held(ax: Axes, comparison: Comparison) -> Axes:
    """Draw for every family the share of its draws that each engine holds.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    comparison : Comparison
        What was measured.

    Returns
    -------
    Axes
        `ax`.
    """
    for engine in _engines(comparison):
        shares = [comparison.result(name, engine).share for name in comparison.names]
        _mark(ax, engine, [(100 * share + _shift(engine), n) for n, share in enumerate(shares)])
    _family_rows(ax, comparison)
    ax.set_xlim(-8, 108)
    ax.set_xlabel("draws in which the bound was held, %")
    return ax


def over_the_bounds(ax: Axes, comparison: Comparison) -> Axes:
    """Draw for every family how many powers of ten the worst draw is over the bound, or under it.

    A line stands at the bound; what lies to its left holds. An engine without a result has no mark.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    comparison : Comparison
        What was measured.

    Returns
    -------
    Axes
        `ax`.
    """
    for engine in _engines(comparison):
        worst = [comparison.result(name, engine).worst for name in comparison.names]
        bounds = [family_by_name(name).bound for name in comparison.names]
        seen = [(n, w, b) for n, (w, b) in enumerate(zip(worst, bounds, strict=True))]
        _mark(ax, engine, [(powers_of_ten(w, b), n) for n, w, b in seen if not math.isnan(w)])
    ax.axvline(0.0, color=GREY, linewidth=1.5)
    _family_rows(ax, comparison)
    ax.set_xlim(LEFT - 0.7, RIGHT + 0.7)
    ax.set_xlabel("worst draw, powers of ten over the bound; at the edges: that much or more")
    return ax


SIZE = {"markersize": 4.7, "markeredgewidth": 1.5}


def _engines(comparison: Comparison) -> list[str]:
    return [engine for engine in MARKS if engine in comparison.engines]


def _mark(ax: Axes, engine: str, points: list[tuple[float, int]]) -> None:
    """Draw an engine's mark at each of some points."""
    marker, color, label = MARKS[engine]
    marks(ax, points, marker=marker, color=color, label=label, zorder=3, **SIZE)


def _shift(engine: str) -> float:
    """Return a small shift that keeps equal shares apart, %."""
    return 1.2 * (list(MARKS).index(engine) - (len(MARKS) - 1) / 2)


def _family_rows(ax: Axes, comparison: Comparison) -> None:
    """Give each family a row, and draw a line with a name above each theme."""
    rows(ax, comparison.names, margin=1.0, fontsize=7)
    first = 0
    for theme, families in by_theme(map(family_by_name, comparison.names)).items():
        ax.axhline(first - 0.5, color=GREY, linewidth=0.6)
        ax.annotate(
            theme,
            (1.01, first),
            xycoords=("axes fraction", "data"),
            va="center",
            fontsize=7,
            annotation_clip=False,
        )
        first += len(families)
    ax.legend(frameon=False, ncols=len(MARKS), loc="lower center", bbox_to_anchor=(0.5, 1.0))


def powers_of_ten(value: float, bound: float) -> float:
    """Return the logarithm of how many times the bound a value is, within the picture.

    >>> powers_of_ten(100.0, 1.0), powers_of_ten(0.0, 1.0), powers_of_ten(1.0, 0.0)
    (2.0, -8.0, 14.0)
    """
    if value <= 0.0:
        return LEFT
    if bound <= 0.0 or not math.isfinite(value):
        return RIGHT
    return min(max(math.log10(value / bound), LEFT), RIGHT)

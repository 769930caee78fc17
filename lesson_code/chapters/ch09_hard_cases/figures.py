"""Figures of the hard cases, a row for each theme: how often engines hold, and how badly not."""

from __future__ import annotations

import math

from matplotlib.axes import Axes

from lesson_code.evidence.hard_cases import Comparison, Result, by_theme, family_by_name
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
    """Draw for every theme the share of its families' draws that each engine holds.

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
        results = _results(comparison, engine)
        held = [sum(r.held for r in theme) / sum(r.draws for r in theme) for theme in results]
        _mark(ax, engine, [100 * share for share in held])
    _theme_rows(ax, comparison)
    ax.set_xlim(-4, 104)
    ax.set_xlabel("draws in which the bound was held, %")
    return ax


def over_the_bounds(ax: Axes, comparison: Comparison) -> Axes:
    """Draw for every theme how many powers of ten its worst draw is over the bound, or under it.

    A line stands at the bound; what lies to its left holds. Families without a result are left
    out; an engine that has none in a theme has no mark there.

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
        powers = [
            [
                powers_of_ten(result.worst, family_by_name(result.family).bound)
                for result in theme
                if not math.isnan(result.worst)
            ]
            for theme in _results(comparison, engine)
        ]
        _mark(ax, engine, [max(theme, default=math.nan) for theme in powers])
    ax.axvline(0.0, color=GREY, linewidth=1.5)
    _theme_rows(ax, comparison)
    ax.set_xlim(LEFT - 0.7, RIGHT + 0.7)
    ax.set_xlabel("worst draw: powers of ten over the bound")
    return ax


def least_held(comparison: Comparison) -> Comparison:
    """Return one family of each theme: the first of those that all engines together hold least."""

    def share(name: str) -> float:
        return sum(comparison.result(name, engine).share for engine in comparison.engines)

    names = [min(theme, key=share) for theme in _themes(comparison).values()]
    return Comparison(
        tuple(comparison.result(name, engine) for name in names for engine in comparison.engines)
    )


SIZE = {"markersize": 7, "markeredgewidth": 1.8}
WORDS = 10
"""Size of the themes' names, points: no smaller than the numbers at the axes of other figures."""

APART = 0.15
"""Rows between the marks of two engines: equal figures do not hide each other."""


def _engines(comparison: Comparison) -> list[str]:
    return [engine for engine in MARKS if engine in comparison.engines]


def _themes(comparison: Comparison) -> dict[str, list[str]]:
    """Return the names of the families by theme."""
    themes = by_theme(map(family_by_name, comparison.names))
    return {theme: [family.name for family in families] for theme, families in themes.items()}


def _results(comparison: Comparison, engine: str) -> list[list[Result]]:
    """Return an engine's results, a list for each theme."""
    themes = _themes(comparison).values()
    return [[comparison.result(name, engine) for name in theme] for theme in themes]


def _mark(ax: Axes, engine: str, values: list[float]) -> None:
    """Draw an engine's mark for each theme, a little above or below the middle of its row."""
    marker, color, label = MARKS[engine]
    shift = APART * ((len(MARKS) - 1) / 2 - list(MARKS).index(engine))
    points = [(value, row + shift) for row, value in enumerate(values)]
    marks(ax, points, marker=marker, color=color, label=label, zorder=3, **SIZE)


def _theme_rows(ax: Axes, comparison: Comparison) -> None:
    """Give each theme a row, with the number of its families, and draw lines between the rows."""
    themes = _themes(comparison)
    names = [f"{theme} ({len(families)})" for theme, families in themes.items()]
    rows(ax, names, margin=0.6, fontsize=WORDS)
    ax.grid(False, axis="y")
    for row in range(1, len(names)):
        ax.axhline(row - 0.5, color="#e4e4e4", linewidth=0.7)
    ax.legend(frameon=False, ncols=len(MARKS), loc="lower center", bbox_to_anchor=(0.42, 1.0))


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

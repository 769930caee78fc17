"""Figures of the hard cases: which solver holds which bound, and by how much the others miss."""

from __future__ import annotations

import math

from matplotlib.axes import Axes

from lesson_code.evidence.hard_cases import Comparison
from lesson_code.view.matplotlib.measured import marks, rows
from lesson_code.view.matplotlib.style import BLUE, GREEN, GREY, ORANGE, VERMILION

LEFT, RIGHT = -8.0, 14.0
"""Powers of ten over the bound: what is further off, or infinitely so, is drawn at the edge."""

MARKS = {
    "naive": ("x", ORANGE, "naive"),
    "box2d": ("s", GREEN, "Box2D"),
    "pymunk": ("^", VERMILION, "pymunk"),
    "ours": ("o", BLUE, "ours"),
}
"""Marker, colour and name of each solver; ours is drawn last, on top."""


def over_the_bounds(ax: Axes, comparison: Comparison) -> Axes:
    """Draw for every case how many powers of ten each solver is over the bound, or under it.

    A line stands at the bound; what lies to its left holds. A solver without a result has no mark.

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
    names = comparison.names
    for solver in [s for s in MARKS if s in comparison.solvers]:
        outcomes = [comparison.outcome(name, solver) for name in names]
        seen = [(n, o.excess) for n, o in enumerate(outcomes) if not math.isnan(o.value)]
        marker, color, label = MARKS[solver]
        look = {"marker": marker, "color": color, "label": label, "zorder": 3}
        points = [(powers_of_ten(excess), n) for n, excess in seen]
        marks(ax, points, markersize=4.7, markeredgewidth=1.5, **look)
    ax.axvline(0.0, color=GREY, linewidth=1.5)
    rows(ax, names, margin=1.0, fontsize=7)
    ax.set_xlim(LEFT - 0.7, RIGHT + 0.7)
    ax.set_xlabel("powers of ten over the bound; at the edges: that much or more")
    ax.legend(frameon=False, ncols=4, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    return ax


def powers_of_ten(excess: float) -> float:
    """Return the logarithm of how many times the bound a value is, within the picture.

    >>> powers_of_ten(100.0), powers_of_ten(0.0), powers_of_ten(math.inf)
    (2.0, -8.0, 14.0)
    """
    if excess <= 0.0:
        return LEFT
    return min(max(math.log10(excess), LEFT), RIGHT) if math.isfinite(excess) else RIGHT

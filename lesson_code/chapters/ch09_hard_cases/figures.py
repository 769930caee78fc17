"""Pictures of the hard cases: who holds which bound, and by how much not."""

from __future__ import annotations

import math

from matplotlib.axes import Axes

from lesson_code.evidence.hard_cases import Comparison
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

    A line stands at the bound; what is left of it holds. A solver without a result has no mark.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    comparison : Comparison
        What was measured.

    Returns
    -------
    Axes
        The same, with one set of marks for each solver.
    """
    names = comparison.names
    for solver in [s for s in MARKS if s in comparison.solvers]:
        outcomes = [comparison.outcome(name, solver) for name in names]
        seen = [(n, o.excess) for n, o in enumerate(outcomes) if not math.isnan(o.value)]
        marker, color, label = MARKS[solver]
        ax.scatter(
            [powers_of_ten(excess) for _, excess in seen],
            [n for n, _ in seen],
            marker=marker,
            color=color,
            label=label,
            s=22,
            zorder=3,
        )
    ax.axvline(0.0, color=GREY, linewidth=1.5)
    ax.set_yticks(range(len(names)), names, fontsize=7)
    ax.set(xlim=(LEFT - 0.7, RIGHT + 0.7), ylim=(len(names), -1.0))
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

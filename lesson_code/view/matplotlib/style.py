"""Colours and sizes that all figures share."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lesson_code.view.palette import ON_WHITE

__all__ = [
    "BLUE",
    "FIRST",
    "GREEN",
    "GREY",
    "INK",
    "ORANGE",
    "PURPLE",
    "SECOND",
    "SKY",
    "VERMILION",
    "figure",
    "plain",
]

BLUE, ORANGE, GREEN = ON_WHITE.blue, ON_WHITE.orange, ON_WHITE.green
VERMILION, PURPLE, SKY = ON_WHITE.vermilion, ON_WHITE.purple, ON_WHITE.sky
GREY = "#6E6E6E"
INK = "#222222"

FIRST, SECOND = BLUE, VERMILION
"""The two bodies of a pair."""


def figure(columns: int = 1, *, width: float = 7.0, height: float = 3.4) -> tuple[Figure, Any]:
    """Return a figure and its axes: one Axes, or an array of them in a row.

    Parameters
    ----------
    columns : int
        How many axes stand side by side.
    width, height : float
        Size of the figure, inches.
    """
    drawn = Figure(figsize=(width, height), layout="constrained", dpi=100)
    axes = drawn.subplots(1, columns)
    for ax in [axes] if columns == 1 else axes:
        plain(ax)
    return drawn, axes


def plain(ax: Axes) -> Axes:
    """Remove the frame lines that carry no information, and set readable sizes."""
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(labelsize=9)
    ax.grid(True, color="#e4e4e4", linewidth=0.7)
    ax.set_axisbelow(True)
    return ax

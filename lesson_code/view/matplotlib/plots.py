"""The figures of the chapters: each takes Axes, draws one thing, and returns the Axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from lesson_code.view.matplotlib import style

Point: TypeAlias = Any
"""Two numbers: a tuple, a list or an array."""


def arrow(
    ax: Axes,
    start: Point,
    vector: Point,
    label: str,
    color: str,
    *,
    dashed: bool = False,
    beside: tuple[float, float] = (0.0, 0.0),
) -> Axes:
    """Draw a vector as an arrow, with its name at its tip.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    start, vector : sequence of 2 floats
        Tail of the arrow, and the vector itself.
    label : str
        Its name; empty for none.
    color : str
        Its colour.
    dashed : bool
        Whether the shaft is dashed, as a second cue beside colour.
    beside : (float, float)
        How far the name stands from the tip, in points.
    """
    tip = (start[0] + vector[0], start[1] + vector[1])
    if vector[0] or vector[1]:  # a zero vector has no direction to draw
        ax.annotate(
            "",
            xy=tip,
            xytext=(start[0], start[1]),
            arrowprops={
                "arrowstyle": "-|>,head_width=0.3,head_length=0.6",
                "color": color,
                "linewidth": 2.0,
                "linestyle": (0, (3, 2)) if dashed else "solid",
                "shrinkA": 0,
                "shrinkB": 0,
            },
        )
    if label:
        ax.annotate(
            label,
            xy=tip,
            xytext=beside,
            textcoords="offset points",
            color=color,
            fontsize=11,
            fontweight="bold",
            ha="center",
            va="center",
        )
    return ax


def before_and_after(
    ax: Axes,
    names: Sequence[str],
    before: Sequence[Sequence[float]],
    after: Sequence[Sequence[float]],
    unit: str,
) -> Axes:
    """Draw a quantity of two bodies, stacked, before and after for each of some cases.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    names : sequence of str
        The cases.
    before, after : sequence of (float, float)
        For each case, the quantity of body 1 and of body 2.
    unit : str
        Label of the axis with the unit.
    """
    for case, (was, is_now) in enumerate(zip(before, after, strict=True)):
        for place, pair in ((case - 0.2, was), (case + 0.2, is_now)):
            _stack(ax, place, pair)
    ax.axhline(0, color=style.INK, linewidth=0.8)
    ax.legend(
        handles=[
            Patch(color=style.FIRST, label="body 1"),
            Patch(facecolor=style.SECOND, hatch="///", edgecolor="white", label="body 2"),
            Line2D([], [], color=style.INK, linewidth=2.5, label="total"),
        ],
        loc="upper left",
        bbox_to_anchor=(1.0, 1.0),
        frameon=False,
    )
    ax.set_xticks(range(len(names)), [f"{name}\nbefore | after" for name in names])
    ax.set_ylabel(unit)
    return ax


def _stack(ax: Axes, place: float, pair: Point) -> None:
    """Draw two values on top of each other; values of opposite sign grow apart from zero."""
    for value, base, color, hatch in (
        (pair[0], 0.0, style.FIRST, ""),
        (pair[1], pair[0] if pair[0] * pair[1] > 0 else 0.0, style.SECOND, "///"),
    ):
        ax.bar(place, value, bottom=base, width=0.36, color=color, hatch=hatch, edgecolor="white")
    total = sum(pair)
    ax.plot([place - 0.18, place + 0.18], [total, total], color=style.INK, linewidth=2.5)


def carts(
    ax: Axes, m1: float, velocities: Sequence[Sequence[float]], m2: float, rows: Sequence[str]
) -> Axes:
    """Draw two carts on a track, a row for each pair of velocities, arrows for velocities.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    m1, m2 : float
        Masses, kg; the area of a cart grows with its mass.
    velocities : sequence of (float, float)
        The velocities of both carts in each row, m/s.
    rows : sequence of str
        The name of each row, top down.
    """
    size_1, size_2 = np.sqrt([m1, m2]) / np.sqrt(max(m1, m2)) * 0.8
    fastest = max(abs(float(v)) for pair in velocities for v in pair) or 1.0
    for row, ((v1, v2), name) in enumerate(zip(velocities, rows, strict=True)):
        y = -1.5 * row
        ax.plot([-4, 4], [y, y], color=style.INK, linewidth=1)
        ax.text(-4, y - 0.22, name, fontsize=10, va="center")
        _cart(ax, (-1.0, y), size_1, "1", style.FIRST, "")
        _cart(ax, (1.0, y), size_2, "2", style.SECOND, "///")
        _cart_velocity(ax, (-1.0, y), size_1, v1, fastest, style.FIRST)
        _cart_velocity(ax, (1.0, y), size_2, v2, fastest, style.SECOND)
    ax.set_xlim(-4.1, 4.1)
    ax.set_ylim(-1.5 * (len(rows) - 1) - 0.5, 1.1)
    ax.set_aspect("equal")
    ax.axis("off")
    return ax


def _cart(ax: Axes, foot: Point, size: float, name: str, color: str, hatch: str) -> None:
    """Draw a cart that stands on the track at `foot`, with its number."""
    x, y = foot
    ax.add_patch(
        Rectangle((x - size / 2, y), size, size, facecolor=color, hatch=hatch, edgecolor="white")
    )
    ax.text(
        x,
        y + size / 2,
        name,
        color="white",
        ha="center",
        va="center",
        fontweight="bold",
        bbox={"boxstyle": "circle,pad=0.45", "facecolor": color, "edgecolor": "none"},
    )


def _cart_velocity(
    ax: Axes, foot: Point, size: float, v: float, fastest: float, color: str
) -> None:
    """Draw the velocity of a cart as an arrow above it and as a number below the track."""
    x, y = foot
    shown = round(v, 2) + 0.0  # + 0.0 takes the sign off a zero
    if shown:
        arrow(ax, (x, y + size + 0.15), (1.6 * v / fastest, 0), "", color)
    ax.text(x, y - 0.22, f"{shown:+.2f} m/s", ha="center", va="center", fontsize=9)


def path(ax: Axes, positions: Any, label: str, color: str, *, dashed: bool = False) -> Axes:
    """Draw where a body has been: a line with a dot where it started."""
    positions = np.asarray(positions)
    ax.plot(
        positions[:, 0],
        positions[:, 1],
        color=color,
        linestyle="--" if dashed else "-",
        linewidth=1.8,
        label=label,
    )
    ax.plot(*positions[0], marker="o", color=color, markersize=6)
    ax.set_aspect("equal")
    return ax


CURVE_STYLES = ((style.BLUE, "-"), (style.VERMILION, "--"), (style.GREEN, ":"))
"""Colour and line of the first, second and third curve of a figure."""


def curves(ax: Axes, named: Mapping[str, tuple[Any, Any]], xlabel: str, ylabel: str) -> Axes:
    """Draw up to three curves, told apart by colour and line, with a legend.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    named : mapping of str to (x, y)
        The curves by name; a single one may have an empty name and gets no legend.
    xlabel, ylabel : str
        What the axes show, with the unit.

    Raises
    ------
    ValueError
        There are more than three curves.
    """
    if len(named) > len(CURVE_STYLES):
        raise ValueError(f"named must hold at most {len(CURVE_STYLES)} curves, got {len(named)}")
    for (name, (x, y)), (color, line) in zip(named.items(), CURVE_STYLES, strict=False):
        ax.plot(x, y, color=color, linestyle=line, label=name)
    ax.set(xlabel=xlabel, ylabel=ylabel)
    if any(named):
        ax.legend(frameon=False)
    return ax

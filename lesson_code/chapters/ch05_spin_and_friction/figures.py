"""The figures of chapter 05: points of a spinning body, triangles, and measured points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon

from lesson_code.formulas import contact_velocity
from lesson_code.view.matplotlib import style
from lesson_code.view.matplotlib.plots import CURVE_STYLES, Point, arrow, curves

MARKERS = ("o", "x")
"""The second cue of measured points: filled for ours, a cross for another engine's."""


def point_velocities(
    ax: Axes,
    velocity: Point,
    angular_velocity: float,
    radius: float,
    longest: float,
    count: int = 8,
) -> Axes:
    """Draw a disc with the velocities of points of its rim and of its centre.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    velocity : sequence of 2 floats
        Of the centre, m/s.
    angular_velocity : float
        rad/s, counter-clockwise.
    radius : float
        m.
    longest : float
        The speed, m/s, that is drawn as long as the radius; the same in all axes to compare.
    count : int
        How many points of the rim.
    """
    ax.add_patch(Circle((0, 0), radius, fill=False, edgecolor=style.INK, linewidth=1.5))
    turns = -np.pi / 2 + 2 * np.pi * np.arange(count) / count
    offsets = radius * np.stack((np.cos(turns), np.sin(turns)), axis=-1)
    scale = radius / longest
    for offset in offsets:
        at_rim = contact_velocity(velocity, angular_velocity, offset)
        ax.plot(*offset, marker="o", color=style.INK, markersize=3)
        arrow(ax, offset, _visible(scale * at_rim, radius), "", style.BLUE)
    arrow(ax, (0, 0), _visible(scale * np.asarray(velocity), radius), "", style.VERMILION)
    ax.plot(0, 0, marker="o", color=style.VERMILION, markersize=4)
    ax.set(xlim=(-1.5 * radius, 1.9 * radius), ylim=(-1.5 * radius, 1.5 * radius))
    ax.set_aspect("equal")
    ax.axis("off")
    return ax


def _visible(vector: Any, radius: float) -> Any:
    """Return a vector, or none at all where it is no more than rounding."""
    return np.where(np.hypot(*vector) > 1e-9 * radius, vector, 0.0)


def fan_of_triangles(ax: Axes, vertices: Any, centre: Point) -> Axes:
    """Draw a polygon cut into triangles that meet in its centroid, and its vertices."""
    corners = np.asarray(vertices, dtype=float)
    ax.add_patch(
        Polygon(corners, facecolor=style.SKY, alpha=0.35, edgecolor=style.INK, linewidth=1.5)
    )
    for corner in corners:
        line = zip(centre, corner, strict=True)
        ax.plot(*line, color=style.GREY, linestyle="--", linewidth=1)
    ax.plot(*corners.T, linestyle="none", marker="o", color=style.INK, markersize=6)
    ax.plot(*centre, marker="+", color=style.VERMILION, markersize=12, markeredgewidth=2)
    ax.set_aspect("equal")
    ax.set(xlabel="x, m", ylabel="y, m")
    return ax


def measured_on_curves(
    ax: Axes,
    named: Mapping[str, tuple[Any, Any]],
    measured: Mapping[str, tuple[Any, Any]],
    xlabel: str,
    ylabel: str,
) -> Axes:
    """Draw closed forms as curves, and what was measured as points on them.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    named : mapping of str to (x, y)
        The curves by name, at most three.
    measured : mapping of str to (x, y)
        The points by name, at most two sets.
    xlabel, ylabel : str
        What the axes show, with the unit.

    Raises
    ------
    ValueError
        There are more curves than can be told apart, or more sets of points.
    """
    if len(measured) > len(MARKERS):
        raise ValueError(f"measured must hold at most {len(MARKERS)} sets, got {len(measured)}")
    curves(ax, named, xlabel, ylabel)
    for (name, (x, y)), marker, (color, _) in zip(
        measured.items(), MARKERS, CURVE_STYLES[::-1], strict=False
    ):
        ax.plot(x, y, linestyle="none", marker=marker, color=color, markersize=7, label=name)
    ax.legend(frameon=False)
    return ax

"""The figures of chapter 05: points of a spinning body, and impulses under Coulomb's limit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
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


def friction_cone(ax: Axes, jn: float, needed: float, jt: float, friction: float) -> Axes:
    """Draw the impulse of a contact, and the cone that Coulomb's limit allows.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    jn : float
        Normal impulse, N s, > 0.
    needed : float
        The tangent impulse that would stop the sliding, N s.
    jt : float
        The tangent impulse that friction gives, N s.
    friction : float
        Friction coefficient mu, >= 0.
    """
    top, width = 1.35 * jn, 1.6 * jn
    cone = np.array([(0, 0), (friction * top, top), (-friction * top, top)])
    ax.add_patch(Polygon(cone, facecolor=style.SKY, alpha=0.35, edgecolor="none"))
    for side in (1, -1):
        ax.plot((0, side * friction * top), (0, top), color=style.BLUE, linewidth=1)
    ax.plot((-width, width), (jn, jn), color=style.GREY, linestyle=":", linewidth=1)
    ax.axhline(0, color=style.INK, linewidth=2)
    arrow(ax, (0, 0), (needed, jn), "", style.VERMILION, dashed=True)
    arrow(ax, (0, 0), (jt, jn), "", style.INK)
    ax.set(xlim=(-width, width), ylim=(-0.08 * jn, top))
    ax.set_aspect("equal")
    ax.set(xlabel="tangent impulse, N s", ylabel="normal impulse, N s")
    ax.legend(
        handles=[
            Line2D([], [], color=style.VERMILION, linestyle="--", label="would stop the sliding"),
            Line2D([], [], color=style.INK, label="the impulse"),
        ],
        loc="lower center",
        bbox_to_anchor=(0.5, 1.0),
        ncols=2,
        frameon=False,
        fontsize=9,
    )
    return ax


def clamped_ramp(ax: Axes, sliding: Any, impulses: Any, here: float, impulse: float) -> Axes:
    """Draw the friction impulse over the sliding velocity, and mark where a contact stands.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    sliding, impulses : array_like, shape (K,)
        The curve: sliding velocities, m/s, and the impulses of friction, N s.
    here, impulse : float
        The contact's own sliding and impulse.
    """
    ax.axhline(0, color=style.GREY, linewidth=0.8)
    ax.axvline(0, color=style.GREY, linewidth=0.8)
    curves(ax, {"": (sliding, impulses)}, "sliding before, m/s", "friction impulse, N s")
    ax.plot(here, impulse, marker="o", markersize=9, color=style.INK)
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

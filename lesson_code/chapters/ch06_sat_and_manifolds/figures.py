"""Figures of the separating axis test: two polygons, their shadows, the way out, the clipping."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon as Outline

from lesson_code.geometry import mtv, project
from lesson_code.view.matplotlib import style
from lesson_code.view.matplotlib.plots import arrow

Vertices: TypeAlias = Any
"""Corners of a convex polygon, counter-clockwise, shape (N, 2), m."""

Interval: TypeAlias = tuple[float, float]

SAME_PLACE = 1e-9
"""m: corners that lie as deep as each other, but for rounding, are an edge."""

ROOM = 0.25
"""m between the polygons and the axis that their shadows fall on."""


def _interval(vertices: Vertices, axis: Any) -> Interval:
    """Return a shadow as plain floats."""
    low, high = project(vertices, axis)
    return float(low), float(high)


def polygon(ax: Axes, vertices: Vertices, name: str, *, first: bool = True) -> Axes:
    """Draw a polygon with its name: A in the first body's colour, or B, hatched, in the second's.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    vertices : array_like, shape (N, 2)
        m.
    name : str
        Written in the middle; empty for none.
    first : bool
        Whether this is the first body of the pair.
    """
    color = style.FIRST if first else style.SECOND
    corners = np.asarray(vertices, dtype=float)
    hatch = "" if first else "///"
    ax.add_patch(Outline(corners, facecolor=color, edgecolor=color, alpha=0.25, hatch=hatch))
    ax.add_patch(Outline(corners, fill=False, edgecolor=color, linewidth=1.8))
    _name(ax, corners.mean(axis=0), name, color)
    return ax


def _name(ax: Axes, place: Any, name: str, color: str) -> None:
    """Write a name on a patch of white, so that lines below do not cross the letters."""
    if name:
        ax.text(
            place[0],
            place[1],
            name,
            color=color,
            ha="center",
            va="center",
            fontweight="bold",
            bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none"},
        )


def pair(
    ax: Axes, vertices_a: Vertices, vertices_b: Vertices, names: Sequence[str] = ("A", "B")
) -> Axes:
    """Draw two polygons to scale, with names and the unit on both axes."""
    polygon(ax, vertices_a, names[0])
    polygon(ax, vertices_b, names[1], first=False)
    ax.autoscale_view()
    ax.set_aspect("equal")
    ax.set(xlabel="x, m", ylabel="y, m")
    return ax


def shadows_beside(
    ax: Axes, vertices_a: Vertices, vertices_b: Vertices, axis: Any, name: str = ""
) -> Axes:
    """Draw an axis beside two polygons, and their shadows on it.

    Parameters
    ----------
    ax : Axes
        Where to draw; the polygons are drawn too.
    vertices_a, vertices_b : array_like, shape (N, 2)
        m.
    axis : array_like, shape (2,)
        Unit vector along the axis; the polygons stand to its left.
    name : str
        Written at the tip of the axis; empty for none.
    """
    pair(ax, vertices_a, vertices_b)
    n = np.asarray(axis, dtype=float)
    across = np.array([n[1], -n[0]])
    nearest = max(float((np.asarray(v) @ across).max()) for v in (vertices_a, vertices_b))
    ends = [_interval(vertices, n) for vertices in (vertices_a, vertices_b)]
    low, high = min(e[0] for e in ends) - ROOM, max(e[1] for e in ends) + ROOM
    foot = (nearest + ROOM) * across
    arrow(ax, low * n + foot, (high - low) * n, name, style.GREY, beside=(10 * n[0], 10 * n[1]))
    for vertices, interval, row, first in (
        (vertices_a, ends[0], 0.35, True),
        (vertices_b, ends[1], 0.8, False),
    ):
        _shadow(ax, vertices, interval, n, foot + row * ROOM * across, first)
    ax.autoscale_view()
    return ax


def _shadow(ax: Axes, vertices: Vertices, ends: Interval, n: Any, foot: Any, first: bool) -> None:
    """Draw one shadow, and dotted lines from its ends to the vertices that cast them."""
    color = style.FIRST if first else style.SECOND
    shade = np.array([end * n + foot for end in ends])
    ax.plot(*shade.T, color=color, linewidth=5, solid_capstyle="butt")
    corners = np.asarray(vertices, dtype=float)
    along = corners @ n
    for corner, end in zip(corners[[along.argmin(), along.argmax()]], shade, strict=True):
        ax.plot(*zip(corner, end, strict=True), color=color, linewidth=1, linestyle=":")


def translation(ax: Axes, vertices_a: Vertices, vertices_b: Vertices) -> Axes:
    """Draw where the minimum translation vector puts B, beside two polygons that are drawn already.

    The arrow leads from the deepest point of B to where that point is put.
    """
    found = mtv(vertices_a, vertices_b)
    if found is None:
        return ax
    corners = np.asarray(vertices_b, dtype=float)
    move = found[1] * np.asarray(found[0])
    moved = Outline(corners + move, fill=False, edgecolor=style.SECOND, linestyle="--", linewidth=2)
    ax.add_patch(moved)
    arrow(ax, deepest(corners, found[0]), move, "", style.INK)
    ax.autoscale_view()
    return ax


def deepest(vertices_b: Vertices, normal: Any) -> Any:
    """Return the point of B that lies deepest in A: a vertex, or the middle of a level edge.

    Parameters
    ----------
    vertices_b : array_like, shape (N, 2)
        m.
    normal : array_like, shape (2,)
        Unit vector from A to B.

    Examples
    --------
    >>> deepest([(0, 0), (2, 0), (2, 1), (0, 1)], normal=(0, 1))
    array([1., 0.])
    """
    corners = np.asarray(vertices_b, dtype=float)
    along = corners @ np.asarray(normal, dtype=float)
    return corners[along <= along.min() + SAME_PLACE].mean(axis=0)

"""Figures of the contact manifold: the edges that meet, the clipping, the points, the ways out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle as CirclePatch

from lesson_code.chapters.ch06_sat_and_manifolds import figures as sat_plots
from lesson_code.engine.core.scene import Scene
from lesson_code.geometry import Circle, Polygon, collide, mtv, sat_axes
from lesson_code.view.matplotlib import scene_plots, style
from lesson_code.view.matplotlib.plots import arrow

Pose: TypeAlias = tuple[float, float, float]
"""x, y, m, and angle, rad."""

ALONG = 1 - 1e-9
"""A unit normal whose dot product with another one is larger than this is the same one."""

POINT: dict[str, Any] = {
    "color": style.INK,
    "linestyle": "",
    "marker": "o",
    "markersize": 4.5,
    "markeredgecolor": "white",
    "markeredgewidth": 0.8,
    "zorder": 7,
}
"""How a contact point is drawn."""


def clipping(
    axes: Sequence[Axes], a: Polygon, pose_a: Pose, b: Polygon, pose_b: Pose
) -> Sequence[Axes]:
    """Draw in three steps how two overlapping polygons get their contact points.

    The edges that face each other; the incident edge, cut at the ends of the reference edge; and
    the contact points, with their penetrations.

    Parameters
    ----------
    axes : sequence of 3 Axes
        Where to draw.
    a, b : Polygon
        The shapes.
    pose_a, pose_b : (x, y, angle)
        Where they are, m and rad.

    Raises
    ------
    ValueError
        The polygons do not overlap.
    """
    manifold = collide(a, pose_a, b, pose_b)
    if manifold is None:
        raise ValueError("a and b must overlap, got polygons that are apart")
    placed = [_placed(a, pose_a), _placed(b, pose_b)]
    reference, incident, is_of_a = _edges(*placed)
    titles = ("the edges that face each other", "clipped at the reference edge", "contact points")
    for ax, title, names in zip(axes, titles, (("A", "B"), ("A", "B"), ("", "")), strict=True):
        sat_plots.pair(ax, placed[0], placed[1], names)
        ax.set_title(title, fontsize=11)
    colors = (style.FIRST, style.SECOND) if is_of_a else (style.SECOND, style.FIRST)
    _edge(axes[0], reference, colors[0], "reference edge")
    _edge(axes[0], incident, colors[1], "incident edge")
    axes[0].legend(loc="upper left", frameon=False, fontsize=9, borderpad=0, labelspacing=0.2)
    arrow(axes[0], reference.mean(axis=0), 0.5 * manifold.normal, "", style.INK)
    _clip(axes[1], reference, incident, colors)
    _points(axes[2], manifold)
    return axes


def _placed(shape: Polygon, pose: Pose) -> Any:
    """Return the corners of a polygon in the world, shape (N, 2)."""
    cos, sin = np.cos(pose[2]), np.sin(pose[2])
    return np.array(shape.vertices) @ np.array([[cos, sin], [-sin, cos]]) + pose[:2]


def _edges(a: Any, b: Any) -> tuple[Any, Any, bool]:
    """Return reference and incident edge, shape (2, 2), and whether the reference edge is A's."""
    found = mtv(a, b)
    normal = np.zeros(2) if found is None else found[0]
    along_a, along_b = sat_axes(a) @ normal, sat_axes(b) @ -normal
    edge_a, edge_b = (
        np.array([vertices[k], vertices[(k + 1) % len(vertices)]])
        for vertices, k in ((a, int(along_a.argmax())), (b, int(along_b.argmax())))
    )
    is_of_a = bool(along_a.max() > ALONG)
    return (edge_a, edge_b, True) if is_of_a else (edge_b, edge_a, False)


def _edge(ax: Axes, edge: Any, color: str, name: str = "") -> None:
    """Draw an edge, thick; a name is for the legend."""
    [line] = ax.plot(*edge.T, color=color, linewidth=5, solid_capstyle="round", zorder=4)
    line.set_label(name)


def _clip(ax: Axes, reference: Any, incident: Any, colors: tuple[str, str]) -> None:
    """Draw what of the incident edge lies between the lines through the reference edge's ends."""
    along = reference[1] - reference[0]
    length = float(np.hypot(*along))
    u = along / length
    for end in reference:
        across = np.array([-u[1], u[0]])
        line = np.array([end - 0.7 * across, end + 0.7 * across])
        ax.plot(*line.T, color=style.GREY, linestyle="--", linewidth=1.5)
    places = (incident - reference[0]) @ u
    parts = (np.clip(places, 0.0, length) - places[0]) / (places[1] - places[0])
    kept = incident[0] + parts[:, np.newaxis] * (incident[1] - incident[0])
    _edge(ax, reference, colors[0])
    _edge(ax, kept, colors[1])
    ax.plot(*incident.T, color=colors[1], linewidth=2, linestyle=":", zorder=4)


def _points(ax: Axes, manifold: Any) -> None:
    """Draw the contact points; beside each, how deep it is."""
    ax.plot(*manifold.points.T, **POINT)
    for point, penetration in zip(manifold.points, manifold.penetrations, strict=True):
        half = penetration / 2 * manifold.normal
        ax.plot(*np.array([point - half, point + half]).T, color=style.INK, linewidth=1.5)
        ax.annotate(
            f"{penetration:.2f} m",
            tuple(point),
            xytext=(0, -22),
            textcoords="offset points",
            ha="center",
            bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none"},
        )


def ways_out(ax: Axes, drawn: Scene) -> Axes:
    """Draw circles that overlap the first body of a scene, and where each has to go.

    An arrow leads along the normal, from each contact point as far as the penetration; the dashed
    outline is the circle that only touches.

    Parameters
    ----------
    ax : Axes
        Where to draw; the scene is drawn too.
    drawn : Scene
        A static body, and circles.
    """
    scene_plots.scene(ax, drawn, around="all")
    first = drawn.bodies[0]
    for body in drawn.bodies[1:]:
        manifold = collide(
            first.shape, (*first.position, first.angle), body.shape, (*body.position, body.angle)
        )
        if manifold is None or not isinstance(body.shape, Circle):
            continue
        move = float(manifold.penetrations[0]) * manifold.normal
        deepest = np.asarray(body.position) - body.shape.radius * manifold.normal
        arrow(ax, deepest, move, "", style.INK)
        _ghost(ax, np.asarray(body.position) + move, body.shape.radius)
    return ax


def _ghost(ax: Axes, centre: Any, radius: float) -> None:
    """Draw the dashed outline of a circle, and extend the view to hold it."""
    ax.add_patch(CirclePatch(tuple(centre), radius, fill=False, linestyle="--"))
    reach = radius + 0.1
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    ax.set_xlim(min(left, centre[0] - reach), max(right, centre[0] + reach))
    ax.set_ylim(min(bottom, centre[1] - reach), max(top, centre[1] + reach))

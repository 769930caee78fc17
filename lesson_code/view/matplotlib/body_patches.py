"""How a body looks in a figure of matplotlib: its shape at a place, its spoke, its name."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Circle as CirclePatch
from matplotlib.patches import Polygon as PolygonPatch
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from lesson_code.engine.core.scene import Scene
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape
from lesson_code.view.framing import View
from lesson_code.view.matplotlib import style

Floats: TypeAlias = NDArray[np.float64]

FILL = 0.35
"""How much of its colour a body is filled with: an overlap stays visible."""

LINE = 1.4
"""Points, width of outlines and spokes; a segment without thickness gets a wider one."""

ROUND_END_POINTS = 13
"""Corners that draw a half circle at a segment's end."""

LARGEST_NAME, SMALLEST_NAME = 11.0, 5.0
"""Points: a name is as large as its body allows, and left out where it could not be read."""

FEW_NAMES, NAME_OF_FEW = 12, 8.0
"""Up to 12 names may be larger than their bodies: at least this many points."""

LETTER = 0.7
"""Width of a letter, of the font's size."""


def draw_static(ax: Axes, scene: Scene, positions: Floats, angles: Floats, colors: Any) -> None:
    """Draw the bodies that nothing can push: grey and hatched, behind the others."""
    for n, body in enumerate(scene.bodies):
        if body.is_static:
            look = {"facecolor": "#e8e8e8", "edgecolor": colors[n], "linewidth": 1.0, "zorder": 2}
            _draw_shape(ax, body.shape, positions[n], angles[n], {**look, "hatch": "////"})


def draw_moving(
    ax: Axes,
    scene: Scene,
    positions: Floats,
    angles: Floats,
    colors: Sequence[str],
    strength: float = 1.0,
) -> None:
    """Draw the bodies that can be pushed, with `strength` 1 for full colour, 0 for none."""
    for n, body in enumerate(scene.bodies):
        if body.is_static:
            continue
        look = {
            "facecolor": (colors[n], FILL * strength),
            "edgecolor": (colors[n], strength),
            "linewidth": LINE,
            "zorder": 3,
        }
        _draw_shape(ax, body.shape, positions[n], angles[n], look)
        if isinstance(body.shape, Circle):
            _draw_spoke(ax, body.shape.radius, positions[n], angles[n], look)


def write_names(
    ax: Axes, scene: Scene, positions: Floats, angles: Floats, names: Mapping[int, str]
) -> None:
    """Write names in the middle of bodies, where there is room for them."""
    view = view_in(ax)
    scale = _points_per_metre(ax, view)
    taken: list[View] = []
    for n, name in names.items():
        shape, is_static = scene.bodies[n].shape, scene.bodies[n].is_static
        least = NAME_OF_FEW if is_static or len(names) <= FEW_NAMES else 0.0
        fitting = shape.min_width * scale / max(1.2, LETTER * len(name))
        size = min(LARGEST_NAME, max(least, fitting))
        place = _placed(np.array([shape.centroid]), positions[n], angles[n])[0]
        if is_static:
            place = _free_place(view, shape, positions[n], angles[n], _others(scene, positions))
        box = View(place[0], place[0], place[1], place[1])
        box = box.padded(LETTER * size * len(name) / scale / 2, size / scale / 2)
        if size < SMALLEST_NAME or not view.holds(box) or any(map(box.overlaps, taken)):
            continue
        taken.append(box)
        _write(ax, place, name, size)


def view_in(ax: Axes) -> View:
    """Return the part of the world that some axes show."""
    return View(*ax.get_xlim(), *ax.get_ylim())


def _draw_shape(
    ax: Axes, shape: Shape, position: Floats, angle: float, look: dict[str, Any]
) -> None:
    """Draw a shape at a place."""
    if isinstance(shape, Circle):
        ax.add_patch(CirclePatch((position[0], position[1]), shape.radius, **look))
    elif isinstance(shape, Segment) and shape.radius == 0:
        x, y = _placed(np.array(shape.outline), position, angle).T
        ax.add_line(Line2D(x, y, color=look["edgecolor"], linewidth=2.4, zorder=look["zorder"]))
    else:
        corners = np.array(shape.outline) if isinstance(shape, Polygon) else _capsule(shape)
        ax.add_patch(PolygonPatch(_placed(corners, position, angle), closed=True, **look))


def _draw_spoke(
    ax: Axes, radius: float, position: Floats, angle: float, look: dict[str, Any]
) -> None:
    """Draw the line from a circle's centre that turns with it."""
    x, y = _placed(np.array([(0.0, 0.0), (radius, 0.0)]), position, angle).T
    ax.add_line(Line2D(x, y, color=look["edgecolor"], linewidth=LINE, zorder=look["zorder"]))


def _placed(corners: Floats, position: Floats, angle: float) -> Floats:
    """Return points seen from a body as places in the world."""
    cos, sin = math.cos(angle), math.sin(angle)
    turned: Floats = corners @ np.array([[cos, sin], [-sin, cos]]) + position
    return turned


def _capsule(segment: Segment) -> Floats:
    """Return the outline of a segment with a thickness, counter-clockwise."""
    start, end = np.array(segment.start), np.array(segment.end)
    along = math.atan2(*(end - start)[::-1])
    half = np.linspace(-math.pi / 2, math.pi / 2, ROUND_END_POINTS) + along
    arc = segment.radius * np.stack((np.cos(half), np.sin(half)), axis=-1)
    return np.concatenate((end + arc, start - arc))


def _write(ax: Axes, place: Floats, name: str, size: float) -> None:
    """Write a name with a white rim, so that lines below it do not cross it."""
    ax.text(
        float(place[0]),
        float(place[1]),
        name,
        fontsize=size,
        color=style.INK,
        ha="center",
        va="center",
        zorder=8,
        path_effects=[withStroke(linewidth=2.2, foreground="white")],
    )


def _points_per_metre(ax: Axes, view: View) -> float:
    """Return how large 1 m will be drawn, in points; a little less, as labels will take room."""
    box = ax.get_window_extent()
    pixels = min(box.width / view.width, box.height / view.height)
    return 0.85 * pixels * 72 / ax.figure.dpi


def _others(scene: Scene, positions: Floats) -> Floats:
    """Return where the bodies are that can be pushed."""
    return positions[[not body.is_static for body in scene.bodies]]


def _free_place(view: View, shape: Shape, position: Floats, angle: float, others: Floats) -> Floats:
    """Return a point of a static body that is in view and far from the moving bodies."""
    places = _placed(_points_on(shape), position, angle)
    well_inside = view.padded(-0.04 * view.side, -0.04 * view.side)
    seen = places[[well_inside.holds(View(x, x, y, y)) for x, y in places]]
    if not len(seen):
        return np.asarray(places[0])
    if not len(others):
        return np.asarray(seen[len(seen) // 2])
    distances = np.hypot(*(seen[:, None] - others).T).min(axis=0)
    return np.asarray(seen[np.argmax(distances)])


def _points_on(shape: Shape) -> Floats:
    """Return points of a shape where its name may stand, the middle first."""
    middle = np.array([shape.centroid])
    if not shape.outline:
        return middle
    core = np.array(shape.outline[0]) if isinstance(shape, Segment) else middle[0]
    spread = np.linspace(0.1, 0.9, 401)[:, None]
    ways = [core + spread * (np.array(corner) - core) for corner in shape.outline]
    return np.concatenate([middle, *ways])

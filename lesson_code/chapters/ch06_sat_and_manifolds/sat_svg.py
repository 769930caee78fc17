"""The picture behind `sat_widget`: two polygons and their shadows, as the text of an SVG.

On the left the polygons, with the axis that decides and the shadows on it; on the right a row
for every axis. All numbers come from the separating axis test of `geometry`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch06_sat_and_manifolds.figures import (
    AxisShadows,
    Vertices,
    deepest,
    shadows,
    shortest,
    way_out,
)
from lesson_code.geometry import mtv
from lesson_code.view.matplotlib import style
from lesson_code.view.svg.elements import element, hatching

Place: TypeAlias = Any
"""A point in metres, y up."""

WIDTH, HEIGHT = 780, 400
SCALE = 62.0
"""px a metre in the scene."""

MIDDLE = (230.0, 185.0)
"""Where the origin of the scene is drawn, px."""

AXIS_DISTANCE = 2.35
"""m from the origin to the axis that the shadows fall on."""

ROWS_ORIGIN, ROWS_TOP, ROW_HEIGHT = 645.0, 46.0, 62.0
"""px: where place 0 of the rows is, the first row, and how far rows are apart."""

ROWS_SCALE = 32.0
"""px a metre in the rows."""


def picture(vertices_a: Vertices, vertices_b: Vertices) -> str:
    """Return the whole picture; the polygon to be dragged has the class ``b``.

    Parameters
    ----------
    vertices_a, vertices_b : array_like, shape (N, 2)
        m; both within about 3 m of the origin.
    """
    found = shadows(vertices_a, vertices_b)
    return element(
        "svg",
        _hatching(),
        *_scene(vertices_a, vertices_b, shortest(found)),
        *_rows(found),
        viewBox=f"0 0 {WIDTH} {HEIGHT}",
        width="100%",
        role="img",
        aria_label=in_words(vertices_a, vertices_b),
        font_family="sans-serif",
        font_size=14,
    )


def as_file(picture: str) -> str:
    """Return a picture as the text of a file of its own, outside of a page."""
    return picture.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)


def in_words(vertices_a: Vertices, vertices_b: Vertices) -> str:
    """Return what the test finds, in a sentence or two.

    >>> square = np.array([(0, 0), (2, 0), (2, 2), (0, 2)])
    >>> in_words(square, square + (1.5, 0.25))
    'Overlap. The shortest way for B out of A is 0.50 m along (1.00, 0.00), on axis A2.'
    >>> in_words(square, square + (2.25, 0.25))
    'No overlap. Axis A2 shows a gap of 0.25 m.'
    """
    decides = shortest(shadows(vertices_a, vertices_b))
    found = mtv(vertices_a, vertices_b)
    if found is None:
        seen = "the two shadows touching" if decides.depth == 0 else f"a {way_out(decides)}"
        return f"No overlap. Axis {decides.name} shows {seen}."
    (x, y), depth = found
    return (
        f"Overlap. The shortest way for B out of A is {depth:.2f} m along "
        f"({x + 0.0:.2f}, {y + 0.0:.2f}), on axis {decides.name}."
    )


def _hatching() -> str:
    """Return the pattern that tells B from A besides its colour."""
    ground = element("rect", width=8, height=8, fill="#f7dfcf")
    line = element("line", x1=0, y1=0, x2=0, y2=8, stroke=style.SECOND, stroke_width=2)
    sheet = element("rect", width=WIDTH, height=HEIGHT, fill="white")
    return hatching("sat-b", 8, ground, line) + sheet


def _scene(vertices_a: Vertices, vertices_b: Vertices, decides: AxisShadows) -> list[str]:
    """Return both polygons, the axis that decides with the shadows on it, and the way out."""
    a, b = np.asarray(vertices_a, dtype=float), np.asarray(vertices_b, dtype=float)
    return [
        _outline(a, "#cfe3f0", style.FIRST, "a"),
        _outline(b, "url(#sat-b)", style.SECOND, "b"),
        *_axis(decides),
        *_shadow(a, decides.axis, decides.a, 0.08, style.FIRST),
        *_shadow(b, decides.axis, decides.b, 0.26, style.SECOND),
        *_way_out(a, b),
        _label(a.mean(axis=0), "A", style.FIRST),
        _label(b.mean(axis=0), "B", style.SECOND),
    ]


def _axis(decides: AxisShadows) -> list[str]:
    """Return the line that the shadows fall on, with its name."""
    n, across = decides.axis, _across(decides.axis)
    start, end = (AXIS_DISTANCE * across + way * n for way in (-3.2, 3.2))
    name = 2.9 * n + (AXIS_DISTANCE + 0.3) * across
    return [_line(start, end, style.GREY, 1.5), _label(name, decides.name, style.GREY)]


def _shadow(
    corners: Any, axis: Any, interval: tuple[float, float], offset: float, color: str
) -> list[str]:
    """Return a shadow on the axis, and dotted lines to the vertices that cast its ends."""
    foot, along = (AXIS_DISTANCE - offset) * _across(axis), corners @ axis
    low, high = (end * axis + foot for end in interval)
    return [
        _line(low, high, color, 8),
        _line(corners[along.argmin()], low, color, 1, dotted=True),
        _line(corners[along.argmax()], high, color, 1, dotted=True),
    ]


def _across(axis: Any) -> Any:
    """Return the direction at right angles to an axis that points down, or to the right."""
    x, y = axis[1], -axis[0]
    return np.array([x, y]) if y < 0 or (y == 0 and x > 0) else np.array([-x, -y])


def _way_out(a: Any, b: Any) -> list[str]:
    """Return B where the minimum translation vector puts it, and an arrow there."""
    found = mtv(a, b)
    if found is None:
        return []
    normal, depth = np.asarray(found[0]), float(found[1])
    start = deepest(b, normal)
    tip = start + depth * normal
    side = np.array([-normal[1], normal[0]])
    head = [tip + 0.1 * side - 0.16 * normal, tip, tip - 0.1 * side - 0.16 * normal]
    return [
        _outline(b + depth * normal, "none", style.SECOND, "moved", dashed=True),
        _line(start, tip, style.INK, 2.5),
        _outline(np.array(head), style.INK, style.INK, "head"),
    ]


def _rows(found: Sequence[AxisShadows]) -> list[str]:
    """Return a row for each axis: its name, both shadows, and the way out or the gap."""
    decides = shortest(found)
    return [
        part
        for number, on in enumerate(found)
        for part in _row(on, ROWS_TOP + number * ROW_HEIGHT, bold=on is decides)
    ]


def _row(on: AxisShadows, y: float, *, bold: bool) -> list[str]:
    """Return the row of one axis; the one that decides is in bold."""
    weight = "bold" if bold else None
    return [
        element("text", on.name, x=480, y=y + 5, font_weight=weight),
        _bar(on.a, y - 13, style.FIRST),
        _bar(on.b, y + 1, "url(#sat-b)"),
        element("text", way_out(on), x=510, y=y + 33, font_size=13, font_weight=weight),
    ]


def _bar(interval: tuple[float, float], y: float, fill: str) -> str:
    """Return a shadow as a bar."""
    left, right = (ROWS_ORIGIN + ROWS_SCALE * end for end in interval)
    width = f"{right - left:.1f}"
    return element("rect", x=f"{left:.1f}", y=f"{y:.1f}", width=width, height=12, fill=fill)


def _outline(corners: Any, fill: str, edge: str, kind: str, *, dashed: bool = False) -> str:
    """Return a polygon."""
    points = " ".join(_at(corner) for corner in corners)
    return element(
        "polygon",
        class_=kind,
        points=points,
        fill=fill,
        fill_opacity=0.8,
        stroke=edge,
        stroke_width=2,
        stroke_dasharray="6 4" if dashed else None,
    )


def _line(start: Place, end: Place, color: str, width: float, *, dotted: bool = False) -> str:
    """Return a straight line."""
    (x1, y1), (x2, y2) = _pixels(start), _pixels(end)
    return element(
        "line",
        x1=f"{x1:.1f}",
        y1=f"{y1:.1f}",
        x2=f"{x2:.1f}",
        y2=f"{y2:.1f}",
        stroke=color,
        stroke_width=f"{width:g}",
        stroke_dasharray="2 4" if dotted else None,
    )


def _label(place: Place, text: str, color: str) -> str:
    """Return a name with its middle at a place; it lets the pointer through."""
    x, y = _pixels(place)
    return element(
        "text",
        text,
        x=f"{x:.1f}",
        y=f"{y + 5:.1f}",
        text_anchor="middle",
        font_weight="bold",
        fill=color,
        stroke="white",
        stroke_width=4,
        paint_order="stroke",
        pointer_events="none",
    )


def _at(place: Place) -> str:
    """Return a place as SVG writes it in a list of points."""
    x, y = _pixels(place)
    return f"{x:.1f},{y:.1f}"


def _pixels(place: Place) -> tuple[float, float]:
    """Return where a place of the scene is drawn, px, y down."""
    return MIDDLE[0] + SCALE * float(place[0]), MIDDLE[1] - SCALE * float(place[1])

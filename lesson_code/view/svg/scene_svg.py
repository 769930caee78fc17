"""A scene as the text of an SVG: the still picture of an animation, and what can move in it.

Places are in tenths of a pixel, y down. They are rounded to whole tenths, so that the text is the
same on every machine although the last bits of a position may not be.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.scene import Scene
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape
from lesson_code.view import framing
from lesson_code.view.framing import View
from lesson_code.view.matplotlib import style
from lesson_code.view.svg.elements import element, hatching

Floats: TypeAlias = NDArray[np.float64]
Ticks: TypeAlias = NDArray[np.int64]

PIXEL = 10
"""Tenths of a pixel in a pixel."""

OFF_THE_EDGE = 0.0371
"""Of a tenth: how far the edges of rounding lie from those of round numbers, where bodies rest."""

GAP = 14
"""px between two pictures side by side."""

LARGEST_NAME, SMALLEST_NAME = 14, 7
"""px: a name is as large as its body allows, and left out where it could not be read."""

FEW_NAMES, NAME_OF_FEW = 12, 11
"""Up to 12 names may be larger than their bodies: at least 11 px."""

LETTER = 0.7
"""Width of a letter, of the font's size."""

SHORTEST_ARROW = 10.0
"""Tenths of a pixel: a shorter arrow is not drawn."""

TITLE, FOOTER = 24, 24
"""px, height of the line above with the titles, and of that below with the scale."""


def ticks(pixels: Any) -> Ticks:
    """Return pixels as whole tenths.

    >>> ticks([0.32, -1.0]).tolist()
    [3, -10]
    """
    tenths: Ticks = np.floor(np.asarray(pixels) * PIXEL + 0.5 - OFF_THE_EDGE).astype(np.int64)
    return tenths


def text_of(number: int) -> str:
    """Return tenths as they are written in an SVG.

    >>> text_of(125), text_of(-30)
    ('12.5', '-3')
    """
    return f"{number / PIXEL:g}"


@dataclass(frozen=True)
class Sheet:
    """Where the world is drawn: a view, how large, and how often side by side.

    Attributes
    ----------
    view : View
        The part of the world that is shown, m.
    scale : float
        Pixels for 1 m.
    titles : sequence of str
        What stands above each picture; all empty for no such line.
    """

    view: View
    scale: float
    titles: Sequence[str]

    @classmethod
    def fitted(cls, view: View, titles: Sequence[str], width: float, height: float) -> Sheet:
        """Return the largest sheet of a width with pictures of at most a height, px."""
        one = (width - GAP * (len(titles) - 1)) / len(titles)
        return cls(view, min(one / view.width, height / view.height), titles)

    @property
    def picture(self) -> tuple[int, int]:
        """Width and height of one picture, px."""
        return round(self.view.width * self.scale), round(self.view.height * self.scale)

    @property
    def top(self) -> int:
        """Where the pictures begin, px."""
        return TITLE if any(self.titles) else 0

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of everything, px."""
        width, height = self.picture
        count = len(self.titles)
        return count * width + (count - 1) * GAP, self.top + height + FOOTER

    def placed(self, points: Any) -> Ticks:
        """Return places in the world as places in a picture, shape (..., 2)."""
        x, y = np.moveaxis(np.asarray(points, dtype=float), -1, 0)
        across, down = (x - self.view.left) * self.scale, (self.view.top - y) * self.scale
        return np.stack((ticks(across), ticks(down)), axis=-1)

    def turned(self, angles: Any) -> Ticks:
        """Return angles in rad as tenths of a degree, clockwise."""
        return ticks(-np.degrees(angles))


def drawing(sheet: Sheet, pictures: Sequence[str], note: str, name: str) -> str:
    """Return the whole SVG: pictures side by side, titles above, the scale below.

    Parameters
    ----------
    sheet : Sheet
        Where everything stands.
    pictures : sequence of str
        What :func:`picture` returns for each.
    note : str
        Words at the right of the last line; empty for none.
    name : str
        A name that no other drawing of a page has.
    """
    width, height = sheet.size
    whole = element(
        "svg",
        _hatching(name),
        *(_framed(sheet, column, picture) for column, picture in enumerate(pictures)),
        _scale_bar(sheet),
        element("text", escape(note), x=width - 2, y=height - 7, text_anchor="end"),
        xmlns="http://www.w3.org/2000/svg",
        width=width,
        height=height,
        viewBox=f"0 0 {width} {height}",
        font_family="sans-serif",
        font_size=13,
        fill=style.INK,
        stroke_linejoin="round",
    )
    return whole.replace("url(#hatch)", f"url(#hatch-{name})")


@dataclass(frozen=True)
class PlacedState:
    """The bodies of a scene at one time, placed in a picture.

    Attributes
    ----------
    places : ndarray of int, shape (N, 2)
        Tenths of a pixel, y down.
    turns : ndarray of int, shape (N,)
        Tenths of a degree, clockwise.
    arrows : ndarray of int, shape (N, 2)
        The velocities as they are drawn, tenths of a pixel; all 0 where none is drawn.
    contacts : sequence of int
        x and y of each contact point, x and y of the next, pixels.
    """

    places: Ticks
    turns: Ticks
    arrows: Ticks
    contacts: Sequence[int] = ()


def picture(sheet: Sheet, scene: Scene, state: PlacedState, names: Mapping[int, str]) -> str:
    """Return the bodies of a scene in a state: static ones behind, then those that move.

    What a script can move carries `data-body`, in the order of :func:`moving`: inside it stand a
    group that turns, the name, and the arrow. Contact points stand in `data-contacts`.

    Parameters
    ----------
    sheet : Sheet
        Where they are drawn.
    scene : Scene
        The bodies.
    state : PlacedState
        Where they are.
    names : mapping of int to str
        What stands on some of the bodies that move.
    """
    colors = framing.body_colors(scene)
    parts = []
    for n in still(scene):
        shape = _shape(scene.bodies[n].shape, sheet.scale)
        place = f"{_move(state, n)} {_turn(state, n)}"
        parts.append(element("g", shape, transform=place, fill="url(#hatch)", stroke=colors[n]))
    for n in moving(scene):
        shape = _shape(scene.bodies[n].shape, sheet.scale)
        least = NAME_OF_FEW if len(names) <= FEW_NAMES else 0
        name = _name(names.get(n, ""), scene.bodies[n].shape.min_width * sheet.scale, least)
        spoke = _spoke(scene.bodies[n].shape, sheet.scale)
        turning = element(
            "g",
            shape,
            spoke,
            transform=_turn(state, n),
            fill=colors[n],
            fill_opacity=0.35,
            stroke=colors[n],
            stroke_width=1.5,
        )
        tip = arrow(*state.arrows[n].tolist())
        velocity = element("path", fill="none", stroke_width=1.8, stroke=style.INK, d=tip)
        parts.append(element("g", turning, name, velocity, data_body=n, transform=_move(state, n)))
    return "".join(parts) + element(
        "path",
        data_contacts="",
        fill="none",
        stroke=style.INK,
        stroke_linecap="round",
        stroke_width=_dot(scene, sheet.scale),
        d=dots(state.contacts),
    )


def moving(scene: Scene) -> list[int]:
    """Return the numbers of the bodies that can be pushed or have a velocity of their own."""
    return [
        n
        for n, body in enumerate(scene.bodies)
        if not body.is_static or any(body.velocity) or body.angular_velocity
    ]


def still(scene: Scene) -> list[int]:
    """Return the numbers of the bodies that stay where they are."""
    return sorted({*range(len(scene.bodies))} - {*moving(scene)})


def arrow(x: int, y: int) -> str:
    """Return the path of an arrow from the origin, in tenths of a pixel; none for a short one.

    >>> arrow(200, 0)
    'M0 0L20 0M13 3.5L20 0L13 -3.5'
    """
    length = math.hypot(x, y)
    if length < SHORTEST_ARROW:
        return ""
    ux, uy = x / length, y / length
    ends = ((x - 70 * ux + s * 35 * uy, y - 70 * uy - s * 35 * ux) for s in (-1, 1))
    left, right = (f"{text_of(round(cx))} {text_of(round(cy))}" for cx, cy in ends)
    tip = f"{text_of(x)} {text_of(y)}"
    return f"M0 0L{tip}M{left}L{tip}L{right}"


def dots(places: Sequence[int]) -> str:
    """Return the path of contact points, from the x and y of each in pixels.

    >>> dots([10, 20, 30, 40])
    'M10 20h0M30 40h0'
    """
    return "".join(f"M{x} {y}h0" for x, y in zip(places[::2], places[1::2], strict=True))


def _move(state: PlacedState, n: int) -> str:
    """Return what takes a body to its place."""
    x, y = state.places[n].tolist()
    return f"translate({text_of(x)} {text_of(y)})"


def _turn(state: PlacedState, n: int) -> str:
    """Return what turns a body."""
    return f"rotate({text_of(int(state.turns[n]))})"


def _shape(shape: Shape, scale: float) -> str:
    """Return a shape around its body's position."""
    if isinstance(shape, Circle):
        return element("circle", r=_length(shape.radius * scale))
    if isinstance(shape, Segment) and shape.radius > 0:
        return _capsule(shape, scale)
    points = _points(shape.outline, scale)
    if isinstance(shape, Polygon):
        return element("path", d=f"M{'L'.join(points)}Z")
    return element("path", stroke_width=2.5, d=f"M{'L'.join(points)}")


def _capsule(segment: Segment, scale: float) -> str:
    """Return the outline of a segment with a thickness: two lines and two half circles."""
    (ax, ay), (bx, by) = segment.start, segment.end
    across = segment.radius / segment.length
    x, y = -(by - ay) * across, (bx - ax) * across
    a, b, c, d = _points(
        [(bx - x, by - y), (bx + x, by + y), (ax + x, ay + y), (ax - x, ay - y)], scale
    )
    r = _length(segment.radius * scale)
    return element("path", d=f"M{a}A{r} {r} 0 0 0 {b}L{c}A{r} {r} 0 0 0 {d}Z")


def _points(corners: Any, scale: float) -> list[str]:
    """Return points of a body, m, as they are written."""
    placed = ticks(np.array(corners) * (scale, -scale)).tolist()
    return [f"{text_of(x)} {text_of(y)}" for x, y in placed]


def _length(pixels: float) -> str:
    """Return a radius as it is written; the smallest can still be seen."""
    return text_of(max(int(ticks(pixels)), PIXEL // 2))


def _spoke(shape: Shape, scale: float) -> str:
    """Return the line from a circle's centre that turns with it."""
    if not isinstance(shape, Circle):
        return ""
    return element("path", d=f"M0 0H{_length(shape.radius * scale)}")


def _name(name: str, room: float, least: int) -> str:
    """Return a name in the middle of a body, as large as there is room, px; it does not turn."""
    size = min(LARGEST_NAME, max(least, int(room / max(1.2, LETTER * len(name)))))
    if not name or size < SMALLEST_NAME:
        return ""
    return element(
        "text",
        escape(name),
        text_anchor="middle",
        y=f"{0.36 * size:.1f}",
        font_size=size,
        stroke="#fff",
        stroke_width=3,
        paint_order="stroke",
    )


def _dot(scene: Scene, scale: float) -> int:
    """Return how wide a contact point is, px: small where bodies are."""
    widths = [body.shape.min_width * scale for body in scene.bodies if not body.is_static]
    return int(min(6.0, max(3.0, 0.3 * min(widths, default=0.0))))


def _hatching(name: str) -> str:
    """Return the pattern of static bodies, and the white sheet."""
    ground = element("path", fill="#ededed", d="M0 0H6V6H0Z")
    line = element("path", stroke="#b4b4b4", d="M0 0V6")
    sheet = element("rect", width="100%", height="100%", fill="#fff")
    return hatching(f"hatch-{name}", 6, ground, line) + sheet


def _framed(sheet: Sheet, column: int, bodies: str) -> str:
    """Return one picture in its frame, with its title; what leaves the frame is cut off."""
    width, height = sheet.picture
    left, title = column * (width + GAP), sheet.titles[column]
    middle = f"{left + width / 2:g}"
    heading = element("text", escape(title), x=middle, y=16, text_anchor="middle", font_weight=600)
    frame = element("rect", width="100%", height="100%", fill="none", stroke="#ccc", stroke_width=2)
    picture = element("svg", bodies, frame, x=left, y=sheet.top, width=width, height=height)
    return heading + picture if title else picture


def _scale_bar(sheet: Sheet) -> str:
    """Return a bar of a round length with its name: the unit of the picture."""
    length = framing.round_length(sheet.view.width / 4)
    width, y = text_of(int(ticks(length * sheet.scale))), sheet.size[1] - 11
    bar = f"M2 {y - 4}V{y + 4}M2 {y}h{width}M{width} {y - 4}m2 0v8"
    return element("path", stroke=style.INK, fill="none", stroke_width=1.5, d=bar) + element(
        "text", framing.in_unit(length), x=width, y=y + 4, dx=10
    )

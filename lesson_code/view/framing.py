"""Which part of the world a picture of a scene shows, and in which colours its bodies appear.

A floor is often far longer than everything that happens on it. So the bodies that can move decide
what is shown, and static ones come in whole only where the moving ones stay large enough to see.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.scene import Scene
from lesson_code.geometry.shapes import Circle, Shape
from lesson_code.view.matplotlib import style
from lesson_code.view.palette import ON_WHITE

Floats: TypeAlias = NDArray[np.float64]

MARGIN = 0.06
"""Of the larger side: the room left empty around what is shown."""

SMALLEST_BODY = 1 / 16
"""Of the larger side: a static body is shown whole while the moving ones are at least so large."""

NEAR = 10.0
"""Diameters within which the nearest point of a static body always comes into view."""

MORE = 1.5
"""A static body is also shown whole if it lengthens the larger side by at most this factor."""

SMALLEST_SIDE = 3.0
"""Diameters: a single body does not fill the view."""

FLATTEST = 3.0
"""A view is at most this many times wider than high."""

SLIMMEST = 0.7
"""A view is at least this many times as wide as it is high."""

BODY_COLORS = (
    ON_WHITE.blue,
    ON_WHITE.vermilion,
    ON_WHITE.green,
    ON_WHITE.orange,
    ON_WHITE.purple,
    ON_WHITE.sky,
)
"""Of the first, second, ... body that can be pushed; then from the beginning again."""


class View(NamedTuple):
    """The part of the world that is shown, m."""

    left: float
    right: float
    bottom: float
    top: float

    @property
    def width(self) -> float:
        """From left to right, m."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top, m."""
        return self.top - self.bottom

    @property
    def side(self) -> float:
        """The larger of width and height, m."""
        return max(self.width, self.height)

    def widened(self, other: View) -> View:
        """Return the smallest view that holds both."""
        return View(
            min(self.left, other.left),
            max(self.right, other.right),
            min(self.bottom, other.bottom),
            max(self.top, other.top),
        )

    def holds(self, other: View) -> bool:
        """Return whether all of another view lies in this one."""
        return self.widened(other) == self

    def overlaps(self, other: View) -> bool:
        """Return whether two views share more than an edge."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.bottom < other.top
            and other.bottom < self.top
        )

    def padded(self, x: float, y: float) -> View:
        """Return the view with this margin added on either side.

        >>> View(0, 2, 0, 1).padded(1, 0)
        View(left=-1, right=3, bottom=0, top=1)
        """
        return View(self.left - x, self.right + x, self.bottom - y, self.top + y)


Around: TypeAlias = Literal["all"] | tuple[float, float, float, float] | None
"""None: what moves. "all": every body, whole. Or left, right, bottom and top, m."""


def view_of(scene: Scene, positions: Any, angles: Any, around: Around = None) -> View:
    """Return the part of the world that a picture of some states shows.

    Parameters
    ----------
    scene : Scene
        Its bodies.
    positions : array_like, shape (F, N, 2)
        Where they are in each of the states, m.
    angles : array_like, shape (F, N)
        How they are turned, rad.
    around : None, "all" or (left, right, bottom, top)
        None: the moving bodies, and of the static ones what leaves the others large enough to
        see. "all": every body, whole. Otherwise the edges of the view, m.

    Raises
    ------
    ValueError
        `around` is something else, or its edges are out of order.

    Examples
    --------
    A ball stands on a floor 2 km long, and the floor is not shown to its ends.

    >>> from lesson_code import Body, Circle, Scene, Segment
    >>> ball = Body(Circle(1.0), position=(0, 1), mass=1.0)
    >>> scene = Scene([ball, Body(Segment((-1000, 0), (1000, 0)))])
    >>> view = view_of(scene, [[(0, 1), (0, 0)]], [[0, 0]])
    >>> view.width < 10
    True
    """
    if around is not None and not isinstance(around, str):
        return _given(around)
    if around not in (None, "all"):
        raise ValueError(
            f'around must be None, "all" or (left, right, bottom, top), got {around!r}'
        )
    boxes = boxes_of(scene, np.asarray(positions, float), np.asarray(angles, float))
    if not boxes:
        return View(-1.0, 1.0, -1.0, 1.0)
    if around == "all":
        return _with_margin(_union(boxes))
    free = [n for n, body in enumerate(scene.bodies) if not body.is_static]
    return _with_margin(_focus(scene, boxes, free) if free else _union(boxes))


def boxes_of(scene: Scene, positions: Floats, angles: Floats) -> list[View]:
    """Return for each body the smallest box that holds it in all states."""
    return [_box(body.shape, positions[:, n], angles[:, n]) for n, body in enumerate(scene.bodies)]


def body_colors(scene: Scene) -> list[str]:
    """Return the colour of each body: grey for static ones, the palette's for the others.

    >>> from lesson_code import Body, Circle, Scene
    >>> body_colors(Scene([Body(Circle(1.0)), Body(Circle(1.0), mass=1.0)]))
    ['#6E6E6E', '#0068A6']
    """
    colors, moving = [], 0
    for body in scene.bodies:
        if body.is_static:
            colors.append(style.GREY)
        else:
            colors.append(BODY_COLORS[moving % len(BODY_COLORS)])
            moving += 1
    return colors


def round_length(length: float) -> float:
    """Return the largest of 1, 2, 5 times a power of ten that is not longer.

    >>> round_length(3.7), round_length(0.06)
    (2.0, 0.05)
    """
    power = math.floor(math.log10(length))
    steps = (5, 2, 1)
    ten = float(f"1e{power}")
    return next((step * ten for step in steps if step * ten <= length * (1 + 1e-9)), ten)


def in_unit(length: float) -> str:
    """Return a round length with its unit, as it is written beside a scale bar.

    >>> in_unit(0.05), in_unit(20.0), in_unit(0.0002)
    ('5 cm', '20 m', '0.2 mm')
    """
    for size, unit in ((1000, "km"), (1, "m"), (0.01, "cm")):
        if length >= size * (1 - 1e-9):
            return f"{length / size:g} {unit}"
    return f"{length * 1000:g} mm"


def _given(around: Iterable[float]) -> View:
    """Return the requested view."""
    edges = tuple(float(edge) for edge in around)
    if len(edges) != 4 or not (edges[0] < edges[1] and edges[2] < edges[3]):
        raise ValueError(f"around must hold left < right and bottom < top, m, got {around!r}")
    return View(*edges)


def _box(shape: Shape, positions: Floats, angles: Floats) -> View:
    """Return the box around a shape in all states."""
    corners = np.array([(0.0, 0.0)] if isinstance(shape, Circle) else shape.outline)
    cos, sin = np.cos(angles)[:, None], np.sin(angles)[:, None]
    x = positions[:, :1] + cos * corners[:, 0] - sin * corners[:, 1]
    y = positions[:, 1:] + sin * corners[:, 0] + cos * corners[:, 1]
    r = shape.rounding
    return View(float(x.min()) - r, float(x.max()) + r, float(y.min()) - r, float(y.max()) + r)


def _union(boxes: Iterable[View]) -> View:
    """Return the box around some boxes."""
    boxes = iter(boxes)
    box = next(boxes)
    for other in boxes:
        box = box.widened(other)
    return box


def _focus(scene: Scene, boxes: list[View], free: list[int]) -> View:
    """Return the box around the moving bodies, and what there is room for of the static ones."""
    view = _union(boxes[n] for n in free)
    diameter = float(np.median([2 * scene.bodies[n].shape.bounding_radius for n in free]))
    static = [box for n, box in enumerate(boxes) if n not in set(free)]
    near = view.padded(NEAR * diameter, NEAR * diameter)
    for point in [_nearest(box, view) for box in static]:
        if near.holds(point):
            view = view.widened(point)
    largest = max(MORE * view.side, diameter / SMALLEST_BODY)
    for box in sorted(static, key=lambda box: box.side):
        if view.widened(box).side <= largest:
            view = view.widened(box)
    missing = max(0.0, SMALLEST_SIDE * diameter - view.side)
    return view.padded(missing / 2, missing / 2)


def _nearest(box: View, view: View) -> View:
    """Return the point of a box that is nearest to the middle of a view."""
    x = min(max((view.left + view.right) / 2, box.left), box.right)
    y = min(max((view.bottom + view.top) / 2, box.bottom), box.top)
    return View(x, x, y, y)


def _with_margin(view: View) -> View:
    """Return a view with room at its edges, neither too flat nor too slim."""
    side = view.side or 1.0
    view = view.padded(MARGIN * side, MARGIN * side)
    return view.padded(
        max(0.0, SLIMMEST * view.height - view.width) / 2,
        max(0.0, view.width / FLATTEST - view.height) / 2,
    )

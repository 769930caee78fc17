"""A picture of a world in metres, y up, in a window in pixels, y down.

`Camera` is the only place where the one becomes the other.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache

import numpy as np

from lesson_code.engine.core.scene import XY, Body
from lesson_code.formulas.validation import Vector
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.view.pygame.window import (
    BACKGROUND,
    BLUE,
    FADED_INK,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    SMALL_TEXT_SIZE,
    VERMILION,
    YELLOW,
    Colour,
    Place,
    Window,
    blend,
    draw_capsule,
    pygame,
    smooth_disc,
)

FIELD_SIZE = (800, 600)
"""Points: the part of the window that shows the world. A camera says how large a metre is there."""

COLOURS: tuple[Colour, ...] = (SKY, ORANGE, GREEN, PURPLE, YELLOW, VERMILION, BLUE)
"""What bodies are drawn in, in turn. Size and a spoke tell them apart too."""

WALL: Colour = (92, 102, 112)
FLASH: Colour = (255, 255, 255)
GRID: Colour = (36, 43, 52)

PANEL_WIDTH = 280
"""Points: the part beside the field."""

FAR = 10_000.0
"""px: pygame cannot draw at any distance."""

LINE = 22
"""Points: from one line to the next, of read-outs and of a notice."""

NOTICE_WIDTH = 0.8
"""Of the field's width, at most."""

SPOKE = 0.5
"""Of the radius: where a spoke begins."""

LARGEST_SPRITE = 240.0
"""px, radius: a larger disc is drawn anew each time, and not kept."""


@dataclass(frozen=True)
class Camera:
    """What part of the world is seen: its lower left corner, and how large a metre is.

    Attributes
    ----------
    left, bottom : float
        m.
    scale : float
        px/m, > 0.
    height : float
        px, from the top of the window to `bottom`.
    up : int
        1 where y points up, as everywhere but on the billiard table; there it is -1.

    Examples
    --------
    >>> camera = Camera(left=0.0, bottom=0.0, scale=100.0, height=600.0)
    >>> camera.world_to_screen((1.0, 2.0))
    (100.0, 400.0)
    >>> camera.screen_to_world((100.0, 400.0))
    (1.0, 2.0)
    """

    left: float
    bottom: float
    scale: float
    height: float = float(FIELD_SIZE[1])
    up: int = 1

    def fitted(self, size: Place) -> Camera:
        """Return the camera that shows the same part of the world, midmost, in a field of px."""
        larger = min(size[0] / FIELD_SIZE[0], size[1] / FIELD_SIZE[1])
        scale = larger * self.scale
        beside = (size[0] - larger * FIELD_SIZE[0]) / 2
        below = (size[1] - larger * FIELD_SIZE[1]) / 2
        return replace(self, left=self.left - beside / scale, scale=scale, height=size[1] - below)

    def world_to_screen(self, point: XY) -> Place:
        """Return the place of a point of the world in the window, px."""
        x = (point[0] - self.left) * self.scale
        y = self.height - (point[1] - self.bottom) * self.scale * self.up
        return min(max(x, -FAR), FAR), min(max(y, -FAR), FAR)

    def places_of(self, points: Vector) -> Vector:
        """Return the places of many points, shape (N, 2), px; faster than one by one."""
        steps = np.asarray(points, dtype=float) - (self.left, self.bottom)
        corner, scales = np.array((0.0, self.height)), (self.scale, -self.scale * self.up)
        return np.clip(corner + steps * scales, -FAR, FAR)

    def screen_to_world(self, place: Place) -> XY:
        """Return the point of the world that is seen at a place of the window, m."""
        x = place[0] / self.scale + self.left
        return x, self.up * (self.height - place[1]) / self.scale + self.bottom


class Picture:
    """Draws bodies, arrows and marks, given in metres, into the field of a window.

    Parameters
    ----------
    window : Window
        What is drawn in.
    camera : Camera
        What is seen.
    beside : float
        Points: width of what stands at the right of the field.

    Attributes
    ----------
    labels : list of Rect
        px: where labels stand in this frame, so that nothing else is written there.
    """

    def __init__(self, window: Window, camera: Camera, beside: float = PANEL_WIDTH) -> None:
        self.labels: list[pygame.Rect] = []
        self.window, self._shown, self._beside = window, camera, beside
        self.fit()

    def fit(self) -> None:
        """Show the same part of the world in the window as large as it is now."""
        width, height = self._fitted = self.window.surface.get_size()
        self.size = max(width - round(self._beside * self.window.unit), 1), height
        self.camera = self._shown.fitted(self.size)
        larger = self.camera.scale / self._shown.scale
        seen = pygame.Rect(0, 0, round(larger * FIELD_SIZE[0]), round(larger * FIELD_SIZE[1]))
        seen.center = self.size[0] // 2, height // 2
        self.seen = seen

    @property
    def _field(self) -> pygame.Surface:
        """What is drawn on."""
        return self.window.surface

    def clear(self, colour: Colour = BACKGROUND) -> None:
        """Empty the field; what is drawn from now on shows where the camera looks."""
        if self._fitted != self.window.surface.get_size():
            self.fit()
        self.labels.clear()
        self.window.fill(colour, 0, self.size[0])
        self._field.set_clip(self.seen)

    def grid(self, spacing: float) -> None:
        """Draw a grid, its lines `spacing` apart, m."""
        left, bottom = self.camera.screen_to_world((self.seen.left, self.seen.bottom))
        right, top = self.camera.screen_to_world((self.seen.right, self.seen.top))
        for k in range(math.ceil(left / spacing), math.floor(right / spacing) + 1):
            x, _ = self.camera.world_to_screen((k * spacing, 0.0))
            self._field.fill(GRID, (round(x), self.seen.top, 1, self.seen.height))
        for k in range(math.ceil(bottom / spacing), math.floor(top / spacing) + 1):
            _, y = self.camera.world_to_screen((0.0, k * spacing))
            self._field.fill(GRID, (self.seen.left, round(y), self.seen.width, 1))

    def body(self, body: Body, position: XY, angle: float, colour: Colour) -> None:
        """Draw a body of any shape where it is."""
        if isinstance(body.shape, Circle):
            self.disc(position, body.shape.radius, colour, angle)
            return
        points = [moved(point, position, angle) for point in body.shape.outline]
        if isinstance(body.shape, Segment):
            self.capsule(points[0], points[1], body.shape.radius, colour)
        else:
            self.polygon(points, colour)

    def discs(self, centres: Vector, radii: Iterable[float], colours: Iterable[Colour]) -> None:
        """Draw many discs at centres of shape (N, 2), m; faster than one by one."""
        sprites, halves = _discs(self.camera.scale, tuple(radii), tuple(colours))
        corners = (np.round(self.camera.places_of(centres)) - halves).astype(int)
        self._field.blits(list(zip(sprites, corners.tolist(), strict=True)), False)

    def disc(self, centre: XY, radius: float, colour: Colour, angle: float | None = None) -> None:
        """Draw a disc; with an angle it has a spoke, which shows how it turns."""
        if radius * self.camera.scale <= LARGEST_SPRITE:
            self.discs([centre], [radius], [colour])
        else:
            place = self.camera.world_to_screen(centre)
            pygame.draw.circle(self._field, colour, place, radius * self.camera.scale)
        if angle is not None:
            self.spoke(centre, radius, angle, blend(colour, BACKGROUND, 0.65))

    def spoke(self, centre: XY, radius: float, angle: float, colour: Colour) -> None:
        """Draw a mark at a disc's rim; its middle stays free for a number."""
        across, up = radius * math.cos(angle), radius * math.sin(angle)
        inner = centre[0] + SPOKE * across, centre[1] + SPOKE * up
        self.line(inner, (centre[0] + across, centre[1] + up), colour)

    def ring(self, centre: XY, radius: float, colour: Colour, width: int = 2) -> None:
        """Draw a circle line."""
        place, r = self.camera.world_to_screen(centre), radius * self.camera.scale
        pygame.draw.circle(self._field, colour, place, r, self.window.px(width))

    def polygon(self, points: Sequence[XY], colour: Colour) -> None:
        """Draw a filled polygon with smooth edges; an upright rectangle has sharp ones."""
        places = [self.camera.world_to_screen(point) for point in points]
        if is_upright(places):
            xs, ys = zip(*places, strict=True)
            left, top, right, bottom = map(round, (min(xs), min(ys), max(xs), max(ys)))
            self._field.fill(colour, (left, top, right - left, bottom - top))
            return
        for start, end in zip(places, [*places[1:], places[0]], strict=True):
            if start[0] != end[0] and start[1] != end[1]:  # others are smooth, and long ones dear
                pygame.draw.aaline(self._field, colour, start, end)
        pygame.draw.polygon(self._field, colour, places)

    def capsule(self, start: XY, end: XY, radius: float, colour: Colour) -> None:
        """Draw a thick line with round ends, 2 px thick at least; none out of sight."""
        half = max(radius * self.camera.scale, self.window.unit)
        a, b = self.camera.world_to_screen(start), self.camera.world_to_screen(end)
        (left, right), (top, bottom) = (sorted(ends) for ends in zip(a, b, strict=True))
        across = left - half < self.seen.right and right + half > self.seen.left
        if across and top - half < self.seen.bottom and bottom + half > self.seen.top:
            draw_capsule(self._field, a, b, half, colour)

    def line(self, start: XY, end: XY, colour: Colour) -> None:
        """Draw a thin line."""
        a, b = self.camera.world_to_screen(start), self.camera.world_to_screen(end)
        pygame.draw.line(self._field, colour, a, b, self.window.px(2))

    def lines(self, starts: Vector, ends: Vector, colour: Colour) -> None:
        """Draw many thin lines between points of shape (N, 2), m; faster than one by one."""
        width, (firsts, lasts) = self.window.px(2), map(self.camera.places_of, (starts, ends))
        for a, b in zip(firsts.tolist(), lasts.tolist(), strict=True):
            pygame.draw.line(self._field, colour, a, b, width)

    def trail(self, places: Sequence[XY], colour: Colour, ground: Colour = BACKGROUND) -> None:
        """Draw the way that something has come, out of the ground into its colour."""
        if len(places) < 2:
            return
        way, width = self.camera.places_of(np.array(places)).tolist(), self.window.px(2)
        shades = _shades(ground, colour, len(way))
        for start, end, faded in zip(way, way[1:], shades, strict=False):
            pygame.draw.line(self._field, faded, start, end, width)

    def arrow(self, tail: XY, along: XY, colour: Colour, width: float = 3.0) -> None:
        """Draw an arrow from `tail` to `tail` + `along`, m."""
        x, y = self.camera.world_to_screen(tail)
        tip = self.camera.world_to_screen((tail[0] + along[0], tail[1] + along[1]))
        self.window.arrow((x, y), (tip[0] - x, tip[1] - y), colour, width=width)

    def text(
        self,
        words: str,
        point: XY,
        *,
        colour: Colour = INK,
        size: int = SMALL_TEXT_SIZE,
        anchor: str = "center",
    ) -> None:
        """Write a line at a point of the world."""
        place = self.camera.world_to_screen(point)
        self.window.text(words, place, colour=colour, size=size, anchor=anchor)

    def label(self, words: str, point: XY, colour: Colour) -> None:
        """Write a line that begins at a point of the world, on a dark ground, over bodies."""
        x, y = self.camera.world_to_screen(point)
        high = self.window.px(SMALL_TEXT_SIZE)
        box = pygame.Rect(0, 0, self.window.width(words, SMALL_TEXT_SIZE), high)
        box.midleft = round(x), round(y)
        self.labels.append(self._field.fill(BACKGROUND, box.inflate(self.window.px(8), 0)))
        self.window.text(words, (x, y), colour=colour, size=SMALL_TEXT_SIZE, anchor="midleft")

    def notice(self, words: str) -> None:
        """Write words in a box in the middle of the field, over everything; no words, no box."""
        if not words:
            return
        lines = self.window.wrapped(words, NOTICE_WIDTH * self.seen.width)
        x, y = self.seen.centerx, self.seen.top + self.seen.height / 3
        places = [(x, y + self.window.px(LINE) * k) for k in range(len(lines))]
        rim = self.window.px(28), self.window.px(18)

        def write() -> list[pygame.Rect]:
            pairs = zip(lines, places, strict=True)
            return [self.window.text(line, place, anchor="center") for line, place in pairs]

        first, *others = write()
        box = first.unionall(others).inflate(rim)
        pygame.draw.rect(self._field, BACKGROUND, box)
        pygame.draw.rect(self._field, FADED_INK, box, 1)
        write()


def is_upright(corners: Sequence[Place]) -> bool:
    """Return whether corners are those of a rectangle with upright and level sides.

    >>> is_upright([(0, 0), (2, 0), (2, 1), (0, 1)]), is_upright([(0, 0), (2, 0.5), (2, 1), (0, 1)])
    (True, False)
    """
    xs, ys = ({round(corner[axis], 6) for corner in corners} for axis in (0, 1))
    return len(corners) == 4 and len(xs) == len(ys) == 2 and len(set(corners)) == 4


def moved(point: XY, position: XY, angle: float) -> XY:
    """Return a point of a body, given as seen from the body, where it is in the world.

    >>> moved((1.0, 0.0), (5.0, 0.0), 0.0)
    (6.0, 0.0)
    """
    c, s = math.cos(angle), math.sin(angle)
    x, y = point
    return position[0] + c * x - s * y, position[1] + s * x + c * y


@cache
def _shades(ground: Colour, colour: Colour, count: int) -> list[Colour]:
    """Return the colours from a ground to a colour, without the ground."""
    return [blend(ground, colour, k / count) for k in range(1, count)]


@lru_cache(maxsize=16)
def _discs(
    scale: float, radii: tuple[float, ...], colours: tuple[Colour, ...]
) -> tuple[list[pygame.Surface], Vector]:
    """Return the pictures of discs and half of their widths, (N, 1) px: mostly as a frame ago."""
    pairs = zip(radii, colours, strict=True)
    sprites = [_disc(round(2 * radius * scale) / 2, colour) for radius, colour in pairs]
    halves = [sprite.get_width() // 2 for sprite in sprites]
    return sprites, np.reshape(halves, (-1, 1))


@cache
def _disc(radius: float, colour: Colour) -> pygame.Surface:
    """Return the picture of a disc, painted once; radius in px."""
    sprite = smooth_disc(max(radius, 1.0), colour).convert_alpha()
    sprite.set_alpha(255, pygame.RLEACCEL)  # three times faster: only its rim is mixed
    return sprite

"""The scenes of chapter 11, of discs and polygons: a demo, a pool break and a shot of billiards.

The demo is that of the lesson that this course grew out of.
"""

from __future__ import annotations

import math
from dataclasses import replace

from lesson_code.chapters.billiards.rules import LAUNCH, TABLE
from lesson_code.engine.core.scene import XY, Body, Material, Scene
from lesson_code.evidence.scenes.discs import LENGTH, WIDTH, rack_break
from lesson_code.geometry import Circle, Polygon

ROOM = (8.0, 6.0)
"""m."""

FRICTION = 0.3

DISCS: tuple[tuple[XY, XY], ...] = (
    ((1, 1), (2, 1)),
    ((3, 1.5), (-1, 2)),
    ((5, 1), (1, 2)),
    ((7, 2), (-2, -1)),
    ((1.5, 4), (2, -2)),
)
"""Position, m, and velocity, m/s."""

PIXELS_PER_METRE = 200.0
"""Makes the billiards a table of 3 m by 2 m."""


def demo(gravity: XY = (0.0, 0.0), restitution: float = 0.9) -> Scene:
    """Return five discs, a triangle and a square in a room; the first four bodies are its walls."""
    surface = Material(restitution, FRICTION)
    discs = [
        Body(Circle(0.3 + 0.05 * n), mass=1.0 + n, position=p, velocity=v, material=surface)
        for n, (p, v) in enumerate(DISCS)
    ]
    triangle = Polygon([(-0.7, -0.5), (0.7, -0.5), (0.0, 0.8)])
    others = [
        Body(triangle, mass=2.0, position=(4, 4), velocity=(-1, -1), material=surface),
        Body(
            Polygon.box(1, 1),
            mass=3.0,
            position=(6.5, 4.5),
            angular_velocity=1.5,
            material=surface,
        ),
    ]
    return Scene([*walls(*ROOM, surface), *discs, *others], gravity)


def pool_break() -> Scene:
    """Return the pool break of section 7 in a room; the first four bodies are its walls.

    >>> len(pool_break().bodies)
    20
    """
    cue, *rack = rack_break(0.95).bodies[4:]
    balls = [
        replace(ball, position=(ball.position[0] + LENGTH / 2, ball.position[1] + WIDTH / 2))
        for ball in (cue, *rack)
    ]
    return Scene([*walls(LENGTH, WIDTH, cue.material), *balls])


def billiards() -> Scene:
    """Return the billiards of chapter 03 and its first shot, in metres and with y up.

    The bumper is a box between two discs; they come first, as in the program.

    >>> [type(body.shape).__name__ for body in billiards().bodies]
    ['Circle', 'Circle', 'Polygon', 'Polygon', 'Polygon', 'Polygon', 'Polygon', 'Circle']
    """
    rubber = Material(TABLE.restitution, 0.0)
    ends = [_metres(*TABLE.bumper_start), _metres(*TABLE.bumper_end)]
    half, radius = TABLE.bumper_half_thickness / PIXELS_PER_METRE, TABLE.radius / PIXELS_PER_METRE
    (x1, y1), (x2, y2) = ends
    bumper = [Body(Circle(half), position=end, material=rubber) for end in ends]
    side = Body(
        Polygon.box(math.dist(*ends), 2 * half),
        position=((x1 + x2) / 2, (y1 + y2) / 2),
        angle=math.atan2(y2 - y1, x2 - x1),
        material=rubber,
    )
    place, (vx, vy) = LAUNCH
    velocity = vx / PIXELS_PER_METRE, -vy / PIXELS_PER_METRE
    ball = Body(
        Circle(radius), mass=1.0, position=_metres(*place), velocity=velocity, material=rubber
    )
    return Scene([*bumper, side, *walls(*_metres(TABLE.width, 0.0), rubber), ball])


def _metres(x: float, y: float) -> XY:
    """Return a place of the billiards, px, y down, in metres with y up."""
    return x / PIXELS_PER_METRE, (TABLE.height - y) / PIXELS_PER_METRE


def walls(width: float, height: float, surface: Material) -> list[Body]:
    """Return four walls, 1 m thick, around a room whose lower left corner is the origin."""
    across, along = Polygon.box(width + 2, 1), Polygon.box(1, height + 2)
    placed = [
        (across, (width / 2, -0.5)),
        (across, (width / 2, height + 0.5)),
        (along, (-0.5, height / 2)),
        (along, (width + 0.5, height / 2)),
    ]
    return [Body(shape, position=place, material=surface) for shape, place in placed]

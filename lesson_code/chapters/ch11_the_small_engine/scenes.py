"""The scene of chapter 11: the demo of the lesson that this course grew out of."""

from __future__ import annotations

from lesson_code.engine.core.scene import XY, Body, Material, Scene
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

"""Scenes with a known answer: bodies that slide, roll, tip, lean and stand.

Each is built once here, for the notebooks and for the tests. Bodies touch the ground from the
start. Body 0 is the ground; where there is one more body, it is body 1.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

GRAVITY = 10.0
"""m/s^2, downwards: a round number, so that results can be checked by hand."""

HALF_LENGTH = 100.0
"""m, length of the ground: no body reaches its end."""


def level_ground() -> Body:
    """Return a level floor at y = 0. It leaves restitution and friction to what stands on it."""
    return incline(0.0)


def incline(angle: float) -> Body:
    """Return a plane through the origin that rises to the right at an angle, rad."""
    return Body(Segment((-HALF_LENGTH, 0), (HALF_LENGTH, 0)), angle=angle)


def on_incline(shape: Shape, angle: float, friction: float, height: float) -> Scene:
    """Return a body of 1 kg at rest on an incline, its centre `height` above the surface, m."""
    body = Body(
        shape,
        position=(-height * math.sin(angle), height * math.cos(angle)),
        angle=angle,
        mass=1.0,
        material=Material(0.0, friction),
    )
    return Scene([incline(angle), body], gravity=(0, -GRAVITY))


def box_on_incline(angle: float, friction: float, width: float = 1.0, height: float = 1.0) -> Scene:
    """Return a box that slides, stands or tips over."""
    return on_incline(Polygon.box(width, height), angle, friction, height / 2)


def disc_on_incline(angle: float, friction: float, radius: float = 1.0) -> Scene:
    """Return a disc that rolls or slips down an incline."""
    return on_incline(Circle(radius), angle, friction, radius)


def sliding_disc(speed: float, friction: float, inertia_ratio: float = 0.5) -> Scene:
    """Return a disc of 1 m and 1 kg that slides on a level floor without turning.

    Its moment of inertia is `inertia_ratio` m r^2: 1/2 for a disc, 1 for a hoop.
    """
    disc = Body(
        Circle(1.0),
        position=(0, 1),
        velocity=(speed, 0),
        mass=1.0,
        inertia=inertia_ratio,
        material=Material(0.0, friction),
    )
    return Scene([level_ground(), disc], gravity=(0, -GRAVITY))


def disc_in_wedge(left_angle: float, right_angle: float) -> Scene:
    """Return a smooth disc of 1 m and 1 kg between two walls; body 2 is the disc.

    Each wall rises from the origin, at its angle to the horizontal, rad.
    """
    length = 10.0
    left = (-length * math.cos(left_angle), length * math.sin(left_angle))
    right = (length * math.cos(right_angle), length * math.sin(right_angle))
    # The centre is 1 m from both walls: on the line that halves the angle between them.
    half = (math.pi - left_angle - right_angle) / 2
    direction = right_angle + half
    centre = (math.cos(direction) / math.sin(half), math.sin(direction) / math.sin(half))
    return Scene(
        [
            Body(Segment(left, (0, 0))),
            Body(Segment((0, 0), right)),
            Body(Circle(1.0), position=centre, mass=1.0),
        ],
        gravity=(0, -GRAVITY),
    )


def ball_on_plank(arm: float, restitution: float = 1.0) -> Scene:
    """Return a plank of 4 m by 0.2 m at rest, and a ball that falls onto it at 2 m/s.

    The ball is body 1; it comes down `arm` to the right of the plank's middle, m. Nothing else
    acts on the two.
    """
    surface = Material(restitution, 0.0)
    return Scene(
        [
            Body(Polygon.box(4.0, 0.2), mass=1.0, material=surface),
            Body(Circle(0.2), position=(arm, 0.301), velocity=(0, -2), mass=1.0, material=surface),
        ]
    )


def box_landing_flat(width: float, height: float, speed: float, restitution: float) -> Scene:
    """Return a box of 1 kg that comes down flat on a level floor, without gravity."""
    box = Body(
        Polygon.box(width, height),
        position=(0, height / 2),
        velocity=(0, -speed),
        mass=1.0,
        material=Material(restitution, 0.0),
    )
    return Scene([level_ground(), box])


def box_stack(count: int, friction: float = 0.6) -> Scene:
    """Return boxes of 1 m and 1 kg, one on the other."""
    surface = Material(0.0, friction)
    boxes = [
        Body(Polygon.box(1, 1), position=(0, 0.5 + n), mass=1.0, material=surface)
        for n in range(count)
    ]
    return Scene([level_ground(), *boxes], gravity=(0, -GRAVITY))


def box_pyramid(rows: int, friction: float = 0.6, gap: float = 0.1, overlap: float = 0.0) -> Scene:
    """Return boxes of 1 m and 1 kg in rows, each one shorter than the one below.

    Boxes in a row are `gap` apart, m, and each row stands in what is below by `overlap`, m.
    """
    surface = Material(0.0, friction)
    boxes = [
        Body(
            Polygon.box(1, 1),
            position=((n - (rows - row - 1) / 2) * (1 + gap), 0.5 + row - (row + 1) * overlap),
            mass=1.0,
            material=surface,
        )
        for row in range(rows)
        for n in range(rows - row)
    ]
    return Scene([level_ground(), *boxes], gravity=(0, -GRAVITY))

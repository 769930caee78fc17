"""Scenes of discs: rows, a shot between two balls, and a pool table with its break.

The table has the size of a 9-foot one, and its balls are pool balls, but smooth: without
friction and cloth they go on for ever. Each cushion is a segment whose body is at its middle.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.geometry.shapes import Circle, Segment

LENGTH, WIDTH = 2.54, 1.27
"""m: the playing surface between the cushions; its middle is the origin."""

BALL_RADIUS, BALL_MASS = 0.0286, 0.17
"""m and kg: a pool ball."""

CUSHIONS = 4
"""How many cushions come before the first ball in a table's scene."""


def row_of_discs(count: int, gap: float, *, last_first: bool = False) -> Scene:
    """Return a row of equal elastic discs, 1 kg and 1 m wide; the left one moves at 1 m/s.

    Parameters
    ----------
    count : int
        How many.
    gap : float
        Between neighbours, m; negative for an overlap.
    last_first : bool
        Whether the scene lists the discs from right to left.

    Examples
    --------
    >>> [body.position[0] for body in row_of_discs(3, gap=0.5).bodies]
    [0.0, 1.5, 3.0]
    """
    elastic = Material(restitution=1.0)
    discs = [
        Body(
            Circle(0.5),
            mass=1.0,
            position=((1 + gap) * place, 0.0),
            velocity=(1.0, 0.0) if place == 0 else (0.0, 0.0),
            material=elastic,
        )
        for place in range(count)
    ]
    return Scene(discs[::-1] if last_first else discs)


def cue_between_two(*, upper_first: bool, overlap: float = 1e-9) -> Scene:
    """Return a cue ball that touches two touching balls and moves between them at 1 m/s.

    All are elastic, of 1 kg and 1 m wide. The cue ball is the first body; the two others stand
    above and below its path.

    Parameters
    ----------
    upper_first : bool
        Which of the two the scene lists first: the only thing that is not symmetric.
    overlap : float
        Of the cue ball with each of the two, m, > 0: without it there would be no contact yet.

    Examples
    --------
    >>> cue, first, second = cue_between_two(upper_first=True).bodies
    >>> first.position, second.position
    ((0.0, 0.5), (0.0, -0.5))
    """
    elastic = Material(restitution=1.0)
    cue = (-math.sqrt((1 - overlap) ** 2 - 0.25), 0.0)
    others = [(0.0, 0.5), (0.0, -0.5)]
    places = [cue, *(others if upper_first else others[::-1])]
    return Scene(
        Body(
            Circle(0.5),
            mass=1.0,
            position=place,
            velocity=(1.0, 0.0) if place is cue else (0.0, 0.0),
            material=elastic,
        )
        for place in places
    )


def rack_break(restitution: float, *, speed: float = 6.0, gap: float = 1e-3) -> Scene:
    """Return a table with fifteen balls in a triangle, and a cue ball on its way to them.

    Parameters
    ----------
    restitution : float
        Of balls and cushions, 0 to 1.
    speed : float
        Of the cue ball, m/s.
    gap : float
        Between neighbours in the triangle, m.

    Examples
    --------
    >>> len(rack_break(0.95).bodies)
    20
    """
    material = Material(restitution=restitution)
    pitch = 2 * BALL_RADIUS + gap
    triangle = [
        (LENGTH / 4 + row * pitch * math.sqrt(0.75), (place - row / 2) * pitch)
        for row in range(5)
        for place in range(row + 1)
    ]
    cue = pool_ball((-LENGTH / 4, 0.0), (speed, 0.0), material)
    return Scene(
        [*cushions(material), cue, *(pool_ball(place, (0.0, 0.0), material) for place in triangle)]
    )


def pool_ball(
    place: tuple[float, float], velocity: tuple[float, float], material: Material
) -> Body:
    """Return a pool ball."""
    return Body(
        Circle(BALL_RADIUS), mass=BALL_MASS, position=place, velocity=velocity, material=material
    )


def cushions(material: Material) -> list[Body]:
    """Return the bottom, top, left and right cushion."""
    x, y = LENGTH / 2, WIDTH / 2
    across, along = Segment((-x, 0.0), (x, 0.0)), Segment((0.0, -y), (0.0, y))
    middles = ((across, (0.0, -y)), (across, (0.0, y)), (along, (-x, 0.0)), (along, (x, 0.0)))
    return [Body(shape, position=middle, material=material) for shape, middle in middles]

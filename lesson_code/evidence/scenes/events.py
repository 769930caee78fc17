"""Scenes of events: fast balls at a thin wall, and discs that can be simulated exactly.

Unless stated otherwise everything is elastic and smooth, and gravity acts only on the ball that
bounces to rest. Walls come first in a scene: :data:`WALLS` of them where there is a box.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene, scene_at
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.reference.closed_forms import ball_in_box

ELASTIC = Material(restitution=1.0)

GRAVITY = 10.0
"""m/s^2, downwards: a round number, so that results can be checked by hand."""

WALLS = 4
"""Segments that make a box: bottom, top, left, right."""

ROD_ARM = 1.5
"""m: from the middle of a turning rod to the ball that it hits."""

BOX = (4.0, 3.0)
"""m: width and height of the box with one ball in it; its lower left corner is the origin."""

BALL_START, BALL_VELOCITY, BALL_RADIUS = (1.1, 0.9), (2.3, 1.1), 0.25
"""m, m/s, m: the ball in that box. Its velocities are in no simple ratio."""

BLOCK_RADIUS = 0.5
"""m: of the discs that stand for the two blocks."""


# Fast balls at a thin wall


def balls_at_wall(
    speed: float, *, count: int, dt: float, radius: float = 0.1, thickness: float = 0.1
) -> Scene:
    """Return balls that fly straight at a wall, each a little further away than the one before.

    The wall is body 0 and stands on x = 0. The starting distances cover the path of one step in
    `count` equal parts, so that all phases of a step occur: after n steps each ball is at a
    different place relative to the wall.

    Parameters
    ----------
    speed : float
        Of the balls, along x, m/s, > 0.
    count : int
        Of the balls.
    dt : float
        The intended time step, s, > 0. radius, thickness : float Of a ball and of the wall, m, > 0.

    Examples
    --------
    >>> wall, *balls = balls_at_wall(10.0, count=4, dt=0.1, radius=0.5, thickness=1.0).bodies
    >>> [ball.position for ball in balls]
    [(-2.125, 0.0), (-2.375, 1.5), (-2.625, 3.0), (-2.875, 4.5)]
    """
    step, pitch = speed * dt, 3 * radius
    wall = Segment((0, -pitch), (0, count * pitch), radius=thickness / 2)
    before = 2 * (radius + thickness / 2)
    balls = [
        Body(
            Circle(radius),
            mass=1.0,
            position=(-before - (n + 0.5) / count * step, n * pitch),
            velocity=(speed, 0.0),
            material=ELASTIC,
        )
        for n in range(count)
    ]
    return Scene([Body(wall, material=ELASTIC), *balls])


def share_beyond(run: Run) -> float:
    """Return how many of the balls at a wall are beyond it at the end, 0 to 1."""
    return float(np.mean(run.positions[-1, 1:, 0] > 0))


def turning_rod(turning: float, *, phase: float, dt: float) -> Scene:
    """Return a rod that rotates about its middle, and a ball at rest that it will hit.

    The rod is body 0: nothing can push it, and it is 4 m long and 0.1 m thick. The ball has a
    radius of 0.1 m, and its centre lies 1.5 m from the rod's.

    Parameters
    ----------
    turning : float
        Of the rod, rad/s, > 0.
    phase : float
        Part of a step, 0 to 1, that the rod starts further back.
    dt : float
        The step that is meant, s, > 0.
    """
    angle = math.pi / 2 - 0.3 - phase * turning * dt
    rod = Segment((-2, 0), (2, 0), radius=0.05)
    return Scene(
        [
            Body(rod, angle=angle, angular_velocity=turning, material=ELASTIC),
            Body(Circle(0.1), mass=1.0, position=(0, ROD_ARM), material=ELASTIC),
        ]
    )


# Two blocks and a wall


def two_blocks(mass_ratio: float) -> Scene:
    """Return a wall, a block of 1 kg at rest in front of it, and a block approaching at 1 m/s.

    The blocks are discs on a line. Body 0 is the wall, body 1 the light block.

    Parameters
    ----------
    mass_ratio : float
        Mass of the other block, kg, > 0.
    """
    block = Circle(BLOCK_RADIUS)
    return Scene(
        [
            Body(Segment((0, -2), (0, 2)), material=ELASTIC),
            Body(block, mass=1.0, position=(1.5, 0), material=ELASTIC),
            Body(block, mass=mass_ratio, position=(3.5, 0), velocity=(-1, 0), material=ELASTIC),
        ]
    )


# A ball in a box


def box(width: float, height: float, material: Material = ELASTIC) -> list[Body]:
    """Return the four walls of a box whose lower left corner is the origin."""
    ends = (
        ((0, 0), (width, 0)),
        ((0, height), (width, height)),
        ((0, 0), (0, height)),
        ((width, 0), (width, height)),
    )
    return [Body(Segment(start, end), material=material) for start, end in ends]


def ball_in_a_box() -> Scene:
    """Return one ball in a box of 4 m by 3 m; it is body 4."""
    ball = Body(
        Circle(BALL_RADIUS),
        mass=1.0,
        position=BALL_START,
        velocity=BALL_VELOCITY,
        material=ELASTIC,
    )
    return Scene([*box(*BOX), ball])


def places_in_the_box(times: Any) -> Any:
    """Return where the ball in the box should be at some times, s: m, shape (F, 2).

    It is the closed form, worked out in fractions.

    Examples
    --------
    >>> places_in_the_box([0.0, 1.0]).tolist()
    [[1.1, 0.9], [3.4, 2.0]]
    """
    ball = BALL_START, BALL_VELOCITY, BALL_RADIUS
    return np.array([ball_in_box(*ball, *BOX, time=time)[0] for time in np.array(times).tolist()])


def error_in_the_box(run: Run) -> Any:
    """Return how far the ball in the box is from where it should be, m, shape (F,)."""
    return np.hypot(*(run.positions[:, WALLS] - places_in_the_box(run.times)).T)


# A ball that bounces to rest


def bouncing_to_rest(restitution: float, height: float = 1.0) -> Scene:
    """Return a level floor, and a ball, 1 m wide, whose lowest point is `height` above it, m."""
    material = Material(restitution=restitution)
    floor = Body(Segment((-5, 0), (5, 0)), material=material)
    ball = Body(Circle(0.5), mass=1.0, position=(0, 0.5 + height), material=material)
    return Scene([floor, ball], gravity=(0, -GRAVITY))


# Backwards in time


def turned_back(run: Run) -> Scene:
    """Return the scene at the end of a run, with every velocity reversed.

    Examples
    --------
    >>> from lesson_code import simulate
    >>> run = simulate(two_blocks(3.0), 0.5)
    >>> turned_back(run).bodies[2].velocity[0]
    1.0
    """
    back = -run.velocities[-1], -run.angular_velocities[-1]
    states = np.column_stack([run.positions[-1], run.angles[-1], *back])
    return scene_at(run.scene, states.tolist())


def error_after_return(run: Run, back: Run) -> float:
    """Return the largest distance of a body from its start after a run and its reversal, m."""
    return float(np.hypot(*(back.positions[-1] - run.positions[0]).T).max())

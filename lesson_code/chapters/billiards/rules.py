"""The table of the cushion-bounce billiards: one ball, four walls, one bumper, and no window.

This exercise alone counts in pixels and has y pointing down, as the screen does; everything else
in the workbook is in SI units with y up. Walls and bumper bounce through the same
:func:`lesson_code.formulas.bounce`, because that formula only asks for a normal.

========  ==========================================================  =====
symbol    meaning                                                     unit
========  ==========================================================  =====
p, v      position and velocity of the ball's centre                  px, px/s
n         unit normal of a contact, from the wall to the ball         -
depth     how far the ball overlaps the wall, > 0                     px
========  ==========================================================  =====
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random
from typing import Any

import numpy as np

from lesson_code.formulas import bounce
from lesson_code.formulas.arithmetic import dot, whole_parts
from lesson_code.formulas.validation import (
    Vector,
    non_negative,
    one_number,
    one_vector,
    unit_vector,
)
from lesson_code.geometry.closest_point import circle_against_segment

TIME_STEP = 1 / 60
"""s: one frame of the window. Steps of another length give another rounding, so it is fixed."""

SAFETY = 0.9
"""Keeps the ball's centre off the bumper's middle line, where no normal is defined."""


@dataclass(frozen=True)
class Table:
    """Sizes and places on the table, px, y down; the corner at the top left is (0, 0).

    The bumper is a capsule: all points within `bumper_half_thickness` of the segment from
    `bumper_start` to `bumper_end`. It has two sides and two round ends, and all of them bounce.
    """

    width: float = 600.0
    height: float = 400.0
    radius: float = 12.0
    restitution: float = 0.95
    bumper_start: tuple[float, float] = (260.0, 160.0)
    bumper_end: tuple[float, float] = (340.0, 240.0)
    bumper_half_thickness: float = 8.0

    @property
    def bumper_normal(self) -> tuple[float, float]:
        """Return the unit normal of the bumper's upper right side: (sin 45, -cos 45)."""
        (x1, y1), (x2, y2) = self.bumper_start, self.bumper_end
        length = math.hypot(x2 - x1, y2 - y1)
        return (y2 - y1) / length, -(x2 - x1) / length

    @property
    def walls(self) -> tuple[tuple[str, tuple[float, float], tuple[float, float]], ...]:
        """Return name, inward unit normal and one point of each wall."""
        return (
            ("top", (0.0, 1.0), (0.0, 0.0)),
            ("bottom", (0.0, -1.0), (0.0, self.height)),
            ("left", (1.0, 0.0), (0.0, 0.0)),
            ("right", (-1.0, 0.0), (self.width, 0.0)),
        )


TABLE = Table()
"""The one table of this exercise; the window draws it and the functions below ask it."""

CUSHIONS = (*(name for name, _, _ in TABLE.walls), "bumper")
"""The names that `hits` may hold."""

MAX_LAUNCH_SPEED = SAFETY * (TABLE.radius + TABLE.bumper_half_thickness) / TIME_STEP
"""px/s (1080): the centre starts a step at least radius + half thickness away from the bumper's
middle line. As long as one step is shorter than that, it cannot come out on the other side."""

LAUNCH = ((80.0, 80.0), (360.0, -280.0))
"""Position and velocity of the first shot: it hits all four walls and the bumper in 3.83 s."""


def first_shot(seed: int) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return :data:`LAUNCH` for seed 0; for any other its direction is drawn by lot.

    >>> first_shot(0) == LAUNCH, first_shot(1) == first_shot(1) != first_shot(2)
    (True, True)
    """
    position, velocity = LAUNCH
    if seed == 0:
        return LAUNCH
    heading = Random(seed).uniform(0, 2 * math.pi)  # noqa: S311 - a game, no secret
    speed = math.hypot(*velocity)
    return position, (speed * math.cos(heading), speed * math.sin(heading))


def wall_contacts(position: Vector) -> list[tuple[str, Any, float]]:
    """Return every wall that the ball overlaps; a corner gives two.

    depth = radius - (p - q) . n,  q any point of the wall

    Parameters
    ----------
    position : array_like, shape (2,)
        Centre of the ball, px, y down.

    Returns
    -------
    list of (name, normal, depth)
        In the order top, bottom, left, right: the wall's name, its inward unit normal, shape
        (2,), and the overlap in px, > 0. Empty when the ball touches nothing: touching is not
        overlapping.

    Raises
    ------
    ValueError
        The position is not finite or its shape is not (2,).

    Examples
    --------
    >>> wall_contacts((5, 200))
    [('left', array([1., 0.]), 7.0)]
    >>> [name for name, normal, depth in wall_contacts((5, 5))]
    ['top', 'left']
    """
    p = one_vector("position", position)
    contacts = []
    for name, normal, point in TABLE.walls:
        depth = float(TABLE.radius - dot(p - point, normal))
        if depth > 0:
            contacts.append((name, np.array(normal), depth))
    return contacts


def bumper_contact(position: Vector) -> tuple[Any, float] | None:
    """Return how the ball overlaps the bumper: the closest point of its middle line decides.

    Parameters
    ----------
    position : array_like, shape (2,)
        Centre of the ball, px, y down.

    Returns
    -------
    (normal, depth) or None
        The unit normal from the bumper to the ball, shape (2,), and the overlap in px, > 0;
        None when they do not overlap.

    Raises
    ------
    ValueError
        The position is not finite or its shape is not (2,).

    References
    ----------
    :func:`lesson_code.geometry.closest_point.circle_against_segment`.

    Examples
    --------
    Left of the upper end, 15 px from it: 12 + 8 - 15 = 5 px too near.

    >>> bumper_contact((245, 160))
    (array([-1.,  0.]), 5.0)
    >>> bumper_contact((100, 200)) is None
    True
    """
    return circle_against_segment(
        one_vector("position", position),
        TABLE.radius,
        TABLE.bumper_start,
        TABLE.bumper_end,
        TABLE.bumper_half_thickness,
    )


def resolve(position: Vector, velocity: Vector, normal: Vector, depth: float) -> tuple[Any, Any]:
    """Return position and velocity after one contact: separate first, then bounce.

    p' = p + depth n,   v' = bounce(v, n, restitution): unchanged if v . n >= 0

    Parameters
    ----------
    position, velocity : array_like, shape (2,)
        px and px/s, y down.
    normal : array_like, shape (2,)
        Unit normal from the wall to the ball, length 1 within 1e-9.
    depth : float
        Overlap, px, >= 0.

    Returns
    -------
    (position, velocity) : tuple of ndarray, shape (2,)
        The ball just touches; it moves away from the wall or along it.

    Raises
    ------
    ValueError
        A vector is not finite or its shape is not (2,), the normal is not unit, or the depth is
        negative.

    Examples
    --------
    >>> resolve(position=(5, 200), velocity=(-100, 30), normal=(1, 0), depth=7)
    (array([ 12., 200.]), array([95., 30.]))
    >>> resolve(position=(5, 200), velocity=(100, 30), normal=(1, 0), depth=7)
    (array([ 12., 200.]), array([100.,  30.]))
    """
    p, v = one_vector("position", position), one_vector("velocity", velocity)
    n = one_vector("normal", unit_vector("normal", normal))
    return p + one_number("depth", depth, non_negative) * n, bounce(v, n, TABLE.restitution)


def step(position: Vector, velocity: Vector, dt: float = TIME_STEP) -> tuple[Any, Any, list[str]]:
    """Return the ball after one step: move, then the bumper, then the walls.

    The walls come last, so that a push from the bumper never leaves the ball outside. Both walls
    of a corner are found before either is resolved, so both reflect in the same step.

    Parameters
    ----------
    position, velocity : array_like, shape (2,)
        px and px/s, y down.
    dt : float
        Length of the step, s, >= 0. Up to :data:`MAX_LAUNCH_SPEED` the ball cannot pass through
        the bumper in a step of :data:`TIME_STEP` or less.

    Returns
    -------
    (position, velocity, hits)
        Both of shape (2,), and the names of the cushions that turned the ball round, in the
        order in which they were resolved. A contact that the ball was already leaving is no hit.

    Raises
    ------
    ValueError
        A vector is not finite or its shape is not (2,), or dt is negative.

    Examples
    --------
    >>> step(position=(20, 200), velocity=(-600, 0))
    (array([ 12., 200.]), array([570.,   0.]), ['left'])
    """
    p, v = one_vector("position", position), one_vector("velocity", velocity)
    p = p + v * one_number("dt", dt, non_negative)
    hits = []
    for contacts in (_bumper_contacts, wall_contacts):
        for name, normal, depth in contacts(p):
            if dot(v, normal) < 0:
                hits.append(name)
            p, v = resolve(p, v, normal, depth)
    return p, v, hits


def advance(
    position: Vector, velocity: Vector, elapsed: float
) -> tuple[Any, Any, list[str], float]:
    """Return the ball after as many whole steps as fit into the elapsed time.

    The step is always :data:`TIME_STEP`, however long the frame was. What is left over is less
    than a step; the caller adds it to the next frame. So the path does not depend on the frames.

    Parameters
    ----------
    position, velocity : array_like, shape (2,)
        px and px/s, y down.
    elapsed : float
        s, >= 0. Each 1/60 s of it costs one step: a caller clamps a long pause.

    Returns
    -------
    (position, velocity, hits, left_over)
        As for :func:`step`, the hits of all steps in order, and the rest of the time, s, >= 0.

    Raises
    ------
    ValueError
        A vector is not finite or its shape is not (2,), or the time is negative.

    References
    ----------
    Fiedler, Fix Your Timestep! (2004).

    Examples
    --------
    >>> p, v, hits, left_over = advance((300, 80), (60, 0), elapsed=0.11)
    >>> p, hits, round(left_over, 6)
    (array([306.,  80.]), [], 0.01)
    """
    p, v = one_vector("position", position), one_vector("velocity", velocity)
    elapsed = one_number("elapsed", elapsed, non_negative)
    steps = whole_parts(elapsed, TIME_STEP)
    hits: list[str] = []
    for _ in range(steps):
        p, v, new_hits = step(p, v, TIME_STEP)
        hits += new_hits
    return p, v, hits, max(0.0, elapsed - steps * TIME_STEP)


def _bumper_contacts(position: Vector) -> list[tuple[str, Any, float]]:
    """Return the bumper's contact in the form of :func:`wall_contacts`."""
    contact = bumper_contact(position)
    return [] if contact is None else [("bumper", *contact)]

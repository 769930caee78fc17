"""One impact, set up so that pymunk's answer is the analytic one.

How to ask pymunk for the answer to one impact: let the bodies overlap, switch gravity off and
make one step. In that step pymunk first moves the bodies and then resolves the contact at the
*moved* positions, so a formula must be given the moved positions too. The resulting velocities
contain no position correction. ``tests/reference/test_pymunk_conventions.py`` measures all of this
on the installed version.

pymunk multiplies the restitution and friction of the two shapes; here one shape carries the
pair's value and the other carries 1.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pymunk

from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.formulas.validation import (
    Vector,
    finite,
    mass,
    non_negative,
    not_both_immovable,
    one_vector,
    positive,
    unit_interval,
)
from lesson_code.geometry.closest_point import segment_ends

STEP = 1e-9
"""s: so short that a body moves by less than 1e-6 m at 1,000 m/s within one step."""

LONGEST_MOVE = 1e-6
"""m: the step is shortened further where a body is so fast that it would move by more."""

OVERLAP = 1e-2
"""m: for bodies of radius 1 m, far more than they move in a step, far less than pymunk's slop."""

BALL, WALL = 1, 2
"""Collision types: a handler for (BALL, WALL) is told the ball first, whatever was added first."""


@dataclass(frozen=True)
class SegmentBounce:
    """The result of one pymunk step of a ball against a wall.

    Attributes
    ----------
    velocity : ndarray, shape (2,)
        Velocity of the ball after the step, m/s.
    normal : ndarray, shape (2,), or None
        Unit normal from the wall to the ball; None when there was no contact.
    moved_position : ndarray, shape (2,)
        Where the ball was when the contact was resolved, m: p + v dt.
    """

    velocity: Any
    normal: Any | None
    moved_position: Any


def collide_on_a_line(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """Return the velocities of two discs after pymunk has let them collide head on.

    The first disc is on the left, and the two overlap by less than pymunk's slop.

    Parameters
    ----------
    m1, m2 : float
        Masses, kg, > 0. One may be ``math.inf``: a kinematic body, which keeps its velocity.
    v1, v2 : float
        Velocities before, m/s, positive to the right; the discs must approach, v1 > v2.
    restitution : float
        Of the pair, 0 to 1.

    Returns
    -------
    (v1', v2') : tuple of float
        Velocities after, m/s.

    Raises
    ------
    ValueError
        A mass is not > 0 or both are infinite, a velocity is not finite, the restitution lies
        outside [0, 1], or the discs do not approach.

    References
    ----------
    Munk2D, src/cpArbiter.c: cpArbiterPreStep and cpArbiterApplyImpulse.

    Examples
    --------
    >>> v1_after, v2_after = collide_on_a_line(m1=1, v1=2, m2=3, v2=-1, restitution=0.7)
    >>> round(v1_after, 12), round(v2_after, 12)
    (-1.825, 0.275)
    """
    not_both_immovable({"m1": mass("m1", m1), "m2": mass("m2", m2)})
    v1, v2 = float(finite("v1", v1)), float(finite("v2", v2))
    e = float(unit_interval("restitution", restitution))
    if not v1 > v2:
        raise ValueError(f"v1 must be > v2: the discs must approach, got v1 = {v1} and v2 = {v2}")
    space = pymunk.Space()
    left = _disc(space, m1, (-1.0, 0.0), (v1, 0.0), elasticity=e)
    right = _disc(space, m2, (1.0 - OVERLAP, 0.0), (v2, 0.0), elasticity=1.0)
    space.step(min(STEP, LONGEST_MOVE / max(abs(v1), abs(v2))))
    return left.velocity.x, right.velocity.x


def bounce_off_segment(
    position: Vector,
    velocity: Vector,
    radius: float,
    start: Vector,
    end: Vector,
    half_thickness: float,
    restitution: float,
    friction: float = 0.0,
    dt: float = STEP,
) -> SegmentBounce:
    """Return the result of one pymunk step for a ball that cannot spin, at a fixed wall.

    Parameters
    ----------
    position, velocity : array_like, shape (2,)
        Centre of the ball, m, and its velocity, m/s, before the step.
    radius : float
        Of the ball, m, > 0.
    start, end : array_like, shape (2,)
        Ends of the wall's middle line, m; they must differ.
    half_thickness : float
        Distance from the middle line to the wall's surface, m, >= 0.
    restitution : float
        Of the pair, 0 to 1.
    friction : float
        Friction coefficient of the pair, >= 0.
    dt : float
        The step, s, > 0.

    Returns
    -------
    SegmentBounce
        Velocity, normal (wall to ball) and the moved position that they belong to.

    Raises
    ------
    ValueError
        A component is not finite, a shape is not (2,), the segment has no length, or a number
        lies outside its range.

    References
    ----------
    Munk2D, src/cpSpaceStep.c: cpSpaceStep; src/cpCollision.c: CircleToSegment.

    Examples
    --------
    >>> after = bounce_off_segment((0, 0.9), (3, -4), 1.0, (-5, 0), (5, 0), 0.0, restitution=0.5)
    >>> after.velocity.round(12), after.normal.round(12) + 0.0
    (array([3., 2.]), array([0., 1.]))
    """
    p, v = one_vector("position", position), one_vector("velocity", velocity)
    a, b = segment_ends(start, end)
    r, h = positive("radius", radius), non_negative("half_thickness", half_thickness)
    e, mu = unit_interval("restitution", restitution), non_negative("friction", friction)
    space = pymunk.Space()
    ball = _disc(space, 1.0, _xy(p), _xy(v), elasticity=e, friction=mu, radius=r)
    _wall(space, _xy(a), _xy(b), half_thickness=h)
    normals = _recorded_normals(space)
    space.step(positive("dt", dt))
    normal = -np.array(normals[0]) if normals else None
    return SegmentBounce(np.array(ball.velocity), normal, np.array(ball.position))


def drop_onto_floor(
    height: float, restitution: float, duration: float, dt: float, gravity: float
) -> tuple[Any, Any]:
    """Return the height of a ball that pymunk drops onto a floor, step by step.

    The floor is made thick enough that the ball cannot pass through it in one step; all
    settings are pymunk's defaults.

    Parameters
    ----------
    height : float
        Clearance below the ball at time 0, m, > 0.
    restitution : float
        Of ball and floor, 0 to 1.
    duration : float
        s, >= 0.
    dt : float
        The step, s, > 0.
    gravity : float
        Acceleration downwards, m/s^2, > 0.

    Returns
    -------
    (times, heights) : tuple of ndarray, shape (F,)
        F = 1 + the number of whole steps in `duration`; times in s, clearance in m. The
        clearance is negative where the ball has sunk into the floor.

    Raises
    ------
    ValueError
        A number lies outside its range.

    Examples
    --------
    >>> times, heights = drop_onto_floor(
    ...     height=1, restitution=0.5, duration=0.5, dt=0.25, gravity=8
    ... )
    >>> times, heights
    (array([0.  , 0.25, 0.5 ]), array([1. , 1. , 0.5]))
    """
    positive("height", height), unit_interval("restitution", restitution)
    positive("dt", dt), positive("gravity", gravity)
    steps = whole_parts(non_negative("duration", duration), dt)
    space = pymunk.Space()
    space.gravity = (0.0, -gravity)
    longest_move = (math.sqrt(2 * gravity * height) + gravity * dt) * dt
    half_thickness = 1.0 + longest_move
    _wall(space, (-1.0, -half_thickness), (1.0, -half_thickness), half_thickness)
    ball = _disc(space, 1.0, (0.0, 1.0 + height), (0.0, 0.0), elasticity=restitution)
    heights = [float(height)]
    for _ in range(steps):
        space.step(dt)
        heights.append(ball.position.y - 1.0)
    return dt * np.arange(steps + 1), np.array(heights)


def rebound_heights(
    height: float, restitution: float, duration: float, dt: float, gravity: float
) -> Any:
    """Return the heights that a ball dropped by pymunk reaches after its impacts.

    Parameters, errors and method are those of :func:`drop_onto_floor`.

    Returns
    -------
    ndarray, shape (count,)
        The highest sample of each rebound that has peaked within the duration, m.

    Examples
    --------
    >>> rebound_heights(height=2, restitution=0.5, duration=1.5, dt=1 / 60, gravity=10).round(3)
    array([0.469, 0.119])
    """
    _, heights = drop_onto_floor(height, restitution, duration, dt, gravity)
    before, here, after = heights[:-2], heights[1:-1], heights[2:]
    # The start is a peak of the sampled curve too: there two samples are equally high.
    peak = (here >= after) & (here > before) & (here > 0)
    return here[peak]


def _disc(
    space: pymunk.Space,
    m: float,
    position: tuple[float, float],
    velocity: tuple[float, float],
    elasticity: float,
    friction: float = 0.0,
    radius: float = 1.0,
) -> pymunk.Body:
    """Add a disc that cannot spin; one of infinite mass is kinematic: nothing can push it."""
    if math.isinf(m):
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
    else:
        body = pymunk.Body(float(m), math.inf)
    body.position, body.velocity = position, velocity
    shape = pymunk.Circle(body, float(radius))
    shape.elasticity, shape.friction = float(elasticity), float(friction)
    shape.collision_type = BALL
    space.add(body, shape)
    return body


def _wall(
    space: pymunk.Space,
    start: tuple[float, float],
    end: tuple[float, float],
    half_thickness: float,
) -> None:
    """Add a fixed wall of restitution 1 and friction 1, which leaves the ball's as they are."""
    shape = pymunk.Segment(space.static_body, start, end, float(half_thickness))
    shape.elasticity, shape.friction, shape.collision_type = 1.0, 1.0, WALL
    space.add(shape)


def _recorded_normals(space: pymunk.Space) -> list[tuple[float, float]]:
    """Return a list that each step fills with its contact normals, from ball to wall."""
    normals: list[tuple[float, float]] = []

    def record(contact: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
        normals.append(contact.normal)

    space.on_collision(BALL, WALL, pre_solve=record)
    return normals


def _xy(v: Any) -> tuple[float, float]:
    """Return a vector as the pair of floats that pymunk takes."""
    return float(v[0]), float(v[1])

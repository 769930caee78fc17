"""The small engine: the whole pipeline on a page, made of the formulas of chapters 01 to 06.

It is what a reader has at the end of the course, without anything that chapters 06 to 10 add for
contacts that last: one visit to each contact, no memory of the step before, nobody watched or
asleep. Chapter 11 reads these lines and compares them with the workbook's engine.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.impulse_table import EVENT_NUMBERS
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import Stepper, moved_on, record
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.formulas import (
    contact_velocity,
    effective_mass,
    friction_impulse,
    normal_impulse,
)
from lesson_code.formulas.arithmetic import cross, dot, perpendicular
from lesson_code.formulas.validation import Vector, one_number, positive
from lesson_code.geometry import Circle, Manifold, Polygon, collide

NAME = "small engine"

Box: TypeAlias = tuple[float, float, float, float]


@dataclass
class Mover:
    """A body on its way.

    Attributes
    ----------
    body : Body
        What it is made of; its own state is that of the start.
    position, velocity : ndarray, shape (2,)
        m and m/s.
    angle, w : float
        rad and rad/s, counter-clockwise.
    inv_m, inv_i : float
        1/kg and 1/(kg m^2); 0 for what nothing can push or turn.
    """

    body: Body
    position: Any
    velocity: Any
    angle: float
    w: float
    inv_m: float
    inv_i: float

    def velocity_at(self, arm: Vector) -> Any:
        """Return the velocity of the point at `arm` from the centre, m/s."""
        return contact_velocity(self.velocity, self.w, arm)


def mover_of(body: Body) -> Mover:
    """Return a body as it is at the start."""
    state = (np.array(body.position), np.array(body.velocity), body.angle, body.angular_velocity)
    inverses = [0.0 if value is None else 1 / value for value in (body.mass, body.inertia)]
    return Mover(body, *state, *inverses)


@dataclass(frozen=True)
class Parts:
    """The functions that a step calls; another engine may bring its own."""

    pairs_near: Callable[[list[Mover]], Iterable[tuple[Mover, Mover]]]
    contact: Callable[[Mover, Mover], Manifold | None]
    hit: Callable[[Mover, Mover, Any, Any, float], None]
    separate: Callable[[Mover, Mover, Any, float], None]


def step(bodies: list[Mover], gravity: Vector, dt: float, parts: Parts) -> None:
    """Let one time step pass: detection, then resolution."""
    for body in bodies:
        move(body, gravity, dt)
    for a, b in parts.pairs_near(bodies):
        manifold = parts.contact(a, b)
        if manifold is None:
            continue
        for point, depth in zip(manifold.points, manifold.penetrations, strict=True):
            parts.hit(a, b, point, manifold.normal, depth)
        parts.separate(a, b, manifold.normal, manifold.penetrations.max())


def move(body: Mover, gravity: Vector, dt: float) -> None:
    """Move a body by its velocity, and let gravity act on what can be pushed."""
    body.position = body.position + body.velocity * dt
    body.angle += body.w * dt
    if body.inv_m > 0:
        body.velocity = body.velocity + np.asarray(gravity) * dt


def pairs_near(bodies: list[Mover]) -> list[tuple[Mover, Mover]]:
    """Return the pairs whose boxes share a point, one of which can be pushed."""
    return [(bodies[i], bodies[j]) for i, j in numbers_near(bodies)]


def numbers_near(bodies: list[Mover]) -> list[tuple[int, int]]:
    """Return their numbers (i, j), i < j."""
    boxes = [box_of(body) for body in bodies]
    return [
        (i, j)
        for i, j in combinations(range(len(bodies)), 2)
        if bodies[i].inv_m + bodies[j].inv_m > 0 and share_a_point(boxes[i], boxes[j])
    ]


def share_a_point(one: Box, other: Box) -> bool:
    """Return whether two boxes overlap or touch."""
    left, right, low, high = one
    other_left, other_right, other_low, other_high = other
    along_x = left <= other_right and other_left <= right
    return along_x and low <= other_high and other_low <= high


def box_of(body: Mover) -> Box:
    """Return the left, right, low and high side of the box around a body, m."""
    points, reach = corners_of(body), body.body.shape.rounding
    (left, low), (right, high) = points.min(axis=0) - reach, points.max(axis=0) + reach
    return left, right, low, high


def corners_of(body: Mover) -> Any:
    """Return the corners of a body where it is, counter-clockwise, m; a circle's centre."""
    points = np.array(body.body.shape.outline or [(0.0, 0.0)])
    cos, sin = math.cos(body.angle), math.sin(body.angle)
    return points @ np.array([[cos, sin], [-sin, cos]]) + body.position


def contact(a: Mover, b: Mover) -> Manifold | None:
    """Return where two bodies overlap, or None."""
    return collide(a.body.shape, pose(a), b.body.shape, pose(b))


def hit(a: Mover, b: Mover, point: Vector, normal: Vector, depth: float) -> None:
    """Bounce two bodies off each other at a point, then stop their sliding as far as friction can.

    The normal points from a to b, and the point is midway between their surfaces; each is pushed
    at its own.
    """
    arm_a, arm_b = point + depth / 2 * normal - a.position, point - depth / 2 * normal - b.position
    e, mu = surfaces(a, b)
    jn = normal_impulse(*_approach(a, b, arm_a, arm_b, normal), e)
    push(a, b, arm_a, arm_b, jn * normal)
    tangent = perpendicular(normal)
    jt = friction_impulse(*_approach(a, b, arm_a, arm_b, tangent), mu, jn)
    push(a, b, arm_a, arm_b, jt * tangent)


def surfaces(a: Mover, b: Mover) -> tuple[float, float]:
    """Return restitution and friction of a pair."""
    one, other = a.body.material, b.body.material
    e = of_pair(min, one.restitution, other.restitution)
    return e, of_pair(geometric_mean, one.friction, other.friction)


def of_pair(rule: Callable[[float, float], float], one: float | None, other: float | None) -> float:
    """Return a pair's coefficient; a body that names none leaves it to the other one."""
    return rule(one, other) if one is not None and other is not None else one or other or 0.0


def geometric_mean(one: float, other: float) -> float:
    """Return the square root of the product."""
    return math.sqrt(one * other)


def _approach(
    a: Mover, b: Mover, arm_a: Vector, arm_b: Vector, along: Vector
) -> tuple[float, float]:
    """Return the relative velocity at a contact along a direction, and the effective mass."""
    v = dot(b.velocity_at(arm_b) - a.velocity_at(arm_a), along)
    inverses = (a.inv_m, b.inv_m, a.inv_i, b.inv_i)
    return v, effective_mass(*inverses, cross(arm_a, along), cross(arm_b, along))


def push(a: Mover, b: Mover, arm_a: Vector, arm_b: Vector, impulse: Vector) -> None:
    """Give b an impulse, N s, and a the opposite one."""
    for body, arm, received in ((a, arm_a, -impulse), (b, arm_b, impulse)):
        body.velocity = body.velocity + received * body.inv_m
        body.w += cross(arm, received) * body.inv_i


def separate(a: Mover, b: Mover, normal: Vector, depth: float) -> None:
    """Move two bodies apart, the lighter one farther."""
    shift = depth / (a.inv_m + b.inv_m) * normal
    a.position = a.position - shift * a.inv_m
    b.position = b.position + shift * b.inv_m


def pose(mover: Mover) -> Vector:
    """Return x, y and angle."""
    return np.array([*mover.position, mover.angle])


OURS = Parts(pairs_near, contact, hit, separate)


class SmallEngine(Stepper):
    """The small engine at work on a scene, as a recorder of runs wants it.

    Parameters
    ----------
    scene : Scene
        What is simulated; its damping and its callbacks are left out.
    dt : float
        s, > 0.
    parts : Parts
        The functions that a step calls.
    """

    def __init__(self, scene: Scene, dt: float, parts: Parts = OURS) -> None:
        self._parts = parts
        self.dt = one_number("dt", dt, positive)
        self._gravity = scene.gravity
        self._bodies = [mover_of(body) for body in scene.bodies]

    def advance(self, steps: int) -> None:
        """Advance by `steps` steps of dt."""
        for _ in range(steps):
            step(self._bodies, self._gravity, self.dt, self._parts)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        rows = [[*b.position, b.angle, *b.velocity, b.w] for b in self._bodies]
        return np.array(rows, dtype=float).reshape(-1, 6)

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states moved on at their velocities, shape (N, 6)."""
        return moved_on(self.states(), duration)

    def events(self) -> NDArray[np.float64]:
        """Return no impulses: they are not written down."""
        return np.empty((0, EVENT_NUMBERS))

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run."""
        return Plan(NAME, reason)


def random_hits(count: int, seed: int) -> Iterator[Scene]:
    """Yield pairs that hit within 0.2 s: a rough disc that spins, and a heavier box, turned.

    Parameters
    ----------
    count, seed : int
        How many, and what draws them.
    """
    rng = np.random.default_rng(seed)
    for _ in range(count):
        e, mu, spin, turn, aside, angle = rng.uniform(
            (0, 0, -5, -2, -0.3, 0), (1, 1, 5, 2, 0.3, 3)
        ).tolist()
        shared: dict[str, Any] = {"material": Material(e, mu)}
        disc = Body(Circle(0.5), mass=1.0, velocity=(1, 0), angular_velocity=spin, **shared)
        shared |= {"position": (1.02, aside), "velocity": (-1, 0.3), "angle": angle}
        yield Scene([disc, Body(Polygon.box(1, 0.6), mass=2.0, angular_velocity=turn, **shared)])


def simulate_small(
    scene: Scene,
    duration: float,
    *,
    dt: float = 1 / 60,
    sample: Any = None,
    parts: Parts = OURS,
) -> Run:
    """Run a scene in the small engine.

    Parameters
    ----------
    scene : Scene
        Without damping and callbacks, which it knows nothing of.
    duration, dt : float
        s.
    sample : None, "end" or array_like
        As :func:`lesson_code.simulate` takes it.
    parts : Parts
        The functions that a step calls.

    Raises
    ------
    ValueError
        The scene has damping or callbacks, or a number is out of range.

    Examples
    --------
    >>> from lesson_code import Circle, Material
    >>> e = Material(restitution=1.0)
    >>> balls = [Body(Circle(1), mass=1.0, position=(3 * n, 0), material=e) for n in (0, 1)]
    >>> moving = Body(Circle(1), mass=1.0, position=(-3, 0), velocity=(2, 0), material=e)
    >>> simulate_small(Scene([moving, *balls]), 3.0, sample="end").velocities[-1, :, 0].tolist()
    [0.0, 0.0, 2.0]
    """
    if scene.damping or scene.callbacks.wanted:
        raise ValueError("scene must have no damping and no callbacks: the small engine knows none")
    return record(SmallEngine(scene, dt, parts), scene, duration, sample, "asked for")

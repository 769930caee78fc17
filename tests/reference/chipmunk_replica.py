"""pymunk's solver written again in Python, to show that we know what it does.

It is our own step with the few things that Chipmunk, the library under pymunk, does otherwise:

- the overlap that is left alone and the share of it that is undone are absolute numbers;
- normal impulse and friction of one contact are computed from the same relative velocity;
- a pair that has parted and touches again within three steps begins with its old impulses,
  although they are not applied;
- contacts are visited in the order of its own search tree, which must be told from outside.

Discs and segments only. Its arithmetic is in Chipmunk's order, operation by operation, because
the comparison is made to the last bit.

References
----------
Chipmunk2D 7, src/cpSpaceStep.c, src/cpArbiter.c, src/cpCollision.c.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeAlias

from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.core.motion import accelerate, move
from lesson_code.engine.core.rows import BodyRow
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.core.tables import world_of
from lesson_code.formulas import rigid_body
from lesson_code.formulas.arithmetic import clamp, cross, dot
from lesson_code.formulas.validation import equation
from lesson_code.geometry.shapes import Circle, Segment

contact_velocity = equation(rigid_body.contact_velocity)

SLOP = 0.10000000149011612
"""m: overlap that pymunk leaves alone; 0.1 that has once been a 32-bit number."""

BIAS = 0.0017970074436457143
"""Share of the overlap that pymunk leaves after one second: 0.9 ** 60 of 32-bit numbers."""

PERSISTENCE = 3
"""Steps for which pymunk remembers the impulses of a pair that has parted."""

Pair: TypeAlias = tuple[int, int]
Vector: TypeAlias = tuple[float, float]


@dataclass(slots=True)
class Arbiter:
    """What Chipmunk keeps of a pair of bodies, for as long as it remembers it."""

    stamp: int  # the last step in which they touched
    is_first: bool = True  # whether they did not touch in the step before
    normal: Vector = (0.0, 0.0)  # from the first body to the second
    r1: Vector = (0.0, 0.0)  # m, lever arms
    r2: Vector = (0.0, 0.0)
    normal_mass: float = 0.0  # kg
    tangent_mass: float = 0.0
    bias: float = 0.0  # m/s, speed at which the overlap is undone
    bounce: float = 0.0  # m/s, restitution times relative velocity; negative when approaching
    restitution: float = 0.0
    friction: float = 0.0
    jn: float = 0.0  # N s, total normal impulse
    jt: float = 0.0
    j_bias: float = 0.0


class ChipmunkReplica:
    """A scene of discs and segments, stepped as pymunk steps it.

    The pair's coefficients are products, as pymunk's are.

    Parameters
    ----------
    scene : Scene
        Discs, and static segments.
    dt : float
        s, > 0.
    iterations : int
        Sweeps in each step.

    Raises
    ------
    ValueError
        A body is neither a disc nor a static segment.
    """

    def __init__(self, scene: Scene, dt: float, iterations: int = 10) -> None:
        self.world = world_of(scene, dt, iterations, mixing_rule("pymunk"))
        self._segments = {
            n: _ends(body)
            for n, body in enumerate(scene.bodies)
            if not isinstance(body.shape, Circle)
        }
        self._arbiters: dict[Pair, Arbiter] = {}
        self._stamp = 0
        self.contacts = 0

    def step(self, order: Iterable[Pair]) -> None:
        """Advance by dt, visiting the pairs of bodies that touch in a given order."""
        self._stamp += 1
        move(self.world)
        touching = [(pair, self._collide(pair)) for pair in order]
        self._forget()
        for pair, arbiter in touching:
            self._prepare(pair, arbiter)
        accelerate(self.world)
        for pair, arbiter in touching:
            if not arbiter.is_first:
                self._apply(pair, arbiter, arbiter.jn, arbiter.jt)
        for _ in range(self.world.state.iterations):
            for pair, arbiter in touching:
                self._solve(pair, arbiter)
        self.contacts += len(touching)

    def states(self) -> list[tuple[float, float, float, float, float, float]]:
        """Return x, y, angle, vx, vy, w of every body."""
        return [(b.x, b.y, b.angle, b.vx, b.vy, b.w) for b in self.world.bodies]

    def _bodies(self, pair: Pair) -> tuple[BodyRow, BodyRow]:
        """Return the rows of a pair."""
        return self.world.bodies[pair[0]], self.world.bodies[pair[1]]

    def _collide(self, pair: Pair) -> Arbiter:
        """Return the arbiter of two bodies that touch, with the geometry of this step."""
        a, b = self._bodies(pair)
        arbiter = self._arbiters.setdefault(min(pair, pair[::-1]), Arbiter(self._stamp))
        arbiter.is_first = arbiter.stamp != self._stamp - 1
        arbiter.stamp = self._stamp
        centre = (a.x, a.y)
        segment = self._segments.get(pair[1])
        other = (b.x, b.y) if segment is None else _closest(centre, *segment)
        delta = (other[0] - centre[0], other[1] - centre[1])
        inverse = 1.0 / math.sqrt(delta[0] * delta[0] + delta[1] * delta[1])
        n = (delta[0] * inverse, delta[1] * inverse)
        arbiter.normal = n
        arbiter.r1 = (a.x + n[0] * a.radius - a.x, a.y + n[1] * a.radius - a.y)
        arbiter.r2 = (other[0] + n[0] * -b.radius - b.x, other[1] + n[1] * -b.radius - b.y)
        arbiter.restitution = a.restitution * b.restitution
        arbiter.friction = a.friction * b.friction
        return arbiter

    def _forget(self) -> None:
        """Forget pairs that have not touched for a while."""
        self._arbiters = {
            pair: arbiter
            for pair, arbiter in self._arbiters.items()
            if self._stamp - arbiter.stamp < PERSISTENCE
        }

    def _prepare(self, pair: Pair, c: Arbiter) -> None:
        """Compute what stays the same during the sweeps."""
        a, b = self._bodies(pair)
        n, t = c.normal, _perpendicular(c.normal)
        c.normal_mass = 1.0 / (_yield(a, c.r1, n) + _yield(b, c.r2, n))
        c.tangent_mass = 1.0 / (_yield(a, c.r1, t) + _yield(b, c.r2, t))
        apart = (c.r2[0] - c.r1[0] + (b.x - a.x), c.r2[1] - c.r1[1] + (b.y - a.y))
        share = 1.0 - BIAS**self.world.state.dt
        c.bias = -share * min(0.0, dot(apart, n) + SLOP) / self.world.state.dt
        c.j_bias = 0.0
        c.bounce = dot(_relative_velocity(a, b, c), n) * c.restitution

    def _solve(self, pair: Pair, c: Arbiter) -> None:
        """Correct one contact; friction and normal impulse see the same relative velocity."""
        a, b = self._bodies(pair)
        n, t = c.normal, _perpendicular(c.normal)
        push1 = contact_velocity((a.pseudo_vx, a.pseudo_vy), a.pseudo_w, c.r1)
        push2 = contact_velocity((b.pseudo_vx, b.pseudo_vy), b.pseudo_w, c.r2)
        v = _relative_velocity(a, b, c)
        vbn = dot((push2[0] - push1[0], push2[1] - push1[1]), n)
        j_bias, jn, jt = c.j_bias, c.jn, c.jt
        c.j_bias = max(j_bias + (c.bias - vbn) * c.normal_mass, 0.0)
        c.jn = max(jn - (c.bounce + dot(v, n)) * c.normal_mass, 0.0)
        limit = c.friction * c.jn
        c.jt = clamp(jt - dot(v, t) * c.tangent_mass, -limit, limit)
        self._push(pair, c, c.j_bias - j_bias)
        self._apply(pair, c, c.jn - jn, c.jt - jt)

    def _apply(self, pair: Pair, c: Arbiter, jn: float, jt: float) -> None:
        """Change the velocities of both bodies by an impulse along normal and tangent."""
        a, b = self._bodies(pair)
        n = c.normal
        x, y = n[0] * jn - n[1] * jt, n[0] * jt + n[1] * jn
        a.vx, a.vy = a.vx - x * a.inv_m, a.vy - y * a.inv_m
        b.vx, b.vy = b.vx + x * b.inv_m, b.vy + y * b.inv_m
        a.w -= a.inv_i * cross(c.r1, (x, y))
        b.w += b.inv_i * cross(c.r2, (x, y))

    def _push(self, pair: Pair, c: Arbiter, j: float) -> None:
        """Change the velocities that undo the overlap."""
        a, b = self._bodies(pair)
        x, y = c.normal[0] * j, c.normal[1] * j
        a.pseudo_vx, a.pseudo_vy = a.pseudo_vx - x * a.inv_m, a.pseudo_vy - y * a.inv_m
        b.pseudo_vx, b.pseudo_vy = b.pseudo_vx + x * b.inv_m, b.pseudo_vy + y * b.inv_m
        a.pseudo_w -= a.inv_i * cross(c.r1, (x, y))
        b.pseudo_w += b.inv_i * cross(c.r2, (x, y))


def _ends(body: Body) -> tuple[Vector, Vector]:
    """Return both ends of a static segment that is not turned, m."""
    if not (isinstance(body.shape, Segment) and body.is_static and body.angle == 0):
        raise ValueError(f"bodies must be discs, or static segments at angle 0, got {body}")
    (x, y), (ax, ay), (bx, by) = body.position, body.shape.start, body.shape.end
    return (x + ax, y + ay), (x + bx, y + by)


def _closest(point: Vector, start: Vector, end: Vector) -> Vector:
    """Return the point of a segment that is closest to a point."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    along = dx * (point[0] - start[0]) + dy * (point[1] - start[1])
    t = max(0.0, min(along / (dx * dx + dy * dy), 1.0))
    return start[0] + dx * t, start[1] + dy * t


def _yield(body: BodyRow, r: Vector, n: Vector) -> float:
    """Return how much velocity along n a body takes from an impulse of 1 N s, 1/kg."""
    r_x_n: float = cross(r, n)
    return body.inv_m + body.inv_i * r_x_n * r_x_n


def _relative_velocity(a: BodyRow, b: BodyRow, c: Arbiter) -> Vector:
    """Return the velocity of the second body's contact point relative to the first's."""
    v1 = contact_velocity((a.vx, a.vy), a.w, c.r1)
    v2 = contact_velocity((b.vx, b.vy), b.w, c.r2)
    return v2[0] - v1[0], v2[1] - v1[1]


def _perpendicular(n: Vector) -> Vector:
    """Return a vector turned by +90 degrees."""
    return -n[1], n[0]

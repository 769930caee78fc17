"""How far bodies can get: whether any two can meet in a run, and how fast one can become."""

from __future__ import annotations

import math
from typing import NamedTuple

from lesson_code.engine.core.scene import Body, Scene
from lesson_code.geometry.shapes import Circle, Segment


class Box(NamedTuple):
    """What a body and all of its way lie in, m."""

    min_x: float
    max_x: float
    min_y: float
    max_y: float
    is_static: bool


def can_meet(scene: Scene, duration: float, dt: float) -> bool:
    """Return whether two bodies, one of which can be pushed, can meet within a run.

    Until the first impact every body flies freely. So it is enough that the boxes around these
    flights stay apart. They are visited from left to right; two static ones are not compared.

    Parameters
    ----------
    scene : Scene
        Bodies, gravity, damping.
    duration : float
        s; ``math.inf``: nobody knows.
    dt : float
        s, the time step: between two steps positions lag behind the parabola by up to g t dt / 2.

    Examples
    --------
    >>> ball = Body(Circle(1), mass=1.0, velocity=(1, 0))
    >>> wall = Body(Circle(1), position=(9, 0))
    >>> [can_meet(Scene([ball, wall]), duration, dt=0.01) for duration in (5.0, 8.0)]
    [False, True]
    """
    if all(body.is_static for body in scene.bodies) or len(scene.bodies) < 2:
        return False
    if math.isinf(duration):
        return True
    free: list[Box] = []
    static: list[Box] = []
    for box in sorted(_box_of_way(body, scene, duration + dt) for body in scene.bodies):
        free = [other for other in free if other.max_x >= box.min_x]
        if any(_share_y(box, other) for other in free):
            return True
        if box.is_static:
            static.append(box)
            continue
        static = [other for other in static if other.max_x >= box.min_x]
        if any(_share_y(box, other) for other in static):
            return True
        free.append(box)
    return False


def fastest_way(scene: Scene, dt: float) -> tuple[float, float]:
    """Return how far a body can move in a step, m, and how far it may without being watched, m.

    Without gravity all bodies together keep the kinetic energy that they have. If one body had
    all of it, it would have the speed sqrt(2 E / m). What counts is the way of its farthest point.

    Examples
    --------
    Two discs of 1 kg and 1 m/s: one of them may come to have the energy of both.

    >>> discs = [Body(Circle(1), mass=1.0, velocity=(1, 0), position=(0, 3 * k)) for k in (0, 1)]
    >>> way, room = fastest_way(Scene(discs), dt=0.1)
    >>> round(way, 6), room
    (0.141421, 1.0)
    """
    free = [body for body in scene.bodies if not body.is_static]
    twice_energy = sum(_twice_energy(body) for body in free)
    speed = max((_fastest_point(body, twice_energy) for body in free), default=0.0)
    return speed * dt, min((_half_width(body) for body in free), default=math.inf)


def _half_width(body: Body) -> float:
    """Return half of the smallest width of a body's matter, m."""
    return body.shape.radius if isinstance(body.shape, Segment) else 0.5 * body.shape.extent


def _twice_energy(body: Body) -> float:
    """Return m v^2 + I w^2, J."""
    vx, vy = body.velocity
    mass, inertia, w = body.mass or 0.0, body.inertia or 0.0, body.angular_velocity
    return mass * (vx * vx + vy * vy) + (inertia * w * w if w != 0.0 else 0.0)


def _fastest_point(body: Body, twice_energy: float) -> float:
    """Return how fast a point of a body can be that has all the energy, m/s."""
    mass, inertia = body.mass or math.inf, body.inertia or math.inf
    arm = 0.0 if isinstance(body.shape, Circle) else body.shape.bounding_radius
    return math.sqrt(twice_energy * (1 / mass + arm * arm / inertia))


def _box_of_way(body: Body, scene: Scene, time: float) -> Box:
    """Return a box around a body's flight, m."""
    gravity = (0.0, 0.0) if body.is_static else scene.gravity
    x, y = (
        _span(*along, time, scene.damping > 0.0)
        for along in zip(body.position, body.velocity, gravity, strict=True)
    )
    reach = body.shape.bounding_radius
    return Box(x[0] - reach, x[1] + reach, y[0] - reach, y[1] + reach, body.is_static)


def _span(
    start: float, speed: float, gain: float, time: float, is_damped: bool
) -> tuple[float, float]:
    """Return the least and the largest of start + speed t + gain t^2 / 2, m; wider if damped."""
    if is_damped:
        way = abs(speed) * time + 0.5 * abs(gain) * time * time
        return start - way, start + way
    times = [0.0, time]
    if gain != 0.0 and 0.0 < -speed / gain < time:
        times.append(-speed / gain)
    places = [start + speed * t + 0.5 * gain * t * t for t in times]
    return min(places), max(places)


def _share_y(a: Box, b: Box) -> bool:
    """Return whether two boxes overlap along y."""
    return a.min_y <= b.max_y and b.min_y <= a.max_y

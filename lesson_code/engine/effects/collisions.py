"""Collisions: some two bodies may meet within the run.

Without them there is nothing to find, to solve or to tell, and bodies fly freely.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.effects.question import Effect, Finding, Question


def rule(question: Question) -> Finding:
    """Ask whether any two bodies can meet."""
    if can_meet(question.scene, question.duration, question.dt):
        return Finding(True, "two bodies can meet")
    return Finding(False, "no two bodies can meet within the run")


EFFECT = Effect(
    rule=rule,
    place=10,
    functions=("find_pairs", "find_contacts", "prepare", "resolve"),
    needs_collisions=False,
)


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
        s; ``math.inf``: unknown.
    dt : float
        s, the time step: between two steps positions lag behind the parabola by up to g t dt / 2.

    Examples
    --------
    >>> from lesson_code import Circle
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

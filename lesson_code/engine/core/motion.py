"""Motion: bodies go on at their velocities; gravity and damping change these."""

from __future__ import annotations

import math

from lesson_code.engine.core.rows import BodyRow, World
from lesson_code.engine.effects.damping import damp
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.gravity import fall
from lesson_code.geometry.rows import turn


def move(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Move every body by its velocity and by the push out of an overlap, which is then spent.

    A body that leaves the range of floating point is noted as lost.
    """
    dt = world.state.dt
    for number, body in enumerate(world.bodies):
        if body.waits or (effects.sleeping and body.is_asleep):
            continue
        body.x += (body.vx + body.pseudo_vx) * dt
        body.y += (body.vy + body.pseudo_vy) * dt
        if not math.isfinite(body.x + body.y):
            world.state.lost_body = number
            return
        if effects.rotation and not turn_on(world, body, dt):
            world.state.lost_body = number
            return
        body.pseudo_vx = 0.0
        body.pseudo_vy = 0.0


def turn_on(world: World, body: BodyRow, dt: float) -> bool:
    """Turn a body by its angular velocity; return whether its angle is still a number."""
    spin = body.w + body.pseudo_w
    body.angle += spin * dt
    body.pseudo_w = 0.0
    if not math.isfinite(body.angle):
        return False
    if spin != 0.0 and body.corner_count > 0:
        turn_with_angle(world, body)
    return True


def turn_with_angle(world: World, body: BodyRow) -> None:
    """Turn the body's outline to its angle."""
    body.cos = math.cos(body.angle)
    body.sin = math.sin(body.angle)
    turn(world.corners, body)


def accelerate(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Let damping and gravity act on the velocities."""
    if effects.damping:
        damp(world, effects)
    if effects.gravity:
        fall(world, effects)


def note_velocities(world: World) -> None:
    """Note the velocities that the bodies have now, to compare with those that contacts make."""
    for body in world.bodies:
        body.start_vx, body.start_vy, body.start_w = body.vx, body.vy, body.w

"""Motion between two events: constant acceleration, so that every moment has a closed form.

x(t) = x + v t + a t^2 / 2        v(t) = v + a t        t counted from the disc's own time

Without gravity nothing is accelerated, and the way is a straight line.
"""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.core.rows import BodyRow
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.event_driven.rows import DiscRow

Pair: TypeAlias = tuple[float, float]


def place_at(disc: DiscRow, time: float, effects: Effects = EVERY_EFFECT) -> Pair:
    """Return where a disc is at a time, m."""
    t = time - disc.time
    if effects.gravity:
        return (
            disc.x + t * (disc.vx + disc.ax * t / 2),
            disc.y + t * (disc.vy + disc.ay * t / 2),
        )
    return disc.x + t * disc.vx, disc.y + t * disc.vy


def velocity_at(disc: DiscRow, time: float, effects: Effects = EVERY_EFFECT) -> Pair:
    """Return a disc's velocity at a time, m/s."""
    if effects.gravity:
        t = time - disc.time
        return disc.vx + disc.ax * t, disc.vy + disc.ay * t
    return disc.vx, disc.vy


def turning_at(disc: DiscRow, time: float, effects: Effects = EVERY_EFFECT) -> Pair:
    """Return a disc's angle, rad, and angular velocity, rad/s, at a time."""
    t = time - disc.time
    if effects.gravity:
        return disc.angle + t * (disc.w + disc.alpha * t / 2), disc.w + disc.alpha * t
    return disc.angle + t * disc.w, disc.w


def seen_from(obstacle: BodyRow, disc: DiscRow) -> Pair:
    """Return where a disc is at its own time, seen from an obstacle, m."""
    return (
        disc.x - (obstacle.x + obstacle.vx * disc.time),
        disc.y - (obstacle.y + obstacle.vy * disc.time),
    )


def move_to(disc: DiscRow, time: float, effects: Effects = EVERY_EFFECT) -> None:
    """Move a disc forward to a time."""
    x, y = place_at(disc, time, effects)
    vx, vy = velocity_at(disc, time, effects)
    if effects.rotation:
        disc.angle, disc.w = turning_at(disc, time, effects)
    disc.x, disc.y = x, y
    disc.vx, disc.vy = vx, vy
    disc.time = time

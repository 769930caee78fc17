"""Motion between two events: constant acceleration, so that every moment has a closed form.

x(t) = x + v t + a t^2 / 2        v(t) = v + a t        t counted from the disc's own time
"""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.event_driven.rows import DiscRow
from lesson_code.engine.rows import BodyRow

Pair: TypeAlias = tuple[float, float]


def place_at(disc: DiscRow, time: float) -> Pair:
    """Return where a disc is at a time, m."""
    t = time - disc.time
    return (
        disc.x + t * (disc.vx + disc.ax * t / 2),
        disc.y + t * (disc.vy + disc.ay * t / 2),
    )


def velocity_at(disc: DiscRow, time: float) -> Pair:
    """Return a disc's velocity at a time, m/s."""
    t = time - disc.time
    return disc.vx + disc.ax * t, disc.vy + disc.ay * t


def turning_at(disc: DiscRow, time: float) -> Pair:
    """Return a disc's angle, rad, and angular velocity, rad/s, at a time."""
    t = time - disc.time
    return disc.angle + t * (disc.w + disc.alpha * t / 2), disc.w + disc.alpha * t


def seen_from(obstacle: BodyRow, disc: DiscRow, now: float) -> Pair:
    """Return where a disc that lives in the present is, seen from an obstacle, m."""
    return (
        disc.x - (obstacle.x + obstacle.vx * now),
        disc.y - (obstacle.y + obstacle.vy * now),
    )


def move_to(disc: DiscRow, time: float) -> None:
    """Let a disc live on to a time."""
    place, velocity, turning = place_at(disc, time), velocity_at(disc, time), turning_at(disc, time)
    disc.x, disc.y = place
    disc.vx, disc.vy = velocity
    disc.angle, disc.w = turning
    disc.time = time

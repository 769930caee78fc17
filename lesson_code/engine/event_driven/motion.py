"""Motion between two events: constant acceleration, so that every moment has a closed form.

x(t) = x + v t + a t^2 / 2        v(t) = v + a t        t counted from the disc's own time
"""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.event_driven.rows import DiscRow

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


def move_to(disc: DiscRow, time: float) -> None:
    """Let a disc live on to a time."""
    t = time - disc.time
    disc.x += t * (disc.vx + disc.ax * t / 2)
    disc.y += t * (disc.vy + disc.ay * t / 2)
    disc.angle += t * (disc.w + disc.alpha * t / 2)
    disc.vx += disc.ax * t
    disc.vy += disc.ay * t
    disc.w += disc.alpha * t
    disc.time = time

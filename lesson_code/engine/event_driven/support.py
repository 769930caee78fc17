"""Resting: a disc that lies, slides or rolls on the flat face of an obstacle.

The face takes away the part of gravity that presses the disc onto it. Along the face the disc is
pulled by the rest g_t of gravity and by friction, and both are constant until the sliding u of
its lowest point has died, so that this motion has a closed form too:

    sliding    a = g_t - mu g_n s,   alpha = mu g_n s r / (I/m)      s the sign of u
    rolling    a = g_t / (1 + k),    alpha = a / r                   k = I / (m r^2)

It rolls where u = 0 and friction can hold it: |g_t| k / (1 + k) <= mu g_n.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.mixing import mixed
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.event_driven.motion import seen_from
from lesson_code.engine.event_driven.rows import DiscRow, ExactState, Tables
from lesson_code.formulas.arithmetic import dot
from lesson_code.geometry.impact_times import line_impact_time
from lesson_code.geometry.rows import following


def let_go(state: ExactState, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> None:
    """Release a disc: only gravity acts on it."""
    disc.support = -1
    disc.held = False
    disc.ax, disc.ay = state.gravity_x, state.gravity_y
    if effects.rotation:
        disc.alpha = 0.0


def settle(
    tables: Tables, disc: DiscRow, k: int, face: int, effects: Effects = EVERY_EFFECT
) -> None:
    """Let a disc rest on a face of an obstacle: no motion along its normal any more."""
    obstacle, c = tables.obstacles[k], tables.corners[face]
    away = dot((disc.vx - obstacle.vx, disc.vy - obstacle.vy), (c.nx, c.ny))
    disc.vx -= away * c.nx
    disc.vy -= away * c.ny
    disc.support, disc.face = k, face
    slide_or_roll(tables, disc, effects)


def slide_or_roll(tables: Tables, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> None:
    """Set the accelerations of a disc that rests on a face."""
    c = tables.corners[disc.face]
    gravity, tangent = (tables.state.gravity_x, tables.state.gravity_y), (-c.ny, c.nx)
    along = dot(gravity, tangent)
    if effects.rotation:
        disc.alpha = 0.0
    if effects.friction:
        along = pull_with_friction(tables, disc, along, -dot(gravity, (c.nx, c.ny)), effects)
    disc.ax, disc.ay = along * tangent[0], along * tangent[1]


def pull_with_friction(
    tables: Tables, disc: DiscRow, pull: float, pressing: float, effects: Effects
) -> float:
    """Return what friction leaves of a pull along a face, m/s^2; it turns the disc, too."""
    friction = friction_of(tables, disc)
    if friction == 0.0:
        return pull
    k = stiffness(disc) if effects.rotation else math.inf
    slip = slip_of(tables, disc, effects)
    grips = abs(slip) <= tables.state.grips
    if grips and abs(pull) * share_held(k) <= friction * pressing:
        along = pull - pull * share_held(k)
        if effects.rotation and math.isfinite(k):
            disc.alpha = along / disc.radius
        return along
    sign = math.copysign(1.0, pull if grips else slip)
    if effects.rotation:
        disc.alpha = friction * pressing * sign / (k * disc.radius)
    return pull - friction * pressing * sign


def stiffness(disc: DiscRow) -> float:
    """Return k = I / (m r^2): infinite for a disc that cannot be turned."""
    if disc.inv_i == 0.0:
        return math.inf
    return disc.inv_m / (disc.inv_i * disc.radius * disc.radius)


def share_held(k: float) -> float:
    """Return the share of the pull that friction must hold, so that a disc does not slip."""
    return 1.0 if math.isinf(k) else k / (1 + k)


def friction_of(tables: Tables, disc: DiscRow) -> float:
    """Return the friction coefficient of a disc and the obstacle it rests on."""
    obstacle = tables.obstacles[disc.support]
    return mixed(tables.state.friction_rule, obstacle.friction, disc.friction)


def slip_of(tables: Tables, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> float:
    """Return how fast the lowest point slides along the face, m/s: u = v . t - w r."""
    speed, _ = motion_along_face(tables, disc)
    return speed - disc.w * disc.radius if effects.rotation else speed


def motion_along_face(tables: Tables, disc: DiscRow) -> tuple[float, float]:
    """Return a disc's velocity, m/s, and acceleration, m/s^2, along the face that it rests on."""
    obstacle, c = tables.obstacles[disc.support], tables.corners[disc.face]
    tangent = (-c.ny, c.nx)
    speed = dot((disc.vx - obstacle.vx, disc.vy - obstacle.vy), tangent)
    return speed, dot((disc.ax, disc.ay), tangent)


def grip_time(tables: Tables, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> float:
    """Return when the disc stops sliding on its face, s from its own time; ``math.inf``: never."""
    if friction_of(tables, disc) == 0.0:
        return math.inf
    slip = slip_of(tables, disc, effects)
    _, change = motion_along_face(tables, disc)
    if effects.rotation:
        change -= disc.alpha * disc.radius
    ends = abs(slip) > tables.state.grips and slip * change < 0.0
    return -slip / change if ends else math.inf


def stop_sliding(tables: Tables, disc: DiscRow, effects: Effects = EVERY_EFFECT) -> None:
    """Take away the rest of sliding that the rounding of time has left at its end."""
    slip, c = slip_of(tables, disc, effects), tables.corners[disc.face]
    if effects.rotation and disc.inv_i > 0.0:
        disc.w += slip / disc.radius
    else:
        disc.vx += slip * c.ny
        disc.vy -= slip * c.nx


def time_to_end(tables: Tables, disc: DiscRow) -> float:
    """Return when the disc reaches an end of the face that it rests on, s from its time."""
    before, beyond = ways_to_ends(tables, disc)
    speed, pull = motion_along_face(tables, disc)
    return min(line_impact_time(before, speed, pull), line_impact_time(beyond, -speed, -pull))


def ways_to_ends(tables: Tables, disc: DiscRow) -> tuple[float, float]:
    """Return how far the disc is from the start and from the end of its face, m."""
    obstacle = tables.obstacles[disc.support]
    start, end = tables.corners[disc.face], tables.corners[following(obstacle, disc.face)]
    x, y = seen_from(obstacle, disc)
    tangent = (-start.ny, start.nx)
    return dot((x - start.x, y - start.y), tangent), dot((end.x - x, end.y - y), tangent)

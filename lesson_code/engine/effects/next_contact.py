"""The next contact of bodies with skins: how long they may move until they touch at a new point.

Every body that moves by more than its skin in a step has to be watched. To look at all pairs in
every step would take longer than all that follows. So what was seen once is kept: around each body
a box with room to move in, for which the candidate pairs hold, and between the two of a pair a gap.
As long as they have moved by less, there is nothing new to see.

The solver that uses this works in plain Python, and so does this: it makes lists.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from lesson_code.engine.core.broad_phase import box_of
from lesson_code.engine.core.candidate_pairs import find_pairs, seek_pairs
from lesson_code.engine.core.constants import (
    IMPACT_DEPTH,
    LEAST_MARGIN,
    LEAST_PART,
    STEPS_AHEAD,
)
from lesson_code.engine.core.motion import turn_with_angle
from lesson_code.engine.core.narrow_phase import touch
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.rows import BodyRow, PairRow, World
from lesson_code.engine.core.skin import skin_of, touching_gap
from lesson_code.engine.effects.continuous import (
    free_impact_time,
    is_far,
    let_fast_wait,
    most_impacts,
    rim_speed,
    way_between,
    way_of,
)
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.geometry.sat import least_overlap

Place: TypeAlias = tuple[float, float, float]
"""x, y, m, and angle, rad."""

LOOKS_AHEAD = 64
"""Looks ahead at two bodies that touch and turn. A thin rod that whirls needs more: then the part
of the step ends where the last look was."""

LOOK_AGAIN = 0.25
"""Of the thinnest body: how far a corner may move between two looks, so that nothing is passed."""

# Candidate pairs


def find_near_pairs(world: World, pipeline: Pipeline) -> bool:
    """Find the pairs that may be in contact; return whether their table had room."""
    effects = pipeline.effects
    if not effects.continuous:  # nothing moves by as much as its skin
        return find_pairs(world, pipeline.broad_phase, effects)
    if not is_in_boxes(world, effects) and not seek_ahead(world, pipeline):
        return False
    let_near_come_first(world, effects)
    return True


def is_in_boxes(world: World, effects: Effects) -> bool:
    """Return whether all bodies are in the boxes drawn around them; note how far they moved."""
    found = world.state.has_pairs
    for body in world.bodies:
        moved = max(abs(body.x - body.seen_x), abs(body.y - body.seen_y))
        body.moved = moved + turned_by(body, body.seen_angle, effects)
        found = found and body.moved <= body.room
    return found


def turned_by(body: BodyRow, angle: float, effects: Effects) -> float:
    """Return how far a corner has moved at the most since the body was turned by an angle, m."""
    if not (effects.outlines and effects.rotation) or body.corner_count == 0:
        return 0.0
    return abs(body.angle - angle) * body.bounding_radius


def seek_ahead(world: World, pipeline: Pipeline) -> bool:
    """Find the candidate pairs for some steps to come; return whether their table had room."""
    state = world.state
    for body in world.bodies:
        left, low, right, high = box_of(world, body, pipeline.effects)
        margin = STEPS_AHEAD * way_of(body, state.whole, pipeline.effects)
        if body.inv_m > 0.0:
            margin = max(margin, LEAST_MARGIN * body.min_width)
        body.min_x, body.max_x = left - margin, right + margin
        body.min_y, body.max_y = low - margin, high + margin
        body.seen_x, body.seen_y, body.seen_angle = body.x, body.y, body.angle
        body.moved, body.room = 0.0, margin
    if not seek_pairs(world, pipeline.broad_phase):
        return False
    state.candidate_count = state.pair_count
    for pair in candidates(world):
        pair.seen_gap = 0.0
    return True


def candidates(world: World) -> list[PairRow]:
    """Return the candidate pairs: those that may be in contact, and the others."""
    return world.pairs[: world.state.candidate_count]


def let_near_come_first(world: World, effects: Effects) -> None:
    """Let the pairs without a gap come first, sorted: between the others there is no contact."""
    near: list[PairRow] = []
    apart: list[PairRow] = []
    for pair in candidates(world):
        (apart if gap_left(world, pair, effects) > 0.0 else near).append(pair)
    near.sort()
    world.state.pair_count = len(near)
    world.pairs[: len(near) + len(apart)] = near + apart


def gap_left(world: World, pair: PairRow, effects: Effects) -> float:
    """Return a distance that the skins of a pair have at least, m; <= 0: it is not known."""
    if pair.seen_gap <= 0.0:
        return 0.0
    a, b = world.bodies[pair.a], world.bodies[pair.b]
    turned = turned_by(a, pair.seen_angle_a, effects) + turned_by(b, pair.seen_angle_b, effects)
    dx, dy = b.x - a.x - pair.seen_dx, b.y - a.y - pair.seen_dy
    return pair.seen_gap - math.sqrt(dx * dx + dy * dy) - turned


def note_gap(world: World, pair: PairRow) -> float:
    """Note how far apart a pair is, and return it, m."""
    a, b = world.bodies[pair.a], world.bodies[pair.b]
    pair.seen_gap = least_gap(world, a, b) - touching_gap(a, b)
    pair.seen_dx, pair.seen_dy = b.x - a.x, b.y - a.y
    pair.seen_angle_a, pair.seen_angle_b = a.angle, b.angle
    return pair.seen_gap


# The length of a part


def choose_part_ahead(world: World, pipeline: Pipeline) -> bool:
    """Choose how much of the part of the step is made now; return whether that was possible.

    All of it, or as much as passes until two bodies touch at a new point.
    """
    state, effects = world.state, pipeline.effects
    longest = state.dt
    if effects.continuous and has_fast(world, longest, effects):
        if leaves_its_box(world) and not seek_ahead(world, pipeline):
            return False
        state.dt = time_to_contact(world, longest, effects)
        if state.dt < longest:
            if longest == min(state.left, state.horizon):  # and this is the first look at the part
                state.impacts += 1
            if state.impacts > most_impacts(state):
                state.dt = state.left
                let_fast_wait(world)
    state.time = (state.steps_done + 1) * state.whole - (state.left - state.dt)
    return True


def has_fast(world: World, duration: float, effects: Effects) -> bool:
    """Note how far each body moves; return whether any moves by more than a skin."""
    found = False
    for body in world.bodies:
        body.way = way_of(body, duration, effects)
        if not math.isfinite(body.way):
            return False  # the move will say that it cannot be made
        body.is_fast = is_far(world, body.way)
        found = found or body.is_fast
    return found


def leaves_its_box(world: World) -> bool:
    """Return whether a body may leave its box; or the table was too small for the pairs."""
    return not world.state.has_pairs or any(
        body.moved + body.way > body.room for body in world.bodies
    )


def time_to_contact(world: World, duration: float, effects: Effects) -> float:
    """Return how long the world may move until two bodies touch at a new point, s."""
    bodies, earliest = world.bodies, duration
    contacts = world.contacts[: world.state.contact_count]
    touching = {(c.a, c.b) for c in contacts}
    for pair in sorted(candidates(world)):
        a, b = bodies[pair.a], bodies[pair.b]
        if not (a.is_fast or b.is_fast):
            continue
        way = way_between(a, b, duration, effects)
        if not is_far(world, way) or gap_left(world, pair, effects) > way:
            continue
        if (pair.a, pair.b) not in touching and note_gap(world, pair) > way:
            continue
        after = pair_contact_time(world, a, b, earliest, effects)
        if after < earliest:
            earliest = min(earliest, after + LEAST_PART * world.state.whole)
    return earliest


def least_gap(world: World, a: BodyRow, b: BodyRow) -> float:
    """Return a distance that the skins of two bodies have at least, m; <= 0: it is not known."""
    if a.corner_count == 0 and b.corner_count == 0:
        return math.hypot(b.x - a.x, b.y - a.y) - (a.radius + b.radius)
    first, second = (a, b) if a.corner_count > 0 else (b, a)
    overlap, _ = least_overlap(world.corners, first, second)
    if overlap + a.radius + b.radius > 0.0 and second.corner_count > 0:
        overlap, _ = least_overlap(world.corners, second, first)
    return -overlap - (a.radius + b.radius)


def pair_contact_time(
    world: World, a: BodyRow, b: BodyRow, duration: float, effects: Effects
) -> float:
    """Return when two bodies touch at a new point, s; ``math.inf``: not within the duration.

    The contacts that there are the solver holds. There may be more as the bodies turn.
    """
    touch(world, a, b, effects)
    if world.manifold.count > 0:
        speed = rim_speed(a, effects) + rim_speed(b, effects)
        depth = IMPACT_DEPTH * world.state.skin * min(a.min_width, b.min_width)
        return next_corner_time(world, a, b, duration, speed, depth) if speed > 0.0 else math.inf
    near = 0.5 * touching_gap(a, b)
    body = a if a.inv_m > 0.0 else b
    radius = body.radius
    body.radius = radius + near - skin_of(world, a) - skin_of(world, b)
    time = free_impact_time(world, a, b, duration, 0.1 * near, effects)
    body.radius = radius
    return time


def next_corner_time(
    world: World, a: BodyRow, b: BodyRow, duration: float, speed: float, depth: float
) -> float:
    """Return when two turning bodies that touch come to touch at another point, s.

    They are moved on by little at a time until a second point is seen, or they are deeper in each
    other by `depth`; then the time is halved in on.

    Parameters
    ----------
    world : World
        Its manifold is that of the bodies as they stand.
    a, b : BodyRow
        They are put back.
    duration : float
        How far to look, s.
    speed : float
        A bound for how fast any corner turns, m/s, > 0.
    depth : float
        m, > 0.

    Returns
    -------
    float
        s; ``math.inf`` if there is none. The end of the last look if there were too many.
    """
    count, before = world.manifold.count, deepest(world)
    look = max(LOOK_AGAIN * world.state.thinnest, depth) / speed
    place_a, place_b = place_of(a), place_of(b)
    safe, late = 0.0, math.inf
    for _ in range(LOOKS_AHEAD):
        if safe == duration or (late < math.inf and (late - safe) * speed < depth):
            break
        t = 0.5 * (safe + late) if late < math.inf else min(safe + look, duration)
        move_on(world, a, place_a, t)
        move_on(world, b, place_b, t)
        touch(world, a, b, EVERY_EFFECT)
        now = world.manifold.count
        if now > count or (now > 0 and deepest(world) > before + depth):
            late = t
        else:
            safe = t
    move_on(world, a, place_a, 0.0)
    move_on(world, b, place_b, 0.0)
    if late < math.inf:
        return late
    return safe if safe < duration else math.inf


def deepest(world: World) -> float:
    """Return the deeper penetration of the manifold, m."""
    m = world.manifold
    return max(m.penetration0, m.penetration1) if m.count == 2 else m.penetration0


def place_of(body: BodyRow) -> Place:
    """Return where a body is."""
    return body.x, body.y, body.angle


def move_on(world: World, body: BodyRow, place: Place, duration: float) -> None:
    """Put a body where it is a while after it was at a place."""
    x, y, angle = place
    body.x, body.y = x + body.vx * duration, y + body.vy * duration
    body.angle = angle + body.w * duration
    if body.corner_count > 0:
        turn_with_angle(world, body)

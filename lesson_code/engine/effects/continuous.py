"""Continuous detection: a step is split at the impacts that it would jump over.

Only a body that moves in a step by more than half of its width, or of the thinnest body's, can
pass through another unseen. If there is one, the time of its first impact is found. The step ends
there, a little later than the impact, so that the overlap is seen; the impact is resolved like
every other; and what is left of the step follows. Scenes without fast bodies pay for one look at
the speeds.

Where no two bodies are to touch unseen, a body is fast as soon as it moves by more than its skin.
Of the direct solver ``next_contact`` says how far its step goes.

After many impacts within one step those fast bodies that may hit something wait for the next
step. They lose time then, but pass through nothing; the run warns of it.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.broad_phase import bound
from lesson_code.engine.core.candidate_pairs import seek_pairs
from lesson_code.engine.core.constants import (
    IMPACT_DEPTH,
    IMPACTS_A_BODY,
    IMPACTS_TO_DOUBLE,
    MOST_IMPACTS,
    SLOP,
    SPEED_DOUBT,
)
from lesson_code.engine.core.narrow_phase import touch
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.rows import BodyRow, State, World
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.skin import skin_of
from lesson_code.engine.effects import friction, gravity, restitution
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.question import Effect, Finding, Question
from lesson_code.geometry.advancement import advance_to_impact
from lesson_code.geometry.rows import ManifoldRow
from lesson_code.geometry.sweep import impact_time, impact_time_with_circle


def rule(facts: Facts) -> Finding:
    """Ask whether a body may move by more than half of its width within a step.

    Without gravity the energy of all bodies together bounds the speed of each, as long as no
    impact makes energy: e is at most 1, and none of Newton's law with friction at a corner.
    """
    if gravity.rule(facts).called_for:
        return Finding(True, "gravity makes bodies faster, nobody knows how fast")
    if facts.may_change_impulses:
        return Finding(True, "a callback may set how bodies bounce")
    if facts.has_mover:
        return Finding(True, "a body that nothing can push moves, and may hit others fast")
    corners_rub = friction.rule(facts).called_for and facts.cornered_count > 0
    if corners_rub and restitution.rule(facts).called_for:
        return Finding(True, "bounces at corners that rub may gain speed")
    way, room = facts.way, facts.room
    if SPEED_DOUBT * way > room:
        return Finding(True, "a body may move {:.3g} m in a step, and has {:.3g} m", way, room)
    words = "no body can move more than {:.3g} m in a step, and has {:.3g} m"
    return Finding(False, words, way, room)


EFFECT = Effect(rule=rule, place=60, functions=("has_fast_body",))


def fastest_way(scene: Scene, dt: float) -> tuple[float, float]:
    """Return how far a body can move in a step, m, and how far it may without being watched, m.

    That is half of the least width.

    Without gravity all bodies together keep the kinetic energy that they have. If one body had
    all of it, it would have the speed sqrt(2 E / m). What counts is the way of its farthest point.

    Examples
    --------
    Two discs of 1 kg and 1 m/s: one of them may come to have the energy of both.

    >>> from lesson_code import Body, Circle
    >>> discs = [Body(Circle(1), mass=1.0, velocity=(1, 0), position=(0, 3 * k)) for k in (0, 1)]
    >>> way, room = fastest_way(Scene(discs), dt=0.1)
    >>> round(way, 6), room
    (0.141421, 1.0)
    """
    facts = Question(scene, dt=dt).facts
    return facts.way, facts.room


# The stage


def choose_part(world: World, pipeline: Pipeline) -> bool:
    """Choose how much of what is left of the step is made now; return whether that was possible.

    All of it, or as much as passes until a fast body hits something.
    """
    state = world.state
    longest = min(state.left, state.horizon)
    state.dt = longest
    if pipeline.effects.continuous and not pipeline.splits_steps:
        state.has_fast = has_fast_body(world, longest, pipeline.effects)
        if state.has_fast:
            return False
    elif pipeline.effects.continuous and mark_fast(world, longest, pipeline.effects):
        state.dt = time_to_impact(world, pipeline, longest)
        if state.pairs_wanted > 0:
            return False
        if state.dt < longest:
            state.impacts += 1
            if state.impacts > most_impacts(state):
                state.dt = state.left
                let_those_wait_that_may_hit(world, pipeline.effects)
    state.time = (state.steps_done + 1) * state.whole - (state.left - state.dt)
    return True


def most_impacts(state: State) -> int:
    """Return how many impacts of one step are followed to their time."""
    return max(MOST_IMPACTS, IMPACTS_A_BODY * state.free_count)


def has_fast_body(world: World, duration: float, effects: Effects = EVERY_EFFECT) -> bool:
    """Return whether any body could pass through another one unseen."""
    found = False
    for body in world.bodies:
        way = way_of(body, duration, effects)
        if not math.isfinite(way):
            return False  # the move will say that it cannot be made
        found = found or is_far(world, way)
    return found


def mark_fast(world: World, duration: float, effects: Effects = EVERY_EFFECT) -> bool:
    """Mark the bodies that could; return whether there are any."""
    found = has_fast_body(world, duration, effects)
    for body in world.bodies:
        body.waits = False
        body.is_fast = found and is_far(world, way_of(body, duration, effects))
    return found


def is_far(world: World, way: float) -> bool:
    """Return whether on so long a way a body or a thinner one could be passed unseen."""
    return way > world.state.reach


def way_of(body: BodyRow, duration: float, effects: Effects = EVERY_EFFECT) -> float:
    """Return how far a point of a body may move at the most, m."""
    speed = math.sqrt(body.vx * body.vx + body.vy * body.vy)
    return (speed + rim_speed(body, effects)) * duration


def way_between(a: BodyRow, b: BodyRow, duration: float, effects: Effects = EVERY_EFFECT) -> float:
    """Return how far a point of a body may move at the most, seen from another body, m."""
    vx, vy = b.vx - a.vx, b.vy - a.vy
    turning = rim_speed(a, effects) + rim_speed(b, effects)
    return (math.sqrt(vx * vx + vy * vy) + turning) * duration


def rim_speed(body: BodyRow, effects: Effects) -> float:
    """Return how fast a body's farthest corner turns about its centre, m/s; a circle has none."""
    if not (effects.outlines and effects.rotation) or body.corner_count == 0:
        return 0.0
    return abs(body.w) * body.bounding_radius


def time_to_impact(world: World, pipeline: Pipeline, duration: float) -> float:
    """Return how long the world may move until its first fast body is just in another one, s.

    When the table of pairs is too small, that is noted, and the answer means nothing.
    """
    bound_way(world, duration, pipeline.effects)
    has_room = seek_pairs(world, pipeline.broad_phase)
    world.state.has_pairs = False  # these are not the pairs of the step
    if not has_room:
        return duration
    earliest = duration
    for k in range(world.state.pair_count):
        a, b = world.bodies[world.pairs[k].a], world.bodies[world.pairs[k].b]
        if (a.is_fast or b.is_fast) and is_far(
            world, way_between(a, b, duration, pipeline.effects)
        ):
            after = pair_impact_time(world, a, b, earliest, pipeline.effects)
            if after < earliest:
                is_now = after == 0.0
                earliest = min(earliest, after + time_into(world, a, b, is_now, pipeline.effects))
    return earliest


def bound_way(world: World, duration: float, effects: Effects = EVERY_EFFECT) -> None:
    """Put a box around every body and all of its way."""
    bound(world, effects)
    for body in world.bodies:
        x, y = body.vx * duration, body.vy * duration
        margin = min(rim_speed(body, effects) * duration, 2.0 * body.bounding_radius)
        body.min_x += min(x, 0.0) - margin
        body.max_x += max(x, 0.0) + margin
        body.min_y += min(y, 0.0) - margin
        body.max_y += max(y, 0.0) + margin


def pair_impact_time(
    world: World, a: BodyRow, b: BodyRow, duration: float, effects: Effects = EVERY_EFFECT
) -> float:
    """Return when two bodies first touch, s; ``math.inf``: not within the duration.

    Of two that touch already it is now if they would pass through each other. The solver has seen
    them, as it has seen two of which only the skins touch. One may still swing about the point at
    which they touch, and come down beside it: then it is when a corner may have passed unseen.
    """
    touch(world, a, b, effects)
    if world.manifold.count > 0:
        if overlaps(world, a, b) and is_far(world, way_into(world.manifold, a, b, duration)):
            return 0.0
        swing = 2.0 * (rim_speed(a, effects) + rim_speed(b, effects)) * duration
        return duration * world.state.reach / swing if is_far(world, swing) else math.inf
    return free_impact_time(world, a, b, duration, 0.1 * depth_into(a, b), effects)


def free_impact_time(
    world: World, a: BodyRow, b: BodyRow, duration: float, tolerance: float, effects: Effects
) -> float:
    """Return when two bodies that are apart first touch, s; of turning ones within a tolerance."""
    if effects.outlines and effects.rotation and (is_turning(a) or is_turning(b)):
        return advance_to_impact(world.corners, a, b, duration, tolerance)
    if effects.manifolds:
        return impact_time(world.corners, a, b, b.vx - a.vx, b.vy - a.vy)
    return impact_time_with_circle(world.corners, a, b, b.vx - a.vx, b.vy - a.vy)


def overlaps(world: World, a: BodyRow, b: BodyRow) -> bool:
    """Return whether two bodies whose manifold is filled overlap without their skins, too."""
    m = world.manifold
    deepest = max(m.penetration0, m.penetration1) if m.count > 1 else m.penetration0
    return deepest > skin_of(world, a) + skin_of(world, b)


def way_into(m: ManifoldRow, a: BodyRow, b: BodyRow, duration: float) -> float:
    """Return how much deeper into each other two bodies would move where they touch, m.

    A rod that comes down on its tip goes on about it: its centre falls, and its tip stays.
    """
    closing = closing_speed(m.nx, m.ny, m.ax0, m.ay0, m.bx0, m.by0, a, b)
    if m.count > 1:
        closing = max(closing, closing_speed(m.nx, m.ny, m.ax1, m.ay1, m.bx1, m.by1, a, b))
    return closing * duration


def closing_speed(
    nx: float, ny: float, ax: float, ay: float, bx: float, by: float, a: BodyRow, b: BodyRow
) -> float:
    """Return how fast two bodies close at a point, m/s, seen from both, along a normal."""
    vx = (b.vx - b.w * by) - (a.vx - a.w * ay)
    vy = (b.vy + b.w * bx) - (a.vy + a.w * ax)
    return -(vx * nx + vy * ny)


def is_turning(body: BodyRow) -> bool:
    """Return whether a body's outline turns; that of a circle stays the same."""
    return body.w != 0.0 and body.corner_count > 0


def depth_into(a: BodyRow, b: BodyRow) -> float:
    """Return how deep two bodies are let overlap, so that an impact is seen, m."""
    return IMPACT_DEPTH * SLOP * min(a.min_width, b.min_width)


def time_into(world: World, a: BodyRow, b: BodyRow, is_now: bool, effects: Effects) -> float:
    """Return the time in which two bodies that touch come to overlap enough to be seen, at most, s.

    A tip that rubs along a floor, just above it, is about to touch it again and again. So bodies
    that touch now go the deeper, the more impacts the step has had, but not so far that they could
    pass unseen.
    """
    depth = depth_into(a, b)
    deeper = min(depth * (1 << (world.state.impacts // IMPACTS_TO_DOUBLE)), world.state.reach)
    return (max(depth, deeper) if is_now else depth) / way_between(a, b, 1.0, effects)


def let_those_wait_that_may_hit(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Let a fast body stay where it is for what is left of the step if its way crosses another's.

    The others go on.
    """
    world.state.late_steps += 1
    for k in range(world.state.pair_count):
        a, b = world.bodies[world.pairs[k].a], world.bodies[world.pairs[k].b]
        if is_far(world, way_between(a, b, world.state.left, effects)):
            a.waits = a.waits or (a.is_fast and a.inv_m > 0.0)
            b.waits = b.waits or (b.is_fast and b.inv_m > 0.0)


def let_fast_wait(world: World) -> None:
    """Let every fast body stay where it is for what is left of the step."""
    world.state.late_steps += 1
    for body in world.bodies:
        body.waits = body.is_fast and body.inv_m > 0.0

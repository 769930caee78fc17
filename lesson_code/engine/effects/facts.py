"""What the rules of the effects ask of a scene: a few numbers, from one look at all bodies.

The look and the rules are plain arithmetic over rows. So the collision lab, in a page, shows the
plan that Python makes: it is compiled from these lines (``view/browser/programs/plan.py``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from lesson_code.engine.core.columns import SEGMENT_CORNERS
from lesson_code.engine.core.constants import REACH
from lesson_code.engine.core.mixing import mixed
from lesson_code.engine.core.rows import BodyRow


@dataclass(slots=True)
class SeenBody:
    """What is asked of a body; the fields have the names that they have in `BodyRow`."""

    vx: float = 0.0  # m/s
    vy: float = 0.0
    w: float = 0.0  # rad/s
    mass: float = math.inf  # kg; infinite for a body that nothing can push
    inv_i: float = 0.0  # 1/(kg m^2), 0 for a body that nothing can turn
    radius: float = 0.0  # m, of a circle, or a segment's half thickness; 0 for a polygon
    min_width: float = 0.0  # m, smallest width
    bounding_radius: float = 0.0  # m, from the centre of mass to the farthest point
    corner_count: int = 0  # 0 circle, 2 segment, 3 and more polygon
    restitution: float = -1.0  # negative: left to the other body
    friction: float = -1.0  # negative: left to the other body


@dataclass(slots=True)
class Coefficients:
    """A coefficient of all bodies that can be pushed, or of all others: only the extremes count."""

    own_count: int = 0  # bodies that have a value of their own
    open_count: int = 0  # bodies that leave it to the other one
    most: float = 0.0
    next_most: float = 0.0  # of another body; may be the same value
    least: float = math.inf
    next_least: float = math.inf


@dataclass(slots=True)
class Facts:
    """A scene, and how it is to be run, as the rules see it."""

    gravity_x: float = 0.0  # m/s^2
    gravity_y: float = 0.0
    damping: float = 0.0  # 1/s
    dt: float = 0.0  # s, a step
    duration: float = math.inf  # s; infinite: nobody knows yet
    skin: float = 0.0  # of a body's width: how far from its surface the solver sees contacts
    reach: float = REACH  # of a body's width: how far one may move in a step unwatched
    restitution_rule: int = 0  # how a pair's coefficients come from its bodies' (core/mixing.py)
    friction_rule: int = 0
    hears_contacts: bool = False  # whether the scene has callbacks
    may_change_impulses: bool = False  # whether one of them may set how a pair bounces and rubs
    flights_meet: bool = True  # whether bodies that fly freely can meet within the run

    body_count: int = 0
    free_count: int = 0  # bodies that can be pushed
    cornered_count: int = 0  # bodies with corners
    has_free_cornered: bool = False  # whether one of these can be pushed
    has_spin: bool = False  # whether a body turns
    has_turnable: bool = False  # whether an impulse can turn a body
    has_turnable_cornered: bool = False  # whether it can turn a body with corners
    has_mover: bool = False  # whether a body moves that nothing can push
    most_restitution: float = 0.0  # of all pairs in which one body can be pushed
    least_restitution: float = 0.0
    most_friction: float = 0.0
    way: float = 0.0  # m, the longest that a point of a body can move in a step, by its energy
    room: float = math.inf  # m, how far it may move unwatched


class Seen(NamedTuple):
    """The tables that `look` reads and writes."""

    facts: Facts
    bodies: list[SeenBody]
    free_restitution: Coefficients
    fixed_restitution: Coefficients
    free_friction: Coefficients
    fixed_friction: Coefficients


def look(seen: Seen) -> None:
    """Write the facts that follow from the bodies."""
    facts = seen.facts
    facts.body_count = len(seen.bodies)
    for body in seen.bodies:
        has_corners = body.corner_count > 0
        if has_corners:
            facts.cornered_count += 1
        if body.w != 0.0:
            facts.has_spin = True
        if body.inv_i > 0.0:
            facts.has_turnable = True
            facts.has_turnable_cornered = facts.has_turnable_cornered or has_corners
        if body.mass < math.inf:
            facts.free_count += 1
            facts.has_free_cornered = facts.has_free_cornered or has_corners
            room = room_of(body, facts.skin, facts.reach)
            facts.room = room if room < facts.room else facts.room
            note(seen.free_restitution, body.restitution)
            note(seen.free_friction, body.friction)
        else:
            is_moving = body.vx != 0.0 or body.vy != 0.0 or body.w != 0.0
            facts.has_mover = facts.has_mover or is_moving
            note(seen.fixed_restitution, body.restitution)
            note(seen.fixed_friction, body.friction)
    free, fixed = seen.free_restitution, seen.fixed_restitution
    facts.most_restitution = most_of_pairs(facts.restitution_rule, free, fixed)
    facts.least_restitution = least_of_pairs(facts.restitution_rule, free, fixed)
    free, fixed = seen.free_friction, seen.fixed_friction
    facts.most_friction = most_of_pairs(facts.friction_rule, free, fixed)
    facts.way = fastest_point(seen.bodies) * facts.dt


def room_of(body: BodyRow | SeenBody, skin: float, reach: float) -> float:
    """Return how far a body may move unwatched, m: no further than it is seen, or is thick."""
    return min(reach * body.min_width, skin * body.min_width + 0.5 * thickness(body))


def thickness(body: BodyRow | SeenBody) -> float:
    """Return the smallest width of a body's matter, m; a line has none."""
    return 2.0 * body.radius if body.corner_count == SEGMENT_CORNERS else body.min_width


def fastest_point(bodies: list[SeenBody]) -> float:
    """Return how fast a point of a body could be, m/s, if that body had the energy of all.

    A body of mass m with the kinetic energy E has the speed sqrt(2 E / m). One that turns moves its
    farthest point, at the distance r, the faster: sqrt(2 E (1 / m + r^2 / I)).
    """
    twice_energy, most_yielding = 0.0, 0.0
    for body in bodies:
        if body.mass < math.inf:
            twice_energy += body.mass * (body.vx * body.vx + body.vy * body.vy)
            if body.w != 0.0:
                twice_energy += body.w * body.w / body.inv_i if body.inv_i > 0.0 else math.inf
            arm = body.bounding_radius if body.corner_count > 0 else 0.0
            yields = 1.0 / body.mass + arm * arm * body.inv_i
            most_yielding = yields if yields > most_yielding else most_yielding
    return math.sqrt(twice_energy * most_yielding)


# The coefficients of pairs


def note(found: Coefficients, value: float) -> None:
    """Note the coefficient of one more body."""
    if value < 0.0:
        found.open_count += 1
        return
    found.own_count += 1
    if value > found.next_most:
        found.next_most = min(value, found.most)
        found.most = max(found.most, value)
    if value < found.next_least:
        found.next_least = max(value, found.least)
        found.least = min(found.least, value)


def most_of_pairs(rule: int, free: Coefficients, fixed: Coefficients) -> float:
    """Return the largest coefficient of the pairs in which one body can be pushed; 0 without any.

    Where both bodies have more, so has their pair: the extremes are enough.
    """
    most = 0.0
    if free.own_count > 1:
        most = mixed(rule, free.most, free.next_most)
    if free.own_count > 0 and fixed.own_count > 0:
        most = max(most, mixed(rule, free.most, fixed.most))
    if free.own_count > 0 and free.open_count + fixed.open_count > 0:
        most = max(most, free.most)
    if fixed.own_count > 0 and free.open_count > 0:
        most = max(most, fixed.most)
    return most


def least_of_pairs(rule: int, free: Coefficients, fixed: Coefficients) -> float:
    """Return the smallest coefficient of these pairs; 0 without any."""
    if free.open_count > 1 or (free.open_count > 0 and fixed.open_count > 0):
        return 0.0  # nobody says anything else
    least = math.inf
    if free.own_count > 1:
        least = mixed(rule, free.least, free.next_least)
    if free.own_count > 0 and fixed.own_count > 0:
        least = min(least, mixed(rule, free.least, fixed.least))
    if free.own_count > 0 and free.open_count + fixed.open_count > 0:
        least = min(least, free.least)
    if fixed.own_count > 0 and free.open_count > 0:
        least = min(least, fixed.least)
    return least if least < math.inf else 0.0

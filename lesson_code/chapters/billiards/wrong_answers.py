"""Wrong models of the billiards: the table's contacts and a step.

They use the constants and functions that the student's file has under the same names.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.billiards.rules import (
    TABLE,
    bumper_contact,
    resolve,
    wall_contacts,
)
from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any

WIDTH, HEIGHT, RADIUS, RESTITUTION = TABLE.width, TABLE.height, TABLE.radius, TABLE.restitution
NORMALS = {name: np.array(normal) for name, normal, _ in TABLE.walls}
BUMPER_START, BUMPER_END = np.array(TABLE.bumper_start), np.array(TABLE.bumper_end)
BUMPER_HALF_THICKNESS = TABLE.bumper_half_thickness


def _depths(position: Vector, reach: float) -> dict[str, Any]:
    """Return how far what reaches so far from a place is in each of the cushions."""
    x, y = position
    beyond = x - (WIDTH - reach), y - (HEIGHT - reach)
    return {"top": reach - y, "bottom": beyond[1], "left": reach - x, "right": beyond[0]}


@wrong_model("B.1", "A ball has a size. How far is its centre from the cushion when it touches?")
def forgets_the_radius(position: Vector) -> Any:
    """A ball meets the cushion when its centre does."""
    x, y = position
    depths = {"top": -y, "bottom": y - HEIGHT, "left": -x, "right": x - WIDTH}
    return [(name, NORMALS[name], depth) for name, depth in depths.items() if depth > 0]


@wrong_model("B.1", "Send a ball into a corner. How many cushions does it touch there?")
def one_cushion_at_a_time(position: Vector) -> Any:
    """A ball can touch only one cushion at a time."""
    depths = _depths(position, RADIUS)
    return [(name, NORMALS[name], depth) for name, depth in depths.items() if depth > 0][:1]


@wrong_model("B.1", "y grows downward here. Which way does the top cushion push the ball?")
def outward_normals(position: Vector) -> Any:
    """A cushion's normal points out of the table."""
    depths = _depths(position, RADIUS)
    return [(name, -NORMALS[name], depth) for name, depth in depths.items() if depth > 0]


@wrong_model("B.2", "A ball far behind the bumper, in the other half of the table: is it inside?")
def endless_half_plane(position: Vector) -> Any:
    """Everything on the far side of the bumper's line is inside the bumper."""
    along = BUMPER_END - BUMPER_START
    normal = np.array([along[1], -along[0]]) / np.hypot(along[0], along[1])
    depth = RADIUS + BUMPER_HALF_THICKNESS - np.dot(position - BUMPER_START, normal)
    return (normal, depth) if depth > 0 else None


def _beside(position: Vector, nearest: Vector, half: float = BUMPER_HALF_THICKNESS) -> Any:
    """Return normal and depth of a ball at the point of the bumper that is taken as nearest."""
    offset = position - nearest
    distance = np.hypot(offset[0], offset[1])
    depth = RADIUS + half - distance
    return (offset / distance, depth) if depth > 0 else None


@wrong_model("B.2", "Roll a ball past the end of the bumper. Does the line go on for ever?")
def endless_line(position: Vector) -> Any:
    """The bumper goes on beyond its ends."""
    along = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    return _beside(position, BUMPER_START + part * along)


@wrong_model("B.2", "Roll a ball straight at the end of the bumper. What is there to stop it?")
def nothing_at_the_ends(position: Vector) -> Any:
    """A bumper pushes only what is beside it, and not what comes to its ends."""
    along = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    return _beside(position, BUMPER_START + part * along) if 0 <= part <= 1 else None


@wrong_model("B.2", "Come from the other side. Which way should the bumper push you there?")
def one_sided(position: Vector) -> Any:
    """A bumper has one normal, whatever side the ball is on."""
    along = BUMPER_END - BUMPER_START
    normal = np.array([along[1], -along[0]]) / np.hypot(along[0], along[1])
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    offset = position - (BUMPER_START + min(max(part, 0.0), 1.0) * along)
    depth = RADIUS + BUMPER_HALF_THICKNESS - np.hypot(offset[0], offset[1])
    return (normal, depth) if depth > 0 else None


@wrong_model("B.2", "The bumper has a thickness too. How close may the centre come to its line?")
def thin_bumper(position: Vector) -> Any:
    """The bumper is as thin as its line."""
    along = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    offset = position - (BUMPER_START + min(max(part, 0.0), 1.0) * along)
    distance = np.hypot(offset[0], offset[1])
    return (offset / distance, RADIUS - distance) if distance < RADIUS else None


@wrong_model(
    "B.3", "A smooth cushion pushes along its normal. What slows the tangent part in yours?"
)
def scales_the_tangent(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """Restitution scales the whole mirror image: v' = e R."""
    v_n = np.dot(velocity, normal)
    if v_n < 0:
        velocity = RESTITUTION * (velocity - 2 * v_n * normal)
    return position + depth * normal, velocity


@wrong_model("B.3", "The ball is already leaving. What does your cushion do to it?")
def without_gate(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """Whatever overlaps is bounced, whichever way it moves."""
    v_n = np.dot(velocity, normal)
    return position + depth * normal, velocity - (1 + RESTITUTION) * v_n * normal


@wrong_model("B.3", "Where is the ball after your call: still inside the cushion?")
def stays_inside(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """Once the velocity is right, the position takes care of itself."""
    v_n = min(0.0, np.dot(velocity, normal))
    return position, velocity - (1 + RESTITUTION) * v_n * normal


@wrong_model("B.3", "The normal points from the cushion to the ball. Which way is out?")
def pushes_deeper(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """The normal points into the cushion."""
    v_n = min(0.0, np.dot(velocity, normal))
    return position - depth * normal, velocity - (1 + RESTITUTION) * v_n * normal


@wrong_model("B.4", "Where is the ball when you look for contacts: before the move, or after?")
def looks_before_it_moves(position: Vector, velocity: Vector, dt: float) -> Any:
    """Contacts are resolved first, and then the ball moves."""
    hits = []
    contact = bumper_contact(position)
    found = [("bumper", *contact)] if contact is not None else []
    for name, normal, depth in [*found, *wall_contacts(position)]:
        if np.dot(velocity, normal) < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    return position + velocity * dt, velocity, hits


@wrong_model("B.4", "In a corner two cushions push. What happens to the second one in your step?")
def first_contact_only(position: Vector, velocity: Vector, dt: float) -> Any:
    """One contact a step is enough; the next step finds the other."""
    position = position + velocity * dt
    contact = bumper_contact(position)
    found = [("bumper", *contact)] if contact is not None else []
    for name, normal, depth in [*found, *wall_contacts(position)]:
        hits = [name] if np.dot(velocity, normal) < 0 else []
        return (*resolve(position, velocity, normal, depth), hits)
    return position, velocity, []


@wrong_model("B.4", "The ball overlaps a cushion but is leaving it. Is that another hit?")
def counts_every_overlap(position: Vector, velocity: Vector, dt: float) -> Any:
    """Every overlap that is found is a hit."""
    position = position + velocity * dt
    hits = []
    contact = bumper_contact(position)
    if contact is not None:
        position, velocity = resolve(position, velocity, *contact)
        hits.append("bumper")
    for name, normal, depth in wall_contacts(position):
        position, velocity = resolve(position, velocity, normal, depth)
        hits.append(name)
    return position, velocity, hits


@wrong_model("B.2", "Walk along the bumper, and beyond its end. Which point of it is nearest then?")
def goes_on_beyond_one_end(position: Vector) -> Any:
    """Only the start of the bumper is an end."""
    along = BUMPER_END - BUMPER_START
    part = max((position - BUMPER_START) @ along / (along @ along), 0.0)
    return _beside(position, BUMPER_START + part * along)


@wrong_model("B.1", "On a screen: is y = 0 at the top or at the bottom?")
def y_points_upwards(position: Vector) -> Any:
    """The top of the table is where y is largest."""
    x, y = position
    depths = {
        "top": y + RADIUS - HEIGHT,
        "bottom": RADIUS - y,
        "left": RADIUS - x,
        "right": x + RADIUS - WIDTH,
    }
    return [(name, NORMALS[name], depth) for name, depth in depths.items() if depth > 0]


@wrong_model(
    "B.2", "You projected on a unit vector. In which unit is your number, and how far may it go?"
)
def length_taken_for_a_part(position: Vector) -> Any:
    """The way along the bumper goes from 0 to 1."""
    along = (BUMPER_END - BUMPER_START) / np.hypot(*(BUMPER_END - BUMPER_START))
    part = min(max((position - BUMPER_START) @ along, 0.0), 1.0)
    return _beside(position, BUMPER_START + part * along)


@wrong_model("B.2", "A ball comes to a round end. Is the push still at right angles to the bumper?")
def never_off_a_right_angle(position: Vector) -> Any:
    """A bumper pushes at right angles to itself, at its round ends, too."""
    along = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    offset = position - (BUMPER_START + min(max(part, 0.0), 1.0) * along)
    depth = RADIUS + BUMPER_HALF_THICKNESS - np.hypot(*offset)
    normal = np.array([-along[1], along[0]]) / np.hypot(*along)
    return (normal if offset @ normal >= 0 else -normal, depth) if depth > 0 else None


@wrong_model(
    "B.4", "Where should the ball be at the end of a step with a hit: at the wall, or off it?"
)
def flies_on_from_the_wall(position: Vector, velocity: Vector, dt: float) -> Any:
    """After a hit the ball flies on for as long as it was in the wall."""
    position, hits = position + velocity * dt, []

    def one(name: str, normal: Vector, depth: float) -> None:
        nonlocal position, velocity
        approach = -np.dot(velocity, normal)
        position, velocity = resolve(position, velocity, normal, depth)
        if approach > 0:
            hits.append(name)
            position = position + velocity * min(depth / approach, dt)

    bumper = bumper_contact(position)
    for contact in [] if bumper is None else [("bumper", *bumper)]:
        one(*contact)
    for contact in wall_contacts(position):
        one(*contact)
    return position, velocity, hits


@wrong_model("B.1", "A ball just touches a cushion. How deep does it overlap?")
def touching_is_overlapping(position: Vector) -> Any:
    """A ball that touches a cushion, with depth 0, overlaps it."""
    depths = _depths(position, RADIUS)
    return [(name, NORMALS[name], depth) for name, depth in depths.items() if depth >= 0]


@wrong_model("B.1", "How far is it from the centre of a ball to its rim?")
def diameter_for_radius(position: Vector) -> Any:
    """A ball overlaps a cushion that is nearer than its diameter."""
    depths = _depths(position, 2 * RADIUS)
    return [(name, NORMALS[name], depth) for name, depth in depths.items() if depth > 0]


@wrong_model("B.2", "From the bumper's middle line to its edge: is that all of its thickness?")
def twice_as_thick(position: Vector) -> Any:
    """The bumper reaches as far from its line as it is thick."""
    along = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    nearest = BUMPER_START + min(max(part, 0.0), 1.0) * along
    return _beside(position, nearest, 2 * BUMPER_HALF_THICKNESS)


@wrong_model("B.2", "A ball meets the middle of the bumper's side. How far is that from both ends?")
def ends_alone(position: Vector) -> Any:
    """The bumper is its two ends."""
    nearest = min((BUMPER_START, BUMPER_END), key=lambda end: float(np.hypot(*(position - end))))
    return _beside(position, nearest)


@wrong_model("B.3", "A ball inside the cushion, but leaving it: does it not have to be moved out?")
def leaves_what_leaves(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """A ball that is leaving needs nothing at all, not even to be moved out."""
    v_n = np.dot(velocity, normal)
    if v_n >= 0:
        return position, velocity
    return position + depth * normal, velocity - (1 + RESTITUTION) * v_n * normal


@wrong_model("B.3", "The ball is already leaving. What takes away a part of its speed in yours?")
def slows_what_leaves(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """Whichever way the ball moves, it leaves with e times its normal speed."""
    v_n = np.dot(velocity, normal)
    return position + depth * normal, velocity + (RESTITUTION * abs(v_n) - v_n) * normal


@wrong_model("B.3", "A ball comes in slowly. Is its restitution another one?")
def too_slow_to_bounce(position: Vector, velocity: Vector, normal: Vector, depth: float) -> Any:
    """A slow ball does not bounce: it stays at the cushion."""
    v_n = min(0.0, np.dot(velocity, normal))
    e = RESTITUTION if v_n < -1 else 0.0
    return position + depth * normal, velocity - (1 + e) * v_n * normal


@wrong_model("B.3", "By how much does the ball overlap, and by how much do you move it?")
def mirrored_at_the_cushion(
    position: Vector, velocity: Vector, normal: Vector, depth: float
) -> Any:
    """The ball went too far by the depth, so it comes back by that, and then e times that more."""
    factor, v_n = 1 + RESTITUTION, min(0.0, np.dot(velocity, normal))
    return position + factor * depth * normal, velocity - factor * v_n * normal


@wrong_model("B.4", "Which of the table's obstacles does your ball fly through?")
def passes_the_bumper(position: Vector, velocity: Vector, dt: float) -> Any:
    """A step looks at the cushions."""
    position, hits = position + velocity * dt, []
    for name, normal, depth in wall_contacts(position):
        hits += [name] if np.dot(velocity, normal) < 0 else []
        position, velocity = resolve(position, velocity, normal, depth)
    return position, velocity, hits


@wrong_model("B.4", "Which way does a ball move after it was resolved: still into the cushion?")
def asks_afterwards(position: Vector, velocity: Vector, dt: float) -> Any:
    """A contact is resolved, and then one sees whether it was a hit."""
    position, hits = position + velocity * dt, []
    contact = bumper_contact(position)
    found = [("bumper", *contact)] if contact is not None else []
    for name, normal, depth in found:
        position, velocity = resolve(position, velocity, normal, depth)
        hits += [name] if np.dot(velocity, normal) < 0 else []
    for name, normal, depth in wall_contacts(position):
        position, velocity = resolve(position, velocity, normal, depth)
        hits += [name] if np.dot(velocity, normal) < 0 else []
    return position, velocity, hits

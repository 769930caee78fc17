"""Wrong models of Breakout: the paddle, the time of impact, the flight."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.breakout.right_answers import by_recursion
from lesson_code.chapters.breakout.rules import STEEPEST, brick_impact
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any

SAMPLES = 60
"""Frames in a second."""


@wrong_model("K.1", "An offset of 0: does the ball go up, or to the right?")
def angle_from_the_horizontal(offset: float, speed: float) -> Any:
    """The angle is measured from the paddle."""
    angle = max(-1.0, min(1.0, offset)) * STEEPEST
    return speed * math.cos(angle), speed * math.sin(angle)


@wrong_model("K.1", "How fast is the ball after it has hit the paddle's end?")
def gains_speed(offset: float, speed: float) -> Any:
    """The paddle adds a sideways velocity; the upward one stays."""
    angle = max(-1.0, min(1.0, offset)) * STEEPEST
    return speed * math.tan(angle), speed


@wrong_model("K.1", "The ball's centre may be beyond the paddle's end. What is the offset then?")
def without_clamp(offset: float, speed: float) -> Any:
    """The offset is never beyond the paddle's ends."""
    return speed * math.sin(offset * STEEPEST), speed * math.cos(offset * STEEPEST)


@wrong_model("K.1", "Which way does y point here? Should the ball go up, or down?")
def downwards(offset: float, speed: float) -> Any:
    """Up is towards smaller y."""
    angle = max(-1.0, min(1.0, offset)) * STEEPEST
    return speed * math.sin(angle), -speed * math.cos(angle)


@wrong_model("K.2", "A ball has a size. Where is its centre when it touches?")
def a_point(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """The ball touches when its centre does."""
    return brick_impact(position, velocity, 1e-12, box)


@wrong_model(
    "K.2", "A ball flies past a corner, nearer than its radius on both axes. Do they touch?"
)
def square_corners(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """The brick grown by the radius is a rectangle."""
    low, high = box[:2] - radius, box[:2] + box[2:] + radius
    best = None
    for axis in (0, 1):
        for face, side in ((low, -1.0), (high, 1.0)):
            if velocity[axis] * side < 0:
                time = (face[axis] - position[axis]) / velocity[axis]
                along = position[1 - axis] + velocity[1 - axis] * time
                if 0 <= time <= 1 and low[1 - axis] <= along <= high[1 - axis]:
                    normal = [0.0, 0.0]
                    normal[axis] = side
                    best = (time, normal)
    return best


@wrong_model("K.2", "The ball crosses a thin brick between two of your samples. Does it see it?")
def samples(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """Looking sixty times in a second is enough."""
    for frame in range(SAMPLES + 1):
        time = frame / SAMPLES
        centre = position + velocity * time
        nearest = np.clip(centre, box[:2], box[:2] + box[2:])
        distance = np.hypot(*(centre - nearest))
        if distance <= radius:
            return time, (centre - nearest) / max(distance, 1e-12)
    return None


@wrong_model("K.2", "The normal is at the time of impact. Where is the ball then?")
def normal_at_the_start(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """The normal points from the brick to where the ball starts."""
    hit = brick_impact(position, velocity, radius, box)
    if hit is None:
        return None
    away = position - np.clip(position, box[:2], box[:2] + box[2:])
    return hit[0], away / np.hypot(*away)


@wrong_model("K.3", "A ball of 10,000 m/s: how often does your ball look for a brick on its way?")
def looks_at_the_end(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """First the ball moves, then it looks what it overlaps."""
    position = position + velocity * duration
    broken = []
    for k, brick in enumerate(bricks):
        nearest = np.clip(position, brick[:2], brick[:2] + brick[2:])
        distance = np.hypot(*(position - nearest))
        if 0 < distance <= radius:
            normal = (position - nearest) / distance
            velocity = velocity - 2 * np.dot(velocity, normal) * normal
            broken.append(k)
    return position, velocity, broken


@wrong_model("K.3", "Which brick lies first on the ball's way: the first in the list?")
def first_in_the_list(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """Bricks are met in the order of the list."""
    broken = []
    for k, brick in enumerate(bricks):
        hit = brick_impact(position, velocity, radius, brick)
        if hit is not None and hit[0] <= duration:
            position = position + velocity * hit[0]
            duration -= hit[0]
            velocity = velocity - 2 * np.dot(velocity, hit[1]) * np.asarray(hit[1])
            broken.append(k)
    return position + velocity * duration, velocity, broken


def _first(position: Vector, velocity: Vector, radius: float, bricks: Vector, gone: Any) -> Any:
    """Return time, place in the list and normal of the first impact, or None."""
    hits = [
        (hit[0], k, np.asarray(hit[1]))
        for k, brick in enumerate(bricks)
        if k not in gone and (hit := brick_impact(position, velocity, radius, brick)) is not None
    ]
    return min(hits, key=lambda hit: hit[0], default=None)


@wrong_model("K.3", "The ball has turned. What becomes of the time that is left?")
def stops_at_the_brick(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """A flight ends at the first brick."""
    first = _first(position, velocity, radius, bricks, ())
    if first is None or first[0] > duration:
        return position + velocity * duration, velocity, []
    time, k, normal = first
    after = velocity - 2 * np.dot(velocity, normal) * normal
    return position + velocity * time, after, [k]


@wrong_model("K.3", "Turn a brick's corner to the ball. Which part of the velocity does it turn?")
def flips_an_axis(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """A brick turns the upward velocity round, wherever it is hit."""
    broken: list[int] = []
    while True:
        first = _first(position, velocity, radius, bricks, broken)
        if first is None or first[0] > duration:
            return position + velocity * duration, velocity, broken
        position = position + velocity * first[0]
        duration -= first[0]
        velocity = velocity * np.array([1.0, -1.0])
        broken.append(first[1])


@wrong_model("K.1", "Half way out, by which angle should the ball leave, and by which does yours?")
def sideways_by_the_offset(offset: float, speed: float) -> tuple[float, float]:
    """The sideways part of the velocity is in proportion to the offset."""
    vx = max(-1.0, min(1.0, offset)) * speed * math.sin(STEEPEST)
    return vx, math.sqrt(speed * speed - vx * vx)


@wrong_model("K.2", "A ball comes at a corner from outside. Which face does it reach first?")
def faces_alone(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """A brick has four faces, and what misses them misses the brick."""
    low, high = box[:2], box[:2] + box[2:]
    found = []
    for axis in (0, 1):
        for face, side in ((low, -1.0), (high, 1.0)):
            if velocity[axis] * side < 0:
                time = (face[axis] + side * radius - position[axis]) / velocity[axis]
                along = position[1 - axis] + velocity[1 - axis] * time
                if 0 <= time <= 1 and low[1 - axis] <= along <= high[1 - axis]:
                    found.append((time, side * np.eye(2)[axis]))
    return min(found, key=lambda hit: hit[0], default=None)


@wrong_model("K.3", "A brick is gone from your list. Which number has the one behind it now?")
def places_among_those_left(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """A brick's number is its place among the bricks that still stand."""
    left, broken = list(bricks), list[int]()
    while True:
        first = _first(position, velocity, radius, left, ())
        if first is None or first[0] > duration:
            return position + velocity * duration, velocity, broken
        time, k, normal = first
        position = position + velocity * time
        velocity = velocity - 2 * np.dot(velocity, normal) * normal
        duration -= time
        broken.append(k)
        del left[k]


@wrong_model(
    "K.2", "A ball meets a corner. Which way does the way from the corner to its centre point?"
)
def corners_push_along_an_axis(
    position: Vector, velocity: Vector, radius: float, box: Vector
) -> Any:
    """A corner belongs to a face, and pushes as that does."""
    hit = brick_impact(position, velocity, radius, box)
    if hit is None:
        return None
    normal, axis = np.zeros(2), int(np.argmax(np.abs(hit[1])))
    normal[axis] = np.sign(hit[1][axis])
    return hit[0], normal


@wrong_model("K.1", "How fast is the ball after your paddle, and how fast was it before?")
def offset_for_the_tangent(offset: float, speed: float) -> Any:
    """The paddle adds the part `offset` of the speed sideways; the upward part stays."""
    offset = min(max(offset, -1.0), 1.0)
    return offset * speed, speed


@wrong_model("K.1", "At the end of the paddle: does the ball leave along the paddle?")
def offset_for_the_sine(offset: float, speed: float) -> Any:
    """The offset is the sideways part of the speed."""
    offset = min(max(offset, -1.0), 1.0)
    return offset * speed, math.sqrt(1 - offset**2) * speed


@wrong_model("K.1", "Which unit do sine and cosine take?")
def sixty_radians(offset: float, speed: float) -> Any:
    """Sine and cosine take degrees."""
    angle = 60 * min(max(offset, -1.0), 1.0)
    return speed * math.sin(angle), speed * math.cos(angle)


@wrong_model("K.1", "A ball that hits beyond the end: what does the task count it as?")
def straight_up_beyond_the_ends(offset: float, speed: float) -> Any:
    """What does not hit the paddle is not turned aside."""
    angle = offset * STEEPEST if abs(offset) <= 1 else 0.0
    return speed * math.sin(angle), speed * math.cos(angle)


@wrong_model("K.2", "A ball meets a face at a slant. Which way does the face push it?")
def pushes_straight_back(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """A brick pushes the ball back the way it came."""
    hit = brick_impact(position, velocity, radius, box)
    return hit and (hit[0], -velocity / np.hypot(*velocity))


@wrong_model("K.2", "A ball meets the left part of a wide brick's top. Which way is it pushed?")
def away_from_the_middle(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """A brick pushes away from its middle, as a disc does."""
    hit = brick_impact(position, velocity, radius, box)
    if hit is None:
        return None
    away = position + velocity * hit[0] - (box[:2] + box[2:] / 2)
    return hit[0], away / np.hypot(*away)


@wrong_model("K.3", "A ball meets a face at a slant. Does it come back into your hand?")
@edited(by_recursion, {"mirror @ v": "-v"})
def straight_back() -> None:
    """A brick sends the ball back the way it came."""


@wrong_model("K.3", "A brick stops the ball along the normal. Does it give nothing back?")
@edited(by_recursion, {"2 * np.outer(n, n)": "np.outer(n, n)"})
def slides_along() -> None:
    """A brick takes the normal part of the velocity away."""


@wrong_model("K.3", "In which order were the bricks broken?")
def places_in_order_of_size(
    position: Vector, velocity: Vector, radius: float, bricks: Vector, duration: float
) -> Any:
    """The bricks are told in the order of their places in the list."""
    end, after, broken = by_recursion(position, velocity, radius, bricks, duration)
    return end, after, sorted(broken)


@wrong_model("K.3", "A ball comes back to where a brick was. Is it still there?")
@edited(by_recursion, {"if name != k": "if name != -1"})
def bricks_do_not_break() -> None:
    """Bricks that were met stay where they are."""


@wrong_model("K.2", "The ball meets the brick after more than HORIZON. What was asked for then?")
def beyond_the_horizon(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """A ball that flies towards a brick meets it, however long it takes."""
    hit = brick_impact(position, 100 * velocity, radius, box)
    return None if hit is None else (100 * hit[0], hit[1])


@wrong_model("K.2", "Which corner is nearest now? Is it that which the ball will meet?")
def nearest_corner_only(position: Vector, velocity: Vector, radius: float, box: Vector) -> Any:
    """A ball that meets no face can only meet the corner that is nearest when it sets out."""
    x, y, wide, high = box
    hit = brick_impact(position, velocity, radius, box)
    if hit is None or 0.0 in hit[1]:
        return hit
    corners = [(a, b) for a in (x, x + wide) for b in (y, y + high)]
    nearest = min(corners, key=lambda corner: math.dist(corner, position))
    touch = np.asarray(position) + hit[0] * np.asarray(velocity) - radius * np.asarray(hit[1])
    return hit if math.dist(touch, nearest) < 1e-6 else None

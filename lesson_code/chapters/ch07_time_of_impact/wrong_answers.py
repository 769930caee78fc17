"""Wrong models of chapter 07: times of impact, and the rest of the step.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch07_time_of_impact.right_answers import (
    from_wall_to_wall,
    with_the_quadratic_formula,
)
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any
Time: TypeAlias = float | None
ROOT = "max(c, 0.0) / (-b + sqrt(b * b - a * c))"
"""The smaller root, as the right answer by the quadratic formula has it."""


@wrong_model("7.1", "The hit comes after the end of the step. Whose business is it then?")
@edited(with_the_quadratic_formula, {"t if t <= dt else None": "t"})
def beyond_the_step() -> None:
    """Circles on a collision course hit; the length of the step plays no part."""


@wrong_model("7.1", "A circle crosses another one in a hundredth of the step. Do ten looks see it?")
def ten_samples(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """Whoever looks ten times in a step sees every hit."""
    for k in range(11):
        t = k / 10 * dt
        if np.hypot(*(p2 + v2 * t - p1 - v1 * t)) <= r1 + r2:
            return t
    return None


@wrong_model("7.1", "The quadratic has two roots: the circles touch twice. Which comes first?")
@edited(with_the_quadratic_formula, {ROOT: "(-b + sqrt(b * b - a * c)) / a if c > 0 else 0.0"})
def the_later_root() -> None:
    """The root with the plus sign is the time of impact."""


@wrong_model("7.1", "Is your time ever negative? What would that say about the hit?")
@edited(
    with_the_quadratic_formula, {"b >= 0 or": "a == 0 or", ROOT: "(-b - sqrt(b * b - a * c)) / a"}
)
def negative_time() -> None:
    """The smaller root is the time of impact, whatever its sign."""


@wrong_model("7.1", "Both circles move. What does the second one look like, seen from the first?")
@edited(with_the_quadratic_formula, {"v2 - v1": "-v1"})
def second_velocity_ignored() -> None:
    """Circle 1 flies towards circle 2, which waits."""


@wrong_model("7.1", "At your time the circles are nearest. Had they touched before that?")
def nearest_approach(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """Circles hit at the moment when their centres are nearest."""
    d, v = p2 - p1, v2 - v1
    if d @ v >= 0:
        return None
    t = -(d @ v) / (v @ v)
    return float(t) if t <= dt and np.hypot(*(d + v * t)) < r1 + r2 else None


@wrong_model("7.1", "Must a circle that passes beside the other fly the whole gap to touch it?")
def as_if_head_on(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """The time is the gap over the speed, whichever way it is crossed."""
    d, v, reach = p2 - p1, v2 - v1, r1 + r2
    if d @ v >= 0 or abs(d[0] * v[1] - d[1] * v[0]) > reach * np.hypot(*v):
        return None
    t = max(0.0, float((np.hypot(*d) - reach) / np.hypot(*v)))
    return t if t <= dt else None


@wrong_model("7.1", "Two circles fly side by side, a metre apart. When do they meet?")
@edited(with_the_quadratic_formula, {"return None": "return None if a else 0.0"})
def side_by_side_is_now() -> None:
    """Where the quadratic has no square, its root is 0."""


@wrong_model("7.1", "The circles overlap and still approach. When is that hit to be resolved?")
@edited(with_the_quadratic_formula, {"b >= 0": "b >= 0 or c <= 0"})
def too_late_when_overlapping() -> None:
    """A time of impact is greater than 0; circles that touch or overlap have met before."""


@wrong_model("7.1", "The circles overlap, but they part. Is there anything left to collide?")
@edited(with_the_quadratic_formula, {"return None": "return None if c > 0 else 0.0"})
def overlapping_is_always_now() -> None:
    """Circles that touch or overlap hit at once, whichever way they move."""


@wrong_model("7.2", "Take 0.5 from 0.50000000000001. How many digits are left for your time?")
def school_formula(height: float, velocity: float, gravity: float) -> Time:
    """The formula from school is as good as any other: it is the same number."""
    return (velocity + math.sqrt(velocity**2 + 2 * gravity * height)) / gravity


@wrong_model("7.2", "Your time is negative. When did it leave the floor, and when is it back?")
def the_root_in_the_past(height: float, velocity: float, gravity: float) -> Time:
    """Of two roots the smaller one is the first hit."""
    if gravity == 0:
        return height / -velocity if velocity < 0 else None
    return (velocity - math.sqrt(velocity**2 + 2 * gravity * height)) / gravity


@wrong_model("7.2", "How fast is the ball when it hits the floor: as fast as at the start?")
def without_gravity(height: float, velocity: float, gravity: float) -> Time:
    """The time is the way over the velocity."""
    return height / -velocity if velocity < 0 else None


@wrong_model("7.2", "From which height does your ball fall: from where it was thrown, or higher?")
def falls_from_the_start(height: float, velocity: float, gravity: float) -> Time:
    """A ball that is thrown up takes v/g to its top, and then falls from its first height."""
    if velocity < 0:
        speed = math.sqrt(velocity**2 + 2 * gravity * height)
        return 2 * height / (speed - velocity)
    return velocity / gravity + math.sqrt(2 * height / gravity) if gravity > 0 else None


@wrong_model("7.2", "Throw one ball down and let another one go. Do they land together?")
def as_if_let_go(height: float, velocity: float, gravity: float) -> Time:
    """Every fall takes the square root of 2 h / g."""
    return math.sqrt(2 * height / gravity) if gravity > 0 else None


@wrong_model("7.2", "How far does a body fall in the first second: 9.81 m, or half of it?")
def half_forgotten(height: float, velocity: float, gravity: float) -> Time:
    """A fall makes the way g t^2."""
    speed = math.sqrt(velocity**2 + 4 * gravity * height)
    if velocity < 0:
        return 2 * height / (speed - velocity)
    return (velocity + speed) / (2 * gravity) if gravity > 0 else None


@wrong_model("7.2", "The ball lies on the floor and has just bounced up. When does it hit it next?")
def on_the_floor_is_now(height: float, velocity: float, gravity: float) -> Time:
    """A ball at the floor hits it now."""
    if height == 0:
        return 0.0
    speed = math.sqrt(velocity**2 + 2 * gravity * height)
    if velocity < 0:
        return 2 * height / (speed - velocity)
    return (velocity + speed) / gravity if gravity > 0 else None


@wrong_model("7.2", "A ball is thrown upwards. Does that make it land earlier?")
def down_is_positive(height: float, velocity: float, gravity: float) -> Time:
    """The velocity is counted downwards."""
    speed = math.sqrt(velocity**2 + 2 * gravity * height)
    if velocity > 0:
        return 2 * height / (speed + velocity)
    return (speed - velocity) / gravity if gravity > 0 else None


@wrong_model("7.3", "The ball bounces after a third of the step. Where are the other two thirds?")
@edited(from_wall_to_wall, {"left - times[axis]": "0.0"})
def stops_at_the_impact() -> None:
    """A step with an impact ends at the impact."""


@wrong_model("7.3", "After the bounce the ball flies on. Can it meet another wall in this step?")
@edited(
    from_wall_to_wall,
    {"restitution * v, v)": "restitution * v, v)\n        return p + v * left, v"},
)
def one_impact_a_step() -> None:
    """There is one impact in a step at the most."""


@wrong_model("7.3", "Is the ball at the wall at the end of the step, or was it there before?")
def clamps_at_the_walls(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> tuple[Vector, Vector]:
    """A ball that has passed a wall is set back to it, and its velocity turned round."""
    moved = p + v * dt
    outside = (moved < 0) | (moved > room)
    return np.clip(moved, 0, room), np.where(outside, -restitution * v, v)


@wrong_model("7.3", "A ball comes back slower than it came. How far does it get in the same time?")
def mirrors_the_rest(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> tuple[Vector, Vector]:
    """What the ball would be beyond the wall, it is on this side of it."""
    moved, after = p + v * dt, np.array(v)
    for axis in range(2):
        while not 0 <= moved[axis] <= room[axis]:
            wall = 0 if moved[axis] < 0 else room[axis]
            moved[axis] = 2 * wall - moved[axis]
            after[axis] = -restitution * after[axis]
    return moved, after


@wrong_model("7.3", "Add up the times in your step: to the wall, and after it. Is it dt?")
@edited(
    from_wall_to_wall,
    {"restitution * v, v)": "restitution * v, v)\n        return p + v * dt, v"},
)
def a_whole_step_after_the_impact() -> None:
    """The ball goes to the wall, bounces, and then makes its step."""


@wrong_model("7.3", "Where does your ball turn round: at the wall, or where the step began?")
def bounces_at_the_start(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> tuple[Vector, Vector]:
    """A ball that will pass a wall in this step bounces, and then makes its step."""
    moved = p + v * dt
    after = np.where((moved < 0) | (moved > room), -restitution * v, v)
    return p + after * dt, after


@wrong_model("7.3", "The ball is at the wall and moves into it. Is a time of 0.0 no time?")
@edited(
    from_wall_to_wall,
    {
        "np.argmin(times)": "np.argmin([t if t else np.inf for t in times])",
        "times[axis] >= left": "not times[axis] or times[axis] >= left",
    },
)
def zero_is_no_time() -> None:
    """`if t` asks whether there is an impact."""


@wrong_model("7.3", "The floor turns the velocity round along y. Does it touch the part along x?")
@edited(
    from_wall_to_wall,
    {
        "np.where(np.arange(2) == axis, -restitution * v, v)": (
            "restitution * np.where(np.arange(2) == axis, -v, v)"
        )
    },
)
def scales_the_tangent() -> None:
    """A bounce makes the whole velocity smaller."""


@wrong_model("7.1", "When their centres are nearest, have the rims not met long before?")
@edited(
    nearest_approach,
    {"    t = -": "    if d @ d <= (r1 + r2) ** 2:\n        return 0.0\n    t = -"},
)
def nearest_approach_if_near_enough() -> None:
    """Circles whose centres come near enough meet when they are nearest."""


@wrong_model("7.1", "The circles pass each other. Does the gap close all the time as fast as now?")
@edited(
    with_the_quadratic_formula,
    {
        "b >= 0 or b * b - a * c < 0": "b >= 0",
        "-b + sqrt(b * b - a * c)": "-b * (1 + (r1 + r2) / sqrt(d @ d))",
    },
)
def the_gap_closes_evenly() -> None:
    """The gap closes along the line of the centres, as fast as it does at the beginning."""


@wrong_model("7.1", "Two circles fly side by side, both fast. How fast does their gap close?")
def gap_over_both_speeds(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """The gap closes as fast as both circles fly together."""
    if (p2 - p1) @ (v2 - v1) >= 0:
        return None
    t = max(np.hypot(*(p2 - p1)) - r1 - r2, 0.0) / (np.hypot(*v1) + np.hypot(*v2))
    return t if t <= dt else None


@wrong_model("7.1", "The circles pass through each other in the step. What do you see at its end?")
@edited(ten_samples, {"for k in range(11):": "for k in [10]:"})
def looks_at_the_end_alone() -> None:
    """Circles hit in a step if they overlap at its end, and the time of the hit is dt."""


@wrong_model("7.1", "How large may the error of your time be: one part in a thousand of the step?")
@edited(
    ten_samples,
    {
        "for k in range(11):": "for k in range(1001 if (p2 - p1) @ (v2 - v1) < 0 else 0):",
        "k / 10 * dt": "k * dt / 1000",
    },
)
def a_thousand_samples() -> None:
    """With steps that are small enough, the first look that sees an overlap tells the time."""


@wrong_model(
    "7.1", "Draw a circle and the square around it. Is what is in the square in the circle?"
)
def as_squares(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """Circles meet when they are less than both radii apart along x and along y."""
    d, v, first, last = p2 - p1, v2 - v1, 0.0, dt
    if d @ v >= 0:
        return None
    for x, u in zip(d, v, strict=True):
        times = sorted([(-r1 - r2 - x) / u, (r1 + r2 - x) / u])
        first, last = max(first, times[0]), min(last, times[1])
    return first if first <= last else None


@wrong_model(
    "7.1", "Your b: is it all that stands before t, or half of it? And what is 4 a c then?"
)
@edited(
    with_the_quadratic_formula,
    {
        "b * b - a * c < 0": "c > 0 and b * b - 4 * a * c < 0",
        ROOT: "(-b - sqrt(b * b - 4 * a * c)) / (2 * a) if c > 0 else 0.0",
    },
)
def half_of_b_in_the_whole_formula() -> None:
    """The formula with 4 a c takes half of what stands before t for b."""


@wrong_model("7.1", "The circles meet in ten seconds, and the step is one. When do they hit in it?")
@edited(with_the_quadratic_formula, {"t if t <= dt else None": "min(t, dt)"})
def late_hits_at_the_end() -> None:
    """A hit after the end of the step is one at its end."""


@wrong_model("7.2", "How fast is the ball when it is back at its height, and does it stay so?")
def evenly_from_its_height(height: float, velocity: float, gravity: float) -> Time:
    """What is thrown up comes back after 2 v / g; from there the time is the way over the speed."""
    if velocity > 0:
        return 2 * velocity / gravity + height / velocity if gravity > 0 else None
    return height / -velocity if velocity < 0 else np.sqrt(2 * height / gravity)


@wrong_model("7.2", "Throw a ball up. Will you wait for it in vain?")
def up_is_away(height: float, velocity: float, gravity: float) -> Time:
    """A ball that flies up moves away from the floor, so it never hits it."""
    speed = math.sqrt(velocity**2 + 2 * gravity * height)
    return None if velocity > 0 or speed == 0 else 2 * height / (speed - velocity)


@wrong_model("7.2", "On an asteroid a stone falls for days. Does it ever arrive?")
def a_little_gravity_is_none(height: float, velocity: float, gravity: float) -> Time:
    """Gravity that is very small counts as 0."""
    if gravity < 1e-9:
        return height / -velocity if velocity < 0 else None
    speed = math.sqrt(velocity**2 + 2 * gravity * height)
    return 2 * height / (speed - velocity) if velocity < 0 else (velocity + speed) / gravity


@wrong_model("7.3", "A wall is near, and the ball flies almost along it. Which wall comes first?")
@edited(from_wall_to_wall, {"np.argmin(times)": "np.argmin(np.abs(v) * times)"})
def nearest_wall_first() -> None:
    """The wall that is nearest is the one that is hit first."""

"""Wrong models of chapter 07: more about falls, and the rest of the step."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch07_time_of_impact.right_answers import from_wall_to_wall
from lesson_code.course.grading.task import edited, wrong_model

Time: TypeAlias = Any


@wrong_model("7.2", "How high does a ball fly that starts at v: v^2 / g, or half of it?")
def flies_up_twice_as_high(height: float, velocity: float, gravity: float) -> Time:
    """A ball that is thrown up rises by v^2 / g."""
    if velocity > 0:
        top = height + velocity**2 / gravity if gravity > 0 else 0.0
        return velocity / gravity + np.sqrt(2 * top / gravity) if gravity > 0 else None
    speed = np.sqrt(velocity**2 + 2 * gravity * height)
    return 2 * height / (speed - velocity) if speed > 0 else None


@wrong_model("7.2", "A ball falls on the moon. Which gravity is there?")
def always_on_the_earth(height: float, velocity: float, gravity: float) -> Time:
    """Gravity is 9.81 m/s^2, wherever there is any."""
    g = 9.81 if gravity > 0 else 0.0
    speed = np.sqrt(velocity**2 + 2 * g * height)
    if velocity < 0:
        return 2 * height / (speed - velocity)
    return (velocity + speed) / g if g > 0 else None


@wrong_model("7.3", "The ball has become slower. Does its clock go slower, too?")
@edited(from_wall_to_wall, {"left - times[axis]": "restitution * (left - times[axis])"})
def rest_shrinks_with_the_bounce() -> None:
    """A bounce makes the rest of the step shorter by e, as it does the velocity."""


@wrong_model("7.3", "Where is the left wall of the room: at 0, or as far from 0 as the right one?")
@edited(from_wall_to_wall, {"else 0.0": "else -s"})
def origin_in_the_middle() -> None:
    """The origin is in the middle of the room, and its sides are half of it."""


@wrong_model("7.3", "A room is longer than it is wide. Which side belongs to y?")
@edited(from_wall_to_wall, {"zip(v, room, strict=True)": "zip(v, [room[0], room[0]], strict=True)"})
def as_high_as_wide() -> None:
    """The room is as high as it is wide."""


@wrong_model("7.3", "Your ball comes back from each wall as fast as it came. What is e for?")
@edited(from_wall_to_wall, {"-restitution * v": "-v"})
def elastic_walls() -> None:
    """A bounce turns the velocity round, and costs none of it."""


@wrong_model("7.2", "Nothing pulls a ball that already moves down. Does it ever arrive?")
def no_gravity_no_landing(height: float, velocity: float, gravity: float) -> Time:
    """What nothing pulls down does not come down."""
    if gravity == 0:
        return None
    speed = np.sqrt(velocity**2 + 2 * gravity * height)
    return 2 * height / (speed - velocity) if velocity < 0 else (velocity + speed) / gravity

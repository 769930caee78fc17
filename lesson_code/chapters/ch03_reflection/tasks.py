"""Tasks of chapter 03: reflection and bounce."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.chapters import draws
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.course.isolation.inside.vectors import vector
from lesson_code.formulas import bounce, reflect

LEVEL_NORMALS = ((0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0))
"""The inward normals of a floor, a ceiling, a left wall and a right wall, y up."""


def at_level_walls(stream: Random) -> Iterator[Arguments]:
    """Draw a velocity into each of four walls."""
    for normal in LEVEL_NORMALS:
        yield draws.velocity_into(stream, normal), normal


def at_tilted_walls(stream: Random) -> Iterator[Arguments]:
    """Draw velocities into walls that stand at an angle."""
    for _ in range(3):
        normal = draws.oblique_normal(stream)
        yield draws.velocity_into(stream, normal), normal


def from_behind(stream: Random) -> Iterator[Arguments]:
    """Draw velocities against the back of a wall: a mirror has two sides."""
    for _ in range(2):
        normal = draws.oblique_normal(stream)
        yield draws.velocity_away(stream, normal), normal


def coming_in(stream: Random) -> Iterator[Arguments]:
    """Draw lossy bounces off tilted walls, the last one of a ball that comes slowly."""
    for how_fast in (draws.speed, draws.speed, draws.creep):
        normal = draws.oblique_normal(stream)
        yield draws.velocity_into(stream, normal, how_fast), normal, draws.restitution(stream)


def leaving(stream: Random) -> Iterator[Arguments]:
    """Draw velocities that already lead away from the wall, fast and slowly."""
    for how_fast in (draws.speed, draws.creep):
        normal = draws.oblique_normal(stream)
        yield draws.velocity_away(stream, normal, how_fast), normal, draws.restitution(stream)


def lossy_level(stream: Random) -> Iterator[Arguments]:
    """Draw lossy bounces off the floor and the left wall."""
    for normal in (LEVEL_NORMALS[0], LEVEL_NORMALS[2]):
        yield draws.velocity_into(stream, normal), normal, draws.restitution(stream)


def without_loss(stream: Random) -> Iterator[Arguments]:
    """Draw bounces with restitution 1 and 0."""
    for restitution in (1.0, 0.0):
        normal = draws.oblique_normal(stream)
        yield draws.velocity_into(stream, normal), normal, restitution


def inside_coming_in(stream: Random) -> Iterator[Arguments]:
    """Draw balls that overlap the wall and move into it."""
    for velocity, normal, restitution in coming_in(stream):
        yield _position(stream), velocity, normal, _depth(stream), restitution


def inside_leaving(stream: Random) -> Iterator[Arguments]:
    """Draw balls that overlap the wall and are already on their way out."""
    for velocity, normal, restitution in leaving(stream):
        yield _position(stream), velocity, normal, _depth(stream), restitution


def _position(stream: Random) -> draws.Vector:
    """Return a position, m."""
    return round(stream.uniform(-5, 5), 2), round(stream.uniform(-5, 5), 2)


def _depth(stream: Random) -> float:
    """Return a depth of overlap, m."""
    return round(stream.uniform(0.1, 0.5), 2)


def _pushed_out_and_bounced(
    position: Any, velocity: Any, normal: Any, depth: float, restitution: float
) -> tuple[Any, Any]:
    """Return position and velocity after the ball was moved out of the wall and bounced."""
    return position + depth * normal, bounce(velocity, normal, restitution)


def speed_before_and_after(arguments: Arguments, answer: Any) -> str:
    """Say what a mirror does to the speed, and what the answer does."""
    return f"Speed before {_speed(arguments[0])}, after yours {_speed(answer)}: a mirror keeps it."


def parts_of_the_answer(arguments: Arguments, answer: Any) -> str:
    """Say which parts of the velocity the answer has changed."""
    velocity, normal = vector(arguments[0]), vector(arguments[1])
    tangent = vector([-normal[1], normal[0]])
    if not _is_vector(answer):
        return "A velocity with two components was asked for."
    return (
        f"Along the normal {_along(velocity, normal)} before, {_along(answer, normal)} after yours;"
        f" along the wall {_along(velocity, tangent)} before, {_along(answer, tangent)} after."
    )


def _along(velocity: Any, direction: Any) -> str:
    """Return a velocity's part along a unit direction, written."""
    return written(float(vector(velocity) @ direction))


def _speed(velocity: Any) -> str:
    """Return the length of a velocity, written, or a question mark for anything else."""
    return written(math.hypot(*velocity)) if _is_vector(velocity) else "?"


def _is_vector(value: Any) -> bool:
    """Return whether a plain value is a pair of numbers."""
    return (
        isinstance(value, list | tuple)
        and len(value) == 2
        and all(isinstance(component, int | float) for component in value)
    )


TASKS = (
    Task(
        id="3.1",
        function="reflect",
        section=1,
        objective="The mirror image of a velocity at a wall.",
        expected=reflect,
        criteria=(
            Criterion("level walls", at_level_walls),
            Criterion("tilted walls", at_tilted_walls, points=2),
            Criterion("the back of a wall", from_behind),
        ),
        explain=speed_before_and_after,
    ),
    Task(
        id="3.2",
        function="bounce",
        section=3,
        objective="The velocity after a bounce with restitution.",
        expected=bounce,
        criteria=(
            Criterion("level walls", lossy_level),
            Criterion("tilted walls", coming_in),
            Criterion("a ball that is already leaving", leaving),
            Criterion("the limits e = 1 and e = 0", without_loss),
        ),
        explain=parts_of_the_answer,
    ),
    Task(
        id="3.3",
        function="resolve_wall",
        section=6,
        objective="Separate first: position and velocity of a ball found inside a wall.",
        expected=_pushed_out_and_bounced,
        criteria=(
            Criterion("a ball moving in", inside_coming_in, points=2),
            Criterion("a ball moving out", inside_leaving, points=2),
        ),
    ),
)

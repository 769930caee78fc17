"""Unusual right answers to the billiards."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.billiards.rules import (
    TIME_STEP,
    bumper_contact,
    resolve,
    step,
    wall_contacts,
)
from lesson_code.chapters.billiards.wrong_answers import (
    BUMPER_END,
    BUMPER_HALF_THICKNESS,
    BUMPER_START,
    HEIGHT,
    RADIUS,
    RESTITUTION,
    WIDTH,
)
from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("B.1")
def one_if_a_wall(position: Vector) -> Any:
    """Four ifs; normals are tuples, contacts are lists."""
    x, y = position
    contacts = []
    if y < RADIUS:
        contacts.append(["top", (0, 1), RADIUS - y])
    if y > HEIGHT - RADIUS:
        contacts.append(["bottom", (0, -1), y + RADIUS - HEIGHT])
    if x < RADIUS:
        contacts.append(["left", (1, 0), RADIUS - x])
    if x > WIDTH - RADIUS:
        contacts.append(["right", (-1, 0), x + RADIUS - WIDTH])
    return contacts


@alternative("B.2")
def with_complex_numbers(position: Vector) -> Any:
    """The bumper's line is turned onto the real axis; a complex normal comes back."""
    start, end, ball = complex(*BUMPER_START), complex(*BUMPER_END), complex(*position)
    direction = (end - start) / abs(end - start)
    turned = (ball - start) / direction
    closest = min(max(turned.real, 0.0), abs(end - start))
    offset = (turned - closest) * direction
    depth = RADIUS + BUMPER_HALF_THICKNESS - abs(offset)
    return (offset / abs(offset), depth) if depth > 0 else None


@alternative("B.3")
def normal_and_tangent_parts(
    position: Vector, velocity: Vector, normal: Vector, depth: float
) -> Any:
    """The velocity is taken apart, its normal part changed, and put together again."""
    normal_part = np.dot(velocity, normal) * normal
    tangent_part = velocity - normal_part
    if np.dot(velocity, normal) < 0:
        normal_part = -RESTITUTION * normal_part
    return [position + depth * normal, tangent_part + normal_part]


@alternative("B.4")
def changes_its_arguments(position: Vector, velocity: Vector, dt: float) -> Any:
    """Position and velocity are changed in place; the hits are a tuple."""
    position += velocity * dt
    hits: tuple[str, ...] = ()
    for find in (
        lambda: [("bumper", *(bumper_contact(position) or (None, 0.0)))],
        lambda: wall_contacts(position),
    ):
        for name, normal, depth in find():
            if normal is None:
                continue
            if float(velocity @ normal) < 0:
                hits = (*hits, name)
            position[:], velocity[:] = resolve(position, velocity, normal, depth)
    return position, velocity, hits


@alternative("B.5")
def counts_steps_with_divmod(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """The steps are counted in sixtieths; what is left over is given back in seconds."""
    steps, rest = divmod(elapsed * 60 + 1e-9, 1)
    hits: list[str] = []
    for _ in range(int(steps)):
        position, velocity, new_hits = step(position, velocity, TIME_STEP)
        hits.extend(new_hits)
    return position, velocity, hits, max(0.0, rest - 1e-9) / 60

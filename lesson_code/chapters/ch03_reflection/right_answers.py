"""Unusual right answers to chapter 03: reflection and bounce."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("3.1")
def with_a_matrix(incident: Vector, normal: Vector) -> Vector:
    """The mirror is the matrix 1 - 2 N N^T."""
    import numpy as np

    return (np.eye(2) - 2 * np.outer(normal, normal)) @ incident


@alternative("3.1")
def with_angles(incident: Vector, normal: Vector) -> tuple[float, float]:
    """The angle to the wall is the same on both sides."""
    from math import atan2, cos, hypot, pi, sin

    wall = atan2(normal[1], normal[0]) + pi / 2
    angle = 2 * wall - atan2(incident[1], incident[0])
    speed = hypot(incident[0], incident[1])
    return speed * cos(angle), speed * sin(angle)


@alternative("3.1")
def with_complex_numbers(incident: Vector, normal: Vector) -> complex:
    """Mirroring is a conjugate in the frame of the normal; a complex number comes back."""
    i, n = complex(*incident), complex(*normal)
    return -n * n * i.conjugate()


@alternative("3.1")
def with_pygame(incident: Vector, normal: Vector) -> object:
    """The vector class of pygame has a mirror of its own; its vector comes back."""
    from pygame import Vector2

    return Vector2(*incident).reflect(Vector2(*normal))


@alternative("3.1")
def with_the_other_normal(incident: Vector, normal: Vector) -> list[float]:
    """Which way the normal points makes no difference to the mirror; a list comes back."""
    n_x, n_y = -normal[0], -normal[1]
    i_n = incident[0] * n_x + incident[1] * n_y
    return [incident[0] - 2 * i_n * n_x, incident[1] - 2 * i_n * n_y]


@alternative("3.2")
def normal_and_tangent_parts(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """The velocity is taken apart, its parts changed, and put together again."""
    import numpy as np

    normal_part = np.dot(velocity, normal) * normal
    tangent_part = velocity - normal_part
    if np.dot(velocity, normal) < 0:
        normal_part = -restitution * normal_part
    return tangent_part + normal_part


@alternative("3.2")
def mixed_from_the_mirror(
    velocity: Vector, normal: Vector, restitution: float
) -> tuple[float, ...]:
    """A bounce lies between sliding along the wall and the mirror image."""
    v_n = velocity[0] * normal[0] + velocity[1] * normal[1]
    if v_n > 0:
        return tuple(velocity)
    return tuple(
        (1 - restitution) * (v - v_n * n) + restitution * (v - 2 * v_n * n)
        for v, n in zip(velocity, normal, strict=True)
    )


@alternative("3.3")
def in_place(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """The arguments themselves are changed and handed back."""
    position += depth * normal
    velocity -= (1 + restitution) * min(0.0, float(velocity @ normal)) * normal
    return [position, velocity]

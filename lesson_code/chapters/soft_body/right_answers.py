"""Unusual right answers to the soft body."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.soft_body.rules import BLOB, pressure_forces, ring_forces
from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("S.1")
def fan_of_triangles(positions: Vector) -> Any:
    """Triangles from the first mass to each edge, by complex numbers."""
    points = [complex(*p) - complex(*positions[0]) for p in positions]
    return sum((a.conjugate() * b).imag for a, b in pairwise(points)) / 2


@alternative("S.2")
def spring_by_spring(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """A loop over complex numbers; index -1 closes the ring."""
    place, speed = ([complex(*row) for row in rows] for rows in (positions, velocities))
    forces = [0j] * len(place)
    for k in range(-1, len(place) - 1):
        line = place[k + 1] - place[k]
        u = line / abs(line)
        faster = ((speed[k + 1] - speed[k]) * u.conjugate()).real
        pull = (stiffness * (abs(line) - length) + damping * faster) * u
        forces[k] += pull
        forces[k + 1] -= pull
    return forces


@alternative("S.3")
def gradient_of_the_area(positions: Vector, area: float, stiffness: float) -> Any:
    """The force is the pressure times the gradient of the area: half of the chord, turned."""
    before, after = np.roll(positions, 1, axis=0), np.roll(positions, -1, axis=0)
    now = np.sum(positions[:, 0] * after[:, 1] - after[:, 0] * positions[:, 1]) / 2
    chord = after - before
    return stiffness * (area - now) / now / 2 * np.stack([chord[:, 1], -chord[:, 0]], axis=1)


@alternative("S.4")
def with_where_and_clip(
    positions: Vector, velocities: Vector, length: float, area: float, steps: float
) -> Any:
    """One array for place and motion; the floor is a choice for every mass."""
    state = np.hstack([positions, velocities])
    for _ in range(int(steps)):
        p, v = state[:, :2], state[:, 2:]
        force = ring_forces(p, v, length, BLOB.stiffness, BLOB.damping)
        push = (force + pressure_forces(p, area, BLOB.pressure)) / BLOB.mass
        v = v + BLOB.dt * (push - BLOB.air * v)
        v[:, 1] -= BLOB.dt * BLOB.gravity
        p = p + BLOB.dt * v
        stopped = np.column_stack([BLOB.grip * v[:, 0], np.clip(v[:, 1], 0, None)])
        v = np.where(p[:, 1:] < 0, stopped, v)
        state = np.hstack([p[:, :1], np.clip(p[:, 1:], 0, None), v])
    return state[:, :2], state[:, 2:]


@alternative("S.4")
def force_by_force(
    positions: Vector, velocities: Vector, length: float, area: float, steps: float
) -> Any:
    """Springs, gas, air and weight add up; then the floor stops what is below it."""
    p, v = positions.copy(), velocities.copy()
    for _ in range(int(steps)):
        forces = ring_forces(p, v, length, BLOB.stiffness, BLOB.damping)
        forces = forces + pressure_forces(p, area, BLOB.pressure)
        v = v + (forces / BLOB.mass - BLOB.air * v + np.array([0.0, -BLOB.gravity])) * BLOB.dt
        p = p + v * BLOB.dt
        below = p[:, 1] < 0
        p[below, 1] = 0.0
        v[below, 1] = np.maximum(v[below, 1], 0.0)
        v[below, 0] *= BLOB.grip
    return p, v


@alternative("S.1")
def edge_by_edge(positions: Vector) -> Any:
    """The shoelace formula in a loop; the last edge closes the ring."""
    total = 0.0
    count = len(positions)
    for k in range(count):
        x0, y0 = positions[k]
        x1, y1 = positions[(k + 1) % count]
        total += x0 * y1 - x1 * y0
    return total / 2


@alternative("S.2")
def neighbour_by_neighbour(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """Each spring once, with its force on either end."""
    count = len(positions)
    forces = np.zeros((count, 2))
    for i in range(count):
        j = (i + 1) % count
        way = positions[j] - positions[i]
        distance = np.hypot(way[0], way[1])
        u = way / distance
        pull = stiffness * (distance - length) + damping * np.dot(velocities[j] - velocities[i], u)
        forces[i] += pull * u
        forces[j] -= pull * u
    return forces


@alternative("S.3")
def pushed_edge_by_edge(positions: Vector, area: float, stiffness: float) -> Any:
    """Each edge once: half of its push on either end."""
    count, now = len(positions), 0.0
    for i in range(count):
        j = (i + 1) % count
        now += (positions[i][0] * positions[j][1] - positions[j][0] * positions[i][1]) / 2
    pressure = stiffness * (area / now - 1)
    forces = np.zeros((count, 2))
    for i in range(count):
        j = (i + 1) % count
        x, y = positions[j] - positions[i]
        push = pressure * np.array([y, -x]) / 2
        forces[i] += push
        forces[j] += push
    return forces

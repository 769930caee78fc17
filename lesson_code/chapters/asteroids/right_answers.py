"""Unusual right answers to the asteroid field."""

from __future__ import annotations

import cmath
import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("A.1")
def with_roots_of_unity(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """Directions are powers of one complex number; momenta are summed, then shared out."""
    root = cmath.exp(2j * math.pi / len(masses))
    pieces = [cmath.rect(speed, heading) * root**k for k in range(len(masses))]
    surplus = sum(m * v for m, v in zip(masses, pieces, strict=True)) / sum(masses)
    return [complex(*velocity) + piece - surplus for piece in pieces]


@alternative("A.2")
def as_a_linear_system(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """Two equations for both velocities: the momentum, and the difference."""
    momentum = (ship_mass + shot_mass) * velocity
    relative = [muzzle_speed * math.cos(heading), muzzle_speed * math.sin(heading)]
    return np.linalg.solve([[ship_mass, shot_mass], [-1.0, 1.0]], [momentum, relative])


@alternative("A.3")
def in_the_frame_of_the_pair(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Seen from the pair's centre of mass, the normal parts turn round."""
    places = [complex(*p) for p in positions]
    moving = [complex(*v) for v in velocities]
    for a in range(len(masses)):
        for b in range(a + 1, len(masses)):
            line = places[b] - places[a]
            if not 0 < abs(line) < radii[a] + radii[b]:
                continue
            turn = line / abs(line)
            u, w = moving[a] / turn, moving[b] / turn
            if u.real <= w.real:
                continue
            centre = (masses[a] * u.real + masses[b] * w.real) / (masses[a] + masses[b])
            u = complex(centre - restitution * (u.real - centre), u.imag)
            w = complex(centre - restitution * (w.real - centre), w.imag)
            moving[a], moving[b] = u * turn, w * turn
    return moving


@alternative("A.1")
def piece_by_piece(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """One list of velocities, one sum of momenta, and what is taken from each."""
    count, total = len(masses), 0.0
    pieces, momentum = [], np.zeros(2)
    for k in range(count):
        angle = heading + k * 2 * math.pi / count
        piece = speed * np.array([math.cos(angle), math.sin(angle)])
        pieces.append(piece)
        momentum = momentum + masses[k] * piece
        total = total + masses[k]
    return [velocity + piece - momentum / total for piece in pieces]

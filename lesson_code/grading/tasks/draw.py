"""Seeded inputs that no wrong model gets right by luck.

Masses are unequal, the second body moves, restitutions lie well inside (0, 1), and normals are
far from the axes. Numbers have two decimals, so that a message can be checked by hand.
"""

from __future__ import annotations

import math
from random import Random
from typing import TypeAlias

Vector: TypeAlias = tuple[float, float]


def unequal_masses(stream: Random) -> tuple[float, float]:
    """Return two masses, kg, one at least 1.5 times the other; either may be the heavier."""
    light = round(stream.uniform(0.5, 3.0), 2)
    heavy = round(light * stream.uniform(1.5, 6.0), 2)
    return (light, heavy) if stream.random() < 0.5 else (heavy, light)


def head_on(stream: Random) -> tuple[float, float]:
    """Return velocities, m/s, of two bodies that move against each other."""
    return round(stream.uniform(1.0, 6.0), 2), -round(stream.uniform(0.5, 4.0), 2)


def catching_up(stream: Random) -> tuple[float, float]:
    """Return velocities, m/s, of a faster body behind a slower one."""
    slow = round(stream.uniform(0.5, 2.0), 2)
    return round(slow + stream.uniform(1.0, 4.0), 2), slow


def speed(stream: Random) -> float:
    """Return a speed, m/s."""
    return round(stream.uniform(1.0, 6.0), 2)


def restitution(stream: Random) -> float:
    """Return a restitution that is neither near 0 nor near 1."""
    return round(stream.uniform(0.3, 0.8), 2)


def oblique_normal(stream: Random) -> Vector:
    """Return a unit normal at least 20 degrees from every axis and diagonal."""
    angle = math.radians(stream.uniform(20, 25) + 45 * stream.randrange(8))
    return math.cos(angle), math.sin(angle)


def velocity_into(stream: Random, normal: Vector) -> Vector:
    """Return a velocity, m/s, towards the wall with `normal`, with a tangent part of its own."""
    return _velocity(-speed(stream), _sliding(stream), normal)


def velocity_away(stream: Random, normal: Vector) -> Vector:
    """Return a velocity, m/s, away from the wall with `normal`, with a tangent part."""
    return _velocity(speed(stream), _sliding(stream), normal)


def _sliding(stream: Random) -> float:
    """Return a tangent velocity, m/s, either way."""
    return stream.choice((-1, 1)) * speed(stream)


def _velocity(along_normal: float, along_tangent: float, normal: Vector) -> Vector:
    """Return the vector with the given parts along a normal and its tangent."""
    n_x, n_y = normal
    return along_normal * n_x - along_tangent * n_y, along_normal * n_y + along_tangent * n_x

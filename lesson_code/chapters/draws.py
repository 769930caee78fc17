"""Seeded inputs that no wrong model gets right by luck.

Masses are unequal, the second body moves, restitutions lie well inside (0, 1), and normals are
far from the axes. Numbers have two decimals, so that a message can be checked by hand.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import TypeAlias, TypeVar

T = TypeVar("T")
Vector: TypeAlias = tuple[float, float]
Speed: TypeAlias = Callable[[Random], float]
"""Draws a speed, m/s."""


def until(holds: Callable[[T], bool], draw: Callable[[], T]) -> T:
    """Return the first of what is drawn, again and again, for which something holds.

    With this no luck of the draw decides what a mistake costs.
    """
    while not holds(drawn := draw()):
        pass
    return drawn


def number(stream: Random, low: float, high: float) -> float:
    """Return a number with two decimals that is neither 1 nor 2.

    A factor too many does not show with 1, nor a square in place of the double with 2.
    """
    return until(lambda drawn: drawn not in {1.0, 2.0}, lambda: round(stream.uniform(low, high), 2))


def unequal_masses(stream: Random) -> tuple[float, float]:
    """Return two masses, kg, one at least 1.5 times the other; either may be the heavier."""
    light = number(stream, 0.5, 3.0)
    heavy = number(stream, 1.5 * light, 6.0 * light)
    return (light, heavy) if stream.random() < 0.5 else (heavy, light)


def head_on(stream: Random) -> tuple[float, float]:
    """Return velocities, m/s, of two bodies that move against each other."""
    return number(stream, 1.0, 6.0), -number(stream, 0.5, 4.0)


def catching_up(stream: Random) -> tuple[float, float]:
    """Return velocities, m/s, of a faster body behind a slower one."""
    slow = number(stream, 0.5, 2.0)
    return number(stream, slow + 1.0, slow + 4.0), slow


def speed(stream: Random) -> float:
    """Return a speed, m/s."""
    return number(stream, 1.0, 6.0)


def creep(stream: Random) -> float:
    """Return a speed, m/s, that is low: a hit all the same."""
    return round(stream.uniform(0.01, 0.09), 3)


def restitution(stream: Random) -> float:
    """Return a restitution that is neither near 0 nor near 1."""
    return round(stream.uniform(0.3, 0.8), 2)


def oblique_normal(stream: Random) -> Vector:
    """Return a unit normal at least 20 degrees from every axis and diagonal."""
    angle = math.radians(stream.uniform(20, 25) + 45 * stream.randrange(8))
    return math.cos(angle), math.sin(angle)


def velocity_into(stream: Random, normal: Vector, how_fast: Speed = speed) -> Vector:
    """Return a velocity, m/s, towards the wall with `normal`, with a tangent part of its own."""
    return _velocity(-how_fast(stream), _sliding(stream), normal)


def velocity_away(stream: Random, normal: Vector, how_fast: Speed = speed) -> Vector:
    """Return a velocity, m/s, away from the wall with `normal`, with a tangent part."""
    return _velocity(how_fast(stream), _sliding(stream), normal)


def _sliding(stream: Random) -> float:
    """Return a tangent velocity, m/s, either way."""
    return stream.choice((-1, 1)) * speed(stream)


def _velocity(along_normal: float, along_tangent: float, normal: Vector) -> Vector:
    """Return the vector with the given parts along a normal and its tangent."""
    n_x, n_y = normal
    return along_normal * n_x - along_tangent * n_y, along_normal * n_y + along_tangent * n_x


def position(stream: Random) -> Vector:
    """Return a position, m."""
    return round(stream.uniform(-5, 5), 2), round(stream.uniform(-5, 5), 2)


def depth(stream: Random) -> float:
    """Return a depth of overlap, m."""
    return round(stream.uniform(0.1, 0.5), 2)


def unequal_radii(stream: Random) -> tuple[float, float]:
    """Return two radii, m, one at least 1.5 times the other; together more than 2 m."""
    small = round(stream.uniform(0.9, 1.5), 2)
    large = round(small * stream.uniform(1.5, 2.5), 2)
    return (small, large) if stream.random() < 0.5 else (large, small)


def at_distance(start: Vector, distance: float, direction: Vector) -> Vector:
    """Return the point `distance` from `start` in a unit direction, m, to two decimals."""
    return round(start[0] + distance * direction[0], 2), round(
        start[1] + distance * direction[1], 2
    )


def approaching_pair(
    stream: Random, normal: Vector, how_fast: Speed = speed
) -> tuple[Vector, Vector]:
    """Return velocities of two bodies, m/s, both moving; they approach along `normal`, 1 to 2."""
    first = _velocity(speed(stream), _sliding(stream), normal)
    return first, _sum(first, velocity_into(stream, normal, how_fast))


def creeping_pair(stream: Random, normal: Vector) -> tuple[Vector, Vector]:
    """Return velocities of two bodies, m/s, both moving, that approach slowly."""
    return approaching_pair(stream, normal, creep)


def first_overtakes(stream: Random, normal: Vector) -> tuple[Vector, Vector]:
    """Return velocities of two bodies, m/s, of which 1 catches up with 2 along `normal`."""
    fast, slow = catching_up(stream)
    return _velocity(fast, _sliding(stream), normal), _velocity(slow, _sliding(stream), normal)


def second_overtakes(stream: Random, normal: Vector) -> tuple[Vector, Vector]:
    """Return velocities of two bodies, m/s, of which 2 catches up with 1 against `normal`."""
    fast, slow = catching_up(stream)
    return _velocity(-slow, _sliding(stream), normal), _velocity(-fast, _sliding(stream), normal)


def separating_pair(
    stream: Random, normal: Vector, how_fast: Speed = speed
) -> tuple[Vector, Vector]:
    """Return velocities of two bodies, m/s, both moving, that already part along `normal`."""
    first = _velocity(speed(stream), _sliding(stream), normal)
    return first, _sum(first, velocity_away(stream, normal, how_fast))


def _sum(a: Vector, b: Vector) -> Vector:
    """Return the sum of two vectors."""
    return a[0] + b[0], a[1] + b[1]


def angular_velocity(stream: Random) -> float:
    """Return an angular velocity, rad/s, either way round."""
    return stream.choice((-1, 1)) * number(stream, 1.0, 8.0)


def lever(stream: Random) -> Vector:
    """Return the way from a centre to a contact, m, far from the axes and the diagonals."""
    x, y = round(stream.uniform(0.2, 0.6), 2), round(stream.uniform(0.7, 1.5), 2)
    return stream.choice((-1, 1)) * x, stream.choice((-1, 1)) * y


def convex_polygon(
    stream: Random, count: int, centre: Vector = (0.0, 0.0), size: float = 1.0, width: float = 0.5
) -> tuple[Vector, ...]:
    """Return the vertices, m, of a convex polygon with no two edges alike, counter-clockwise.

    They lie on a tilted ellipse about `centre` that is `size` long and `width` times as wide,
    at uneven angles, and begin anywhere on it. No edge is level or upright: what that costs an
    answer must not depend on the seed.
    """
    return until(_is_oblique, lambda: _any_convex_polygon(stream, count, centre, size, width))


def _is_oblique(vertices: tuple[Vector, ...]) -> bool:
    """Return whether no edge of a polygon is level or upright."""
    edges = zip(vertices, (*vertices[1:], vertices[0]), strict=True)
    return all(a[0] != b[0] and a[1] != b[1] for a, b in edges)


def _any_convex_polygon(
    stream: Random, count: int, centre: Vector, size: float, width: float
) -> tuple[Vector, ...]:
    """Return the vertices of such a polygon with edges of any direction."""
    gaps = [stream.uniform(1.0, 2.2) for _ in range(count)]
    first, tilt = stream.uniform(0, 2 * math.pi), stream.uniform(0, math.pi)
    turns = [first + 2 * math.pi * sum(gaps[:place]) / sum(gaps) for place in range(count)]
    on_ellipse = [(size * math.cos(turn), size * width * math.sin(turn)) for turn in turns]
    return tuple(_placed(point, tilt, centre) for point in on_ellipse)


def _placed(point: Vector, tilt: float, centre: Vector) -> Vector:
    """Return a point turned about the origin by `tilt` and then moved by `centre`."""
    (x, y), cos, sin = point, math.cos(tilt), math.sin(tilt)
    return round(centre[0] + x * cos - y * sin, 2), round(centre[1] + x * sin + y * cos, 2)

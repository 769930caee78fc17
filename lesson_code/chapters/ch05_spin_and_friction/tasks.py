"""Tasks of chapter 05: spin and friction."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.ch05_spin_and_friction.scenes import bounce_with_spin, coulomb
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.course.isolation.inside.vectors import vector
from lesson_code.formulas import (
    contact_velocity,
    effective_mass,
    polygon_inertia,
)
from lesson_code.formulas.arithmetic import cross, perpendicular

# 5.1 Moment of inertia


def rectangles_around_the_origin(stream: Random) -> Iterator[Arguments]:
    """Draw rectangles whose centroid is the origin."""
    for _ in range(2):
        x, y = round(stream.uniform(0.5, 1.0), 2), round(stream.uniform(1.2, 2.0), 2)
        yield _mass(stream), ((-x, -y), (x, -y), (x, y), (-x, y))


def polygons_elsewhere(stream: Random) -> Iterator[Arguments]:
    """Draw polygons away from the origin, counter-clockwise."""
    for count in (3, 5):
        yield _mass(stream), _polygon(stream, count)


def polygons_clockwise(stream: Random) -> Iterator[Arguments]:
    """Draw polygons away from the origin, in the other order."""
    for count in (4, 5):
        yield _mass(stream), _polygon(stream, count)[::-1]


def polygons_with_a_vertex_too_many(stream: Random) -> Iterator[Arguments]:
    """Draw polygons with a vertex in the middle of an edge."""
    for count in (3, 4):
        first, second, *rest = _polygon(stream, count)
        middle = ((first[0] + second[0]) / 2, (first[1] + second[1]) / 2)
        yield _mass(stream), (first, middle, second, *rest)


def _polygon(stream: Random, count: int) -> tuple[draws.Vector, ...]:
    """Return the vertices of a convex polygon away from the origin, counter-clockwise, m."""
    x, y = (stream.choice((-1, 1)) * stream.uniform(2.0, 5.0) for _ in range(2))
    return draws.convex_polygon(stream, count, centre=(x, y), size=2.0, width=0.6)


def _mass(stream: Random) -> float:
    """Return a mass, kg, that is not near 1."""
    return round(stream.uniform(2.0, 6.0), 2)


# 5.2 Velocity of the contact point


def spinning_on_the_spot(stream: Random) -> Iterator[Arguments]:
    """Draw bodies that turn about a centre at rest."""
    for _ in range(2):
        yield (0.0, 0.0), draws.angular_velocity(stream), draws.lever(stream)


def moving_and_spinning(stream: Random) -> Iterator[Arguments]:
    """Draw bodies that move and turn."""
    for _ in range(3):
        yield _velocity(stream), draws.angular_velocity(stream), draws.lever(stream)


def _velocity(stream: Random) -> draws.Vector:
    """Return a velocity, m/s."""
    return draws.speed(stream), -draws.speed(stream)


def part_of_the_spin(arguments: Arguments, answer: Any) -> str:
    """Say how long the part from the spin is, and at which angle to the lever it stands."""
    v, w, r = arguments
    added, distance = vector(answer) - vector(v), math.hypot(*r)
    along = round(float(added @ vector(r)) / distance, 9) + 0.0  # + 0.0 takes the sign off a zero
    return (
        f"What you added to v is {written(math.hypot(*added))} m/s long, {written(along)} of it"
        f" along r. The spin adds {written(abs(w) * distance)} m/s, none of it along r."
    )


# 5.3 Inverse effective mass


def central_hits(stream: Random) -> Iterator[Arguments]:
    """Draw contacts at which both levers lie along the normal, as of two discs."""
    for _ in range(2):
        n = draws.oblique_normal(stream)
        a, b = (round(stream.uniform(0.3, 1.5), 2) for _ in range(2))
        levers = (a * n[0], a * n[1]), (-b * n[0], -b * n[1])
        yield _two_bodies(stream, levers, n)


def hits_off_centre(stream: Random) -> Iterator[Arguments]:
    """Draw contacts anywhere on two bodies."""
    for _ in range(3):
        n = draws.oblique_normal(stream)
        yield _two_bodies(stream, (_beside(stream, n), _beside(stream, n)), n)


def hits_on_the_ground(stream: Random) -> Iterator[Arguments]:
    """Draw contacts with a body that can neither be moved nor turned."""
    for _ in range(2):
        n = draws.oblique_normal(stream)
        body = _mass(stream), _inertia(stream), _beside(stream, n)
        yield (*body, math.inf, math.inf, _beside(stream, n), n)


def _beside(stream: Random, n: draws.Vector) -> draws.Vector:
    """Return a lever, m, with a part along a direction and an unequal part across it."""
    along = stream.choice((-1, 1)) * stream.uniform(0.2, 0.4)
    across = stream.choice((-1, 1)) * stream.uniform(0.5, 1.0)
    return along * n[0] - across * n[1], along * n[1] + across * n[0]


def _two_bodies(
    stream: Random, levers: tuple[draws.Vector, draws.Vector], direction: draws.Vector
) -> Arguments:
    """Return mass, inertia and lever of two unequal bodies, and a direction."""
    (m_a, m_b), (r_a, r_b) = draws.unequal_masses(stream), levers
    return m_a, _inertia(stream), r_a, m_b, _inertia(stream), r_b, direction


def _inertia(stream: Random) -> float:
    """Return a moment of inertia, kg m^2."""
    return round(stream.uniform(0.2, 0.9), 2)


def _inverse_effective_mass(
    m_a: float, i_a: float, r_a: Any, m_b: float, i_b: float, r_b: Any, direction: Any
) -> float:
    """Return k = 1 / effective mass along a direction, 1/kg."""
    levers = {"ra_x_n": cross(r_a, direction), "rb_x_n": cross(r_b, direction)}
    return float(1 / effective_mass(1 / m_a, 1 / m_b, 1 / i_a, 1 / i_b, **levers))


def lever_arms(arguments: Arguments, _answer: Any) -> str:
    """Say what the lever arms are."""
    _, _, r_a, _, _, r_b, direction = arguments
    arms = (written(_across(r, direction)) for r in (r_a, r_b))
    return "The lever arms r x n are {} m and {} m.".format(*arms)


def _across(a: Any, b: Any) -> float:
    """Return the cross product of two vectors of plain numbers."""
    return float(a[0] * b[1] - a[1] * b[0])


# 5.4 Coulomb friction


def gripping(stream: Random) -> Iterator[Arguments]:
    """Draw contacts that friction can hold, sliding either way; it takes more than mu N s."""
    for way in (1, -1):
        vt, jn, mu, k = draws.until(
            lambda drawn: drawn[0] / drawn[3] > drawn[2], lambda: _gripping(stream)
        )
        yield way * vt, jn, mu, k


def _gripping(stream: Random) -> tuple[float, float, float, float]:
    """Return vt, jn, mu and k of a contact that friction can hold."""
    vt, k = draws.speed(stream), _yielding(stream)
    return vt, *_pressed(stream, stream.uniform(1.1, 1.4) * vt / k), k


def slipping(stream: Random) -> Iterator[Arguments]:
    """Draw contacts that slide on, either way, and one that is rough, but hardly pressed.

    The first is smooth, and so well pressed that a rough one would not slide.
    """
    for way, held, rough in ((1, (0.6, 0.7), (0.2, 0.5)), (-1, (0.2, 0.7), (0.2, 0.8))):
        vt, k = draws.speed(stream), _yielding(stream)
        yield way * vt, *_pressed(stream, stream.uniform(*held) * vt / k, rough), k
    vt, k = draws.speed(stream), _yielding(stream)
    yield vt, *_pressed(stream, stream.uniform(0.1, 0.2) * vt / k, (0.7, 0.8)), k


def creeping(stream: Random) -> Iterator[Arguments]:
    """Draw contacts that slide very slowly, and one that does not slide."""
    slow = round(stream.uniform(0.002, 0.008), 4)
    for vt in (slow, -slow, 0.0):
        yield vt, *_pressed(stream, stream.uniform(1.0, 2.0)), _yielding(stream)


def _yielding(stream: Random) -> float:
    """Return an inverse effective mass, 1/kg."""
    return round(stream.uniform(1.5, 4.0), 2)


def _pressed(
    stream: Random, limit: float, rough: tuple[float, float] = (0.2, 0.8)
) -> tuple[float, float]:
    """Return jn, N s, and mu, within what is given, whose product is about `limit`."""
    friction = round(stream.uniform(*rough), 2)
    return round(limit / friction, 2), friction


def limit_and_need(arguments: Arguments, _answer: Any) -> str:
    """Say what would stop the sliding, and what friction can give."""
    vt, jn, friction, k = arguments
    return (
        f"To stop the sliding takes {written(-vt / k)} N s;"
        f" friction can give {written(friction * jn)} N s either way."
    )


# 5.5 A disc hits a wall


def rough_walls(stream: Random) -> Iterator[Arguments]:
    """Draw hits at which the disc does not slide afterwards, with slip of either sign.

    Then one at which friction makes the disc spin faster, and one, with top spin, at which it
    makes the disc itself faster: it brakes the sliding of the rim, and nothing else.
    """
    for way in (1, -1):
        yield _disc_at_wall(stream, way, slip=0.5, friction=stream.uniform(0.7, 1.0))
    for slip in (0.2, -0.5):
        way = stream.choice((1, -1))
        yield _disc_at_wall(stream, way, slip=slip, friction=stream.uniform(0.7, 1.0))


def smooth_walls(stream: Random) -> Iterator[Arguments]:
    """Draw hits at which the disc goes on sliding, with slip of either sign.

    The third one is slow, and the last one has top spin, with which friction makes it faster.
    """
    for way, slip, how_fast in (
        (1, 3.0, draws.speed), (-1, 3.0, draws.speed), (1, 3.0, draws.creep),
        (stream.choice((1, -1)), -3.0, draws.speed),
    ):  # fmt: skip
        friction = stream.uniform(0.05, 0.2)
        yield _disc_at_wall(stream, way, slip=slip, friction=friction, how_fast=how_fast)


def leaving_discs(stream: Random) -> Iterator[Arguments]:
    """Draw spinning discs that already leave the wall, fast and slowly."""
    for how_fast in (draws.speed, draws.creep):
        normal = draws.oblique_normal(stream)
        velocity, w = draws.velocity_away(stream, normal, how_fast), draws.angular_velocity(stream)
        radius, friction = round(stream.uniform(0.2, 0.8), 2), round(stream.uniform(0.2, 0.8), 2)
        yield velocity, w, radius, normal, draws.restitution(stream), friction


def _disc_at_wall(
    stream: Random, way: int, slip: float, friction: float, how_fast: draws.Speed = draws.speed
) -> Arguments:
    """Return a disc that meets a wall; `slip` is its sliding there over its approach."""
    normal = draws.oblique_normal(stream)
    approach, radius = how_fast(stream), round(stream.uniform(0.2, 0.8), 2)
    v_t = way * approach * stream.uniform(0.3, 0.6)
    w = round((v_t - way * slip * approach) / radius, 4)
    velocity = np.multiply(-approach, normal) + v_t * perpendicular(normal)
    return (
        tuple(velocity.tolist()),
        w,
        radius,
        normal,
        draws.restitution(stream),
        round(friction, 2),
    )


def turning_about_the_contact(arguments: Arguments, answer: Any) -> str:
    """Say what the angular momentum about the contact is, before and after."""
    velocity, w, radius, normal = arguments[:4]
    before, after = (
        radius * _across(normal, v) + radius**2 / 2 * spin
        for v, spin in ((velocity, w), (answer[0], float(answer[1])))
    )
    return (
        f"Angular momentum about the contact, for 1 kg: before {written(before)}, after yours"
        f" {written(after)} m^2/s. What acts at the contact cannot change it."
    )


TASKS = (
    Task(
        id="5.1",
        function="moment_of_inertia",
        section=2,
        objective="The moment of inertia of any polygon about its centroid.",
        expected=polygon_inertia,
        criteria=(
            Criterion("a rectangle around the origin", rectangles_around_the_origin),
            Criterion("a polygon somewhere else", polygons_elsewhere),
            Criterion("clockwise order", polygons_clockwise),
            Criterion("a vertex too many", polygons_with_a_vertex_too_many),
        ),
    ),
    Task(
        id="5.2",
        function="contact_velocity",
        section=1,
        objective="The velocity of a point of a body that moves and turns.",
        expected=contact_velocity,
        criteria=(
            Criterion("spinning on the spot", spinning_on_the_spot),
            Criterion("moving and spinning", moving_and_spinning, points=2),
        ),
        explain=part_of_the_spin,
    ),
    Task(
        id="5.3",
        function="inverse_effective_mass",
        section=3,
        objective="How far two bodies give way to an impulse at their contact.",
        expected=_inverse_effective_mass,
        criteria=(
            Criterion("through both centres", central_hits),
            Criterion("off centre", hits_off_centre, points=2),
            Criterion("against the ground", hits_on_the_ground),
        ),
        explain=lever_arms,
    ),
    Task(
        id="5.4",
        function="friction_impulse",
        section=4,
        objective="The impulse of dry friction, with Coulomb's limit.",
        expected=coulomb,
        criteria=(
            Criterion("a contact that grips", gripping),
            Criterion("a contact that slips", slipping, points=2),
            Criterion("very slow sliding", creeping),
        ),
        explain=limit_and_need,
    ),
    Task(
        id="5.5",
        function="bounce_with_spin",
        section=5,
        objective="Velocity and angular velocity of a disc after it has hit a rough wall.",
        expected=bounce_with_spin,
        criteria=(
            Criterion("a wall that grips", rough_walls, points=2),
            Criterion("a wall that slips", smooth_walls, points=2),
            Criterion("a disc that is leaving", leaving_discs),
        ),
        explain=turning_about_the_contact,
    ),
)

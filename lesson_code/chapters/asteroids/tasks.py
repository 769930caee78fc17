"""Tasks of the asteroid field: whatever happens, the momentum is kept."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.asteroids import rules as asteroids_rules
from lesson_code.course.grading.task import Arguments, Criterion, Task

FIELD_MASSES = (1.0, 4.0, 2.5, 7.0, 0.5, 3.0, 5.5, 1.5, 2.0)
"""kg: of the field in which the momentum is added up."""

PIECE_MASSES = (1.0, 2.5, 4.0)
"""kg: of the pieces whose momentum is added up."""


def bursts(stream: Random) -> Iterator[Arguments]:
    """Draw asteroids that burst into two, three and five unequal pieces."""
    for count in (2, 3, 5):
        masses = tuple(round(stream.uniform(0.5, 1.0) * (1 + k), 2) for k in range(count))
        yield _velocity(stream), masses, draws.speed(stream), round(stream.uniform(0, 6), 2)


def bursts_of_three(stream: Random) -> Iterator[Arguments]:
    """Draw an asteroid that bursts into pieces of known masses."""
    yield _velocity(stream), PIECE_MASSES, draws.speed(stream), round(stream.uniform(0, 6), 2)


def shots(stream: Random) -> Iterator[Arguments]:
    """Draw shots from a ship that moves, in any direction."""
    for _ in range(2):
        yield _shot(stream, _velocity(stream))


def shots_at_rest(stream: Random) -> Iterator[Arguments]:
    """Draw a shot from a ship at rest."""
    yield _shot(stream, (0.0, 0.0))


def _shot(stream: Random, velocity: draws.Vector) -> Arguments:
    """Return the arguments of a shot, heavier or lighter than the ship."""
    ship, shot = draws.unequal_masses(stream)
    return velocity, ship, shot, round(stream.uniform(5, 9), 2), round(stream.uniform(0, 6), 2)


def pairs(stream: Random) -> Iterator[Arguments]:
    """Draw two that overlap and approach, two that part, and two that do not touch.

    Of those that approach one catches up, or both come slowly. In the last case the centres of two
    that come towards each other coincide.
    """
    slowly = partial(draws.separating_pair, how_fast=draws.creep)
    for scale, smaller_first, pair in (
        (0.9, True, draws.first_overtakes),
        (0.9, False, draws.second_overtakes),
        (0.5, True, draws.creeping_pair),
        (0.9, True, draws.separating_pair),
        (0.7, True, slowly),
        (1.1, False, draws.approaching_pair),
        (0.0, True, draws.approaching_pair),
    ):
        normal, radii = draws.oblique_normal(stream), sorted(draws.unequal_radii(stream))
        radii = radii if smaller_first else radii[::-1]
        distance = scale * stream.uniform(0.95, 1.0) * sum(radii)
        v = pair(stream, normal)
        there = draws.at_distance((0.0, 0.0), distance, normal)
        places = ((0.0, 0.0), there)
        yield places, v, draws.unequal_masses(stream), tuple(radii), draws.restitution(stream)


def chains(stream: Random) -> Iterator[Arguments]:
    """Draw three in a crooked row, each overlapping the next, the first one fast.

    Then a fast one hits two others, of which the second comes towards it; one is thrown back at
    another by the next, when the turn of the two is over; and one hits two, on the first of which
    it lies centre on centre.
    """
    bend = stream.uniform(0.4, 0.8)
    places = ((0.0, 0.0), (1.5, 0.2), (1.5 + 1.5 * math.cos(bend), 0.2 + 1.5 * math.sin(bend)))
    v = ((round(stream.uniform(3, 5), 2), 0.4), (0.0, 0.3), (-1.0, 0.0))
    yield places, v, (2.0, 1.0, 3.0), (1.0, 1.0, 1.0), draws.restitution(stream)
    aside = stream.uniform(0.7, 0.9)
    places = ((0.0, 0.0), (1.5, aside), (1.5, -aside))
    v = ((round(stream.uniform(3, 5), 2), 0.4), (0.3, 0.0), (-2.0, 0.5))
    yield places, v, (2.0, 1.0, 3.0), (1.0, 1.0, 1.0), draws.restitution(stream)
    places = ((0.0, 0.0), (-1.5, 0.3), (1.5, -0.2))
    v = ((0.0, 0.2), (0.5, 0.0), (-round(stream.uniform(3, 5), 2), 0.0))
    yield places, v, (2.0, 1.0, 3.0), (1.0, 1.0, 1.0), draws.restitution(stream)
    places = ((0.0, 0.0), (0.0, 0.0), (1.5, 0.3))
    v = ((round(stream.uniform(3, 5), 2), 0.0), (-0.3, 0.2), (-0.5, 0.1))
    yield places, v, (2.0, 1.0, 3.0), (1.0, 1.0, 1.0), draws.restitution(stream)


def crowded_fields(stream: Random) -> Iterator[Arguments]:
    """Draw nine asteroids in a crowd, in which many overlap.

    The first one is hit from both sides, so that it is thrown back at the second one when their
    turn is over. Two others part.
    """
    places, radii = draws.until(lambda drawn: _first_overlaps(*drawn), lambda: _crowd(stream))
    thrown = (
        (0.0, 0.2),
        (round(stream.uniform(0.5, 1.0), 2), 0.0),
        (-draws.speed(stream) - 3, 0.0),
    )
    parting = ((-draws.speed(stream), 0.0), (draws.speed(stream), 0.0))
    moving = (*thrown, *parting, *(_velocity(stream) for _ in range(4)))
    yield places, moving, FIELD_MASSES, radii, draws.restitution(stream)


def _crowd(stream: Random) -> tuple[tuple[draws.Vector, ...], tuple[float, ...]]:
    """Return places and radii of nine asteroids; the first is in the middle of the lowest row."""
    places = tuple(
        (1.4 * (k % 3) + stream.uniform(-0.2, 0.2), 1.4 * (k // 3) + stream.uniform(-0.2, 0.2))
        for k in (1, 0, 2, *range(3, 9))
    )
    return places, tuple(round(stream.uniform(0.85, 0.95), 2) for _ in places)


def _first_overlaps(places: tuple[draws.Vector, ...], radii: tuple[float, ...]) -> bool:
    """Return whether the first circle overlaps the next two."""
    return all(math.dist(places[0], places[k]) < radii[0] + radii[k] for k in (1, 2))


def _velocity(stream: Random) -> draws.Vector:
    """Return a velocity, m/s, that is not small."""
    speed, heading = draws.speed(stream), stream.uniform(0, 2 * math.pi)
    return round(speed * math.cos(heading), 2), round(speed * math.sin(heading), 2)


def momentum_of_pieces(velocities: Any) -> Any:
    """Return the total momentum of the three pieces, kg m/s."""
    return np.array(PIECE_MASSES) @ np.asarray(velocities, dtype=float)


def momentum_of_field(velocities: Any) -> Any:
    """Return the total momentum of the nine asteroids, kg m/s."""
    return np.array(FIELD_MASSES) @ np.asarray(velocities, dtype=float)


TASKS = (
    Task(
        id="A.1",
        function="split",
        objective="An asteroid bursts, and its momentum is kept.",
        expected=asteroids_rules.split,
        criteria=(
            Criterion("the pieces", bursts, points=2),
            Criterion("the momentum is kept", bursts_of_three, part=momentum_of_pieces),
        ),
    ),
    Task(
        id="A.2",
        function="fire",
        objective="A shot, and its recoil.",
        expected=asteroids_rules.fire,
        criteria=(
            Criterion("from rest", shots_at_rest),
            Criterion("while it moves", shots, points=2),
        ),
    ),
    Task(
        id="A.3",
        function="collide_all",
        objective="A field of collisions, and its momentum is kept.",
        expected=asteroids_rules.collide_all,
        criteria=(
            Criterion("two asteroids", pairs),
            Criterion("a row of three", chains),
            Criterion("the momentum of a field is kept", crowded_fields, part=momentum_of_field),
            Criterion("a field", crowded_fields),
        ),
    ),
)

"""Tasks of chapter 10: which effects a scene calls for, how far bodies get, and what may sleep."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations, pairwise
from random import Random
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters import draws
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task

Numbers: TypeAlias = tuple[float, ...]

# 10.1: friction


def free_bodies(stream: Random) -> Iterator[Arguments]:
    """Draw rough bodies all of which can be pushed, from the smoothest on and from the roughest."""
    for way in (1, -1):
        yield _inverse_masses(stream, 4), _coefficients(stream, 4)[::way]


def rough_floors(stream: Random) -> Iterator[Arguments]:
    """Draw scenes whose roughest bodies are static, and one whose only free body is the smoothest.

    Two static bodies never meet: the pair of the two roughest does not count.
    """
    for _ in range(2):
        smooth, middle, rough, rougher = _coefficients(stream, 4)
        yield (*_inverse_masses(stream, 2), 0.0, 0.0), (smooth, middle, rough, rougher)
        yield (0.0, 0.0, *_inverse_masses(stream, 1)), (rough, rougher, smooth)


def smooth_partners(stream: Random) -> Iterator[Arguments]:
    """Draw scenes in which a rough body has only smooth partners or none, and one with others."""
    low, high = sorted(_coefficients(stream, 2))
    yield _inverse_masses(stream, 3), (0.0, high, 0.0)
    yield (0.0, 0.0, *_inverse_masses(stream, 2)), (low, high, 0.0, 0.0)
    yield (0.0, *_inverse_masses(stream, 2)), (low, 0.0, high)
    yield (0.0, 0.0), (low, high)
    yield _inverse_masses(stream, 1), (high,)


def _inverse_masses(stream: Random, count: int) -> Numbers:
    """Return inverse masses, 1/kg, of bodies that can be pushed."""
    return tuple(round(stream.uniform(0.1, 2.0), 2) for _ in range(count))


def _coefficients(stream: Random, count: int) -> Numbers:
    """Return coefficients, each clearly larger than the one before."""
    return tuple(round(0.2 * n + stream.uniform(0.1, 0.2), 2) for n in range(count))


# 10.2: a plan. A body is (inverse mass, corners, restitution, friction, angular velocity).

BALL, BOX = 0.0, 4.0
"""Corners."""


def rough_or_smooth(stream: Random) -> Iterator[Arguments]:
    """Draw pairs of which both, one or none is rough, and two rough bodies that are static.

    Of four bodies one pair is rough: at either end of the list, or one at each.
    """
    m, n, mu, nu = *_inverse_masses(stream, 2), *_coefficients(stream, 2)
    for first, second in ((mu, nu), (mu, 0.0), (0.0, 0.0)):
        yield ((m, BALL, 0.0, first, 0.0), (n, BOX, 0.0, second, 0.0)), (0.0, -9.81)
    floors = ((0.0, BOX, 0.0, mu, 0.0), (0.0, BOX, 0.0, nu, 0.0))
    yield (*floors, (m, BALL, 0.0, 0.0, 0.0)), (0.0, -9.81)
    rough, smooth = (m, BALL, 0.0, mu, 0.0), (n, BALL, 0.0, 0.0, 0.0)
    yield from ((bodies, (0.0, -9.81)) for bodies in _one_pair(floors[0], rough, smooth))


def _one_pair(floor: Numbers, body: Numbers, other: Numbers) -> Iterator[tuple[Numbers, ...]]:
    """Yield bodies of which only floor and body make a pair that counts.

    It is the last one, the first one, and one of bodies that are no neighbours in the list.
    """
    yield other, other, body, floor
    yield other, other, floor, body
    yield body, floor, other, other
    yield body, other, other, floor
    yield other, floor, other, body


def bouncing_or_not(stream: Random) -> Iterator[Arguments]:
    """Draw pairs of which both, one or none bounces; and more bodies, of which one pair does.

    One pair is elastic.
    """
    m, n, low, high = *_inverse_masses(stream, 2), *_coefficients(stream, 2)
    floor, ball, dead = ((inv, BALL, e, 0.0, 0.0) for inv, e in ((0.0, low), (m, high), (n, 0.0)))
    yield from ((bodies, (0.0, 0.0)) for bodies in _one_pair(floor, ball, dead))
    yield (dead, ball), (0.0, 0.0)
    yield ((m, BALL, 1.0, 0.0, 0.0), (n, BALL, 1.0, 0.0, 0.0)), (0.0, 0.0)
    yield (floor, dead, (0.0, BOX, high, 0.0, 0.0)), (0.0, 0.0)
    for first, second in ((low, high), (high, 0.0), (0.0, 0.0)):
        yield ((m, BALL, first, 0.0, 0.0), (n, BALL, second, 0.0, 0.0)), (0.0, 0.0)
    yield ((0.0, BOX, high, 0.0, 0.0), (n, BALL, low, 0.0, 0.0)), (0.0, 0.0)


def turning_or_not(stream: Random) -> Iterator[Arguments]:
    """Draw discs and boxes that turn, that can be turned, and that cannot, at any place."""
    m, n, mu, nu = *_inverse_masses(stream, 2), *_coefficients(stream, 2)
    w = stream.choice((-1, 1)) * draws.speed(stream)
    ball, floor = (m, BALL, 0.5, 0.0, 0.0), (0.0, BOX, 0.5, mu, 0.0)
    yield (ball, (n, BALL, 0.5, 0.0, 0.0)), (0.0, 0.0)
    yield (ball, floor), (0.0, 0.0)
    yield from (((ball, (n, BALL, 0.5, 0.0, spin)), (0.0, 0.0)) for spin in (w, -w))
    yield (floor, (m, BALL, 0.5, nu, 0.0)), (0.0, 0.0)
    yield (ball, (n, BOX, 0.5, 0.0, 0.0)), (0.0, 0.0)
    yield (floor, (0.0, BALL, 0.5, nu, 0.0), ball), (0.0, 0.0)
    others = floor, ball, ball
    for found in ((n, BOX, 0.5, 0.0, 0.0), (n, BALL, 0.5, 0.0, w), (0.0, BOX, 0.5, mu, w)):
        yield (found, *others), (0.0, 0.0)
        yield (*others, found), (0.0, 0.0)
    yield others, (0.0, 0.0)


def whole_plans(stream: Random) -> Iterator[Arguments]:
    """Draw scenes of all kinds, with gravity down, aside, and none."""
    for gravity in ((0.0, -9.81), (round(stream.uniform(1, 3), 2), 0.0), (0.0, 0.0)):
        m, n, mu, e = *_inverse_masses(stream, 2), *_coefficients(stream, 2)
        floor = (0.0, BOX, e, mu, 0.0)
        yield (floor, (m, BALL, e, 0.0, 0.0), (n, BALL, 0.0, 0.0, 0.0)), gravity
        yield (floor, (m, BALL, 0.0, mu, 0.0)), gravity


# 10.3: how far a body can move in a step


def equal_discs(stream: Random) -> Iterator[Arguments]:
    """Draw discs of one mass, all moving."""
    masses = (round(stream.uniform(0.5, 3.0), 2),) * 4
    yield masses, tuple(_velocity(stream) for _ in masses), _dt(stream)


def unequal_discs(stream: Random) -> Iterator[Arguments]:
    """Draw discs of different masses, all moving; the lightest stands anywhere."""
    for _ in range(3):
        masses = [round(0.4 * 2.0**n * stream.uniform(1.0, 1.5), 2) for n in range(4)]
        stream.shuffle(masses)
        yield tuple(masses), tuple(_velocity(stream) for _ in masses), _dt(stream)


def a_light_one_at_rest(stream: Random) -> Iterator[Arguments]:
    """Draw a heavy disc that comes slowly, and a light one that lies still."""
    heavy, light = round(stream.uniform(20, 80), 1), round(stream.uniform(0.05, 0.2), 3)
    yield (heavy, light), (_velocity(stream), (0.0, 0.0)), _dt(stream)
    yield (light, heavy), ((0.0, 0.0), _velocity(stream)), _dt(stream)


def _velocity(stream: Random) -> draws.Vector:
    """Return a velocity, m/s, neither part of which is small."""
    return (
        stream.choice((-1, 1)) * draws.speed(stream),
        stream.choice((-1, 1)) * draws.speed(stream),
    )


def _dt(stream: Random) -> float:
    """Return a time step, s."""
    return round(stream.uniform(0.01, 0.05), 3)


# 10.4: the box around a flight


def straight_flights(stream: Random) -> Iterator[Arguments]:
    """Draw flights without gravity, in two of the four directions between the axes."""
    for _ in range(2):
        given = draws.position(stream), _velocity(stream), _radius(stream)
        yield *given, (0.0, 0.0), round(stream.uniform(0.5, 2.0), 2)


def turning_points_inside(stream: Random) -> Iterator[Arguments]:
    """Draw flights that turn back within the time: thrown up, and thrown against a side wind.

    They turn in the first half of the time, or in the second.
    """
    for part in (stream.uniform(0.3, 0.45), stream.uniform(0.6, 0.8)):
        vx, vy = draws.speed(stream), draws.speed(stream)
        time = round(vy / 9.81 / part, 3)
        yield draws.position(stream), (vx, vy), _radius(stream), (0.0, -9.81), time
        wind = round(stream.uniform(1, 3), 2)
        time = round(vx / wind / part, 3)
        yield draws.position(stream), (-vx, vy), _radius(stream), (wind, 0.0), time


def turning_points_outside(stream: Random) -> Iterator[Arguments]:
    """Draw flights whose turning point lies after the end, or before the start."""
    vx, vy = draws.speed(stream), draws.speed(stream)
    time = round(vy / 9.81 * stream.uniform(0.4, 0.8), 3)
    yield draws.position(stream), (vx, vy), _radius(stream), (0.0, -9.81), time
    time = round(stream.uniform(0.5, 1.0), 2)
    yield draws.position(stream), (-vx, -vy), _radius(stream), (0.0, -9.81), time


def _radius(stream: Random) -> float:
    """Return a radius, m."""
    return round(stream.uniform(0.2, 0.8), 2)


# 10.5: what may sleep


def one_pile(stream: Random) -> Iterator[Arguments]:
    """Draw a pile on a floor, all of it still, or one of its ends not; and two single bodies.

    One of these flies, and the other one is still.
    """
    flying, count = 4, 6
    joined = [(0, 1), (1, 2), (2, 3)]
    yield _world(stream, count, joined, moving=(flying,))
    for end in (1, 3):
        yield _world(stream, count, joined, moving=(end, flying))


def piles_on_one_floor(stream: Random) -> Iterator[Arguments]:
    """Draw two piles that share nothing but the floor; one has a body that moves, or none has.

    The floor is the last body in the first one. In the second one an end of a pile of three moves.
    """
    joined = [(0, 1), (1, 2), (0, 3), (3, 4), (4, 5)]
    yield _reversed(_world(stream, 6, joined, moving=(stream.randint(1, 2),)))
    yield _world(stream, 6, joined, moving=(5,))
    yield _world(stream, 6, joined, moving=())


def long_chains(stream: Random) -> Iterator[Arguments]:
    """Draw chains of bodies in a shuffled order, the one at the end of which moves; and a pair.

    In two of them the numbers go up, and down again to the one that moves, or the other way round:
    whoever goes through the bodies once does not come to the end. The last one is the longest.
    """

    def shuffled(links: int, moves: bool) -> Arguments:
        order = [*range(1, links + 3)]
        stream.shuffle(order)
        return _chain_and_pair(stream, order[:links], order[links:], moves)

    for moves in (True, False):
        yield shuffled(5, moves)
    for way in (1, -1):
        lowest, *chain = sorted(stream.sample(range(1, 8), 5))[::way]
        pair = [n for n in range(1, 8) if n not in (lowest, *chain)]
        yield _chain_and_pair(stream, [*chain, lowest], pair, moves=True)
    yield shuffled(12, moves=True)


def _chain_and_pair(stream: Random, chain: list[int], pair: list[int], moves: bool) -> Arguments:
    """Return a chain and a pair on a floor; the end of one of the two moves."""
    joined = [(0, n) for n in (*chain, *pair)]
    joined += [(min(a, b), max(a, b)) for a, b in (*pairwise(chain), pair)]
    return _world(
        stream, 1 + len(chain) + len(pair), joined, moving=(chain[-1] if moves else pair[-1],)
    )


def _reversed(world: Arguments) -> Arguments:
    """Return a world whose bodies are numbered the other way round."""
    inverse_masses, still, touches = world
    return inverse_masses[::-1], still[::-1], tuple(row[::-1] for row in touches[::-1])


def _world(
    stream: Random, count: int, joined: list[tuple[int, int]], moving: tuple[int, ...]
) -> Arguments:
    """Return inverse masses, which bodies are still, and the table of what touches what."""
    still = tuple(0 if n in moving else 1 for n in range(count))
    pairs = {*joined, *((b, a) for a, b in joined)}
    touches = tuple(tuple(int((a, b) in pairs) for b in range(count)) for a in range(count))
    return (0.0, *_inverse_masses(stream, count - 1)), still, touches


# What is expected


def _pairs(inverse_masses: Any) -> list[tuple[int, int]]:
    """Return the pairs of bodies of which one can be pushed."""
    count = len(inverse_masses)
    return [
        (a, b)
        for a in range(count)
        for b in range(a + 1, count)
        if inverse_masses[a] > 0 or inverse_masses[b] > 0
    ]


def _most_friction(inverse_masses: Any, frictions: Any) -> float:
    """Return the largest friction coefficient of any pair that can meet."""
    pairs = _pairs(inverse_masses)
    return max((math.sqrt(frictions[a] * frictions[b]) for a, b in pairs), default=0.0)


def _effects_called_for(bodies: Any, gravity: Any) -> list[str]:
    """Return the names of the effects that a scene calls for, in alphabetical order."""
    inverse_masses, corners, restitutions, frictions, turning = np.transpose(bodies)
    rubs = _most_friction(inverse_masses, frictions) > 0
    bounces = any(min(restitutions[a], restitutions[b]) > 0 for a, b in _pairs(inverse_masses))
    free = inverse_masses > 0
    turns = bool(turning.any() or corners[free].any() or (free.any() and rubs))
    found = {"friction": rubs, "gravity": any(gravity), "restitution": bounces, "rotation": turns}
    return [name for name, is_needed in found.items() if is_needed]


def _fastest_way(masses: Any, velocities: Any, dt: float) -> float:
    """Return how far the fastest body can ever move in a step, m."""
    m, v = np.asarray(masses, dtype=float), np.asarray(velocities, dtype=float)
    return float(np.sqrt(m @ (v * v).sum(axis=1) / m.min()) * dt)


def _box_of_flight(
    position: Any, velocity: Any, radius: float, gravity: Any, duration: float
) -> tuple[float, float, float, float]:
    """Return left, right, low and high of the smallest box around a disc's flight, m."""
    sides: list[float] = []
    for start, speed, gain in zip(position, velocity, gravity, strict=True):
        times = [0.0, duration]
        if gain != 0 and 0 < -speed / gain < duration:
            times.append(-speed / gain)
        places = [start + speed * t + gain * t * t / 2 for t in times]
        sides += [min(places) - radius, max(places) + radius]
    left, right, low, high = sides
    return left, right, low, high


def _bodies_asleep(inverse_masses: Any, still: Any, touches: Any) -> list[int]:
    """Return the numbers of the bodies whose whole island is still."""
    free = [n for n, inverse_mass in enumerate(inverse_masses) if inverse_mass > 0]
    awake = {n for n in free if not still[n]}
    while reached := {b for a in awake for b in free if touches[a][b]} - awake:
        awake |= reached
    return [n for n in free if n not in awake]


# Parts of an answer, and reasons


def says_friction(names: Any) -> bool:
    """Return whether an answer names friction."""
    return "friction" in list(names)


def says_restitution(names: Any) -> bool:
    """Return whether an answer names restitution."""
    return "restitution" in list(names)


def says_rotation(names: Any) -> bool:
    """Return whether an answer names rotation."""
    return "rotation" in list(names)


def in_order(names: Any) -> list[Any]:
    """Return names or numbers sorted: any order is right."""
    return sorted(names)


def pairs_that_can_meet(arguments: Arguments, _answer: Any) -> str:
    """Say which pairs count, and their coefficients."""
    inverse_masses, frictions = arguments
    found = [
        f"{a} and {b}: {written(math.sqrt(frictions[a] * frictions[b]), 3)}"
        for a, b in _pairs(inverse_masses)
    ]
    return f"Pairs of which one can be pushed: {', '.join(found)}."


def energy_of_all(arguments: Arguments, _answer: Any) -> str:
    """Say how much energy there is, and who would be fastest with it."""
    masses, velocities, _ = arguments
    energy = sum(m * (x * x + y * y) / 2 for m, (x, y) in zip(masses, velocities, strict=True))
    return f"All bodies together have {written(energy)} J; the lightest has {min(masses)} kg."


def turning_times(arguments: Arguments, _answer: Any) -> str:
    """Say when a flight turns back."""
    _, velocity, _, gravity, duration = arguments
    times = [-v / g for v, g in zip(velocity, gravity, strict=True) if g]
    told = ", ".join(f"{written(t, 4)} s" for t in times) or "never"
    return f"It turns back at: {told}; the flight lasts from 0 to {duration} s."


def islands_in_words(arguments: Arguments, _answer: Any) -> str:
    """Say who moves and who touches whom, the floor left out."""
    inverse_masses, still, touches = arguments
    moving = [str(n) for n, is_still in enumerate(still) if not is_still] or ["none"]
    free = [n for n, inverse_mass in enumerate(inverse_masses) if inverse_mass > 0]
    pairs = [f"{a}-{b}" for a, b in combinations(free, 2) if touches[a][b] > 0]
    return f"Moving: {', '.join(moving)}. Touching, the floor left out: {', '.join(pairs)}."


TASKS = (
    Task(
        id="10.1",
        function="most_friction",
        section=2,
        objective="The rule for friction: the largest coefficient of any pair that can meet.",
        expected=_most_friction,
        criteria=(
            Criterion("bodies that can all be pushed", free_bodies),
            Criterion("rough floors", rough_floors),
            Criterion("rough bodies with smooth partners", smooth_partners),
        ),
        explain=pairs_that_can_meet,
    ),
    Task(
        id="10.2",
        function="effects_called_for",
        section=1,
        objective="The plan of a scene, before it is run.",
        expected=_effects_called_for,
        any_order=0,
        criteria=(
            Criterion("friction", rough_or_smooth, part=says_friction),
            Criterion("restitution", bouncing_or_not, part=says_restitution),
            Criterion("rotation", turning_or_not, points=2, part=says_rotation),
            Criterion("the whole plan", whole_plans, part=in_order),
        ),
    ),
    Task(
        id="10.3",
        function="fastest_way",
        section=5,
        objective="How far a body can move in a step, from the energy of all.",
        expected=_fastest_way,
        criteria=(
            Criterion("equal masses", equal_discs),
            Criterion("different masses", unequal_discs, points=2),
            Criterion("a light body at rest", a_light_one_at_rest),
        ),
        explain=energy_of_all,
    ),
    Task(
        id="10.4",
        function="box_of_flight",
        section=8,
        objective="The box that a flight stays in.",
        expected=_box_of_flight,
        criteria=(
            Criterion("without gravity", straight_flights),
            Criterion("it turns back within the time", turning_points_inside, points=2),
            Criterion("it turns back later, or would have earlier", turning_points_outside),
        ),
        explain=turning_times,
    ),
    Task(
        id="10.5",
        function="bodies_asleep",
        section=9,
        objective="Which bodies may sleep: those whose whole island is still.",
        expected=_bodies_asleep,
        any_order=0,
        criteria=(
            Criterion("one pile", one_pile, part=in_order),
            Criterion("piles on one floor", piles_on_one_floor, points=2, part=in_order),
            Criterion("long chains", long_chains, part=in_order),
        ),
        explain=islands_in_words,
    ),
)

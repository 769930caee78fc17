"""Wrong models of the asteroid field: bursts, shots, collisions."""

from __future__ import annotations

from itertools import combinations
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


def _apart(masses: Vector, speed: float, heading: float) -> Any:
    """Return velocities that are spread evenly round the circle."""
    turns = heading + 2 * np.pi * np.arange(len(masses)) / len(masses)
    return speed * np.column_stack([np.cos(turns), np.sin(turns)])


@wrong_model(
    "A.1",
    "You take nothing back, or the plain mean, which is 0. Which of two pieces of one speed, a "
    "heavy and a light one, has more momentum?",
)
def nothing_taken_back(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """Directions that are spread evenly keep the momentum, whatever the masses."""
    return velocity + _apart(masses, speed, heading)


@wrong_model("A.1", "Which piece should change your answer more, a light one or a heavy one?")
def weighed_the_wrong_way(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """In the mean that is taken back, light pieces count most."""
    apart = _apart(masses, speed, heading)
    return velocity + apart - (1 / masses) @ apart / np.sum(1 / masses)


@wrong_model("A.1", "Did the asteroid move before it burst? Where is its momentum afterwards?")
def forgets_the_asteroid(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """The pieces fly apart from where the asteroid was, at rest."""
    apart = _apart(masses, speed, heading)
    return apart - masses @ apart / np.sum(masses)


@wrong_model("A.1", "A light piece and a heavy one: who got which share of the velocity?")
def momentum_for_velocity(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """Each piece gives back its own share of the surplus, by its mass."""
    apart = _apart(masses, speed, heading)
    surplus = masses @ apart
    return velocity + apart - masses[:, None] * surplus / np.sum(masses**2)


@wrong_model("A.2", "A gun that fires pushes back. How fast is your ship after the shot?")
def without_recoil(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The ship feels nothing of a shot."""
    return velocity, velocity + muzzle_speed * np.array([np.cos(heading), np.sin(heading)])


@wrong_model(
    "A.2", "The muzzle speed is seen from the ship. Does the shot keep the ship's velocity?"
)
def forgets_the_ship(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The shot leaves at the muzzle speed, however the ship moves."""
    shot = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    return velocity - shot_mass / ship_mass * shot, shot


@wrong_model("A.2", "The ship flies on at 100 m/s. Is a shot of 50 m/s behind it or before it?")
def seen_from_the_ground(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The muzzle speed is that over the ground; the ship has the rest of the momentum."""
    shot = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    return velocity + shot_mass / ship_mass * (velocity - shot), shot


@wrong_model("A.2", "After the shot, how fast is it as seen from the ship that has recoiled?")
def seen_from_before(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The muzzle speed is that seen from the ship before it fired."""
    relative = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    return velocity - shot_mass / ship_mass * relative, velocity + relative


@wrong_model("A.2", "Add up both momenta. In which direction does the ship go?")
def recoils_forward(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The shot pulls the ship with it."""
    relative = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    ship = velocity + shot_mass / (ship_mass + shot_mass) * relative
    return ship, ship + relative


def _pairs(positions: Vector, radii: Vector) -> Any:
    """Yield the pairs that overlap, each with its normal, in order."""
    for a, b in combinations(range(len(radii)), 2):
        offset = positions[b] - positions[a]
        distance = np.hypot(*offset)
        if 0 < distance < radii[a] + radii[b]:
            yield a, b, offset / distance


@wrong_model(
    "A.3", "Two of your asteroids part and still overlap. What does your impulse do to them?"
)
def without_gate(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Whatever overlaps collides."""
    v = velocities.copy()
    for a, b, n in _pairs(positions, radii):
        j = (1 + restitution) * np.dot(v[a] - v[b], n) / (1 / masses[a] + 1 / masses[b])
        v[a] -= j / masses[a] * n
        v[b] += j / masses[b] * n
    return v


@wrong_model("A.3", "A pebble hits a mountain. Do both change their velocities by the same?")
def masses_alike(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Both bodies of a pair share the change of velocity alike."""
    v = velocities.copy()
    for a, b, n in _pairs(positions, radii):
        change = (1 + restitution) / 2 * max(np.dot(v[a] - v[b], n), 0.0) * n
        v[a] -= change
        v[b] += change
    return v


@wrong_model(
    "A.3", "A third asteroid meets one that has just been hit. Which velocity has that one?"
)
def all_from_the_old_velocities(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Every pair finds the velocities from before all collisions."""
    v = velocities.copy()
    for a, b, n in _pairs(positions, radii):
        approach = max(np.dot(velocities[a] - velocities[b], n), 0.0)
        j = (1 + restitution) * approach / (1 / masses[a] + 1 / masses[b])
        v[a] -= j / masses[a] * n
        v[b] += j / masses[b] * n
    return v


@wrong_model(
    "A.3", "Two bodies meet at a slant. Which part of the relative velocity does 1 + e act on?"
)
def whole_relative_velocity(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """The impulse acts along the relative velocity."""
    v = velocities.copy()
    for a, b, n in _pairs(positions, radii):
        relative = v[a] - v[b]
        if np.dot(relative, n) > 0:
            j = (1 + restitution) * relative / (1 / masses[a] + 1 / masses[b])
            v[a] -= j / masses[a]
            v[b] += j / masses[b]
    return v


@wrong_model("A.3", "Head on, with restitution 0, how fast do two bodies part?")
def twice_the_impulse(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """An impact needs 2 (1 + e)."""
    v = velocities.copy()
    for a, b, n in _pairs(positions, radii):
        approach = max(np.dot(v[a] - v[b], n), 0.0)
        j = 2 * (1 + restitution) * approach / (1 / masses[a] + 1 / masses[b])
        v[a] -= j / masses[a] * n
        v[b] += j / masses[b] * n
    return v


@wrong_model("A.3", "A rock is hit twice. What has its second hit to know of the first?")
def from_the_velocities_before(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Each pair is worked out from the velocities at the start; the last one counts."""
    after = np.array(velocities, dtype=float)
    for a in range(len(masses)):
        for b in range(a + 1, len(masses)):
            d = positions[b] - positions[a]
            distance = np.hypot(*d)
            if distance == 0 or distance >= radii[a] + radii[b]:
                continue
            approach = (velocities[a] - velocities[b]) @ d / distance
            if approach > 0:
                j = (1 + restitution) * approach / (1 / masses[a] + 1 / masses[b]) * d / distance
                after[a] = velocities[a] - j / masses[a]
                after[b] = velocities[b] + j / masses[b]
    return after


@wrong_model("A.3", "An asteroid overlaps two others. With how many of them does it collide?")
def one_collision_each(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """An asteroid that has collided is done for this step."""
    v, done = velocities.copy(), set[int]()
    for a, b, n in _pairs(positions, radii):
        approach = np.dot(v[a] - v[b], n)
        if approach > 0 and not {a, b} & done:
            impulse = (1 + restitution) * approach / (1 / masses[a] + 1 / masses[b])
            v[a] -= impulse / masses[a] * n
            v[b] += impulse / masses[b] * n
            done |= {a, b}
    return v


@wrong_model(
    "A.1", "The same velocity is taken from all. Is it the same in yours for light pieces?"
)
def equal_shares_of_the_momentum(
    velocity: Vector, masses: Vector, speed: float, heading: float
) -> Any:
    """Each piece gives back an equal share of the surplus of momentum."""
    apart = _apart(masses, speed, heading)
    return velocity + apart - masses @ apart / (len(masses) * np.array(masses)[:, None])


@wrong_model("A.1", "All pieces fly apart as fast in the task. Which of yours does not?")
def the_last_piece_pays(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """The last piece gets the velocity that makes the momentum right; the others keep theirs."""
    apart = _apart(masses, speed, heading)
    apart[-1] -= masses @ apart / masses[-1]
    return velocity + apart


@wrong_model("A.1", "Is the speed of the task that of a piece, or its momentum?")
def equal_momenta(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """Each piece has as much momentum as the others, so the light ones are faster."""
    return velocity + _apart(masses, speed, heading) * np.mean(masses) / masses[:, None]


@wrong_model("A.1", "Two pieces: by which angle do their directions differ, and by which in yours?")
def first_and_last_alike(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """The directions are spread from the heading all the way round to the heading again."""
    turns = heading + np.linspace(0, 2 * np.pi, len(masses))
    apart = speed * np.column_stack([np.cos(turns), np.sin(turns)])
    return velocity + apart - masses @ apart / np.sum(masses)


@wrong_model("A.1", "A full turn in radians: how much is it?")
def a_turn_of_360_radians(velocity: Vector, masses: Vector, speed: float, heading: float) -> Any:
    """A full turn is 360, also for the sine and the cosine."""
    turns = heading + 360 * np.arange(len(masses)) / len(masses)
    apart = speed * np.column_stack([np.cos(turns), np.sin(turns)])
    return velocity + apart - masses @ apart / np.sum(masses)


@wrong_model("A.1", "Before it burst, how fast did each part of the asteroid move?")
def the_velocity_is_shared_out(
    velocity: Vector, masses: Vector, speed: float, heading: float
) -> Any:
    """Each piece takes its share, by mass, of the asteroid's velocity along."""
    apart = _apart(masses, speed, heading)
    apart = apart - masses @ apart / np.sum(masses)
    return apart + velocity * (masses / np.sum(masses))[:, None]


@wrong_model("A.2", "A heavy cannon fires a light ball. Do both fly off equally fast?")
def as_fast_backwards(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The ship is thrown back as fast as the shot flies forward."""
    relative = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    return velocity - relative, velocity + relative


@wrong_model("A.2", "The ship moves before the shot. Did the shot not move with it?")
def the_shot_starts_from_rest(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """The ship keeps its velocity, less the recoil; the shot has only what the cannon gives it."""
    relative = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    part = shot_mass / (ship_mass + shot_mass)
    return velocity - part * relative, (1 - part) * relative


@wrong_model("A.2", "From which axis is a heading measured, and which way has heading 0?")
def heading_from_the_vertical(
    velocity: Vector, ship_mass: float, shot_mass: float, muzzle_speed: float, heading: float
) -> Any:
    """A heading of 0 is up: x goes with the sine and y with the cosine."""
    relative = muzzle_speed * np.array([np.sin(heading), np.cos(heading)])
    part = shot_mass / (ship_mass + shot_mass)
    return velocity - part * relative, velocity + (1 - part) * relative


def _with_impulses(
    velocities: Vector, masses: Vector, pairs: Any, restitution: float, rounds: int = 1
) -> Any:
    """Return the velocities after the impulses of some pairs, each as often as there are rounds."""
    v, found = velocities.copy(), list(pairs)
    for a, b, n in rounds * found:
        approach = max(0.0, np.dot(v[a] - v[b], n))
        impulse = (1 + restitution) * approach / (1 / masses[a] + 1 / masses[b]) * n
        v[a] -= impulse / masses[a]
        v[b] += impulse / masses[b]
    return v


@wrong_model("A.3", "What is the restitution for, if all collisions of yours are elastic?")
def always_elastic(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Collisions in space lose no energy."""
    return _with_impulses(velocities, masses, _pairs(positions, radii), 1.0)


@wrong_model("A.3", "How often does each pair have its turn in the task?")
def until_nothing_approaches(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Pairs collide again and again, until none approaches."""
    return _with_impulses(velocities, masses, _pairs(positions, radii), restitution, rounds=100)


@wrong_model("A.3", "Which pairs does your inner loop visit twice?")
def each_pair_from_both_sides(
    positions: Vector, velocities: Vector, masses: Vector, radii: Vector, restitution: float
) -> Any:
    """Each asteroid collides with each other one: 1 with 2, and later 2 with 1."""
    found = list(_pairs(positions, radii))
    both = sorted([*found, *((b, a, -n) for a, b, n in found)], key=lambda pair: pair[:2])
    return _with_impulses(velocities, masses, both, restitution)

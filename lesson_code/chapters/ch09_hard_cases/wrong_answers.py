"""Wrong models of chapter 09: towers, sweeps, sliding tips, energy, and rows of balls.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


@wrong_model("9.1", "The lowest box stands on the floor. Who carries the boxes above it?")
def own_weight(masses: Vector, gravity: float) -> Any:
    """Under a box is its own weight."""
    return np.array(masses) * gravity


@wrong_model("9.1", "Take the highest box. Which boxes does the contact under it carry?")
def whole_weight(masses: Vector, gravity: float) -> Any:
    """Every contact carries the whole tower."""
    return np.full(len(masses), sum(masses) * gravity)


@wrong_model("9.1", "The force under a box: does that box itself press on it?")
def without_the_box_itself(masses: Vector, gravity: float) -> Any:
    """Under a box is the weight of the boxes above it."""
    return np.array([sum(masses[n + 1 :]) * gravity for n in range(len(masses))])


@wrong_model("9.1", "Where is your largest force: under the lowest box, or under the highest?")
def counted_from_the_floor(masses: Vector, gravity: float) -> Any:
    """The forces add up from the floor to the top."""
    return np.cumsum(masses) * gravity


@wrong_model("9.2", "A sweep leaves M/(M + m) of the approach. Is that half of it, for a load?")
def halved_each_time(light: float, heavy: float, left: float) -> int:
    """Each sweep halves the error."""
    return math.ceil(-math.log2(left))


@wrong_model("9.2", "Put in M = 100 m: does your load come to rest in five sweeps?")
def masses_swapped(light: float, heavy: float, left: float) -> int:
    """A sweep leaves m/(M + m)."""
    return math.ceil(-math.log(left) / math.log1p(heavy / light))


@wrong_model("9.2", "Does every sweep take away the same amount, or the same part of what is left?")
def same_amount_each_time(light: float, heavy: float, left: float) -> int:
    """A sweep takes m/(M + m) away, and n sweeps take n times that."""
    return math.ceil((1 - left) * (heavy + light) / light)


@wrong_model("9.2", "Is 2.3 sweeps enough, if 2 are not?")
def rounded_down(light: float, heavy: float, left: float) -> int:
    """What is left of a sweep does not count."""
    return math.floor(-math.log(left) / math.log1p(light / heavy))


@wrong_model("9.2", "With M/m = 1e9: how many digits of M/(M + m) = 0.999999999 say anything?")
def digits_lost(light: float, heavy: float, left: float) -> int:
    """The logarithm of M/(M + m) is as good as any other."""
    return math.ceil(math.log(left) / math.log(heavy / (heavy + light)))


@wrong_model("9.3", "Friction acts beside the centre, too. Does it not turn the rod?")
def friction_does_not_lift(
    vn: float, vt: float, knn: float, knt: float, friction: float
) -> float | None:
    """Friction acts along the floor, and changes nothing across it."""
    return -vn / knn if vn < 0 else 0.0


@wrong_model("9.3", "The tip slides to the left. Which way does friction act?")
def always_to_the_left(
    vn: float, vt: float, knn: float, knt: float, friction: float
) -> float | None:
    """Friction acts to the left."""
    if vn >= 0:
        return 0.0
    yields = knn - friction * knt
    return -vn / yields if yields > 0 else None


@wrong_model("9.3", "Does friction act with the sliding, or against it?")
def friction_drives(vn: float, vt: float, knn: float, knt: float, friction: float) -> float | None:
    """Friction acts the way the tip slides."""
    if vn >= 0:
        return 0.0
    yields = knn + friction * math.copysign(1, vt) * knt
    return -vn / yields if yields > 0 else None


@wrong_model("9.3", "Your impulse is negative. Can a floor pull?")
def a_floor_that_pulls(
    vn: float, vt: float, knn: float, knt: float, friction: float
) -> float | None:
    """The formula has an answer for every tip."""
    if vn >= 0:
        return 0.0
    return -vn / (knn - friction * math.copysign(1, vt) * knt)


@wrong_model("9.3", "The tip leaves the floor. What would an impulse do that brings vn to 0?")
def holds_what_parts(vn: float, vt: float, knn: float, knt: float, friction: float) -> float | None:
    """The tip ends with vn = 0, whatever it had."""
    yields = knn - friction * math.copysign(1, vt) * knt
    return -vn / yields if yields > 0 else None


@wrong_model("9.4", "The rod turns. Is there no energy in that?")
def without_spin(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """Kinetic energy is m v^2 / 2."""
    after = velocity + impulse / mass
    return float(after @ after / (velocity @ velocity)) if velocity.any() else 0.0


@wrong_model("9.4", "A blow up, to the right of the centre: does that turn the body to the left?")
def turns_the_other_way(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The blow turns the body clockwise."""
    after = velocity + impulse / mass
    w_after = w - (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    before = mass * (velocity @ velocity) + inertia * w**2
    return float((mass * (after @ after) + inertia * w_after**2) / before)


@wrong_model("9.4", "The blow comes beside the centre. Does the spin stay as it was?")
def spin_stays(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """A blow changes the velocity, and the spin stays."""
    after = velocity + impulse / mass
    before = mass * (velocity @ velocity) + inertia * w**2
    return float((mass * (after @ after) + inertia * w**2) / before)


@wrong_model("9.4", "Is a blow along the arm as good at turning as one across it?")
def torque_of_lengths(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The torque is the length of the arm times the length of the blow."""
    after = velocity + impulse / mass
    w_after = w + np.hypot(*arm) * np.hypot(*impulse) / inertia
    before = mass * (velocity @ velocity) + inertia * w**2
    return float((mass * (after @ after) + inertia * w_after**2) / before)


@wrong_model("9.4", "How large is the ratio if nothing changes: 0, or 1?")
def the_gain_alone(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The ratio says what has been added."""
    after = velocity + impulse / mass
    w_after = w + (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    before = mass * (velocity @ velocity) + inertia * w**2
    return float((mass * (after @ after) + inertia * w_after**2) / before - 1)


@wrong_model("9.5", "Two balls come. When the last has left, is there another pair that meets?")
def one_pass(masses: Vector, velocities: Vector) -> Any:
    """One pass from the left to the right does it."""
    v = np.array(velocities, dtype=float)
    for k in range(len(v) - 1):
        if v[k] > v[k + 1]:
            centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
            v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "A heavy ball hits a light one. Do they change velocities?")
def always_swaps(masses: Vector, velocities: Vector) -> Any:
    """Elastic balls change velocities."""
    return np.sort(velocities)


@wrong_model("9.5", "Which strike comes first, where two pairs approach: the one on the left?")
def leftmost_first(masses: Vector, velocities: Vector) -> Any:
    """The pairs strike from the left to the right, again and again."""
    v = np.array(velocities, dtype=float)
    while (v[:-1] - v[1:]).max() > 1e-9:
        k = int(np.argmax(v[:-1] - v[1:] > 1e-9))
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "The balls part. Why do they strike?")
def without_a_gate(masses: Vector, velocities: Vector) -> Any:
    """Every pair that touches strikes once, from the left to the right."""
    v = np.array(velocities, dtype=float)
    for k in range(len(v) - 1):
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "After your strikes all balls have one velocity. Where is the energy?")
def sticks_together(masses: Vector, velocities: Vector) -> Any:
    """What is in touch moves on together."""
    v = np.array(velocities, dtype=float)
    if (v[:-1] <= v[1:]).all():
        return v
    return np.full(len(v), masses @ v / masses.sum())


@wrong_model("9.1", "Three boxes stand on the lowest. How many of them does it carry?")
def the_next_box_alone(masses: Vector, gravity: float) -> Any:
    """A box carries the one above it, and that one the next."""
    above = [*list(masses)[1:], 0.0]
    return [(m + n) * gravity for m, n in zip(masses, above, strict=True)]


@wrong_model("9.3", "The tip slides twice as fast. Is the friction twice as large?")
def grows_with_the_sliding(vn: float, vt: float, knn: float, knt: float, friction: float) -> Any:
    """Friction is in proportion to the speed of the sliding."""
    if vn >= 0:
        return 0.0
    share = knn - friction * vt * knt
    return None if share <= 0 else -vn / share


@wrong_model("9.1", "Does the floor carry all of the lowest box, or half of it?")
def half_of_the_box_itself(masses: Vector, gravity: float) -> Any:
    """A box presses with its upper half from above, and with its lower half on nothing."""
    return np.array([(sum(masses[n:]) - masses[n] / 2) * gravity for n in range(len(masses))])


@wrong_model("9.2", "Is 2.3 sweeps enough, if 2 are not?")
def to_the_nearest(light: float, heavy: float, left: float) -> int:
    """A number of sweeps is rounded as any number is."""
    return max(1, round(-math.log(left) / math.log1p(light / heavy)))


@wrong_model("9.4", "Push a moving body against its motion. Does its energy grow?")
def energies_add_up(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The blow adds the energy that it would give to a body at rest."""
    before = mass * (velocity @ velocity) + inertia * w**2
    torque = arm[0] * impulse[1] - arm[1] * impulse[0]
    return float(1 + ((impulse @ impulse) / mass + torque**2 / inertia) / before)


@wrong_model("9.5", "Of the pairs that approach, which one do you let strike first?")
def rightmost_first(masses: Vector, velocities: Vector) -> Any:
    """The pairs strike from the right to the left, again and again."""
    v = np.array(velocities, dtype=float)
    for _ in range(10_000):
        near = np.flatnonzero(v[:-1] - v[1:] > 1e-9)
        if len(near) == 0:
            break
        k = near[-1]
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.4", "Push a body through its centre. Does your blow turn it?")
def dot_for_torque(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The torque is the dot product of arm and blow."""
    v, spin = velocity + impulse / mass, w + arm @ impulse / inertia
    before = mass * (velocity @ velocity) + inertia * w**2
    return float((mass * (v @ v) + inertia * spin**2) / before)

"""Wrong models of chapter 09: towers, sweeps, sliding tips, and energy.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import edited, wrong_model

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


@wrong_model("9.4", "Your number is in J. What is the unit of a ratio?")
def the_gain_in_joules(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """How much energy a blow makes is what it adds."""
    after = velocity + impulse / mass
    w_after = w + (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    gained = mass * (after @ after - velocity @ velocity) + inertia * (w_after**2 - w**2)
    return float(gained) / 2


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


@wrong_model("9.2", "Sweeps are counted. What is 2.3 of one?")
def not_a_whole_number(light: float, heavy: float, left: float) -> float:
    """The number of sweeps is where the power comes down to the part that is allowed."""
    return -math.log(left) / math.log1p(light / heavy)


@wrong_model("9.4", "Push a moving body against its motion. Does its energy grow?")
def energies_add_up(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The blow adds the energy that it would give to a body at rest."""
    before = mass * (velocity @ velocity) + inertia * w**2
    torque = arm[0] * impulse[1] - arm[1] * impulse[0]
    return float(1 + ((impulse @ impulse) / mass + torque**2 / inertia) / before)


@wrong_model("9.4", "Push a body through its centre. Does your blow turn it?")
def dot_for_torque(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The torque is the dot product of arm and blow."""
    v, spin = velocity + impulse / mass, w + arm @ impulse / inertia
    before = mass * (velocity @ velocity) + inertia * w**2
    return float((mass * (v @ v) + inertia * spin**2) / before)


@wrong_model("9.1", "A light box lies upon a heavy one. Does its contact carry a half of both?")
def equal_steps(masses: Vector, gravity: float) -> Any:
    """From one contact to the next the force falls by the same amount."""
    count = len(masses)
    return np.sum(masses) * gravity * np.arange(count, 0, -1) / count


@wrong_model("9.1", "What stands above presses down, and so does the box. Why subtract one?")
def difference_of_weights(masses: Vector, gravity: float) -> Any:
    """Under a box is the difference of its weight and of what stands above it."""
    return [abs(sum(masses[n + 1 :]) - masses[n]) * gravity for n in range(len(masses))]


@wrong_model("9.2", "Take a load of 3 and a part left of 0.1, and then of 0.01. Is it one count?")
def as_many_as_the_ratio(light: float, heavy: float, left: float) -> int:
    """So many sweeps are needed as the load is heavier than the box."""
    return math.ceil(heavy / light)


@wrong_model("9.2", "After n sweeps, what part is (M/(M + m))^n: what is left, or what is gone?")
def what_has_gone(light: float, heavy: float, left: float) -> int:
    """The power of M/(M + m) is the part that has been taken away."""
    return math.ceil(math.log(1 - left) / math.log(heavy / (heavy + light)))


@wrong_model("9.2", "Two sweeps leave (M/(M + m))^2. Is that M/(M + 2 m)?")
def like_a_box_n_times_as_heavy(light: float, heavy: float, left: float) -> int:
    """After n sweeps M/(M + n m) is left."""
    return math.ceil((heavy / left - heavy) / light)


@wrong_model("9.2", "Is 2.3 sweeps enough, if 2 are not? And has 0.999999999 digits to spare?")
def rounded_down_with_digits_lost(light: float, heavy: float, left: float) -> int:
    """What is left of a sweep does not count, and log(M/(M + m)) is exact enough."""
    return math.floor(math.log(left) / math.log(heavy / (heavy + light)))


@wrong_model("9.2", "Is 2.3 sweeps enough, if 2 are not? And which digits has 0.999999999 left?")
def to_the_nearest_with_digits_lost(light: float, heavy: float, left: float) -> int:
    """A count is rounded as any number is, and log(M/(M + m)) is exact enough."""
    return round(math.log(left) / math.log(heavy / (heavy + light)))


@wrong_model("9.3", "The tip leaves the floor. Is there no answer, or an impulse of 0?")
def none_for_what_parts(
    vn: float, vt: float, knn: float, knt: float, friction: float
) -> float | None:
    """Where no impulse is needed, there is none to be returned."""
    yields = knn - friction * math.copysign(1, vt) * knt
    return -vn / yields if vn < 0 and yields > 0 else None


@wrong_model("9.3", "The tip jams. Would an impulse of 0 stop it?")
def zero_for_a_jam(vn: float, vt: float, knn: float, knt: float, friction: float) -> float | None:
    """A tip that jams needs no impulse."""
    yields = knn - friction * math.copysign(1, vt) * knt
    return -vn / yields if vn < 0 and yields > 0 else 0.0


@wrong_model("9.3", "Friction lifts the tip. Can it jam, however strong the friction is?")
def jams_either_way(vn: float, vt: float, knn: float, knt: float, friction: float) -> float | None:
    """Strong friction makes a tip jam, whichever way it slides."""
    if vn >= 0:
        return 0.0
    yields = knn - friction * math.copysign(1, vt) * knt
    return -vn / yields if friction * abs(knt) < knn else None


@wrong_model("9.3", "The tip slides all the time. How large is the friction of what slides?")
def friction_stops_the_tip(
    vn: float, vt: float, knn: float, knt: float, friction: float
) -> float | None:
    """Friction brings the sliding to rest, whatever the coefficient."""
    return -(vn - knt * vt / knn) / knn if vn < 0 else 0.0


@wrong_model("9.4", "A blow comes from the side. Is the body faster by all of J/m then?")
@edited(
    turns_the_other_way,
    {
        "velocity + impulse / mass": (
            "velocity * (1 + np.hypot(*impulse) / mass / np.hypot(*velocity))"
        ),
        "w - (": "w + (",
    },
)
def speeds_add_up() -> None:
    """A blow makes a body faster by the size of the blow over the mass, from wherever it comes."""


@wrong_model("9.4", "In m v^2 / 2 + I w^2 / 2: of which point of the body is v?")
def velocity_of_the_point_hit(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """Kinetic energy takes the velocity of the point that is hit."""
    turned = np.array([-arm[1], arm[0]])
    w_after = w + turned @ impulse / inertia
    before, after = velocity + w * turned, velocity + impulse / mass + w_after * turned
    energy = mass * (before @ before) + inertia * w**2
    return float((mass * (after @ after) + inertia * w_after**2) / energy)


@wrong_model("9.4", "In which of the two parts of the energy has your formula a half?")
def no_half_for_the_spin(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> float:
    """The energy of the rotation is I w^2."""
    after = velocity + impulse / mass
    w_after = w + (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    before = mass * (velocity @ velocity) + 2 * inertia * w**2
    return float((mass * (after @ after) + 2 * inertia * w_after**2) / before)


@wrong_model(
    "9.4", "A free body is hit. About which point does it turn: the hit one, or its centre?"
)
@edited(
    turns_the_other_way,
    {"w - (": "w + (", "impulse[0]) / inertia": "impulse[0]) / (inertia + mass * (arm @ arm))"},
)
def inertia_about_the_point_hit() -> None:
    """The blow turns the body about the point that is hit."""


@wrong_model("9.4", "A blow comes across the arm. Does the centre stay where it is?")
@edited(
    turns_the_other_way,
    {"impulse / mass": "impulse @ arm / (arm @ arm) * arm / mass", "w - (": "w + ("},
)
def only_the_part_towards_the_centre_moves() -> None:
    """The part of a blow along the arm moves the body, and the part across it turns it."""


@wrong_model("9.3", "The tip jams. Which impulse would do, or is there none?")
def a_jam_pushes_back(
    vn: float, vt: float, knn: float, knt: float, friction: float
) -> float | None:
    """An impulse is positive, so the divisor counts without its sign."""
    return -vn / abs(knn - friction * math.copysign(1, vt) * knt) if vn < 0 else 0.0

"""Wrong models of Newton's cradle: a row of collisions, a pendulum, the whole cradle."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.cradle.right_answers import in_the_frame_of_each_pair, swap_by_swap
from lesson_code.chapters.cradle.rules import GRAVITY, collide_row
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any

SLOWEST = 1e-12


@wrong_model(
    "C.1", "The last ball has got its velocity. Has every ball between passed all of it on?"
)
def one_pass(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """Going through the row once is enough."""
    v = velocities.copy()
    for k in range(len(v) - 1):
        if v[k] > v[k + 1]:
            j = (1 + restitution) * (v[k] - v[k + 1]) / (1 / masses[k] + 1 / masses[k + 1])
            v[k] -= j / masses[k]
            v[k + 1] += j / masses[k + 1]
    return v


@wrong_model("C.1", "Only equal masses that collide elastically swap. What are yours?")
def always_swaps(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """Two balls that collide swap their velocities."""
    return np.sort(velocities)


@wrong_model("C.1", "Your balls hand on all they have. What does a restitution of 0.9 leave?")
def always_elastic(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """Balls in a cradle are elastic."""
    v = velocities.copy()
    k = 0
    while k < len(v) - 1:
        if v[k] - v[k + 1] > SLOWEST:
            j = 2 * (v[k] - v[k + 1]) / (1 / masses[k] + 1 / masses[k + 1])
            v[k] -= j / masses[k]
            v[k + 1] += j / masses[k + 1]
            k = 0
        else:
            k += 1
    return v


@wrong_model("C.1", "Compute the momentum and the energy before and after. Which of them is kept?")
def only_the_last_flies(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """All of the momentum goes to the last ball."""
    v = np.zeros(len(masses))
    v[-1] = np.dot(masses, velocities) / masses[-1]
    return v


@wrong_model("C.2", "How long is the string in your formula? A longer one swings more slowly.")
def without_the_length(angle: float, rate: float, length: float, dt: float) -> Any:
    """Gravity turns a ball by g sin(angle)."""
    rate = rate - GRAVITY * math.sin(angle) * dt
    return angle + rate * dt, rate


@wrong_model("C.2", "At 60 degrees, is sin(angle) still the angle?")
def small_angles(angle: float, rate: float, length: float, dt: float) -> Any:
    """The pull is as large as the angle."""
    rate = rate - GRAVITY / length * angle * dt
    return angle + rate * dt, rate


@wrong_model("C.2", "Which rate moves your angle: the one before the step, or the one after it?")
def old_rate(angle: float, rate: float, length: float, dt: float) -> Any:
    """Angle and rate change together, each from what was before."""
    return angle + rate * dt, rate - GRAVITY / length * math.sin(angle) * dt


@wrong_model("C.2", "The ball hangs to the right. Which way does gravity turn it?")
def away_from_rest(angle: float, rate: float, length: float, dt: float) -> Any:
    """Gravity makes the angle larger."""
    rate = rate + GRAVITY / length * math.sin(angle) * dt
    return angle + rate * dt, rate


@wrong_model("C.3", "Do two of your balls ever touch?")
@edited(swap_by_swap, {"angles[k] >= angles[k + 1] and rates[k] > rates[k + 1]": "False"})
def never_collides() -> None:
    """Each ball swings for itself."""


@wrong_model("C.3", "One swap a step. How many steps does a push need through five balls?")
@edited(
    swap_by_swap,
    {"rates[[k + 1, k]]": "rates[[k + 1, k]]\n                break"},
)
def one_swap_a_step() -> None:
    """In each step one collision is enough."""


@wrong_model("C.3", "You go from left to right once. What of a ball that comes from the right?")
@edited(swap_by_swap, {"len(angles) * [*range(len(angles) - 1)]": "range(len(angles) - 1)"})
def one_pass_a_step() -> None:
    """In each step the pairs are looked at once, from left to right."""


@wrong_model("C.3", "Two balls come nearer, a hand's breadth apart. Have they hit each other yet?")
@edited(swap_by_swap, {"angles[k] >= angles[k + 1] and ": ""})
def swaps_at_a_distance() -> None:
    """Balls that approach swap their rates, touching or not."""


@wrong_model("C.3", "Two balls swing to the right, side by side. Do they collide?")
@edited(
    swap_by_swap,
    {
        "len(angles) * [*range(len(angles) - 1)]": "range(len(angles) - 1)",
        " and rates[k] > rates[k + 1]": "",
    },
)
def swaps_without_gate() -> None:
    """Balls that touch swap, whether they approach or part."""


@wrong_model("C.3", "Your balls stick together. What do two equal elastic balls do?")
@edited(
    swap_by_swap,
    {
        "len(angles) * [*range(len(angles) - 1)]": "range(len(angles) - 1)",
        "rates[[k + 1, k]]": "(rates[k] + rates[k + 1]) / 2",
    },
)
def sticks() -> None:
    """Balls that touch go on together."""


@wrong_model("C.3", "The balls swing, then collide. Where are they when you ask who touches?")
def touching_before_the_swing(
    angles: Vector, rates: Vector, length: float, dt: float, steps: float
) -> Any:
    """Balls collide if they touched before the swing."""
    angles, rates = np.array(angles, dtype=float), np.array(rates, dtype=float)
    for _ in range(int(steps)):
        touching = angles[:-1] >= angles[1:]
        rates = rates - GRAVITY / length * np.sin(angles) * dt
        angles = angles + rates * dt
        while True:
            hits = [i for i, touch in enumerate(touching) if touch and rates[i] > rates[i + 1]]
            if not hits:
                break
            rates[hits[0]], rates[hits[0] + 1] = rates[hits[0] + 1], rates[hits[0]]
    return angles, rates


@wrong_model("C.2", "At which angle should gravity pull in this step: the old one, or the new one?")
def angle_first(angle: float, rate: float, length: float, dt: float) -> Any:
    """First the ball moves, then gravity pulls at the place where it has come to."""
    angle = angle + rate * dt
    return angle, rate - GRAVITY / length * math.sin(angle) * dt


@wrong_model("C.2", "With which rate does the task move the ball: the new one, or a mean?")
def mean_of_both_rates(angle: float, rate: float, length: float, dt: float) -> Any:
    """The ball moves by the mean of the old and the new rate."""
    after = rate - GRAVITY / length * math.sin(angle) * dt
    return angle + (rate + after) / 2 * dt, after


@wrong_model("C.1", "Which pair goes first in the task: the leftmost, or the one that is fastest?")
@edited(in_the_frame_of_each_pair, {"pairs[0]": "max(pairs, key=lambda q: v[q] - v[q + 1])"})
def fastest_approach_first() -> None:
    """The two that approach fastest collide first."""


@wrong_model("C.1", "Pair 2 makes pair 1 approach again. Which of them is next in the task?")
def sweep_after_sweep(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """The row is gone through from left to right, again and again, until nothing approaches."""
    v = velocities
    for _ in range(200):
        v = one_pass.function(masses, v, restitution)
    return v


@wrong_model("C.1", "A row in which nobody has collided: do velocities change places?")
def turned_end_for_end(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """As many balls fly out as come in, so the velocities stand in the reverse order."""
    return velocities[::-1]


@wrong_model("C.1", "After the first collision another pair approaches. Who looks at it?")
@edited(
    in_the_frame_of_each_pair,
    {"    while True:": "    for turn in (0, 1):", "not pairs": "turn or not pairs"},
)
def one_collision_alone() -> None:
    """The leftmost pair that approaches collides, and that is all."""


@wrong_model("C.1", "A ball between two that approach it: how fast is it in the second hit?")
def all_pairs_at_once(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """All pairs that approach collide at once, with their velocities from before."""
    v = velocities.copy()
    for _ in range(1000):
        approach = v[:-1] - v[1:]
        if np.all(approach <= SLOWEST):
            break
        impulses = (1 + restitution) * approach / (1 / masses[:-1] + 1 / masses[1:])
        impulses[approach <= SLOWEST] = 0.0
        v[:-1] -= impulses / masses[:-1]
        v[1:] += impulses / masses[1:]
    return v


@wrong_model("C.2", "Is a ball on a string as hard to turn as a rod that is fixed at its end?")
def as_a_rod(angle: float, rate: float, length: float, dt: float) -> Any:
    """The string turns like a rod: by 3/2 g / length."""
    after = rate - 1.5 * GRAVITY / length * math.sin(angle) * dt
    return angle + after * dt, after


@wrong_model("C.2", "Is the rate that of the angle, or that of the ball along its arc?")
def rate_along_the_arc(angle: float, rate: float, length: float, dt: float) -> Any:
    """The angle changes by the rate over the length."""
    after = rate - GRAVITY / length * math.sin(angle) * dt
    return angle + after / length * dt, after


@wrong_model("C.2", "Which part of the weight acts along the arc: where is it in your triangle?")
def tangent_for_sine(angle: float, rate: float, length: float, dt: float) -> Any:
    """Gravity turns a ball by the tangent of its angle."""
    after = rate - GRAVITY / length * math.tan(angle) * dt
    return angle + after * dt, after


@wrong_model("C.2", "In which order does the task want angle and rate?")
def rate_in_front(angle: float, rate: float, length: float, dt: float) -> Any:
    """The rate is worked out first, so it is returned first."""
    after = rate - GRAVITY / length * math.sin(angle) * dt
    return after, angle + after * dt


@wrong_model("C.3", "Balls that touch: does one jump to the place of the other?")
@edited(
    swap_by_swap,
    {
        "rates[[k, k + 1]]": "rates[[k, k + 1]], angles[[k, k + 1]]",
        "rates[[k + 1, k]]": "rates[[k + 1, k]], angles[[k + 1, k]]",
    },
)
def places_change_hands() -> None:
    """Balls that collide exchange their rates and their angles."""


@wrong_model("C.3", "Two balls touch after the last swing. Do they collide in yours?")
def collides_before_the_swing(
    angles: Vector, rates: Vector, length: float, dt: float, steps: float
) -> Any:
    """In a step the balls collide first, and then they swing."""
    rates = rates.copy()
    for _ in range(int(steps)):
        for k in len(angles) * [*range(len(angles) - 1)]:
            if angles[k] >= angles[k + 1] and rates[k] > rates[k + 1]:
                rates[[k, k + 1]] = rates[[k + 1, k]]
        rates = rates - GRAVITY / length * np.sin(angles) * dt
        angles = angles + rates * dt
    return angles, rates


@wrong_model("C.3", "Two equal balls collide, one at rest. Does it stay at rest?")
@edited(swap_by_swap, {"rates[[k, k + 1]] = rates[[k + 1, k]]": "rates[k : k + 2] *= -1"})
def both_turn_round() -> None:
    """Balls that collide turn round, each as fast as it was."""


@wrong_model("C.1", "Half the sum of two velocities is their common one. For which masses?")
def equal_masses_throughout(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """The centre of mass moves with half the sum of the velocities."""
    return collide_row([1.0] * len(masses), velocities, restitution)

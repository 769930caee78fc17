"""Wrong models of pool: the rack, the stroke, an impact of many balls."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any

ROWS, TOUCHING, ROUNDS = 5, 2.001, 20


@wrong_model("P.1", "Three balls that touch: what triangle do their centres make, and how high?")
def square_rows(apex: Vector, radius: float, gap: float) -> Any:
    """Rows are as far apart as balls in a row."""
    step = 2 * radius + gap
    return [
        (apex[0] + row * step, apex[1] + (place - row / 2) * step)
        for row in range(ROWS)
        for place in range(row + 1)
    ]


@wrong_model(
    "P.1", "Where does the apex lie as seen along the rack: at its edge, or in its middle?"
)
def not_centred(apex: Vector, radius: float, gap: float) -> Any:
    """Every row begins at the apex's height."""
    step = 2 * radius + gap
    return [
        (apex[0] + row * step * np.sqrt(3) / 2, apex[1] + place * step)
        for row in range(ROWS)
        for place in range(row + 1)
    ]


@wrong_model("P.1", "Two balls of radius r touch. How far apart are their centres?")
def radius_for_diameter(apex: Vector, radius: float, gap: float) -> Any:
    """Neighbours' centres are one radius apart."""
    step = radius + gap
    return [
        (apex[0] + row * step * np.sqrt(3) / 2, apex[1] + (place - row / 2) * step)
        for row in range(ROWS)
        for place in range(row + 1)
    ]


@wrong_model("P.1", "You are given a gap. What is the distance of two neighbours' centres?")
def forgets_the_gap(apex: Vector, radius: float, gap: float) -> Any:
    """Balls in a rack touch, whatever the gap."""
    step = 2 * radius
    return [
        (apex[0] + row * step * np.sqrt(3) / 2, apex[1] + (place - row / 2) * step)
        for row in range(ROWS)
        for place in range(row + 1)
    ]


@wrong_model("P.1", "A gap stands between any two balls. Which triangle do three centres make?")
def whole_gap_between_rows(apex: Vector, radius: float, gap: float) -> Any:
    """The rows of touching balls are moved apart by the gap."""
    step, row_step = 2 * radius + gap, radius * np.sqrt(3) + gap
    return [
        (apex[0] + row * row_step, apex[1] + (place - row / 2) * step)
        for row in range(ROWS)
        for place in range(row + 1)
    ]


@wrong_model("P.2", "Push a book at its left edge, away from you. Which way does it turn?")
def turns_the_other_way(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """A hit on the left turns the ball counter-clockwise."""
    return impulse / mass, offset * np.hypot(*impulse) / (0.4 * mass * radius**2)


@wrong_model("P.2", "Is this a coin or a ball? What is the moment of inertia of a solid sphere?")
def a_disc(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """A ball has the moment of inertia of a disc."""
    return impulse / mass, -offset * np.hypot(*impulse) / (0.5 * mass * radius**2)


@wrong_model("P.2", "What unit has J / m? And what is J alone?")
def impulse_for_velocity(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """The impulse is the velocity."""
    return impulse, -offset * np.hypot(*impulse) / (0.4 * mass * radius**2)


@wrong_model("P.2", "Does a cue that hits off centre push the ball's centre less?")
def spin_costs_speed(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """What goes into spin is missing in the velocity."""
    left = 1 - abs(offset) / radius
    return impulse / mass * left, -offset * np.hypot(*impulse) / (0.4 * mass * radius**2)


def _touching(positions: Vector, radius: float) -> list[tuple[int, int, Any]]:
    """Return the pairs that touch, each with its normal."""
    pairs = []
    for a, b in combinations(range(len(positions)), 2):
        offset = positions[b] - positions[a]
        if np.hypot(*offset) <= TOUCHING * radius:
            pairs.append((a, b, offset / np.hypot(*offset)))
    return pairs


@wrong_model(
    "P.3", "Break head on. Is your answer as symmetric as the rack? Which pair came first?"
)
def one_pair_after_the_other(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """Pairs may be resolved in turn, each with the velocities that the last one left."""
    v = velocities.copy()
    for _ in range(ROUNDS):
        for a, b, normal in _touching(positions, radius):
            approach = np.dot(v[a] - v[b], normal)
            if approach > 0:
                v[a] -= (1 + restitution) / 2 * approach * normal
                v[b] += (1 + restitution) / 2 * approach * normal
    return v


@wrong_model("P.3", "Add up the energies before and after. One ball met two: what did it get?")
def every_pair_in_full(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """Each pair gets all of the impulse that it alone would need."""
    v = velocities.copy()
    for _ in range(ROUNDS):
        changes = np.zeros_like(v)
        for a, b, normal in _touching(positions, radius):
            approach = max(np.dot(v[a] - v[b], normal), 0.0)
            changes[a] -= (1 + restitution) / 2 * approach * normal
            changes[b] += (1 + restitution) / 2 * approach * normal
        v += changes
    return v


def _larger(one: int, other: int) -> tuple[int, int]:
    """Return the larger count for both."""
    return max(one, other), max(one, other)


def _shared(
    velocities: Vector,
    pairs: Any,
    restitution: float,
    rounds: int,
    counts: Callable[[int, int], Any],
) -> Any:
    """Return the velocities after shared impulses, by what each ball of a pair divides."""
    v = velocities.copy()
    for _ in range(rounds):
        meets = [(a, b, n, np.dot(v[a] - v[b], n)) for a, b, n in pairs]
        meets = [meeting for meeting in meets if meeting[3] > 0]
        busy = np.bincount([ball for a, b, _, _ in meets for ball in (a, b)], minlength=len(v))
        for a, b, normal, approach in meets:
            change = (1 + restitution) / 2 * approach * normal
            by_a, by_b = counts(busy[a], busy[b])
            v[a] -= change / by_a
            v[b] += change / by_b
    return v


@wrong_model("P.3", "Add up the momenta before and after. Is what a loses what b gains?")
def each_by_its_own_count(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """Each ball divides by the number of its own pairs."""
    touching = _touching(positions, radius)
    return _shared(velocities, touching, restitution, ROUNDS, lambda a, b: (a, b))


@wrong_model("P.3", "After one round, does any pair still approach?")
def one_round(positions: Vector, velocities: Vector, radius: float, restitution: float) -> Any:
    """One round is enough."""
    return _shared(velocities, _touching(positions, radius), restitution, 1, _larger)


@wrong_model("P.2", "Strike the ball away from you, along y. Does it not spin then?")
def pushed_along_x_alone(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """The push that turns the ball is the x part of the impulse."""
    return np.asarray(impulse) / mass, -offset * impulse[0] / (0.4 * mass * radius**2)


@wrong_model("P.3", "All impulses of a round come from the same velocities. Do yours?")
def changed_within_the_round(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """The shares are counted once a round; each pair then sees what the last one has left."""
    v = velocities.copy()
    for _ in range(ROUNDS):
        meets = [
            one for one in _touching(positions, radius) if (v[one[0]] - v[one[1]]) @ one[2] > 0
        ]
        busy = np.bincount([ball for a, b, _ in meets for ball in (a, b)], minlength=len(v))
        for a, b, normal in meets:
            approach = np.dot(v[a] - v[b], normal)
            change = (1 + restitution) / 2 * approach / max(busy[a], busy[b]) * normal
            v[a] -= change
            v[b] += change
    return v


@wrong_model("P.2", "Push a book at its edge and at its middle. Does its centre move less fast?")
def spin_takes_a_part(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """A stroke beside the centre moves the ball less, since a part of it makes the spin."""
    part = np.sqrt(max(0.0, 1 - (offset / radius) ** 2))
    spin = -offset * np.hypot(*impulse) / (0.4 * mass * radius**2)
    return np.asarray(impulse) / mass * part, spin


@wrong_model("P.3", "Two balls touch and part. Does their pair count in your division?")
def all_that_touch_count(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """An impulse is divided by how many balls are touched."""
    pairs, v = _touching(positions, radius), velocities.copy()
    busy = np.bincount([ball for a, b, _ in pairs for ball in (a, b)], minlength=len(v))
    for _ in range(ROUNDS):
        changes = np.zeros_like(v)
        for a, b, normal in pairs:
            approach = max(np.dot(v[a] - v[b], normal), 0.0)
            change = (1 + restitution) / 2 * approach / max(busy[a], busy[b]) * normal
            changes[a] -= change
            changes[b] += change
        v += changes
    return v


@wrong_model("P.3", "The second ball of a pair may be in more pairs than the first. Who counts it?")
def by_the_count_of_the_first(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """A pair's impulse is divided by the count of its first ball."""
    touching = _touching(positions, radius)
    return _shared(velocities, touching, restitution, ROUNDS, lambda a, _: (a, a))


@wrong_model("P.3", "Two balls in one pair each: by what does the task divide its impulse?")
def by_both_counts_together(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """A pair's impulse is divided by the counts of both balls, added up."""
    touching = _touching(positions, radius)
    return _shared(velocities, touching, restitution, ROUNDS, lambda a, b: (a + b, a + b))


@wrong_model("P.2", "About which point does a ball turn that nothing but the cue touches?")
def turns_about_the_cloth(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """A ball turns about the point where it lies on the cloth."""
    return impulse / mass, -offset * np.hypot(*impulse) / (1.4 * mass * radius**2)


@wrong_model("P.1", "Which way does the rack open: away from the apex to the right, or upward?")
def opens_upwards(apex: Vector, radius: float, gap: float) -> Any:
    """The rows lie above each other, and a row runs along x."""
    step = 2 * radius + gap
    return [
        (apex[0] + (k - row / 2) * step, apex[1] + row * step * np.sqrt(3) / 2)
        for row in range(5)
        for k in range(row + 1)
    ]


@wrong_model("P.1", "In which direction does y grow within a row of the task?")
def rows_from_the_top(apex: Vector, radius: float, gap: float) -> Any:
    """Each row begins with its uppermost ball."""
    step = 2 * radius + gap
    return [
        (apex[0] + row * step * np.sqrt(3) / 2, apex[1] + (row / 2 - k) * step)
        for row in range(5)
        for k in range(row + 1)
    ]


@wrong_model("P.1", "Neighbours of different rows: how far are they apart with a gap, in yours?")
def gap_within_rows_alone(apex: Vector, radius: float, gap: float) -> Any:
    """The gap is between balls of a row; the rows lie as they do without one."""
    step = 2 * radius + gap
    return [
        (apex[0] + row * radius * np.sqrt(3), apex[1] + (k - row / 2) * step)
        for row in range(5)
        for k in range(row + 1)
    ]


@wrong_model("P.2", "A stroke just beside the centre and one at the rim: which makes more spin?")
def lever_of_a_radius(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """The stroke acts at the rim, so its lever is the radius."""
    spin = -np.sign(offset) * radius * np.hypot(*impulse) / (0.4 * mass * radius**2)
    return impulse / mass, spin


@wrong_model("P.2", "Does a ball that slides, or is hit at its centre, turn as if it rolled?")
def rolls_at_once(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """A ball that moves rolls: its spin is v / r."""
    return impulse / mass, -np.hypot(*impulse) / mass / radius


@wrong_model("P.2", "Is a billiard ball hollow?")
def a_hollow_ball(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """A ball has the moment of inertia of its surface: 2/3 m r^2."""
    return impulse / mass, -offset * np.hypot(*impulse) / (2 / 3 * mass * radius**2)


@wrong_model("P.2", "About which point does a ball turn that lies free: where the cue hits?")
def turns_about_the_cue(impulse: Vector, offset: float, mass: float, radius: float) -> Any:
    """The ball turns about the line of the stroke: I = 2/5 m r^2 + m offset^2."""
    inertia = 0.4 * mass * radius**2 + mass * offset**2
    return impulse / mass, -offset * np.hypot(*impulse) / inertia


@wrong_model("P.3", "A ball with six neighbours and one with one: which of them sets the limit?")
def by_the_smaller_count(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """A pair's impulse is divided by the count of its less busy ball."""
    touching = _touching(positions, radius)
    return _shared(velocities, touching, restitution, ROUNDS, lambda a, b: 2 * (min(a, b),))


@wrong_model("P.3", "A busy ball and a free one: is the busy one given too much in yours?")
def by_the_mean_count(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """A pair's impulse is divided by the mean of the counts of its balls."""
    touching = _touching(positions, radius)
    return _shared(velocities, touching, restitution, ROUNDS, lambda a, b: 2 * ((a + b) / 2,))


@wrong_model("P.3", "What is the restitution for, if all collisions of yours are elastic?")
def always_elastic(positions: Vector, velocities: Vector, radius: float, restitution: float) -> Any:
    """Billiard balls lose nothing when they collide."""
    return _shared(velocities, _touching(positions, radius), 1.0, ROUNDS, _larger)


@wrong_model("P.3", "Two equal balls meet head on, with e = 1. Which velocities have they then?")
def the_whole_change_for_each(
    positions: Vector, velocities: Vector, radius: float, restitution: float
) -> Any:
    """Each ball of a pair changes by (1 + e) times the approach."""
    touching = _touching(positions, radius)
    return _shared(velocities, touching, restitution, ROUNDS, lambda a, b: (max(a, b) / 2,) * 2)

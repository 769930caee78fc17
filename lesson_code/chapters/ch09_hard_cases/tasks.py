"""Tasks of chapter 09: loads, sweeps, friction that jams, energy from nothing, and the cradle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws, rows_of_balls
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.course.isolation.inside.vectors import vector

# 9.1: a tower


def equal_boxes(stream: Random) -> Iterator[Arguments]:
    """Draw a tower of equal boxes."""
    yield (draws.speed(stream),) * stream.randint(3, 6), 9.81


def unequal_boxes(stream: Random) -> Iterator[Arguments]:
    """Draw towers whose boxes differ, on the earth, on Mars and on the moon."""
    for gravity in (9.81, 3.71, 1.62):
        count = stream.randint(3, 6)
        yield tuple(round(stream.uniform(0.5, 9.0), 2) for _ in range(count)), gravity


def one_box(stream: Random) -> Iterator[Arguments]:
    """Draw a tower of one box."""
    yield (draws.speed(stream),), 9.81


# 9.2: sweeps


def light_loads(stream: Random) -> Iterator[Arguments]:
    """Draw loads of some times the box's mass; in the first a sweep has just begun.

    The last one is as heavy as the box: a sweep leaves one half, which is no more than one half.
    """
    yield _load(stream, 6, 0.1, begun=0.2)
    light = round(stream.uniform(0.5, 3.0), 2)
    yield light, round(light * stream.uniform(3, 9), 2), 0.01
    light = stream.randrange(9, 16) / 8  # no number is rounded
    yield light, light, 0.5


def heavy_loads(stream: Random) -> Iterator[Arguments]:
    """Draw loads of hundreds and thousands of times; a sweep has just begun, or is nearly over."""
    for ratio, begun in ((5e2, 0.2), (5e3, 0.8), (5e4, 0.2)):
        yield _load(stream, ratio, 0.001, begun)


def _load(stream: Random, ratio: float, left: float, begun: float) -> Arguments:
    """Return a load about `ratio` times as heavy; the part `begun` of its last sweep is needed."""
    light = round(stream.uniform(0.5, 3.0), 2)
    heavy = draws.until(
        lambda heavy: abs(-math.log(left) / math.log1p(light / heavy) % 1 - begun) <= 0.1,
        lambda: round(light * ratio * stream.uniform(0.2, 1.8), 2),
    )
    return light, heavy, left


def huge_loads(stream: Random) -> Iterator[Arguments]:
    """Draw loads of a billion times: here a float has few digits left for 1 - m/M."""
    for _ in range(2):
        yield 1.0, draws.until(_loses_digits, lambda: round(stream.uniform(1, 9) * 1e9)), 0.01


def _loses_digits(heavy: float) -> bool:
    """Return whether the logarithms of M/(M + m) and (M + m)/M, m = 1 kg, are clearly off."""
    logs = -math.log(heavy / (heavy + 1.0)), math.log((heavy + 1.0) / heavy)
    return all(abs(log / math.log1p(1.0 / heavy) - 1) > 1e-8 for log in logs)


# 9.3: a tip that slides


def without_a_lever(stream: Random) -> Iterator[Arguments]:
    """Draw impacts right below the centre of mass: knt is 0."""
    for way in (1, -1):
        yield -draws.speed(stream), way * draws.speed(stream), _stiffness(stream), 0.0, _mu(stream)


def lifted_or_pressed(stream: Random) -> Iterator[Arguments]:
    """Draw tips that friction lifts, and tips that it presses down, all of them still sliding.

    The last ones come slowly.
    """
    for way in (1, -1, 1, -1):
        knn, knt = _stiffness(stream), way * round(stream.uniform(0.4, 0.8), 2)
        for slides in (1, -1):
            yield -draws.speed(stream), slides * draws.speed(stream), knn, knt, _mu(stream)
    for way in (1, -1):  # pressed down so hard that they all but jam
        knn, knt = _stiffness(stream), way * round(stream.uniform(1.2, 1.5), 2)
        mu = round(0.8 * knn / abs(knt), 2)
        yield -draws.creep(stream), way * draws.creep(stream), knn, knt, mu


def jammed(stream: Random) -> Iterator[Arguments]:
    """Draw tips that cannot slide on: mu abs(knt) is more than knn."""
    for way in (1, -1):
        knn, knt = _stiffness(stream), way * round(stream.uniform(1.2, 1.5), 2)
        mu = round(1.3 * knn / abs(knt), 2)
        yield -draws.speed(stream), way * draws.speed(stream), knn, knt, mu
        yield -draws.speed(stream), -way * draws.speed(stream), knn, knt, mu


def parting(stream: Random) -> Iterator[Arguments]:
    """Draw tips that leave the floor, one that does not, and one that would jam if it came.

    The last one neither leaves nor comes.
    """
    yield -draws.speed(stream), draws.speed(stream), _stiffness(stream), 0.5, _mu(stream)
    for way, how_fast in ((1, draws.speed), (-1, draws.creep)):
        knt = way * round(stream.uniform(0.4, 0.8), 2)
        yield how_fast(stream), draws.speed(stream), _stiffness(stream), knt, _mu(stream)
    _, *jams = next(jammed(stream))
    yield draws.speed(stream), *jams
    yield 0.0, draws.speed(stream), _stiffness(stream), 0.5, _mu(stream)


def _stiffness(stream: Random) -> float:
    """Return knn, 1/kg."""
    return round(stream.uniform(1.5, 2.5), 2)


def _mu(stream: Random) -> float:
    """Return a friction coefficient with which no tip of the task jams."""
    return round(stream.uniform(0.3, 0.9), 2)


# 9.4: energy


def through_the_centre(stream: Random) -> Iterator[Arguments]:
    """Draw blows whose line goes through the centre of mass."""
    arm = (round(stream.uniform(0.5, 2.0), 2), 0.0)
    yield *_moving_body(stream), arm, (stream.choice((-1, 1)) * draws.speed(stream), 0.0)


def beside_the_centre(stream: Random) -> Iterator[Arguments]:
    """Draw blows beside the centre of mass."""
    for _ in range(3):
        arm = _vector(stream, 0.4, 1.5)
        yield *_moving_body(stream), arm, _vector(stream, 1.0, 5.0)


def at_rest_in_place(stream: Random) -> Iterator[Arguments]:
    """Draw a body that only spins, and one that does not."""
    mass, inertia, velocity, w = _moving_body(stream)
    yield mass, inertia, (0.0, 0.0), w, _vector(stream, 0.4, 1.5), _vector(stream, 1.0, 5.0)
    yield mass, inertia, velocity, 0.0, _vector(stream, 0.4, 1.5), _vector(stream, 1.0, 5.0)


def _moving_body(stream: Random) -> Arguments:
    """Return mass, moment of inertia, velocity and angular velocity."""
    mass, inertia = round(stream.uniform(1.5, 4.0), 2), round(stream.uniform(0.2, 0.9), 2)
    return mass, inertia, _vector(stream, 1.0, 4.0), stream.choice((-1, 1)) * draws.speed(stream)


def _vector(stream: Random, least: float, most: float) -> tuple[float, float]:
    """Return a vector, neither part of which is small."""
    x, y = (stream.choice((-1, 1)) * round(stream.uniform(least, most), 2) for _ in range(2))
    return x, y


# 9.5: one by one


def equal_balls(_stream: Random) -> Iterator[Arguments]:
    """Yield cradles of five equal balls, of which one to four come, and a row with 55 strikes.

    In that each ball comes faster than the next: all velocities change places.
    """
    for moving in range(1, 5):
        yield (1.0,) * 5, (2.0,) * moving + (0.0,) * (5 - moving)
    yield (1.0,) * 11, tuple(float(v) for v in range(11, 0, -1))


def from_the_other_side(stream: Random) -> Iterator[Arguments]:
    """Draw cradles whose balls come from the right, and from both sides."""
    v = draws.speed(stream)
    yield (1.0,) * 5, (0.0, 0.0, 0.0, -v, -v)
    yield (1.0,) * 5, (v, 0.0, 0.0, 0.0, -2 * v)


def unequal_balls(stream: Random) -> Iterator[Arguments]:
    """Draw rows of balls of different masses, in which the order of the strikes counts.

    Each shows one other order; one tells two others apart. In the last two approach slowly, and
    then very slowly.
    """
    for other in rows_of_balls.ORDERS:
        if other is not rows_of_balls.fastest:
            yield rows_of_balls.row_in_which_order_counts(stream, 1.0, rows_of_balls.fastest, other)
    leftmost, passes = rows_of_balls.leftmost, rows_of_balls.to_the_right
    yield rows_of_balls.row_in_which_order_counts(stream, 1.0, leftmost, passes)
    yield _row_for_the_hardest(stream)
    v = draws.speed(stream)
    yield draws.unequal_masses(stream), (v + draws.creep(stream), v)
    yield draws.unequal_masses(stream), (v + 1e-6, v)


def _row_for_the_hardest(stream: Random) -> Arguments:
    """Return a row that ends otherwise if the strike with the largest impulse comes first."""
    fastest = rows_of_balls.fastest
    while True:
        m, v = rows_of_balls.row_in_which_order_counts(stream, 1.0, fastest, rows_of_balls.leftmost)

        def hardest(approaches: list[float], m: Sequence[float] = m) -> Sequence[int]:
            pairs = rows_of_balls.ranked(approaches)
            return sorted(pairs, key=lambda k: approaches[k] / (1 / m[k] + 1 / m[k + 1]))[-1:]

        one, two = (rows_of_balls.after_strikes(m, v, 1.0, order) for order in (fastest, hardest))
        if one and two and math.dist(one, two) > rows_of_balls.CLEAR:
            return m, v


def parting_balls(stream: Random) -> Iterator[Arguments]:
    """Draw a row in which nothing approaches."""
    v = draws.speed(stream)
    yield (1.0, 2.0, 3.0), (-v, 0.0, v)


# What is expected


def _tower_forces(masses: Any, gravity: float) -> Any:
    """Return the force under each box, from the lowest up."""
    return np.cumsum(np.asarray(masses, dtype=float)[::-1])[::-1] * gravity


def _sweeps_needed(light: float, heavy: float, left: float) -> int:
    """Return how many sweeps leave no more than a given part of the approach."""
    return math.ceil(-math.log(left) / math.log1p(light / heavy))


def _sliding_impulse(vn: float, vt: float, knn: float, knt: float, friction: float) -> float | None:
    """Return the normal impulse with which a sliding tip stops approaching, or None."""
    if vn >= 0.0:
        return 0.0
    yields = knn - friction * math.copysign(1.0, vt) * knt
    return -vn / yields if yields > 0.0 else None


def _energy_ratio(
    mass: float, inertia: float, velocity: Any, w: float, arm: Any, impulse: Any
) -> float:
    """Return the kinetic energy after a blow over that before it."""
    v = np.asarray(velocity, dtype=float)
    (rx, ry), (jx, jy) = arm, impulse
    after, w_after = v + np.asarray(impulse) / mass, w + (rx * jy - ry * jx) / inertia
    before = mass * (v @ v) + inertia * w**2
    return float((mass * (after @ after) + inertia * w_after**2) / before)


def _one_by_one(masses: Any, velocities: Any) -> Any:
    """Return the velocities when elastic balls in a row have struck each other one by one."""
    m, v = np.asarray(masses, dtype=float), np.array(velocities, dtype=float)
    while True:
        approach = v[:-1] - v[1:]
        if approach.max() <= QUIET:
            return v
        k = int(np.argmax(approach))
        centre = (m[k] * v[k] + m[k + 1] * v[k + 1]) / (m[k] + m[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]


QUIET = 1e-9
"""m/s: slower is no approach."""


# Why


def sum_of_weights(arguments: Arguments, _answer: Any) -> str:
    """Say what the whole tower weighs."""
    masses, gravity = arguments
    return f"The whole tower weighs {written(sum(masses) * gravity)} N. What carries that?"


def left_after(arguments: Arguments, answer: Any) -> str:
    """Say what is left of the approach after the sweeps that were returned."""
    light, heavy, left = arguments
    if not isinstance(answer, int | float) or not 0 <= answer < math.inf:
        return ""
    rest = math.exp(-answer * math.log1p(light / heavy))
    return f"After these sweeps {written(rest)} of the approach is left; wanted is {left}."


def velocity_of_the_tip(arguments: Arguments, answer: Any) -> str:
    """Say how fast the tip still approaches after the impulse that was returned."""
    vn, vt, knn, knt, friction = arguments
    if not isinstance(answer, int | float):
        return ""
    after = vn + (knn - friction * math.copysign(1.0, vt) * knt) * answer
    return f"After your impulse the tip has vn = {written(after)} m/s."


def momentum_and_energy(arguments: Arguments, answer: Any) -> str:
    """Say what becomes of momentum and energy."""
    if not isinstance(answer, list | tuple) or len(answer) != len(arguments[0]):
        return ""
    masses, velocities, v = map(vector, (*arguments, answer))
    momenta = [written(float(masses @ u)) for u in (velocities, v)]
    energies = [written(float(masses @ u**2) / 2) for u in (velocities, v)]
    return (
        f"Momentum {momenta[0]} kg m/s before and {momenta[1]} after; "
        f"energy {energies[0]} J and {energies[1]} J."
    )


TASKS = (
    Task(
        id="9.1",
        function="tower_forces",
        section=2,
        objective="The forces under the boxes of a tower at rest.",
        expected=_tower_forces,
        criteria=(
            Criterion("equal boxes", equal_boxes),
            Criterion("different boxes", unequal_boxes),
            Criterion("one box", one_box),
        ),
        explain=sum_of_weights,
    ),
    Task(
        id="9.2",
        function="sweeps_needed",
        section=1,
        objective="How many sweeps a heavy load on a light box needs.",
        expected=_sweeps_needed,
        criteria=(
            Criterion("a load of some boxes", light_loads),
            Criterion("a load of hundreds and thousands", heavy_loads, points=2),
            Criterion("a load of a billion", huge_loads),
        ),
        explain=left_after,
    ),
    Task(
        id="9.3",
        function="sliding_impulse",
        section=4,
        objective="The impulse on a tip that slides, and the case in which there is none.",
        expected=_sliding_impulse,
        criteria=(
            Criterion("right below the centre", without_a_lever),
            Criterion("friction lifts or presses", lifted_or_pressed, points=2),
            Criterion("a tip that jams", jammed),
            Criterion("whether a tip parts", parting),
        ),
        explain=velocity_of_the_tip,
    ),
    Task(
        id="9.4",
        function="energy_ratio",
        section=4,
        objective="Whether a blow has made energy.",
        expected=_energy_ratio,
        criteria=(
            Criterion("through the centre of mass", through_the_centre),
            Criterion("beside the centre of mass", beside_the_centre, points=2),
            Criterion("a body that only spins, or only flies", at_rest_in_place),
        ),
    ),
    Task(
        id="9.5",
        function="one_by_one",
        section=5,
        objective="A row of elastic balls that strike one after the other.",
        expected=_one_by_one,
        criteria=(
            Criterion("equal balls from the left", equal_balls),
            Criterion("from the right, and from both sides", from_the_other_side),
            Criterion("balls of different masses", unequal_balls),
            Criterion("nothing approaches", parting_balls),
        ),
        explain=momentum_and_energy,
    ),
)

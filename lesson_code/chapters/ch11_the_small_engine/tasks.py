"""Tasks of chapter 11: a broad phase, a hit, a whole step; then callbacks, an effect, a sound."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from random import Random
from typing import Any, TypeAlias, TypeVar

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.draws import Vector
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.course.isolation.inside.vectors import vector
from lesson_code.formulas.arithmetic import perpendicular

Box: TypeAlias = tuple[float, float, float, float]
Row = TypeVar("Row")

# 11.1: pairs of boxes, each left, right, low, high


def apart_in_one_direction(stream: Random) -> Iterator[Arguments]:
    """Draw a box with one that it overlaps, one beside it, and one above it.

    From left to right, the one above stands before the box, or between it and the one it overlaps,
    and these two have other places than in the table. At first, no centre of these is inside the
    other one.
    """
    for is_turned, left, aside in ((True, -1.0, 1.2), (False, 0.1, 0.5)):
        box = _box(stream, 2.0, 3.0)
        near = _moved(box, aside + stream.uniform(0.0, 0.3), stream.uniform(0.5, 1.4))
        beside = _moved(box, stream.uniform(3.5, 4.0), stream.uniform(-1.0, -0.5))
        above = _moved(box, left + stream.uniform(0.0, 0.3), stream.uniform(5.0, 6.0))
        yield (_unlike_sorted(stream, [box, near, beside, above], is_turned),)


def crossed_and_nested(stream: Random) -> Iterator[Arguments]:
    """Draw boxes that cross with no corner in each other, one inside another, and one far away.

    That one is the last of the table; from left to right, it is the last one, or the first.
    """
    for is_turned, x in ((True, 20.0), (False, -20.0)):
        wide, high = _box(stream, 6.0, 1.0), _box(stream, 1.0, 6.0)
        high = _at_the_middle_of(high, wide)
        inside = _at_the_middle_of(_box(stream, 0.2, 0.3), wide)
        far = _moved(wide, x, 20.0)
        yield ((*_mixed(stream, [wide, high, inside], is_turned), far),)


def many_boxes(stream: Random) -> Iterator[Arguments]:
    """Draw boxes of all sizes all over the place, and two that cross."""
    wide, high = _box(stream, 6.0, 1.0), _box(stream, 1.0, 6.0)
    boxes = [wide, _at_the_middle_of(high, wide)]
    for _ in range(10):
        box = _box(stream, stream.uniform(1, 4), stream.uniform(1, 4))
        boxes.append(_moved(box, stream.uniform(0, 8), stream.uniform(0, 8)))
    yield (tuple(boxes),)


def many_and_touching_boxes(stream: Random) -> Iterator[Arguments]:
    """Draw boxes of all sizes all over the place, and some that share a side or a corner."""
    yield from many_boxes(stream)
    yield from boxes_that_touch(stream)


def boxes_that_touch(stream: Random) -> Iterator[Arguments]:
    """Draw boxes that share a side or a corner alone, and one that does not quite reach.

    They come in an order and its reverse, so that each pair is looked at from either box.
    """
    left, low = stream.randint(-4, 4) / 2, stream.randint(-4, 4) / 2
    wide, high = stream.randint(2, 6) / 2, stream.randint(2, 6) / 2
    box = left, left + wide, low, low + high
    beside = left + wide, left + wide + 1.5, low + 0.25, low + high
    above = left + 0.25, left + wide - 0.25, low + high, low + high + 2.5
    corner = left - 2.0, left, low - 1.5, low
    near = left - 3.0, left - 0.125, low + 0.5, low + high
    boxes = (box, beside, *_shuffled(stream, [above, corner, near]))
    yield (boxes,)
    yield (boxes[::-1],)


def _unlike_sorted(stream: Random, boxes: list[Box], is_turned: bool) -> tuple[Box, ...]:
    """Return boxes in any order in which the first two have other places than when sorted."""

    def places(order: Sequence[Box]) -> set[int]:
        return {order.index(box) for box in boxes[:2]}

    return draws.until(
        lambda mixed: places(mixed) != places(sorted(mixed)),
        lambda: _mixed(stream, boxes, is_turned),
    )


def _mixed(stream: Random, boxes: list[Box], is_turned: bool) -> tuple[Box, ...]:
    """Return boxes in any order; if turned, one in which the second stands before the first.

    The first lies farther left: with this no luck makes the order of a sweep that of the table.
    """
    mixed = _shuffled(stream, boxes)
    is_sorted = mixed.index(boxes[0]) < mixed.index(boxes[1])
    return mixed[::-1] if is_turned and is_sorted else mixed


def _box(stream: Random, width: float, height: float) -> Box:
    """Return a box of about that size near the origin."""
    left, low = stream.uniform(-1, 1), stream.uniform(-1, 1)
    return _rounded(left, left + width, low, low + height)


def _moved(box: Box, x: float, y: float) -> Box:
    """Return a box moved by x and y."""
    left, right, low, high = box
    return _rounded(left + x, right + x, low + y, high + y)


def _at_the_middle_of(box: Box, other: Box) -> Box:
    """Return a box moved to the middle of another one."""
    (left, right, low, high), (other_left, other_right, other_low, other_high) = box, other
    x = (other_left + other_right - left - right) / 2
    return _moved(box, x, (other_low + other_high - low - high) / 2)


def _rounded(*sides: float) -> Box:
    """Return a box with three decimals."""
    left, right, low, high = (round(side, 3) for side in sides)
    return left, right, low, high


# 11.2: a hit. A body is mass, inertia, vx, vy and w.


def through_the_centres(stream: Random) -> Iterator[Arguments]:
    """Draw smooth discs that spin: the impulse goes through both centres."""
    for _ in range(2):
        n = draws.oblique_normal(stream)
        r, s = draws.unequal_radii(stream)
        arms = (r * n[0], r * n[1]), (-s * n[0], -s * n[1])
        yield *_bodies(stream, n, arms, -draws.speed(stream)), n, draws.restitution(stream), 0.0


def beside_the_centres(stream: Random) -> Iterator[Arguments]:
    """Draw smooth bodies that are hit beside their centres, the last time by a wall that moves."""
    for is_wall in (False, False, True):
        n, arms = draws.oblique_normal(stream), (draws.lever(stream), draws.lever(stream))
        (m, i, *motion), *others = _bodies(stream, n, arms, -draws.speed(stream))
        first = (math.inf, math.inf) if is_wall else (m, i)
        yield (*first, *motion), *others, n, draws.restitution(stream), 0.0


def rough_bodies(stream: Random) -> Iterator[Arguments]:
    """Draw rough bodies: some slide through the impact, one way and the other, and some grip."""
    for low, high, way in ((0.05, 0.1, 1), (0.1, 0.2, -1)):
        yield draws.until(
            partial(_slides_on, way=way), partial(_pair, stream, -1, draws.speed, low, high)
        )
    for _ in range(2):
        yield _pair(stream, -1, draws.speed, 5.0, 9.0)


CLEAR = 0.1
"""m/s: what slides on slides faster."""


def _slides_on(given: Arguments, way: int) -> bool:
    """Return whether two bodies clearly slide one way at their contact after a hit."""
    _, arm_a, _, arm_b, n, _, _ = given
    v_a, w_a, v_b, w_b = _hit(*given)
    change = v_b - v_a + w_b * perpendicular(arm_b) - w_a * perpendicular(arm_a)
    return bool(way * float(change @ perpendicular(n)) > CLEAR)


def parting_bodies(stream: Random) -> Iterator[Arguments]:
    """Draw bodies that part at the contact already, fast and slowly, and some that come slowly.

    With these, the contact slides one way, and the centres slide the other way.
    """
    for how_fast in (draws.speed, draws.creep):
        yield _pair(stream, 1, how_fast, 0.1, 0.5)
    yield draws.until(
        lambda drawn: _centres_slide_the_other_way(*drawn),
        partial(_pair, stream, -1, draws.creep, 0.1, 0.5),
    )


def _pair(
    stream: Random, way: int, how_fast: draws.Speed, smoothest: float, roughest: float
) -> Arguments:
    """Return two bodies that part along an oblique normal, or meet where `way` is -1, and slide."""
    n, arms = draws.oblique_normal(stream), (draws.lever(stream), draws.lever(stream))
    mu = round(stream.uniform(smoothest, roughest), 2)
    bodies = _bodies(stream, n, arms, way * how_fast(stream))
    return *bodies, n, draws.restitution(stream), mu


def _centres_slide_the_other_way(
    a: Any, arm_a: Vector, b: Any, arm_b: Vector, n: Vector, *_: float
) -> bool:
    """Return whether two centres slide past each other against the way their contact slides."""
    tangent = perpendicular(vector(n))
    centres = vector(b[2:4]) - vector(a[2:4])
    rims = b[4] * perpendicular(vector(arm_b)) - a[4] * perpendicular(vector(arm_a))
    return bool((centres @ tangent) * ((centres + rims) @ tangent) < 0)


def _bodies(stream: Random, n: Vector, arms: tuple[Vector, Vector], vn: float) -> Arguments:
    """Return two bodies and their arms; at the contact they part at vn along n, and slide."""
    masses = draws.unequal_masses(stream)
    inertias = [round(m * stream.uniform(0.3, 0.8), 2) for m in masses]
    spins = [draws.angular_velocity(stream) for _ in masses]
    first = (draws.speed(stream), -draws.speed(stream))
    vt = stream.choice((-1, 1)) * draws.speed(stream)
    second = tuple(
        round(value, 4)
        for value in (
            first[0] - spins[0] * arms[0][1] + spins[1] * arms[1][1] + vn * n[0] - vt * n[1],
            first[1] + spins[0] * arms[0][0] - spins[1] * arms[1][0] + vn * n[1] + vt * n[0],
        )
    )
    a = (masses[0], inertias[0], *first, spins[0])
    return a, arms[0], (masses[1], inertias[1], *second, spins[1]), arms[1]


# 11.3: a step of smooth discs in a room

ROOM = (12.0, 9.0)
"""m."""


def free_discs(stream: Random) -> Iterator[Arguments]:
    """Draw discs that meet nothing, with gravity down and aside."""
    for gravity in ((0.0, -9.81), (round(stream.uniform(1, 3), 2), 0.0)):
        states = [((x, 4.5), _velocity(stream)) for x in (3.0, 6.0, 9.0)]
        yield _world(stream, states, gravity)


def discs_at_walls(stream: Random) -> Iterator[Arguments]:
    """Draw discs beyond a wall, three on their way out, one on its way in already, and one free.

    In the last scene discs are in corners, beyond two walls each: one is on its way out of both,
    and the others out of one of the two.
    """
    way = draws.speed(stream)
    states = [
        ((0.6, 3.0), (-way, 1.0)),
        ((11.4, 6.0), (way, -1.0)),
        ((4.0, 8.5), (1.0, way)),
        ((8.0, 0.3), (-1.0, way)),
        ((6.0, 4.5), (1.0, -way)),
    ]
    yield _world(stream, states, (0.0, 0.0))
    yield _world(stream, states, (0.0, -9.81))
    corners = [((0.5, 0.6), (-way, -1.5)), ((11.5, 8.4), (way, -1.0)), ((0.6, 8.5), (1.5, way))]
    yield _world(stream, corners, (0.0, 0.0))


def discs_that_meet(stream: Random) -> Iterator[Arguments]:
    """Draw two discs that overlap and approach, and two that overlap and part.

    In the last scene no two of them are neighbours in the table, and the first one has two
    partners: pushed away by one, it is deeper in the other, which is the last of the table.
    """
    for x, y in ((0.8, 0.6), (0.6, -0.8)):
        way = draws.speed(stream)
        states = [
            ((3.0, 4.5), (way, 0.5)),
            ((3.0 + 1.2 * x, 4.5 + 1.2 * y), (-1.0, 0.2)),
            ((8.0, 4.5), (-way, 0.3)),
            ((8.0 + 1.2 * x, 4.5 + 1.2 * y), (1.0, -0.5)),
        ]
        yield _world(stream, states, (0.0, 0.0))
    way = draws.speed(stream)
    states = [
        ((4.0, 4.5), (0.3, 0.2)),
        ((8.0, 3.0), (way, 0.5)),
        ((2.8, 4.4), (way, -0.4)),
        ((8.7, 4.0), (0.4, -way)),
        ((4.7, 5.4), (-way, -0.5)),
    ]
    yield _world(stream, states, (0.0, 0.0))


def all_at_once(stream: Random) -> Iterator[Arguments]:
    """Draw discs that meet, one at a wall, and one alone, with gravity; and a row of discs.

    In the row each overlaps the next, but for the last two: these do once others are moved apart.
    Beside it a disc is hit out of the room.
    """
    way = draws.speed(stream)
    states = [
        ((0.5, 5.0), (-way, 0.5)),
        ((5.0, 4.0), (way, way)),
        ((5.9, 4.7), (-way, -0.3)),
        ((9.5, 2.0), (0.4, way)),
    ]
    yield _world(stream, states, (0.0, -9.81))
    states = [
        ((3.0, 4.0), (way, 0.5)),
        ((4.2, 4.3), (0.2, 0.3)),
        ((5.0, 4.8), (-0.5, 0.1)),
        ((6.4, 5.6), (-0.5, 0.1)),
        ((10.2, 3.0), (way, 0.3)),
        ((11.4, 3.2), (-0.5, 0.1)),
    ]
    yield _world(stream, states, (0.0, 0.0))


def _velocity(stream: Random) -> Vector:
    """Return a velocity, m/s."""
    return stream.choice((-1, 1)) * draws.speed(stream), draws.speed(stream)


def _world(stream: Random, states: list[tuple[Vector, Vector]], gravity: Vector) -> Arguments:
    """Return the arguments of a step: different masses, radii between 0.7 and 0.8 m."""
    positions, velocities = zip(*states, strict=True)
    masses = tuple(round(1.3**n * stream.uniform(0.8, 1.0), 2) for n in range(len(states)))
    radii = tuple(round(stream.uniform(0.7, 0.8), 2) for _ in states)
    dt = round(stream.uniform(0.01, 0.02), 3)
    return positions, velocities, masses, radii, draws.restitution(stream), gravity, ROOM, dt


# 11.4: who touches whom, before and now

Pairs: TypeAlias = tuple[tuple[int, int], ...]


def pairs_that_begin(stream: Random) -> Iterator[Arguments]:
    """Draw touches that go on, and some that begin, also of bodies that touched others before.

    At last of bodies whose numbers have two digits.
    """
    for _ in range(2):
        go_on, begin = _chain(stream, 3), _chain(stream, 4, step=2)
        begin = _with_one_among(go_on, begin)
        yield _shuffled(stream, go_on), _shuffled(stream, (*go_on, *begin))
    i, j = stream.randint(0, 3), stream.randint(5, 9)
    yield ((i + 1, j),), ((i + 1, j), (i, j + 10))


def pairs_that_part(stream: Random) -> Iterator[Arguments]:
    """Draw touches that go on, some that end, and one that begins."""
    for _ in range(2):
        go_on, end = _chain(stream, 3), _chain(stream, 3, step=2)
        end = _with_one_among(go_on, end)
        begin = ((20, 21),)
        yield _shuffled(stream, (*go_on, *end)), _shuffled(stream, (*go_on, *begin))


def first_and_last_touch(stream: Random) -> Iterator[Arguments]:
    """Draw a step before which nothing touched, one after which nothing does, and one without."""
    touching = _shuffled(stream, _chain(stream, 3))
    yield (), touching
    yield touching, ()
    yield touching, touching


def _chain(stream: Random, links: int, step: int = 1) -> Pairs:
    """Return pairs of bodies `step` apart, each of which touches the next."""
    first = stream.randint(0, 3)
    return tuple((first + k, first + k + step) for k in range(links))


def _with_one_among(chain: Pairs, pairs: Pairs) -> Pairs:
    """Return pairs of which one at least is of two bodies of a chain that do not touch there.

    In another one the last body of the chain, which there is always the second, is the first.
    """
    last = chain[-1][1]
    return tuple(dict.fromkeys([(chain[0][0], chain[1][1]), (last, last + 5), *pairs]))


def _shuffled(stream: Random, rows: Sequence[Row]) -> tuple[Row, ...]:
    """Return pairs or boxes in another order."""
    order = list(rows)
    stream.shuffle(order)
    return tuple(order)


# 11.5: brightness of bodies that are hit


def lit_bodies(stream: Random) -> Iterator[Arguments]:
    """Draw bodies of which some are hit, the first of them a dark one."""
    for _ in range(2):
        brightness, (struck, *times) = list(_lit(stream, 5, hit=2)), _glow(stream)
        brightness[struck.index(1)] = round(stream.uniform(0.1, 0.4), 2)
        yield tuple(brightness), struck, *times


def fading_bodies(stream: Random) -> Iterator[Arguments]:
    """Draw bodies of which none is hit, with steps shorter and longer than the half-life."""
    for part in (0.1, 0.7, 1.6):
        half_life = round(stream.uniform(0.1, 0.4), 2)
        yield _lit(stream, 4, hit=0), (0, 0, 0, 0), round(part * half_life, 3), half_life


def _lit(stream: Random, count: int, hit: int) -> tuple[float, ...]:
    """Return how bright bodies are; at least `hit` are neither dark nor full."""
    return tuple(round(stream.uniform(0.2, 0.9), 2) for _ in range(max(count, hit)))


def _glow(stream: Random) -> Arguments:
    """Return who is hit, and the lengths of the step and of the half-life."""
    struck = [1, 1, 0, 0, 0]
    stream.shuffle(struck)
    return tuple(struck), round(stream.uniform(0.01, 0.05), 3), round(stream.uniform(0.1, 0.4), 2)


# 11.6: samples of a sound


def low_tones(stream: Random) -> Iterator[Arguments]:
    """Draw tones well below half of the rate, loud and soft."""
    for loudness in (round(stream.uniform(0.2, 0.5), 2), round(stream.uniform(0.6, 0.9), 2)):
        yield loudness, _frequency(stream, 200, 900), *_ringing(stream), 12


def tones_that_die_away(stream: Random) -> Iterator[Arguments]:
    """Draw sounds that last for several half-lives."""
    for _ in range(2):
        tone = round(stream.uniform(0.3, 0.9), 2), _frequency(stream, 30, 60)
        yield *tone, round(stream.uniform(0.004, 0.008), 4), 1000, 30


def tones_too_high(stream: Random) -> Iterator[Arguments]:
    """Draw a tone above half of the rate, and one just below it."""
    rate = 1000 * stream.randint(4, 8)
    for part in (0.6, 1.3, 0.45):
        yield 0.5, round(part * rate), round(stream.uniform(0.02, 0.05), 3), rate, 9


def _frequency(stream: Random, low: int, high: int) -> float:
    """Return a frequency, 1/s, that is no whole number: of such the sine is 0 at each second."""
    return stream.randint(low, high) + stream.choice((0.2, 0.3, 0.7, 0.8))


def _ringing(stream: Random) -> Arguments:
    """Return half-life and rate."""
    return round(stream.uniform(0.02, 0.05), 3), 1000 * stream.randint(8, 12)


# What is expected


def _near_pairs(boxes: Any) -> list[tuple[int, int]]:
    """Return the pairs of boxes that share a point."""
    return [
        (i, j)
        for j in range(len(boxes))
        for i in range(j)
        if boxes[i][0] <= boxes[j][1]
        and boxes[j][0] <= boxes[i][1]
        and boxes[i][2] <= boxes[j][3]
        and boxes[j][2] <= boxes[i][3]
    ]


def _hit(
    a: Any, arm_a: Any, b: Any, arm_b: Any, normal: Any, restitution: float, friction: float
) -> tuple[Any, float, Any, float]:
    """Return the velocities and spins of two bodies after they have hit each other."""
    bodies = [[1 / body[0], 1 / body[1], np.array(body[2:4]), body[4]] for body in (a, b)]
    arms = np.array(arm_a), np.array(arm_b)
    n = np.array(normal)
    jn = 0.0
    for along in (n, np.array([-n[1], n[0]])):
        speeds, yields = [], 0.0
        for (inv_m, inv_i, v, w), (x, y) in zip(bodies, arms, strict=True):
            speeds.append((v + w * np.array([-y, x])) @ along)
            yields += inv_m + inv_i * (x * along[1] - y * along[0]) ** 2
        change = speeds[1] - speeds[0]
        if along is n:
            j = jn = max(-(1 + restitution) * change / yields, 0.0)
        else:
            j = max(-friction * jn, min(-change / yields, friction * jn))
        for body, (x, y), side in zip(bodies, arms, (-1, 1), strict=True):
            body[2] = body[2] + side * j * body[0] * along
            body[3] += side * j * body[1] * (x * along[1] - y * along[0])
    return bodies[0][2], bodies[0][3], bodies[1][2], bodies[1][3]


def _step_discs(
    positions: Any,
    velocities: Any,
    masses: Any,
    radii: Any,
    restitution: float,
    gravity: Any,
    room: Any,
    dt: float,
) -> tuple[Any, Any]:
    """Return the positions and velocities of smooth discs in a room after a step."""
    p = np.array(positions, dtype=float) + np.array(velocities) * dt
    v = np.array(velocities, dtype=float) + np.array(gravity) * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth > 0:
                n, m = way / np.hypot(*way), 1 / (1 / masses[i] + 1 / masses[j])
                impulse = max(-(1 + restitution) * m * ((v[j] - v[i]) @ n), 0.0) * n
                v[i], v[j] = v[i] - impulse / masses[i], v[j] + impulse / masses[j]
                shift = depth * m * n
                p[i], p[j] = p[i] - shift / masses[i], p[j] + shift / masses[j]
    for disc, radius in enumerate(radii):
        for axis in (0, 1):
            low, high = radius, room[axis] - radius
            outward = -1 if p[disc, axis] < low else 1 if p[disc, axis] > high else 0
            if outward:
                p[disc, axis] = low if outward < 0 else high
                if v[disc, axis] * outward > 0:
                    v[disc, axis] *= -restitution
    return p, v


def _touch_changes(before: Any, now: Any) -> tuple[list[Any], list[Any]]:
    """Return the pairs that begin to touch, and those that part."""
    earlier, later = ([[int(i), int(j)] for i, j in pairs] for pairs in (before, now))
    begun = [pair for pair in later if pair not in earlier]
    return begun, [pair for pair in earlier if pair not in later]


def _glow_after(brightness: Any, hit: Any, dt: float, half_life: float) -> list[float]:
    """Return how bright the bodies are after a step."""
    left = math.exp2(-dt / half_life)
    return [1.0 if struck else left * b for b, struck in zip(brightness, hit, strict=True)]


def _knock(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> list[float]:
    """Return the samples of the sound of an impact."""
    if 2 * frequency >= rate:
        return [0.0] * count
    turn, left = 2 * math.pi * frequency / rate, math.exp2(-1 / (rate * half_life))
    return [loudness * left**k * math.sin(turn * k) for k in range(count)]


# Parts of an answer, and reasons


def _both_in_order(lists: Any) -> list[list[list[int]]]:
    """Return two lists of pairs, each sorted: any order is right."""
    return [sorted([int(i), int(j)] for i, j in pairs) for pairs in lists]


def _in_order(pairs: Any) -> list[list[Any]]:
    """Return pairs sorted: any order is right."""
    return sorted(list(pair) for pair in pairs)


def momentum_of_both(arguments: Arguments, answer: Any) -> str:
    """Say what becomes of the momentum."""
    a, _, b, *_ = arguments
    v_a, _, v_b, _ = answer
    if math.inf in (a[0], b[0]):
        return "A wall takes up any momentum, and keeps its velocity."
    before = vector(a[2:4]) * a[0] + vector(b[2:4]) * b[0]
    after = vector(v_a) * a[0] + vector(v_b) * b[0]
    return f"Momentum {written(list(before))} kg m/s before and {written(list(after))} after."


TASKS = (
    Task(
        id="11.1",
        function="near_pairs",
        section=3,
        objective="A broad phase: the pairs whose boxes share a point.",
        expected=_near_pairs,
        any_order=0,
        criteria=(
            Criterion("apart in one direction", apart_in_one_direction, part=_in_order),
            Criterion("crossed, and one inside another", crossed_and_nested, part=_in_order),
            Criterion("many boxes, and touching ones", many_and_touching_boxes, part=_in_order),
        ),
    ),
    Task(
        id="11.2",
        function="hit",
        section=4,
        objective="A hit of any two bodies, with spin and friction.",
        expected=_hit,
        criteria=(
            Criterion("through the centres", through_the_centres),
            Criterion("beside the centres", beside_the_centres),
            Criterion("rough bodies", rough_bodies, points=2),
            Criterion("whether bodies part", parting_bodies),
        ),
        explain=momentum_of_both,
    ),
    Task(
        id="11.3",
        function="step_discs",
        section=2,
        objective="A whole step: move, pairs, walls.",
        expected=_step_discs,
        criteria=(
            Criterion("free discs", free_discs),
            Criterion("discs at walls", discs_at_walls),
            Criterion("discs that meet", discs_that_meet),
            Criterion("all at once", all_at_once),
        ),
    ),
    Task(
        id="11.4",
        function="touch_changes",
        section=8,
        objective="Callbacks: which pairs have begun to touch, and which have parted.",
        expected=_touch_changes,
        any_order=1,
        criteria=(
            Criterion("pairs that begin", pairs_that_begin, part=_both_in_order),
            Criterion("pairs that part", pairs_that_part, part=_both_in_order),
            Criterion("the first and the last touch", first_and_last_touch, part=_both_in_order),
        ),
    ),
    Task(
        id="11.5",
        function="glow",
        section=8,
        objective="An effect: what is hit lights up, and fades at any length of the steps alike.",
        expected=_glow_after,
        criteria=(
            Criterion("bodies that are hit", lit_bodies),
            Criterion("bodies that fade", fading_bodies, points=2),
        ),
    ),
    Task(
        id="11.6",
        function="knock",
        section=8,
        objective="A sound: the samples of an impact that rings and dies away.",
        expected=_knock,
        criteria=(
            Criterion("the tone", low_tones, points=2),
            Criterion("how it dies away", tones_that_die_away),
            Criterion("a tone too high for the rate", tones_too_high),
        ),
    ),
)

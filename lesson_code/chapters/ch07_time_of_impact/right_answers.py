"""Unusual right answers to chapter 07: times of impact and events."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any
Time: TypeAlias = Any


@alternative("7.1")
def ray_against_a_circle(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """Circle 1 shrinks to a point, circle 2 grows: a ray, its foot, and half a chord back."""
    import numpy as np

    way, speed, reach = p2 - p1, np.hypot(*(v1 - v2)), r1 + r2
    if way @ (v1 - v2) <= 0:
        return None
    if way @ way <= reach**2:
        return 0.0
    along = (v1 - v2) / speed
    foot, aside = way @ along, way[0] * along[1] - way[1] * along[0]
    if abs(aside) > reach:
        return None
    t = (foot - np.sqrt((reach - aside) * (reach + aside))) / speed
    return t if t <= dt else None


@alternative("7.1")
def with_complex_numbers(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """Turned so that the relative velocity lies along x, it is a question of Pythagoras."""
    d, v = complex(*p2) - complex(*p1), complex(*v1) - complex(*v2)
    if not v:
        return None
    z = d * v.conjugate() / abs(v)
    if z.real <= 0 or abs(z.imag) > r1 + r2:
        return None
    t = (z.real - ((r1 + r2) ** 2 - z.imag**2) ** 0.5) / abs(v)
    return None if t > dt else max(0, t)


@alternative("7.1")
def bisected(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """Up to the nearest approach the distance only falls: halve that time sixty times."""
    from math import dist

    d, v = p2 - p1, v2 - v1
    if d @ v >= 0:
        return None
    early, late = 0.0, -(d @ v) / (v @ v)
    if dist(p1 + v1 * late, p2 + v2 * late) > r1 + r2:
        return None
    for _ in range(60):
        middle = (early + late) / 2
        if dist(p1 + v1 * middle, p2 + v2 * middle) > r1 + r2:
            early = middle
        else:
            late = middle
    return None if late > dt else late


@alternative("7.1")
def roots_of_a_polynomial(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """NumPy finds the roots; the smaller one counts, and 0 where it is in the past."""
    import numpy as np

    d, v = p2 - p1, v2 - v1
    if np.dot(d, v) >= 0:
        return None
    roots = np.roots([v @ v, 2 * d @ v, d @ d - (r1 + r2) ** 2])
    if np.iscomplex(roots).any():
        return None
    t = max(min(roots.real), 0.0)
    return t if t <= dt else None


@alternative("7.1")
def with_the_quadratic_formula(
    p1: Vector, v1: Vector, r1: float, p2: Vector, v2: Vector, r2: float, dt: float
) -> Time:
    """The smaller root, written so that nothing is subtracted from its like."""
    from math import sqrt

    d, v = p2 - p1, v2 - v1
    a, b, c = v @ v, d @ v, d @ d - (r1 + r2) ** 2
    if b >= 0 or b * b - a * c < 0:
        return None
    t = max(c, 0.0) / (-b + sqrt(b * b - a * c))
    return t if t <= dt else None


@alternative("7.2")
def by_the_mean_velocity(height: float, velocity: float, gravity: float) -> Time:
    """The way down over the mean of two velocities; what goes up is first back where it was."""
    from math import hypot, sqrt

    if velocity > 0:
        back = 2 * velocity / gravity if gravity else None
        if back is None or height == 0:
            return back
        return back + 2 * height / (hypot(velocity, sqrt(2 * gravity * height)) + velocity)
    mean = (hypot(velocity, sqrt(2 * gravity * height)) - velocity) / 2
    return height / mean if mean else None


@alternative("7.2")
def with_fifty_digits(height: float, velocity: float, gravity: float) -> Time:
    """The formula from school will do if there are digits enough."""
    from decimal import Decimal, localcontext

    with localcontext() as context:
        context.prec = 50
        h, v, g = Decimal(height), Decimal(velocity), Decimal(gravity)
        if g == 0:
            return -h / v if v < 0 else None
        return (v + (v * v + 2 * g * h).sqrt()) / g


@alternative("7.2")
def newtons_method(height: float, velocity: float, gravity: float) -> Time:
    """From a time that is too late, tangents lead down to the root and never past it."""
    if gravity == 0:
        return None if velocity >= 0 else -height / velocity
    t = 2 * max(velocity, 0.0) / gravity + (2 * height / gravity) ** 0.5
    for _ in range(80):
        above, rising = height + velocity * t - gravity * t * t / 2, velocity - gravity * t
        t = t - above / rising if rising else t
    return t


@alternative("7.3")
def from_wall_to_wall(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> tuple[Vector, Vector]:
    """From one impact to the next, until the step is over."""
    import numpy as np

    left = dt
    while True:
        walls = [(s if u > 0 else 0.0) for u, s in zip(v, room, strict=True)]
        times = [(s - x) / u if u else np.inf for x, u, s in zip(p, v, walls, strict=True)]
        axis = int(np.argmin(times))
        if times[axis] >= left:
            return p + v * left, v
        p, left = p + v * times[axis], left - times[axis]
        v = np.where(np.arange(2) == axis, -restitution * v, v)


@alternative("7.3")
def each_axis_for_itself(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> list[list[float]]:
    """Walls along x and walls along y know nothing of each other."""
    ends = []
    for x, speed, size in zip(p, v, room, strict=True):
        left = dt
        while speed != 0:
            need = (size - x) / speed if speed > 0 else x / -speed
            if need > left:
                break
            x, speed, left = (size if speed > 0 else 0.0), -restitution * speed, left - need
        ends.append((x + speed * left, speed))
    (x, vx), (y, vy) = ends
    return [[x, y], [vx, vy]]


@alternative("7.3")
def called_again_for_the_rest(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> Any:
    """After the first impact the rest of the step is a shorter step: the function calls itself."""
    import numpy as np

    def step(p: Vector, v: Vector, left: float) -> Any:
        walls = np.where(v > 0, room, 0.0)
        times = np.full(2, np.inf)
        np.divide(walls - p, v, out=times, where=v != 0)
        if times.min() > left:
            return p + v * left, v
        hit = times == times.min()
        there = np.where(hit, walls, p + v * times.min())
        return step(there, np.where(hit, -restitution * v, v), left - times.min())

    return step(p, v, dt)


@alternative("7.3")
def unrolled_with_growing_rooms(
    p: Vector, v: Vector, room: Vector, restitution: float, dt: float
) -> Any:
    """Instead of a slower ball a larger room: the way goes straight on through mirrored rooms."""
    import numpy as np

    places, speeds = [], []
    for x, u, size in zip(p, v, room, strict=True):
        way, walls = abs(u) * dt, (size - x if u > 0 else x)
        count, scale = 0, 1.0
        while way >= walls and u != 0:
            way, count, scale = way - walls, count + 1, scale / restitution
            walls = size * scale
        forward = (u > 0) == (count % 2 == 0)
        start = x if count == 0 else (0.0 if forward else size)
        places.append(start + (1 if forward else -1) * way / scale)
        speeds.append((1 if forward else -1) * abs(u) / scale)
    return np.array([places, speeds])


@alternative("7.4")
def from_a_heap(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """All events are thrown on a heap; the one on top is the next."""
    import heapq
    from itertools import combinations

    heap: list[tuple[float, int, int]] = []
    for i, j in combinations(range(len(radii)), 2):
        d = complex(*positions[j]) - complex(*positions[i])
        v = complex(*velocities[i]) - complex(*velocities[j])
        reach = radii[i] + radii[j]
        z = d * v.conjugate() / abs(v) if v else -1j
        if z.real > 0 and abs(z.imag) <= reach:
            t = (z.real - (reach**2 - z.imag**2) ** 0.5) / abs(v)
            heapq.heappush(heap, (max(t, 0.0), i, j))
    return heap[0] if heap else None


@alternative("7.4")
def all_pairs_in_arrays(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """The times of all pairs stand in one table; nan and inf mark those that never meet."""
    import numpy as np

    i, j = np.triu_indices(len(radii), k=1)
    d, v = positions[j] - positions[i], velocities[j] - velocities[i]
    a, b = (v * v).sum(axis=1), (d * v).sum(axis=1)
    c = (d * d).sum(axis=1) - (radii[i] + radii[j]) ** 2
    with np.errstate(invalid="ignore", divide="ignore"):
        t = np.maximum(c, 0) / (np.sqrt(b * b - a * c) - b)
    t = np.where((b < 0) & (b * b >= a * c), t, np.inf)
    first = t.argmin()
    return [t[first], i[first], j[first]] if np.isfinite(t[first]) else None


@alternative("7.4")
def pair_by_pair(positions: Vector, velocities: Vector, radii: Vector) -> Any:
    """Two loops list the meetings, and the smallest of the list is the next."""
    import numpy as np

    found = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v = positions[j] - positions[i], velocities[j] - velocities[i]
            a, b, c = v @ v, d @ v, d @ d - (radii[i] + radii[j]) ** 2
            if b < 0 <= b * b - a * c:
                t = max(c, 0.0) / (-b + np.sqrt(b * b - a * c))
                found.append((t, i, j))
    return min(found, default=None)


@alternative("7.5")
def turning_on_a_circle(mass_ratio: float) -> int:
    """With the energy kept, the velocities are a point on a circle; each two hits turn it."""
    from math import atan, ceil, pi, sqrt

    return ceil(pi / atan(1 / sqrt(mass_ratio))) - 1


@alternative("7.5")
def with_places_and_times(mass_ratio: float) -> int:
    """The blocks really move: the next event is the earlier of two, until there is none."""
    x1, x2, v1, v2, count = 1.0, 2.0, 0.0, -1.0, 0
    while True:
        to_wall = -x1 / v1 if v1 < 0 else float("inf")
        to_block = (x2 - x1) / (v1 - v2) if v1 > v2 else float("inf")
        if to_wall == to_block == float("inf"):
            return count
        t, count = min(to_wall, to_block), count + 1
        x1, x2 = x1 + v1 * t, x2 + v2 * t
        if to_wall < to_block:
            x1, v1 = 0.0, -v1
        else:
            x2, push = x1, 2 * (v1 - v2) / (1 + mass_ratio)
            v1, v2 = v1 - push * mass_ratio, v2 + push


@alternative("7.5")
def as_a_matrix(mass_ratio: float) -> Any:
    """A hit of the blocks is a matrix, the wall another one; they take turns."""
    import numpy as np

    m = mass_ratio
    blocks = np.array([[1 - m, 2 * m], [2, m - 1]]) / (1 + m)
    wall, v, count = np.diag([-1.0, 1.0]), np.array([0.0, -1.0]), 0
    while v[0] < 0 or v[0] > v[1]:
        v, count = (wall if v[0] < 0 else blocks) @ v, count + 1
    return np.int64(count)


@alternative("7.5")
def from_hit_to_hit(mass_ratio: float) -> int:
    """Velocities alone: the blocks hit while they approach, and the wall turns the light one."""
    light, heavy, count = 0.0, -1.0, 0
    while light > heavy:
        centre = (light + mass_ratio * heavy) / (1 + mass_ratio)
        light, heavy, count = 2 * centre - light, 2 * centre - heavy, count + 1
        if light < 0:
            light, count = -light, count + 1
    return count

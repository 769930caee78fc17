"""Unusual right answers to chapter 11: from a broad phase to a sound."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any
Table: TypeAlias = Any


@alternative("11.1")
def sort_and_sweep(boxes: Table) -> Any:
    """From left to right: a box is compared with those that have not ended yet."""
    order = sorted(range(len(boxes)), key=lambda n: boxes[n][0])
    active: list[int] = []
    found: list[tuple[int, int]] = []
    for n in order:
        active = [k for k in active if boxes[k][1] >= boxes[n][0]]
        near = [k for k in active if boxes[k][2] <= boxes[n][3] and boxes[n][2] <= boxes[k][3]]
        found += [(min(k, n), max(k, n)) for k in near]
        active.append(n)
    return found


@alternative("11.1")
def all_at_once(boxes: Table) -> Any:
    """Four tables of comparisons, one for each side."""
    import numpy as np

    left, right, low, high = np.transpose(boxes)
    x = (left[:, None] <= right) & (left <= right[:, None])
    y = (low[:, None] <= high) & (low <= high[:, None])
    return np.argwhere(np.triu(x & y, k=1))


@alternative("11.2")
def with_six_velocities(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """All six velocities in one vector; a contact is a row, and the masses are a diagonal."""
    import numpy as np

    inverses = np.diag(1 / np.array([a[0], a[0], a[1], b[0], b[0], b[1]]))
    v = np.array([a[2], a[3], a[4], b[2], b[3], b[4]])
    rows = []
    for x, y in (normal, (-normal[1], normal[0])):
        turns = [arm[0] * y - arm[1] * x for arm in (arm_a, arm_b)]
        rows.append(np.array([-x, -y, -turns[0], x, y, turns[1]]))
    across, along = rows
    if across @ v >= 0:
        return a[2:4], a[4], b[2:4], b[4]
    jn = -(1 + restitution) * (across @ v) / (across @ inverses @ across)
    v = v + inverses @ across * jn
    wanted = -(along @ v) / (along @ inverses @ along)
    v = v + inverses @ along * (np.sign(wanted) * min(abs(wanted), friction * jn))
    return v[0:2], v[2], v[3:5], v[5]


@alternative("11.2")
def with_complex_numbers(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """Vectors are complex numbers; i r is the velocity of a point that turns at 1 rad/s."""
    n, r, s = complex(*normal), complex(*arm_a), complex(*arm_b)
    v, w, x, y = complex(a[2], a[3]), a[4], complex(b[2], b[3]), b[4]
    limits = [float("inf"), 0.0]
    for k, along in enumerate((n, 1j * n)):
        u = ((x + 1j * s * y - v - 1j * r * w) * along.conjugate()).real
        lever_a, lever_b = (r.conjugate() * along).imag, (s.conjugate() * along).imag
        mass = 1 / (1 / a[0] + 1 / b[0] + lever_a**2 / a[1] + lever_b**2 / b[1])
        j = -u * mass * (1 + restitution if k == 0 else 1)
        j = max(j, 0.0) if k == 0 else max(-limits[1], min(j, limits[1]))
        limits[1] = friction * j
        v, w = v - j * along / a[0], w - j * lever_a / a[1]
        x, y = x + j * along / b[0], y + j * lever_b / b[1]
    return v, w, x, y


@alternative("11.2")
def one_loop_for_both_directions(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """First the normal, then the tangent; both bodies in lists of two."""
    import numpy as np

    v, w, jn = [a[2:4], b[2:4]], [a[4], b[4]], 0.0
    arms = np.array([arm_a, arm_b])
    for turn, n in enumerate((normal, np.array([-normal[1], normal[0]]))):
        r = arms[:, 0] * n[1] - arms[:, 1] * n[0]
        yields = 1 / a[0] + 1 / b[0] + r[0] ** 2 / a[1] + r[1] ** 2 / b[1]
        u = (v[1] - v[0]) @ n + w[1] * r[1] - w[0] * r[0]
        limit = friction * jn
        j = np.clip(-u / yields, -limit, limit) if turn else max(-(1 + restitution) * u / yields, 0)
        jn = jn if turn else j
        v = [v[0] - j * n / a[0], v[1] + j * n / b[0]]
        w = [w[0] - j * r[0] / a[1], w[1] + j * r[1] / b[1]]
    return v[0], w[0], v[1], w[1]


@alternative("11.2")
def first_the_push_then_the_rub(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """Both impulses written out, one after the other."""
    import numpy as np

    n, t = np.array(normal), np.array([-normal[1], normal[0]])
    v_a, w_a, v_b, w_b = np.array(a[2:4]), a[4], np.array(b[2:4]), b[4]
    n_a, n_b = arm_a[0] * n[1] - arm_a[1] * n[0], arm_b[0] * n[1] - arm_b[1] * n[0]
    t_a, t_b = arm_a[0] * t[1] - arm_a[1] * t[0], arm_b[0] * t[1] - arm_b[1] * t[0]
    u = (v_b - v_a) @ n + w_b * n_b - w_a * n_a
    if u >= 0:
        return v_a, w_a, v_b, w_b
    jn = -(1 + restitution) * u / (1 / a[0] + 1 / b[0] + n_a**2 / a[1] + n_b**2 / b[1])
    v_a, v_b = v_a - jn / a[0] * n, v_b + jn / b[0] * n
    w_a, w_b = w_a - jn * n_a / a[1], w_b + jn * n_b / b[1]
    s = (v_b - v_a) @ t + w_b * t_b - w_a * t_a
    grip = -s / (1 / a[0] + 1 / b[0] + t_a**2 / a[1] + t_b**2 / b[1])
    jt = max(-friction * jn, min(grip, friction * jn))
    v_a, v_b = v_a - jt / a[0] * t, v_b + jt / b[0] * t
    w_a, w_b = w_a - jt * t_a / a[1], w_b + jt * t_b / b[1]
    return v_a, w_a, v_b, w_b


@alternative("11.3")
def from_the_centre_of_mass(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """Each pair is seen from its centre of mass, and each wall from its own side."""
    import numpy as np

    p = [x + v * dt for x, v in zip(positions, velocities, strict=True)]
    v = [u + gravity * dt for u in velocities]
    for j in range(len(p)):
        for i in range(j):
            distance = np.linalg.norm(p[i] - p[j])
            if distance >= radii[i] + radii[j]:
                continue
            n = (p[i] - p[j]) / distance
            total = masses[i] + masses[j]
            centre = (masses[i] * v[i] + masses[j] * v[j]) / total
            for k, other in ((i, j), (j, i)):
                approaches = (v[k] - centre) @ n * (1 if k == i else -1) < 0
                if approaches:
                    v[k] = v[k] - (1 + restitution) * ((v[k] - centre) @ n) * n
                out = (radii[i] + radii[j] - distance) * masses[other] / total
                p[k] = p[k] + (out if k == i else -out) * n
    for k, radius in enumerate(radii):
        for inward, place in (
            ((1, 0), radius),
            ((0, 1), radius),
            ((-1, 0), radius - room[0]),
            ((0, -1), radius - room[1]),
        ):
            n = np.array(inward)
            if p[k] @ n < place:
                p[k] = p[k] + (place - p[k] @ n) * n
                if v[k] @ n < 0:
                    v[k] = v[k] - (1 + restitution) * (v[k] @ n) * n
    return np.array(p), np.array(v)


@alternative("11.3")
def pair_by_pair_and_wall_by_wall(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """The steps of the task in their order, each written out."""
    import numpy as np

    v = velocities + gravity * dt
    p = positions + velocities * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth <= 0:
                continue
            n, k = way / np.hypot(*way), 1 / masses[i] + 1 / masses[j]
            vn = (v[j] - v[i]) @ n
            jn = max(-(1 + restitution) * vn / k, 0)
            v[i] -= jn / masses[i] * n
            v[j] += jn / masses[j] * n
            p[i] -= depth / k / masses[i] * n
            p[j] += depth / k / masses[j] * n
    for axis in (0, 1):
        low, high = radii, room[axis] - radii
        left, right = p[:, axis] < low, p[:, axis] > high
        out = (left & (v[:, axis] < 0)) | (right & (v[:, axis] > 0))
        v[out, axis] *= -restitution
        p[:, axis] = np.clip(p[:, axis], low, high)
    return p, v


@alternative("11.4")
def with_keys_of_two_digits(before: Table, now: Table) -> Any:
    """Each pair is one number, and sorted tables are compared."""
    import numpy as np

    keys = [np.array([1000 * i + j for i, j in pairs], dtype=int) for pairs in (before, now)]
    begun, parted = np.setdiff1d(keys[1], keys[0]), np.setdiff1d(keys[0], keys[1])
    return [divmod(key, 1000) for key in begun], [divmod(key, 1000) for key in parted]


@alternative("11.5")
def with_natural_exponential(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """One body after the other, with the rate ln 2 / half-life."""
    import math

    rate = math.log(2) / half_life
    return [
        1 if struck else light * math.exp(-rate * dt)
        for light, struck in zip(brightness, hit, strict=True)
    ]


@alternative("11.6")
def all_samples_at_once(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """The times of all samples in an array, and one formula of it."""
    import numpy as np

    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.arange(count) / rate
    return loudness * 0.5 ** (t / half_life) * np.sin(2 * np.pi * frequency * t)


@alternative("11.6")
def as_a_turning_pointer(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """A complex pointer that turns and shrinks; its height is the sample."""
    import cmath
    import math

    if frequency >= rate / 2:
        return [0.0] * count
    turn = cmath.exp(complex(-math.log(2) / half_life, 2 * math.pi * frequency) / rate)
    return [(loudness * turn**k).imag for k in range(count)]


@alternative("11.1")
def swept_in_order(boxes: Table) -> Any:
    """Sorted by their left sides, with their numbers; a box that begins too late ends the row."""
    order = sorted(range(len(boxes)), key=lambda n: boxes[n][0])
    found = []
    for i in range(len(order)):
        for k in range(i + 1, len(order)):
            one, other = boxes[order[i]], boxes[order[k]]
            if other[0] > one[1]:
                break
            if one[2] <= other[3] and other[2] <= one[3]:
                found.append((min(order[i], order[k]), max(order[i], order[k])))
    return sorted(found)

"""Wrong models of chapter 11: a broad phase, a hit, and a step.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import WrongModel, marked, wrong_model

Vector: TypeAlias = Any
Table: TypeAlias = Any


@wrong_model("11.1", "One box is far above the other. Do they share a point?")
def only_along_x(boxes: Table) -> Any:
    """Boxes overlap if they do along x."""
    count = range(len(boxes))
    return [
        (i, j)
        for i in count
        for j in count
        if i < j and boxes[i][0] <= boxes[j][1] and boxes[j][0] <= boxes[i][1]
    ]


@wrong_model("11.1", "Two planks make a cross. Which corner of one is inside the other?")
def corners_inside(boxes: Table) -> Any:
    """Boxes overlap if a corner of one is inside the other."""
    found = []
    for i in range(len(boxes)):
        for j in range(i + 1, len(boxes)):
            for (left, right, low, high), corners in ((boxes[i], boxes[j]), (boxes[j], boxes[i])):
                x_inside = any(left <= x <= right for x in corners[:2])
                if x_inside and any(low <= y <= high for y in corners[2:]):
                    found.append((i, j))
    return list(dict.fromkeys(found))


@wrong_model("11.1", "The pair of 2 and 5 is that of 5 and 2. Is it hit twice?")
def both_orders(boxes: Table) -> Any:
    """Each box asks every other one."""
    count = range(len(boxes))
    return [
        (i, j)
        for i in count
        for j in count
        if i != j
        and boxes[i][0] <= boxes[j][1]
        and boxes[j][0] <= boxes[i][1]
        and boxes[i][2] <= boxes[j][3]
        and boxes[j][2] <= boxes[i][3]
    ]


@wrong_model("11.1", "A small box lies inside a long one, off its middle. What does your rule say?")
def neighbours_in_a_row(boxes: Table) -> Any:
    """Sorted by their left sides, only neighbours can overlap."""
    order = np.argsort(boxes[:, 0])
    found = []
    for n in range(len(order) - 1):
        first, second = order[n], order[n + 1]
        one, other = boxes[first], boxes[second]
        if other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]:
            found.append((min(first, second), max(first, second)))
    return found


@wrong_model(
    "11.2", "A body that is hit beside its centre turns away. Does it yield as if it could not?"
)
def yields_by_moving_alone(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """The effective mass is that of the masses."""
    v, w, jn = [a[2:4], b[2:4]], [a[4], b[4]], 0.0
    arms = np.array([arm_a, arm_b])
    for turn, n in enumerate((normal, np.array([-normal[1], normal[0]]))):
        r = arms[:, 0] * n[1] - arms[:, 1] * n[0]
        yields = 1 / a[0] + 1 / b[0]
        u = (v[1] - v[0]) @ n + w[1] * r[1] - w[0] * r[0]
        j = (
            np.clip(-u / yields, -friction * jn, friction * jn)
            if turn
            else max(-(1 + restitution) * u / yields, 0)
        )
        jn = jn if turn else j
        v = [v[0] - j * n / a[0], v[1] + j * n / b[0]]
        w = [w[0] - j * r[0] / a[1], w[1] + j * r[1] / b[1]]
    return v[0], w[0], v[1], w[1]


@wrong_model(
    "11.2", "Friction stops the sliding as far as it can. How far can it, with a small mu?"
)
def friction_stops_everything(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """Friction always stops the sliding."""
    v, w, jn = [a[2:4], b[2:4]], [a[4], b[4]], 0.0
    arms = np.array([arm_a, arm_b])
    for turn, n in enumerate((normal, np.array([-normal[1], normal[0]]))):
        r = arms[:, 0] * n[1] - arms[:, 1] * n[0]
        yields = 1 / a[0] + 1 / b[0] + r[0] ** 2 / a[1] + r[1] ** 2 / b[1]
        u = (v[1] - v[0]) @ n + w[1] * r[1] - w[0] * r[0]
        j = -u / yields if turn else max(-(1 + restitution) * u / yields, 0)
        jn = jn if turn else j
        v = [v[0] - j * n / a[0], v[1] + j * n / b[0]]
        w = [w[0] - j * r[0] / a[1], w[1] + j * r[1] / b[1]]
    return v[0], w[0], v[1], w[1]


@wrong_model(
    "11.2", "The two receive opposite impulses at their arms. Are both torques of one sign?"
)
def both_turn_the_same_way(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """The impulse turns both bodies the same way."""
    v, w, jn = [a[2:4], b[2:4]], [a[4], b[4]], 0.0
    arms = np.array([arm_a, arm_b])
    for turn, n in enumerate((normal, np.array([-normal[1], normal[0]]))):
        r = arms[:, 0] * n[1] - arms[:, 1] * n[0]
        yields = 1 / a[0] + 1 / b[0] + r[0] ** 2 / a[1] + r[1] ** 2 / b[1]
        u = (v[1] - v[0]) @ n + w[1] * r[1] - w[0] * r[0]
        j = (
            np.clip(-u / yields, -friction * jn, friction * jn)
            if turn
            else max(-(1 + restitution) * u / yields, 0)
        )
        jn = jn if turn else j
        v = [v[0] - j * n / a[0], v[1] + j * n / b[0]]
        w = [w[0] + j * r[0] / a[1], w[1] + j * r[1] / b[1]]
    return v[0], w[0], v[1], w[1]


@wrong_model("11.2", "Bodies that part at the contact: does anything pull them together?")
def without_a_gate(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """Every contact is a hit."""
    v, w, jn = [a[2:4], b[2:4]], [a[4], b[4]], 0.0
    arms = np.array([arm_a, arm_b])
    for turn, n in enumerate((normal, np.array([-normal[1], normal[0]]))):
        r = arms[:, 0] * n[1] - arms[:, 1] * n[0]
        yields = 1 / a[0] + 1 / b[0] + r[0] ** 2 / a[1] + r[1] ** 2 / b[1]
        u = (v[1] - v[0]) @ n + w[1] * r[1] - w[0] * r[0]
        j = (
            np.clip(-u / yields, -friction * abs(jn), friction * abs(jn))
            if turn
            else -(1 + restitution) * u / yields
        )
        jn = jn if turn else j
        v = [v[0] - j * n / a[0], v[1] + j * n / b[0]]
        w = [w[0] - j * r[0] / a[1], w[1] + j * r[1] / b[1]]
    return v[0], w[0], v[1], w[1]


@wrong_model(
    "11.2", "The blow along the normal turns both bodies. Do they slide as before, after it?"
)
def sliding_before_the_blow(
    a: Vector,
    arm_a: Vector,
    b: Vector,
    arm_b: Vector,
    normal: Vector,
    restitution: float,
    friction: float,
) -> Any:
    """Friction acts on the sliding that there was before the impact."""
    v, w, jn = [a[2:4], b[2:4]], [a[4], b[4]], 0.0
    arms = np.array([arm_a, arm_b])
    for turn, n in enumerate((normal, np.array([-normal[1], normal[0]]))):
        r = arms[:, 0] * n[1] - arms[:, 1] * n[0]
        yields = 1 / a[0] + 1 / b[0] + r[0] ** 2 / a[1] + r[1] ** 2 / b[1]
        u = (b[2:4] - a[2:4]) @ n + b[4] * r[1] - a[4] * r[0]
        limit = friction * jn
        j = np.clip(-u / yields, -limit, limit) if turn else max(-(1 + restitution) * u / yields, 0)
        jn = jn if turn else j
        v = [v[0] - j * n / a[0], v[1] + j * n / b[0]]
        w = [w[0] - j * r[0] / a[1], w[1] + j * r[1] / b[1]]
    return v[0], w[0], v[1], w[1]


@wrong_model(
    "11.3", "Which velocity moves the disc in your step: that at its start, or that at its end?"
)
def falls_before_it_moves(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """Gravity comes first, and the new velocity moves the discs."""
    v = velocities + gravity * dt
    p = positions + v * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth <= 0:
                continue
            n, k = way / np.hypot(*way), 1 / masses[i] + 1 / masses[j]
            jn = max(-(1 + restitution) * ((v[j] - v[i]) @ n) / k, 0)
            v[i] -= jn / masses[i] * n
            v[j] += jn / masses[j] * n
            p[i] -= depth / k / masses[i] * n
            p[j] += depth / k / masses[j] * n
    for axis in (0, 1):
        low, high = radii, room[axis] - radii
        out = ((p[:, axis] < low) & (v[:, axis] < 0)) | ((p[:, axis] > high) & (v[:, axis] > 0))
        v[out, axis] *= -restitution
        p[:, axis] = np.clip(p[:, axis], low, high)
    return p, v


@wrong_model(
    "11.3",
    "A disc beyond the wall is on its way in already. Which way does it fly after your step?",
)
def walls_without_a_gate(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """A disc beyond a wall is turned round."""
    p, v = positions + velocities * dt, velocities + gravity * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth <= 0:
                continue
            n, k = way / np.hypot(*way), 1 / masses[i] + 1 / masses[j]
            jn = max(-(1 + restitution) * ((v[j] - v[i]) @ n) / k, 0)
            v[i] -= jn / masses[i] * n
            v[j] += jn / masses[j] * n
            p[i] -= depth / k / masses[i] * n
            p[j] += depth / k / masses[j] * n
    for axis in (0, 1):
        low, high = radii, room[axis] - radii
        out = (p[:, axis] < low) | (p[:, axis] > high)
        v[out, axis] *= -restitution
        p[:, axis] = np.clip(p[:, axis], low, high)
    return p, v


@wrong_model("11.3", "The disc has turned round. Is it still in the wall?")
def nobody_is_put_back(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """The velocity is turned round, and the disc comes out by itself."""
    p, v = positions + velocities * dt, velocities + gravity * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth <= 0:
                continue
            n, k = way / np.hypot(*way), 1 / masses[i] + 1 / masses[j]
            jn = max(-(1 + restitution) * ((v[j] - v[i]) @ n) / k, 0)
            v[i] -= jn / masses[i] * n
            v[j] += jn / masses[j] * n
            p[i] -= depth / k / masses[i] * n
            p[j] += depth / k / masses[j] * n
    for axis in (0, 1):
        low, high = radii, room[axis] - radii
        out = ((p[:, axis] < low) & (v[:, axis] < 0)) | ((p[:, axis] > high) & (v[:, axis] > 0))
        v[out, axis] *= -restitution
    return p, v


@wrong_model("11.3", "Two discs overlap and part already. Why do you hit them?")
def pairs_without_a_gate(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """Discs that overlap hit each other."""
    p, v = positions + velocities * dt, velocities + gravity * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth <= 0:
                continue
            n, k = way / np.hypot(*way), 1 / masses[i] + 1 / masses[j]
            jn = -(1 + restitution) * ((v[j] - v[i]) @ n) / k
            v[i] -= jn / masses[i] * n
            v[j] += jn / masses[j] * n
            p[i] -= depth / k / masses[i] * n
            p[j] += depth / k / masses[j] * n
    for axis in (0, 1):
        low, high = radii, room[axis] - radii
        out = ((p[:, axis] < low) & (v[:, axis] < 0)) | ((p[:, axis] > high) & (v[:, axis] > 0))
        v[out, axis] *= -restitution
        p[:, axis] = np.clip(p[:, axis], low, high)
    return p, v


@wrong_model("11.3", "A heavy disc and a light one: do both give way by the same?")
def half_each(
    positions: Table,
    velocities: Table,
    masses: Vector,
    radii: Vector,
    restitution: float,
    gravity: Vector,
    room: Vector,
    dt: float,
) -> Any:
    """Each disc is moved by half of the overlap."""
    p, v = positions + velocities * dt, velocities + gravity * dt
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            way = p[j] - p[i]
            depth = radii[i] + radii[j] - np.hypot(*way)
            if depth <= 0:
                continue
            n, k = way / np.hypot(*way), 1 / masses[i] + 1 / masses[j]
            jn = max(-(1 + restitution) * ((v[j] - v[i]) @ n) / k, 0)
            v[i] -= jn / masses[i] * n
            v[j] += jn / masses[j] * n
            p[i] -= depth / 2 * n
            p[j] += depth / 2 * n
    for axis in (0, 1):
        low, high = radii, room[axis] - radii
        out = ((p[:, axis] < low) & (v[:, axis] < 0)) | ((p[:, axis] > high) & (v[:, axis] > 0))
        v[out, axis] *= -restitution
        p[:, axis] = np.clip(p[:, axis], low, high)
    return p, v


WRONG_MODELS = marked(globals(), WrongModel)

"""Mistakes of which something false was said, or what is so only the other way round."""

from __future__ import annotations

import pytest
from course.recognition.students import Wrong
from course.recognition.test_recognition import SEED, is_right, verdict_of

SEEDS = (SEED, 1, 20, 77)
"""Draws with which the mistakes were measured."""

MISTAKES = (
    Wrong(
        "3.2",
        "restitution squared: a power is one too many, and none left out",
        ("power_more",),
        """
def bounce(velocity, normal, restitution):
    s = velocity @ normal
    if s >= 0:
        return velocity
    return velocity - (1 + restitution**2) * s * normal
""",
    ),
    Wrong(
        "2.1",
        "the root of the ratio",
        ("power_less",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return ((v2_after - v1_after) / (v1 - v2)) ** 0.5
""",
    ),
    Wrong(
        "3.2",
        "only the part along the wall is turned round, too: that along the normal is right",
        ("parts",),
        """
def bounce(velocity, normal, restitution):
    s = velocity @ normal
    if s >= 0:
        return velocity
    return -(velocity - s * normal) - restitution * s * normal
""",
    ),
    Wrong(
        "6.6",
        "the first edge in reach for the nearest: one call differs, in no length and no border",
        ("case",),
        """
import numpy as np


def circle_against_polygon(centre, radius, vertices):
    least = way = None
    inside = True
    for a, b in zip(vertices, np.roll(vertices, -1, axis=0)):
        edge = b - a
        inside = inside and edge[0] * (centre - a)[1] - edge[1] * (centre - a)[0] > 0
        part = min(max((centre - a) @ edge / (edge @ edge), 0.0), 1.0)
        offset = centre - (a + part * edge)
        distance = np.hypot(*offset)
        if least is None or (distance < least and least >= radius):
            least, way = distance, offset
    if inside:
        return -way / least, radius + least
    return (way / least, radius - least) if least < radius else None
""",
    ),
    Wrong(
        "6.4",
        "the axes of A only, turned by the centres: most of it is that one listed mistake",
        ("axes_of_a_only",),
        """
import numpy as np


def mtv(vertices_a, vertices_b):
    best = None
    for x, y in np.roll(vertices_a, -1, axis=0) - vertices_a:
        axis = np.array([y, -x]) / np.hypot(x, y)
        a, b = vertices_a @ axis, vertices_b @ axis
        depth = min(a.max() - b.min(), b.max() - a.min())
        if depth <= 0:
            return None
        if best is None or depth < best[1]:
            if (vertices_b.mean(axis=0) - vertices_a.mean(axis=0)) @ axis < 0:
                axis = -axis
            best = axis, depth
    return best
""",
    ),
    Wrong(
        "7.4",
        "the smallest gap now: two calls are wrong besides, one of them without a number",
        ("the_nearest_pair",),
        """
import math

import numpy as np


def meet(p, v, R):
    a, b, c = v @ v, p @ v, p @ p - R * R
    if b >= 0:
        return None
    if c <= 0:
        return 0.0
    if b * b < a * c:
        return None
    return c / (-b + math.sqrt(b * b - a * c))



def next_event(positions, velocities, radii):
    n = len(radii)
    pairs = [(i, j) for i in range(n) for j in range(i + 1, n)]
    gap = lambda ij: np.hypot(*(positions[ij[1]] - positions[ij[0]])) - radii[ij[0]] - radii[ij[1]]
    i, j = min(pairs, key=gap)
    t = meet(positions[j] - positions[i], velocities[j] - velocities[i], radii[i] + radii[j])
    if t is None:
        return None
    return t, i, j
""",
    ),
    Wrong(
        "7.5",
        "a wall after each strike: whole numbers, and two mistakes would give them, too",
        ("the_wall_after_every_strike",),
        """
def pi_collisions(mass_ratio):
    inner = 0.0
    outer = -1.0
    collisions = 0
    while outer < inner:
        V = (inner + mass_ratio * outer) / (mass_ratio + 1)
        inner = 2 * V - inner
        outer = 2 * V - outer
        collisions += 1
        inner = abs(inner)
        collisions += 1
    return collisions
""",
    ),
    Wrong(
        "P.3",
        "radii not counted: one side of a border, in no length",
        ("as_one",),
        """
import numpy as np


def share_impact(positions, velocities, radius, restitution):
    v = velocities.copy()
    for _ in range(ROUNDS):
        hits = []
        for i in range(len(v)):
            for j in range(i + 1, len(v)):
                way = positions[j] - positions[i]
                size = np.hypot(*way)
                if size <= TOUCHING:
                    speed = (v[i] - v[j]) @ way / size
                    if speed > 0:
                        hits.append((i, j, way / size, speed))
        load = np.zeros(len(v))
        for i, j, _n, _s in hits:
            load[[i, j]] += 1
        delta = np.zeros(v.shape)
        for i, j, n, s in hits:
            J = (1 + restitution) * s / 2 / max(load[i], load[j]) * n
            delta[i] -= J
            delta[j] += J
        v = v + delta
    return v
""",
    ),
)
"""Two were said to leave a power out, and the others to hold a slip that they do not hold."""


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("wrong", MISTAKES, ids=lambda wrong: wrong.cause)
def test_nothing_false_is_said_of_a_mistake(wrong: Wrong, seed: int) -> None:
    """What is said, if anything is, is the cause."""
    verdict = verdict_of(wrong, seed)
    assert not verdict.is_full
    assert is_right(wrong, verdict), [found.name for found in verdict.diagnoses]


def test_what_is_right_beside_a_mistake_is_said_to_be_right() -> None:
    """Of two parts of a velocity, one as it should be, the hint names the other."""
    (turned,) = [wrong for wrong in MISTAKES if "along the wall" in wrong.cause]
    (said,) = verdict_of(turned).diagnoses
    assert "is as it should be, that across it is turned round" in said.hint

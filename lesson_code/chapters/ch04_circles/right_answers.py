"""Unusual right answers to chapter 04: circles."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("4.1")
def with_complex_numbers(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Positions are complex numbers, and so is the normal that comes back."""
    way = complex(*p2) - complex(*p1)
    depth = r1 + r2 - abs(way)
    return None if depth <= 0 else [way / abs(way) if way else 1 + 0j, depth]


@alternative("4.1")
def with_an_angle(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """The normal is a direction; atan2 says 0 where there is none, which is (1, 0)."""
    from math import atan2, cos, dist, sin

    angle = atan2(p2[1] - p1[1], p2[0] - p1[0])
    depth = r1 + r2 - dist(p1, p2)
    return ((cos(angle), sin(angle)), depth) if depth > 0 else None


@alternative("4.1")
def with_pygame_vectors(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """A game's vector class measures, and its vector comes back."""
    from pygame import Vector2

    a, b = Vector2(*p1), Vector2(*p2)
    if a.distance_squared_to(b) >= (r1 + r2) ** 2:
        return None
    return (b - a).normalize() if a != b else Vector2(1, 0), r1 + r2 - a.distance_to(b)


@alternative("4.1")
def from_2_to_1_and_turned(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circle 1 is seen from circle 2; order and normal are both turned round."""
    x, y = p1[0] - p2[0], p1[1] - p2[1]
    if x * x + y * y >= (r2 + r1) * (r2 + r1):
        return None
    distance = (x * x + y * y) ** 0.5
    if distance == 0:
        return (1.0, 0.0), r2 + r1
    return (-x / distance, -y / distance), r2 + r1 - distance


@alternative("4.2")
def seen_from_the_centre_of_mass(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Seen from the centre of mass each normal part is turned round and multiplied by e."""
    import numpy as np

    if np.dot(v1 - v2, normal) <= 0:
        return v1, v2
    centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    u1, u2 = np.dot(v1 - centre, normal), np.dot(v2 - centre, normal)
    return v1 - (1 + restitution) * u1 * normal, v2 - (1 + restitution) * u2 * normal


@alternative("4.2")
def with_the_reduced_mass(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> list[list[float]]:
    """The impulse is (1 + e) times reduced mass times approach; lists come back."""
    approach = sum((a - b) * n for a, b, n in zip(v1, v2, normal, strict=True))
    impulse = (1 + restitution) * max(0, approach) * m1 * m2 / (m1 + m2)
    return [
        [a - impulse * n / m1 for a, n in zip(v1, normal, strict=True)],
        [b + impulse * n / m2 for b, n in zip(v2, normal, strict=True)],
    ]


@alternative("4.2")
def as_four_equations(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Momentum along n, restitution, and both tangent parts: four equations, four unknowns."""
    import numpy as np

    (x, y), approach = normal, np.dot(v1 - v2, normal)
    if approach < 0:
        return v1, v2
    equations = [[m1 * x, m1 * y, m2 * x, m2 * y], [-x, -y, x, y], [-y, x, 0, 0], [0, 0, -y, x]]
    tangent = np.array([-y, x])
    known = [np.dot(m1 * v1 + m2 * v2, normal), restitution * approach, v1 @ tangent, v2 @ tangent]
    return np.linalg.solve(equations, known).reshape(2, 2)


@alternative("4.2")
def turned_into_one_dimension(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> tuple[complex, complex]:
    """Turned so that the normal lies along x, it is chapter 01; then all is turned back."""
    n = complex(*normal)
    a, b = complex(*v1) / n, complex(*v2) / n
    if a.real > b.real:
        centre = (m1 * a.real + m2 * b.real) / (m1 + m2)
        bounced = [centre - restitution * (v.real - centre) for v in (a, b)]
        a, b = complex(bounced[0], a.imag), complex(bounced[1], b.imag)
    return a * n, b * n


@alternative("4.3")
def fixed_circles_apart(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """A fixed circle is a case of its own; otherwise the other mass decides."""
    from math import inf

    if m1 == inf:
        part = 0.0
    elif m2 == inf:
        part = 1.0
    else:
        part = m2 / (m1 + m2)
    return p1 - part * depth * normal, p2 + (1 - part) * depth * normal


@alternative("4.3")
def with_complex_positions(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> list[complex]:
    """Positions are complex numbers; a push moves each as far as its inverse mass lets it."""
    push = depth * complex(*normal) / (1 / m1 + 1 / m2)
    return [complex(*p1) - push / m1, complex(*p2) + push / m2]


@alternative("4.3")
def moved_in_place(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """The positions themselves are changed and handed back."""
    normal *= depth / (1 / m1 + 1 / m2)
    p1 -= normal / m1
    p2 += normal / m2
    return [p1, p2]


@alternative("4.4")
def written_out_in_components(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Velocities first, then positions, number by number; lists come back."""
    (x, y), inverse = normal, 1 / m1 + 1 / m2
    approach = max(0.0, (v1[0] - v2[0]) * x + (v1[1] - v2[1]) * y)
    jn, push = (1 + restitution) * approach / inverse, depth / inverse
    return [
        [p1[0] - push / m1 * x, p1[1] - push / m1 * y],
        [v1[0] - jn / m1 * x, v1[1] - jn / m1 * y],
        [p2[0] + push / m2 * x, p2[1] + push / m2 * y],
        [v2[0] + jn / m2 * x, v2[1] + jn / m2 * y],
    ]


@alternative("4.4")
def as_one_array_of_four(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Positions and velocities are pushed alike: one row each, one array comes back."""
    import numpy as np

    impulse = (1 + restitution) * max(0.0, float((v1 - v2) @ normal))
    share = 1 / m2 / (1 / m1 + 1 / m2)
    pushes = np.array([share - 1, share - 1, share, share]) * [depth, impulse, depth, impulse]
    return np.array([p1, v1, p2, v2]) + np.outer(pushes, normal)


@alternative("4.4")
def first_places_then_velocities(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Both velocities are worked out from both old ones, each with the whole formula."""
    w1, w2 = 1 / m1, 1 / m2
    p1 = p1 - w1 / (w1 + w2) * depth * normal
    p2 = p2 + w2 / (w1 + w2) * depth * normal
    if (v2 - v1) @ normal < 0:
        v1, v2 = (
            v1 + (1 + restitution) * ((v2 - v1) @ normal) / (w1 + w2) * w1 * normal,
            v2 - (1 + restitution) * ((v2 - v1) @ normal) / (w1 + w2) * w2 * normal,
        )
    return p1, v1, p2, v2

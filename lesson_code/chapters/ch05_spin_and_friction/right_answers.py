"""Unusual right answers to chapter 05: spin and friction."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Number: TypeAlias = Any
Vector: TypeAlias = Any


@alternative("5.1")
def cut_into_triangles(mass: float, vertices: Vector) -> Number:
    """A fan of triangles, each with its own inertia and the parallel axis theorem."""
    from itertools import pairwise

    parts = []
    (x0, y0) = vertices[0]
    for (x1, y1), (x2, y2) in pairwise(vertices[1:]):
        area = ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2
        centre = ((x0 + x1 + x2) / 3, (y0 + y1 + y2) / 3)
        corners = ((x0, y0), (x1, y1), (x2, y2))
        spread = sum((x - centre[0]) ** 2 + (y - centre[1]) ** 2 for x, y in corners)
        parts.append((area, *centre, spread / 12))
    total = sum(part[0] for part in parts)
    c_x, c_y = (sum(part[0] * part[i] for part in parts) / total for i in (1, 2))
    about_centre = (a * (own + (x - c_x) ** 2 + (y - c_y) ** 2) for a, x, y, own in parts)
    return mass * sum(about_centre) / total


@alternative("5.1")
def origin_less_parallel_axis(mass: float, vertices: Vector) -> Number:
    """About the origin first, then m d^2 is taken away."""
    import numpy as np

    p, q = vertices, np.roll(vertices, -1, axis=0)
    w = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    w = w / w.sum()
    centroid = w @ (p + q) / 3
    return mass * (w @ (p * p + p * q + q * q).sum(axis=1) / 6 - centroid @ centroid)


@alternative("5.1")
def with_complex_vertices(mass: float, vertices: Vector):  # type: ignore[no-untyped-def]
    points = [complex(x, y) for x, y in vertices]
    edges = list(zip(points, points[1:] + points[:1], strict=True))
    area = sum((p.conjugate() * q).imag for p, q in edges)
    centre = sum((p.conjugate() * q).imag * (p + q) for p, q in edges) / area / 3
    edges = [(p - centre, q - centre) for p, q in edges]
    second = sum(
        (p.conjugate() * q).imag * (abs(p) ** 2 + (p * q.conjugate()).real + abs(q) ** 2)
        for p, q in edges
    )
    return mass * second / area / 6


@alternative("5.1")
def edge_by_edge(mass: float, vertices: Vector) -> Number:
    """One sum after the other, over the edges: first for the centroid, then about it."""
    count, area, moment = len(vertices), 0.0, 0.0
    centroid = 0 * vertices[0]
    for i in range(count):
        (x1, y1), (x2, y2) = vertices[i], vertices[(i + 1) % count]
        area += (x1 * y2 - x2 * y1) / 2
        centroid = centroid + (vertices[i] + vertices[(i + 1) % count]) * (x1 * y2 - x2 * y1)
    centroid = centroid / (6 * area)
    area = 0.0
    for i in range(count):
        p, q = vertices[i] - centroid, vertices[(i + 1) % count] - centroid
        twice = p[0] * q[1] - p[1] * q[0]
        moment += twice * (p @ p + p @ q + q @ q) / 12
        area += twice / 2
    return mass * moment / area


@alternative("5.1")
def as_a_closed_ring(mass: float, vertices: Vector):  # type: ignore[no-untyped-def]
    import numpy as np

    ring = np.vstack([vertices, vertices[:1]]) - vertices[0]
    x, y = ring.T
    w = x[:-1] * y[1:] - x[1:] * y[:-1]
    centre = np.array([np.sum(w * (c[:-1] + c[1:])) for c in (x, y)]) / (3 * w.sum())
    x, y = (ring - centre).T
    w = np.abs(x[:-1] * y[1:] - x[1:] * y[:-1])  # seen from inside a convex shape, all of one sign
    squares = sum(c[:-1] ** 2 + c[:-1] * c[1:] + c[1:] ** 2 for c in (x, y))
    return np.array(mass * np.average(squares, weights=w) / 6)


@alternative("5.2")
def with_complex_numbers(v: Vector, w: float, r: Vector) -> complex:
    """A quarter turn is a factor i; a complex number comes back."""
    return complex(*v) + 1j * w * complex(*r)


@alternative("5.2")
def with_a_matrix(v: Vector, w: float, r: Vector) -> Vector:
    """The spin is a matrix that acts on r."""
    import numpy as np

    return v + np.array([[0, -w], [w, 0]]) @ r


@alternative("5.2")
def as_vectors_in_space(v: Vector, w: float, r: Vector) -> list[float]:
    """The cross product of vectors in space; a list comes back."""
    import numpy as np

    turned = np.cross([0.0, 0.0, w], [r[0], r[1], 0.0])
    return [float(v[0] + turned[0]), float(v[1] + turned[1])]


@alternative("5.3")
def change_by_one_newton_second(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """Push with 1 N s, and look how much the velocities at the contact differ afterwards."""
    n_x, n_y = direction

    def given(m: float, i: float, r: Vector, push: float) -> float:
        w = push * (r[0] * n_y - r[1] * n_x) / i
        return float((push * n_x / m - w * r[1]) * n_x + (push * n_y / m + w * r[0]) * n_y)

    return given(m_b, i_b, r_b, 1.0) - given(m_a, i_a, r_a, -1.0)


@alternative("5.3")
def lever_by_pythagoras(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Any:
    """The lever arm squared is r squared less the part along the push, squared."""
    import numpy as np

    arms = [np.dot(r, r) - np.dot(r, direction) ** 2 for r in (r_a, r_b)]
    return np.float64(1 / m_a + arms[0] / i_a + 1 / m_b + arms[1] / i_b)


@alternative("5.3")
def with_angles(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """The lever arm is the distance times the sine of the angle to the push."""
    from math import atan2, hypot, sin

    way = atan2(direction[1], direction[0])
    k = 0.0
    for m, i, r in ((m_a, i_a, r_a), (m_b, i_b, r_b)):
        k += 1 / m + (hypot(*r) * sin(way - atan2(r[1], r[0]))) ** 2 / i
    return k


@alternative("5.4")
def the_middle_of_three(vt: float, jn: float, friction: float, k: float) -> Number:
    """Of the two limits and what would stop the sliding, the middle one."""
    return sorted((-friction * jn, -vt / k, friction * jn))[1]


@alternative("5.4")
def smaller_of_two_sizes(vt: float, jn: float, friction: float, k: float) -> Number:
    """The smaller of both sizes, against the sliding."""
    from math import copysign

    return copysign(min(abs(vt) / k, friction * jn), -vt)


@alternative("5.4")
def in_two_cases(vt: float, jn: float, friction: float, k: float):  # type: ignore[no-untyped-def]
    import numpy as np

    if friction * jn * k >= abs(vt):
        return np.array(-vt / k)
    return -friction * jn if vt > 0 else friction * jn


@alternative("5.5")
def from_what_is_kept(
    velocity: Vector, w: float, radius: float, normal: Vector, restitution: float, friction: float
) -> Any:
    """The angular momentum about the contact is kept, and a disc that does not slide rolls."""
    n_x, n_y = normal
    v_n = velocity[0] * n_x + velocity[1] * n_y
    v_t = velocity[1] * n_x - velocity[0] * n_y
    if v_n >= 0:
        return tuple(velocity), w
    # About the contact m r v_t + 1/2 m r^2 w is kept; rolling is v_t = w r.
    rolling = (2 * v_t + w * radius) / 3
    most = friction * (1 + restitution) * -v_n
    change = max(-most, min(most, rolling - v_t))
    v_n, v_t = -restitution * v_n, v_t + change
    return (v_n * n_x - v_t * n_y, v_n * n_y + v_t * n_x), w - 2 * change / radius


@alternative("5.5")
def in_the_frame_of_the_wall(
    velocity: Vector, w: float, radius: float, normal: Vector, restitution: float, friction: float
) -> Any:
    """The wall is turned level by a complex factor, and back; nested lists come back."""
    n = complex(*normal)
    along = complex(*velocity) * 1j / n  # the normal is turned to i, the floor's own
    if along.imag >= 0:
        return [[float(velocity[0]), float(velocity[1])], w]
    mass = 2.5
    inertia = mass * radius**2 / 2
    jn = -(1 + restitution) * mass * along.imag
    sliding = along.real + w * radius
    jt = -sliding / (1 / mass + radius**2 / inertia)
    jt = max(-friction * jn, min(friction * jn, jt))
    after = (along + (jt + 1j * jn) / mass) * n / 1j
    return [[after.real, after.imag], w + radius * jt / inertia]


@alternative("5.5")
def along_and_across_the_wall(
    velocity: Vector, w: float, radius: float, normal: Vector, restitution: float, friction: float
) -> Any:
    """For a disc of 1 kg: an impulse across the wall, then one along it, clamped."""
    import numpy as np

    tangent = np.array([-normal[1], normal[0]])
    v_n, v_t = np.dot(velocity, normal), np.dot(velocity, tangent) - w * radius
    if v_n >= 0:
        return velocity, w
    jn = -(1 + restitution) * v_n
    jt = np.clip(-v_t / 3, -friction * jn, friction * jn)
    return velocity + jn * normal + jt * tangent, w - 2 * jt / radius

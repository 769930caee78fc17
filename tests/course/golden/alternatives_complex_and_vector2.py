"""Right answers as a complex number, as a Vector2 of pygame, and as lists."""

from pygame import Vector2


def reflect(incident, normal):
    i, n = complex(*incident), complex(*normal)
    return -n * n * i.conjugate()


def bounce(velocity, normal, restitution):
    v, n = Vector2(*velocity), Vector2(*normal)
    return v - (1 + restitution) * min(0.0, v.dot(n)) * n


def resolve_wall(position, velocity, normal, depth, restitution):
    (x, y), (n_x, n_y) = position.tolist(), normal.tolist()
    return [[x + depth * n_x, y + depth * n_y], bounce(velocity, normal, restitution)]

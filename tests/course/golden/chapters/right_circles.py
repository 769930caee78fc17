"""Right answers, each written in an unusual way: circles."""


def circle_contact(p1, r1, p2, r2):
    """Circle 1 is seen from circle 2; order and normal are both turned round."""
    x, y = (p1[0] - p2[0], p1[1] - p2[1])
    if x * x + y * y >= (r2 + r1) * (r2 + r1):
        return None
    distance = (x * x + y * y) ** 0.5
    if distance == 0:
        return ((1.0, 0.0), r2 + r1)
    return ((-x / distance, -y / distance), r2 + r1 - distance)


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    """Turned so that the normal lies along x, it is chapter 01; then all is turned back."""
    n = complex(*normal)
    a, b = (complex(*v1) / n, complex(*v2) / n)
    if a.real > b.real:
        centre = (m1 * a.real + m2 * b.real) / (m1 + m2)
        bounced = [centre - restitution * (v.real - centre) for v in (a, b)]
        a, b = (complex(bounced[0], a.imag), complex(bounced[1], b.imag))
    return (a * n, b * n)


def separate(p1, m1, p2, m2, normal, depth):
    """The positions themselves are changed and handed back."""
    normal *= depth / (1 / m1 + 1 / m2)
    p1 -= normal / m1
    p2 += normal / m2
    return [p1, p2]


def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    """Positions and velocities are pushed alike: one row each, one array comes back."""
    import numpy as np
    impulse = (1 + restitution) * max(0.0, float((v1 - v2) @ normal))
    share = 1 / m2 / (1 / m1 + 1 / m2)
    pushes = np.array([share - 1, share - 1, share, share]) * [depth, impulse, depth, impulse]
    return np.array([p1, v1, p2, v2]) + np.outer(pushes, normal)

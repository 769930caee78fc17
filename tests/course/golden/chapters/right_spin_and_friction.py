"""Right answers, each written in an unusual way: spin and friction."""


def moment_of_inertia(mass, vertices):
    import numpy as np
    ring = np.vstack([vertices, vertices[:1]]) - vertices[0]
    x, y = ring.T
    w = x[:-1] * y[1:] - x[1:] * y[:-1]
    centre = np.array([np.sum(w * (c[:-1] + c[1:])) for c in (x, y)]) / (3 * w.sum())
    x, y = (ring - centre).T
    w = np.abs(x[:-1] * y[1:] - x[1:] * y[:-1])
    squares = sum((c[:-1] ** 2 + c[:-1] * c[1:] + c[1:] ** 2 for c in (x, y)))
    return np.array(mass * np.average(squares, weights=w) / 6)


def contact_velocity(v, w, r):
    """The cross product of vectors in space; a list comes back."""
    import numpy as np
    turned = np.cross([0.0, 0.0, w], [r[0], r[1], 0.0])
    return [float(v[0] + turned[0]), float(v[1] + turned[1])]


def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    """The lever arm is the distance times the sine of the angle to the push."""
    from math import atan2, hypot, sin
    way = atan2(direction[1], direction[0])
    k = 0.0
    for m, i, r in ((m_a, i_a, r_a), (m_b, i_b, r_b)):
        k += 1 / m + (hypot(*r) * sin(way - atan2(r[1], r[0]))) ** 2 / i
    return k


def friction_impulse(vt, jn, friction, k):
    import numpy as np
    if friction * jn * k >= abs(vt):
        return np.array(-vt / k)
    return -friction * jn if vt > 0 else friction * jn


def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    """The wall is turned level by a complex factor, and back; nested lists come back."""
    n = complex(*normal)
    along = complex(*velocity) * 1j / n
    if along.imag >= 0:
        return [[float(velocity[0]), float(velocity[1])], w]
    mass = 2.5
    inertia = mass * radius ** 2 / 2
    jn = -(1 + restitution) * mass * along.imag
    sliding = along.real + w * radius
    jt = -sliding / (1 / mass + radius ** 2 / inertia)
    jt = max(-friction * jn, min(friction * jn, jt))
    after = (along + (jt + 1j * jn) / mass) * n / 1j
    return [[after.real, after.imag], w + radius * jt / inertia]

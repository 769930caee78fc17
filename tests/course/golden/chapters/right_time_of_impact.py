"""Right answers, each written in an unusual way: time of impact."""


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    """NumPy finds the roots; the smaller one counts, and 0 where it is in the past."""
    import numpy as np
    d, v = (p2 - p1, v2 - v1)
    if np.dot(d, v) >= 0:
        return None
    roots = np.roots([v @ v, 2 * d @ v, d @ d - (r1 + r2) ** 2])
    if np.iscomplex(roots).any():
        return None
    t = max(min(roots.real), 0.0)
    return t if t <= dt else None


def time_to_floor(height, velocity, gravity):
    """From a time that is too late, tangents lead down to the root and never past it."""
    if gravity == 0:
        return None if velocity >= 0 else -height / velocity
    t = 2 * max(velocity, 0.0) / gravity + (2 * height / gravity) ** 0.5
    for _ in range(80):
        above, rising = (height + velocity * t - gravity * t * t / 2, velocity - gravity * t)
        t = t - above / rising if rising else t
    return t


def advance(p, v, room, restitution, dt):
    """Instead of a slower ball a larger room: the way goes straight on through mirrored rooms."""
    import numpy as np
    places, speeds = ([], [])
    for x, u, size in zip(p, v, room, strict=True):
        way, walls = (abs(u) * dt, size - x if u > 0 else x)
        count, scale = (0, 1.0)
        while way >= walls and u != 0:
            way, count, scale = (way - walls, count + 1, scale / restitution)
            walls = size * scale
        forward = (u > 0) == (count % 2 == 0)
        start = x if count == 0 else 0.0 if forward else size
        places.append(start + (1 if forward else -1) * way / scale)
        speeds.append((1 if forward else -1) * abs(u) / scale)
    return np.array([places, speeds])


def next_event(positions, velocities, radii):
    """The times of all pairs stand in one table; nan and inf mark those that never meet."""
    import numpy as np
    i, j = np.triu_indices(len(radii), k=1)
    d, v = (positions[j] - positions[i], velocities[j] - velocities[i])
    a, b = ((v * v).sum(axis=1), (d * v).sum(axis=1))
    c = (d * d).sum(axis=1) - (radii[i] + radii[j]) ** 2
    with np.errstate(invalid='ignore', divide='ignore'):
        t = np.maximum(c, 0) / (np.sqrt(b * b - a * c) - b)
    t = np.where((b < 0) & (b * b >= a * c), t, np.inf)
    first = t.argmin()
    return [t[first], i[first], j[first]] if np.isfinite(t[first]) else None


def pi_collisions(mass_ratio):
    """A hit of the blocks is a matrix, the wall another one; they take turns."""
    import numpy as np
    m = mass_ratio
    blocks = np.array([[1 - m, 2 * m], [2, m - 1]]) / (1 + m)
    wall, v, count = (np.diag([-1.0, 1.0]), np.array([0.0, -1.0]), 0)
    while v[0] < 0 or v[0] > v[1]:
        v, count = ((wall if v[0] < 0 else blocks) @ v, count + 1)
    return np.int64(count)

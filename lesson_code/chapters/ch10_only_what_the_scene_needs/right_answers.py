"""Unusual right answers to chapter 10: friction, plans, fastest ways, flights, and sleep."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any
Table: TypeAlias = Any
Number: TypeAlias = Any


@alternative("10.1")
def roughest_with_the_next(inverse_masses: Vector, frictions: Vector) -> Number:
    """The roughest free body meets the roughest other one: no other pair is rougher."""
    order = sorted(range(len(frictions)), key=lambda n: -frictions[n])
    free = next((n for n in order if inverse_masses[n] > 0), None)
    other = next((n for n in order if n != free), None)
    if free is None or other is None:
        return 0
    return (frictions[free] * frictions[other]) ** 0.5


@alternative("10.1")
def with_a_table_of_products(inverse_masses: Vector, frictions: Vector) -> Number:
    """All pairs at once, in a table; those that never meet are crossed out."""
    import numpy as np

    products = np.outer(frictions, frictions)
    products[np.add.outer(inverse_masses, inverse_masses) == 0] = 0
    np.fill_diagonal(products, 0)
    return np.sqrt(products.max())


@alternative("10.2")
def asks_pair_by_pair(bodies: Table, gravity: Vector) -> Any:
    """Each pair says what it calls for, and then each body does; the order does not matter."""
    from itertools import combinations

    found = ["gravity"] if any(gravity) else []
    for one, other in combinations(bodies.tolist(), 2):
        if one[0] == other[0] == 0:
            continue
        if one[3] and other[3]:
            found += ["rotation", "friction"]
        if one[2] and other[2]:
            found.append("restitution")
    for inverse_mass, corners, _, _, w in bodies.tolist():
        if w or (inverse_mass and corners):
            found.append("rotation")
    return tuple(dict.fromkeys(found))


@alternative("10.2")
def asks_effect_by_effect(bodies: Table, gravity: Vector) -> Any:
    """For each effect a question to all pairs, or to all bodies."""
    m, corners, e, mu, w = bodies.T
    pairs = [(a, b) for a in range(len(m)) for b in range(a) if m[a] + m[b] > 0]
    rubs = any(mu[a] * mu[b] > 0 for a, b in pairs)
    bounces = any(e[a] * e[b] > 0 for a, b in pairs)
    turns = w.any() or corners[m > 0].any() or (m.any() and rubs)
    needed = {"friction": rubs, "gravity": any(gravity), "restitution": bounces, "rotation": turns}
    return [name for name in needed if needed[name]]


@alternative("10.3")
def by_the_energy_of_one(masses: Vector, velocities: Vector, dt: float) -> Number:
    """Body by body: as fast as it would be with all the energy."""
    energy = sum(m / 2 * abs(complex(*v)) ** 2 for m, v in zip(masses, velocities, strict=True))
    return max((2 * energy / m) ** 0.5 * dt for m in masses)


@alternative("10.3")
def in_units_of_the_lightest(masses: Vector, velocities: Vector, dt: float) -> Number:
    """The length of one long vector of velocities, each weighted by the root of its mass."""
    import numpy as np

    weights = np.sqrt(np.array(masses) / min(masses))
    return np.linalg.norm(weights[:, None] * np.array(velocities) * dt)


@alternative("10.4")
def with_the_time_clamped(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """The turning point, brought into the time: outside of it that is one of the ends."""
    import numpy as np

    with np.errstate(all="ignore"):
        turning = np.where(gravity == 0, 0.0, -velocity / gravity)
    times = np.array([np.zeros(2), np.clip(turning, 0, duration), np.full(2, duration)])
    places = position + velocity * times + gravity * times**2 / 2
    return np.transpose([places.min(axis=0) - radius, places.max(axis=0) + radius]).ravel()


@alternative("10.4")
def by_the_speed_at_the_end(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """Who ends with the other sign has turned back on the way, at x - v^2 / (2 g)."""
    sides = []
    for x, v, g in zip(position, velocity, gravity, strict=True):
        last = v + g * duration
        places = [x, x + (v + last) / 2 * duration]
        if v * last < 0:
            places.append(x - v * v / (2 * g))
        sides += [min(places) - radius, max(places) + radius]
    return tuple(sides)


@alternative("10.5")
def islands_by_name(inverse_masses: Vector, still: Vector, touches: Table) -> Any:
    """Each body takes the smallest name among those it touches, until nothing changes."""
    free = [n for n in range(len(still)) if inverse_masses[n] > 0]
    name = {n: n for n in free}
    for _ in free:
        for a in free:
            for b in free:
                if touches[a][b]:
                    name[a] = name[b] = min(name[a], name[b])
    restless = {name[n] for n in free if not still[n]}
    return [n for n in free if name[n] not in restless]


@alternative("10.5")
def powers_of_the_table(inverse_masses: Vector, still: Vector, touches: Table) -> Any:
    """The N-th power of the table says who can be reached in N steps or fewer."""
    import numpy as np

    free = np.array(inverse_masses) > 0
    joined = (np.array(touches) > 0) & free & free[:, None]
    count = len(free)
    near = (joined | np.eye(count, dtype=bool)).astype(float)
    reached = np.linalg.matrix_power(near, count) > 0
    disturbed = (reached & (np.array(still) == 0) & free).any(axis=1)
    return np.flatnonzero(free & ~disturbed)


@alternative("10.5")
def woken_by_their_neighbours(inverse_masses: Vector, still: Vector, touches: Table) -> Any:
    """Whoever touches one that is awake wakes up; again, until nobody does."""
    count = len(still)
    awake = [inverse_masses[n] > 0 and not still[n] for n in range(count)]
    changed = True
    while changed:
        changed = False
        for a in range(count):
            for b in range(count):
                if touches[a][b] and awake[a] and not awake[b] and inverse_masses[b] > 0:
                    awake[b] = changed = True
    return [n for n in range(count) if inverse_masses[n] > 0 and not awake[n]]

"""Unusual right answers to chapter 09: towers, sweeps, sliding tips, energy, rows of balls."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any
Number: TypeAlias = Any


@alternative("9.1")
def from_the_top_down(masses: Vector, gravity: float) -> Any:
    """What stands above is added up on the way down."""
    forces: list[float] = []
    above = 0.0
    for mass in reversed(list(masses)):
        above += mass
        forces.insert(0, above * gravity)
    return forces


@alternative("9.1")
def by_solving_equations(masses: Vector, gravity: float) -> Any:
    """Each box is at rest: the force from below less that from above is its weight."""
    import numpy as np

    count = len(masses)
    balance = np.eye(count) - np.eye(count, k=1)
    return np.linalg.solve(balance, np.asarray(masses) * gravity)


@alternative("9.2")
def halved_and_searched(light: float, heavy: float, left: float) -> Number:
    """A count that is enough is halved in until it is the least."""
    from math import exp, log1p

    shrinks = log1p(light / heavy)
    enough = 1
    while exp(-enough * shrinks) > left:
        enough *= 2
    too_few = 0
    while enough - too_few > 1:
        middle = (enough + too_few) // 2
        if exp(-middle * shrinks) > left:
            too_few = middle
        else:
            enough = middle
    return enough


@alternative("9.2")
def with_forty_digits(light: float, heavy: float, left: float) -> Number:
    """With more digits the school's logarithm is good enough."""
    from decimal import ROUND_CEILING, Decimal, localcontext

    with localcontext() as context:
        context.prec = 40
        part = Decimal(heavy) / (Decimal(heavy) + Decimal(light))
        return (Decimal(left).ln() / part.ln()).to_integral_value(ROUND_CEILING)


@alternative("9.3")
def two_linear_equations(vn: float, vt: float, knn: float, knt: float, friction: float) -> Number:
    """The velocity across the floor, and the cone: two equations for two impulses."""
    import numpy as np

    if vn >= 0:
        return 0.0
    side = np.sign(vt)
    jn, _ = np.linalg.solve([[knn, knt], [friction * side, 1.0]], [-vn, 0.0])
    return None if jn < 0 else jn


@alternative("9.3")
def cases_first(vn: float, vt: float, knn: float, knt: float, friction: float) -> Number:
    """Seen from the other side a slide to the left is one to the right."""
    if vt < 0:
        vt, knt = -vt, -knt
    if vn < 0 and friction * knt >= knn:
        return None
    return max(-vn, 0.0) / (knn - friction * knt) if vn < 0 else 0


@alternative("9.4")
def work_of_the_blow(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> Number:
    """The gain is the blow times the mean velocity of the point that it hits."""
    import numpy as np

    spin = np.array([-arm[1], arm[0]])
    before = mass * np.dot(velocity, velocity) / 2 + inertia * w**2 / 2
    point = velocity + w * spin
    changed = impulse / mass + spin * np.dot(spin, impulse) / inertia
    return 1 + np.dot(impulse, point + changed / 2) / before


@alternative("9.4")
def with_complex_numbers(
    mass: float, inertia: float, velocity: Vector, w: float, arm: Vector, impulse: Vector
) -> Number:
    """A vector is a complex number, and a torque the imaginary part of a product."""
    v, r, j = complex(*velocity), complex(*arm), complex(*impulse)
    energies = [
        mass * abs(v + s * j / mass) ** 2
        + inertia * (w + s * (r.conjugate() * j).imag / inertia) ** 2
        for s in (0, 1)
    ]
    return energies[1] / energies[0]


@alternative("9.5")
def by_the_impulse(masses: Vector, velocities: Vector) -> Any:
    """2 m_eff times the approach goes from one ball to the other."""
    v = list(velocities)
    while True:
        speed, k = max((v[k] - v[k + 1], -k) for k in range(len(v) - 1))
        if speed < 1e-9:
            return v
        left, right = -k, 1 - k
        j = 2 * speed / (1 / masses[left] + 1 / masses[right])
        v[left] -= j / masses[left]
        v[right] += j / masses[right]


@alternative("9.5")
def by_mirrors(masses: Vector, velocities: Vector) -> Any:
    """In the space of all velocities a strike is a mirror: its normal is the pair's."""
    import numpy as np

    pairs = np.diff(np.eye(len(masses)), axis=0)
    v = np.array(velocities, dtype=float)
    while np.min(pairs @ v) < -1e-9:
        g = pairs[np.argmin(pairs @ v)]
        v = v - 2 * (g @ v) / (g @ (g / masses)) * (g / masses)
    return v

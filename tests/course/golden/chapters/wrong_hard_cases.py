"""A common mistake in every task: hard cases."""

import math
import numpy as np


def tower_forces(masses, gravity):
    """Every contact carries the whole tower."""
    return np.full(len(masses), sum(masses) * gravity)


def sweeps_needed(light, heavy, left):
    """A sweep leaves m/(M + m)."""
    return math.ceil(-math.log(left) / math.log1p(heavy / light))


def sliding_impulse(vn, vt, knn, knt, friction):
    """Friction acts to the left."""
    if vn >= 0:
        return 0.0
    yields = knn - friction * knt
    return -vn / yields if yields > 0 else None


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    """The blow turns the body clockwise."""
    after = velocity + impulse / mass
    w_after = w - (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    before = mass * (velocity @ velocity) + inertia * w ** 2
    return float((mass * (after @ after) + inertia * w_after ** 2) / before)


def one_by_one(masses, velocities):
    """Elastic balls change velocities."""
    return np.sort(velocities)

"""A common mistake in every task: time of impact."""

import math
import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    """Whoever looks ten times in a step sees every hit."""
    for k in range(11):
        t = k / 10 * dt
        if np.hypot(*p2 + v2 * t - p1 - v1 * t) <= r1 + r2:
            return t
    return None


def time_to_floor(height, velocity, gravity):
    """Of two roots the smaller one is the first hit."""
    if gravity == 0:
        return height / -velocity if velocity < 0 else None
    return (velocity - math.sqrt(velocity ** 2 + 2 * gravity * height)) / gravity


def advance(p, v, room, restitution, dt):
    """There is one impact in a step at the most."""
    times = [((s if u > 0 else 0) - x) / u for x, u, s in zip(p, v, room, strict=True)]
    axis = int(np.argmin(times))
    if times[axis] >= dt:
        return (p + v * dt, v)
    after = np.where(np.arange(2) == axis, -restitution * v, v)
    return (p + v * times[axis] + after * (dt - times[axis]), after)


def next_event(positions, velocities, radii):
    """The first pair that will meet is the one that meets first."""
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            d, v, r = (positions[j] - positions[i], velocities[j] - velocities[i], radii[i] + radii[j])
            a, b, c = (v @ v, d @ v, d @ d - r * r)
            if b < 0 <= b * b - a * c:
                return (max(c, 0.0) / (-b + math.sqrt(b * b - a * c)), i, j)
    return None


def pi_collisions(mass_ratio):
    """A collision takes two blocks."""
    light, heavy, count = (0.0, -1.0, 0)
    while light > heavy:
        centre = (light + mass_ratio * heavy) / (1 + mass_ratio)
        light, heavy, count = (abs(2 * centre - light), 2 * centre - heavy, count + 1)
    return count

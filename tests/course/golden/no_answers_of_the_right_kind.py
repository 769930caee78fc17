"""Each answer is something else than what was asked for."""

import math

import numpy as np


def restitution_1d(v1, v2, v1_after, v2_after):
    return math.nan


def collide_1d(m1, v1, m2, v2, restitution):
    return None


def bounce_heights(height, restitution, count):
    heights = [height * restitution ** (2 * n) for n in range(1, count + 1)]
    return np.reshape(heights, (-1, 1))


def rest_time(height, restitution, gravity):
    return {"time": (2 * height / gravity) ** 0.5 * (1 + restitution) / (1 - restitution)}

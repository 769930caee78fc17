"""Unusual right answers to Newton's cradle."""

from __future__ import annotations

import cmath
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.cradle.rules import GRAVITY
from lesson_code.course.grading.task import alternative

Vector: TypeAlias = Any


@alternative("C.1")
def in_the_frame_of_each_pair(masses: Vector, velocities: Vector, restitution: float) -> Any:
    """Seen from the pair's centre of mass, both turn round and keep e of their speed."""
    v = [float(value) for value in velocities]
    while True:
        pairs = [k for k in range(len(v) - 1) if v[k] - v[k + 1] > 1e-12]
        if not pairs:
            return v
        k = pairs[0]
        whole = masses[k] + masses[k + 1]
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / whole
        v[k : k + 2] = [centre - restitution * (speed - centre) for speed in v[k : k + 2]]


@alternative("C.2")
def sine_from_a_complex_number(angle: float, rate: float, length: float, dt: float) -> Any:
    """The sine is the imaginary part of exp(i angle); the answer is an array."""
    pull = -GRAVITY * cmath.exp(1j * angle).imag / length
    after = rate + pull * dt
    return np.array([angle + after * dt, after])


@alternative("C.3")
def swap_by_swap(angles: Vector, rates: Vector, length: float, dt: float, steps: float) -> Any:
    """The row is gone through as often as there are balls: no swap needs more."""
    for _ in range(int(steps)):
        rates = rates - GRAVITY / length * np.sin(angles) * dt
        angles = angles + rates * dt
        for k in len(angles) * [*range(len(angles) - 1)]:
            if angles[k] >= angles[k + 1] and rates[k] > rates[k + 1]:
                rates[[k, k + 1]] = rates[[k + 1, k]]
    return angles, rates


@alternative("C.3")
def all_balls_at_once(angles: Vector, rates: Vector, length: float, dt: float, steps: float) -> Any:
    """Equal balls that touch end with their rates sorted: that is what all the swaps do."""
    for _ in range(int(steps)):
        rates = rates - GRAVITY / length * np.sin(angles) * dt
        angles = angles + rates * dt
        begin = 0
        for end in range(1, len(angles) + 1):
            if end == len(angles) or angles[end - 1] < angles[end]:
                rates[begin:end] = np.sort(rates[begin:end])
                begin = end
    return angles, rates

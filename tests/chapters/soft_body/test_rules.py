"""The rules of the soft bodies: laws, limits and answers that do not come from their own lines."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest
from shapely.geometry import Polygon as ShapelyPolygon

from lesson_code.chapters.soft_body.rules import BLOB, drop, pressure_forces, ring_area, ring_forces

ROUNDING = 1e-12
"""Relative: sums of a few dozen numbers of like size."""

DIFFERENCE, SLOPE = 1e-6, 1e-6
"""m: step of a numerical derivative. N: how exact it is then, for energies of 100 J at 1e-16."""


def uneven_ring() -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Return a ring of seven with no two edges alike."""
    stream = Random(5)  # noqa: S311 - a test
    turns = [2 * math.pi * k / 7 + stream.uniform(-0.2, 0.2) for k in range(7)]
    return np.array([(1.3 * math.cos(t), 0.8 * math.sin(t)) for t in turns])


def test_ring_area_is_shapelys() -> None:
    """Counter-clockwise positive, clockwise negative."""
    ring = uneven_ring()
    assert ring_area(ring) == pytest.approx(ShapelyPolygon(ring).area, rel=ROUNDING)
    assert ring_area(ring[::-1]) == pytest.approx(-ring_area(ring), rel=ROUNDING)


def test_ring_forces_are_the_slope_of_the_springs_energy() -> None:
    """F = -dE/dx with E = sum k (d - l)^2 / 2; and they add up to nothing."""
    ring = uneven_ring()
    forces = ring_forces(ring, np.zeros_like(ring), 0.5, 40.0, 3.0)

    def energy(places: np.ndarray[tuple[int, int], np.dtype[np.float64]]) -> float:
        edges = np.roll(places, -1, axis=0) - places
        return float(20.0 * ((np.hypot(edges[:, 0], edges[:, 1]) - 0.5) ** 2).sum())

    for k in range(7):
        for axis in (0, 1):
            shift = np.zeros_like(ring)
            shift[k, axis] = DIFFERENCE
            slope = (energy(ring + shift) - energy(ring - shift)) / (2 * DIFFERENCE)
            assert forces[k, axis] == pytest.approx(-slope, abs=SLOPE)
    assert forces.sum(axis=0) == pytest.approx([0.0, 0.0], abs=1e-12)


def test_ring_damping_leaves_rotation_and_flight_alone() -> None:
    """A ring that flies or turns as a rigid body feels none of it."""
    ring = uneven_ring()
    rigid = np.column_stack([2.0 - 3.0 * ring[:, 1], 1.0 + 3.0 * ring[:, 0]])
    moving = ring_forces(ring, rigid, 0.5, 40.0, 3.0)
    still = ring_forces(ring, np.zeros_like(ring), 0.5, 40.0, 3.0)
    assert moving == pytest.approx(still, abs=1e-12)


def test_pressure_is_the_slope_of_the_gas_energy() -> None:
    """F = pressure dA/dx: the work of a gas is pressure times the change of area."""
    ring = uneven_ring()
    forces = pressure_forces(ring, 3.0, 50.0)
    pressure = 50.0 * (3.0 / ShapelyPolygon(ring).area - 1)
    for k in range(7):
        for axis in (0, 1):
            shift = np.zeros_like(ring)
            shift[k, axis] = DIFFERENCE
            larger, smaller = (ShapelyPolygon(ring + s * shift).area for s in (1, -1))
            slope = (larger - smaller) / (2 * DIFFERENCE)
            assert forces[k, axis] == pytest.approx(pressure * slope, abs=SLOPE)


def test_drop_keeps_its_area_within_five_percent_and_comes_to_rest() -> None:
    """From 1.5 m: never more than 5 % off, never below the floor, at rest after five seconds."""
    turns = 2 * np.pi * np.arange(12) / 12
    ring = 0.7 * np.column_stack([np.cos(turns), np.sin(turns)]) + np.array([0.0, 1.5])
    area, edge = ring_area(ring), float(np.hypot(*(ring[1] - ring[0])))
    positions, velocities = ring, np.zeros_like(ring)
    for _ in range(150):
        positions, velocities = drop(positions, velocities, edge, area, 20)
        assert abs(ring_area(positions) / area - 1) < 0.05
        assert positions[:, 1].min() >= 0.0
    assert BLOB.mass * (velocities**2).sum() / 2 < 1e-3

"""The rules of the challenges: laws, limits and answers that do not come from their own lines."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random

import numpy as np
import pytest
from shapely.geometry import Point
from shapely.geometry import Polygon as ShapelyPolygon

from lesson_code.chapters.asteroids.rules import collide_all, fire, split, wrap
from lesson_code.chapters.breakout.rules import STEEPEST, brick_impact, fly, paddle_bounce
from lesson_code.chapters.cradle.rules import GRAVITY, collide_row, cradle, on_circle, swing_step
from lesson_code.chapters.dominoes.rules import chain, tipping_angle, toppling_rate
from lesson_code.chapters.pool.rules import ROLLING, rack, roll, share_impact, strike
from lesson_code.chapters.soft_body.rules import BLOB, drop, pressure_forces, ring_area, ring_forces

ROUNDING = 1e-12
"""Relative: sums of a few dozen numbers of like size."""

DIFFERENCE, SLOPE = 1e-6, 1e-6
"""m: step of a numerical derivative. N: how exact it is then, for energies of 100 J at 1e-16."""

ROOT = 1e-9
"""Relative: of places that shapely computes again."""


# Pool


def test_rack_neighbours_are_a_diameter_and_a_gap_apart() -> None:
    """In a triangle of five rows 30 pairs touch, and all others are farther apart."""
    places = rack((1.0, 2.0), 0.5, 0.1)
    distances = sorted(math.dist(p, q) for k, p in enumerate(places) for q in places[:k])
    assert distances[:30] == pytest.approx([1.1] * 30, rel=ROUNDING)
    assert distances[30] > 1.5


def test_strike_keeps_momentum_and_angular_momentum() -> None:
    """M v is the impulse, and I w its moment about the centre."""
    velocity, spin = strike((0.3, 0.4), 0.01, 0.17, 0.03)
    assert np.array(velocity) * 0.17 == pytest.approx([0.3, 0.4], rel=ROUNDING)
    arm = 0.01 * np.array([-0.8, 0.6])  # to the left of (0.6, 0.8)
    moment = arm[0] * 0.4 - arm[1] * 0.3
    assert 0.4 * 0.17 * 0.03**2 * spin == pytest.approx(moment, rel=ROUNDING)


def test_roll_stops_after_the_way_that_friction_leaves() -> None:
    """A ball of 1 m/s rolls v^2 / (2 mu g) far, to within the way of one step, and then lies."""
    velocity, way, dt = (1.0, 0.0), 0.0, 1e-3
    for _ in range(20_000):
        velocity, _ = roll(velocity, 0.0, 0.03, dt)
        way += velocity[0] * dt
    assert velocity == (0.0, 0.0)
    assert way == pytest.approx(1 / (2 * ROLLING * GRAVITY), abs=dt)


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_share_impact_keeps_momentum_and_never_gains_energy(restitution: float) -> None:
    """A ball comes into a rack at an angle."""
    places = [(-0.06, 0.0), *rack((0.0, 0.0), 0.03, 0.0)]
    before = np.zeros((16, 2))
    before[0] = (3.0, 1.0)
    after = share_impact(places, before, 0.03, restitution)
    assert after.sum(axis=0) == pytest.approx([3.0, 1.0], rel=ROUNDING)
    assert (after**2).sum() <= 10.0


def test_share_impact_of_balls_that_do_not_touch_changes_nothing() -> None:
    """A gap of a hundredth of a radius is no contact."""
    before = np.array([[1.0, 0.0], [0.0, 0.0]])
    assert (share_impact([(0, 0), (2.01, 0)], before, 1.0, 1.0) == before).all()


# Newton's cradle


@pytest.mark.parametrize("count", [1, 3, 7])
def test_collide_row_k_balls_in_k_balls_out(count: int) -> None:
    """Equal, elastic balls: as many leave as came in, at their speed."""
    for k in range(1, count + 1):
        speeds = [2.0] * k + [0.0] * (count - k)
        assert collide_row([1.5] * count, speeds, 1.0) == speeds[::-1]


def test_collide_row_keeps_momentum_and_ends_in_order() -> None:
    """Unequal masses with losses: afterwards nothing approaches."""
    masses, before = [1.0, 3.0, 0.5, 2.0], [4.0, 1.0, 0.0, -2.0]
    after = collide_row(masses, before, 0.8)
    assert np.dot(masses, after) == pytest.approx(np.dot(masses, before), rel=ROUNDING)
    assert all(left <= right + 1e-12 for left, right in pairwise(after))


def test_swing_step_small_swings_have_the_period_of_the_pendulum() -> None:
    """After 2 pi sqrt(l/g), in steps of a 10,000th of it, the ball is where it was."""
    length, start = 2.0, 1e-3
    period = 2 * math.pi * math.sqrt(length / GRAVITY)
    state = (start, 0.0)
    for _ in range(10_000):
        state = swing_step(*state, length, period / 10_000)
    assert state[0] == pytest.approx(start, rel=1e-6)


@pytest.mark.parametrize("pulled", [1, 2, 3, 4])
def test_cradle_k_balls_in_k_balls_out(pulled: int) -> None:
    """Half a period later, and half a period after that, just so many are out on that side."""
    out = 0.4
    angles = [-out] * pulled + [0.0] * (5 - pulled)
    half = math.pi * math.sqrt(1.0 / GRAVITY) * (1 + out**2 / 16)  # for swings of this size
    for side, steps in ((1, round(half * 2000)), (-1, round(2 * half * 2000))):
        found, _ = cradle(angles, [0.0] * 5, 1.0, 1 / 2000, steps)
        assert sum(side * angle > 0.9 * out for angle in found) == pulled
        assert sum(abs(angle) < 0.1 * out for angle in found) == 5 - pulled


def test_on_circle_the_string_does_no_work() -> None:
    """The ball is on its circle, and moves along it as fast as it did along it before."""
    place, velocity = on_circle((3.0, -4.2), (1.0, 2.0), (0.0, 0.0), 5.0)
    assert math.hypot(*place) == pytest.approx(5.0, rel=ROUNDING)
    assert place[0] * velocity[0] + place[1] * velocity[1] == pytest.approx(0.0, abs=ROUNDING)
    tangent = np.array([4.2, 3.0]) / math.hypot(3.0, 4.2)
    assert np.dot(velocity, tangent) == pytest.approx(np.dot((1.0, 2.0), tangent), rel=ROUNDING)


# Breakout


def test_paddle_bounce_keeps_the_speed_and_is_clamped() -> None:
    """Up in the middle, 60 degrees at the ends and beyond."""
    assert paddle_bounce(0.0, 3.0) == (0.0, 3.0)
    for offset in (-2.0, -1.0, 0.4, 1.0, 7.0):
        x, y = paddle_bounce(offset, 3.0)
        assert math.hypot(x, y) == pytest.approx(3.0, rel=ROUNDING)
        clamped = min(max(offset, -1.0), 1.0)
        assert math.atan2(x, y) == pytest.approx(clamped * STEEPEST, rel=ROUNDING)


def test_brick_impact_touches_when_it_says_so() -> None:
    """At the time of impact the brick is a radius away, along the normal; before, farther."""
    stream, hits = Random(1), 0  # noqa: S311 - a test
    brick = (0.0, 0.0, 2.0, 1.0)
    outline = ShapelyPolygon([(0, 0), (2, 0), (2, 1), (0, 1)])
    for _ in range(200):
        start = np.array([stream.uniform(-3, 5), -2.0])
        velocity = np.array([stream.uniform(-2, 2), 4.0])
        hit = brick_impact(start, velocity, 0.3, brick)
        if hit is None:
            continue
        hits += 1
        time, normal = hit
        assert outline.distance(Point(start + velocity * time)) == pytest.approx(0.3, rel=ROOT)
        assert outline.distance(Point(start + velocity * 0.9 * time)) > 0.3
        foot = start + velocity * time - 0.3 * np.array(normal)
        assert outline.exterior.distance(Point(foot)) < 1e-9
    assert hits > 50


@pytest.mark.parametrize("speed", [1.0, 1e3, 1e6, 1e9])
def test_fly_no_ball_passes_through_a_brick_at_any_speed(speed: float) -> None:
    """The brick breaks and the ball comes back below it."""
    brick = (0.0, 1.0, 2.0, 0.01)
    duration = min(1.0, 10.0 / speed)
    place, velocity, broken = fly((1.0, 0.2), (0.0, speed), 0.1, [brick], duration)
    assert broken == [0]
    assert velocity == (0.0, -speed)
    assert place[1] == pytest.approx(0.2 + 0.7 - (duration * speed - 0.7), rel=ROOT)


# Dominoes


def test_toppling_rate_just_takes_a_domino_over_its_edge() -> None:
    """A rod and a plate fall with 1 % more and stand with 1 % less, in small steps."""
    for width, height in ((0.1, 0.6), (0.3, 0.5)):
        for factor, falls in ((1.01, True), (0.99, False)):
            assert topples(width, height, factor * toppling_rate(width, height)) is falls


def topples(width: float, height: float, rate: float) -> bool:
    """Return whether a domino passes its tipping angle, by following it in time."""
    inertia = (width**2 + height**2) / 3
    half, angle, dt = math.hypot(width, height) / 2, 0.0, 1e-4
    while angle >= 0.0:
        lever = half * math.sin(tipping_angle(width, height) - angle)
        rate -= 9.81 * lever / inertia * dt
        angle += rate * dt
        if angle > tipping_angle(width, height):
            return True
    return False


def test_chain_every_domino_falls_and_in_order() -> None:
    """Each leans before the one after it does, and in the end all lie."""
    state = ([0.0] * 8, [1.0] + [0.0] * 7)
    order: list[int] = []
    for _ in range(800):
        state = chain(*state, 0.6, 0.3, 1 / 240, 1)
        order += [k for k, angle in enumerate(state[0]) if angle > 0.6 and k not in order]
    assert order == list(range(8))
    assert state[0] == [math.pi / 2] * 8


def test_chain_too_far_apart_stops() -> None:
    """Nobody pushes a row that stands."""
    assert chain([0.0] * 3, [0.0] * 3, 0.6, 0.3, 0.01, 500)[0] == [0.0] * 3


# Asteroids


def test_split_keeps_momentum_and_flies_apart() -> None:
    """Whatever the masses: the sum is the asteroid's, the differences are as asked for."""
    masses = np.array([1.0, 2.5, 4.0])
    pieces = split((0.3, -0.7), masses, 2.0, 0.4)
    assert masses @ pieces == pytest.approx(masses.sum() * np.array([0.3, -0.7]), rel=ROUNDING)
    sides = [math.dist(pieces[k], pieces[k - 1]) for k in range(3)]
    assert sides == pytest.approx([2 * math.sqrt(3)] * 3, rel=ROUNDING)


def test_fire_keeps_momentum_and_the_muzzle_speed() -> None:
    """Ship and shot together as before; apart at the muzzle speed."""
    ship, shot = fire((1.0, 2.0), 5.0, 0.4, 7.0, 2.0)
    assert 5.0 * ship + 0.4 * shot == pytest.approx([5.4, 10.8], rel=ROUNDING)
    assert shot - ship == pytest.approx([7 * math.cos(2), 7 * math.sin(2)], rel=ROUNDING)


def test_collide_all_keeps_momentum_and_the_energy_of_elastic_bodies() -> None:
    """Nine in a crowd."""
    stream = Random(3)  # noqa: S311 - a test
    places = [(1.4 * (k % 3), 1.4 * (k // 3)) for k in range(9)]
    before = np.array([[stream.uniform(-3, 3) for _ in range(2)] for _ in range(9)])
    masses = np.array([stream.uniform(0.5, 5) for _ in range(9)])
    after = collide_all(places, before, masses, [0.8] * 9, 1.0)
    assert (after != before).any()
    assert masses @ after == pytest.approx(masses @ before, rel=1e-11)
    energies = [masses @ (v**2).sum(axis=1) for v in (before, after)]
    assert energies[1] == pytest.approx(energies[0], rel=ROUNDING)


def test_wrap_joins_the_edges() -> None:
    """Inside nothing changes; outside the other side is meant."""
    assert wrap((3.0, 2.0), (8.0, 6.0), 0.5) == (3.0, 2.0)
    assert wrap((-0.4, 6.4), (8.0, 6.0), 0.5) == (-0.4, 6.4)  # a part of it is still seen
    assert wrap((-0.6, 6.6), (8.0, 6.0), 0.5) == (8.5, -0.5)


# Soft bodies


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


def test_several_rings_at_once_are_each_alone() -> None:
    """Areas and pressure forces of many rings are, to the last bit, those of one after another."""
    rings = np.random.default_rng(8).uniform(1, 2, (3, 16, 2))
    areas = np.array([0.2, 0.3, 0.4])
    assert ring_area(rings).tolist() == [ring_area(ring) for ring in rings]
    together = pressure_forces(rings, areas, 50.0)
    for ring, area, forces in zip(rings, areas, together, strict=True):
        assert (pressure_forces(ring, area, 50.0) == forces).all()


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

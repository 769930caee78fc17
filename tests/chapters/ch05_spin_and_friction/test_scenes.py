"""A body on a slope, in both engines, against the closed forms; and a disc at a wall."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lesson_code import Circle, Polygon
from lesson_code.chapters.ch05_spin_and_friction import wrong_answers as wrong
from lesson_code.chapters.ch05_spin_and_friction.scenes import (
    acceleration,
    block_in_steps,
    coulomb,
    hit_wall,
    on_slope,
    tipping_angle,
)
from lesson_code.evidence.scenes.slopes import GRAVITY
from lesson_code.evidence.scenes.spinning_discs import Disc, hit
from lesson_code.reference import rigid_body_closed_forms as closed

ENGINES = ("sequential", "pymunk")

EXACT = 1e-9
"""m/s^2. One contact, or two that agree: measured 6e-14, and 2.3e-9 for pymunk's box."""

PYMUNK_BOX = 1e-4
"""m/s^2: pymunk's box creeps at its default of 10 iterations; measured 7e-5."""

TEN_SWEEPS = 0.3
"""Degrees that ten sweeps are off at the edge of tipping; measured 0.23 for ours."""

FIFTY_SWEEPS = 0.02
"""Degrees, and the interval is halved down to 0.01."""

BOX = Polygon([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)])


@pytest.mark.parametrize("solver", ENGINES)
@pytest.mark.parametrize("friction", [0.0, 0.05, 0.12, 0.13, 0.5])
def test_disc_rolls_or_slips_as_the_closed_form_says(friction: float, solver: str) -> None:
    """At 20 degrees the edge between the two is a third of tan 20 degrees, 0.1213."""
    expected, _ = closed.roll_down(math.radians(20), 1 / 2, friction, GRAVITY)
    assert abs(acceleration(Circle(0.5), 20, friction, solver) - expected) <= EXACT


@pytest.mark.parametrize(("solver", "bound"), [("sequential", EXACT), ("pymunk", PYMUNK_BOX)])
@pytest.mark.parametrize("friction", [0.0, 0.2, 0.57, 0.58, 0.8])
def test_box_stays_or_slides_as_the_closed_form_says(
    friction: float, solver: str, bound: float
) -> None:
    """At 30 degrees the edge between the two is tan 30 degrees, 0.5774."""
    expected = closed.slide_down(math.radians(30), friction, GRAVITY)
    assert abs(acceleration(BOX, 30, friction, solver) - expected) <= bound


@pytest.mark.parametrize("solver", ENGINES)
@pytest.mark.parametrize(("iterations", "bound"), [(10, TEN_SWEEPS), (50, FIFTY_SWEEPS)])
def test_box_tips_where_its_centre_leaves_its_base(
    solver: str, iterations: int, bound: float
) -> None:
    """Half as wide as high: atan 1/2, 26.565 degrees."""
    found = tipping_angle(0.5, 1.0, solver=solver, iterations=iterations)
    assert abs(found - math.degrees(closed.tipping_angle(0.5, 1.0))) <= bound


def test_body_begins_on_the_slope_at_rest() -> None:
    """Its lowest point touches, and nothing moves."""
    for shape, height in ((Circle(0.7), 0.7), (BOX, 0.25)):
        run = on_slope(shape, degrees=10, friction=0.5, duration=0.0)
        assert run.positions[0, 1].tolist() == [0.0, height]
        assert run.velocities[0, 1].tolist() == [0.0, 0.0]


@pytest.mark.parametrize(("degrees", "friction"), [(30, 0.0), (30, 0.3), (10, 0.5), (0, 0.0)])
def test_block_in_steps_slides_as_the_closed_form_says(degrees: float, friction: float) -> None:
    """After n steps of a constant acceleration a it is at a dt^2 n (n + 1)/2."""
    a = closed.slide_down(math.radians(degrees), friction, GRAVITY)
    expected = a * (1 / 240) ** 2 * 480 * 481 / 2
    found = block_in_steps(coulomb, degrees, friction, duration=2.0)
    assert found == pytest.approx(expected, abs=EXACT)


def test_dead_band_creeps_and_no_clamp_holds_on_ice() -> None:
    """In the dead band nothing holds a block that should stay; without the clamp ice holds one.

    At 5 degrees a step adds 3.56 mm/s: two of three steps are below 10 mm/s, and add up to
    3 * 3.56 mm/s of way in three steps.
    """
    gained = GRAVITY * math.sin(math.radians(5)) / 240
    crept = block_in_steps(wrong.dead_band, 5, 0.5, duration=10.0)
    assert crept == pytest.approx(800 * 3 * gained / 240, abs=EXACT)
    assert block_in_steps(wrong.without_clamp, 30, 0.05, duration=10.0) == 0.0


def test_hit_wall_is_the_limit_of_a_heavy_disc() -> None:
    """A disc of 1e9 kg is a wall to one of 1 kg, but for a part of 1e-9."""
    disc = Disc(1.0, 0.5, np.array([0.0, 0.5]), np.array([3.0, -4.0]), 2.0)
    heavy = Disc(1e9, 1.0, np.array([0.0, -1.0]), np.zeros(2))
    n = np.array([0.0, 1.0])
    at_wall, on_heavy = hit_wall(disc, n, 0.5, 0.2), hit(heavy, disc, n, 0.5, 0.2)[1]
    assert at_wall.velocity == pytest.approx(on_heavy.velocity, abs=1e-7)
    assert at_wall.angular_velocity == pytest.approx(on_heavy.angular_velocity, abs=1e-7)

"""A ball against a wall: reflect, bounce and the wall's normal against pymunk's segments.

The cases are built backwards. The place of the contact is chosen first: a closest point on the
wall, a normal and a depth. The ball is then put where it was one step earlier, so that pymunk,
which moves before it collides, meets it there. The normal of the construction is a third
answer beside pymunk's and ours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code.formulas import bounce, reflect
from lesson_code.geometry import circle_against_segment
from lesson_code.reference.pymunk_reference import SegmentBounce, bounce_off_segment

CASES = share(2_000)
SEED = 20_240_301
REGIONS = ["left side", "right side", "start", "end"]

ROUNDING = 1e-9
"""For normals, and for velocities in units of the speed. A normal is read off a distance of
down to 0.005 m between places with coordinates of up to 40 m, rounded to 4e-15 m: that makes
1e-12; measured: 4e-13. The rest is margin for other processors."""

NEAR_MISS = 1e-9
"""m: the smallest gap tested: a million times the rounding of places 40 m away."""

STEPS = [1e-9, 1 / 60]
"""s: with the long step the ball is up to 1.7 m away before it moves: a comparison at the
positions before the move would fail."""


@dataclass(frozen=True)
class Hit:
    """One ball at one wall, at the instant at which the contact is resolved."""

    position: Any
    velocity: Any
    radius: float
    start: Any
    end: Any
    half_thickness: float
    restitution: float
    friction: float
    normal: Any
    depth: float

    def in_pymunk(self, dt: float) -> SegmentBounce:
        """Return pymunk's answer; the ball starts one step earlier."""
        return bounce_off_segment(
            self.position - self.velocity * dt,
            self.velocity,
            self.radius,
            self.start,
            self.end,
            self.half_thickness,
            self.restitution,
            self.friction,
            dt,
        )

    def contact_at(self, position: Any) -> tuple[Any, float] | None:
        """Return our contact of the ball at a given place with this wall."""
        return circle_against_segment(
            position, self.radius, self.start, self.end, self.half_thickness
        )


def random_hit(
    rng: np.random.Generator, region: str, depth: float | None = None, **fixed: float
) -> Hit:
    """Return a random ball that overlaps a random wall, pushed away in the given region."""
    along = _unit(rng.uniform(-math.pi, math.pi))
    start, length = rng.uniform(-10, 10, 2), 10 ** rng.uniform(-1, 1.3)
    radius, half_thickness = 10 ** rng.uniform(-1, 0.7), rng.choice([0.0, rng.uniform(0, 2)])
    closest, normal = _closest_and_normal(rng, region, start, along, length)
    reach = radius + half_thickness
    depth = reach * rng.uniform(0.001, 0.95) if depth is None else depth
    return Hit(
        position=closest + (reach - depth) * normal,
        velocity=rng.uniform(0, 100) * _unit(rng.uniform(-math.pi, math.pi)),
        radius=radius,
        start=start,
        end=start + length * along,
        half_thickness=half_thickness,
        restitution=fixed.get("restitution", rng.uniform(0, 1)),
        friction=fixed.get("friction", rng.choice([0.0, rng.uniform(0, 2)])),
        normal=normal,
        depth=depth,
    )


def _closest_and_normal(
    rng: np.random.Generator, region: str, start: Any, along: Any, length: float
) -> tuple[Any, Any]:
    """Return a point of the wall and a direction in which the ball may lie from it."""
    left = np.array([-along[1], along[0]])
    if region.endswith("side"):
        return (
            start + rng.uniform(0, 1) * length * along,
            left if region == "left side" else -left,
        )
    turn = rng.uniform(-math.pi / 2, math.pi / 2)
    outward = along if region == "end" else -along
    closest = start + length * along if region == "end" else start
    return closest, math.cos(turn) * outward + math.sin(turn) * left


def _unit(angle: float) -> Any:
    return np.array([math.cos(angle), math.sin(angle)])


def hits(region: str, count: int = CASES, **fixed: float) -> list[Hit]:
    """Return the table of cases for one region."""
    rng = np.random.default_rng([SEED, REGIONS.index(region)])
    return [random_hit(rng, region, **fixed) for _ in range(count)]


def normal_errors(hit: Hit, result: SegmentBounce) -> tuple[float, float]:
    """Return how far our normal at the moved position is from pymunk's and from the built one."""
    contact = hit.contact_at(result.moved_position)
    assert contact is not None
    assert result.normal is not None
    return math.dist(contact[0], result.normal), math.dist(contact[0], hit.normal)


def velocity_error(hit: Hit, result: SegmentBounce, *, mirror: bool = False) -> float:
    """Return how far our velocity after is from pymunk's, in units of the speed."""
    contact = hit.contact_at(result.moved_position)
    assert contact is not None
    ours = (
        reflect(hit.velocity, contact[0])
        if mirror
        else bounce(hit.velocity, contact[0], hit.restitution, hit.friction)
    )
    return math.dist(ours, result.velocity) / math.hypot(*hit.velocity)


@pytest.mark.parametrize("dt", STEPS, ids=["short step", "long step"])
@pytest.mark.parametrize("region", REGIONS)
def test_normal_random_walls_equal_pymunk_and_construction(region: str, dt: float) -> None:
    """The wall's normal at the moved position is pymunk's, on both sides and at both ends."""
    errors = [normal_errors(hit, hit.in_pymunk(dt)) for hit in hits(region)]
    assert np.max(errors) < ROUNDING


@pytest.mark.parametrize("region", REGIONS)
def test_penetration_random_walls_equals_construction(region: str) -> None:
    """The penetration is the depth that the case was built with."""
    for hit in hits(region):
        contact = hit.contact_at(hit.position)
        assert contact is not None
        assert contact[1] == pytest.approx(hit.depth, abs=ROUNDING)


@pytest.mark.parametrize("dt", STEPS, ids=["short step", "long step"])
@pytest.mark.parametrize("region", REGIONS)
def test_velocity_random_bounce_equals_pymunk(region: str, dt: float) -> None:
    """Bounce is pymunk's answer for any restitution and friction, approaching or parting."""
    errors = [velocity_error(hit, hit.in_pymunk(dt)) for hit in hits(region)]
    assert max(errors) < ROUNDING


@pytest.mark.parametrize("region", REGIONS)
def test_velocity_elastic_approach_is_reflected_as_in_pymunk(region: str) -> None:
    """With e = 1 and no friction pymunk makes of an approach what a mirror does."""
    table = [
        hit for hit in hits(region, restitution=1.0, friction=0.0) if hit.velocity @ hit.normal < 0
    ]
    errors = [velocity_error(hit, hit.in_pymunk(STEPS[0]), mirror=True) for hit in table]
    assert len(table) > 0.4 * CASES
    assert max(errors) < ROUNDING


@pytest.mark.parametrize("region", REGIONS)
def test_velocity_parting_ball_is_left_alone_as_in_pymunk(region: str) -> None:
    """A ball that overlaps but already parts keeps its velocity to the last bit, in both."""
    for hit in hits(region, count=500):
        if hit.velocity @ hit.normal > 0:
            result = hit.in_pymunk(STEPS[0])
            assert result.normal is not None
            np.testing.assert_array_equal(result.velocity, hit.velocity)
            ours = bounce(hit.velocity, result.normal, hit.restitution, hit.friction)
            np.testing.assert_array_equal(ours, hit.velocity)


@pytest.mark.parametrize("depth", [NEAR_MISS, -NEAR_MISS], ids=["just overlapping", "just apart"])
@pytest.mark.parametrize("region", REGIONS)
def test_contact_near_miss_is_decided_as_in_pymunk(region: str, depth: float) -> None:
    """A nanometre of overlap is a contact, a nanometre of gap is none; there v is unchanged."""
    rng = np.random.default_rng(SEED)
    for _ in range(500):
        hit = random_hit(rng, region, depth)
        result = hit.in_pymunk(STEPS[0])
        contact = hit.contact_at(result.moved_position)
        assert (contact is None) == (result.normal is None)
        if contact is None:
            np.testing.assert_array_equal(result.velocity, hit.velocity)


@settings(derandomize=True, deadline=None)
@given(
    region=st.sampled_from(REGIONS),
    seed=st.integers(0, 2**32 - 1),
    restitution=st.floats(0, 1),
    friction=st.floats(0, 10),
)
def test_velocity_any_coefficients_equal_pymunk(
    region: str, seed: int, restitution: float, friction: float
) -> None:
    """Hypothesis looks for coefficients, the limits 0 and 1 among them, that make a difference."""
    rng = np.random.default_rng(seed)
    hit = random_hit(rng, region, restitution=restitution, friction=friction)
    assert velocity_error(hit, hit.in_pymunk(STEPS[0])) < ROUNDING

"""What pymunk does, measured on the installed version: an upgrade that changes it fails here.

The cross-validations stand on these conventions. They are about pymunk, not about the lesson;
nothing here imports the lesson's code. Sources named are files of Munk2D, pymunk's solver.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pymunk
import pytest

ROUNDING = 1e-14
"""A few roundings of velocities and positions of size 1 to 10."""

TINY_STEP = 1e-9
"""s: positions move by a few nanometres, so that they may be read as unmoved."""

TURNED = 1e-7
"""Moving for TINY_STEP at a few m/s turns the normal by some 1e-9; energies of 10 J feel that."""

FIRST, SECOND = 1, 2
"""Collision types of the first and second shape."""


@dataclass
class Pair:
    """Two discs of radius 1 m in a space of their own, and what their contacts were like."""

    distance: float = 1.99
    velocities: tuple[tuple[float, float], tuple[float, float]] = ((2.0, 0.0), (-1.0, 0.0))
    masses: tuple[float, float] = (1.0, 3.0)
    moments: tuple[float, float] = (math.inf, math.inf)
    elasticities: tuple[float, float] = (0.7, 1.0)
    frictions: tuple[float, float] = (0.0, 0.0)
    second_added_first: bool = False
    handler: tuple[int | None, int | None] = (FIRST, SECOND)
    contacts: list[dict[str, Any]] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Build the space: the first disc at the origin, the second to its right."""
        self.space = pymunk.Space()
        self.bodies = [pymunk.Body(self.masses[i], self.moments[i]) for i in (0, 1)]
        self.shapes = [pymunk.Circle(body, 1.0) for body in self.bodies]
        for i in (0, 1):
            self.bodies[i].position = (i * self.distance, 0.0)
            self.bodies[i].velocity = self.velocities[i]
            self.shapes[i].elasticity = self.elasticities[i]
            self.shapes[i].friction = self.frictions[i]
            self.shapes[i].collision_type = (FIRST, SECOND)[i]
        for i in (1, 0) if self.second_added_first else (0, 1):
            self.space.add(self.bodies[i], self.shapes[i])
        self.space.on_collision(*self.handler, post_solve=self._record)

    def _record(self, contact: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
        self.contacts.append(
            {
                "impulse": contact.total_impulse,
                "ke": contact.total_ke,
                "normal": contact.normal,
                "restitution": contact.restitution,
                "friction": contact.friction,
                "first_is_first": contact.shapes[0] is self.shapes[0],
            }
        )

    def step(self, dt: float = TINY_STEP) -> Pair:
        """Make one step and return self."""
        self.space.step(dt)
        return self

    def vx(self) -> tuple[float, float]:
        """Return the velocities along the line."""
        return self.bodies[0].velocity.x, self.bodies[1].velocity.x

    def energy(self) -> float:
        """Return the kinetic energy, J, worked out here and not by pymunk."""
        return sum(b.mass * b.velocity.length**2 / 2 for b in self.bodies) + sum(
            b.moment * b.angular_velocity**2 / 2 for b in self.bodies if b.angular_velocity
        )


def ball_on_floor(
    velocity: tuple[float, float], clearance: float, elasticity: float, gravity: float = 0.0
) -> tuple[pymunk.Space, pymunk.Body]:
    """Return a space with a ball of radius 1 m above a floor at y = 0."""
    space = pymunk.Space()
    space.gravity = (0.0, -gravity)
    body = pymunk.Body(1.0, math.inf)
    body.position, body.velocity = (0.0, 1.0 + clearance), velocity
    ball = pymunk.Circle(body, 1.0)
    floor = pymunk.Segment(space.static_body, (-10.0, -1.0), (10.0, -1.0), 1.0)
    ball.elasticity, floor.elasticity = elasticity, 1.0
    space.add(body, ball, floor)
    return space, body


# The step: cpSpaceStep.c


def test_step_free_fall_moves_before_it_accelerates() -> None:
    """Position first, with the old velocity: p += v dt, and only then v += g dt."""
    space, body = ball_on_floor((0.0, 2.0), clearance=5.0, elasticity=1.0, gravity=10.0)
    space.step(0.125)
    assert body.position.y == 6.0 + 2.0 * 0.125
    assert body.velocity.y == 2.0 - 10.0 * 0.125


def test_step_discs_that_meet_on_the_way_collide_in_the_same_step() -> None:
    """Contacts are looked for after the move: apart before it, overlapped after, resolved now."""
    pair = Pair(2.5, ((4.0, 0.0), (-4.0, 0.0)), (1.0, 1.0), elasticities=(1.0, 1.0)).step(0.125)
    assert pair.vx() == pytest.approx((-4.0, 4.0), abs=ROUNDING)
    assert pair.bodies[1].position.x - pair.bodies[0].position.x == 1.5


def test_step_discs_that_part_on_the_way_do_not_collide() -> None:
    """Overlapped before the move and apart after it: no contact at all."""
    assert not Pair(1.5, ((-4.0, 0.0), (4.0, 0.0))).step(0.125).contacts


def test_step_oblique_hit_takes_the_normal_at_the_moved_positions() -> None:
    """The normal joins the centres as they are after the move, p + v dt."""
    pair = Pair(2.0, ((2.0, 4.0), (0.0, 0.0))).step(0.125)
    moved = np.array([2.0, 0.0]) - np.array([0.25, 0.5])
    normal = pair.contacts[0]["normal"]
    np.testing.assert_allclose(normal, moved / math.hypot(*moved), atol=ROUNDING)


def test_step_damping_is_a_factor_per_second() -> None:
    """The velocity is multiplied by damping**dt before the acceleration is added."""
    space, body = ball_on_floor((0.0, 4.0), clearance=5.0, elasticity=1.0, gravity=10.0)
    space.damping = 0.25
    space.step(0.5)
    assert body.velocity.y == pytest.approx(4.0 * 0.5 - 5.0, abs=ROUNDING)


# Contact: cpCollision.c, and cpArbiter.c for what a pair is made of


@pytest.mark.parametrize(
    ("distance", "contacts"), [(2.0, 0), (math.nextafter(2.0, 0.0), 1)], ids=["touch", "overlap"]
)
def test_contact_circles_need_real_overlap(distance: float, contacts: int) -> None:
    """Two circles at exactly d = r1 + r2 are no contact; one bit closer they are."""
    pair = Pair(distance, ((0.0, 0.0), (0.0, 0.0))).step()
    assert len(pair.contacts) == contacts


@pytest.mark.parametrize(
    ("clearance", "hit"), [(0.0, False), (-(2.0**-50), True)], ids=["touch", "overlap"]
)
def test_contact_circle_and_segment_need_real_overlap(clearance: float, hit: bool) -> None:
    """A ball that exactly touches a wall is no contact either."""
    space, body = ball_on_floor((0.0, -(2.0**-1060)), clearance, elasticity=1.0)
    space.step(TINY_STEP)
    assert (body.velocity.y > 0) == hit


@pytest.mark.parametrize(("gap", "contacts"), [(2.0**-40, 0), (0.0, 1)], ids=["apart", "touch"])
def test_contact_polygons_touch_is_enough(gap: float, contacts: int) -> None:
    """Polygons are a contact at a distance of exactly 0: another rule than for circles."""
    space, count = pymunk.Space(), []
    bodies = [pymunk.Body(1.0, math.inf), pymunk.Body(1.0, math.inf)]
    bodies[1].position = (2.0 + gap, 0.0)
    space.add(*bodies, *(pymunk.Poly.create_box(body, (2.0, 2.0)) for body in bodies))
    space.on_collision(post_solve=lambda *_: count.append(1))
    space.step(TINY_STEP)
    assert len(count) == contacts


def test_contact_coefficients_are_products() -> None:
    """The pair's restitution is e1 * e2 and its friction mu1 * mu2."""
    pair = Pair(elasticities=(0.5, 0.75), frictions=(0.25, 3.0)).step()
    assert pair.contacts[0]["restitution"] == 0.5 * 0.75
    assert pair.contacts[0]["friction"] == 0.25 * 3.0


def test_contact_coincident_circles_get_a_normal_on_the_x_axis() -> None:
    """Circles with one centre are pushed apart along x; which way depends on their order."""
    pair = Pair(0.0, ((0.0, 0.0), (0.0, 0.0))).step()
    normal = pair.contacts[0]["normal"]
    assert (abs(normal.x), abs(normal.y)) == (1.0, 0.0)


@pytest.mark.parametrize(("end", "left"), [((4.0, 0.0), (0.0, 1.0)), ((0.0, 4.0), (-1.0, 0.0))])
def test_contact_centre_on_segment_gets_its_left_normal(
    end: tuple[float, float], left: tuple[float, float]
) -> None:
    """A ball whose centre lies on a segment is pushed to the left of its direction."""
    space, normals = pymunk.Space(), []
    body = pymunk.Body(1.0, math.inf)
    body.position = (end[0] / 2, end[1] / 2)
    ball = pymunk.Circle(body, 1.0)
    ball.collision_type = FIRST
    space.add(body, ball, pymunk.Segment(space.static_body, (0.0, 0.0), end, 0.0))
    space.on_collision(FIRST, 0, post_solve=lambda contact, *_: normals.append(contact.normal))
    space.step(TINY_STEP)
    np.testing.assert_array_equal(-np.array(normals), [left])


# Velocity: cpArbiter.c


def test_restitution_head_on_pair_is_hard_case_one() -> None:
    """With m = 1, 3, v = 2, -1, e = 0.7: v' = -1.825, 0.275 and an impulse of 3.825 N s."""
    pair = Pair().step()
    assert pair.vx() == pytest.approx((-1.825, 0.275), abs=ROUNDING)
    assert pair.contacts[0]["impulse"].length == pytest.approx(3.825, abs=ROUNDING)


def test_restitution_under_gravity_uses_the_velocity_before_gravity() -> None:
    """At v = -1, g dt = 1 m/s, e = 0.5 it bounces with 0.5 m/s; after gravity it would be 1."""
    space, body = ball_on_floor((0.0, -1.0), clearance=0.0, elasticity=0.5, gravity=8.0)
    space.step(0.125)
    assert body.velocity.y == pytest.approx(0.5, abs=ROUNDING)


@pytest.mark.parametrize("speed", [1e-12, 1e-6, 0.9])
def test_restitution_slow_hit_has_no_threshold(speed: float) -> None:
    """However slow, an elastic ball bounces with its own speed."""
    space, body = ball_on_floor((0.0, -speed), clearance=-0.01, elasticity=1.0)
    space.step(TINY_STEP)
    assert body.velocity.y == pytest.approx(speed, rel=ROUNDING)


def test_restitution_above_one_is_accepted_and_creates_energy() -> None:
    """A restitution of 1.5 is taken: v = -2 comes back as +3."""
    space, body = ball_on_floor((0.0, -2.0), clearance=-0.01, elasticity=1.5)
    space.step(TINY_STEP)
    assert body.velocity.y == pytest.approx(3.0, abs=ROUNDING)


def test_velocity_overlap_that_persists_is_left_alone_after_the_bounce() -> None:
    """One step turns the velocity; a second step, still overlapped, changes nothing more."""
    space, body = ball_on_floor((0.0, -1.0), clearance=-0.05, elasticity=1.0)
    space.step(TINY_STEP)
    space.step(TINY_STEP)
    assert body.velocity.y == pytest.approx(1.0, abs=ROUNDING)
    assert body.position.y < 1.0


def test_velocity_deep_overlap_is_not_pushed() -> None:
    """The position split works through a velocity of its own: bodies at rest stay at rest."""
    pair = Pair(1.0, ((0.0, 0.0), (0.0, 0.0)))
    for _ in range(10):
        pair.step(1 / 60)
    assert pair.vx() == (0.0, 0.0)
    assert pair.bodies[1].position.x - pair.bodies[0].position.x > 1.0


def test_position_overlap_beyond_the_slop_shrinks_by_the_bias() -> None:
    """Each step multiplies the overlap beyond the slop by collision_bias**dt, one step late."""
    pair, dt = Pair(1.5, ((0.0, 0.0), (0.0, 0.0))), 1 / 60
    beyond = 0.5 - pair.space.collision_slop
    for _ in range(1 + 3):
        pair.step(dt)
    left = 2.0 - pair.bodies[1].position.x + pair.bodies[0].position.x - pair.space.collision_slop
    assert left == pytest.approx(beyond * pair.space.collision_bias ** (3 * dt), abs=ROUNDING)


def test_position_overlap_within_the_slop_is_kept() -> None:
    """Less overlap than the slop is left as it is."""
    pair = Pair(1.95, ((0.0, 0.0), (0.0, 0.0)))
    for _ in range(10):
        pair.step(1 / 60)
    assert pair.bodies[1].position.x - pair.bodies[0].position.x == 1.95


def test_angular_momentum_friction_on_overlapped_discs_changes_by_overlap_times_jt() -> None:
    """Each body has a contact point of its own, so the friction impulses are a couple."""
    pair = Pair(
        distance=1.95,
        velocities=((2.0, 1.0), (-1.0, 0.0)),
        moments=(0.5, 1.5),
        frictions=(0.25, 1.0),
    )
    before = angular_momentum(pair.bodies)
    impulse = pair.step().contacts[0]["impulse"]
    gained = angular_momentum(pair.bodies) - before
    assert abs(gained) == pytest.approx(0.05 * abs(impulse.y), abs=TURNED)
    assert abs(impulse.y) > 0.1


def angular_momentum(bodies: list[pymunk.Body]) -> float:
    """Return the angular momentum of bodies about the origin, kg m^2/s."""
    return sum(
        b.mass * (b.position.x * b.velocity.y - b.position.y * b.velocity.x)
        + b.moment * b.angular_velocity
        for b in bodies
    )


# What is reported: space.py, body.py, arbiter.py


def test_defaults_of_a_space_are_known() -> None:
    """Defaults: the slop is a float32 0.1, the bias 0.9f**60 worked out in floats."""
    space = pymunk.Space()
    assert space.iterations == 10
    assert space.collision_slop == 0.10000000149011612
    assert space.collision_bias == 0.0017970074436457143
    assert space.collision_persistence == 3
    assert space.damping == 1.0
    assert space.sleep_time_threshold == math.inf
    assert space.idle_speed_threshold == 0.0


def test_kinetic_energy_of_a_body_is_doubled() -> None:
    """Body.kinetic_energy is m v^2 + I w^2: 38 for m = 2, v = 3, I = 5, w = 2, not 19."""
    body = pymunk.Body(2.0, 5.0)
    body.velocity, body.angular_velocity = (3.0, 0.0), 2.0
    assert body.kinetic_energy == 2 * (2 * 9 / 2 + 5 * 4 / 2)


def test_total_ke_without_friction_is_twice_the_energy_lost() -> None:
    """Arbiter.total_ke is in the same doubled unit: 3.4425 where 1.72125 J are lost."""
    pair = Pair()
    before = pair.energy()
    lost = before - pair.step().energy()
    assert lost == pytest.approx(1.72125, abs=ROUNDING)
    assert pair.contacts[0]["ke"] == pytest.approx(2 * lost, abs=ROUNDING)


def test_total_ke_with_sliding_friction_counts_it_as_if_it_stuck() -> None:
    """Sliding turns 2 |jt| vt - jt^2/m_t (doubled) into heat; total_ke counts jt^2/m_t of it."""
    pair = Pair(velocities=((2.0, 4.0), (-1.0, 0.0)), moments=(0.5, 1.5), frictions=(0.125, 1.0))
    before = pair.energy()
    lost = before - pair.step().energy()
    jt, vt, inv_m_t = 0.125 * 3.825, 4.0, 1 + 1 / 3 + 1 / 0.5 + 1 / 1.5
    missed = 2 * jt * vt - 2 * jt**2 * inv_m_t
    assert 2 * lost - pair.contacts[0]["ke"] == pytest.approx(missed, abs=TURNED)
    assert missed > 0.2 * 2 * lost


@pytest.mark.parametrize("second_added_first", [False, True])
def test_total_impulse_typed_handler_is_the_impulse_on_its_first_type(
    second_added_first: bool,
) -> None:
    """With a handler for types (1, 2) the impulse is that on the shape of type 1."""
    pair = Pair(second_added_first=second_added_first).step()
    assert pair.contacts[0]["first_is_first"]
    assert pair.contacts[0]["impulse"].x == pytest.approx(-3.825, abs=ROUNDING)
    assert pair.contacts[0]["normal"].x == pytest.approx(1.0, abs=ROUNDING)


def test_total_impulse_untyped_handler_changes_sign_with_the_order_of_adding() -> None:
    """With a handler for (None, None) the engine's own order rules: a trap for signs."""
    impulses = [
        Pair(handler=(None, None), second_added_first=swapped).step().contacts[0]["impulse"].x
        for swapped in (False, True)
    ]
    assert impulses == pytest.approx([3.825, -3.825], abs=ROUNDING)

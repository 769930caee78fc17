"""Whole trajectories against pymunk, step by step and to the last bit.

A collision amplifies every difference, so trajectories of many bodies can only be compared when
each operation is the same. The replica performs pymunk's operations in pymunk's order; that it
stays with pymunk for thousands of contacts shows that we know what pymunk's step does.
"""

from __future__ import annotations

import numpy as np
import pymunk
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.reference.pymunk_reference import PymunkStepper

from . import chipmunk_replica
from .chipmunk_replica import ChipmunkReplica

DT = 1 / 60
HALF_WIDTH = 5.0
"""m, of the box that the discs fall into."""


def discs_in_a_box(count: int) -> Scene:
    """Discs of different size and mass above a box, with speed and spin."""
    rng = np.random.default_rng(seed=1)
    wall, ball = Material(1.0, 1.0), Material(0.6, 0.4)
    left, right, top = -HALF_WIDTH, HALF_WIDTH, 20.0
    walls = [
        Body(Segment((left, 0), (right, 0)), material=wall),
        Body(Segment((left, 0), (left, top)), material=wall),
        Body(Segment((right, 0), (right, top)), material=wall),
    ]
    discs = [
        Body(
            Circle(0.4 + 0.02 * n),
            position=(rng.uniform(-4, 4), 1 + 1.3 * n),
            velocity=rng.uniform(-3, 3, 2),
            angular_velocity=rng.uniform(-5, 5),
            mass=1.0 + n,
            material=ball,
        )
        for n in range(count)
    ]
    return Scene(walls + discs, gravity=(0, -10))


@pytest.mark.one_in(4)
@pytest.mark.parametrize(
    ("count", "seconds", "contacts"), [(1, 12, 483), (2, 10, 700), (5, 10, 1_500), (12, 10, 6_500)]
)
def test_trajectory_in_pymunks_order_is_bit_equal(count: int, seconds: int, contacts: int) -> None:
    """Position, angle, velocity and spin of every disc, in every step: not one bit differs."""
    scene = discs_in_a_box(count)
    theirs = PymunkStepper(scene, dt=DT, iterations=10, substeps=1, combine=mixing_rule("pymunk"))
    ours = ChipmunkReplica(scene, DT)
    for step in range(seconds * 60):
        theirs.advance(1)
        ours.step(theirs.visited)
        assert np.array_equal(theirs.states(), ours.states()), f"step {step}"
    assert ours.contacts >= contacts


@pytest.mark.full
def test_order_of_contacts_is_part_of_the_result() -> None:
    """The same replica, its contacts visited backwards, is soon somewhere else."""
    scene = discs_in_a_box(12)
    theirs = PymunkStepper(scene, dt=DT, iterations=10, substeps=1, combine=mixing_rule("pymunk"))
    ours = ChipmunkReplica(scene, DT)
    for _ in range(600):
        theirs.advance(1)
        ours.step(theirs.visited[::-1])
        apart = np.abs(np.subtract(theirs.states(), ours.states()))[:, :2].max()
        if apart > 0.1:
            break
    assert apart > 0.1


def test_replicas_constants_are_those_of_the_installed_pymunk() -> None:
    """Slop, bias and persistence: an upgrade that changes them fails here."""
    space = pymunk.Space()
    assert space.collision_slop == chipmunk_replica.SLOP
    assert space.collision_bias == chipmunk_replica.BIAS
    assert space.collision_persistence == chipmunk_replica.PERSISTENCE


@pytest.mark.parametrize(
    "body",
    [
        Body(Polygon.box(1, 1), mass=1.0),
        Body(Segment((-1, 0), (1, 0)), mass=1.0),
        Body(Segment((-1, 0), (1, 0)), angle=0.1),
    ],
    ids=["polygon", "rod", "turned wall"],
)
def test_replica_refuses_what_it_cannot_do(body: Body) -> None:
    """It knows discs and level-headed walls only, and says so."""
    with pytest.raises(ValueError, match="bodies must be discs, or static segments"):
        ChipmunkReplica(Scene([body]), DT)

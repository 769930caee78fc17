"""Islands: which contacts belong together, and what an impulse at one does to another."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from contacts import apply_impulse, velocity_along
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core.broad_phase import all_pairs
from lesson_code.engine.core.candidate_pairs import find_pairs
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.contact_motion import (
    normal_of,
    tangent_of,
)
from lesson_code.engine.core.islands import (
    apply_impulses,
    apply_pseudo_impulses,
    islands_of,
    pseudo_velocities,
    velocities,
)
from lesson_code.engine.core.narrow_phase import find_contacts
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.core.tables import world_of

ROUNDING = 1e-12
"""m/s, of velocities of some tens: sums of a dozen products, twice."""


def detected(bodies: list[Body]) -> World:
    """Return the tables of some bodies, their contacts found."""
    world = world_of(Scene(bodies), dt=0.01, iterations=1, combine=MixingRule())
    while not (find_pairs(world, all_pairs) and find_contacts(world)):
        world = add_capacity(world)
    return world


def push_velocity_along(c: ContactRow, a: BodyRow, b: BodyRow, u: Any) -> float:
    """Return the relative velocity of the correction along u, as the motion's would be."""
    pushed = [BodyRow(vx=r.pseudo_vx, vy=r.pseudo_vy, w=r.pseudo_w) for r in (a, b)]
    return velocity_along(c, *pushed, u)


def apply_pseudo_impulse(c: ContactRow, a: BodyRow, b: BodyRow, u: Any, j: float) -> None:
    """Change the velocities of the correction as an impulse would those of the motion."""
    pushed = [BodyRow(inv_m=row.inv_m, inv_i=row.inv_i) for row in (a, b)]
    apply_impulse(c, *pushed, u, j)
    for row, gained in zip((a, b), pushed, strict=True):
        row.pseudo_vx += gained.vx
        row.pseudo_vy += gained.vy
        row.pseudo_w += gained.w


def ball(x: float, y: float = 0.49, mass: float | None = 1.0, **motion: Any) -> Body:
    """Return a disc of radius 1/2, which a floor at y = 0 touches."""
    return Body(Circle(0.5), position=(x, y), mass=mass, **motion)


FLOOR = Body(Segment((-50, 0), (50, 0)))

GROUPS = {
    "two balls on one floor are two": ([FLOOR, ball(0), ball(5)], [[(0, 1)], [(0, 2)]]),
    "two that touch are one": ([FLOOR, ball(0), ball(0.9)], [[(0, 1), (0, 2), (1, 2)]]),
    "a chain is one, whatever its order": (
        [ball(0), ball(1.8), ball(2.7), ball(0.9)],
        [[(0, 3), (1, 2), (1, 3)]],
    ),
    "a static ball between two does not connect": (
        [ball(0), ball(0.9, mass=None), ball(1.8)],
        [[(0, 1)], [(1, 2)]],
    ),
    "nothing touches": ([ball(0), ball(2)], []),
}


@pytest.mark.parametrize(("bodies", "groups"), GROUPS.values(), ids=GROUPS)
def test_islands_are_joined_by_bodies_that_can_be_pushed(
    bodies: list[Body], groups: list[list[tuple[int, int]]]
) -> None:
    """Pairs of bodies, island by island, in the order of the contact table."""
    islands = islands_of(detected(bodies))
    assert [[(c.a, c.b) for c in island.contacts] for island in islands] == groups


def heap(seed: int) -> World:
    """Return ten bodies of all kinds on a heap, as they move, with pushes too."""
    rng = np.random.default_rng(seed)
    shapes = [Circle(0.4), Polygon.box(0.9, 0.5), Polygon.regular(5, 0.5)]
    bodies = [
        Body(
            shapes[rng.integers(3)],
            position=rng.uniform(-0.8, 0.8, 2),
            angle=rng.uniform(-3, 3),
            velocity=rng.uniform(-5, 5, 2),
            angular_velocity=rng.uniform(-5, 5),
            mass=None if rng.random() < 0.2 else rng.uniform(0.1, 10),
        )
        for _ in range(10)
    ]
    world = detected(bodies)
    for row in world.bodies:
        row.pseudo_vx, row.pseudo_vy, row.pseudo_w = rng.uniform(-5, 5, 3)
    return world


@settings(max_examples=share(30), phases=[Phase.explicit, Phase.generate])
@given(seed=st.integers(0, 10**9))
def test_velocities_after_impulses_are_u_plus_k_x(seed: int) -> None:
    """The matrix says what the engine's own impulses, one contact after the other, do."""
    rng, world = np.random.default_rng(seed), heap(seed)
    for island in islands_of(world):
        contacts = island.contacts
        u = velocities(island)
        x = rng.uniform(-1, 1, len(u))
        for c, jn, jt in zip(contacts, *np.split(x, 2), strict=True):
            a, b = world.bodies[c.a], world.bodies[c.b]
            apply_impulse(c, a, b, normal_of(c), jn)
            apply_impulse(c, a, b, tangent_of(c), jt)
        after = [
            velocity_along(c, world.bodies[c.a], world.bodies[c.b], along(c))
            for along in (normal_of, tangent_of)
            for c in contacts
        ]
        np.testing.assert_allclose(u + island.delassus @ x, after, atol=100 * ROUNDING)
        apply_impulses(island, -x)  # and back again
        np.testing.assert_allclose(velocities(island), u, atol=100 * ROUNDING)


@settings(max_examples=share(30), phases=[Phase.explicit, Phase.generate])
@given(seed=st.integers(0, 10**9))
def test_pushes_change_the_velocities_of_the_correction_alone(seed: int) -> None:
    """The same matrix, the other velocities."""
    rng, world = np.random.default_rng(seed), heap(seed)
    for island in islands_of(world):
        contacts = island.contacts
        u, before = pseudo_velocities(island), velocities(island)
        x = rng.uniform(-1, 1, len(u))
        apply_pseudo_impulses(island, x)
        np.testing.assert_array_equal(velocities(island), before)
        after = [
            push_velocity_along(c, world.bodies[c.a], world.bodies[c.b], along(c))
            for along in (normal_of, tangent_of)
            for c in contacts
        ]
        np.testing.assert_allclose(u + island.delassus @ x, after, atol=100 * ROUNDING)
        for c, jn, jt in zip(contacts, *np.split(-x, 2), strict=True):
            a, b = world.bodies[c.a], world.bodies[c.b]
            apply_pseudo_impulse(c, a, b, normal_of(c), jn)
            apply_pseudo_impulse(c, a, b, tangent_of(c), jt)
        np.testing.assert_allclose(pseudo_velocities(island), u, atol=100 * ROUNDING)

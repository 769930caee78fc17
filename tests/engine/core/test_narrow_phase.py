"""The narrow phase: the contact table holds what the geometry says of every candidate pair."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core.broad_phase import all_pairs
from lesson_code.engine.core.candidate_pairs import find_pairs
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.contact_motion import contact_point
from lesson_code.engine.core.narrow_phase import find_overlaps
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.geometry import collide

ROUNDING = 1e-14
"""m: a point is a sum of a place and an offset, each of a few metres and right to 1e-16."""


def detected(scene: Scene, combine: MixingRule | None = None, dirt: float = 0.0) -> World:
    """Return the tables of a scene, its contacts found, in rows that held something before."""
    world = world_of(scene, dt=0.01, iterations=1, combine=combine or MixingRule())
    while not (find_pairs(world, all_pairs) and find_overlaps(world, EVERY_EFFECT)):
        world = add_capacity(world)
    for contact in world.contacts:
        contact.normal_impulse = contact.tangent_impulse = contact.pseudo_impulse = dirt
    assert find_overlaps(world, EVERY_EFFECT)
    return world


def in_use(world: World) -> list[ContactRow]:
    """Return the contacts that there are."""
    return world.contacts[: world.state.contact_count]


def some_scene(seed: int) -> Scene:
    """Return 15 bodies of all kinds on a small place."""
    rng = np.random.default_rng(seed)
    shapes = [Circle(0.4), Polygon.box(0.9, 0.5), Polygon.regular(5, 0.5), Segment((-1, 0), (1, 0))]
    bodies = [
        Body(
            shapes[rng.integers(len(shapes))],
            position=rng.uniform(-1.5, 1.5, 2),
            angle=rng.uniform(-3, 3),
            mass=None if rng.random() < 0.2 else 1.0,
        )
        for _ in range(15)
    ]
    return Scene(bodies)


def pose(body: Body) -> tuple[float, float, float]:
    """Return where a body is, as the geometry takes it."""
    return (*body.position, body.angle)


@settings(max_examples=share(40), phases=[Phase.explicit, Phase.generate])
@given(seed=st.integers(0, 10**9))
def test_contacts_of_any_scene_are_those_of_each_pair_alone(seed: int) -> None:
    """Pair by pair in their order: the manifold's normal, points, penetrations and features."""
    scene = some_scene(seed)
    world = detected(scene)
    expected: list[Any] = []
    for i, a in enumerate(scene.bodies):
        for j in range(i + 1, len(scene.bodies)):
            b = scene.bodies[j]
            manifold = collide(a.shape, pose(a), b.shape, pose(b))
            if manifold is None or (a.is_static and b.is_static):
                continue
            places = zip(manifold.points, manifold.penetrations, manifold.features, strict=True)
            expected += [(i, j, *manifold.normal, *p, d, feature) for p, d, feature in places]
    measured = [
        (
            c.a,
            c.b,
            c.nx,
            c.ny,
            *contact_point(c, world.bodies[c.a], world.bodies[c.b]),
            c.penetration,
            c.feature,
        )
        for c in in_use(world)
    ]
    assert [row[:2] for row in measured] == [row[:2] for row in expected]
    np.testing.assert_allclose(measured, expected, atol=ROUNDING)


@settings(max_examples=share(20), phases=[Phase.explicit, Phase.generate])
@given(seed=st.integers(0, 10**9))
def test_lever_arms_of_any_scene_end_on_both_surfaces(seed: int) -> None:
    """Position A + arm A = position B + arm B + penetration n: one penetration apart along n."""
    world = detected(some_scene(seed))
    for c in in_use(world):
        a, b = world.bodies[c.a], world.bodies[c.b]
        on_a, on_b = np.array([a.x + c.ax, a.y + c.ay]), np.array([b.x + c.bx, b.y + c.by])
        gap = on_a - on_b - c.penetration * np.array([c.nx, c.ny])
        np.testing.assert_allclose(gap, 0, atol=ROUNDING)


@pytest.mark.parametrize(
    ("combine", "expected"),
    [
        (MixingRule(), (0.25, 0.4)),
        (MixingRule("product", "product"), (0.16, 0.16)),
        (MixingRule("max", "min"), (0.64, 0.25)),
    ],
)
def test_coefficients_of_a_contact_are_the_pairs(
    combine: MixingRule, expected: tuple[float, float]
) -> None:
    """Restitution and friction each by its own rule, of 0.25 and 0.64."""
    bodies = [
        Body(Circle(1), mass=1, position=(x, 0), material=Material(c, c))
        for x, c in ((0, 0.25), (1, 0.64))
    ]
    [contact] = in_use(detected(Scene(bodies), combine))
    assert (contact.restitution, contact.friction) == pytest.approx(expected)


def test_impulses_of_a_new_contact_begin_at_zero() -> None:
    """A row is used again in every step; nothing is left of what it held."""
    bodies = [Body(Circle(1), mass=1, position=(x, 0)) for x in (0, 1)]
    [contact] = in_use(detected(Scene(bodies), dirt=7.0))
    impulses = contact.normal_impulse, contact.tangent_impulse, contact.pseudo_impulse
    assert impulses == (0.0, 0.0, 0.0)


def test_contacts_of_boxes_that_overlap_without_their_shapes_are_none() -> None:
    """The broad phase compares boxes; a candidate pair need not touch."""
    bodies = [Body(Circle(1), mass=1, position=(x, x)) for x in (0, 1.9)]
    world = detected(Scene(bodies))
    assert (world.state.pair_count, world.state.contact_count) == (1, 0)


def test_contacts_of_discs_that_just_touch_are_none() -> None:
    """Touching is not overlapping; a hair nearer it is."""
    for x, count in ((2.0, 0), (2.0 - 1e-12, 1)):
        bodies = [Body(Circle(1), mass=1), Body(Circle(1), mass=1, position=(x, 0))]
        assert detected(Scene(bodies)).state.contact_count == count

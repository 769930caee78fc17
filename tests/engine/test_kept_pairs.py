"""Pairs that are kept while every body is in its box: found seldom, and never too late."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core.broad_phase import all_pairs, bound
from lesson_code.engine.core.candidate_pairs import find_pairs
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.rows import World
from lesson_code.engine.core.tables import BROAD_PHASES, world_of
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.gas import gas_of


def counting(way: Callable[[World], int], calls: list[int]) -> Callable[[World], int]:
    """Return a broad phase that notes each time it is asked."""
    return lambda world: calls.append(1) or way(world)  # type: ignore[func-returns-value]


def two_discs() -> World:
    """Return two discs 1.5 m apart, in boxes with a margin of 5 cm, their pairs found."""
    discs = [Body(Circle(0.5), mass=1, position=(x, 0)) for x in (0, 1.5)]
    world = world_of(Scene(discs), 0.01, 1, MixingRule())
    world.state.pairs_wanted = 1
    world = add_capacity(world)
    assert find_pairs(world, all_pairs)
    return world


def test_pairs_are_kept_until_a_body_leaves_its_box() -> None:
    """And then found anew, for all bodies and from where they are."""
    world = two_discs()
    calls: list[int] = []
    way = counting(all_pairs, calls)
    assert (world.state.pair_count, world.bodies[1].min_x) == (0, 0.95)
    world.bodies[1].x = 1.46
    assert find_pairs(world, way)
    assert (len(calls), world.state.pair_count, world.bodies[1].min_x) == (0, 0, 0.95)
    world.bodies[1].x = 1.08  # the boxes with their margins overlap now, the discs do not
    assert find_pairs(world, way)
    assert (len(calls), world.state.pair_count) == (1, 1)
    world.bodies[1].x = 1.12
    assert find_pairs(world, way)
    assert (len(calls), world.state.pair_count) == (1, 1)
    world.bodies[1].x = 9.0
    assert find_pairs(world, way)
    assert (len(calls), world.state.pair_count) == (2, 0)


def test_pairs_that_had_no_room_are_found_when_there_is() -> None:
    """A table that was too small holds no pairs to keep."""
    world = two_discs()
    world.pairs.clear()
    world.sorted_pairs.clear()
    world.bodies[1].x = 0.9
    assert not find_pairs(world, all_pairs)
    assert not find_pairs(world, all_pairs)
    world = add_capacity(world)
    assert find_pairs(world, all_pairs)
    assert world.state.pair_count == 1


def heap(count: int, speed: float) -> Scene:
    """Return discs, boxes and rods that are thrown into a pit."""
    rng = np.random.default_rng(8)
    shapes = (Circle(0.3), Polygon.box(0.6, 0.4), Segment((-0.3, 0), (0.3, 0), radius=0.1))
    walls = [Segment((-2, 0), (2, 0)), Segment((-2, 0), (-2, 20)), Segment((2, 0), (2, 20))]
    bodies = [
        Body(
            shapes[n % 3], mass=1, position=(n % 4 - 1.5, 0.5 + n // 4), angle=rng.uniform(-3, 3),
            velocity=rng.uniform(-speed, speed, 2), angular_velocity=rng.uniform(-speed, speed),
            material=Material(0.4, 0.5),
        )
        for n in range(count)
    ]  # fmt: skip
    return Scene([*map(Body, walls), *bodies], gravity=(0, -10))


def tumbling() -> Scene:
    """Return boxes and triangles that turn and fly between four walls."""
    rng = np.random.default_rng(7)
    shapes = [Polygon.box(1, 0.5), Polygon.regular(3, 0.6)]
    surface = Material(restitution=0.9, friction=0.3)
    places = [(-1.5, -1.5), (-1.5, 1.5), (1.5, -1.5), (1.5, 1.5)]
    bodies = [
        Body(
            shapes[n % 2],
            mass=1,
            position=place,
            velocity=rng.uniform(-9, 9, 2),
            angular_velocity=rng.uniform(-9, 9),
            material=surface,
        )
        for n, place in enumerate(places)
    ]
    corners = [(-3, -3), (3, -3), (3, 3), (-3, 3), (-3, -3)]
    walls = [Body(Segment(p, q), material=surface) for p, q in pairwise(corners)]
    return Scene([*walls, *bodies])


SCENES = {
    "a heap": heap(30, 2.0),
    "few bodies": heap(6, 2.0),
    "fast bodies": heap(12, 60.0),
    "a gas": gas_of(30, 0.3, seed=3),
    "tumbling bodies": tumbling(),
}

SOLVERS = {name: ["sequential", "substep", "naive"] for name in SCENES}
SOLVERS["a gas"].append("direct")  # it takes seconds for a heap
SOLVERS["tumbling bodies"].append("direct")


@pytest.mark.parametrize(
    ("name", "solver"), [(name, solver) for name in SCENES for solver in SOLVERS[name]]
)
def test_run_with_pairs_that_are_kept_has_the_bits_of_one_that_finds_them_in_every_step(
    name: str, solver: str
) -> None:
    """Pairs that do not touch make no contacts, and those that do are in the same order.

    The direct solver keeps the gaps between bodies, too, and does not look at those that are apart.
    """
    measured: list[Any] = []
    for forget in (False, True):
        stepper = EngineStepper(
            SCENES[name], solver=solver, dt=1 / 60, iterations=4, substeps=2, combine=MixingRule()
        )
        calls: list[int] = []
        way = counting(stepper.pipeline.broad_phase, calls)
        stepper.pipeline = stepper.pipeline._replace(broad_phase=way)
        for _ in range(60):
            stepper.world.state.has_pairs &= not forget
            stepper.advance(1)
        measured.append((stepper.states().tobytes(), stepper.events().tobytes(), len(calls)))
    kept, sought = measured
    assert kept[:2] == sought[:2]
    assert kept[2] <= sought[2] >= 60


def test_pairs_of_a_heap_at_rest_are_never_found_again() -> None:
    """What lies still stays in its box."""
    scene = Scene(
        [Body(Segment((-9, 0), (9, 0)))]
        + [Body(Circle(0.5), mass=1, position=(1.5 * k - 6, 0.498)) for k in range(9)],
        gravity=(0, -10),
    )
    for name in BROAD_PHASES:
        calls: list[int] = []
        stepper = EngineStepper(
            scene, solver="sequential", dt=1 / 60, iterations=4, substeps=1, combine=MixingRule()
        )
        way = counting(BROAD_PHASES[name], calls)
        stepper.pipeline = stepper.pipeline._replace(broad_phase=way)
        stepper.advance(60)
        assert len(calls) == 2  # once more, when there was room for what was found


def test_pairs_of_a_look_ahead_are_not_those_of_the_step() -> None:
    """A fast ball's box holds all of its way meanwhile; the step draws its own."""
    ball = Body(Circle(0.1), mass=1, velocity=(30, 0))
    wall = Body(Segment((5, -1), (5, 1)))
    stepper = EngineStepper(
        Scene([ball, wall]), solver="sequential", dt=1 / 60, iterations=4, substeps=1,
        combine=MixingRule(),
    )  # fmt: skip
    stepper.advance(1)
    drawn = [(body.min_x, body.max_x) for body in stepper.world.bodies]
    bound(stepper.world)
    assert drawn == [(body.min_x, body.max_x) for body in stepper.world.bodies]

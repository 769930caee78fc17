"""Bodies with a neighbour, found by arrays: those that a comparison of all pairs finds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core.broad_phase import all_pairs, bound
from lesson_code.engine.core.constants import LARGEST_IN_GRID, LEAST_MARGIN, PAIRS_ANYWAY
from lesson_code.engine.core.neighbours import has_neighbour
from lesson_code.engine.core.rows import PairRow
from lesson_code.engine.core.tables import world_of

PLACES = st.floats(-6, 6)
SHAPES = st.one_of(
    st.builds(Circle, st.floats(0.1, 2)),
    st.builds(Polygon.box, st.floats(0.1, 2), st.floats(0.1, 2)),
    st.just(Segment((-1, -1), (1, 1), 0.1)),
    st.just(Circle(2 * LARGEST_IN_GRID)),
)
BODIES = st.builds(
    lambda shape, angle, **given: Body(shape, angle=angle, **given),
    SHAPES,
    st.floats(-3, 3),
    position=st.tuples(PLACES, PLACES),
    mass=st.sampled_from([None, 1.0]),
)


def compared(scene: Scene) -> list[bool]:
    """Return the same by the engine's comparison of all pairs of boxes; nothing moves here."""
    world = world_of(scene, dt=1.0, iterations=0, combine=MixingRule())
    world.pairs.extend(PairRow() for _ in range(len(scene.bodies) ** 2))
    bound(world)
    pairs = world.pairs[: all_pairs(world)]
    found = {number for pair in pairs for number in (pair.a, pair.b)}
    return [number in found for number in range(len(scene.bodies))]


@given(st.lists(BODIES, max_size=30))
def test_neighbours_are_those_that_a_comparison_of_all_pairs_finds(bodies: list[Any]) -> None:
    """Bodies of all kinds, small and large, at any angle; static ones are no neighbours."""
    scene = Scene(bodies)
    assert has_neighbour(scene, LEAST_MARGIN).tolist() == compared(scene)


@pytest.mark.parametrize("far", [1e9, 1e15, 1e300])
def test_neighbours_are_found_far_from_the_origin(far: float) -> None:
    """Beyond the last cell of the grid all are in one: discs that touch are still found."""
    pair = [Body(Circle(1), mass=1.0, position=(far, y)) for y in (0, 1, 9)]
    assert has_neighbour(Scene(pair), LEAST_MARGIN).tolist() == [True, True, False]


def test_neighbours_of_a_heap_are_all_without_a_look() -> None:
    """Too many pairs to write down: a row of them would fill the memory."""
    heap = [Body(Circle(1), mass=1.0)] * PAIRS_ANYWAY
    alone = Body(Circle(1), mass=1.0, position=(100, 0))
    assert np.all(has_neighbour(Scene([*heap, alone]), LEAST_MARGIN))

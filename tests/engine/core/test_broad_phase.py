"""The broad phase: three ways to the same candidate pairs, against every box with every box."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core import broad_phase
from lesson_code.engine.core.broad_phase import (
    bound,
    box_of,
    has_left_box,
    most_pairs,
    put_pair,
    slot_of,
    slots_for,
    sort_pairs,
)
from lesson_code.engine.core.candidate_pairs import seek_pairs
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.constants import LAST_CELL, LEAST_MARGIN, MOST_MARGIN, STEPS_AHEAD
from lesson_code.engine.core.motion import move, turn_with_angle
from lesson_code.engine.core.rows import PairRow, World
from lesson_code.engine.core.tables import BROAD_PHASES, world_of

ROUNDING = 1e-14
"""m, of boxes of some metres: a turned corner is right to 1e-16 of its distance."""

WAYS = sorted(BROAD_PHASES)

seeds = st.integers(0, 10**9)
scenes_by_seed = settings(max_examples=share(60), phases=[Phase.explicit, Phase.generate])

PLACES = {
    "scattered": lambda rng, n: rng.uniform(-6, 6, (n, 2)),
    "dense": lambda rng, n: rng.uniform(-1.5, 1.5, (n, 2)),
    "coincident": lambda rng, n: np.zeros((n, 2)) + rng.integers(-1, 2, 2),
    "on a lattice": lambda rng, n: rng.integers(-4, 5, (n, 2)) * 0.6,
    "on a line": lambda rng, n: np.column_stack([rng.uniform(-9, 9, n), np.full(n, -3.0)]),
    "far away": lambda rng, n: 1e9 + rng.uniform(-6, 6, (n, 2)),
    "far away and negative": lambda rng, n: -1e9 + rng.uniform(-6, 6, (n, 2)),
    "very far away": lambda rng, n: 1e16 + rng.uniform(-60, 60, (n, 2)),
}
SIZES = {
    "equal": lambda _: 0.3,
    "mixed": lambda rng: float(np.exp(rng.uniform(-3, 1))),
    "nearly equal": lambda rng: rng.uniform(0.25, 0.35),
}


def some_shape(rng: np.random.Generator, size: float) -> Any:
    """Return a circle, polygon or rod of a size."""
    kind = rng.integers(4)
    if kind == 0:
        return Polygon.box(2 * size, size)
    if kind == 1:
        return Segment((-size, 0), (size, 0), radius=size / 10)
    return Circle(size)


def some_scene(seed: int, places: str, sizes: str) -> Scene:
    """Return up to 40 turned bodies, a third of them static, and sometimes a huge floor."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 41))
    bodies = [
        Body(
            some_shape(rng, SIZES[sizes](rng)),
            position=place,
            angle=rng.uniform(-3, 3),
            velocity=rng.uniform(-9, 9, 2),
            angular_velocity=rng.uniform(-9, 9),
            mass=None if rng.random() < 0.3 else 1.0,
        )
        for place in PLACES[places](rng, count)
    ]
    if rng.random() < 0.5:
        floor = Body(Segment((-500, -1), (500, -1)), position=bodies[0].position)
        bodies.insert(int(rng.integers(len(bodies) + 1)), floor)
    return Scene(bodies)


def world_from(scene: Scene) -> World:
    """Return the tables of a scene, its boxes drawn, without room for any pair."""
    world = world_of(scene, dt=0.01, iterations=1, combine=MixingRule())
    bound(world)
    return world


def draw_tight(world: World) -> World:
    """Draw the boxes without any margin, and return the tables."""
    for body in world.bodies:
        body.min_x, body.min_y, body.max_x, body.max_y = box_of(world, body)
    return world


def found(world: World, way: str) -> list[tuple[int, int]]:
    """Return the pairs of the boxes as they are drawn that a way finds, and make room for them."""
    while not seek_pairs(world, BROAD_PHASES[way]):
        add_capacity(world)
    return [(pair.a, pair.b) for pair in world.pairs[: world.state.pair_count]]


def all_found(world: World) -> dict[str, list[tuple[int, int]]]:
    """Return the pairs that each way finds."""
    return {way: found(world, way) for way in WAYS}


def brute_force(world: World) -> list[tuple[int, int]]:
    """Return every pair of boxes that share a point, and of which one body has a mass."""
    low = np.array([(b.min_x, b.min_y) for b in world.bodies])
    high = np.array([(b.max_x, b.max_y) for b in world.bodies])
    free = np.array([b.inv_m > 0 for b in world.bodies])
    share = (low[:, np.newaxis] <= high) & (high[:, np.newaxis] >= low)
    wanted = share.all(axis=-1) & (free[:, np.newaxis] | free)
    return [(int(a), int(b)) for a, b in np.argwhere(np.triu(wanted, k=1))]


# The boxes


@scenes_by_seed
@given(seed=seeds)
def test_box_of_a_turned_shape_just_holds_it(seed: int) -> None:
    """Each side touches the shape: the farthest corner of the outline, and the rounding."""
    scene = some_scene(seed, "scattered", "mixed")
    world = draw_tight(world_from(scene))
    for row, body in zip(world.bodies, scene.bodies, strict=True):
        c, s = math.cos(body.angle), math.sin(body.angle)
        corners = np.array(body.shape.outline or [(0.0, 0.0)]) @ [[c, s], [-s, c]]
        low = body.position + corners.min(axis=0) - body.shape.rounding
        high = body.position + corners.max(axis=0) + body.shape.rounding
        size = np.abs([low, high]).max()
        np.testing.assert_allclose((row.min_x, row.min_y), low, atol=ROUNDING * size)
        np.testing.assert_allclose((row.max_x, row.max_y), high, atol=ROUNDING * size)


def some_speeds(seed: int) -> Scene:
    """Return bodies that move at up to 1e-3, 1 or 1e3 m/s."""
    scene = some_scene(seed, "scattered", "mixed")
    speed = 10.0 ** (3 * (seed % 3) - 3)
    bodies = [replace(body, velocity=speed * np.array(body.velocity)) for body in scene.bodies]
    return Scene(bodies)


@scenes_by_seed
@given(seed=seeds)
def test_margin_of_a_box_is_the_way_of_the_fastest_within_limits(seed: int) -> None:
    """On all four sides alike; 4 steps of it, but 5 to 35 % of the body's own width."""
    scene = some_speeds(seed)
    world = world_from(scene)
    speeds = [np.hypot(*body.velocity) for body in scene.bodies if not body.is_static]
    way = STEPS_AHEAD * max(speeds, default=0.0) * world.state.dt
    for body in world.bodies:
        left, low, right, high = box_of(world, body)
        margins = [left - body.min_x, low - body.min_y, body.max_x - right, body.max_y - high]
        if body.inv_m == 0.0:
            assert margins == [0.0] * 4
        else:
            expected = np.clip(way, LEAST_MARGIN * body.min_width, MOST_MARGIN * body.min_width)
            assert margins == pytest.approx([expected] * 4, abs=100 * ROUNDING)


def test_box_has_been_left_when_any_side_is_outside_it() -> None:
    """By more than the margin, whichever way; a wall leaves its own by any move at all."""
    discs = [Body(Circle(0.5), mass=1, position=(2.0 * k, 0)) for k in range(3)]
    world = world_from(Scene([*discs, Body(Circle(0.5))]))
    disc, wall = world.bodies[1], world.bodies[3]
    margin = LEAST_MARGIN * 1.0
    assert not has_left_box(world)
    for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        for way, leaves in ((0.99 * margin, False), (1.01 * margin, True)):
            disc.x, disc.y = 2.0 + way * x, way * y
            assert has_left_box(world) == leaves
    disc.x, disc.y = 2.0, 0.0
    wall.x = 1e-9
    assert has_left_box(world)


def test_box_of_a_body_that_turns_is_left_by_a_corner() -> None:
    """A beam that turns on the spot by 3 degrees moves its ends by 5 cm of a metre."""
    world = world_from(Scene([Body(Polygon.box(2, 0.2), mass=1)]))
    beam = world.bodies[0]
    for angle, leaves in ((0.005, False), (0.05, True)):
        beam.angle = angle
        turn_with_angle(world, beam)
        assert has_left_box(world) == leaves


# The pairs


@pytest.mark.parametrize("sizes", SIZES)
@pytest.mark.parametrize("places", PLACES)
@settings(max_examples=share(15), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds)
def test_pairs_of_any_scene_are_those_of_brute_force(places: str, sizes: str, seed: int) -> None:
    """The same pairs in the same order from each way: a < b, sorted by a, then by b."""
    world = world_from(some_scene(seed, places, sizes))
    assert all_found(world) == dict.fromkeys(WAYS, brute_force(world))


@pytest.mark.parametrize("sizes", SIZES)
@settings(max_examples=share(20), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds)
def test_pairs_hold_every_pair_that_overlaps(sizes: str, seed: int) -> None:
    """Boxes with a margin overlap wherever boxes without one do."""
    scene = some_scene(seed, "dense", sizes)
    overlapping = brute_force(draw_tight(world_from(scene)))
    for way in WAYS:
        pairs = found(world_from(scene), way)
        assert len(pairs) == len(set(pairs))
        assert set(overlapping) <= set(pairs)


@pytest.mark.parametrize("places", PLACES)
@settings(max_examples=share(10), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds)
def test_pairs_in_a_grid_of_few_slots_are_those_of_brute_force(places: str, seed: int) -> None:
    """Eight slots for 40 bodies: cells share them, and rows of cells go on at the first slot."""
    world = world_from(some_scene(seed, places, "nearly equal"))
    world.state.slot_count, world.state.row_stride = 8, 5
    del world.slots[9:], world.fixed_slots[8:]
    assert found(world, "uniform_grid") == brute_force(world)


@pytest.mark.parametrize("kept", [True, False], ids=["pushed", "fixed"])
def test_pairs_across_the_last_slot_are_found(kept: bool) -> None:
    """Every place in a row of cells is once the one whose right neighbour has slot 0."""
    for k in range(40):
        bodies = [
            Body(Circle(0.3), mass=1, position=(k, 0.1)),
            Body(Circle(0.3), mass=1 if kept else None, position=(k + 0.5, 0)),
        ]
        world = world_from(Scene(bodies))
        assert slots_for(2) < 40
        assert found(world, "uniform_grid") == [(0, 1)]


@pytest.mark.parametrize("cells", [1e9, -1e9, 2.0**31, -(2.0**31), 2.0**63, 1e25])
def test_pairs_around_the_last_cell_are_found(cells: float) -> None:
    """A row of discs across it; and far beyond it, where all lie in one cell."""
    cell = world_from(discs(30, 0.5)).state.cell_size
    start = cells * cell - 15 * 0.9
    row = [Body(Circle(0.5), mass=1, position=(start + 0.9 * k, -start)) for k in range(30)]
    world = world_from(Scene(row))
    assert all_found(world) == dict.fromkeys(WAYS, brute_force(world))
    assert max(abs(place.cell_x) for place in world.places) <= LAST_CELL


def test_slots_of_neighbouring_cells_are_different() -> None:
    """Beside each other in a row, far away in the next, and never outside the table."""
    world = world_from(Scene([Body(Circle(1), mass=1)] * 100))
    state = world.state
    assert len(world.slots) == state.slot_count + 1 == slots_for(100) + 1 > 200
    for x, y in ((0, 0), (-1, -1), (10**9, -(10**9)), (-3, 10**12)):
        slots = {slot_of(state, x + i, y + j) for i in range(3) for j in range(3)}
        assert len(slots) == 9
        assert all(0 <= slot < state.slot_count for slot in slots)
        assert slot_of(state, x + 1, y) == (slot_of(state, x, y) + 1) % state.slot_count


@settings(max_examples=share(20), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds)
def test_pairs_of_bodies_that_move_are_those_of_brute_force(seed: int) -> None:
    """Step after step: the sweep goes on from the order of the last one."""
    world = world_from(some_scene(seed, "scattered", "mixed"))
    for _ in range(5):
        assert all_found(world) == dict.fromkeys(WAYS, brute_force(world))
        move(world)
        bound(world)


@pytest.mark.parametrize("radius", [0.1, 0.3, 0.35, 0.5, 0.7])
def test_pairs_of_boxes_that_only_just_touch_are_found_by_all(radius: float) -> None:
    """Discs side by side, and an ulp less or more: what is beside a cell must not be lost."""
    for k in range(-20, 20):
        x = 2 * radius * k
        for right in (x + 2 * radius, math.nextafter(x + 2 * radius, math.inf)):
            bodies = [Body(Circle(radius), mass=1, position=(p, p)) for p in (x, right)]
            world = draw_tight(world_from(Scene(bodies)))
            assert all_found(world) == dict.fromkeys(WAYS, brute_force(world))


@pytest.mark.parametrize("way", WAYS)
def test_pair_of_two_static_bodies_is_none(way: str) -> None:
    """Walls that cross are no contact; a body between them has one with each."""
    walls = [Body(Circle(0.5)), Body(Circle(0.5), velocity=(1, 0)), Body(Circle(0.5), mass=1)]
    assert found(world_from(Scene(walls)), way) == [(0, 2), (1, 2)]


@pytest.mark.parametrize("way", WAYS)
def test_pairs_of_no_bodies_are_none(way: str) -> None:
    """An empty scene has no boxes to compare."""
    assert found(world_from(Scene()), way) == []


@pytest.mark.parametrize("way", WAYS)
def test_pairs_of_a_floor_and_many_balls_are_one_each(way: str) -> None:
    """A floor as long as all the balls together fits into no cell of theirs."""
    balls = [Body(Circle(0.3), mass=1, position=(k, 0.2)) for k in range(50)]
    floor = Body(Segment((-10, 0), (60, 0)))
    assert found(world_from(Scene([*balls, floor])), way) == [(k, 50) for k in range(50)]


# Room


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("room", [0, 1, 10])
def test_count_of_pairs_without_room_for_them_is_right(way: str, room: int) -> None:
    """A way says how many there are, writes what it can and no more: so room can be made."""
    scene = some_scene(4, "dense", "mixed")
    pairs = brute_force(world_from(scene))
    world = world_from(scene)
    world.pairs.extend(PairRow() for _ in range(room))
    assert BROAD_PHASES[way](world) == len(pairs) > 10
    assert len(world.pairs) == room


@pytest.mark.parametrize("way", WAYS)
def test_pairs_beyond_the_room_are_said_and_not_used(way: str) -> None:
    """Too small a table: no pairs to go on with, and how many are wanted is noted."""
    world = world_from(some_scene(4, "dense", "mixed"))
    assert not seek_pairs(world, BROAD_PHASES[way])
    assert (world.state.has_pairs, world.state.pair_count) == (False, 0)
    assert world.state.pairs_wanted == len(brute_force(world))


@pytest.mark.parametrize("way", WAYS)
def test_pairs_of_a_heap_in_one_place_are_refused(way: str) -> None:
    """400 bodies in one place have 79,800 pairs: more than the 50 x 400 + 10,000 allowed."""
    world = world_from(Scene([Body(Circle(0.5), mass=1) for _ in range(400)]))
    assert most_pairs(400) == 30_000
    with pytest.raises(ValueError, match=r"bodies must not be heaped .*: 400 of them overlap in"):
        found(world, way)
    assert world.pairs == []


@pytest.mark.parametrize("way", WAYS)
def test_pairs_of_a_moderate_heap_are_found(way: str) -> None:
    """100 bodies in one place are unusual and allowed: 4,950 pairs."""
    world = world_from(Scene([Body(Circle(0.5), mass=1) for _ in range(100)]))
    assert len(found(world, way)) == world.state.pair_count == 4950


# Order


@scenes_by_seed
@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), max_size=30))
def test_sorted_pairs_are_those_that_python_sorts(pairs: list[tuple[int, int]]) -> None:
    """Two counting sorts make one sort by a, then by b; none is lost, none twice."""
    world = world_from(Scene([Body(Circle(1), mass=1)] * 10))
    world.state.pairs_wanted = 30
    add_capacity(world)
    count = 0
    for a, b in pairs:
        count = put_pair(world.pairs, count, a, b, is_pair=True)
    assert sort_pairs(world, count) == len(pairs)
    assert [(pair.a, pair.b) for pair in world.pairs[:count]] == sorted(
        (min(pair), max(pair)) for pair in pairs
    )


def test_two_that_are_no_pair_are_written_over_by_the_next() -> None:
    """They do not count; and where there is no room nothing is written."""
    pairs = [PairRow()]
    assert put_pair(pairs, 0, 5, 4, is_pair=False) == 0
    assert put_pair(pairs, 0, 3, 2, is_pair=True) == 1
    assert put_pair(pairs, 1, 7, 6, is_pair=True) == 2
    assert pairs == [PairRow(2, 3)]


# Work


def comparisons(monkeypatch: pytest.MonkeyPatch, scene: Scene, way: str) -> int:
    """Return how many boxes a way compares with another."""
    world = world_from(scene)
    found(world, way)  # from now on the sweep's order is right
    asked: list[int] = []
    compare = broad_phase.boxes_overlap
    with monkeypatch.context() as patch:
        patch.setattr(broad_phase, "boxes_overlap", lambda a, b: asked.append(1) or compare(a, b))
        found(world, way)
    return len(asked)


def discs(count: int, radius: float) -> Scene:
    """Return discs scattered over a square, one for each square metre on average."""
    rng = np.random.default_rng(1)
    places = rng.uniform(0, math.sqrt(count), (count, 2))
    return Scene([Body(Circle(radius), mass=1, position=place) for place in places])


def pairs_nearby(world: World) -> int:
    """Return how many pairs lie in one cell or in neighbouring ones."""
    cells = np.array([(place.cell_x, place.cell_y) for place in world.places])
    near = (abs(cells[:, np.newaxis] - cells) <= 1).all(axis=-1)
    return int(np.triu(near, k=1).sum())


@pytest.mark.parametrize("count", [400, 1600])
@pytest.mark.parametrize("radius", [0.1, 0.3, 0.5])
def test_work_of_the_grid_is_the_pairs_in_neighbouring_cells(
    monkeypatch: pytest.MonkeyPatch, radius: float, count: int
) -> None:
    """Each once, and of the others no more than chance puts into the five slots looked at.

    A cell is 1.01 x 1.7 diameters wide. Nine of them hold 4.8 others of radius 0.3 m around a
    disc, and half of these come later; less at the edges of the square. The work for a disc does
    not grow with the number of discs; all pairs of 1600 would be 800 for each.
    """
    world = world_from(discs(count, radius))
    found(world, "uniform_grid")
    asked = comparisons(monkeypatch, discs(count, radius), "uniform_grid")
    by_chance = 5 * count * count / slots_for(count)
    assert pairs_nearby(world) <= asked <= pairs_nearby(world) + by_chance
    assert asked <= 4.5 * (1.01 * 1.7 * 2 * radius) ** 2 * count + by_chance


def test_work_of_the_sweep_is_what_overlaps_in_x(monkeypatch: pytest.MonkeyPatch) -> None:
    """Discs in a row: each is compared with its neighbour alone."""
    row = Scene([Body(Circle(0.5), mass=1, position=(0.9 * k, 0)) for k in range(100)])
    assert comparisons(monkeypatch, row, "sweep_and_prune") == 99


def test_work_of_the_grid_for_walls_alone_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    """10,000 static bodies in one place cost no comparison: nothing there can be pushed."""
    walls = Scene([Body(Circle(0.5)) for _ in range(10_000)])
    assert comparisons(monkeypatch, walls, "uniform_grid") == 0

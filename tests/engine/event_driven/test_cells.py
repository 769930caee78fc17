"""The grid: every disc is found where it is, and every neighbour that it could touch."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine.core.broad_phase import slot_of
from lesson_code.engine.core.constants import FEWEST_FOR_GRID
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.event_driven.cells import (
    border_gap,
    cross_border,
    is_endless,
    leave_cell,
    put_into_slot,
)
from lesson_code.engine.event_driven.loop import next_event, next_time
from lesson_code.engine.event_driven.motion import place_at
from lesson_code.engine.event_driven.rows import Tables
from lesson_code.engine.event_driven.tables import tables_of

ELASTIC = Material(restitution=1.0)

ON_THE_BORDER = 1e-9
"""m: a disc that is about to cross may be beyond the border by rounding."""


def scattered(count: int, seed: int, extra: tuple[Body, ...] = (), **settings: float) -> Scene:
    """Return discs of several sizes, somewhere in 8 m x 8 m, that fly in all directions."""
    rng = np.random.default_rng(seed)
    discs = [
        Body(
            Circle(rng.uniform(0.1, 0.3)),
            mass=1.0,
            position=(i % 8 + rng.uniform(-0.1, 0.1), i // 8 + rng.uniform(-0.1, 0.1)),
            velocity=rng.uniform(-3, 3, 2),
            material=ELASTIC,
        )
        for i in range(count)
    ]
    return Scene([*extra, *discs], **settings)


def tables_for(scene: Scene) -> Tables:
    """Return the tables of a scene at its start."""
    return tables_of(scene, mixing_rule("workbook"), has_grid=True)


def found_in_cell(tables: Tables, cell_x: int, cell_y: int) -> list[int]:
    """Return the discs that the grid finds in a cell."""
    found, i = [], tables.slots[slot_of(tables.state, cell_x, cell_y)].first_disc
    while i >= 0:
        if (tables.discs[i].cell_x, tables.discs[i].cell_y) == (cell_x, cell_y):
            found.append(i)
        i = tables.discs[i].next_in_slot
    return found


def box() -> tuple[Body, ...]:
    """Return walls around 8 m x 8 m."""
    ends = (((-1, -1), (9, -1)), ((-1, 9), (9, 9)), ((-1, -1), (-1, 9)), ((9, -1), (9, 9)))
    return tuple(Body(Segment(*pair), material=ELASTIC) for pair in ends)


def test_every_disc_is_found_in_its_cell_after_thousands_of_events() -> None:
    """Exactly once, and its centre is in that cell."""
    solver = ExactSolver(
        scattered(64, 1, box()), combine=mixing_rule("workbook"), keep_impulses=False
    )
    tables, size, crossings = solver.tables, solver.tables.state.cell_size, 0
    for event in range(6000):
        first = tables.discs[tables.queue[1].disc]
        crossings += first.border_time <= first.event_time
        next_event(tables)
        if event % 100 == 0:
            for i, disc in enumerate(tables.discs):
                assert found_in_cell(tables, disc.cell_x, disc.cell_y).count(i) == 1
                x, y = place_at(disc, tables.state.now)
                assert abs(x - (disc.cell_x + 0.5) * size) <= size / 2 + ON_THE_BORDER
                assert abs(y - (disc.cell_y + 0.5) * size) <= size / 2 + ON_THE_BORDER
    assert crossings > 1000


def test_discs_that_touch_are_in_neighbouring_cells_at_any_time() -> None:
    """So that no pair is forgotten: the cells around hold all that a disc could touch."""
    solver = ExactSolver(scattered(64, 2, box()), combine=mixing_rule("workbook"))
    discs = solver.tables.discs
    pairs = 0
    for _ in range(200):
        time = solver.next_collision(math.inf)
        assert time is not None
        places = np.array([place_at(disc, time) for disc in discs])
        cells = np.array([(disc.cell_x, disc.cell_y) for disc in discs])
        radii = np.array([disc.radius for disc in discs])
        for i in range(len(discs)):
            near = np.hypot(*(places - places[i]).T) <= radii + radii[i] + ON_THE_BORDER
            near &= np.arange(len(discs)) != i
            pairs += int(near.sum())
            assert (np.abs(cells[near] - cells[i]) <= 1).all()
    assert pairs > 100


def test_discs_may_enter_and_leave_in_any_order() -> None:
    """First, last or in the middle of a slot's list: the others stay."""
    tables = tables_for(Scene([Body(Circle(0.5), mass=1.0)] * 20))
    present = set(range(20))
    rng = np.random.default_rng(3)
    for i in rng.integers(0, 20, 400).tolist():
        if i in present:
            leave_cell(tables, i)
        else:
            put_into_slot(tables, i)
        present ^= {i}
        assert sorted(found_in_cell(tables, 0, 0)) == sorted(present)


@pytest.mark.parametrize(("side", "cell"), [(0, (1, 0)), (1, (-1, 0)), (2, (0, 1)), (3, (0, -1))])
def test_disc_that_crosses_a_border_is_found_beyond_it(side: int, cell: tuple[int, int]) -> None:
    """Sides 0 to 3 are right, left, up and down."""
    tables = tables_for(Scene([Body(Circle(0.5), mass=1.0, position=(0.5, 0.5))] * 20))
    cross_border(tables, 7, side)
    assert found_in_cell(tables, *cell) == [7]
    assert 7 not in found_in_cell(tables, 0, 0)


def test_gaps_to_the_borders_of_a_cell_worked_by_hand() -> None:
    """A disc of 0.5 m: its cell is 1 m wide, but for a margin."""
    tables = tables_for(Scene([Body(Circle(0.5), mass=1.0, position=(0.25, 2.5))] * 20))
    gaps = [border_gap(tables.state, tables.discs[0], side, 0.25, 2.5) for side in range(4)]
    assert gaps == pytest.approx([0.75, 0.25, 0.5, 0.5], abs=1e-8)


def test_discs_without_a_grid_have_one_cell_without_borders() -> None:
    """Wherever they are, they are all looked at, and no border is an event."""
    places = [(-3.0, -3.0), (3.0, 3.0), (1e9, -1e9)]
    scene = Scene([Body(Circle(0.5), mass=1.0, position=x) for x in places])
    tables = tables_of(scene, mixing_rule("workbook"), has_grid=False)
    assert math.isinf(tables.state.cell_size)
    assert {(disc.cell_x, disc.cell_y) for disc in tables.discs} == {(0, 0)}
    assert all(is_endless(tables.state, tables.discs[0], side) for side in range(4))


def test_many_discs_that_fly_apart_for_ever_cross_no_borders_in_the_end() -> None:
    """The outermost cells go on for ever: a year of flight takes a few hundred events."""
    scene = scattered(32, 4)
    solver = ExactSolver(scene, combine=mixing_rule("workbook"), keep_impulses=False)
    for _ in range(5000):
        if math.isinf(next_time(solver.tables)):
            break
        next_event(solver.tables)
    assert math.isinf(next_time(solver.tables))


def test_discs_that_fly_in_from_far_away_meet_all_the_same() -> None:
    """In an endless cell, too, neighbours are found."""
    disc = Circle(0.01)
    swarm = [Body(disc, mass=1.0, position=(k, 0)) for k in range(FEWEST_FOR_GRID)]
    pair = [
        Body(disc, mass=1.0, position=(0, 1000), velocity=(1, 1)),
        Body(disc, mass=1.0, position=(100, 1000), velocity=(-1, 1)),
    ]
    solver = ExactSolver(Scene([*swarm, *pair]), combine=mixing_rule("workbook"))
    assert solver.next_collision(1e9) == pytest.approx(49.99)


def test_obstacle_is_noted_wherever_a_disc_could_touch_it() -> None:
    """From the start and at any time: all cells that a disc near it can be in."""
    wall = Body(Polygon.box(2.0, 1.0), position=(3.7, 3.2), angle=0.7)
    tables = tables_for(scattered(40, 5, (wall,)))
    size, noted = tables.state.cell_size, {(near.cell_x, near.cell_y) for near in tables.near}
    for turn in np.linspace(0, 2 * math.pi, 200):
        corner = np.abs(np.array([math.cos(turn), math.sin(turn)])).max()
        x = 3.7 + math.cos(turn) / corner * 1.0
        y = 3.2 + math.sin(turn) / corner * 0.5
        assert (math.floor(x / size), math.floor(y / size)) in noted
    assert not tables.everywhere


def test_large_or_moving_obstacle_is_near_everywhere() -> None:
    """A block that fills the grid is not noted in thousands of cells, nor is a wall that moves."""
    block = Body(Polygon.box(1000, 1000), position=(3.0, -490.0))
    piston = Body(Segment((-5, -2), (-5, 2)), velocity=(0.1, 0))
    tables = tables_for(scattered(4000, 6, (block, piston)))
    assert [row.index for row in tables.everywhere] == [0, 1]
    assert not tables.near


def test_walls_much_larger_than_a_room_are_noted_along_it() -> None:
    """The grid ends at their near sides, wherever the discs begin; inside no wall is looked at.

    Beyond, it goes on for ever: a disc that begins outside meets them, too.
    """
    h, size = 500.0, 20.0
    corners = [(-h, -h), (size + h, -h), (size + h, size + h), (-h, size + h)]
    ends = zip(corners, corners[1:] + corners[:1], strict=True)
    tables = tables_for(scattered(40, 5, [Body(Segment(a, b, h)) for a, b in ends]))
    state, cell = tables.state, tables.state.cell_size
    assert not tables.everywhere
    assert (state.first_x, state.first_y) == (-2, -2)
    assert state.last_x == state.last_y == math.floor(size / cell) + 1
    for k in range(4):
        noted = {(near.cell_x, near.cell_y) for near in tables.near if near.obstacle == k}
        axis, is_high = (1, 0, 1, 0)[k], k in (1, 2)
        edge = math.floor(size / cell) if is_high else 0
        for place in range(math.floor(size / cell)):
            assert ((edge, place) if axis == 0 else (place, edge)) in noted
            if 3 < place < size / cell - 3:
                assert (place, place) not in noted

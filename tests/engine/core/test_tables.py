"""From a scene to the engine's tables."""

from __future__ import annotations

import math
from typing import Any

import pytest

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core.constants import FEWEST_FOR_GRID, LARGEST_IN_GRID, MOST_MARGIN
from lesson_code.engine.core.mixing import GEOMETRIC_MEAN, MAX, UNSPECIFIED
from lesson_code.engine.core.rows import BodyRow, World
from lesson_code.engine.core.sight import Sight
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.effects.question import Question


def tables(*bodies: Body, **scene: Any) -> World:
    """Return the tables of a scene."""
    return world_of(Scene(bodies, **scene), 0.01, 7, MixingRule("max", "geometric_mean"))


def test_row_of_a_body_holds_what_the_scene_says() -> None:
    """Mass and inertia become their inverses: a disc of 4 kg and 0.5 m has I = 0.5."""
    body = Body(
        Circle(0.5), mass=4, position=(1, 2), velocity=(3, 4), angle=math.pi / 2,
        angular_velocity=6, material=Material(0.7, 0.8),
    )  # fmt: skip
    [row] = tables(body).bodies
    assert (row.x, row.y, row.vx, row.vy, row.w) == (1, 2, 3, 4, 6)
    assert (row.inv_m, row.inv_i, row.radius, row.corner_count) == (0.25, 2.0, 0.5, 0)
    assert (row.restitution, row.friction, row.min_width) == (0.7, 0.8, 1.0)
    assert (row.angle, row.sin) == (math.pi / 2, 1.0)


def test_reach_is_that_of_the_body_that_is_seen_through_first() -> None:
    """Part of its width, but no more than half of its matter and its skin; a line has no matter."""
    plank = Body(Polygon.box(4, 2), mass=1)
    line = Body(Segment((-3, 0), (3, 0)), mass=1)
    rod = Body(Segment((-3, 0), (3, 0), radius=0.25), mass=1)
    wall = Body(Segment((0, 0), (0, 1e-3)))
    for bodies, skin, reach, expected in (
        ([plank, wall], 0.0, 0.5, 1.0),
        ([plank, rod], 0.0, 0.5, 0.25),
        ([plank, line], 0.0, 0.5, 0.0),
        ([plank, line], 1e-3, 0.5, 6e-3),
        ([plank, rod], 0.1, 0.1, 0.05),
        ([wall], 0.1, 0.1, math.inf),
    ):
        sight = Sight(skin, reach)
        world = world_of(Scene(bodies), 0.01, 1, MixingRule(), sight)
        assert world.state.reach == pytest.approx(expected, rel=1e-15)
        assert Question(Scene(bodies), sight=sight).facts.room == world.state.reach


def test_row_of_a_static_body_cannot_be_moved_and_is_no_scale() -> None:
    """Its width does not matter for what overlap is small: the other body's does."""
    [row] = tables(Body(Segment((0, 0), (1, 0)))).bodies
    assert (row.inv_m, row.inv_i, row.min_width) == (0.0, 0.0, math.inf)
    assert (row.restitution, row.friction) == (UNSPECIFIED, UNSPECIFIED)


def test_row_of_a_body_that_never_turns_has_an_inverse_inertia_of_zero() -> None:
    """1 / infinity."""
    [row] = tables(Body(Circle(1), mass=2, inertia=math.inf)).bodies
    assert (row.inv_m, row.inv_i) == (0.5, 0.0)


def test_outlines_of_all_bodies_stand_one_after_the_other_turned() -> None:
    """A circle has none; a rod is a rounded line; a quarter turn swaps the sides of a box."""
    rod = Body(Segment((-1, 0), (1, 0), radius=0.1))
    world = tables(Body(Circle(1)), rod, Body(Polygon.box(2, 4), angle=math.pi / 2))
    ranges = [(row.first_corner, row.corner_count, row.radius) for row in world.bodies]
    assert ranges == [(0, 0, 1.0), (0, 2, 0.1), (2, 4, 0.0)]
    assert max(corner.x for corner in world.corners[2:]) == pytest.approx(2)
    assert max(corner.local_x for corner in world.corners[2:]) == 1.0


def test_state_holds_the_settings() -> None:
    """And counts that begin at 0."""
    state = tables(gravity=(1, -2), damping=0.5).state
    assert (state.dt, state.iterations, state.damping) == (0.01, 7, 0.5)
    assert (state.gravity_x, state.gravity_y) == (1.0, -2.0)
    assert (state.restitution_rule, state.friction_rule) == (MAX, GEOMETRIC_MEAN)
    assert (state.pair_count, state.contact_count, state.memory_count) == (0, 0, 0)


def test_cell_of_the_grid_holds_every_body_but_a_few_much_larger_ones() -> None:
    """Discs of 1 to 2 m and a floor of 100 m: a little more than 2 m and a margin on each side."""
    discs = [Body(Circle(radius), mass=1) for radius in (0.5, 0.6, 1.0)]
    floor = Body(Segment((-50, 0), (50, 0)))
    assert tables(*discs, floor).state.cell_size == pytest.approx(2 + 2 * 0.7, rel=0.02)


@pytest.mark.parametrize("factor", [0.99, 1.01])
def test_cell_of_the_grid_leaves_out_what_is_larger_than_its_limit(factor: float) -> None:
    """Up to four times the median a body still shapes the cells."""
    large = 0.5 * LARGEST_IN_GRID * factor
    bodies = [Body(Circle(r), mass=1) for r in (0.5, 0.5, 0.5, large)]
    width = 2 * large if factor < 1 else 1.0
    with_margins = width * (1 + 2 * MOST_MARGIN)
    assert tables(*bodies).state.cell_size == pytest.approx(with_margins, rel=0.02)


def test_cell_of_the_grid_without_bodies_is_a_metre() -> None:
    """Any will do, but 0."""
    assert tables().state.cell_size == 1.0


@pytest.mark.parametrize(("count", "name"), [(-1, "all_pairs"), (0, "uniform_grid")])
def test_broad_phase_is_chosen_by_the_number_of_bodies(count: int, name: str) -> None:
    """Below two dozen the grid does not repay its upkeep."""
    scene = Scene([Body(Circle(1))] * (FEWEST_FOR_GRID + count))
    assert broad_phase_for(scene) == name
    assert name in BROAD_PHASES


def test_rows_of_two_worlds_are_not_shared() -> None:
    """A scene can be run again: no run changes what another one starts from."""
    body = Body(Polygon.box(1, 1), mass=1)
    first, second = tables(body), tables(body)
    first.bodies[0].x, first.corners[0].x = 5.0, 5.0
    assert (second.bodies[0].x, second.corners[0].x) == (0.0, -0.5)


def test_rows_take_no_field_that_they_do_not_have() -> None:
    """A misspelt field is an error and not a new one."""
    with pytest.raises(AttributeError):
        BodyRow().velocity_x = 1.0  # type: ignore[attr-defined]

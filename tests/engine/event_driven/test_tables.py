"""From a scene to the tables of the event-driven solver."""

from __future__ import annotations

import math

import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine.core.mixing import UNSPECIFIED, mixing_rule
from lesson_code.engine.event_driven.constants import HOP, REST, STILL
from lesson_code.engine.event_driven.loop import next_time
from lesson_code.engine.event_driven.rows import Tables
from lesson_code.engine.event_driven.tables import tables_of


def tables_for(*bodies: Body, gravity: tuple[float, float] = (0.0, 0.0)) -> Tables:
    """Return the tables of a scene, with a grid."""
    return tables_of(Scene(bodies, gravity), mixing_rule("workbook"), has_grid=True)


def test_discs_and_obstacles_keep_their_places_in_the_scene() -> None:
    """Discs are what can be pushed; a static circle is an obstacle."""
    tables = tables_for(
        Body(Circle(1.0)),
        Body(Circle(0.5), mass=2.0, position=(3, 4), velocity=(1, 2), angular_velocity=5),
        Body(Segment((0, 0), (1, 0))),
        Body(Circle(0.25), mass=1.0, inertia=math.inf, material=Material(0.3, 0.4)),
    )
    assert [disc.body for disc in tables.discs] == [1, 3]
    assert [row.index for row in tables.obstacle_bodies] == [0, 2]
    first, second = tables.discs
    assert (first.x, first.y, first.vx, first.vy, first.w) == (3.0, 4.0, 1.0, 2.0, 5.0)
    assert (first.inv_m, first.inv_i, first.radius) == (0.5, 4.0, 0.5)
    assert (first.restitution, first.friction) == (UNSPECIFIED, UNSPECIFIED)
    assert (second.inv_i, second.restitution, second.friction) == (0.0, 0.3, 0.4)


def test_discs_fall_from_the_start() -> None:
    """Gravity alone acts on them."""
    disc = tables_for(Body(Circle(0.5), mass=2.0), gravity=(1.0, -10.0)).discs[0]
    assert (disc.ax, disc.ay, disc.support) == (1.0, -10.0, -1)


def test_small_speeds_are_in_proportion_to_the_scene() -> None:
    """Of the fastest body or, where that is more, of a fall by a radius."""
    still = tables_for(Body(Circle(0.4), mass=1.0), gravity=(0.0, -10.0)).state
    assert still.rest == pytest.approx(REST * 2.0)
    assert still.hop == pytest.approx(HOP * 2.0)
    fast = tables_for(Body(Circle(0.4), mass=1.0, velocity=(30, 40)), gravity=(0.0, -10.0)).state
    assert fast.still == pytest.approx(STILL * 50)
    assert fast.hop == pytest.approx(HOP * 2.0)


def test_scene_without_gravity_has_no_hops() -> None:
    """Nothing lies on anything."""
    state = tables_for(Body(Circle(0.4), mass=1.0, velocity=(3, 4))).state
    assert (state.hop, state.window, state.pile_time) == (0.0, 0.0, 0.0)


def test_cell_is_a_little_wider_than_the_largest_disc() -> None:
    """Obstacles do not count: they are noted in as many cells as they need."""
    discs = [Body(Circle(0.1 + 0.01 * k), mass=1.0, position=(k, 0)) for k in range(20)]
    size = tables_for(Body(Polygon.box(9, 9), position=(0, 20)), *discs).state.cell_size
    assert size == pytest.approx(2 * 0.29)
    assert size > 2 * 0.29


def test_tables_of_an_empty_scene_are_empty() -> None:
    """No disc, no obstacle, no event."""
    tables = tables_for()
    assert (tables.discs, tables.obstacles, next_time(tables)) == ([], [], math.inf)

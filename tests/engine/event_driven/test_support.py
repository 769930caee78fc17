"""Resting: what holds a disc on a face, how it moves along it, and when that ends."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven.rows import Tables
from lesson_code.engine.event_driven.support import (
    friction_of,
    grip_time,
    let_go,
    settle,
    share_held,
    slide_or_roll,
    slip_of,
    stop_sliding,
    time_to_end,
    ways_to_ends,
)
from lesson_code.engine.event_driven.tables import tables_of

UP = 1
"""The face of :func:`resting`'s floor that looks up: its corners run to the left."""


def resting(friction: float = 0.2, angle: float = 0.0, **ball: Any) -> Tables:
    """Return a disc of 0.5 m that touches a floor from -4 to 4 m, and has been laid down on it."""
    c, s = math.cos(angle), math.sin(angle)
    values: dict[str, Any] = {"mass": 2.0, "position": (-0.5 * s, 0.5 * c)} | ball
    scene = Scene(
        [
            Body(Segment((4, 0), (-4, 0)), angle=angle, material=Material(0.0, friction)),
            Body(Circle(0.5), material=Material(0.0, friction), **values),
        ],
        gravity=(0, -10),
    )
    tables = tables_of(scene, mixing_rule("workbook"))
    settle(tables, tables.discs[0], 0, UP)
    return tables


def test_face_of_this_file_looks_up() -> None:
    """What the other tests take for granted."""
    tables = resting()
    assert (tables.corners[UP].nx, tables.corners[UP].ny) == (0.0, 1.0)


def test_disc_that_is_laid_down_keeps_only_its_speed_along_the_face() -> None:
    """And no acceleration through the floor."""
    disc = resting(velocity=(1.5, -0.3), angular_velocity=-3).discs[0]
    assert (disc.vx, disc.vy, disc.support, disc.face) == (1.5, 0.0, 0, UP)
    assert (disc.ax, disc.ay, disc.alpha) == (0.0, 0.0, 0.0)


def test_disc_on_a_moving_floor_keeps_the_floors_motion() -> None:
    """Only the velocity relative to the face loses its part along the normal."""
    scene = Scene(
        [Body(Segment((4, 0), (-4, 0)), velocity=(1, 2)), Body(Circle(0.5), mass=1.0)], (0, -10)
    )
    tables = tables_of(scene, mixing_rule("workbook"))
    settle(tables, tables.discs[0], 0, UP)
    assert tables.discs[0].vy == 2.0


def test_sliding_disc_is_braked_and_spun_up() -> None:
    """With a = -mu g = -2 m/s^2; alpha = -mu g r / (I/m) = -2 * 0.5 / 0.125 = -8 rad/s^2."""
    tables = resting(velocity=(3, 0))
    disc = tables.discs[0]
    assert (disc.ax, disc.ay, disc.alpha) == (pytest.approx(-2.0), 0.0, pytest.approx(-8.0))
    assert abs(slip_of(tables, disc)) == 3.0
    assert grip_time(tables, disc) == pytest.approx(0.5)  # slip 3, change -2 - 8 * 0.5


def test_disc_without_friction_slides_for_ever() -> None:
    """Nothing brakes it, nothing ever grips."""
    tables = resting(friction=0.0, velocity=(3, 0))
    disc = tables.discs[0]
    assert (disc.ax, disc.alpha, grip_time(tables, disc)) == (0.0, 0.0, math.inf)


def test_rolling_disc_on_a_level_floor_rolls_on() -> None:
    """No slip, no friction, no end of it."""
    tables = resting(velocity=(1, 0), angular_velocity=-2)
    disc = tables.discs[0]
    assert slip_of(tables, disc) == 0.0
    assert (disc.ax, disc.alpha, grip_time(tables, disc)) == (0.0, 0.0, math.inf)


@given(angle=st.floats(0.01, 1.2), friction=st.floats(0, 2), mass=st.floats(0.1, 10))
def test_disc_on_a_slope_rolls_exactly_if_friction_can_hold_it(
    angle: float, friction: float, mass: float
) -> None:
    """For a disc a = 2/3 g sin, from mu = tan / 3 on; below that it slips."""
    tables = resting(friction, angle, mass=mass)
    disc = tables.discs[0]
    along = math.hypot(disc.ax, disc.ay)
    rolls = friction >= math.tan(angle) / 3
    expected = (
        20 / 3 * math.sin(angle) if rolls else 10 * (math.sin(angle) - friction * math.cos(angle))
    )
    assert along == pytest.approx(expected, rel=1e-9, abs=1e-9)
    rim = expected if rolls else 20 * friction * math.cos(angle)
    assert abs(disc.alpha) * 0.5 == pytest.approx(rim, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("k", "share"), [(0.5, 1 / 3), (1.0, 1 / 2), (math.inf, 1.0)])
def test_share_of_the_pull_that_friction_holds(k: float, share: float) -> None:
    """A disc, a hoop, and a body that cannot turn: friction must hold all of that."""
    assert share_held(k) == pytest.approx(share)


def test_friction_of_the_pair_is_combined() -> None:
    """The geometric mean, as everywhere in the workbook."""
    scene = Scene(
        [
            Body(Segment((4, 0), (-4, 0)), material=Material(0.0, 0.9)),
            Body(Circle(0.5), mass=1.0, material=Material(0.0, 0.4)),
        ],
        (0, -10),
    )
    tables = tables_of(scene, mixing_rule("workbook"))
    settle(tables, tables.discs[0], 0, UP)
    assert friction_of(tables, tables.discs[0]) == pytest.approx(0.6)


@pytest.mark.parametrize("inertia", [None, math.inf])
def test_rest_of_sliding_is_taken_away(inertia: float | None) -> None:
    """From the spin or, where the disc cannot turn, from its speed; then it grips."""
    tables = resting(velocity=(1e-8, 0), inertia=inertia)
    disc = tables.discs[0]
    stop_sliding(tables, disc)
    assert abs(slip_of(tables, disc)) <= tables.state.grips
    slide_or_roll(tables, disc)
    assert grip_time(tables, disc) == math.inf
    assert disc.ax == 0.0


def test_ways_and_time_to_the_ends_of_a_face() -> None:
    """1 m to the right of the middle of 8 m; at 2 m/s to the left."""
    tables = resting(friction=0.0, position=(1, 0.5), velocity=(-2, 0))
    assert sorted(ways_to_ends(tables, tables.discs[0])) == [3.0, 5.0]
    assert time_to_end(tables, tables.discs[0]) == pytest.approx(2.5)


def test_disc_at_rest_never_comes_to_an_end() -> None:
    """No speed, no pull."""
    tables = resting()
    assert time_to_end(tables, tables.discs[0]) == math.inf


def test_disc_that_is_let_go_falls() -> None:
    """Gravity alone."""
    tables = resting(velocity=(3, 0))
    let_go(tables.state, tables.discs[0])
    disc = tables.discs[0]
    assert (disc.support, disc.held, disc.ax, disc.ay, disc.alpha) == (-1, False, 0, -10, 0)


def test_face_of_a_polygon_holds_a_disc_as_a_segment_does() -> None:
    """The top of a crate, 1 m to either side."""
    scene = Scene(
        [Body(Polygon.box(2, 2), position=(5, -1)), Body(Circle(0.5), mass=1.0, position=(5, 0.5))],
        (0, -10),
    )
    tables = tables_of(scene, mixing_rule("workbook"))
    top = next(k for k, c in enumerate(tables.corners) if c.ny > 0.9)
    settle(tables, tables.discs[0], 0, top)
    assert ways_to_ends(tables, tables.discs[0]) == pytest.approx((1.0, 1.0))

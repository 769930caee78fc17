"""Motion between two events: by hand, and the same whether it is asked for or carried out."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.event_driven.motion import move_to, place_at, velocity_at
from lesson_code.engine.event_driven.rows import DiscRow

numbers = st.floats(-10, 10)

ROUNDING = 1e-12
"""Of numbers below a thousand: a few operations."""


def falling_disc() -> DiscRow:
    """Return a disc whose clock stands at 1 s; it flies at (3, 4) m/s and turns ever faster."""
    return DiscRow(
        time=1.0, x=1.0, y=2.0, angle=0.5, vx=3.0, vy=4.0, w=1.0, ax=0.5, ay=-10.0, alpha=2.0
    )


def test_place_and_velocity_of_a_falling_disc_worked_by_hand() -> None:
    """Two seconds on: x = 1 + 6 + 1, y = 2 + 8 - 20."""
    disc = falling_disc()
    assert place_at(disc, 3.0) == (8.0, -10.0)
    assert velocity_at(disc, 3.0) == (4.0, -16.0)
    assert (disc.time, disc.x) == (1.0, 1.0)


def test_disc_that_is_moved_has_another_clock() -> None:
    """The angle, too: 0.5 + 2 + 4; the accelerations stay."""
    disc = falling_disc()
    move_to(disc, 3.0)
    assert (disc.time, disc.x, disc.y, disc.angle) == (3.0, 8.0, -10.0, 6.5)
    assert (disc.vx, disc.vy, disc.w) == (4.0, -16.0, 5.0)
    assert (disc.ax, disc.ay, disc.alpha) == (0.5, -10.0, 2.0)


def test_disc_moved_by_no_time_keeps_every_bit() -> None:
    """An event at the present."""
    disc = falling_disc()
    move_to(disc, 1.0)
    assert disc == falling_disc()


@given(x=numbers, v=numbers, a=numbers, first=st.floats(0, 5), second=st.floats(5, 10))
def test_motion_in_two_parts_is_motion_in_one(
    x: float, v: float, a: float, first: float, second: float
) -> None:
    """So that an event of one disc does not change another's path."""
    parts = DiscRow(x=x, vx=v, ax=a, y=-x, vy=2 * v, ay=a / 2)
    whole = DiscRow(x=x, vx=v, ax=a, y=-x, vy=2 * v, ay=a / 2)
    move_to(parts, first)
    expected = place_at(whole, second), velocity_at(whole, second)
    assert place_at(parts, second) == pytest.approx(expected[0], abs=1000 * ROUNDING)
    assert velocity_at(parts, second) == pytest.approx(expected[1], abs=100 * ROUNDING)

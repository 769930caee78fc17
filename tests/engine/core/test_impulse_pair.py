"""An impulse and its opposite: momentum stays whatever the impulse is, to rounding."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.core.impulse_pair import (
    exchange,
    exchange_and_turn,
    exchange_pushes,
    exchange_pushes_and_turn,
)
from lesson_code.engine.core.rows import BodyRow

ROUNDING = 1e-13
"""kg m/s: a few operations on numbers of about 100."""

numbers = st.floats(-100, 100)
masses = st.floats(0.1, 10)


@given(masses, masses, numbers, numbers)
def test_impulse_pair_keeps_momentum(m_a: float, m_b: float, jx: float, jy: float) -> None:
    """M_a v_a + m_b v_b is 0 before and after; b has received J."""
    a, b = BodyRow(inv_m=1 / m_a), BodyRow(inv_m=1 / m_b)
    exchange(a, b, jx, jy)
    received = m_b * b.vx, m_b * b.vy
    assert received == pytest.approx((jx, jy), abs=ROUNDING)
    assert (m_a * a.vx, m_a * a.vy) == pytest.approx((-jx, -jy), abs=ROUNDING)
    assert (a.w, b.w) == (0.0, 0.0)


def test_spins_are_added_as_they_are_given() -> None:
    """Where the impulse acts, and so what it turns, its solver knows."""
    a, b = BodyRow(inv_m=1.0, w=1.0), BodyRow(inv_m=0.5, w=-1.0)
    exchange_and_turn(a, b, 2.0, 4.0, -0.5, 0.25)
    assert (a.vx, a.vy, a.w) == (-2.0, -4.0, 0.5)
    assert (b.vx, b.vy, b.w) == (1.0, 2.0, -0.75)


def test_pushes_leave_the_velocities_alone() -> None:
    """The position correction has its own, and no overlap becomes speed."""
    a, b = BodyRow(inv_m=1.0), BodyRow(inv_m=0.5)
    exchange_pushes(a, b, 2.0, 4.0)
    exchange_pushes_and_turn(a, b, 2.0, 4.0, -0.5, 0.25)
    assert (a.pseudo_vx, a.pseudo_vy, a.pseudo_w) == (-4.0, -8.0, -0.5)
    assert (b.pseudo_vx, b.pseudo_vy, b.pseudo_w) == (2.0, 4.0, 0.25)
    assert (a.vx, a.vy, a.w, b.vx, b.vy, b.w) == (0.0,) * 6

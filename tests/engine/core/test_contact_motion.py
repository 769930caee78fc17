"""Velocities, effective masses and impulses at a contact, against what happens to its points."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from contacts import apply_impulse, mass_along, velocity_along
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.core.contact_motion import (
    normal_of,
    tangent_of,
)
from lesson_code.engine.core.rows import BodyRow, ContactRow

ROUNDING = 1e-12
"""Numbers below are at most 1e3, and a change may be the difference of two of them."""

components = st.floats(-10, 10)
pairs = st.tuples(components, components)
inverses = st.floats(0.1, 10)
bodies = st.builds(
    BodyRow,
    vx=components,
    vy=components,
    w=components,
    pseudo_vx=components,
    pseudo_vy=components,
    pseudo_w=components,
    inv_m=inverses,
    inv_i=inverses,
)
contacts = st.builds(
    ContactRow, nx=st.just(0.6), ny=st.just(-0.8), ax=components, ay=components,
    bx=components, by=components, target_vn=components, pseudo_speed=st.floats(0, 10),
)  # fmt: skip
directions = st.sampled_from([normal_of, tangent_of])


def velocities(*rows: BodyRow) -> Any:
    """Return vx, vy, w of bodies."""
    return np.array([(row.vx, row.vy, row.w) for row in rows])


def pushes(*rows: BodyRow) -> Any:
    """Return the same of the position correction."""
    return np.array([(row.pseudo_vx, row.pseudo_vy, row.pseudo_w) for row in rows])


def test_directions_of_a_contact_are_a_right_handed_pair() -> None:
    """The tangent is the normal turned by +90 degrees."""
    c = ContactRow(nx=0.6, ny=-0.8)
    assert normal_of(c) == (0.6, -0.8)
    assert tangent_of(c) == (0.8, 0.6)


def test_velocity_worked_by_hand_is_found() -> None:
    """B's point moves at (3, 0) + 2 (-(-1), 0) = (5, 0), A's at (0, 1) + 1 (0, 2) = (0, 3)."""
    a = BodyRow(vy=1.0, w=1.0)
    b = BodyRow(vx=3.0, w=2.0)
    c = ContactRow(nx=1.0, ax=2.0, by=-1.0)
    assert velocity_along(c, a, b, normal_of(c)) == 5.0
    assert velocity_along(c, a, b, tangent_of(c)) == -3.0


def test_mass_worked_by_hand_is_found() -> None:
    """1 / (1 + 0.5 + 2^2 x 0.25 + 1^2 x 1.5) = 1/4: arms of 2 m and 1 m across the normal."""
    a, b = BodyRow(inv_m=1.0, inv_i=0.25), BodyRow(inv_m=0.5, inv_i=1.5)
    c = ContactRow(nx=1.0, ax=7.0, ay=2.0, bx=-7.0, by=-1.0)
    assert mass_along(c, a, b, normal_of(c)) == 0.25


@given(bodies, bodies, contacts, directions, components)
def test_impulse_changes_the_relative_velocity_by_impulse_over_mass(
    a: BodyRow, b: BodyRow, c: ContactRow, direction: Any, j: float
) -> None:
    """That is what an effective mass is."""
    u = direction(c)
    before = velocity_along(c, a, b, u)
    apply_impulse(c, a, b, u, j)
    change = velocity_along(c, a, b, u) - before
    assert change == pytest.approx(j / mass_along(c, a, b, u), rel=ROUNDING, abs=10 * ROUNDING)


@given(bodies, bodies, contacts, directions, components)
def test_impulse_keeps_momentum_and_turns_each_body_by_its_own_arm(
    a: BodyRow, b: BodyRow, c: ContactRow, direction: Any, j: float
) -> None:
    """A receives -j u at r_a, B +j u at r_b; the push velocities are left alone."""
    before, pushed = velocities(a, b), pushes(a, b)
    u = np.array(direction(c))
    apply_impulse(c, a, b, direction(c), j)
    change = velocities(a, b) - before
    gained = change / [[a.inv_m] * 2 + [a.inv_i], [b.inv_m] * 2 + [b.inv_i]]
    turns = [-(c.ax * u[1] - c.ay * u[0]) * j, (c.bx * u[1] - c.by * u[0]) * j]
    np.testing.assert_allclose(gained[:, :2], [-j * u, j * u], atol=10 * ROUNDING)
    np.testing.assert_allclose(gained[:, 2], turns, atol=100 * ROUNDING)
    np.testing.assert_array_equal(pushes(a, b), pushed)


def test_impulse_on_a_static_body_moves_only_the_other() -> None:
    """An inverse mass of 0 takes no velocity."""
    wall, ball = BodyRow(vx=1.0, w=2.0), BodyRow(inv_m=0.5, inv_i=0.5)
    c = ContactRow(nx=1.0, ay=3.0, by=1.0)
    apply_impulse(c, wall, ball, normal_of(c), 4.0)
    assert velocities(wall, ball).tolist() == [[1.0, 0.0, 2.0], [2.0, 0.0, -2.0]]

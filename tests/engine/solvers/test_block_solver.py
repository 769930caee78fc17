"""Two points of one manifold, solved together: the one answer that pushes and does not pull."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.engine.core.constants import LEAST_DETERMINANT
from lesson_code.engine.core.contact_frame import set_frame
from lesson_code.engine.core.rows import BodyRow, ContactRow
from lesson_code.engine.solvers.block_solver import (
    couple,
    couple_tangents,
    solve_manifold,
    solve_normals,
    solve_pseudo_velocities,
    two_impulses,
)
from lesson_code.engine.solvers.substep import solve_friction

ROUNDING = 1e-9
"""m/s and N s, of numbers up to 1e3: the equations for two lose up to six digits here."""

NARROW = 1e-6
"""1 - k12^2 / (k11 k22) of the closest points that are drawn below."""

velocities = st.floats(-10, 10)
impulses = st.floats(0, 10)
inverse_masses = st.floats(0.1, 10)
shares = st.floats(-0.99, 0.99)


# K = [[2, 1], [1, 2]]; the velocities that are missing, and the impulses that mend them
BY_HAND = {
    "both carry": ((-3, -3), (1, 1)),
    "the first carries, the second opens": ((-2, 1), (1, 0)),
    "the second carries, the first opens": ((1, -2), (0, 1)),
    "the second would pull": ((-4, -1), (2, 0)),
    "both open": ((1, 2), (0, 0)),
    "nothing is missing": ((0, 0), (0, 0)),
}


@pytest.mark.parametrize(("missing", "expected"), BY_HAND.values(), ids=BY_HAND)
def test_impulses_worked_by_hand_are_found(
    missing: tuple[float, float], expected: tuple[float, float]
) -> None:
    """2 x 2 linear equations, or one."""
    assert two_impulses((2.0, 1.0, 2.0), missing, (0.0, 0.0)) == pytest.approx(expected)


@given(
    k11=inverse_masses,
    k22=inverse_masses,
    share=shares,
    missing=st.tuples(velocities, velocities),
    before=st.tuples(impulses, impulses),
)
def test_impulses_of_two_points_solve_their_complementarity_problem(
    k11: float,
    k22: float,
    share: float,
    missing: tuple[float, float],
    before: tuple[float, float],
) -> None:
    """Impulses x >= 0, velocities w >= 0, and where x > 0 there w = 0: they push or they open."""
    k = np.array([[k11, share * np.sqrt(k11 * k22)], [share * np.sqrt(k11 * k22), k22]])
    x = np.array(two_impulses((k11, float(k[0, 1]), k22), missing, before))
    w = missing + k @ (x - before)
    assert (x >= 0).all()
    assert (w >= -ROUNDING).all()
    np.testing.assert_allclose(x * w, 0, atol=ROUNDING * max(1, x.max()))


offsets = st.floats(-2, 2)


@given(ax=offsets, bx=offsets, apart=st.floats(1e-2, 3), i=st.floats(0.1, 10), m=st.floats(0.1, 10))
def test_velocities_at_both_points_reach_their_targets_in_one_visit(
    ax: float, bx: float, apart: float, i: float, m: float
) -> None:
    """Two bodies fall onto each other along y, with two points side by side between them."""
    a = BodyRow(inv_m=1.0, inv_i=1.0, corner_count=4)
    b = BodyRow(inv_m=m, inv_i=i, vy=-1.0, corner_count=4)
    c = ContactRow(ny=1.0, ax=ax, ay=1.0, bx=bx, by=-1.0, target_vn=0.5)
    d = ContactRow(ny=1.0, ax=ax + apart, ay=1.0, bx=bx + apart, by=-1.0, target_vn=0.5)
    set_frame(c, a, b)
    set_frame(d, a, b)
    couple(c, d, a, b)
    determinant = 1 - c.k_cross**2 * c.normal_mass * d.normal_mass
    assume(determinant > NARROW)
    solve_normals(c, d, a, b)
    parting = [b.vy + b.w * p.bx - a.vy - a.w * p.ax for p in (c, d)]
    assert c.is_block
    assert min(parting) >= 0.5 - ROUNDING
    for point, vn in zip((c, d), parting, strict=True):
        assert point.normal_impulse == 0 or vn == pytest.approx(0.5, abs=ROUNDING)


@given(
    ax=offsets,
    bx=offsets,
    apart=st.floats(1e-2, 3),
    velocity=st.tuples(velocities, velocities, velocities),
    friction=st.floats(0, 2),
    before=st.tuples(impulses, impulses, st.floats(-1, 1), st.floats(-1, 1)),
)
def test_manifold_in_one_visit_is_its_normals_then_friction_at_each_point(
    ax: float,
    bx: float,
    apart: float,
    velocity: tuple[float, float, float],
    friction: float,
    before: tuple[float, float, float, float],
) -> None:
    """The impulses that are computed ahead are those of three visits, one after the other."""
    reached = []
    for stages in (False, True):
        a = BodyRow(inv_m=1.0, inv_i=2.0, corner_count=4, w=1.0)
        vx, vy, w = velocity
        b = BodyRow(inv_m=0.5, inv_i=3.0, corner_count=4, vx=vx, vy=vy, w=w)
        c = ContactRow(ny=1.0, ax=ax, ay=1.0, bx=bx, by=-1.0, friction=friction)
        d = ContactRow(ny=1.0, ax=ax + apart, ay=1.0, bx=bx + apart, by=-1.0, friction=friction)
        c.normal_impulse, d.normal_impulse, share_c, share_d = before
        for point, share in ((c, share_c), (d, share_d)):
            set_frame(point, a, b)
            point.tangent_impulse = share * friction * point.normal_impulse
        couple(c, d, a, b)
        couple_tangents(c, d, a, b)
        assume(1 - c.k_cross**2 * c.normal_mass * d.normal_mass > NARROW)
        if stages:
            solve_normals(c, d, a, b)
            solve_friction(c, a, b)
            solve_friction(d, a, b)
        else:
            solve_manifold(c, d, a, b)
        impulse = [j for p in (c, d) for j in (p.normal_impulse, p.tangent_impulse)]
        reached.append([a.vx, a.vy, a.w, b.vx, b.vy, b.w, *impulse])
    np.testing.assert_allclose(reached[0], reached[1], atol=ROUNDING)


def test_pushes_at_both_points_undo_what_each_overlaps() -> None:
    """A box overlaps more on its right: pushed at 1 and 3 m/s, 2 m apart, it turns at 1 rad/s."""
    floor, box = BodyRow(corner_count=2), BodyRow(inv_m=1.0, inv_i=1.5, corner_count=4)
    c = ContactRow(ny=1.0, bx=-1.0, by=-1.0, pseudo_speed=1.0)
    d = ContactRow(ny=1.0, bx=1.0, by=-1.0, pseudo_speed=3.0)
    for point in (c, d):
        set_frame(point, floor, box)
    couple(c, d, floor, box)
    solve_pseudo_velocities(c, d, floor, box)
    assert (box.pseudo_vy, box.pseudo_w) == pytest.approx((2.0, 1.0))
    assert (box.vy, box.w) == (0.0, 0.0)


def test_points_as_good_as_one_are_left_single() -> None:
    """At the same place the two equations are one, and how they share the load is open."""
    a, b = BodyRow(corner_count=2), BodyRow(inv_m=1.0, inv_i=1.0, corner_count=4)
    for apart, is_block in ((0.0, False), (1e-6, False), (1e-2, True), (1.0, True)):
        c, d = ContactRow(ny=1.0, bx=0.5), ContactRow(ny=1.0, bx=0.5 + apart)
        for point in (c, d):
            set_frame(point, a, b)
        couple(c, d, a, b)
        assert c.is_block is is_block, f"{apart} m apart, limit {LEAST_DETERMINANT}"

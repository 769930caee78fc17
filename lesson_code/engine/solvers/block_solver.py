"""Two points of one manifold, solved together: a complementarity problem of size two.

K is the Delassus matrix: k11 and k22 are each point's own 1 / effective mass, and k12 is what an
impulse at one point does to the velocity of the other. Impulses x at the points change the normal
velocities by K x. Wanted are totals x with

    x >= 0,    w = b + K x >= 0,    x1 w1 = x2 w2 = 0

Each point either carries the load or opens. There are four cases; exactly one fits.

Visiting the points in turn finds the same, but slowly: the error falls by (k12/k11)^2 a sweep,
and a wide box that lands flat is left turning.

References
----------
Catto, Box2D 2.4, src/dynamics/b2_contact_solver.cpp: the block solver. Cottle, Pang and Stone,
The Linear Complementarity Problem (1992), section 3.3: why one case fits (K is a P-matrix).
"""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.compiled.lanes import everywhere, where
from lesson_code.engine.core.constants import LEAST_DETERMINANT
from lesson_code.engine.core.contact_frame import (
    friction_impulse,
    missing_pseudo_velocity,
    missing_velocity,
    velocity_at,
)
from lesson_code.engine.core.impulse_pair import exchange_and_turn, exchange_pushes_and_turn
from lesson_code.engine.core.rows import BodyRow, ContactRow

Two: TypeAlias = tuple[float, float]
Three: TypeAlias = tuple[float, float, float]


def couple(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Compute K for two points, and its inverse unless they are as good as one."""
    turning = c.ra_x_n * d.ra_x_n * a.inv_i + c.rb_x_n * d.rb_x_n * b.inv_i
    c.k_cross = a.inv_m + b.inv_m + turning
    c.k_own, d.k_own = 1 / c.normal_mass, 1 / d.normal_mass
    c.is_block = 1 - c.k_cross * c.k_cross * c.normal_mass * d.normal_mass > LEAST_DETERMINANT
    if c.is_block:
        share = 1 / (c.k_own * d.k_own - c.k_cross * c.k_cross)
        c.block_mass, d.block_mass = d.k_own * share, c.k_own * share
        c.shared_mass = -c.k_cross * share


def couple_tangents(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Compute how friction at one point moves the other along the tangent."""
    turning = c.ra_x_t * d.ra_x_t * a.inv_i + c.rb_x_t * d.rb_x_t * b.inv_i
    c.k_cross_tangent = a.inv_m + b.inv_m + turning


def solve_manifold(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring both normal velocities to their targets, then stop the sliding at each point in turn.

    What one impulse does to the next is computed ahead, and the bodies are moved once, by all four.
    """
    (vn_c, vt_c), (vn_d, vt_d) = velocity_at(c, a, b), velocity_at(d, a, b)
    before = c.normal_impulse, d.normal_impulse
    jn = block_impulses(c, d, (vn_c - c.target_vn, vn_d - d.target_vn), before)
    more_n = jn[0] - before[0], jn[1] - before[1]
    wa, wb = spins_by_normals(c, d, a, b, more_n)
    vt = vt_c + wb * c.rb_x_t - wa * c.ra_x_t, vt_d + wb * d.rb_x_t - wa * d.ra_x_t
    jt = friction_impulses(c, d, vt, jn)
    more_t = jt[0] - c.tangent_impulse, jt[1] - d.tangent_impulse
    apply_at_two(c, d, a, b, more_n, more_t)
    c.normal_impulse, d.normal_impulse = jn
    c.tangent_impulse, d.tangent_impulse = jt


def solve_normals(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring both normal velocities to their targets: all there is to do where nothing rubs."""
    before = c.normal_impulse, d.normal_impulse
    missing = missing_velocity(c, a, b), missing_velocity(d, a, b)
    jn = block_impulses(c, d, missing, before)
    apply_normals(c, d, a, b, (jn[0] - before[0], jn[1] - before[1]))
    c.normal_impulse, d.normal_impulse = jn


def solve_pseudo_velocities(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Undo the overlap at both points; where none is left and none was undone, nothing changes."""
    before = c.pseudo_impulse, d.pseudo_impulse
    missing = missing_pseudo_velocity(c, a, b), missing_pseudo_velocity(d, a, b)
    is_apart = (missing[0] >= 0) & (missing[1] >= 0)
    if everywhere(is_apart & (before[0] == 0) & (before[1] == 0)):
        return
    totals = block_impulses(c, d, missing, before)
    apply_pseudo_impulses(c, d, a, b, (totals[0] - before[0], totals[1] - before[1]))
    c.pseudo_impulse, d.pseudo_impulse = totals


def friction_impulses(c: ContactRow, d: ContactRow, vt: Two, jn: Two) -> Two:
    """Return the total friction at two points that slide at vt: of c, then of d after it."""
    jt_c = friction_impulse(vt[0], c.tangent_mass, c.friction, jn[0], c.tangent_impulse)
    vt_d = vt[1] + c.k_cross_tangent * (jt_c - c.tangent_impulse)
    return jt_c, friction_impulse(vt_d, d.tangent_mass, d.friction, jn[1], d.tangent_impulse)


def spins_by_normals(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, jn: Two) -> Two:
    """Return how impulses along the normal at both points change the angular velocities, rad/s."""
    wa = -(jn[0] * c.ra_x_n + jn[1] * d.ra_x_n) * a.inv_i
    return wa, (jn[0] * c.rb_x_n + jn[1] * d.rb_x_n) * b.inv_i


def apply_at_two(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, jn: Two, jt: Two) -> None:
    """Change the velocities of both bodies by impulses along normal and tangent at both points."""
    along, across = jn[0] + jn[1], jt[0] + jt[1]
    j = along * c.nx - across * c.ny, along * c.ny + across * c.nx
    wa, wb = spins_by_normals(c, d, a, b, jn)
    wa -= (jt[0] * c.ra_x_t + jt[1] * d.ra_x_t) * a.inv_i
    wb += (jt[0] * c.rb_x_t + jt[1] * d.rb_x_t) * b.inv_i
    exchange_and_turn(a, b, j[0], j[1], wa, wb)


def apply_normals(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, jn: Two) -> None:
    """Change them by impulses along the normal, N s."""
    wa, wb = spins_by_normals(c, d, a, b, jn)
    exchange_and_turn(a, b, (jn[0] + jn[1]) * c.nx, (jn[0] + jn[1]) * c.ny, wa, wb)


def apply_pseudo_impulses(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, j: Two) -> None:
    """Change the velocities of the position correction likewise."""
    wa, wb = spins_by_normals(c, d, a, b, j)
    exchange_pushes_and_turn(a, b, (j[0] + j[1]) * c.nx, (j[0] + j[1]) * c.ny, wa, wb)


def block_impulses(c: ContactRow, d: ContactRow, missing: Two, before: Two) -> Two:
    """Return the total impulses of two rigid points; most often both carry."""
    x1 = before[0] - (c.block_mass * missing[0] + c.shared_mass * missing[1])
    x2 = before[1] - (c.shared_mass * missing[0] + d.block_mass * missing[1])
    both = (x1 >= 0) & (x2 >= 0)
    if everywhere(both):
        return x1, x2
    other = two_impulses((c.k_own, c.k_cross, d.k_own), missing, before)
    return where(both, x1, other[0]), where(both, x2, other[1])


def two_impulses(k: Three, missing: Two, before: Two) -> Two:
    """Return the total impulses of two points, from what is missing after those so far.

    k holds k11, k12 and k22, 1/kg: the velocity at a point from 1 N s there or at the other.
    """
    k11, k12, k22 = k
    b1 = missing[0] - (k11 * before[0] + k12 * before[1])
    b2 = missing[1] - (k12 * before[0] + k22 * before[1])
    x1, x2 = before  # where rounding has left no case that fits
    is_first = (b1 < 0) & (b2 - k12 * b1 / k11 >= 0)  # the first carries, the second opens
    is_second = (b2 < 0) & (b1 - k12 * b2 / k22 >= 0)
    x1, x2 = where(is_second, 0.0, x1), where(is_second, -b2 / k22, x2)
    x1, x2 = where(is_first, -b1 / k11, x1), where(is_first, 0.0, x2)
    d1, d2 = k12 * b2 - k22 * b1, k12 * b1 - k11 * b2  # times the determinant, which is > 0
    both = (d1 >= 0) & (d2 >= 0)
    share = 1 / (k11 * k22 - k12 * k12)
    x1, x2 = where(both, d1 * share, x1), where(both, d2 * share, x2)
    none = (b1 >= 0) & (b2 >= 0)
    return where(none, 0.0, x1), where(none, 0.0, x2)

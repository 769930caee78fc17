"""Two points of one manifold, solved together: a complementarity problem of size two.

With k11 and k22 for each point's own compliance (1 / effective mass) and k12 for their coupling,
an impulse x at the points changes the normal velocities by K x. Wanted are totals x with

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

from lesson_code.engine.constants import LEAST_DETERMINANT
from lesson_code.engine.contact_frame import apply_push, missing_push, missing_velocity
from lesson_code.engine.rows import BodyRow, ContactRow

Two: TypeAlias = tuple[float, float]
Three: TypeAlias = tuple[float, float, float]


def couple(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Compute the coupling of two points; where they are as good as one, leave them single."""
    turning = c.ra_x_n * d.ra_x_n * a.inv_i + c.rb_x_n * d.rb_x_n * b.inv_i
    c.coupling = a.inv_m + b.inv_m + turning
    c.compliance, d.compliance = 1 / c.normal_mass, 1 / d.normal_mass
    c.is_block = 1 - c.coupling * c.coupling * c.normal_mass * d.normal_mass > LEAST_DETERMINANT


def solve_normals(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bring both normal velocities to their targets, by impulses that only push."""
    k = c.compliance, c.coupling, d.compliance
    missing = missing_velocity(c, a, b), missing_velocity(d, a, b)
    totals = two_impulses(k, missing, (c.normal_impulse, d.normal_impulse))
    apply_at_two(c, d, a, b, totals[0] - c.normal_impulse, totals[1] - d.normal_impulse)
    c.normal_impulse, d.normal_impulse = totals


def solve_pushes(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Undo the overlap at both points."""
    k = c.compliance, c.coupling, d.compliance
    missing = missing_push(c, a, b), missing_push(d, a, b)
    totals = two_impulses(k, missing, (c.push_impulse, d.push_impulse))
    apply_push(c, a, b, totals[0] - c.push_impulse)
    apply_push(d, a, b, totals[1] - d.push_impulse)
    c.push_impulse, d.push_impulse = totals


def apply_at_two(
    c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, jc: float, jd: float
) -> None:
    """Change the velocities of both bodies by impulses along the normal at both points, N s."""
    jx, jy = (jc + jd) * c.nx, (jc + jd) * c.ny
    a.vx -= jx * a.inv_m
    a.vy -= jy * a.inv_m
    a.w -= (jc * c.ra_x_n + jd * d.ra_x_n) * a.inv_i
    b.vx += jx * b.inv_m
    b.vy += jy * b.inv_m
    b.w += (jc * c.rb_x_n + jd * d.rb_x_n) * b.inv_i


def two_impulses(k: Three, missing: Two, before: Two) -> Two:
    """Return the total impulses of two points, from what is missing after those so far.

    k holds k11, k12 and k22, 1/kg: the velocity at a point from 1 N s there or at the other.
    """
    k11, k12, k22 = k
    b1 = missing[0] - (k11 * before[0] + k12 * before[1])
    b2 = missing[1] - (k12 * before[0] + k22 * before[1])
    share = 1 / (k11 * k22 - k12 * k12)
    x1 = (k12 * b2 - k22 * b1) * share
    x2 = (k12 * b1 - k11 * b2) * share
    if x1 >= 0 and x2 >= 0:  # both carry
        return x1, x2
    if b1 < 0 and b2 - k12 * b1 / k11 >= 0:  # the first carries, the second opens
        return -b1 / k11, 0.0
    if b2 < 0 and b1 - k12 * b2 / k22 >= 0:  # the second carries, the first opens
        return 0.0, -b2 / k22
    if b1 >= 0 and b2 >= 0:  # both open
        return 0.0, 0.0
    return before  # rounding has left none: keep what there is

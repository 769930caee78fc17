"""A contact seen along its normal n and its tangent t, as the sweeps of a solver need it.

A point's velocity along a direction u is (v + w x r) . u = v . u + w (r x u). So a sweep needs only
r x n and r x t from a lever arm r. They stay the same during a step and are set once:

    normal velocity    vn = (v_b - v_a) . n + w_b (r_b x n) - w_a (r_a x n)
    impulse j along n  -j n on a, which turns it by -j (r_a x n);  the opposite on b

and likewise along t. The normal of a disc goes through its centre: r x n = 0. Where discs meet
without friction no body turns, and the impact is *central*: only velocities and masses count.
"""

from __future__ import annotations

from lesson_code.engine.core.contact_motion import XY, normal_of, tangent_of
from lesson_code.engine.core.impulse_pair import (
    exchange,
    exchange_and_turn,
    exchange_pushes,
    exchange_pushes_and_turn,
)
from lesson_code.engine.core.rows import BodyRow, ContactRow
from lesson_code.formulas import contact
from lesson_code.formulas.arithmetic import cross
from lesson_code.formulas.validation import equation

effective_mass = equation(contact.effective_mass)
normal_impulse = equation(contact.normal_impulse)
friction_impulse = equation(contact.friction_impulse)


def set_frame(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Set the lever arms, the effective masses, and the coupling of normal and tangent."""
    set_normal_frame(c, a, b)
    t = tangent_of(c)
    c.ra_x_t, c.rb_x_t = cross((c.ax, c.ay), t), cross((c.bx, c.by), t)
    c.tangent_mass = effective_mass(a.inv_m, b.inv_m, a.inv_i, b.inv_i, c.ra_x_t, c.rb_x_t)
    c.skew = c.ra_x_n * c.ra_x_t * a.inv_i + c.rb_x_n * c.rb_x_t * b.inv_i


def set_normal_frame(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Set the lever arms and the mass along the normal: all a contact without friction needs."""
    n = normal_of(c)
    c.ra_x_n = cross((c.ax, c.ay), n) if a.corner_count > 0 else 0.0
    c.rb_x_n = cross((c.bx, c.by), n) if b.corner_count > 0 else 0.0
    c.normal_mass = effective_mass(a.inv_m, b.inv_m, a.inv_i, b.inv_i, c.ra_x_n, c.rb_x_n)


def set_central_frame(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Set the effective mass of a central impact: all that bodies without rotation need."""
    c.normal_mass = effective_mass(a.inv_m, b.inv_m)


def velocity_at(c: ContactRow, a: BodyRow, b: BodyRow) -> XY:
    """Return the relative velocity of the contact points along normal and tangent, m/s."""
    return normal_velocity(c, a, b), tangent_velocity(c, a, b)


def normal_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the relative velocity along the normal, m/s; > 0: parting."""
    return central_velocity(c, a, b) + (b.w * c.rb_x_n - a.w * c.ra_x_n)


def central_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the same for bodies that cannot rotate."""
    return (b.vx - a.vx) * c.nx + (b.vy - a.vy) * c.ny


def tangent_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the relative velocity along the tangent (-ny, nx), m/s."""
    along = (b.vy - a.vy) * c.nx - (b.vx - a.vx) * c.ny
    return along + (b.w * c.rb_x_t - a.w * c.ra_x_t)


def pseudo_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the relative normal velocity of the position correction, m/s."""
    return central_pseudo_velocity(c, a, b) + (b.pseudo_w * c.rb_x_n - a.pseudo_w * c.ra_x_n)


def central_pseudo_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the same for bodies that cannot rotate."""
    return (b.pseudo_vx - a.pseudo_vx) * c.nx + (b.pseudo_vy - a.pseudo_vy) * c.ny


def missing_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the normal velocity less its target, m/s; negative: the bodies part too slowly."""
    return normal_velocity(c, a, b) - c.target_vn


def missing_pseudo_velocity(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return the same for the velocities of the position correction."""
    return pseudo_velocity(c, a, b) - c.pseudo_speed


def apply_impulses(c: ContactRow, a: BodyRow, b: BodyRow, jn: float, jt: float) -> None:
    """Change the velocities of both bodies by impulses along normal and tangent, N s."""
    wa = -(jn * c.ra_x_n + jt * c.ra_x_t) * a.inv_i
    wb = (jn * c.rb_x_n + jt * c.rb_x_t) * b.inv_i
    exchange_and_turn(a, b, jn * c.nx - jt * c.ny, jn * c.ny + jt * c.nx, wa, wb)


def apply_normal_impulse(c: ContactRow, a: BodyRow, b: BodyRow, jn: float) -> None:
    """Change the velocities of both bodies by an impulse along the normal, N s."""
    wa, wb = -jn * c.ra_x_n * a.inv_i, jn * c.rb_x_n * b.inv_i
    exchange_and_turn(a, b, jn * c.nx, jn * c.ny, wa, wb)


def apply_central_impulse(c: ContactRow, a: BodyRow, b: BodyRow, jn: float) -> None:
    """Change the velocities of bodies that cannot rotate by an impulse along the normal, N s."""
    exchange(a, b, jn * c.nx, jn * c.ny)


def apply_pseudo_impulse(c: ContactRow, a: BodyRow, b: BodyRow, j: float) -> None:
    """Change the velocities of the position correction by an impulse along the normal, N s."""
    wa, wb = -j * c.ra_x_n * a.inv_i, j * c.rb_x_n * b.inv_i
    exchange_pushes_and_turn(a, b, j * c.nx, j * c.ny, wa, wb)


def apply_central_pseudo_impulse(c: ContactRow, a: BodyRow, b: BodyRow, j: float) -> None:
    """Change the pseudo-velocities of bodies that cannot rotate."""
    exchange_pushes(a, b, j * c.nx, j * c.ny)


def bring_to_total(c: ContactRow, a: BodyRow, b: BodyRow, total: float) -> None:
    """Apply the difference between a total and the contact's normal impulse so far, N s."""
    apply_normal_impulse(c, a, b, total - c.normal_impulse)
    c.normal_impulse = total

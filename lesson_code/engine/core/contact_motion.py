"""The two bodies of a contact: how fast its points part, how hard they are to part, a push.

Every impact is made of these. Along a unit direction u, with lever arms r_a and r_b:

    velocity   (v_b + w_b x r_b - v_a - w_a x r_a) . u
    mass       1 / (1/m_a + 1/m_b + (r_a x u)^2 / I_a + (r_b x u)^2 / I_b)
    impulse j  -j u on a at r_a,  +j u on b at r_b
"""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.core.impulse_pair import MovingBody, exchange_and_turn
from lesson_code.engine.core.rows import ContactRow
from lesson_code.formulas import contact, rigid_body
from lesson_code.formulas.arithmetic import cross, dot
from lesson_code.formulas.validation import equation

XY: TypeAlias = tuple[float, float]


contact_velocity = equation(rigid_body.contact_velocity)
effective_mass = equation(contact.effective_mass)


def normal_of(c: ContactRow) -> XY:
    """Return the contact's unit normal, from a to b."""
    return c.nx, c.ny


def tangent_of(c: ContactRow) -> XY:
    """Return the contact's unit tangent: the normal turned by +90 degrees."""
    return -c.ny, c.nx


def velocity_along(c: ContactRow, a: MovingBody, b: MovingBody, u: XY) -> float:
    """Return the relative velocity of the contact points along u, m/s; > 0 along n: parting."""
    on_a = contact_velocity((a.vx, a.vy), a.w, (c.ax, c.ay))
    on_b = contact_velocity((b.vx, b.vy), b.w, (c.bx, c.by))
    along: float = dot((on_b[0] - on_a[0], on_b[1] - on_a[1]), u)
    return along


def mass_along(c: ContactRow, a: MovingBody, b: MovingBody, u: XY) -> float:
    """Return the effective mass of the contact along u, kg."""
    ra_x_u, rb_x_u = cross((c.ax, c.ay), u), cross((c.bx, c.by), u)
    mass: float = effective_mass(a.inv_m, b.inv_m, a.inv_i, b.inv_i, ra_x_u, rb_x_u)
    return mass


def contact_point(c: ContactRow, a: MovingBody, b: MovingBody) -> XY:
    """Return the point midway between the two surfaces, m."""
    return (a.x + c.ax + b.x + c.bx) / 2, (a.y + c.ay + b.y + c.by) / 2


def apply_impulse(c: ContactRow, a: MovingBody, b: MovingBody, u: XY, j: float) -> None:
    """Change the velocities of both bodies by an impulse j along u, N s."""
    jx, jy = j * u[0], j * u[1]
    wa = -cross((c.ax, c.ay), (jx, jy)) * a.inv_i
    wb = cross((c.bx, c.by), (jx, jy)) * b.inv_i
    exchange_and_turn(a, b, jx, jy, wa, wb)

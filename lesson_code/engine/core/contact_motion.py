"""The directions of a contact, the point where it is, and an impulse j along a direction u there.

The impulse is -j u on a at its lever arm r_a, and +j u on b at r_b.
"""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.core.impulse_pair import MovingBody, exchange_and_turn
from lesson_code.engine.core.rows import ContactRow
from lesson_code.formulas.arithmetic import cross

XY: TypeAlias = tuple[float, float]


def normal_of(c: ContactRow) -> XY:
    """Return the contact's unit normal, from a to b."""
    return c.nx, c.ny


def tangent_of(c: ContactRow) -> XY:
    """Return the contact's unit tangent: the normal turned by +90 degrees."""
    return -c.ny, c.nx


def contact_point(c: ContactRow, a: MovingBody, b: MovingBody) -> XY:
    """Return the point midway between the two surfaces, m."""
    return (a.x + c.ax + b.x + c.bx) / 2, (a.y + c.ay + b.y + c.by) / 2


def apply_impulse(c: ContactRow, a: MovingBody, b: MovingBody, u: XY, j: float) -> None:
    """Change the velocities of both bodies by an impulse j along u, N s."""
    jx, jy = j * u[0], j * u[1]
    wa = -cross((c.ax, c.ay), (jx, jy)) * a.inv_i
    wb = cross((c.bx, c.by), (jx, jy)) * b.inv_i
    exchange_and_turn(a, b, jx, jy, wa, wb)

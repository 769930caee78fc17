"""What tests measure and do at a contact, apart from the engine's own code for it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lesson_code.engine.core.impulse_pair import MovingBody, exchange_and_turn
from lesson_code.engine.core.rows import ContactRow
from lesson_code.formulas.arithmetic import cross


def velocity_along(c: ContactRow, a: MovingBody, b: MovingBody, u: ArrayLike) -> float:
    """Return the relative velocity of the contact points along u, m/s; > 0 along n: parting."""
    on_a, on_b = _point_velocity(a, (c.ax, c.ay)), _point_velocity(b, (c.bx, c.by))
    return float(np.dot(on_b - on_a, u))


def mass_along(c: ContactRow, a: MovingBody, b: MovingBody, u: ArrayLike) -> float:
    """Return the effective mass along u, kg: 1 N s over the velocity it adds."""
    return 1 / (_gain(a, (c.ax, c.ay), u) + _gain(b, (c.bx, c.by), u))


def apply_impulse(
    c: ContactRow, a: MovingBody, b: MovingBody, u: tuple[float, float], j: float
) -> None:
    """Give b an impulse j along u at its lever arm, N s, and a the opposite one at its own."""
    jx, jy = j * u[0], j * u[1]
    wa = -cross((c.ax, c.ay), (jx, jy)) * a.inv_i
    wb = cross((c.bx, c.by), (jx, jy)) * b.inv_i
    exchange_and_turn(a, b, jx, jy, wa, wb)


def _point_velocity(body: MovingBody, arm: tuple[float, float]) -> NDArray[np.float64]:
    """Return the velocity of a body's point, m/s: v + w x r."""
    return np.array([body.vx - body.w * arm[1], body.vy + body.w * arm[0]])


def _gain(body: MovingBody, arm: tuple[float, float], u: ArrayLike) -> float:
    """Return the velocity along u that an impulse of 1 N s along u gives a body's point."""
    x, y = np.asarray(u)
    turning = arm[0] * y - arm[1] * x
    return float(body.inv_m + body.inv_i * turning * turning)

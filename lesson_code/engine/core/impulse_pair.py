"""An impulse and its opposite: +J on b, -J on a. Every solver of the engine moves bodies by these.

Whatever J is, the momentum of the two together stays; a body that nothing can push has an inverse
mass of 0 and stays as it is. What an impulse turns a body by depends on where it acts, so that its
solver says: changes of angular velocity, wa and wb, are given along with it.

The position correction has velocities of its own, and gives impulses to those in the same way.
"""

from __future__ import annotations

from typing import Protocol

from lesson_code.engine.core.rows import BodyRow


class MovingBody(Protocol):
    """The fields of a body that an impact reads and writes; a row may have more than these."""

    x: float
    y: float
    vx: float
    vy: float
    w: float
    inv_m: float
    inv_i: float


def exchange(a: MovingBody, b: MovingBody, jx: float, jy: float) -> None:
    """Give b an impulse, N s, and a the opposite one, where neither turns by it."""
    a.vx -= jx * a.inv_m
    a.vy -= jy * a.inv_m
    b.vx += jx * b.inv_m
    b.vy += jy * b.inv_m


def exchange_and_turn(
    a: MovingBody, b: MovingBody, jx: float, jy: float, wa: float, wb: float
) -> None:
    """Give b an impulse and a the opposite one, N s, and both what they turn by it, rad/s.

    All is read before anything is written: a processor that reads eight numbers at once would have
    to wait for one of them that was written just now.
    """
    of_a = a.vx - jx * a.inv_m, a.vy - jy * a.inv_m, a.w + wa
    of_b = b.vx + jx * b.inv_m, b.vy + jy * b.inv_m, b.w + wb
    a.vx, a.vy, a.w = of_a
    b.vx, b.vy, b.w = of_b


def exchange_pushes(a: BodyRow, b: BodyRow, jx: float, jy: float) -> None:
    """Do the same to the velocities of the position correction, where neither turns."""
    a.pseudo_vx -= jx * a.inv_m
    a.pseudo_vy -= jy * a.inv_m
    b.pseudo_vx += jx * b.inv_m
    b.pseudo_vy += jy * b.inv_m


def exchange_pushes_and_turn(
    a: BodyRow, b: BodyRow, jx: float, jy: float, wa: float, wb: float
) -> None:
    """Do the same to them, and to their angular velocities, rad/s."""
    of_a = a.pseudo_vx - jx * a.inv_m, a.pseudo_vy - jy * a.inv_m, a.pseudo_w + wa
    of_b = b.pseudo_vx + jx * b.inv_m, b.pseudo_vy + jy * b.inv_m, b.pseudo_w + wb
    a.pseudo_vx, a.pseudo_vy, a.pseudo_w = of_a
    b.pseudo_vx, b.pseudo_vy, b.pseudo_w = of_b

"""The directions of a contact, and the point where it is."""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.core.impulse_pair import MovingBody
from lesson_code.engine.core.rows import BodyRow, ContactRow
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


def gap_between(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return how far apart the points are, m, after the bodies have moved since they were found."""
    return c.gap_origin + way_apart(c, a, b)


def way_apart(c: ContactRow, a: BodyRow, b: BodyRow) -> float:
    """Return what the bodies' places and angles add to the gap, m.

    n (x_b - x_a) + (r_b x n) angle_b - (r_a x n) angle_a: exact for a disc that rolls, and to
    first order in the turning of a polygon. Only its change within the step matters.
    """
    n = normal_of(c)
    turning: float = cross((c.bx, c.by), n) * b.angle - cross((c.ax, c.ay), n) * a.angle
    return (b.x - a.x) * c.nx + (b.y - a.y) * c.ny + turning

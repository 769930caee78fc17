"""The directions of a contact, and the point where it is."""

from __future__ import annotations

from typing import TypeAlias

from lesson_code.engine.core.impulse_pair import MovingBody
from lesson_code.engine.core.rows import ContactRow

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

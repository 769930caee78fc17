"""A skin: contacts are seen a little before the bodies touch.

A corner that lies on a face is a contact whether rounding puts it a hair above the face or a hair
below. The narrow phase works with outlines that are rounded by the skin. What it finds is the
distance of the skins; that of the bodies is more by both, so that a penetration may be negative:
then it is a gap.
"""

from __future__ import annotations

from lesson_code.engine.core.constants import LAST_DIGITS, NEAR
from lesson_code.engine.core.rows import BodyRow, ContactRow, World


def take_skins_off(world: World) -> None:
    """Let each contact tell of the bodies without their skins, and act on both at one point.

    An impulse and its opposite at one point leave no torque over. The point divides the way from
    one surface to the other as the widths of the bodies do: both lever arms of two discs are too
    short by the same share. A body that nothing can push counts as infinitely wide: so a disc
    rolls by its radius, however deep it lies in the floor.
    """
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        skin_a, skin_b = skin_of(world, a), skin_of(world, b)
        c.penetration -= skin_a + skin_b
        c.ax, c.ay = c.ax - skin_a * c.nx, c.ay - skin_a * c.ny
        c.bx, c.by = c.bx + skin_b * c.nx, c.by + skin_b * c.ny
        dx, dy = b.x - a.x, b.y - a.y
        of_b = 1.0 / (1.0 + b.min_width / a.min_width)
        c.ax += of_b * (dx + c.bx - c.ax)
        c.ay += of_b * (dy + c.by - c.ay)
        if of_b < 1.0:
            c.bx, c.by = c.ax - dx, c.ay - dy


def skin_of(world: World, body: BodyRow) -> float:
    """Return the thickness of a body's skin, m; one that nothing can push has none."""
    return world.state.skin * body.min_width if body.inv_m > 0.0 else 0.0


def gap_of(c: ContactRow) -> float:
    """Return the distance of two bodies at a contact, m; 0 if they touch or overlap."""
    return max(-c.penetration, 0.0)


def touching_gap(a: BodyRow, b: BodyRow) -> float:
    """Return how far apart two bodies are that touch, at the most, m."""
    places = abs(a.x) + abs(a.y) + abs(b.x) + abs(b.y)
    return NEAR * min(a.min_width, b.min_width) + LAST_DIGITS * places

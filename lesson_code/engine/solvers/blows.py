"""Scenes in which contacts pass blows alone, and carry nothing, in sub-steps.

A spring gives way, and the relax pass takes back what it has pushed: both cost energy, as is right
for bodies that come to rest. Where e = 1, nothing rubs and nobody stands from the start, none ever
does. There no contact carries. After each sub-step, when way and speed belong to one parabola,
bodies that would meet in the next one bounce, pair by pair: each blow by itself keeps the energy
and the momentum to rounding. Where gravity acts there are no pushes out of an overlap either:
lifted out of a floor, a body would have more energy. It comes out as it bounces.
"""

from __future__ import annotations

from lesson_code.engine.core.contact_frame import apply_impulses, normal_velocity
from lesson_code.engine.core.contact_motion import gap_between
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.solvers.block_solver import two_impulses


def pass_blows(world: World) -> None:
    """Let bodies that would meet within a sub-step bounce."""
    is_second = False
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        a, b = world.bodies[c.a], world.bodies[c.b]
        if c.is_block:
            bounce_at_two(c, world.contacts[k + 1], a, b, world.state.dt)
        elif not is_second:
            bounce(c, a, b, -2 * meeting_velocity(c, a, b, world.state.dt) * c.normal_mass)
        is_second = c.is_block


def bounce_at_two(c: ContactRow, d: ContactRow, a: BodyRow, b: BodyRow, h: float) -> None:
    """Let two bodies bounce at one point of their manifold, or at both at once."""
    vn = meeting_velocity(c, a, b, h), meeting_velocity(d, a, b, h)
    jn = -2 * vn[0] * c.normal_mass, -2 * vn[1] * d.normal_mass
    if vn[0] < 0.0 and vn[1] < 0.0:
        jn = two_impulses((c.k_own, c.k_cross, d.k_own), (2 * vn[0], 2 * vn[1]), (0.0, 0.0))
    bounce(c, a, b, jn[0])
    bounce(d, a, b, jn[1])


def meeting_velocity(c: ContactRow, a: BodyRow, b: BodyRow, h: float) -> float:
    """Return the normal velocity, m/s, if the bodies would meet within h, else 0."""
    vn = normal_velocity(c, a, b)
    return vn if vn < 0.0 and gap_between(c, a, b) + vn * h < 0.0 else 0.0


def bounce(c: ContactRow, a: BodyRow, b: BodyRow, j: float) -> None:
    """Give two bodies a blow, N s, and count it."""
    apply_impulses(c, a, b, j, 0.0)
    c.normal_total += j

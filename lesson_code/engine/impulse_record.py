"""Post-processing: the impulses of each step, in a table that is emptied now and then."""

from __future__ import annotations

from lesson_code.engine.contact_motion import contact_point
from lesson_code.engine.rows import World

STEPS_KEPT = 32
"""Steps whose impulses fit into the table: so seldom is a run interrupted to empty it."""


def has_room_for_record(world: World) -> bool:
    """Return whether the impulses of all contacts of this step fit into the table."""
    state = world.state
    if state.impulse_count + state.contact_count <= len(world.impulses):
        return True
    state.impulses_wanted = STEPS_KEPT * state.contact_count
    return False


def record_impulses(world: World) -> None:
    """Write down the contacts that have received an impulse."""
    state = world.state
    for k in range(state.contact_count):
        c = world.contacts[k]
        if c.normal_impulse != 0.0:
            x, y = contact_point(c, world.bodies[c.a], world.bodies[c.b])
            row = world.impulses[state.impulse_count]
            row.time, row.a, row.b = state.time, c.a, c.b
            row.x, row.y, row.nx, row.ny = x, y, c.nx, c.ny
            row.normal_impulse, row.tangent_impulse = c.normal_impulse, c.tangent_impulse
            row.penetration = c.penetration
            state.impulse_count += 1

"""Impulse record: the impulses of each step, in a table that is emptied now and then."""

from __future__ import annotations

from lesson_code.engine.core.contact_motion import contact_point
from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.question import Effect, Finding

STEPS_KEPT, ROWS_KEPT = 32, 8192
"""Steps whose impulses fit into the table, at the least, and rows that it has where they fit more
of the steps ahead: so seldom is a run interrupted to empty it."""


def rule(_facts: Facts) -> Finding:
    """Ask whether contacts are to be read afterwards: yes, unless that is declined."""
    return Finding(True, "run.contacts lists every impulse")


EFFECT = Effect(
    rule=rule,
    place=160,
    functions=("has_capacity_for_record", "record_impulses"),
    is_optional=True,
)


def has_capacity_for_record(world: World) -> bool:
    """Return whether the impulses of all contacts of this step fit into the table."""
    state = world.state
    wanted = state.contact_count + state.resting_count
    if state.impulse_count + wanted <= len(world.impulses):
        return True
    state.impulses_wanted = wanted * max(STEPS_KEPT, min(state.steps_left, ROWS_KEPT // wanted))
    return False


def record_impulses(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Write down the contacts that have received an impulse."""
    state = world.state
    for k in range(state.contact_count):
        c = world.contacts[k]
        if c.normal_impulse != 0.0:
            x, y = contact_point(c, world.bodies[c.a], world.bodies[c.b])
            row = world.impulses[state.impulse_count]
            row.time, row.a, row.b = state.time, c.a, c.b
            row.x, row.y, row.nx, row.ny = x, y, c.nx, c.ny
            row.normal_impulse = c.normal_impulse
            row.tangent_impulse = c.tangent_impulse if effects.friction else 0.0
            row.penetration = c.penetration
            state.impulse_count += 1


def record_resting(world: World) -> None:
    """Write down what the contacts of sleeping islands carry, as if their step had been made."""
    state = world.state
    for k in range(state.resting_count):
        rest = world.resting[k]
        if rest.normal_impulse != 0.0:
            row = world.impulses[state.impulse_count]
            longer = state.dt / rest.dt
            row.time, row.a, row.b = state.time, rest.a, rest.b
            row.x, row.y, row.nx, row.ny = rest.x, rest.y, rest.nx, rest.ny
            row.normal_impulse = rest.normal_impulse * longer
            row.tangent_impulse = rest.tangent_impulse * longer
            row.penetration = rest.penetration
            state.impulse_count += 1

"""Gravity: the same acceleration for every body that can be pushed."""

from __future__ import annotations

from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether there is any."""
    if facts.gravity_x != 0.0 or facts.gravity_y != 0.0:
        return Finding(True, "g = ({:g}, {:g}) m/s^2", facts.gravity_x, facts.gravity_y)
    return Finding(False, "g = 0")


EFFECT = Effect(rule=rule, place=100, functions=("fall",), needs_collisions=False)


def fall(world: World, effects: Effects) -> None:
    """Let gravity act on all bodies that can be pushed."""
    state = world.state
    for body in world.bodies:
        if body.inv_m > 0.0 and not body.waits and not (effects.sleeping and body.is_asleep):
            body.vx += state.gravity_x * state.dt
            body.vy += state.gravity_y * state.dt

"""Damping: the velocities of bodies that can be pushed die away."""

from __future__ import annotations

import math

from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.question import Effect, Finding


def rule(facts: Facts) -> Finding:
    """Ask whether there is any."""
    if facts.damping != 0.0:
        return Finding(True, "motion dies away at {:g} /s", facts.damping)
    return Finding(False, "the rate is 0")


EFFECT = Effect(rule=rule, place=110, functions=("damp",), needs_collisions=False)


def damp(world: World, effects: Effects) -> None:
    """Let the velocities of all bodies that can be pushed die away."""
    remaining = math.exp(-world.state.damping * world.state.dt)
    for body in world.bodies:
        if body.inv_m > 0.0 and not body.waits and not (effects.sleeping and body.is_asleep):
            body.vx *= remaining
            body.vy *= remaining
            body.w *= remaining

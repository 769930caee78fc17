"""How deep bodies stand in each other: the same measure for every solver's states."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.broad_phase import bound
from lesson_code.engine.core.candidate_pairs import seek_pairs
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.motion import turn_with_angle
from lesson_code.engine.core.narrow_phase import find_contacts
from lesson_code.engine.core.pipeline import BroadPhase
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects

EVERY_OVERLAP = EVERY_EFFECT._replace(internal_edges=False)
"""What overlaps are measured with: where a floor has a seam, two overlaps are two."""


def deepest_overlaps(
    scene: Scene, positions: NDArray[np.float64], angles: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the depth of the deepest overlap in each of F states, shape (F,), m."""
    world = world_of(scene, dt=1.0, iterations=0, combine=MixingRule())
    broad_phase = BROAD_PHASES[broad_phase_for(scene)]
    depths = np.zeros(len(positions))
    for frame in range(len(positions)):
        for n, body in enumerate(world.bodies):
            body.x, body.y = positions[frame, n].tolist()
            body.angle = float(angles[frame, n])
        while (depth := measure_overlaps(world, broad_phase, EVERY_OVERLAP, in_metres)) < 0.0:
            world = add_capacity(world)
        depths[frame] = depth
    return depths


Measure: TypeAlias = Callable[[World, ContactRow], float]
"""Returns how deep a contact is, in some unit."""


def in_metres(world: World, c: ContactRow) -> float:  # noqa: ARG001
    """Return the depth of a contact, m."""
    return c.penetration


def in_widths(world: World, c: ContactRow) -> float:
    """Return the depth of a contact as a share of the smaller body's width."""
    return c.penetration / min(world.bodies[c.a].min_width, world.bodies[c.b].min_width)


def measure_overlaps(
    world: World, broad_phase: BroadPhase, effects: Effects, depth: Measure
) -> float:
    """Return the depth of the deepest overlap, 0 without one; -1 when a table was too small."""
    if not see_contacts(world, broad_phase, effects):
        return -1.0
    deepest = 0.0
    for k in range(world.state.contact_count):
        deepest = max(deepest, depth(world, world.contacts[k]))
    return deepest


def see_contacts(world: World, broad_phase: BroadPhase, effects: Effects) -> bool:
    """Find the contacts of the bodies as they stand; return whether the tables had room."""
    for body in world.bodies:
        turn_with_angle(world, body)
    bound(world)
    return seek_pairs(world, broad_phase) and find_contacts(world, effects)

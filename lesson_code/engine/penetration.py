"""How deep bodies stand in each other: the same measure for every solver's states."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.combination import Combination
from lesson_code.engine.narrow_phase import find_contacts
from lesson_code.engine.room import make_room
from lesson_code.engine.rows import World
from lesson_code.engine.scene import Scene
from lesson_code.engine.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.world import find_pairs, turn_with_angle


def deepest_overlaps(
    scene: Scene, positions: NDArray[np.float64], angles: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the depth of the deepest overlap in each of F states, shape (F,), m."""
    world = world_of(scene, dt=1.0, iterations=0, combine=Combination())
    broad_phase = BROAD_PHASES[broad_phase_for(scene)]
    depths = np.zeros(len(positions))
    for frame in range(len(positions)):
        for n, body in enumerate(world.bodies):
            body.x, body.y = positions[frame, n].tolist()
            body.angle = float(angles[frame, n])
            turn_with_angle(world, body)
        while not (find_pairs(world, broad_phase) and find_contacts(world)):
            world = make_room(world)
        depths[frame] = _deepest(world)
    return depths


def _deepest(world: World) -> float:
    """Return the largest penetration in the contact table, m; 0 when it is empty."""
    in_use = range(world.state.contact_count)
    return max((world.contacts[k].penetration for k in in_use), default=0.0)

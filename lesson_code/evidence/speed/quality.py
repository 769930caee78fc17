"""How well a scene was simulated: overlaps and energy, measured alike on every engine's states."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import as_arrays, compiled_function, link
from lesson_code.engine.core.capacity import make_room
from lesson_code.engine.core.mixing import Combination
from lesson_code.engine.core.penetration import EVERY_OVERLAP, in_widths, measure_overlaps
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of

Floats = NDArray[np.float64]


class Reading(NamedTuple):
    """What a gauge reads in a state."""

    depth: float  # of the deepest overlap, as a share of the smaller body's width
    contacts: int  # points
    energy: float  # J, kinetic


class Gauge:
    """Measures overlaps and energy in the states of one scene.

    It is compiled and keeps its tables, since there may be 100,000 bodies.

    Parameters
    ----------
    scene : Scene
        The bodies, in any state.
    """

    def __init__(self, scene: Scene) -> None:
        self._masses, self._inertias = _weights(scene)
        broad_phase = BROAD_PHASES[broad_phase_for(scene)]
        source = link(
            measure_overlaps, broad_phase=broad_phase, effects=EVERY_OVERLAP, depth=in_widths
        )
        self._world: Any = as_arrays(world_of(scene, 1.0, 0, Combination()), source)
        self._measure = compiled_function(source, "measure_overlaps")

    def read(self, states: Floats) -> Reading:
        """Return what is measured in a state, shape (N, 6)."""
        bodies = self._world.bodies
        bodies["x"], bodies["y"], bodies["angle"] = states[:, 0], states[:, 1], states[:, 2]
        bodies["vx"] = bodies["vy"] = 0.0  # no margins are needed
        while (depth := float(self._measure(self._world))) < 0.0:
            self._world = make_room(self._world)
        contacts = int(self._world.state.contact_count)
        return Reading(depth, contacts, self.energy(states))

    def energy(self, states: Floats) -> float:
        """Return the kinetic energy of all bodies that can be pushed, J."""
        vx, vy, w = states[:, 3], states[:, 4], states[:, 5]
        return float((self._masses * (vx * vx + vy * vy) + self._inertias * w * w).sum() / 2)


def smallest_width(scene: Scene) -> float:
    """Return the smallest width of all bodies that can move, m."""
    return min(body.shape.extent for body in scene.bodies if not body.is_static)


def energy_to_lift(scene: Scene) -> float:
    """Return what it takes to lift all bodies by the smallest width, J; 0 without gravity."""
    mass = sum(body.mass or 0.0 for body in scene.bodies)
    return mass * float(np.hypot(*scene.gravity)) * smallest_width(scene)


def states_of(scene: Scene) -> Floats:
    """Return the state that a scene begins in, shape (N, 6)."""
    rows = [(*b.position, b.angle, *b.velocity, b.angular_velocity) for b in scene.bodies]
    return np.array(rows, dtype=float)


def _weights(scene: Scene) -> tuple[Floats, Floats]:
    """Return masses and moments of inertia, 0 for what is not pushed or not turned."""
    inertias = np.array([0.0 if body.inertia is None else body.inertia for body in scene.bodies])
    masses = np.array([body.mass or 0.0 for body in scene.bodies])
    return masses, np.where(np.isfinite(inertias), inertias, 0.0)
